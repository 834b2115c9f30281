//! Messages for bad model files; good ones are read.

mod limits;

use cspace::PairClass;
use cspace_model::{ModelError, model};

const SQUARE: &str = "[[0, 0], [1, 0], [1, 1], [0, 1]]";

pub(super) fn error(toml: &str) -> ModelError {
    model::from_toml(toml, "m.toml").unwrap_err()
}

/// Asserts that an error, with its help, has all the words.
pub(super) fn says(error: &ModelError, words: &[&str]) {
    let all = format!("{error} | {}", error.help().unwrap_or_default());
    for w in words {
        assert!(all.contains(w), "{w:?} is not in: {all}");
    }
}

fn part(name: &str, rest: &str) -> String {
    format!("[[part]]\nname = \"{name}\"\n{rest}\n")
}

#[test]
fn the_shipped_models_are_read() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    let mut read = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "toml") {
            let model = model::read(&path).unwrap();
            assert!(!model.pairs.is_empty(), "{path:?}");
            read += 1;
        }
    }
    assert!(read >= 6);
}

#[test]
fn toml_and_json_are_the_same() {
    let toml = format!(
        "name = \"n\"\nunit = \"mm\"\n{}{}[[pair]]\nfixed = \"b\"\nmoving = \"a\"\ntheta = [\"-10deg\", 0.5]\n",
        part(
            "a",
            &format!("loops = [{SQUARE}]\nmotion = {{ type = \"revolute\", center = [0, 0] }}")
        ),
        part("b", &format!("loops = [{SQUARE}]")),
    );
    let json = format!(
        r#"{{"name": "n", "unit": "mm", "part": [
            {{"name": "a", "loops": [{SQUARE}], "motion": {{"type": "revolute", "center": [0, 0]}}}},
            {{"name": "b", "loops": [{SQUARE}]}}],
            "pair": [{{"fixed": "b", "moving": "a", "theta": ["-10deg", 0.5]}}]}}"#
    );
    let a = model::from_toml(&toml, "m.toml").unwrap();
    assert_eq!(a, model::from_json(&json, "m.json").unwrap());
    assert_eq!(a.pair_class(&a.pairs[0]), PairClass::General);
    assert!((a.pairs[0].window.unwrap().0 + 10f64.to_radians()).abs() < 1e-15);
}

#[test]
fn errors_name_the_place_and_say_what_to_do() {
    for empty in ["", " \n\n", "\u{feff}"] {
        says(
            &error(empty),
            &["m.toml: the file is empty", "[[part]]", "loops"],
        );
        let json = model::from_json(empty, "m.json").unwrap_err();
        says(&json, &["m.json: the file is empty"]);
    }
    says(&error("# a comment\n"), &["m.toml", "no parts", "[[part]]"]);
    says(&error("[[part]\n"), &["m.toml:1:", "no TOML"]);
    says(&error("x = = 2"), &["m.toml:1:5: "]);
    says(
        &error(&part("a", &format!("loop = [{SQUARE}]"))),
        &["part 0 \"a\"", "unknown key \"loop\"", "`loops`"],
    );
    says(
        &error(&part("a", "")),
        &["part 0 \"a\"", "`loops` is missing"],
    );
    says(
        &error(&part("a", "loops = 3")),
        &["`loops` is the number 3", "a list"],
    );
    says(
        &error(&part("a", "dxf = \"a.dxf\"")),
        &["m.toml:3:7", "a.dxf: it cannot be read", "check the path"],
    );
    says(&error(&part("a", "loops = []")), &["part 0 \"a\""]);
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1]]]")),
        &["loop 0, vertex 2", "[x, y, bulge]"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1, 1, 0, 0]]]")),
        &["loop 0, vertex 2"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, \"0deg\"], [1, 1]]]")),
        &["loop 0, vertex 1", "\"0deg\""],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, nan], [1, 1]]]")),
        &["loop 0, vertex 1", "finite"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0]]]")),
        &["part 0 \"a\"", "loop 0"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 0], [1, 0], [0, 1]]]")),
        &["loop 0", "vert"],
    );
    says(
        &error(&part("a", "loops = [[[0, 0], [1, 1], [1, 0], [0, 1]]]")),
        &["loop 0"],
    );
    let two = format!(
        "{}{}",
        part("a", &format!("loops = [{SQUARE}]")),
        part("a", &format!("loops = [{SQUARE}]"))
    );
    says(&error(&two), &["part 1 \"a\"", "part 0"]);
    says(
        &error(&part(" ", &format!("loops = [{SQUARE}]"))),
        &["part 0", "empty"],
    );
    let motion = |m: &str| part("a", &format!("loops = [{SQUARE}]\nmotion = {m}"));
    says(
        &error(&motion("{ type = \"revolut\", center = [0, 0] }")),
        &["motion", "`revolute`"],
    );
    says(
        &error(&motion("{ type = \"revolute\" }")),
        &["`center` is missing"],
    );
    says(
        &error(&motion("{ type = \"prismatic\", direction = [0, 0] }")),
        &["direction is zero"],
    );
    says(
        &error(&motion(
            "{ type = \"revolute\", center = [0, 0], range = [1, -1] }",
        )),
        &["reversed"],
    );
    says(
        &error(&part("a", &format!("loops = [{SQUARE}]\nsymmetry = 0"))),
        &["`symmetry`"],
    );
}

