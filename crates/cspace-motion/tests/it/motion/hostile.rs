//! Models that are invalid, or beyond the range of numbers: a message names the problem, at once.

use std::time::{Duration, Instant};

use cspace_model::Mechanism;
use cspace_motion::{Settings, Simulation, Status};
use cspace_oracle::effort;

/// A message comes within this, whatever else the machine does.
const SOON: Duration = Duration::from_secs(20);

/// A base that stands, a wheel, and a block that is free to move; with keys of the whole, of wheel and block, and what follows them.
fn scene(whole: &str, wheel: &str, block: &str, rest: &str) -> String {
    format!(
        r#"{whole}
[[part]]
name = "base"
motion = {{ type = "fixed" }}
loops = [ [[-1, -5], [1, -5], [1, -3], [-1, -3]] ]
[[part]]
name = "wheel"
motion = {{ type = "revolute", center = [0, 0] }}
loops = [ [[-1, -1], [1, -1], [1, 1], [-1, 1]] ]
{wheel}
[[part]]
name = "block"
loops = [ [[5, -1], [7, -1], [7, 1], [5, 1]] ]
{block}
{rest}"#
    )
}

fn read(text: &str) -> Result<Mechanism, String> {
    cspace_model::model::from_toml(text, "m.toml").map_err(|e| e.to_string())
}

/// Why a model is refused, when it is read or when it is prepared.
#[track_caller]
fn refusal(text: &str) -> String {
    match read(text) {
        Err(message) => message,
        Ok(mechanism) => match Simulation::new(&mechanism) {
            Err(error) => error.to_string(),
            Ok(_) => panic!("taken: {text}"),
        },
    }
}

#[track_caller]
fn refused(text: &str, words: &[&str]) {
    let begun = Instant::now();
    let message = refusal(text);
    assert!(begun.elapsed() < SOON, "{message}");
    for word in words {
        assert!(message.contains(word), "{word}: {message}");
    }
}

const DRIVE: &str = "[[drive]]\npart = \"wheel\"\nrate = 1\n";

#[test]
fn numbers_that_no_part_has() {
    for number in ["0", "-1", "nan", "inf", "-inf"] {
        for key in ["mass", "density"] {
            let text = scene("", "", &format!("{key} = {number}"), DRIVE);
            refused(&text, &["block", key]);
        }
        let text = scene("", "", &format!("mass = 1\ninertia = {number}"), DRIVE);
        refused(&text, &["block", "inertia"]);
    }
    refused(&scene("", "", "inertia = 1", DRIVE), &["block", "inertia"]);
    for number in ["-1", "nan", "inf"] {
        let text = scene(&format!("friction = {number}"), "", "", DRIVE);
        refused(&text, &["friction"]);
    }
    for number in ["-0.1", "1.1", "nan", "inf"] {
        let text = scene(&format!("restitution = {number}"), "", "", DRIVE);
        refused(&text, &["restitution"]);
    }
    refused(&scene("gravity = [0, inf]", "", "", DRIVE), &["gravity"]);
    for start in ["inf, 0, 0", "nan, 0, 0", "0, 0, inf", "0, 0, 1e300"] {
        let text = scene("", "", &format!("start = [{start}]"), DRIVE);
        refused(&text, &["block", "start"]);
    }
    refused(
        &scene("", "", "rate = [0, nan, 0]", DRIVE),
        &["block", "rate"],
    );
}

#[test]
fn drives_that_jump_or_contradict_each_other() {
    for (table, words) in [
        ("[0, 0], [1, 1], [1, 2]", ["table", "point 2"]),
        ("[0, 0], [1, 1], [0.5, 2]", ["table", "point 2"]),
        ("[0, 0]", ["table", "a table of"]),
        ("", ["table", "a table of"]),
        ("[0, 0], [1, nan]", ["table", "NaN"]),
        ("[0, 0], [inf, 1]", ["table", "inf"]),
        ("[0, 0], [1, 1e300]", ["table", "1e300"]),
    ] {
        let drive = format!("[[drive]]\npart = \"wheel\"\ntable = [{table}]\n");
        refused(&scene("", "", "", &drive), &words);
    }
    let of = |part: &str, rate: &str| format!("[[drive]]\npart = \"{part}\"\n{rate}\n");
    refused(
        &scene("", "", "", &of("base", "rate = 1")),
        &["base", "stands still"],
    );
    refused(
        &scene("", "", "", &of("block", "rate = 1")),
        &["block", "moves freely"],
    );
    refused(
        &scene("", "", "", &of("nobody", "rate = 1")),
        &["drive 0", "nobody"],
    );
    refused(&scene("", "", "", &of("wheel", "")), &["drive 0", "rate"]);
    refused(
        &scene("", "", "", &of("wheel", "rate = inf")),
        &["drive 0", "rate"],
    );
    let twice = format!("{DRIVE}{DRIVE}");
    refused(&scene("", "", "", &twice), &["drive 1", "drive 0"]);
    refused(&scene("", "rate = 2", "", DRIVE), &["wheel", "rate"]);
}

