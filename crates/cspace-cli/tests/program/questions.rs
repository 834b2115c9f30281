//! `play --at` and `play --at --by`, against arithmetic done by hand and against `classify`.

use serde_json::Value;

use crate::helpers::{cspace, fails, json, mechanism, model, printed, unframed};

/// A square ring, 6 wide outside and 4 inside, and a block of 2.
fn ring() -> tempfile::NamedTempFile {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    let text = "unit = \"mm\"\n[[part]]\nname = \"ring\"\n\
        loops = [[[-3, -3], [3, -3], [3, 3], [-3, 3]], [[-2, -2], [2, -2], [2, 2], [-2, 2]]]\n\
        [[part]]\nname = \"block\"\nloops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]\n";
    std::fs::write(file.path(), text).unwrap();
    file
}

/// Answer of `play` for the one pair.
#[track_caller]
fn play(args: &[&str]) -> Value {
    let mut pairs = json(&[&["play"], args].concat());
    assert_eq!(pairs.as_array().unwrap().len(), 1, "{pairs}");
    pairs[0].take()
}

/// How far a displacement leads.
#[track_caller]
fn moved(args: &[&str]) -> Value {
    play(args)["motion"].take()
}

fn number(value: &Value, path: &str) -> f64 {
    value.pointer(path).and_then(Value::as_f64).expect(path)
}

#[test]
fn a_block_moves_to_the_wall() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    // From x = 0.25 there is 0.75 to go of 3.
    let played = play(&[path, "--at", "0.25,0.1,0", "--by", "3,0,0"]);
    assert_eq!(played["outcome"], "free");
    let answer = &played["motion"];
    assert_eq!(answer["result"], "contact");
    assert!((number(answer, "/fraction") - 0.25).abs() < 1e-9);
    assert!((number(answer, "/at/x") - 1.0).abs() < 1e-9);
    // Its right side, line 1, lies on the ring's inner right side, and both of its right corners touch it.
    let touching = answer["touching"].as_array().unwrap();
    assert!(
        touching.iter().all(|t| t[0] == "line 1 of loop 1"),
        "{touching:?}"
    );
    let moving: Vec<&str> = touching.iter().map(|t| t[1].as_str().unwrap()).collect();
    assert!(
        moving.contains(&"vertex 1 of loop 0") && moving.contains(&"vertex 2 of loop 0"),
        "{moving:?}"
    );
    let free = moved(&[path, "--at", "0,0,0", "--by", "0.5,0,90deg"]);
    assert!((free["result"] == "free") && number(&free, "/fraction") == 1.0);
    assert!((number(&free, "/at/theta") - core::f64::consts::FRAC_PI_2).abs() < 1e-15);
    let overlapping = ["play", path, "--at", "1.5,0,0", "--by", "1,0,0"];
    cspace(&overlapping).assert().code(1);
    let overlapping = play(&overlapping[1..]);
    assert_eq!(overlapping["outcome"], "blocked");
    let blocked = &overlapping["motion"];
    assert_eq!(
        (&blocked["result"], number(blocked, "/fraction")),
        (&Value::from("blocked"), 0.0)
    );
    // The window ends at 0.3 rad: half way.
    let leaves = moved(&[
        path,
        "--at",
        "0,0,0.1",
        "--by",
        "0,0,0.4",
        "--window=-0.2,0.3",
    ]);
    assert_eq!(leaves["result"], "leaves");
    assert!((number(&leaves, "/fraction") - 0.5).abs() < 1e-9);
    let text = printed(&["play", path, "--at", "0.25,0.1,0", "--by", "3,0,0"]);
    let (_, displaced) = text.split_once("  displaced  ").unwrap();
    assert!(
        displaced
            .trim_start()
            .starts_with("contact after 25.000000 % of the way\n"),
        "{text}"
    );
    assert!(
        displaced.contains("at x 1.000000, y 0.100000 mm, theta 0.0000 deg\n"),
        "{text}"
    );
    assert!(displaced.contains("line 1 of loop 1 of ring "), "{text}");
}