#[test]
fn declared_symmetry_must_be_true() {
    let declared =
        |loops: &str, fold: u32| part("a", &format!("loops = {loops}\nsymmetry = {fold}"));
    let square = format!("[{SQUARE}]");
    for fold in [1, 2, 4] {
        model::from_toml(&declared(&square, fold), "m.toml").unwrap();
    }
    says(
        &error(&declared(&square, 3)),
        &["symmetry", "\"a\"", "3-fold", "the largest is 4-fold"],
    );
    // A disc may claim anything, and a corner that is none changes nothing.
    model::from_toml(&declared("[[[0, 0, 1], [1, 0, 1]]]", 17), "m.toml").unwrap();
    let seamed = "[[[0, 0], [0.5, 0], [1, 0], [1, 1], [0, 1]]]";
    model::from_toml(&declared(seamed, 4), "m.toml").unwrap();
    says(
        &error(&declared("[[[0, 0], [3, 0], [1, 1]]]", 2)),
        &["2-fold", "no rotational symmetry", "remove"],
    );
}

#[test]
fn joints_must_agree_with_motions() {
    let model = |motion: &str, joints: &str| {
        let wheel = format!("loops = [{SQUARE}]\nmotion = {motion}");
        let frame = format!("loops = [{SQUARE}]\nmotion = {{ type = \"fixed\" }}");
        format!("{}{}{joints}", part("wheel", &wheel), part("frame", &frame))
    };
    let hinge = |at: &str| {
        format!("[[joint]]\ntype = \"revolute\"\nparts = [\"frame\", \"wheel\"]\nat = {at}\n")
    };
    let turning = "{ type = \"revolute\", center = [1, 2] }";
    assert!(model::from_toml(&model(turning, &hinge("[1, 2]")), "m.toml").is_ok());
    says(
        &error(&model(turning, &hinge("[1, 2.1]"))),
        &["joint 0", "\"wheel\"", "motion"],
    );
    let sliding = "{ type = \"prismatic\", direction = [0, 1] }";
    says(
        &error(&model(sliding, &hinge("[1, 2]"))),
        &["joint 0", "motion"],
    );
    let twice = format!("{}{}", hinge("[1, 2]"), hinge("[1, 2]"));
    says(&error(&model(turning, &twice)), &["joint 1", "joint 0"]);
    let tiny = "{ type = \"prismatic\", direction = [1e-320, 0] }";
    says(&error(&model(tiny, "")), &["direction", "length"]);
}

#[test]
fn errors_in_pairs_and_joints() {
    let parts = format!(
        "{}{}",
        part("wheel", &format!("loops = [{SQUARE}]")),
        part("pawl", &format!("loops = [{SQUARE}]"))
    );
    let pair = |p: &str| error(&format!("{parts}[[pair]]\n{p}\n"));
    says(
        &pair("fixed = \"wheal\"\nmoving = \"pawl\""),
        &["pair 0", "\"wheal\"", "`wheel`"],
    );
    says(
        &pair("fixed = \"pawl\"\nmoving = \"pawl\""),
        &["pair 0", "itself"],
    );
    says(&pair("fixed = \"wheel\""), &["`moving` is missing"]);
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [1, 0]"),
        &["pair 0", "reversed"],
    );
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [0, 7]"),
        &["more than a turn"],
    );
    says(
        &pair("fixed = \"wheel\"\nmoving = \"pawl\"\ntheta = [0, inf]"),
        &["theta"],
    );
    says(
        &pair(
            "fixed = \"wheel\"\nmoving = \"pawl\"\n[[pair]]\nfixed = \"pawl\"\nmoving = \"wheel\"",
        ),
        &["pair 1", "pair 0"],
    );
    let joint = |j: &str| error(&format!("{parts}[[joint]]\n{j}\n"));
    says(
        &joint("type = \"rigid\"\nparts = [\"wheel\"]"),
        &["joint 0", "two"],
    );
    says(
        &joint("type = \"rigit\"\nparts = [\"wheel\", \"pawl\"]"),
        &["joint 0", "`rigid`"],
    );
    says(
        &joint("type = \"revolute\"\nparts = [\"wheel\", \"pawl\"]"),
        &["`at` is missing"],
    );
}

