//! Random options in random combinations: no panic, an exit code that is one of three and what is said with it, and no file that is
//! not what its name says.

use std::path::Path;

use cspace_oracle::effort;

use crate::helpers::{cspace, mechanism, model, printed};

/// Numbers that look random and are the same in every run (Knuth's linear congruential generator).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = (self.0.wrapping_mul(6_364_136_223_846_793_005))
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n as u64) as usize
    }

    fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.below(of.len())]
    }

    /// A place to write to, mostly one for a picture.
    fn place(&mut self) -> &'static str {
        match self.below(3) {
            0 => self.one(OUT),
            k => OUT[k - 1],
        }
    }
}

/// All options of the commands that take a model, with values that are right, wrong or strange.
const OPTIONS: [(&str, &[&str]); 34] = [
    (
        "--pair",
        &["ratchet,pawl", "driver,link", "gear,pinion", "pawl", ""],
    ),
    ("--general", &[]),
    ("--json", &[]),
    ("--format", &["text", "json", "xml"]),
    ("--threads", &["1", "2", "0", "-1"]),
    (
        "--window",
        &["-0.1,0.1", "0.3", "10deg", "1,0", "nan", "0,20"],
    ),
    ("--theta", &["0.3", "10deg", "-0.1,0.1", "nan", "1e9"]),
    ("--tolerance", &["0.05", "0.1", "0", "2"]),
    ("--theta-scale", &["10", "1", "-1"]),
    ("--ascii", &[]),
    ("--slices", &["1", "3", "0", "999"]),
    ("--size", &["300x200", "100x100", "5x5", "x"]),
    ("--title", &["a & b", "", "\u{7f}"]),
    ("--labels", &["none", "auto", "all", "some"]),
    ("--x", &["-10,10", "3,2", "1"]),
    ("--y", &["-1e300,1e300", "0,1"]),
    ("--u", &["0,10deg", "1,1"]),
    ("--v", &["-1,1", "a,b"]),
    (
        "--at",
        &["0,0,0", "1,2", "60,0,0.1", "0,0", "1e300,0,0", "x"],
    ),
    ("--from", &["0,0,0", "100,0,0", "0,0"]),
    ("--to", &["100,0,0", "0,0,0", "0,0", "out", "x"]),
    ("--energy", &[]),
    ("--gravity", &["0,-1", "0,0", "1"]),
    ("--accuracy", &["1", "0", "x"]),
    ("--proof", &["proof.json", "no/proof.json"]),
    ("--by", &["10,0,0", "0,1", "0,0,7", "1e9,0,0"]),
    ("--within", &["5", "0", "-1"]),
    (
        "--columns",
        &[
            "class",
            "region,distance",
            "touching",
            "class,class",
            "mass",
        ],
    ),
    ("--touch", &["0.1", "-1"]),
    ("--verbose", &[]),
    ("--snap", &[]),
    ("--quiet", &[]),
    ("--color", &["always", "never", "red"]),
    ("-o", OUT),
];

/// Places for what is written.
const OUT: &[&str] = &[
    "a.svg", "a.png", "a.pdf", "a.json", "a.ply", "a.obj", "a.stl", "a.glb", "a.html", "a.csv",
    "a.dxf", "a.txt", "a.toml", "-", "no/a.svg",
];

