//! The command on pairs of every class.

#![allow(clippy::unwrap_used)]

use assert_cmd::Command;
use cspace::{Configuration, Point, Rotation};
use serde_json::{Value, json};

/// A pair of each class, all of one mechanism.
const PAIRS: [(&str, &str); 6] = [
    ("frame,driver", "lower"),
    ("frame,link", "lower"),
    ("frame,ratchet", "lower"),
    ("link,pawl", "lower"),
    ("driver,link", "fixed-axes"),
    ("ratchet,pawl", "symmetric"),
];

fn model(name: &str) -> String {
    format!("{}/../../models/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}

fn mechanism() -> String {
    model("ratchet_mechanism")
}

fn cspace(args: &[&str]) -> Command {
    let mut command = Command::cargo_bin("cspace").unwrap();
    command.args(args);
    command
}

fn printed(args: &[&str]) -> String {
    let output = cspace(args).assert().success().get_output().clone();
    assert!(output.stderr.is_empty(), "{args:?}: {output:?}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(args: &[&str]) -> Value {
    let args = [args, &["--format", "json"]].concat();
    serde_json::from_str(&printed(&args)).unwrap()
}

/// A run that fails with this code says all of `words`, and prints nothing to stdout.
#[track_caller]
fn fails(mut command: Command, code: i32, words: &[&str]) {
    let output = command.assert().code(code).get_output().clone();
    assert!(output.stdout.is_empty(), "{output:?}");
    let message = String::from_utf8(output.stderr).unwrap();
    for word in words {
        assert!(message.contains(word), "no {word:?} in: {message}");
    }
}

fn with_rows(args: &[&str], rows: &str) -> Command {
    let mut command = cspace(&[&["classify"], args].concat());
    command.write_stdin(rows.to_owned());
    command
}

/// The classes of rows of numbers.
fn classes(args: &[&str], header: &str, rows: &[Vec<f64>]) -> Vec<String> {
    let mut text = format!("{header}\n");
    for row in rows {
        let row: Vec<String> = row.iter().map(f64::to_string).collect();
        text += &(row.join(",") + "\n");
    }
    let output = with_rows(args, &text)
        .assert()
        .success()
        .get_output()
        .clone();
    let answer = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<&str> = answer.lines().collect();
    assert_eq!(lines[0], format!("{header},class"));
    assert_eq!(lines.len(), rows.len() + 1);
    (lines[1..].iter().zip(text.lines().skip(1)))
        .map(|(line, given)| line.strip_prefix(&format!("{given},")).unwrap().to_owned())
        .collect()
}

#[test]
fn every_pair_of_the_mechanism_has_its_class() {
    let file = mechanism();
    let info = json(&["info", &file]);
    let all = json(&["compute", &file]);
    for (list, what) in [(&info["pairs"], "info"), (&all, "compute")] {
        let found: Vec<(String, &str)> = (list.as_array().unwrap().iter())
            .map(|p| {
                let name = |key: &str| p[key].as_str().unwrap();
                (
                    format!("{},{}", name("fixed"), name("moving")),
                    name("class"),
                )
            })
            .collect();
        let found: Vec<(&str, &str)> = found.iter().map(|(n, c)| (n.as_str(), *c)).collect();
        assert_eq!(found, PAIRS, "{what}");
    }
    assert_eq!(info["joints"].as_array().unwrap().len(), 4);
}

/// The keys of the contract are there for pairs of every class, and mean what they should.
#[test]
fn compute_has_the_keys_of_the_contract_for_every_class() {
    let all = json(&["compute", &mechanism()]);
    for pair in all.as_array().unwrap() {
        let name = &pair["moving"];
        for key in ["fixed", "moving", "class"] {
            assert!(pair[key].is_string(), "{name}: {key}");
        }
        let critical = pair["critical_orientations"].as_array().unwrap().len();
        let counts = [
            "/features/fixed",
            "/features/moving",
            "/features/total",
            "/symmetry/fixed",
            "/symmetry/moving",
            "/bands",
            "/slices",
            "/patches",
            "/links/side",
            "/links/vertical",
            "/free_regions",
        ]
        .map(|key| pair.pointer(key).and_then(Value::as_u64).expect(key));
        let [
            fixed,
            moving,
            total,
            _,
            _,
            bands,
            slices,
            patches,
            side,
            vertical,
            regions,
        ] = counts;
        assert_eq!(fixed + moving, total);
        assert!(pair["seconds"]["total"].as_f64().unwrap() > 0.0);
        match pair["class"].as_str().unwrap() {
            "lower" => {
                assert_eq!((critical, bands, slices, patches), (0, 1, 0, 1), "{name}");
                assert_eq!((side, vertical, regions), (0, 0, 0), "{name}");
                let permanent = &pair["motion"]["permanent"][0];
                assert_eq!(permanent["permanent"], true);
                assert_eq!(permanent["kind"], "point-arc");
            }
            "fixed-axes" => {
                // The fork touches the eccentric on either side, in front of its middle and behind: closed curves.
                assert_eq!((critical, bands, slices, vertical), (0, 1, 1, 0));
                assert_eq!((patches, side, regions), (4, 4, 1));
            }
            "symmetric" => {
                assert_eq!(bands, 20 * slices, "one slab of twenty was computed");
                assert_eq!(bands as usize, critical);
                assert_eq!(pair["symmetry"], json!({ "fixed": 20, "moving": 1 }));
                assert_eq!((side > 0, vertical > 0, regions), (true, true, 1));
            }
            other => panic!("{other}"),
        }
    }
}

/// The driver turns for ever. The link follows the direction of the eccentric's centre as the fork's clearance lets it:
/// thrown by 19.5 at a distance of 100, with 0.1 to either side.
#[test]
fn the_driver_goes_around_and_rocks_the_link() {
    let file = mechanism();
    let pair = ["--pair", "driver,link"];
    let all = json(&["compute", &file, pair[0], pair[1]]);
    let region = &all[0]["regions"][0];
    assert_eq!(
        (&region["around_u"], &region["around_v"]),
        (&json!(true), &json!(false))
    );
    let (throw, shaft, play) = (19.5f64, 100.0f64, 0.1f64);
    let mut rows = Vec::new();
    let mut expected = Vec::new();
    for i in 0..72 {
        let u = 0.1 + 5f64.to_radians() * f64::from(i);
        // The centre of the eccentric, seen from the link's pivot.
        let (x, y) = (throw * u.sin(), shaft + throw * u.cos());
        let (direction, distance) = (x.atan2(y), x.hypot(y));
        let clearance = (play / distance).asin();
        for (part, class) in [
            (-1.001, "blocked"),
            (-0.999, "free"),
            (0.0, "free"),
            (0.999, "free"),
            (1.001, "blocked"),
        ] {
            rows.push(vec![u, direction + part * clearance]);
            expected.push(class);
        }
    }
    assert_eq!(classes(&[&file, pair[0], pair[1]], "u,v", &rows), expected);
    // The reach of the link: where the line from its pivot touches the throw's circle, nearly.
    let most = region["v"][1].as_f64().unwrap();
    let swing = (throw / shaft).asin();
    assert!(
        most > swing && most < swing + 1.1 * play / (shaft - throw),
        "{most}"
    );
}

/// On the way counter-clockwise the pawl bears on the tooth; on the way back it is lifted over the next one.
#[test]
fn the_pawl_catches_and_rides_over() {
    let pivot = Point::new(42.0, 56.0);
    // The link turned about the wheel's axis, the pawl about its pivot on the link.
    let pose = |link: f64, pawl: f64| {
        let (link, pawl) = (link.to_radians(), pawl.to_radians());
        let arm = pivot.to_vector();
        let at = Rotation::by(link) * arm - Rotation::by(link + pawl) * arm;
        vec![at.x, at.y, link + pawl]
    };
    let file = mechanism();
    let args = [file.as_str(), "--pair", "ratchet,pawl"];
    let ask = |rows: &[Vec<f64>]| classes(&args, "x,y,theta", rows);
    let engaged: Vec<Vec<f64>> = [0.0, 0.2, -18.0, -17.8].map(|a| pose(a, 0.0)).into();
    assert_eq!(ask(&engaged), ["free", "blocked", "free", "blocked"]);
    // Turned onto the wheel it is stopped, and so it is on the way if it does not lift.
    assert_eq!(ask(&[pose(0.0, 4.0), pose(-9.0, 0.0)]), ["blocked"; 2]);
    // Lifted by 7 deg it passes, all the way to the next tooth.
    let back: Vec<Vec<f64>> = (0..=36).map(|i| pose(-0.5 * f64::from(i), -7.0)).collect();
    assert!(ask(&back).iter().all(|c| c == "free"));
}

/// Dead beat: while the anchor swings on, the wheel rests, at one and the same angle.
#[test]
fn the_escape_wheel_rests_while_the_anchor_swings_on() {
    let file = model("escapement");
    let at = |v: f64, u: f64| vec![u.to_radians(), v.to_radians()];
    let rests = |deg: f64, side: f64| {
        let ask = |u: f64| classes(&[&file], "u,v", &[at(side * deg, u)]).remove(0);
        // From a free angle on, clockwise, until the wheel is stopped.
        let (mut free, mut blocked) = if side > 0.0 {
            (-9.5, -12.0)
        } else {
            (-3.5, -6.0)
        };
        assert_eq!(
            (ask(free), ask(blocked)),
            ("free".into(), "blocked".into()),
            "{deg} {side}"
        );
        for _ in 0..34 {
            let middle = 0.5 * (free + blocked);
            if ask(middle) == "free" {
                free = middle;
            } else {
                blocked = middle;
            }
        }
        free
    };
    for side in [1.0, -1.0] {
        let angles = [2.5, 4.0, 5.9].map(|deg| rests(deg, side));
        assert!((angles[0] - angles[1]).abs() < 1e-7, "{angles:?}");
        assert!((angles[2] - angles[1]).abs() < 1e-7, "{angles:?}");
    }
    // From one side to the other it steps by half a pitch.
    let step = rests(4.0, -1.0) - rests(4.0, 1.0);
    assert!((step - 6.0).abs() < 0.1, "{step}");
}

#[test]
fn the_general_method_can_be_asked_for_whatever_the_class() {
    let file = mechanism();
    for (pair, class) in PAIRS {
        let args = [&file, "--pair", pair, "--general"];
        let info = json(&[&["info"], &args[..]].concat());
        assert_eq!(info["pairs"][0]["class"], "general", "{pair}");
        if pair == "frame,ratchet" {
            continue; // As the others, and the slowest of them.
        }
        let general = json(&[&["compute"], &args[..]].concat());
        assert_eq!(general[0]["class"], "general", "{pair}");
        assert_eq!(general[0]["slices"], general[0]["bands"]);
        let text = printed(&[&["compute"], &args[..]].concat());
        assert_eq!(
            text.contains(&format!("the pair's class is {class}")),
            class != "symmetric",
            "{text}"
        );
    }
}

/// Where the link is in the driver's frame, by the motions written down anew.
fn relative(u: f64, v: f64) -> Configuration {
    let shaft = Point::new(0.0, -100.0);
    // q -> R_v q in the assembly, which the driver sees turned back about its shaft.
    let back = Rotation::by(-u);
    let at = shaft + back * (Point::ORIGIN - shaft);
    Configuration::new(at.x, at.y, v - u)
}

#[test]
fn classes_by_u_and_v_are_those_of_the_general_method() {
    let file = mechanism();
    let mut axes = Vec::new();
    let mut planar = Vec::new();
    for i in 0..60 {
        for j in -20..=20 {
            let (u, v) = (0.017 + 0.105 * f64::from(i), 0.017 * f64::from(j) + 0.0004);
            axes.push(vec![u, v]);
            let c = relative(u, v);
            planar.push(vec![c.x, c.y, c.theta]);
        }
    }
    // In the model's file the link is kept within 20 deg, and rows beyond would be refused.
    let pair = [file.as_str(), "--pair", "driver,link"];
    let by_axes = classes(&pair, "u,v", &axes);
    let general = classes(&[&pair[..], &["--general"]].concat(), "x,y,theta", &planar);
    assert!(by_axes == general);
    for class in ["free", "blocked"] {
        assert!(by_axes.iter().any(|c| c == class), "{class}");
    }
}

#[test]
fn wrong_columns_and_rows_beyond_the_range_are_told() {
    let file = mechanism();
    let ask = |pair: &str, more: &[&str], rows: &str| {
        with_rows(&[&[file.as_str(), "--pair", pair], more].concat(), rows)
    };
    let wants_axes = [
        "line 1",
        "fixed-axes",
        "driver,link",
        "is u and v",
        "--general",
    ];
    fails(
        ask("driver,link", &[], "x,y,theta\n0,0,0\n"),
        2,
        &wants_axes,
    );
    fails(ask("driver,link", &[], "u\n0\n"), 2, &wants_axes);
    for (pair, more) in [
        ("driver,link", &["--general"][..]),
        ("ratchet,pawl", &[]),
        ("frame,link", &[]),
    ] {
        let words = ["line 1", "\"u,v\"", pair, "x, y and theta"];
        fails(ask(pair, more, "u,v\n0,0\n"), 2, &words);
    }
    fails(
        ask("driver,link", &[], "u,v,u\n0,0,0\n"),
        2,
        &["column u", "twice", "once"],
    );
    fails(
        ask("driver,link", &[], "u,v\n0,0\n0,x\n"),
        2,
        &["line 3", "column v", "\"x\""],
    );
    fails(
        ask("driver,link", &[], "u,v\n0,inf\n"),
        2,
        &["line 2", "column v"],
    );
    fails(
        ask("driver,link", &[], "u,v\n9,0\n0,0.36\n"),
        2,
        &["line 3", "v 0.36", "-0.349", "0.349", "link", "range"],
    );
    fails(
        ask("ratchet,pawl", &["--theta", "0,1"], "x,y,theta\n0,0,2\n"),
        2,
        &["line 2", "theta 2", "from 0 to 1"],
    );
    fails(
        with_rows(&[&model("rack_pinion")], "u,v\n0,-70\n0,-70.5\n"),
        2,
        &["line 3", "v -70.5", "from -70 to 70", "rack"],
    );
    // Angles may have a unit, lengths may not.
    let angles = ask("driver,link", &[], "u,v\n0.1turn,-30deg\n");
    fails(angles, 2, &["line 2", "v -0.52"]);
    fails(
        with_rows(&[&model("rack_pinion")], "u,v\n5deg,1deg\n"),
        2,
        &["column v", "1deg"],
    );
}

#[test]
fn orientations_are_refused_where_they_are_no_coordinate() {
    let file = mechanism();
    for (pair, class) in [("frame,link", "lower"), ("driver,link", "fixed-axes")] {
        for command in ["info", "compute"] {
            let args = [command, &file, "--pair", pair, "--theta", "0,1"];
            fails(cspace(&args), 2, &[pair, class, "window", "--general"]);
        }
        let args = ["classify", &file, "--pair", pair, "--theta", "0,1"];
        let mut command = cspace(&args);
        command.write_stdin("x,y,theta,u,v\n0,0,0,0,0\n");
        fails(command, 2, &[pair, class, "--general"]);
        fails(
            cspace(&["slice", &file, "--pair", pair, "--theta", "0.1"]),
            2,
            &["--theta", pair, class, "--general"],
        );
    }
    // With all pairs the window fits some only.
    fails(
        cspace(&["compute", &file, "--theta", "0,1"]),
        2,
        &["frame,driver", "--pair"],
    );
    fails(
        cspace(&["slice", &file, "--pair", "frame,link"]),
        1,
        &["lower", "--general"],
    );
    printed(&[
        "slice",
        &file,
        "--pair",
        "driver,link",
        "--theta",
        "0.1",
        "--general",
    ]);
}

#[test]
fn slices_and_pictures_of_fixed_axes_show_the_plane_of_the_motions() {
    let file = mechanism();
    let dir = tempfile::tempdir().unwrap();
    let pair = ["--pair", "driver,link"];
    let text = printed(&["slice", &file, pair[0], pair[1]]);
    assert!(
        text.starts_with("driver (fixed, u), link (moving, v): 4 contact curves"),
        "{text}"
    );
    let plane = json(&["slice", &file, pair[0], pair[1]]);
    assert_eq!(plane["patches"].as_array().unwrap().len(), 4);
    let by = |command: &str, name: &str| {
        let out = dir.path().join(name);
        printed(&[
            command,
            &file,
            pair[0],
            pair[1],
            "-o",
            out.to_str().unwrap(),
        ]);
        std::fs::read_to_string(out).unwrap()
    };
    let picture = by("slice", "a.svg");
    assert!(
        picture.starts_with("<svg") || picture.starts_with("<?xml"),
        "{picture}"
    );
    assert!(picture.contains("link in driver"));
    assert_eq!(picture, by("export", "b.svg"));
}

#[test]
fn surfaces_are_refused_where_there_are_none() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_owned();
    let file = mechanism();
    for (pair, class) in [("frame,link", "lower"), ("driver,link", "fixed-axes")] {
        let saved = path("saved.json");
        printed(&["export", &file, "--pair", pair, "-o", &saved]);
        for name in ["out.ply", "out.obj", "out.stl"] {
            let out = path(name);
            let words = [pair, class, "surface", "--general"];
            fails(
                cspace(&["export", &file, "--pair", pair, "-o", &out]),
                1,
                &words,
            );
            fails(cspace(&["export", &saved, "-o", &out]), 1, &words);
            assert!(!std::path::Path::new(&out).exists());
        }
    }
    let out = path("out.svg");
    fails(
        cspace(&["export", &file, "--pair", "frame,link", "-o", &out]),
        1,
        &["picture", "lower"],
    );
}

/// A summary without what depends on the clock.
fn timeless(mut value: Value) -> Value {
    value[0]["seconds"] = Value::Null;
    value
}

#[test]
fn saved_spaces_of_every_class_answer_as_their_models_do() {
    let dir = tempfile::tempdir().unwrap();
    let file = mechanism();
    for (pair, class) in PAIRS {
        let saved = dir.path().join(format!("{class}.json"));
        let saved = saved.to_str().unwrap();
        let model = [file.as_str(), "--pair", pair];
        printed(&[&["export"], &model[..], &["-o", saved]].concat());
        // Writing it again changes nothing.
        let again = dir.path().join("again.json");
        printed(&["export", saved, "-o", again.to_str().unwrap()]);
        assert!(
            std::fs::read(saved).unwrap() == std::fs::read(again).unwrap(),
            "{pair}"
        );

        let info = json(&["info", saved]);
        assert_eq!(info["pairs"][0]["class"], class, "{pair}");
        let summary = |args: &[&str]| timeless(json(&[&["compute"], args].concat()));
        assert_eq!(summary(&[saved]), summary(&model), "{pair}");

        let (header, rows) = if class == "fixed-axes" {
            (
                "u,v",
                vec![vec![0.0, 0.0], vec![1.0, 0.3], vec![3.2, -0.0141]],
            )
        } else {
            let rows = [[0.0, 0.0, 0.0], [3.0, 200.0, 0.4], [0.0, 1.0, 0.1]];
            ("x,y,theta", rows.map(|r| r.to_vec()).into())
        };
        let classified = classes(&[saved], header, &rows);
        assert_eq!(classified, classes(&model, header, &rows), "{pair}");

        match class {
            "lower" => {
                assert_eq!(classified, ["contact", "blocked", "blocked"], "{pair}");
                fails(cspace(&["slice", saved]), 1, &["lower", "--general"]);
                let joint = &info["joints"][0];
                assert_eq!(joint["type"], "revolute");
            }
            "fixed-axes" => {
                assert_eq!(classified, ["free", "blocked", "free"]);
                assert_eq!(
                    printed(&["slice", saved]),
                    printed(&[&["slice"], &model[..]].concat())
                );
                let motion = &info["parts"][1]["motion"];
                assert_eq!(motion["type"], "revolute");
                assert!(motion["range"].is_array());
                fails(cspace(&["slice", saved, "--theta", "1"]), 2, &["--theta"]);
            }
            _ => {
                assert_eq!(classified[..2], ["free", "free"]);
                let slice = |args: &[&str]| json(&[&["slice", "--theta", "0.3"], args].concat());
                let (a, b) = (slice(&[saved]), slice(&model));
                let curves = |s: &Value| s["curves"].as_array().unwrap().len();
                assert_eq!(curves(&a), curves(&b));
            }
        }
        fails(
            cspace(&["compute", saved, "--general"]),
            2,
            &["--general", class, "saved", "model"],
        );
        fails(
            cspace(&["compute", saved, "--theta", "0,1"]),
            2,
            &["--theta", "saved"],
        );
        fails(cspace(&["compute", saved, "--pair", "a,b"]), 2, &[pair]);
    }
    // What the general method made stays general.
    let saved = dir.path().join("general.json");
    let saved = saved.to_str().unwrap();
    printed(&[
        "export",
        &file,
        "--pair",
        "driver,link",
        "--general",
        "-o",
        saved,
    ]);
    for args in [&["info", saved][..], &["info", saved, "--general"]] {
        assert_eq!(json(args)["pairs"][0]["class"], "general");
    }
    assert_eq!(
        json(&["compute", saved, "--general"])[0]["class"],
        "general"
    );
    printed(&["slice", saved, "--theta", "0.1"]);
}

#[test]
fn the_models_on_fixed_axes_have_the_regions_that_their_readme_tells() {
    for (name, regions, around) in [
        ("cam_tappet", 1, true),
        ("cam_plate", 1, false),
        ("escapement", 1, true),
        ("geneva", 1, true),
        ("rack_pinion", 12, false),
        ("gears_on_shafts", 2, true),
    ] {
        let pair = &json(&["compute", &model(name)])[0];
        assert_eq!(pair["class"], "fixed-axes", "{name}");
        assert_eq!(pair["free_regions"], regions, "{name}");
        let list = pair["regions"].as_array().unwrap();
        assert_eq!(list.len(), regions, "{name}");
        assert!(list.iter().all(|r| r["around_u"] == around), "{name}");
    }
}