#[test]
fn errors_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    let read = |p: &std::path::Path| model::read(p).unwrap_err();
    says(
        &read(&folder.path().join("none.toml")),
        &["none.toml", "cannot be read"],
    );
    says(&read(&path("a.txt", b"")), &["a.txt", ".toml"]);
    says(
        &read(&path("b.toml", &[0x66, 0xff, 0x00])),
        &["b.toml", "not text"],
    );
    says(&read(&path("c.json", b"{\"part\": [}")), &["c.json:1:"]);
    std::fs::create_dir(folder.path().join("d.toml")).unwrap();
    says(&read(&folder.path().join("d.toml")), &["folder"]);
}

/// Positions are those of the wrong value, or of the key that should not be there.
#[test]
fn errors_name_line_and_column() {
    let toml = |part: &str| {
        let text = format!("name = \"m\"\n\n[[part]]\nname = \"a\"\n{part}\n");
        let e = error(&text);
        (e.line(), e.column(), e)
    };
    for (part, line, column) in [
        ("loop = []", 5, 1),
        ("loops = 3", 5, 9),
        ("loops = [\n  [[0, 0], [1, 0],\n   [1]]]", 7, 4),
        ("loops = [\n  [[0, 0], [1, 0], [1, \"0deg\"]]]", 6, 20),
        ("loops = [\n  [[0, 0], [1, 0], [1, \"0*x\"]]]", 6, 27),
        // A part that makes no outline: crossing, spike, coincident vertices, a bad bulge, a loop twice.
        (
            "loops = [\n [[0, 0],\n  [1, 1],\n  [1, 0],\n  [0, 1]]]",
            6,
            3,
        ),
        (
            "loops = [\n [[0, 0],\n  [2, 0],\n  [1, 0],\n  [0, 1]]]",
            7,
            3,
        ),
        (
            "loops = [\n [[0, 0],\n  [1, 0],\n  [1, 0],\n  [0, 1]]]",
            7,
            3,
        ),
        ("loops = [\n [[0, 0],\n  [1, 0, 1e300],\n  [0, 1]]]", 7, 3),
        (
            "loops = [\n [[0, 0], [1, 0], [0, 1]],\n [[0, 0], [1, 0], [0, 1]]]",
            7,
            2,
        ),
        ("loops = [\n [[0, 0], [1, 0]]]", 6, 2),
        (
            "loops = [[[0, 0], [1, 0], [0, 1]]]\nmotion = { type = \"planar\",\n  range = [0, 1] }",
            7,
            3,
        ),
        ("loops = [[[0, 0], [1, 0], [0, 1]]]\nmotion.type = 1", 6, 15),
        (
            "loops = [[[0, 0], [1, 0], [0, 1]]]\n[part.motion]\ntype = \"revolute\"\ncenter = [0]",
            8,
            10,
        ),
        ("loops = [[[0, 0], [1, 0], [0, 1]]]\nsymmetry = 1.5", 6, 12),
        (
            "loops = [[[0, 0], [1, 0], [0, 1]]]\n[[pair]]\nfixed = \"a\"\nmoving = \"b\"",
            8,
            10,
        ),
        ("motion = { type = \"fixed\" }", 3, 1),
    ] {
        let (l, c, e) = toml(part);
        assert_eq!((l, c), (Some(line), Some(column)), "{part}: {e}");
        assert!(
            e.to_string()
                .starts_with(&format!("m.toml:{line}:{column}: ")),
            "{e}"
        );
        assert!(e.help().is_some_and(|h| !h.is_empty()), "{e}");
    }
}

