//! `cspace simulate`.

use crate::helpers::{cspace, fails, file, json, model, printed, unframed};

/// A block that is pushed to the end of its range.
pub(crate) const JAM: &str = r#"
[[part]]
name = "pusher"
motion = { type = "prismatic", direction = [1, 0] }
loops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]

[[part]]
name = "block"
motion = { type = "prismatic", direction = [1, 0], range = [0, 1.5] }
loops = [ [[3, -1], [5, -1], [5, 1], [3, 1]] ]

[[drive]]
part = "pusher"
rate = 1
"#;

/// Both written forms hold the same numbers, and the wheel steps by 60 degrees.
#[test]
fn samples_are_the_same_in_csv_and_json() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.csv");
    let out = path.to_str().unwrap();
    let args = [
        "simulate",
        &model("geneva"),
        "--time",
        "2",
        "--every",
        "0.5",
    ];
    let text = printed(&[&args[..], &["--rates", "-o", out]].concat());
    assert!(
        text.starts_with("done: 2 s\n") && text.contains("wheel: from 0.0000 deg to"),
        "{text}"
    );
    let csv = std::fs::read_to_string(path).unwrap();
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!(rows[0], "t,wheel.u,driver.u,wheel.du,driver.du");
    assert_eq!(rows.len(), 6);
    let answer = json(&args);
    for (row, sample) in rows[1..].iter().zip(answer["samples"].as_array().unwrap()) {
        let numbers: Vec<f64> = row.split(',').map(|x| x.parse().unwrap()).collect();
        assert_eq!(sample["t"], numbers[0]);
        assert_eq!(sample["wheel"], numbers[1]);
        assert_eq!(sample["driver"], numbers[2]);
        assert!(sample.get("rates").is_none());
    }
    let wheel = |i: usize| answer["samples"][i]["wheel"].as_f64().unwrap().to_degrees();
    assert!((wheel(4) - wheel(2) + 60.0).abs() < 1e-9);
    let events = answer["events"].as_array().unwrap();
    assert!(
        events
            .iter()
            .all(|e| e["at"][0].is_f64() && e["features"][1].is_string())
    );
}

#[test]
fn a_jam_is_an_answer() {
    let (_folder, path) = file(JAM);
    let asked = ["simulate", &path, "--time", "10"];
    cspace(&asked).assert().code(1);
    let answer = json(&asked);
    assert_eq!(answer["status"], "jammed");
    assert_eq!(answer["outcome"], "jammed");
    assert!((answer["until"].as_f64().unwrap() - 3.5).abs() < 1e-9);
    assert_eq!(answer["obstacles"].as_array().unwrap().len(), 2);
    assert!(
        answer["reason"]
            .as_str()
            .unwrap()
            .contains("the upper end of the range of block")
    );
}

#[test]
fn what_cannot_be_simulated_is_told() {
    let run = |text: &str, more: &[&str]| {
        let (folder, path) = file(text);
        (
            folder,
            cspace(&[&["simulate", &path, "--time", "1"], more].concat()),
        )
    };
    let overlap = JAM.replace("[5, 1], [3, 1]", "[5, 1], [0.5, 1]");
    let (_f, command) = run(&overlap, &[]);
    fails(command, 2, &["pusher", "block", "overlap at the start"]);
    let heavy = JAM.replace("name = \"block\"", "name = \"block\"\nmass = 1");
    let (_f, mut command) = run(&heavy, &[]);
    command.assert().success();
    let light = "\n[[part]]\nname = \"light\"\nloops = [ [[20, 0], [21, 0], [20, 1]] ]\n";
    let (_f, command) = run(&(heavy.clone() + light), &[]);
    fails(command, 2, &["light has no mass", "kinematic mode"]);
    let (_f, mut command) = run(&heavy, &["--mode", "kinematic"]);
    command.assert().success();
    let (_f, command) = run(&JAM.replace("\"block\"", "\"t\""), &[]);
    fails(command, 2, &["called t"]);
    let (_f, command) = run(JAM, &["--every", "1e-9"]);
    fails(command, 2, &["sample less often"]);
    let (_f, command) = run(JAM, &["--every", "0"]);
    fails(command, 2, &["--every"]);
    let still =
        "[[part]]\nname = \"a\"\nmotion = { type = \"fixed\" }\nloops = [ [[0,0],[1,0],[0,1]] ]\n";
    let (_f, command) = run(still, &[]);
    fails(command, 2, &["no part can move"]);
}

