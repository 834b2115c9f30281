//! Files that are no models and no spaces.

use std::path::PathBuf;
use std::process::Command;

use super::bounds::{fails, run_to};
use crate::helpers::model;

const SQUARE: &str = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

/// A folder in which files are made.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) -> String {
        std::fs::write(self.path(name), text).unwrap();
        self.name(name)
    }

    fn name(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }
}

#[test]
fn nesting_has_a_limit() {
    const DEEP: usize = 100_000;
    let folder = Folder::new();
    let (open, close) = ("[".repeat(DEEP), "]".repeat(DEEP));
    let saved = "{\"format\": \"contact-space\", \"version\": 1, ";
    for (name, text) in [
        ("a.json", open.clone()),
        ("b.json", format!("{{\"part\": {open}{close}}}")),
        ("c.json", "{\"a\":".repeat(DEEP)),
        ("d.json", format!("{saved}\"fixed\": {open}{close}}}")),
        (
            "e.json",
            format!("{saved}\"fixed\": {}", "{\"a\":[".repeat(DEEP)),
        ),
        ("f.json", format!("{{\"format\": {open}{close}}}")),
        ("g.json", format!("{saved}\"name\": {open}{close}}}")),
        ("a.toml", format!("a = {open}{close}")),
        ("b.toml", format!("a = {open}")),
        ("c.toml", format!("[{}a]\nb = 1", "a.".repeat(DEEP))),
        (
            "d.toml",
            format!("a = {}1{}", "{b = ".repeat(DEEP), "}".repeat(DEEP)),
        ),
        ("e.toml", format!("{}a = 1", "a.".repeat(DEEP))),
    ] {
        let file = folder.write(name, &text);
        fails(&["info", &file], 2, &[name, "error: "]);
        fails(&["compute", &file], 2, &[name, "  help: "]);
    }
}

#[test]
fn broken_text_is_located() {
    let folder = Folder::new();
    let good = std::fs::read_to_string(model("ratchet_mechanism")).unwrap();
    let cut: Vec<usize> = (1..40).map(|i| i * good.len() / 40).collect();
    for at in cut.into_iter().filter(|&at| good.is_char_boundary(at)) {
        let file = folder.write("cut.toml", &good[..at]);
        // Between two tables what is left may be a model.
        let output = run_to(std::process::Stdio::piped(), &["info", &file]);
        let said = String::from_utf8(output.stderr).unwrap();
        match output.status.code() {
            Some(0) => assert!(
                !said.contains("error: ") && !output.stdout.is_empty(),
                "{at}"
            ),
            code => {
                assert_eq!(code, Some(2), "{at}: {said}");
                assert!(
                    said.contains("cut.toml") && said.contains("  help: "),
                    "{said}"
                );
            }
        }
    }
    for (name, bytes) in [
        ("zero.toml", &[0; 1000][..]),
        ("zero.json", &[0; 1000]),
        ("latin.toml", b"name = \"R\xe4der\""),
        ("wide.json", b"\xff\xfe{\0}\0"),
        ("quote.toml", b"name = \"a"),
        ("quote.json", b"{\"name\": \"a"),
        ("comma.json", b"{\"part\": [,]}"),
        ("twice.json", b"{\"part\": [], \"part\": []}"),
        ("twice.toml", b"name = 1\nname = 2"),
        (
            "twice_saved.json",
            b"{\"format\": \"contact-space\", \"format\": 1}",
        ),
        ("tail.json", b"{} {}"),
        ("number.json", b"7"),
        ("null.json", b"null"),
        ("text.json", b"\"contact-space\""),
    ] {
        std::fs::write(folder.path(name), bytes).unwrap();
        fails(&["info", &folder.name(name)], 2, &[name, "error: "]);
    }
}

