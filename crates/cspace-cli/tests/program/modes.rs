//! `cspace modes`: answers, pictures, and what is rejected.

use serde_json::Value;

use crate::helpers::{cspace, fails, framed, json, model, printed};

fn written(text: &str) -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("model.toml");
    std::fs::write(&file, text).unwrap();
    let name = file.to_str().unwrap().to_owned();
    (dir, name)
}

const SLIDE: &str = "motion = { type = \"prismatic\", direction = [1, 0], range = [-20, 20] }";

/// Three blocks, 2 long and 4 apart on one rail, a fixed part beside it, and some more.
fn blocks(motions: [&str; 3], more: &str) -> (tempfile::TempDir, String) {
    let mut text = String::from("name = \"blocks\"\nunit = \"mm\"\n");
    for (k, motion) in motions.iter().enumerate() {
        let x = 4.0 * k as f64;
        text += &format!(
            "[[part]]\nname = \"{}\"\nloops = [[[{x}, 0], [{}, 0], [{}, 2], [{x}, 2]]]\n{motion}\n",
            ["a", "b", "c"][k],
            x + 2.0,
            x + 2.0
        );
    }
    text += "[[part]]\nname = \"case\"\nloops = [[[0, 50], [2, 50], [2, 52], [0, 52]]]\nmotion = { type = \"fixed\" }\n";
    written(&(text + more))
}

fn requested(file: &str, at: &str) -> Value {
    json(&["modes", file, "--at", at])["requested"].clone()
}

#[test]
fn each_order_of_blocks_on_a_rail_is_a_mode() {
    let (_dir, file) = blocks([SLIDE; 3], "");
    let answer = json(&["modes", &file]);
    assert_eq!(answer["modes"].as_array().unwrap().len(), 6);
    assert_eq!(answer["doubts"], 0);
    assert_eq!(answer["left_out"].as_array().unwrap().len(), 3);
    let drawn = &answer["requested"]["mode"];
    assert_eq!(requested(&file, "u=-5")["mode"], *drawn);
    // The first block between the others, and beyond them.
    let between = requested(&file, "u=6.5,w=4");
    let beyond = requested(&file, "u=14");
    for place in [&between, &beyond] {
        assert_eq!(place["result"], "free");
        assert_ne!(place["mode"], *drawn);
    }
    assert_ne!(between["mode"], beyond["mode"]);
    // Where blocks overlap, and where a range ends.
    let blocked = requested(&file, "u=4");
    assert_eq!(
        (&blocked["result"], &blocked["mode"]),
        (&Value::from("blocked"), &Value::Null)
    );
    assert_eq!(blocked["between"], serde_json::json!(["a", "b"]));
    assert_eq!(
        requested(&file, "w=21")["between"],
        serde_json::json!(["c"])
    );
    // In another order of the parts the coordinates change places.
    let exchanged = json(&["modes", &file, "--parts", "c,a,b"]);
    assert_eq!(exchanged["modes"].as_array().unwrap().len(), 6);
    assert_eq!(exchanged["parts"][0]["name"], "c");
    // In the order c, b, a the third block is at -12 at the minimum, so the first is at -8.
    let said = printed(&["modes", &file]);
    assert!(said.contains("6 modes\n"), "{said}");
    assert!(
        said.contains("u (a) from -8.000000 mm to 20.000000 mm, its limit\n"),
        "{said}"
    );
    assert!(said.contains("not considered: a and case"), "{said}");
}

#[test]
fn parts_that_overlap_in_all_their_range_have_no_mode() {
    let slide = |range: &str| {
        format!("motion = {{ type = \"prismatic\", direction = [1, 0], range = {range} }}")
    };
    // The second block stays within a unit of the first, which is two long.
    let motions = [slide("[4, 5]"), slide("[0, 1]"), slide("[-1, 1]")];
    let (_dir, file) = blocks(motions.each_ref().map(String::as_str), "");
    let answer = framed(&["modes", &file]);
    assert_eq!(answer["outcome"], "blocked");
    assert_eq!(answer["modes"], serde_json::json!([]));
    let said = printed(&["modes", &file]);
    assert!(
        said.contains("blocked: no configuration of the three is free\n"),
        "{said}"
    );
    cspace(&["modes", &file]).assert().code(1);
}