#[test]
fn springs_and_loads_of_nothing() {
    let spring = |parts: &str, stiffness: &str| {
        let spring = format!("[[spring]]\nparts = [{parts}]\nat = [[6, 0], [9, 0]]\n{stiffness}\n");
        scene("", "", "", &format!("{DRIVE}{spring}"))
    };
    let soft = "stiffness = 1";
    refused(
        &spring("\"block\", \"block\"", soft),
        &["spring 0", "itself"],
    );
    refused(
        &spring("\"block\", \"nobody\"", soft),
        &["spring 0", "nobody"],
    );
    refused(&spring("", soft), &["spring 0", "parts"]);
    refused(&spring("\"base\"", soft), &["spring 0", "stands still"]);
    for number in ["-1", "nan", "inf", "0"] {
        let stiffness = format!("stiffness = {number}");
        refused(&spring("\"block\"", &stiffness), &["spring 0", "stiffness"]);
    }
    let load = |text: &str| scene("", "", "", &format!("{DRIVE}[[load]]\n{text}\n"));
    refused(
        &load("part = \"nobody\"\ntorque = 1"),
        &["load 0", "nobody"],
    );
    refused(
        &load("part = \"base\"\ntorque = 1"),
        &["load 0", "stands still"],
    );
    refused(
        &load("part = \"block\"\nforce = [nan, 1]"),
        &["load 0", "force"],
    );
    refused(
        &load("part = \"block\"\ntorque = inf"),
        &["load 0", "torque"],
    );
    refused(&load("part = \"block\""), &["load 0"]);
}

/// A crank and a lever whose pins are farther apart than the rod between them is long, however they turn.
#[test]
fn loops_that_cannot_close() {
    let text = r#"
[[part]]
name = "crank"
motion = { type = "revolute", center = [0, 0] }
loops = [ [[-1, -1], [3, -1], [3, 1], [-1, 1]] ]
[[part]]
name = "rod"
loops = [ [[2, -1], [5, -1], [5, 1], [2, 1]] ]
start = [100, 0, 0]
[[part]]
name = "lever"
motion = { type = "prismatic", direction = [0, 1], range = [30, 40] }
loops = [ [[4, -1], [7, -1], [7, 1], [4, 1]] ]
start = 35
[[joint]]
type = "revolute"
parts = ["crank", "rod"]
at = [3, 0]
[[joint]]
type = "revolute"
parts = ["rod", "lever"]
at = [5, 0]
[[drive]]
part = "crank"
rate = 1
"#;
    let message = refusal(text);
    assert!(
        (message.contains("joints cannot all hold") && message.contains("rod"))
            || (message.contains("lever") && message.contains("range")),
        "{message}"
    );
}

#[test]
fn parts_that_overlap_at_the_start() {
    let text = scene("", "", "start = [-5, 0, 0]", DRIVE);
    refused(&text, &["wheel", "block", "overlap at the start"]);
    let still = scene("", "", "", DRIVE).replace("revolute\", center = [0, 0]", "fixed\"");
    refused(&still, &["wheel", "stands still"]);
}

/// A part that a load drives away is reported, soon.
#[test]
fn what_flies_away_is_told_soon() {
    let load = "[[load]]\npart = \"block\"\nforce = [1e12, 1e12]\n";
    let text = scene("", "", "", &format!("{DRIVE}{load}"));
    let simulation = Simulation::new(&read(&text).unwrap()).unwrap();
    let settings = Settings {
        time: 2.0,
        every: None,
    };
    let begun = Instant::now();
    let record = simulation.kinematic(&settings).unwrap();
    assert!(begun.elapsed() < SOON, "{:?}", begun.elapsed());
    assert_eq!(record.status, Status::Undetermined);
    let reason = record.reason.unwrap();
    assert!(reason.starts_with("nothing stops block"), "{reason}");
}

/// Valid models whose motion cannot be computed end with a reason, and soon.
#[test]
fn numbers_that_cannot_be_followed() {
    let settings = Settings {
        time: 2.0,
        every: None,
    };
    let springs = ["1e12", "1e100", "1e300"].map(|stiffness| {
        let spring = format!(
            "{DRIVE}[[spring]]\nparts = [\"block\"]\nat = [[6, 0], [9, 0]]\nlength = 1\nstiffness = {stiffness}\n"
        );
        scene("", "", "mass = 1", &spring)
    });
    let masses = ["1e-300", "1e-320", "1e300"].map(|mass| {
        let load = format!("{DRIVE}[[load]]\npart = \"block\"\nforce = [-1, 0]\n");
        scene("", "", &format!("mass = {mass}"), &load)
    });
    let rates = ["1e30", "1e300"]
        .map(|rate| scene("", "", &format!("mass = 1\nrate = [-{rate}, 0, 0]"), DRIVE));
    let loads = [
        "force = [-1e12, 1e12]",
        "force = [1e12, 0]\nat = [6, 1]",
        "torque = 1e12",
    ]
    .map(|load| {
        scene(
            "",
            "",
            "",
            &format!("{DRIVE}[[load]]\npart = \"block\"\n{load}\n"),
        )
    });
    let jump = "[[drive]]\npart = \"wheel\"\ntable = [[0, 0], [1, 0], [1.000000001, 1]]\n";
    let jumps = [scene("", "", "mass = 1", jump)];
    let gravity = [scene("gravity = [0, 1e308]", "", "mass = 1", DRIVE)];
    let all = springs
        .iter()
        .chain(&masses)
        .chain(&rates)
        .chain(&jumps)
        .chain(&gravity)
        .chain(&loads);
    for text in all.step_by(effort(12, 1)) {
        let simulation = Simulation::new(&read(text).unwrap()).unwrap();
        let begun = Instant::now();
        let record = simulation.kinematic(&settings).unwrap();
        assert!(begun.elapsed() < SOON, "{text}");
        assert!(
            record.status == Status::Done || record.reason.is_some(),
            "{text}"
        );
        let finite = |c: &[f64]| c.iter().all(|c| c.is_finite());
        assert!(
            record.samples.iter().all(|s| finite(&s.coordinates)),
            "{:?}: {text}",
            record.status
        );
    }
}