#[test]
fn errors_in_json_name_line_and_column_once() {
    let error = |text: &str| model::from_json(text, "m.json").unwrap_err();
    let e =
        error("{\"part\": [\n  {\"name\": \"a\",\n   \"loops\": [[[0, 0],\n     [1, null]]]}]}");
    says(
        &e,
        &["m.json:4:6: part 0 \"a\", loop 0, vertex 1: null where"],
    );
    let e = error("{\"part\": [\n  {\"nmae\": \"a\"}]}");
    says(&e, &["m.json:2:4: part 0: unknown key", "`name`"]);
    let e = error("{\"part\": [}");
    assert_eq!((e.line(), e.column()), (Some(1), Some(11)));
    assert_eq!(e.to_string().matches("11").count(), 1, "{e}");
    assert!(!e.to_string().contains("column"), "{e}");
    let e = error("{\"part\": [\n");
    says(&e, &["m.json:2:", "no JSON", "whole"]);
    let e = error("{\"name\": \"a\", \"name\": \"b\"}");
    says(&e, &["given twice"]);
    let e = error("[]");
    says(&e, &["m.json:1:1", "an empty list where a table"]);
}

#[test]
fn one_outline_for_each_part() {
    let with = |keys: &str| error(&part("a", keys));
    let loops = format!("loops = [{SQUARE}]");
    for drawing in ["dxf", "svg"] {
        says(
            &with(&format!("{loops}\n{drawing} = \"a.{drawing}\"")),
            &[
                "m.toml:4:1",
                &format!("both `loops` and `{drawing}`"),
                "remove",
            ],
        );
        says(
            &with(&format!("{drawing} = \"a.txt\"")),
            &["m.toml:3:7", "a.txt", &format!(".{drawing}")],
        );
    }
    says(
        &with("svg = \"a.svg\"\ndxf = \"a.dxf\""),
        &["both `dxf` and `svg`"],
    );
    says(&with(&format!("{loops}\nlayer = \"0\"")), &["`layer`"]);
    says(
        &error(&format!("[part]\nname = \"a\"\n{loops}\n")),
        &["`part` is a table", "[[part]]"],
    );
    says(
        &with("loops = [[0, 0], [1, 0], [0, 1]]"),
        &["vertex 0", "a pair of brackets missing"],
    );
}

#[test]
fn many_parts_are_refused_before_their_pairs_are_made() {
    let text: String = (0..1001)
        .map(|i| part(&format!("p{i}"), &format!("loops = [{SQUARE}]")))
        .collect();
    says(&error(&text), &["1001 parts", "split"]);
}

#[test]
fn a_byte_order_mark_is_no_part_of_the_text() {
    let text = format!("\u{feff}{}", part("a", &format!("loops = [{SQUARE}]")));
    assert_eq!(model::from_toml(&text, "m.toml").unwrap().parts.len(), 1);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("marked.toml");
    std::fs::write(&path, &text).unwrap();
    assert_eq!(model::read(&path).unwrap().name, "marked");
    let path = folder.path().join("marked.json");
    let json = format!("\u{feff}{{\"part\": [{{\"name\": \"a\", \"loops\": [{SQUARE}]}}]}}");
    std::fs::write(&path, json).unwrap();
    assert_eq!(model::read(&path).unwrap().parts.len(), 1);
    // The mark takes no column.
    says(
        &model::from_toml("\u{feff}x = = 2", "m.toml").unwrap_err(),
        &["m.toml:1:5"],
    );
}

/// A device may never end, a pipe may never begin.
#[cfg(unix)]
#[test]
fn only_regular_files_are_opened() {
    let folder = tempfile::tempdir().unwrap();
    let zero = folder.path().join("zero.toml");
    std::os::unix::fs::symlink("/dev/zero", &zero).unwrap();
    says(
        &model::read(&zero).unwrap_err(),
        &["zero.toml", "no regular file", "write the text to a file"],
    );
    let pipe = folder.path().join("pipe.json");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    if made.is_ok_and(|s| s.success()) {
        says(
            &cspace_model::read(&pipe).unwrap_err(),
            &["no regular file"],
        );
    }
    // Larger than what is read, though it takes no room on the disk.
    let large = folder.path().join("large.toml");
    let file = std::fs::File::create(&large).unwrap();
    file.set_len((16 << 20) + 1).unwrap();
    says(
        &model::read(&large).unwrap_err(),
        &["large.toml", "at most 16777216 bytes", "write it as .json"],
    );
    let large = folder.path().join("large.json");
    let file = std::fs::File::create(&large).unwrap();
    file.set_len((64 << 20) + 1).unwrap();
    // Read as a model, and by whichever it might be.
    let words = ["large.json", "at most 67108864 bytes", "several files"];
    says(&model::read(&large).unwrap_err(), &words);
    says(&cspace_model::read(&large).unwrap_err(), &words);
}

