//! `cspace draw`, and pictures of `slice` and `export`.

use std::path::Path;

use crate::helpers::{cspace, fails, framed, model, printed};

/// Every model that is shipped.
fn models() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let files = std::fs::read_dir(folder)
        .unwrap()
        .map(|f| f.unwrap().path());
    let mut models: Vec<String> = files
        .filter(|p| p.extension().is_some_and(|e| e == "toml"))
        .map(|p| p.to_str().unwrap().to_owned())
        .collect();
    models.sort();
    assert!(models.len() > 10);
    models
}

/// Writes a picture and gives it back, after a look at what it begins with.
#[track_caller]
fn picture(name: &str, args: &[&str]) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join(name);
    let all: Vec<&str> = args
        .iter()
        .copied()
        .chain(["-o", out.to_str().unwrap()])
        .collect();
    let said = printed(&all);
    match args[0] {
        "draw" | "export" => assert_eq!(said, ""),
        // The answer is printed as without a picture, but for what is about pictures alone.
        _ => {
            let mut plain: Vec<&str> =
                (args.iter().take_while(|a| **a != "--at").copied()).collect();
            if args[0] == "tolerances" && !args.contains(&"--along") {
                // What its pictures are of.
                plain.push("--zones");
            }
            assert_eq!(said, printed(&plain));
        }
    }
    let bytes = std::fs::read(out).unwrap();
    let begins: &[u8] = match name.rsplit('.').next().unwrap() {
        "svg" => b"<svg",
        "png" => b"\x89PNG",
        _ => b"%PDF",
    };
    assert!(bytes.starts_with(begins), "{args:?}");
    bytes
}

fn svg(args: &[&str]) -> String {
    String::from_utf8(picture("a.svg", args)).unwrap()
}

#[test]
fn parts_of_every_model_are_drawn() {
    for file in models().into_iter().step_by(cspace_oracle::effort(6, 1)) {
        for name in ["a.svg", "a.PNG", "a.pdf"] {
            picture(&name.to_lowercase(), &["draw", &file]);
        }
        let text = printed(&["draw", &file]);
        assert!(text.starts_with("<svg") && text.len() < 300_000, "{file}");
        assert_eq!(text, svg(&["draw", &file]));
    }
}

/// A peg of 2 by 4 beside a block with its right side at x = 3: at x = 4 it touches, and the mark is on x = 3.
#[test]
fn contacts_are_marked_where_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("m.toml");
    let text = "unit = \"mm\"\n[[part]]\nname = \"block\"\nloops = [[[-3, -3], [3, -3], [3, 3], [-3, 3]]]\n\
        [[part]]\nname = \"peg\"\nloops = [[[-1, -2], [1, -2], [1, 2], [-1, 2]]]\n";
    std::fs::write(&file, text).unwrap();
    let file = file.to_str().unwrap();
    let touching = svg(&[
        "draw",
        file,
        "--at",
        "4,0,0",
        "--x=-4,6",
        "--y=-5,5",
        "--size",
        "1000x1000",
    ]);
    assert!(touching.contains("line 1 of loop 0 of block touches vertex 3 of loop 0 of peg"));
    assert!(touching.contains("in contact"));
    // Where x = 3 is: the frame's tick numbers tell the scale.
    let tick = |number: &str| {
        let at = touching.find(&format!(">{number}</text>")).unwrap();
        let tag = &touching[touching[..at].rfind("<text").unwrap()..at];
        let x = tag.split(" x=\"").nth(1).unwrap();
        x[..x.find('"').unwrap()].parse::<f64>().unwrap()
    };
    let three = tick("2") + 0.25 * (tick("6") - tick("2"));
    let marks: Vec<f64> = touching
        .split("fill=\"#d0002a\"")
        .filter_map(|before| before.rsplit("d=\"M").next())
        .filter_map(|d| d.split([' ', '-', 'a']).next()?.parse().ok())
        .collect();
    // The left end of a round mark of radius .32 letters of 13 · 1000/960.
    assert!(
        marks
            .iter()
            .any(|x| (x + 0.32 * 13.0 * 1000.0 / 960.0 - three).abs() < 0.1),
        "{marks:?} {three}"
    );
    let apart = svg(&["draw", file, "--at", "4.5,0,0"]);
    assert!(apart.contains("free, outside, 0.500000 mm apart") && !apart.contains("#d0002a"));
    let over = svg(&["draw", file, "--at", "0,0,0"]);
    assert!(over.contains("blocked: the parts overlap"));
}