/// The number of threads changes nothing.
#[test]
fn threads_change_nothing() {
    let run = |threads: &str| {
        let mut answer = json(&[
            "simulate",
            &model("ratchet_mechanism"),
            "--time",
            "1",
            "--threads",
            threads,
        ]);
        answer["seconds"] = 0.into();
        answer
    };
    assert_eq!(run("1"), run("2"));
}

/// A picture is written beside the answer, the same in words whatever its format, and shows each part, pair and event.
#[test]
fn a_motion_is_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["simulate", &model("ratchet_mechanism"), "--time", "1.6"];
    let plain = printed(&args);
    for (name, begins) in [
        ("a.svg", &b"<svg"[..]),
        ("a.png", b"\x89PNG"),
        ("a.pdf", b"%PDF"),
    ] {
        let path = folder.path().join(name);
        let told = printed(&[&args[..], &["-o", path.to_str().unwrap()]].concat());
        assert_eq!(told, plain);
        assert!(std::fs::read(path).unwrap().starts_with(begins), "{name}");
    }
    let drawn = std::fs::read_to_string(folder.path().join("a.svg")).unwrap();
    for said in [
        ">driver</text>",
        ">pawl θ</text>",
        ">ratchet</text>",
        ">driver – link</text>",
        ">ratchet – pawl</text>",
        ">time, s</text>",
        ">u: driver turns, degrees</text>",
        "drops off the ratchet",
    ] {
        assert!(drawn.contains(said), "{said}");
    }
    let events = plain
        .lines()
        .filter(|l| l.contains(" s touch ") || l.contains(" s release "));
    for event in events {
        let time = event.trim_start().split(' ').next().unwrap();
        assert!(drawn.contains(&format!("{time} s: ")), "{event}");
    }
    assert!(drawn.len() < 400_000, "{}", drawn.len());
}

#[test]
fn what_is_told_has_words_and_numbers() {
    let answer = json(&["simulate", &model("ratchet_mechanism"), "--time", "2"]);
    let summary = answer["summary"].as_array().unwrap();
    let says = |words: &str| summary.iter().any(|s| s.as_str().unwrap().contains(words));
    assert!(
        says("the ratchet turns 18.000 deg per turn of the driver"),
        "{summary:?}"
    );
    let cycle = &answer["cycle"];
    assert_eq!(cycle["driver"], "driver");
    assert!((cycle["period"].as_f64().unwrap() - 1.0).abs() < 1e-12);
    let ratio = cycle["parts"]["ratchet"]["ratio"].as_f64().unwrap();
    assert!((ratio - 0.05).abs() < 1e-12);
    assert_eq!(cycle["parts"]["link"]["advance"], 0.0);
    assert!(cycle["parts"]["pawl"]["least"].as_array().unwrap().len() == 3);
    // Each contact that ends does so at a release, those that do not are open at the end.
    let contacts = answer["contacts"].as_array().unwrap();
    let events = answer["events"].as_array().unwrap();
    let releases = events.iter().filter(|e| e["kind"] == "release").count();
    assert_eq!(
        contacts.iter().filter(|c| c.get("to").is_some()).count(),
        releases
    );
    assert!(answer.get("energy").is_none());
    // What is seen once does not repeat.
    let once = json(&["simulate", &model("ratchet_mechanism"), "--time", "1"]);
    assert!(once.get("cycle").is_none());
}

#[test]
fn forces_and_pictures_are_refused_where_they_make_no_sense() {
    let (_folder, path) = file(JAM);
    let run = |more: &[&str]| cspace(&[&["simulate", &path, "--time", "1"], more].concat());
    fails(
        run(&["--forces"]),
        2,
        &["--forces", "loads, springs and weights", "[[load]]"],
    );
    fails(
        run(&["--size", "800x600"]),
        2,
        &["--size is about pictures"],
    );
    fails(run(&["-o", "run.xyz"]), 2, &["run.xyz", ".csv", ".png"]);
    fails(run(&["-o", "run.txt"]), 2, &["run.txt", ".csv", ".png"]);
    fails(run(&["-o", "run.svg", "--u=0,1"]), 2, &["--x and --y"]);
}