/// On both sides of every contact that is told, `classify` says free and blocked.
#[test]
fn contacts_are_where_classify_changes() {
    for (name, from, by) in [
        ("ratchet_pawl", "150,20,0.3", "-200,-15,0.2"),
        ("knee", "500,50,0.1", "-600,-20,0.4"),
        ("snap_fastener", "0,80,0.05", "1,-120,-0.1"),
        ("geneva", "0,0", "0.2,200deg"),
        ("cam_tappet", "0,5", "2,-30"),
    ] {
        let file = model(name);
        let answer = moved(&[&file, "--at", from, "--by", by]);
        let at = answer["fraction"].as_f64().unwrap();
        assert_eq!(answer["result"], "contact", "{name}: {answer}");
        assert!(!answer["touching"].as_array().unwrap().is_empty());
        let parse = |text: &str| -> Vec<f64> {
            let number = |t: &str| match t.strip_suffix("deg") {
                Some(t) => t.parse::<f64>().unwrap().to_radians(),
                None => t.parse().unwrap(),
            };
            text.split(',').map(number).collect()
        };
        let (c, d) = (parse(from), parse(by));
        let row = |t: f64| {
            let numbers: Vec<String> = (c.iter().zip(&d))
                .map(|(c, d)| (c + t * d).to_string())
                .collect();
            numbers.join(",")
        };
        let names = if c.len() == 3 { "x,y,theta" } else { "u,v" };
        let rows: Vec<String> = (0..=20)
            .map(|i| row(at * f64::from(i) / 20.0 * (1.0 - 1e-7)))
            .chain([row(at + 1e-7)])
            .collect();
        let input = format!("{names}\n{}\n", rows.join("\n"));
        let output = cspace(&["classify", &file])
            .write_stdin(input)
            .output()
            .unwrap();
        let told = String::from_utf8(output.stdout).unwrap();
        let classes: Vec<&str> = told
            .lines()
            .skip(1)
            .map(|l| l.rsplit(',').next().unwrap())
            .collect();
        let (last, before) = classes.split_last().unwrap();
        assert!(before.iter().all(|c| *c == "free"), "{name}: {told}");
        assert_eq!(*last, "blocked", "{name}: {told}");
    }
}

#[test]
fn contacts_have_distances_points_and_normals() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    // The block 0.2 from the inner right side, 0.9 from the upper and 1.1 from the lower.
    let answer = play(&[path, "--at", "0.8,0.1,0", "--touch", "0.5"]);
    assert_eq!(
        (&answer["outcome"], &answer["region"]),
        (&Value::from("free"), &Value::from(1))
    );
    assert!((number(&answer, "/clearance") - 0.2).abs() < 1e-12);
    let contacts = answer["near"].as_array().unwrap();
    assert!(!contacts.is_empty());
    for c in contacts {
        assert_eq!(c["features"][0], "line 1 of loop 1");
        assert!((number(c, "/distance") - 0.2).abs() < 1e-9);
        assert!((number(c, "/at/0") - 2.0).abs() < 1e-9);
        assert!((number(c, "/on_moving/0") - 1.8).abs() < 1e-9);
        assert!((number(c, "/normal/0") + 1.0).abs() < 1e-9 && number(c, "/normal/1").abs() < 1e-9);
    }
    let near = |args: &[&str]| -> Vec<String> {
        let text = printed(&[&["play", path], args].concat());
        let lines = text.lines().filter(|l| l.starts_with("  near  "));
        lines.map(str::to_owned).collect()
    };
    let told = near(&["--at", "0.8,0.1,0", "--touch", "0.5"]);
    assert_eq!(told.len(), contacts.len());
    for (line, c) in told.iter().zip(contacts) {
        let at = format!(
            "0.200000 mm apart at (2.000000, {:.6}): ",
            number(c, "/at/1")
        );
        assert!(line.contains(&at), "{line}");
        let moving = c["features"][1].as_str().unwrap();
        for feature in [
            "line 1 of loop 1 of ring (",
            &format!("{moving} of block ("),
        ] {
            assert!(line.contains(feature), "{line}");
        }
    }
    assert!(near(&["--at", "0,0,0"]).is_empty());
    let none = play(&[path, "--at", "0,0,0"]);
    assert_eq!(none["near"], serde_json::json!([]));
}