#[test]
fn slices_come_at_even_steps() {
    let file = model("ratchet_pawl");
    let six = svg(&["export", &file, "--slices", "6"]);
    for degrees in ["−180", "−120", "−60", "0", "60", "120"] {
        assert!(
            six.contains(&format!(">θ = {degrees}°</text>")),
            "{degrees}"
        );
    }
    let window = svg(&["export", &file, "--slices", "3", "--window=-10deg,10deg"]);
    for degrees in ["−10", "0", "10"] {
        assert!(
            window.contains(&format!(">θ = {degrees}°</text>")),
            "{degrees}"
        );
    }
    let one = svg(&["slice", &file, "--theta", "12.5deg"]);
    assert!(one.contains(">slice at θ = 12.5°</text>"));
    assert!(one.contains(">ratchet and pawl: pawl relative to ratchet, lengths in mm</text>"));
    for name in ["a.png", "a.pdf"] {
        picture(
            name,
            &["slice", &file, "--theta", "12.5deg", "--at", "30,40"],
        );
        picture(name, &["export", &file, "--slices", "2"]);
    }
}

#[test]
fn planes_name_their_axes_and_zoom() {
    let file = model("gears_on_shafts");
    let whole = svg(&["slice", &file]);
    for said in [
        ">u: gear turns, degrees<",
        ">v: pinion turns, degrees<",
        ">−180</text>",
        ">180</text>",
    ] {
        assert!(whole.contains(said), "{said}");
    }
    let near = svg(&[
        "export",
        &file,
        "--u",
        "0,20deg",
        "--v=-5deg,15deg",
        "--title",
        "near & far",
    ]);
    assert!(near.contains(">20</text>") && near.contains(">near &amp; far</text>"));
    assert!(!near.contains(">180</text>"));
}

#[test]
fn what_a_picture_does_not_have_is_refused() {
    let (planar, axes) = (model("ratchet_pawl"), model("gears_on_shafts"));
    let folder = tempfile::tempdir().unwrap();
    let out = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let cases: &[(&[&str], &str)] = &[
        (
            &["draw", &planar, "-o", &out("a.jpg")],
            ".svg, .png or .pdf",
        ),
        (
            &["slice", &planar, "--theta", "0", "-o", &out("a.txt")],
            ".svg, .png, .pdf, .dxf, .json",
        ),
        (&["draw", &planar, "--u", "0,1"], "--x and --y"),
        (
            &["slice", &planar, "--theta", "0", "--size", "300x300"],
            "--size is about pictures",
        ),
        (
            &["slice", &planar, "--theta", "0", "--at", "1,2"],
            "--at is about pictures",
        ),
        (
            &["slice", &axes, "-o", &out("a.svg"), "--x", "0,1"],
            "--u and --v",
        ),
        (
            &["slice", &axes, "-o", &out("a.svg"), "--at", "0,1"],
            "without parts",
        ),
        (
            &["export", &planar, "-o", &out("a.ply"), "--labels", "none"],
            "--labels is about pictures",
        ),
        (
            &["export", &axes, "-o", &out("a.svg"), "--slices", "4"],
            "one plane",
        ),
        (&["draw", &planar, "--size", "12"], "width x height"),
        (&["draw", &planar, "--size", "1e9x1e9"], "from 100 to 50000"),
        (
            &[
                "draw",
                &planar,
                "-o",
                &out("a.png"),
                "--size",
                "50000x50000",
            ],
            "a smaller --size",
        ),
        (&["draw", &planar, "--x", "2,1"], "the smaller first"),
        (&["draw", &planar, "--at", "1,2"], "--at x,y,theta"),
    ];
    for (args, said) in cases {
        fails(cspace(args), 2, &[said]);
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Contact zones, with the features of their bands; and a requirement along a motion, with how far its extremes are off.
#[test]
#[ignore = "long: seconds"]
fn tolerances_are_drawn() {
    let lock = model("tolerances/geneva_lock");
    let zones = svg(&["tolerances", &lock, "--v=-1deg,1deg"]);
    for said in [
        "free within all",
        "blocked within all",
        "vertex 0 of loop 0",
        "v: wheel turns",
    ] {
        assert!(zones.contains(said), "{said}");
    }
    let along = svg(&["tolerances", &lock, "--along", "u=0:1:2"]);
    for said in [
        ">dwell, deg<",
        ">off by, dwell, deg<",
        ">smallest<",
        ">largest<",
    ] {
        assert!(along.contains(said), "{said}");
    }
}

/// Two parts on axes have no orientation, and a motion has no zones: what is not used is refused.
#[test]
fn an_orientation_of_zones_is_used_or_refused() {
    let lock = model("tolerances/geneva_lock");
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.svg");
    let out = out.to_str().unwrap();
    let on_axes = [
        "--at: driver and wheel move on axes",
        "leave --at out",
        "--u and --v",
    ];
    for args in [&["--zones"][..], &["-o", out]] {
        let asked = [&["tolerances", &lock, "--at=10deg"], args].concat();
        fails(cspace(&asked), 2, &on_axes);
    }
    let along = [
        "tolerances",
        &lock,
        "--at=10deg",
        "--along=u=0:1:2",
        "-o",
        out,
    ];
    fails(
        cspace(&along),
        2,
        &["--at is the orientation of contact zones"],
    );
    assert!(!Path::new(out).exists());
}

/// Files that are written have the unit of what they are made of: of a model, of a space that keeps its unit, of a drawing.
#[test]
fn the_unit_of_what_is_written_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let peg = model("peg_hole");
    let unit = |args: &[&str]| framed(args)["units"]["length"].clone();
    let [space, outlines] = ["space.json", "outlines.dxf"].map(path);
    for args in [
        ["export", &peg, "-o", &space],
        ["export", &space, "-o", &path("slices.svg")],
        ["draw", &peg, "-o", &path("parts.svg")],
        ["draw", &peg, "-o", &outlines],
        ["draw", &outlines, "-o", &path("drawing.svg")],
    ] {
        assert_eq!(unit(&args), "mm", "{args:?}");
    }
    let mut saved: serde_json::Value =
        serde_json::from_slice(&std::fs::read(&space).unwrap()).unwrap();
    saved.as_object_mut().unwrap().remove("unit");
    std::fs::write(&space, saved.to_string()).unwrap();
    assert!(unit(&["draw", &space, "-o", &path("none.svg")]).is_null());
}

/// Each feature has one label, called as in answers, or is counted as left out; a square has room for all of its own.
#[test]
fn features_are_labelled_where_they_fit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("square.toml");
    let text = "[[part]]\nname = \"square\"\nloops = [[[0, 0], [4, 0], [4, 4], [0, 4]]]\n";
    std::fs::write(&path, text).unwrap();
    let labelled = |file: &str| printed(&["draw", file, "--labels", "features", "-o", "-"]);
    let drawn = labelled(path.to_str().unwrap());
    assert!(
        drawn.contains(">labels of all 8 features</text>"),
        "{drawn}"
    );
    for k in 0..4 {
        for kind in ["line", "vertex"] {
            let said = format!(">{kind} {k} of loop 0</text>");
            assert_eq!(drawn.matches(&said).count(), 1, "{said}");
        }
    }
    let drawn = labelled(&model("ratchet_pawl"));
    let told = drawn.split(">labels of ").nth(1).unwrap();
    let mut numbers = told
        .split(' ')
        .filter_map(|word| word.parse::<usize>().ok());
    let (left_out, all) = (numbers.next().unwrap(), numbers.next().unwrap());
    let labels = drawn.matches(" of loop ").count();
    assert!(left_out > 0 && labels > 4);
    // Some features of this model have names of their own.
    assert!(labels + left_out <= all);
    let plain = printed(&["draw", path.to_str().unwrap(), "-o", "-"]);
    assert!(!plain.contains("of loop"));
}