/// Steps of one length are of the dynamic mode, and lengths of steps are theirs.
#[test]
fn steps_are_of_motions_with_masses() {
    let heavy = JAM.replace("name = ", "mass = 1\ninertia = 1\nname = ");
    let run = |text: &str, more: &[&str]| {
        let (folder, path) = file(text);
        (
            folder,
            cspace(&[&["simulate", &path, "--time", "1"], more].concat()),
        )
    };
    let (_f, command) = run(JAM, &["--scheme", "stepping"]);
    fails(command, 2, &["--scheme stepping", "kinematic", "mass"]);
    let (_f, command) = run(&heavy, &["--scheme", "stepping", "--mode", "kinematic"]);
    fails(command, 2, &["--scheme stepping", "kinematic"]);
    let (_f, command) = run(&heavy, &["--step", "0.1"]);
    fails(command, 2, &["--step", "--scheme stepping"]);
    for step in ["0", "-1", "nan"] {
        let (_f, command) = run(&heavy, &["--scheme", "stepping", "--step", step]);
        fails(command, 2, &["--step", "positive"]);
    }
    let (_f, mut command) = run(&heavy, &["--scheme", "stepping", "--step", "0.01"]);
    command.assert().success();
}

/// A square beside the axis about which it turns.
const WHEEL: &str = "[[part]]\nname = \"wheel\"\nloops = [[[1, -1], [3, -1], [3, 1], [1, 1]]]\nmotion = { type = \"revolute\", center = [0, 0] }\n";

#[test]
fn symmetry_about_another_point_than_the_axis_shortens_no_cycle() {
    let drive = "[[drive]]\npart = \"wheel\"\nrate = 1\n";
    let (_folder, path) = file(&format!("{WHEEL}{drive}"));
    let said = printed(&["simulate", &path, "--time", "20"]);
    assert!(
        said.contains("a cycle takes 6.28319 s, a turn of the wheel"),
        "{said}"
    );
}

#[test]
fn a_torsion_spring_rests_at_its_angle() {
    let spring =
        "[[spring]]\nparts = [\"wheel\"]\ntype = \"torsion\"\nstiffness = 2\nangle = \"30deg\"\n";
    let (_folder, path) = file(&format!("{WHEEL}{spring}"));
    let said = printed(&["simulate", &path, "--time", "2"]);
    assert!(
        said.contains("wheel: from 30.0000 deg to 30.0000 deg"),
        "{said}"
    );
}

/// An arm on a hinge turns into its base: parts that a joint connects are not tested for contact, and that is said from where it matters on.
#[test]
fn joined_parts_that_go_through_each_other_are_told() {
    let model = "[[part]]\nname = \"base\"\nmotion = { type = \"fixed\" }\nloops = [[[-60, -30], [70, -30], [70, -12], [-60, -12]]]\n\
        [[part]]\nname = \"arm\"\nmotion = { type = \"revolute\", center = [0, 0] }\nloops = [[[-50, -2], [5, -2], [5, 2], [-50, 2]]]\n\
        [[joint]]\ntype = \"revolute\"\nparts = [\"base\", \"arm\"]\nat = [0, 0]\n[[drive]]\npart = \"arm\"\nrate = \"30deg\"\n";
    let (_folder, path) = file(model);
    assert!(!printed(&["simulate", &path, "--time", "0.38"]).is_empty());
    let output = cspace(&["simulate", &path, "--time", "1"])
        .output()
        .unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    // The corner (-50, -2) comes to y = -12.
    let turn = (12.0 / 50.0_f64.hypot(2.0)).asin() - (2.0_f64 / 50.0).atan();
    let time = format!("{:.3}", turn.to_degrees() / 30.0);
    assert!(
        said.contains("base") && said.contains("arm") && said.contains(&time),
        "{said} {time}"
    );
}

/// In large steps a pin is pushed into the plug by more than it moves in a step: that is no motion.
#[test]
fn steps_that_let_parts_overlap_are_told() {
    let model = format!(
        "{}/tests/models/tumbler_pin.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let asked = [
        "simulate", &model, "--time", "0.1", "--scheme", "stepping", "--step", "0.0005",
    ];
    let output = cspace(&[&asked[..], &["--json"]].concat());
    let output = { output }.assert().code(2).get_output().clone();
    let answer = unframed("simulate", serde_json::from_slice(&output.stdout).unwrap());
    assert_eq!(answer["status"], "undetermined");
    assert_eq!(answer["outcome"], "undetermined");
    let reason = answer["reason"].as_str().unwrap();
    assert!(
        reason.contains("overlap by") && reason.contains("shorter steps"),
        "{reason}"
    );
}