/// Two triangles, one with a flat arc, whose nearest points are a vertex and a point of a side: 21.1341991 apart by dense points of
/// both outlines. The circle of the arc and the lines of other sides come nearer beyond their ends, and are not listed.
#[test]
fn contacts_are_between_ends_of_features() {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    let text = "[[part]]\nname = \"fixed\"\n\
        loops = [[[-44.366, 20.14, -0.037522192156308816], [-51.606, 11.029], [-30, 5]]]\n\
        [[part]]\nname = \"moving\"\n\
        loops = [[[-68.783742, -2.494091], [-60.061866, -9.05758], [-75, -15]]]\n";
    std::fs::write(file.path(), text).unwrap();
    let path = file.path().to_str().unwrap();
    let answer = play(&[path, "--at", "0,0,0", "--touch", "60"]);
    let contacts = answer["near"].as_array().unwrap();
    assert_eq!(contacts.len(), 1, "{contacts:?}");
    let contact = &contacts[0];
    let features = serde_json::json!(["vertex 1 of loop 0", "line 0 of loop 0"]);
    assert_eq!(contact["features"], features);
    let distance = number(contact, "/distance");
    assert!((distance - 21.134_199_1).abs() < 1e-6, "{distance}");
    assert!((distance - number(&answer, "/clearance")).abs() < 1e-12);
    // Seen from the vertex, the foot on the side from (-68.8, -2.5) to (-60.1, -9.1) is this share of the way.
    let (vertex, side) = ([-51.606, 11.029], [8.721_876, -6.563_489]);
    let from_start: [f64; 2] = [vertex[0] + 68.783_742, vertex[1] + 2.494_091];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let share = dot(from_start, side) / dot(side, side);
    assert!((0.0..=1.0).contains(&share));
    let foot = [-68.783_742 + share * side[0], -2.494_091 + share * side[1]];
    for i in 0..2 {
        assert!((number(contact, &format!("/at/{i}")) - vertex[i]).abs() < 1e-12);
        assert!((number(contact, &format!("/on_moving/{i}")) - foot[i]).abs() < 1e-9);
    }
}

#[test]
fn what_cannot_be_asked_is_refused() {
    for (args, words) in [
        (
            vec!["play", "--at", "0,0", "--by", "0,0,1"],
            "takes 3 numbers",
        ),
        (
            vec!["play", "--at", "0,0,0", "--by", "0,1"],
            "takes 3 numbers",
        ),
        (vec!["play", "--at", "0,0,x", "--by", "0,0,1"], "theta"),
        (vec!["play", "--at", "0,0,0", "--by", "0,0,x"], "theta"),
        (vec!["play", "--at", "1,inf,0"], "inf"),
        (vec!["play", "--at", "0,0,3", "--window=-1,1"], "outside"),
    ] {
        let file = model("peg_hole");
        let args = [&args[..], &[&file]].concat();
        let output = cspace(&args).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains(words) && error.contains("help:"), "{error}");
    }
    let file = model("peg_hole");
    fails(
        cspace(&["play", &file, "--touch=-1"]),
        2,
        &["--touch", "0 or more"],
    );
}

/// A displacement of parts that a joint connects is not answered, and that is said.
#[test]
fn joined_parts_are_not_displaced() {
    let mechanism = mechanism();
    let asked = ["play", &mechanism, "--pair", "frame,link"];
    let displaced = [&asked[..], &["--at", "0,0,0", "--by", "1,0,0"]].concat();
    fails(cspace(&displaced), 2, &["frame,link"]);
}

