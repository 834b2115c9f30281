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
        &["of such parts this model has 2: a, c"],
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
    named("a,b,c,case", &["--parts names 4 parts"]);
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