#[test]
fn a_pair_that_is_not_listed_hinders_nothing() {
    let pair = |a: &str, b: &str| format!("[[pair]]\nfixed = \"{a}\"\nmoving = \"{b}\"\n");
    let (_dir, file) = blocks([SLIDE; 3], &(pair("a", "b") + &pair("c", "b")));
    let answer = json(&["modes", &file]);
    // a and c on either side of b, each for itself.
    assert_eq!(answer["modes"].as_array().unwrap().len(), 4);
    assert_eq!(answer["pairs"][2]["listed"], false);
    assert_eq!(requested(&file, "u=8")["result"], "free");
}

#[test]
fn pictures_have_a_row_for_each_mode() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let interlock = model("shift_interlock");
    let plain = printed(&["modes", &interlock]);
    for name in ["modes.svg", "modes.png", "modes.pdf"] {
        let told = printed(&["modes", &interlock, "-o", &path(name)]);
        assert_eq!(told, plain);
    }
    let picture = std::fs::read_to_string(path("modes.svg")).unwrap();
    for said in [
        "mode 0",
        "shift interlock: modes of first rail, plunger, second rail",
        "w: second rail slides, mm",
    ] {
        assert!(picture.contains(said), "{said}");
    }
    let (_dir, file) = blocks([SLIDE; 3], "");
    cspace(&["modes", &file, "-o", &path("blocks.svg")])
        .assert()
        .success();
    let picture = std::fs::read_to_string(path("blocks.svg")).unwrap();
    assert!(picture.contains("mode 5"));
    // What says more than a small picture has room for is cut.
    let small = [
        "modes",
        &interlock,
        "-o",
        &path("small.svg"),
        "--size=220x180",
    ];
    cspace(&small).assert().success();
    let picture = std::fs::read_to_string(path("small.svg")).unwrap();
    assert!(
        picture.contains("u: first rail sli…<") && !picture.contains("u: first rail slides, mm")
    );
    for option in ["--u=0,1", "--y=0,1", "--labels=none"] {
        let name = option.split('=').next().unwrap();
        fails(
            cspace(&[
                "modes",
                &interlock,
                "-o",
                &path("a.svg"),
                "--size=800x400",
                option,
            ]),
            2,
            &[name, "`cspace modes` has no option", "is for"],
        );
    }
    fails(
        cspace(&["modes", &interlock, "-o", &path("a.ply")]),
        2,
        &["a.ply"],
    );
    for name in ["a.json", "a.txt"] {
        let refused = cspace(&["modes", &interlock, "-o", &path(name)]);
        fails(refused, 2, &[name, ".svg, .png, .pdf"]);
        assert!(!std::path::Path::new(&path(name)).exists());
    }
}

#[test]
fn what_has_no_modes_is_rejected_by_name() {
    let open = "motion = { type = \"prismatic\", direction = [1, 0] }";
    let planar = "motion = { type = \"planar\" }";
    let (_one, file) = blocks([open, SLIDE, open], "");
    let both = ["model.toml", "\"a\" and \"c\"", "give one of them a range"];
    fails(cspace(&["modes", &file]), 2, &both);
    let (_two, file) = blocks([SLIDE, planar, SLIDE], "");
    fails(
        cspace(&["modes", &file]),
        2,
        &[
            "three parts or more",
            "of such parts this model has 2: a, c",
        ],
    );
    let named = |names: &str, words: &[&str]| {
        fails(cspace(&["modes", &file, "--parts", names]), 2, words);
    };
    named(
        "a,b,c",
        &["part \"b\" moves freely in the plane", "--parts A,B,C"],
    );
    named("a,case,c", &["part \"case\" does not move"]);
    named("a,a,c", &["part \"a\" is named twice"]);
    named(
        "a,x,c",
        &["no part \"x\"", "the parts that move on axes are a, c"],
    );
    named("a,c", &["three names are needed"]);
    named(
        "a,b,c,case",
        &["part \"b\" moves freely in the plane", "--parts A,B,C"],
    );
    let joint = "[[joint]]\ntype = \"prismatic\"\ndirection = [1, 0]\nparts = [\"a\", \"b\"]\n";
    let (_three, file) = blocks([SLIDE; 3], joint);
    fails(
        cspace(&["modes", &file]),
        2,
        &[
            "model.toml",
            "parts \"a\" and \"b\" are connected by a joint",
        ],
    );
    let film = model("film_advance");
    fails(cspace(&["modes", &film]), 2, &["a chain of joints"]);
    let (_four, file) = blocks([SLIDE; 3], "");
    for (at, words) in [
        ("x=1", ["\"x=1\" is none of", "u=18deg"]),
        ("u=1,u=2", ["u is given twice", "--at"]),
        ("u=18deg", ["\"18deg\" is no number", "--at"]),
        ("u=inf", ["\"inf\" is no number", "--at"]),
    ] {
        fails(cspace(&["modes", &file, "--at", at]), 2, &words);
    }
}