/// In the train, the first arbor is at 0 to 8, the third at 8 to 16, and the second has a layer at each.
#[test]
fn one_height_is_drawn_alone() {
    let file = model("layers/compound_train");
    let named = |of: &str, text: &str| text.contains(&format!(">{of} arbor</text>"));
    for (z, first, third) in [
        ("4", true, false),
        ("8", false, true),
        ("15.9", false, true),
    ] {
        let drawn = svg(&["draw", &file, "--height", z]);
        assert!(named("second", &drawn), "{z}");
        assert_eq!(named("first", &drawn), first, "{z}");
        assert_eq!(named("third", &drawn), third, "{z}");
    }
    let all = svg(&["draw", &file]);
    assert!(
        ["first", "second", "third"]
            .iter()
            .all(|of| named(of, &all))
    );
    for z in ["16", "-1", "nan"] {
        let command = cspace(&["draw", &file, "--height", z]);
        fails(
            command,
            2,
            &["no layer is there", "from 0 to less than 16 mm"],
        );
    }
    let flat = cspace(&["draw", &model("knee"), "--height", "1"]);
    fails(flat, 2, &["no part has any"]);
    // Loops of the outlines alone: a gear, and a gear with a bore.
    let loops = |more: &[&str]| {
        let outlines = printed(&[&["draw", &file, "--outlines"], more].concat());
        outlines.matches('M').count()
    };
    assert_eq!(loops(&["--height", "4"]), 3);
    assert_eq!(loops(&["--height", "12"]), 3);
    assert_eq!(loops(&[]), 6);
}

/// The lower follower lies on the lower cam: at the heights of the upper one nothing touches.
#[test]
fn contacts_are_those_of_the_height() {
    let file = model("layers/cam_stack");
    let at = ["draw", &file, "--pair", "shaft,lower follower", "--at"];
    let touching = svg(&[&at[..], &["90deg,6"]].concat());
    assert!(touching.contains(" touches "));
    let lower = svg(&[&at[..], &["90deg,6", "--height", "4"]].concat());
    assert!(lower.contains(" touches "));
    let upper = svg(&[&at[..], &["90deg,6", "--height", "14"]].concat());
    assert!(!upper.contains(" touches "));
}