/// Whatever is done to a model's text: a model or an error with a place, and no panic.
#[test]
fn damaged_models_are_refused_or_read() {
    use rand::{Rng, SeedableRng, seq::IndexedRandom};
    const PIECES: [&str; 18] = [
        "[", "]", "{", "}", "\"", ",", "=", ":", "\n", "-", "nan", "1e308", "-0.0", "[[part]]",
        "é", "null", "1e-320", "\\",
    ];
    let toml = format!(
        "name = \"räder\"\n{}motion = {{ type = \"revolute\", center = [0, 0], range = [\"-10deg\", 1] }}\n{}{}",
        part("a", &format!("loops = [{SQUARE}]\nsymmetry = 4")),
        part("b", "loops = [[[2, 0, 1], [3, 0, 1]]]"),
        "[[joint]]\ntype = \"revolute\"\nparts = [\"a\", \"b\"]\nat = [0, 1]\n[[pair]]\nfixed = \"a\"\nmoving = \"b\"\ntheta = [-1, 1]\n"
    );
    let json = format!(
        r#"{{"name": "räder", "part": [
            {{"name": "a", "loops": [{SQUARE}], "motion": {{"type": "prismatic", "direction": [1, 0], "range": [0, 1]}}}},
            {{"name": "b", "loops": [[[2, 0, 1], [3, 0, 1]]]}}],
            "joint": [{{"type": "prismatic", "direction": [1, 0], "parts": ["a", "b"]}}], "pair": [{{"fixed": "b", "moving": "a"}}]}}"#
    );
    model::from_toml(&toml, "m.toml").unwrap();
    model::from_json(&json, "m.json").unwrap();
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(4);
    for i in 0..20_000 {
        let is_toml = i % 2 == 0;
        let mut text: Vec<char> = if is_toml { &toml } else { &json }.chars().collect();
        for _ in 0..rng.random_range(1..4) {
            let at = rng.random_range(0..text.len());
            let end = (at + rng.random_range(0..6)).min(text.len());
            let piece = PIECES.choose(&mut rng).unwrap();
            text.splice(at..end, piece.chars());
        }
        if rng.random_bool(0.1) {
            text.truncate(rng.random_range(0..text.len()));
        }
        let text: String = text.into_iter().collect();
        let read = if is_toml {
            model::from_toml(&text, "m")
        } else {
            model::from_json(&text, "m")
        };
        if let Err(e) = read {
            assert!(!e.message().is_empty() && e.help().is_some(), "{e}: {text}");
            let lines = text.split('\n').count();
            assert!(e.line().is_none_or(|l| (1..=lines).contains(&l)), "{e}");
            // Only what the file as a whole lacks has no line.
            let is_whole = ["no parts", "is empty"]
                .iter()
                .any(|w| e.message().contains(w));
            assert!(e.line().is_some() || is_whole, "{e}: {text}");
        }
    }
}

/// Suggested keys are accepted in the place for which they are suggested.
#[test]
fn suggestions_are_keys_that_are_taken() {
    let part = |keys: &str| {
        format!("[[part]]\nname = \"a\"\nloops = [[[0, 0], [1, 0], [0, 1]]]\n{keys}\n")
    };
    let two = format!("{}{}", part(""), part("").replace("\"a\"", "\"b\""));
    for (text, suggests) in [
        (part("dfx = \"a.dxf\""), Some("dxf")),
        (part("laier = \"0\""), Some("layer")),
        (part("moton = { type = \"fixed\" }"), Some("motion")),
        (part("motion = { type = \"fixed\", centre = [0, 0] }"), None),
        (
            part("motion = { type = \"revolute\", centre = [0, 0] }"),
            Some("center"),
        ),
        (
            part("motion = { type = \"prismatic\", centre = [0, 0] }"),
            None,
        ),
        (
            part("motion = { type = \"prismatic\", directoin = [1, 0] }"),
            Some("direction"),
        ),
        (
            format!(
                "{two}[[joint]]\ntype = \"rigid\"\nparts = [\"a\", \"b\"]\ndirectoin = [1, 0]\n"
            ),
            None,
        ),
    ] {
        let error = model::from_toml(&text, "m.toml").unwrap_err();
        let meant = error.help().unwrap().strip_prefix("did you mean `");
        assert_eq!(
            meant.map(|m| m.trim_end_matches("`?")),
            suggests,
            "{text}: {error}"
        );
    }
}