#[test]
fn numbers_have_limits() {
    let folder = Folder::new();
    for (i, (part, words)) in [
        ("loops = [[[0, 0], [1e400, 0], [0, 1]]]", "overflow"),
        ("loops = [[[0, 0], [1e308, 0], [0, 1]]]", "vertex 1"),
        ("loops = [[[-1e308, 0], [1e308, 0], [0, 1e308]]]", "loop 0"),
        ("loops = [[[0, 0], [nan, 0], [0, 1]]]", "vertex 1"),
        ("loops = [[[0, 0], [1, 0, 1e308], [0, 1]]]", "bulge"),
        ("loops = [[[0, 0], [1e-320, 0], [0, 1e-320]]]", "loop 0"),
        (
            "loops = [[[0, 0], [99999999999999999999999999999, 0], [0, 1]]]",
            "overflow",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let file = folder.write(
            &format!("{i}.toml"),
            &format!("[[part]]\nname = \"a\"\n{part}\n"),
        );
        let output = run_to(std::process::Stdio::piped(), &["info", &file]);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{part}: {said}");
        assert!(said.contains(&format!("{i}.toml:3:")), "{part}: {said}");
        assert!(
            said.contains(words) || said.contains("part 0"),
            "{part}: {said}"
        );
        assert!(said.len() < 400, "{said}");
    }
    let json = format!(r#"{{"part": [{{"name": "a", "loops": [{SQUARE}], "symmetry": 1e999}}]}}"#);
    fails(
        &["info", &folder.write("a.json", &json)],
        2,
        &["a.json:1:", "out of range"],
    );
    // What is shown of numbers that are accepted is short, too.
    let motion = "motion = { type = \"revolute\", center = [1e300, -1e308] }";
    let part = |name: &str| format!("[[part]]\nname = \"{name}\"\nloops = [{SQUARE}]\n{motion}\n");
    let file = folder.write("far.toml", &(part("a") + &part("b")));
    let output = run_to(std::process::Stdio::piped(), &["info", &file]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("revolute about (1e300, -1e308)"), "{text}");
    let words = [
        "far.toml: part \"a\" of the pair a,b",
        "the fixed part's centre is",
        "at most 32 times",
    ];
    fails(&["compute", &file], 2, &words);
    let said = run_to(std::process::Stdio::piped(), &["compute", &file]).stderr;
    assert!(!String::from_utf8(said).unwrap().contains("inf"));
    let (a, b) = (part("a").replace("[1e300, -1e308]", "[1, 1]"), part("b"));
    let b = b.replace("[1e300, -1e308]", "[40, 0.5]");
    let file = folder.write("b.toml", &(a + &b));
    fails(
        &["compute", &file],
        2,
        &["b.toml: part \"b\"", "the moving part's", "39.5 times"],
    );
}

/// Files about half as long as are read.
#[test]
#[ignore = "long: megabytes"]
fn long_lists_take_bounded_time_and_memory() {
    let folder = Folder::new();
    let many = |item: &str, bytes: usize| item.repeat(bytes / item.len() - 20);
    let (toml, json) = (8 << 20, 30 << 20);
    for (name, text, words) in [
        (
            "a.toml",
            format!(
                "[[part]]\nname = \"a\"\nloops = [[{}]]",
                many("[0, 0], ", toml)
            ),
            "vertices, more than",
        ),
        (
            "b.toml",
            format!("[[part]]\nname = \"a\"\nloops = [{}]", many("[],", toml)),
            "loop 0",
        ),
        (
            "c.toml",
            format!("[[part]]\nname = \"a\"\nloops = [[{}]]", many("0,", toml)),
            "vertex 0",
        ),
        ("d.toml", many("[[part]]\n", toml), "parts, more than"),
        (
            "e.toml",
            format!("name = \"{}\"", "a".repeat(toml)),
            "no parts",
        ),
        (
            "a.json",
            format!(
                "{{\"part\": [{{\"name\": \"a\", \"loops\": [[{}[0, 0]]]}}]}}",
                many("[0, 0], ", json)
            ),
            "vertices, more than",
        ),
        (
            "b.json",
            format!("{{\"part\": [{}0]}}", many("0,", json)),
            "parts, more than",
        ),
        (
            "c.json",
            format!(
                "{{\"format\": \"contact-space\", \"version\": 1, \"critical_orientations\": [{}0]}}",
                many("0,", json)
            ),
            "missing field",
        ),
        (
            "d.json",
            format!("{{\"format\": [{}0]}}", many("0,", json)),
            "the format is [0,0",
        ),
    ] {
        let file = folder.write(name, &text);
        drop(text);
        fails(&["info", &file, "--threads", "1"], 2, &[name, words]);
        std::fs::remove_file(file).unwrap();
    }
}

#[test]
fn only_regular_files_are_read() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    let link = |to: &str, name: &str| {
        symlink(to, folder.path(name)).unwrap();
        folder.name(name)
    };
    fails(
        &["info", &link("nowhere.toml", "dangling.toml")],
        2,
        &["dangling.toml", "No such file", "  help: "],
    );
    fails(
        &["info", &link("circle.toml", "circle.toml")],
        2,
        &["circle.toml", "  help: "],
    );
    std::fs::create_dir(folder.path("folder.toml")).unwrap();
    fails(
        &["info", &folder.name("folder.toml")],
        2,
        &["folder.toml", "folder", "give a file"],
    );
    fails(
        &["info", &link("folder.toml", "to_folder.toml")],
        2,
        &["to_folder.toml", "folder"],
    );
    for name in ["pipe.toml", "pipe.json"] {
        let made = Command::new("mkfifo")
            .arg(folder.path(name))
            .status()
            .unwrap();
        assert!(made.success());
        fails(
            &["info", &folder.name(name)],
            2,
            &[name, "no regular file", "  help: "],
        );
    }
    for (device, name) in [("/dev/zero", "zero.toml"), ("/dev/null", "null.json")] {
        fails(
            &["info", &link(device, name)],
            2,
            &[name, "no regular file"],
        );
    }
    fails(&["info", "/dev/zero"], 2, &["/dev/zero", "extension"]);
    fails(&["info", ""], 2, &["FILE"]);
    // A link to a model is a model.
    let good = link(&model("knee"), "knee.toml");
    assert!(
        run_to(std::process::Stdio::piped(), &["info", &good])
            .status
            .success()
    );
}

/// A loop of more vertices than a contact space has room for is refused, by its name and number.
#[test]
#[ignore = "long: megabytes"]
fn pairs_that_are_too_large_are_refused() {
    let folder = Folder::new();
    let outline: Vec<String> = (0..300_000)
        .map(|i| {
            let (sin, cos) = (core::f64::consts::TAU * f64::from(i) / 300_000.0).sin_cos();
            let r = 10.0 + f64::from(i * 7 % 13) * 1e-5;
            format!("[{:.9}, {:.9}]", r * cos, r * sin)
        })
        .collect();
    let text = format!(
        "{{\"part\": [{{\"name\": \"rim\", \"loops\": [[{}]]}}, \
         {{\"name\": \"wedge\", \"loops\": [[[0, 0], [1, 0], [0.3, 0.9]]]}}]}}",
        outline.join(", ")
    );
    let file = folder.write("rim.json", &text);
    let words = [
        "pair rim,wedge",
        "part rim has 300000 edges",
        "262144",
        "help: ",
    ];
    fails(&["compute", &file], 2, &words);
    fails(&["slice", &file, "--theta", "0.1"], 2, &words);
}
