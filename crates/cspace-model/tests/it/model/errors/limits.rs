//! Models that are refused: keys of another type of joint, control characters, angles and numbers beyond all use.

use cspace_model::{ModelError, model};

use super::{SQUARE, error, part, says};

/// Two squares, in a model with something more.
fn with_more(more: &str) -> ModelError {
    let square = |name: &str| part(name, &format!("loops = [{SQUARE}]"));
    error(&format!("{}{}{more}\n", square("a"), square("b")))
}

#[test]
fn joints_have_the_keys_of_their_type() {
    let joint = |keys: &str| with_more(&format!("[[joint]]\nparts = [\"a\", \"b\"]\n{keys}"));
    for (keys, words) in [
        (
            "type = \"rigid\"\nat = [0, 0]",
            [
                "m.toml:10:1: joint 0: unknown key \"at\"",
                "a rigid joint has the keys type, parts",
            ],
        ),
        (
            "type = \"rigid\"\ndirection = [1, 0]",
            [
                "unknown key \"direction\"",
                "a rigid joint has the keys type, parts",
            ],
        ),
        (
            "type = \"revolute\"\nat = [0, 0]\ndirection = [1, 0]",
            [
                "unknown key \"direction\"",
                "a revolute joint has the keys type, parts, at",
            ],
        ),
        (
            "type = \"prismatic\"\ndirection = [1, 0]\nangle = 1",
            ["unknown key \"angle\"", "type, parts, at, direction"],
        ),
    ] {
        says(&joint(keys), &words);
    }
    // A point of the line may be given.
    let square = |name: &str| part(name, &format!("loops = [{SQUARE}]"));
    let slide = "[[joint]]\nparts = [\"a\", \"b\"]\ntype = \"prismatic\"\ndirection = [1, 0]\nat = [0, 2]\n";
    let text = format!("{}{}{slide}", square("a"), square("b"));
    assert_eq!(model::from_toml(&text, "m.toml").unwrap().joints.len(), 1);
}

#[test]
fn text_has_no_control_characters() {
    let square = format!("loops = [{SQUARE}]");
    for (escape, shown) in [
        ("\\u0000", r"\0"),
        ("\\u001B[31m", r"\u{1b}"),
        ("\\n", r"\n"),
        ("\\t", r"\t"),
        ("\\u007F", r"\u{7f}"),
        ("\\u009B", r"\u{9b}"),
    ] {
        let name = format!("p{escape}q");
        let joint = format!("[[joint]]\ntype = \"{name}\"\nparts = [\"a\", \"b\"]");
        for (place, error) in [
            (
                "`name`",
                error(&format!("name = \"{name}\"\n{}", part("a", &square))),
            ),
            (
                "`unit`",
                error(&format!("unit = \"{name}\"\n{}", part("a", &square))),
            ),
            ("part 0", error(&part(&name, &square))),
            (
                "motion",
                error(&part(
                    "a",
                    &format!("{square}\nmotion = {{ type = \"{name}\" }}"),
                )),
            ),
            ("joint 0", with_more(&joint)),
            (
                "pair 0",
                with_more(&format!("[[pair]]\nfixed = \"{name}\"\nmoving = \"b\"")),
            ),
            (
                "pair 0",
                with_more(&format!(
                    "[[pair]]\nfixed = \"a\"\nmoving = \"b\"\ntheta = [\"{name}\", 1]"
                )),
            ),
            (
                "joint 0",
                with_more(&format!(
                    "[[joint]]\ntype = \"rigid\"\nparts = [\"{name}\", \"b\"]"
                )),
            ),
        ] {
            says(&error, &[place, shown]);
            let all = format!("{error}{}", error.help().unwrap_or_default());
            assert!(!all.contains(char::is_control), "{all:?}");
        }
        // Keys, and what is only refused.
        for error in [
            error(&format!("\"{name}\" = 1\n{}", part("a", &square))),
            error(&part("a", &format!("dxf = \"{name}\"\nlayer = \"{name}\""))),
        ] {
            let all = format!("{error}{}", error.help().unwrap_or_default());
            assert!(!all.contains(char::is_control), "{all:?}");
        }
    }
    // The same in JSON, and in the name of the file itself.
    let json = format!(r#"{{"part": [{{"name": "p\u001b[2Jq", "loops": [{SQUARE}]}}]}}"#);
    let error = model::from_json(&json, "m\u{1b}[2J\n.json").unwrap_err();
    says(
        &error,
        &[r"m\u{1b}[2J\n.json:1:", "control character", r"p\u{1b}[2Jq"],
    );
    assert!(!error.to_string().contains(char::is_control));
}

#[test]
fn orientations_far_from_0_are_refused() {
    let pair = |theta: &str| {
        with_more(&format!(
            "[[pair]]\nfixed = \"a\"\nmoving = \"b\"\ntheta = {theta}"
        ))
    };
    says(
        &pair("[1e12, 1e12]"),
        &[
            "pair 0",
            "`theta`",
            "1000000000000 rad",
            "1e6 rad",
            "whole turns",
        ],
    );
    says(&pair("[-1000001, -1000000]"), &["-1000001 rad"]);
    says(&pair("[0, \"1e300turn\"]"), &["`theta`", "e300 rad"]);
    let range = "motion = { type = \"revolute\", center = [0, 0], range = [0, 1e7] }";
    let turning = error(&part("a", &format!("loops = [{SQUARE}]\n{range}")));
    says(
        &turning,
        &["part 0 \"a\", motion", "`range`", "10000000 rad"],
    );
    // Lengths may be long.
    let sliding = range
        .replace("revolute", "prismatic")
        .replace("center = [0, 0]", "direction = [1, 0]");
    let text = part("a", &format!("loops = [{SQUARE}]\n{sliding}"));
    assert!(model::from_toml(&text, "m.toml").is_ok());
}

#[test]
fn long_numbers_are_told_in_short() {
    let square = format!("loops = [{SQUARE}]");
    let sliding = "motion = { type = \"prismatic\", direction = [1, 0], range = [1e308, -1e308] }";
    let bow = "loops = [[[0, 0], [1e149, 1e149], [1e149, 0], [0, 1e149]]]";
    for (error, words) in [
        (
            error(&part("a", &format!("{square}\n{sliding}"))),
            "goes from 1e308 to -1e308",
        ),
        (
            error(&part("a", &square.replace("[1, 1]", "[1, 1, 1e308]"))),
            "the bulge 1e308",
        ),
        (error(&part("a", bow)), "e148, "),
        (error(&part("a", "loops = 1e301")), "the number 1e301"),
        (
            error(&part("a", &format!("{square}\nsymmetry = 1e305"))),
            "the number 1e305",
        ),
        (
            with_more("[[pair]]\nfixed = \"a\"\nmoving = \"b\"\ntheta = [0, 1e307]"),
            "the angle 1e307 rad",
        ),
    ] {
        says(&error, &[words]);
        let said = error.to_string();
        assert!(said.len() < 250 && !said.contains("00000000"), "{said}");
    }
}