/// How far the plug of the lock turns from where it is drawn, in degrees, with some parameters set.
fn turned(settings: &[String]) -> f64 {
    let lock = model("layers/pin_tumbler_lock");
    let sets: Vec<String> = settings.iter().map(|s| format!("--set={s}")).collect();
    // A note would say what is set.
    let mut line = vec!["modes", &lock, "--quiet"];
    line.extend(sets.iter().map(String::as_str));
    let answer = json(&line);
    assert_eq!(answer["doubts"], 0, "{settings:?}");
    assert_eq!(answer["parts"][3]["coordinate"], "q4");
    let mode = answer["requested"]["mode"].as_u64().unwrap();
    let mode = &answer["modes"][mode as usize];
    assert_eq!(mode["more"].as_array().unwrap().len(), 4);
    mode["u"]["hi"].as_f64().unwrap().to_degrees()
}

#[test]
fn a_lock_of_five_pins_opens_with_its_key_and_with_no_other() {
    let key = [3, 1, 5, 2, 4];
    let cut = |pin: usize, by: i32| format!("key{}={}", pin + 1, key[pin] + by);
    let mut wrong: Vec<Vec<String>> = Vec::new();
    for pin in 0..5 {
        wrong.extend([-2, -1, 1, 2].map(|by| vec![cut(pin, by)]));
        wrong.push(vec![cut(pin, 1), cut((pin + 1) % 5, -1)]);
    }
    let slots = ["slot1=11.8", "slot1=10.2", "slot2=13.8", "slot2=12.2"];
    wrong.extend(slots.map(|slot| vec![slot.to_owned()]));
    wrong.push(vec!["slot1=13".to_owned(), "slot2=11".to_owned()]);
    assert_eq!(wrong.len(), 30);
    assert!((turned(&[]) - 90.0).abs() < 1e-6);
    for settings in wrong {
        let far = turned(&settings);
        let most = if settings[0].starts_with("slot") {
            26.0
        } else {
            8.0
        };
        assert!(far < most, "{settings:?} turns it by {far}");
    }
    // Who lifts the driver pins opens it with cuts that are too deep, and not with one that is too shallow.
    let picked = |key: &str| turned(&["lift=3".to_owned(), key.to_owned()]);
    assert!((picked("key3=6") - 90.0).abs() < 1e-6);
    assert!(picked("key3=4") < 8.0);
}

#[test]
fn more_parts_than_three_are_told_and_refused_in_their_words() {
    let lock = model("layers/pin_tumbler_lock");
    let said = printed(&["modes", &lock]);
    for line in [
        "  u (plug) from -1.0000 deg, its limit, to 90.0000 deg, its limit\n",
        "plug, driver pin 5: ",
        "  q7 (driver pin 5) from ",
    ] {
        assert!(said.contains(line), "{line}: {said}");
    }
    // A driver pin, raised out of the way; by its name's coordinate alone.
    let at = &requested(&lock, "q4=0.05")["at"];
    assert_eq!(at["more"], serde_json::json!([0.05, 0.0, 0.0, 0.0]));
    fails(
        cspace(&["modes", &lock, "--at", "q8=1"]),
        2,
        &["\"q8=1\" is none of", "q7=Q"],
    );
    let dir = tempfile::tempdir().unwrap();
    let picture = dir.path().join("modes.svg");
    let refused = cspace(&["modes", &lock, "-o", picture.to_str().unwrap()]);
    fails(
        refused,
        2,
        &["modes of 7 parts have no picture", "--parts A,B,C"],
    );
    assert!(!picture.exists());
    // Four blocks on one rail, each of which may touch all others.
    let more = "[[part]]\nname = \"d\"\nloops = [[[12, 0], [14, 0], [14, 2], [12, 2]]]\n"
        .to_owned()
        + SLIDE;
    let (_dir, file) = blocks([SLIDE; 3], &more);
    fails(
        cspace(&["modes", &file]),
        2,
        &["model.toml", "around a cycle", "--parts a,"],
    );
    let three = json(&["modes", &file, "--parts", "a,b,d"]);
    assert_eq!(three["modes"].as_array().unwrap().len(), 6);
}