/// Whether a file is what its name says.
fn is_true(path: &Path) -> bool {
    let bytes = std::fs::read(path).unwrap();
    let text = || String::from_utf8(bytes.clone()).unwrap();
    match path.extension().and_then(|e| e.to_str()) {
        Some("svg") => bytes.starts_with(b"<svg") && bytes.ends_with(b"</svg>\n"),
        Some("png") => bytes.starts_with(b"\x89PNG\r\n"),
        Some("pdf") => bytes.starts_with(b"%PDF"),
        Some("json") => serde_json::from_str::<serde_json::Value>(&text()).is_ok(),
        Some("ply") => bytes.starts_with(b"ply\n"),
        Some("obj") => text().lines().any(|l| l.starts_with("f ")),
        Some("stl") => bytes.starts_with(b"solid") || (bytes.len() - 84).is_multiple_of(50),
        Some("html") => text().ends_with("</html>\n"),
        Some("glb") => bytes.starts_with(b"glTF"),
        Some("csv") => text().starts_with("x,y,theta") || text().starts_with("u,v"),
        Some("dxf") => text().ends_with("EOF\n"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn no_options_make_it_panic_or_lie() {
    // Enough that some of them succeed.
    let runs = effort(100, 400);
    const COMMANDS: [&str; 9] = [
        "info",
        "compute",
        "slice",
        "classify",
        "plan",
        "clearance",
        "play",
        "draw",
        "export",
    ];
    let files = ["ratchet_pawl", "gears_on_shafts", "peg_hole", "cam_tappet"].map(model);
    let mechanism = mechanism();
    let helps = COMMANDS.map(|c| printed(&[c, "--help"]).replace('\n', " "));
    let mut dice = Dice(22);
    let (mut done, mut denied, mut written) = (0, 0, 0);
    for run in 0..runs {
        let folder = tempfile::tempdir().unwrap();
        let command = COMMANDS[dice.below(COMMANDS.len())];
        let file = match dice.below(5) {
            0 => &mechanism,
            k => &files[k - 1],
        };
        let mut args = vec![command, file.as_str()];
        // What a command needs is mostly given.
        if dice.below(4) > 0 {
            match command {
                "play" => args.extend([
                    "--at",
                    dice.one(&["0,0,0", "0,0", "70,0,1", "99,0,1"]),
                    "--by=1,0,0",
                ]),
                "plan" => args.extend(["--from", dice.one(&["0,0,0", "0,0", "70,0,1"])]),
                "slice" => args.extend(["--theta", "0.2", "-o", dice.place()]),
                "draw" => args.extend(["-o", dice.place()]),
                "export" => args.extend(["-o", dice.place()]),
                _ => {}
            }
        }
        for (option, values) in OPTIONS {
            // The other name of --json is in no help.
            let shown = if option == "--format" {
                "--json"
            } else {
                option
            };
            let is_written = !["info", "compute", "play", "clearance"].contains(&command);
            let is_known = (option != "-o" || is_written)
                && helps[COMMANDS.iter().position(|c| *c == command).unwrap()]
                    .contains(&format!("{shown} "));
            // A fifth of those that it has, few that it has not.
            let often = if is_known { 5 } else { 100 };
            if dice.below(often) == 0 && !args.contains(&option) {
                args.push(option);
                // The first value is mostly right.
                match (values, dice.below(2)) {
                    ([], _) => {}
                    (_, 0) => args.push(values[0]),
                    _ => args.push(dice.one(values)),
                }
            }
        }
        let mut program = cspace(&args);
        let rows = dice.one(&["x,y,theta\n0,0,0\n90,0,1\n", "u,v\n0,0\n", "", "a\n1\n"]);
        let output = program
            .current_dir(folder.path())
            .write_stdin(rows)
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        let code = output.status.code();
        assert!(
            matches!(code, Some(0..=2)) && !said.contains("panicked"),
            "{run} {args:?}: {said}"
        );
        // A no is an answer, and what is not answered has a reason: an error, or an answer that leaves it open.
        let told = String::from_utf8_lossy(&output.stdout);
        if code != Some(2) {
            assert!(!said.contains("error:"), "{run} {args:?}: {said}");
        } else {
            assert!(
                said.contains("error:") || !told.is_empty(),
                "{run} {args:?}"
            );
        }
        let is_json =
            args.contains(&"--json") || args.windows(2).any(|w| w == ["--format", "json"]);
        if is_json && command != "draw" && command != "export" {
            let value: serde_json::Value = serde_json::from_str(&told)
                .unwrap_or_else(|e| panic!("{run} {args:?}: {e}: {told}"));
            assert!(
                value["outcome"].is_string() || code == Some(2) && value["error"].is_object(),
                "{run} {args:?}: {told}"
            );
        }
        done += usize::from(code == Some(0));
        denied += usize::from(code == Some(1));
        for entry in std::fs::read_dir(folder.path()).unwrap() {
            let path = entry.unwrap().path();
            assert!(
                code != Some(2) && is_true(&path),
                "{run} {args:?}: {}",
                path.display()
            );
            written += 1;
        }
    }
    assert!(
        done > runs / 12 && denied > 0 && written > runs / 60,
        "{done} done, {denied} denied, {written} written"
    );
}