/// The columns that a row is answered with.
fn columns(path: &str, options: &[&str], rows: &str) -> Vec<Vec<String>> {
    let mut command = cspace(&[&["classify", path], options].concat());
    let output = command
        .write_stdin(rows.to_owned())
        .assert()
        .success()
        .get_output()
        .clone();
    let text = String::from_utf8(output.stdout).unwrap();
    (text.lines())
        .map(|l| l.split(',').map(str::to_owned).collect())
        .collect()
}

#[test]
fn columns_say_region_distance_and_what_touches() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    let asked = ["--columns", "region,class,touching,distance"];
    // In the middle; at the right wall, where two corners touch; over the ring; outside, 1 beside it; empty lines are none.
    let rows = "x,y,theta\n0.25,0.1,0\n\n1,0.5,0\n  \t\n2.5,0,0\n5,0,0\n";
    let found = columns(path, &asked, rows);
    assert_eq!(
        found[0],
        ["x", "y", "theta", "region", "class", "touching", "distance"]
    );
    assert_eq!(found.len(), 5);
    let distance = |row: usize| found[row][6].parse::<f64>().unwrap();
    let (inside, outside) = (&found[1][3], &found[4][3]);
    assert!(inside != outside && !inside.is_empty() && !outside.is_empty());
    assert_eq!((&*found[1][4], &*found[1][5]), ("free", ""));
    assert!((distance(1) - 0.75).abs() < 1e-9);
    assert_eq!(
        (&*found[2][3], &*found[2][4], &*found[2][6]),
        ("", "contact", "0")
    );
    let mut touching: Vec<&str> = found[2][5].split(';').collect();
    touching.sort_unstable();
    assert_eq!(
        touching,
        [
            "line 1 of loop 1|vertex 1 of loop 0",
            "line 1 of loop 1|vertex 2 of loop 0"
        ]
    );
    assert_eq!(found[3][3..], ["", "blocked", "", ""]);
    assert!((distance(4) - 1.0).abs() < 1e-9);
    // What is near counts as touching on request, and JSON has the same.
    let rows = "x,y,theta\n0.95,0,0\n";
    let near = columns(path, &["--columns", "touching", "--touch", "0.06"], rows);
    assert_eq!(near[1][3].matches('|').count(), 2, "{near:?}");
    let mut command = cspace(&[
        "classify",
        path,
        "--columns",
        "distance,touching,region",
        "--touch=0.06",
        "--format=json",
    ]);
    let output = command
        .write_stdin(rows)
        .assert()
        .success()
        .get_output()
        .clone();
    let answer = unframed("classify", serde_json::from_slice(&output.stdout).unwrap());
    assert!((number(&answer, "/0/distance") - 0.05).abs() < 1e-9);
    assert_eq!(answer[0]["touching"].as_array().unwrap().len(), 2);
    assert_eq!(answer[0]["region"].to_string(), *inside);
}

/// Distances are where a displacement leads, whatever the class.
#[test]
fn distances_on_fixed_axes_are_those_of_the_moving_part() {
    let file = tempfile::Builder::new().suffix(".toml").tempfile().unwrap();
    let text = "[[part]]\nname = \"wall\"\nloops = [[[-1, -1], [1, -1], [1, 1], [-1, 1]]]\n\
        motion = { type = \"fixed\" }\n\
        [[part]]\nname = \"slider\"\nloops = [[[4, -1], [6, -1], [6, 1], [4, 1]]]\n\
        motion = { type = \"prismatic\", direction = [-1, 0] }\n";
    std::fs::write(file.path(), text).unwrap();
    let path = file.path().to_str().unwrap();
    let asked = ["--columns", "class,distance,region"];
    let found = columns(path, &asked, "u,v\n0,1\n0,3\n0,4\n0,10\n");
    // It meets the wall after 3; at 4 it is in it; at 10 it is 3 beyond it.
    assert!((found[1][3].parse::<f64>().unwrap() - 2.0).abs() < 1e-9);
    assert_eq!(found[2][2..4], ["contact", "0"]);
    assert_eq!(found[3][2..], ["blocked", "", ""]);
    assert!((found[4][3].parse::<f64>().unwrap() - 3.0).abs() < 1e-9);
    assert_ne!(found[1][4], found[4][4]);
}

#[test]
fn columns_are_checked() {
    let file = ring();
    let path = file.path().to_str().unwrap();
    for (options, said) in [
        (
            &["--columns", "class,weight"][..],
            "possible values: class, region, distance, touching",
        ),
        (&["--columns", "class,class"], "asked for twice"),
        (&["--touch", "0.1"], "--columns class,touching"),
    ] {
        let args = [&["classify", path], options].concat();
        fails(cspace(&args), 2, &[said]);
    }
    let mut taken = cspace(&["classify", path, "--columns", "region"]);
    taken.write_stdin("x,y,theta,region\n0,0,0,5\n");
    fails(taken, 2, &["a column `region`"]);
    let mechanism = mechanism();
    let mut joined = cspace(&[
        "classify",
        &mechanism,
        "--pair",
        "link,pawl",
        "--columns",
        "distance",
    ]);
    joined.write_stdin("x,y,theta\n0,0,0\n");
    fails(joined, 2, &["--columns", "joint"]);
}

/// A feature is called by its name wherever it is told of, also of a space that was saved.
#[test]
fn features_have_their_names() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let text = std::fs::read_to_string(ring().path()).unwrap();
    let names =
        "names = { \"line 1 of loop 1\" = \"right wall\", \"vertex 1 of loop 1\" = \"niche\" }\n";
    let named = text.replacen("loops =", &format!("{names}loops ="), 1);
    let (model, saved) = (place("m.toml"), place("s.json"));
    std::fs::write(&model, &named).unwrap();
    printed(&["export", &model, "-o", &saved]);
    for file in [&model, &saved] {
        let at = ["--at", "1,0,0"];
        let played = printed(&[&["play", file][..], &at].concat());
        assert!(
            played.contains("touches") && played.contains("right wall of ring (right wall of ")
        );
        let near = (played.lines()).find(|l| l.starts_with("  near  "));
        assert!(near.unwrap().contains("right wall of ring"), "{played}");
        assert_eq!(
            play(&[file, "--at", "1,0,0"])["near"][0]["features"][0],
            "right wall"
        );
        assert!(
            printed(&[&["draw", file][..], &at].concat()).contains(">right wall of ring touches")
        );
        let moved = moved(&[file, "--at", "0,0,0", "--by", "3,0,0"]);
        assert_eq!(moved["touching"][0][0], "right wall");
        assert!(printed(&["slice", file, "--theta", "0.1"]).contains("on right wall of ring"));
        let found = columns(file, &["--columns", "touching"], "x,y,theta\n1,0.1,0\n");
        assert!(found[1][3].starts_with("right wall|"), "{found:?}");
    }
    let wrong = [
        ("\"line 9 of loop 1\" = \"x\"", "there is no"),
        ("\"convex arc 1 of loop 1\" = \"x\"", "is a line"),
        ("\"wall\" = \"x\"", "is no feature"),
        (
            "\"line 1 of loop 1\" = \"x\", \"line 2 of loop 1\" = \"x\"",
            "given twice",
        ),
    ];
    for (names, said) in wrong {
        let file = place("w.toml");
        std::fs::write(
            &file,
            text.replacen("loops =", &format!("names = {{ {names} }}\nloops ="), 1),
        )
        .unwrap();
        fails(cspace(&["info", &file]), 2, &[said, "part 0 \"ring\""]);
    }
}
