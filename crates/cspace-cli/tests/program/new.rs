//! Models to begin with: they are read and computed, and mean what their dimensions say.

use core::f64::consts::PI;

use cspace_oracle::Schema;
use serde_json::Value;
use tempfile::TempDir;

use crate::helpers::{classes, cspace, fails, json, printed};

const KINDS: [&str; 6] = ["latch", "cam", "gears", "geneva", "ratchet", "peg"];

/// A model in a folder of its own.
struct Model {
    _folder: TempDir,
    file: String,
}

impl Model {
    /// `set` is what stands behind each `--set`.
    #[track_caller]
    fn new(kind: &str, set: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("m.toml").to_str().unwrap().to_owned();
        let mut args = vec!["new", kind, "-o", &file];
        args.extend(set.split_whitespace().flat_map(|s| ["--set", s]));
        assert_eq!(printed(&args), "");
        Self {
            _folder: folder,
            file,
        }
    }

    fn result(&self) -> Value {
        json(&["compute", &self.file])[0].clone()
    }

    #[track_caller]
    fn are<const N: usize>(&self, class: &str, rows: &[[f64; N]]) {
        let header = if N == 3 { "x,y,theta" } else { "u,v" };
        let rows: Vec<Vec<f64>> = rows.iter().map(|r| r.to_vec()).collect();
        for (row, found) in rows.iter().zip(classes(&[&self.file], header, &rows)) {
            assert_eq!(found, class, "{row:?}");
        }
    }
}

#[test]
fn the_peg_fits_with_its_clearance() {
    for (set, [d, c, h, k]) in [
        ("", [10.0, 0.1, 20.0, 1.0]),
        (
            "diameter=25 clearance=0.02 depth=60 chamfer=3",
            [25.0, 0.02, 60.0, 3.0],
        ),
    ] {
        let m = Model::new("peg", set);
        assert_eq!(m.result()["free_regions"], 1);
        let side = |share: f64| [0.5 * c * share, -0.5 * h, 0.0];
        // Half way down the chamfer.
        let caught = |share: f64| [0.5 * c + 0.5 * k * share, -0.5 * k, 0.0];
        let down = |share: f64| [0.0, -h * share, 0.0];
        m.are(
            "free",
            &[side(0.99), side(-0.99), caught(0.99), down(0.999)],
        );
        m.are("blocked", &[side(1.01), caught(1.01), down(1.001)]);
        m.are(
            "blocked",
            &[[0.5 * c + 1.01 * k + 0.01 * d, -0.01 * d, 0.0]],
        );
    }
}

#[test]
fn the_latch_has_its_play_and_holds_what_is_too_wide() {
    for (set, aside, play, regions) in [
        ("", 1.0, 2.0, 2),
        ("mouth=10.2", 1.1, 2.0, 1),
        ("head=30 stem=10 mouth=11 play=0.5 side=3", 0.5, 0.5, 2),
    ] {
        let m = Model::new("latch", set);
        assert_eq!(m.result()["free_regions"], regions);
        let up = |share: f64| [0.0, 0.5 * play * share, 0.0];
        let beside = |share: f64| [aside * share, 0.0, 0.0];
        m.are("free", &[up(0.999), up(-0.999), beside(0.999)]);
        m.are("blocked", &[up(-1.001), beside(1.001)]);
        m.are(if regions == 2 { "blocked" } else { "free" }, &[up(1.001)]);
    }
}

/// The face stands on the base circle, R, or on the nose, r − D cos u with D = R + lift − r.
#[test]
fn the_cam_lifts_as_it_is_told() {
    for (set, [base, lift, nose]) in [
        ("", [20.0, 8.0, 6.0]),
        ("base=30 lift=25 nose=2 face=110", [30.0, 25.0, 2.0]),
    ] {
        let m = Model::new("cam", set);
        assert_eq!(m.result()["free_regions"], 1);
        let height = |u: f64| (nose - (base + lift - nose) * u.cos() - base).max(0.0);
        let rows = |off: f64| -> Vec<[f64; 2]> {
            let us = (0..120).map(|i| (3.0 * f64::from(i)).to_radians());
            us.map(|u| [u, height(u) + off]).collect()
        };
        m.are("free", &rows(1e-7 * base));
        m.are("blocked", &rows(-1e-7 * base));
        m.are("contact", &[[PI, lift], [0.0, 0.0]]);
    }
}

#[test]
fn the_gears_turn_with_their_backlash() {
    for (set, [gear, pinion, module, backlash]) in [
        ("", [20.0, 12.0, 4.0, 0.2]),
        (
            "gear=36 pinion=24 module=1.5 pressure=20deg backlash=0.1",
            [36.0, 24.0, 1.5, 0.1],
        ),
    ] {
        let m = Model::new("gears", set);
        let half = 0.5 * backlash / (0.5 * module * pinion);
        // The arcs are off the involute by up to 0.003 modules a flank, four flanks.
        let off = 0.012 * module / backlash;
        let rows = |share: f64| -> Vec<[f64; 2]> {
            (0..200)
                .map(|i| 0.0371 * f64::from(i))
                .flat_map(|u| [share, -share].map(|s| [u, -u * gear / pinion + s * half]))
                .collect()
        };
        m.are("free", &rows(0.98 - off));
        m.are("blocked", &rows(1.02 + off));
    }
}

/// The pin's place tells the wheel's angle while it is in a slot; otherwise the wheel stands.
#[test]
fn the_geneva_driver_turns_free_and_holds_the_wheel() {
    for (set, [slots, distance, play]) in [
        ("", [6.0, 60.0, 0.1]),
        ("slots=3 distance=100 pin=10 play=0.2", [3.0, 100.0, 0.2]),
        ("slots=12 distance=100 pin=5", [12.0, 100.0, 0.1]),
    ] {
        let m = Model::new("geneva", set);
        let half_step = PI / slots;
        let crank = distance * half_step.sin();
        let wheel = |u: f64| {
            let enters = 0.5 * PI + half_step;
            match u {
                u if u < enters => 0.0,
                u if u > 2.0 * PI - enters => -2.0 * half_step,
                u => (crank * u.sin()).atan2(distance + crank * u.cos()) - half_step,
            }
        };
        let us = (0..=720).map(|i| (0.5 * f64::from(i)).to_radians());
        m.are("free", &us.map(|u| [u, wheel(u)]).collect::<Vec<_>>());
        // Half way the pin has its play in the slot; at dwell the wheel does not turn by a tenth of a step.
        let way = |share: f64| [PI, share * play / (distance - crank) - half_step];
        m.are("free", &[way(0.95), way(-0.95)]);
        m.are("blocked", &[way(1.05), way(-1.05), [0.0, 0.2 * half_step]]);
    }
}

/// The tip of the tooth comes to the pawl's upright face, `play` away: asin(play / radius).
#[test]
fn the_ratchet_turns_one_way() {
    for (set, [teeth, radius, play]) in [
        ("", [12.0_f64, 50.0, 0.2]),
        ("teeth=6 radius=20 height=4 play=0.1", [6.0, 20.0, 0.1]),
        (
            "teeth=60 radius=100 height=3 play=0.05",
            [60.0, 100.0, 0.05],
        ),
    ] {
        let m = Model::new("ratchet", set);
        assert_eq!(m.result()["free_regions"], 1);
        let turn = |share: f64| [-(play / radius).asin() * share, 0.0];
        m.are("free", &[turn(0.0), turn(0.999)]);
        m.are("blocked", &[turn(1.001), turn(2.0), turn(5.0)]);
        // Lifted all the way, the wheel turns.
        let parts = &json(&["info", &m.file])["parts"];
        let lifted = 0.999 * parts[1]["motion"]["range"][0].as_f64().unwrap();
        assert!((-0.8..0.0).contains(&lifted), "{lifted}");
        let us = (0..360).map(|i| f64::from(i).to_radians());
        m.are("free", &us.map(|u| [u, lifted]).collect::<Vec<_>>());
        // Counter-clockwise the tooth before lifts the pawl: it is not held, but neither does the pawl stay.
        let pitch = 2.0 * PI / teeth;
        m.are("blocked", &[[0.9 * pitch, 0.0]]);
        m.are("free", &[[pitch, 0.0], [5.0 * pitch, 0.0]]);
    }
}

#[test]
fn each_model_has_notes_and_requirements() {
    for kind in KINDS {
        let text = printed(&["new", kind]);
        let m = Model::new(kind, "");
        assert_eq!(std::fs::read_to_string(&m.file).unwrap(), text);
        assert!(text.lines().all(|l| l.len() <= 130), "{kind}");
        cspace(&["check", &m.file]).assert().success();
        Schema::new("model").takes(&toml::from_str(&text).unwrap(), kind);
        // All dimensions down to the first empty line have notes, which help shows.
        let help = printed(&["new", "--help"]);
        assert!(help.contains(&format!("- {kind}:")), "{help}");
        let (_, dimensions) = text.split_once("[parameter]\n").unwrap();
        for line in dimensions.lines().take_while(|l| !l.is_empty()) {
            let (name, rest) = line.split_once(" = ").unwrap();
            let (value, note) = rest.split_once(" # ").unwrap();
            let row = format!("    {name:<9}  {:<5}  {note}\n", value.trim_matches('"'));
            assert!(help.contains(&row), "{row} is not in {help}");
        }
    }
}

#[test]
fn set_values_are_written_and_comments_kept() {
    let text = printed(&["new", "peg"]);
    let set = ["--set", "clearance=0.05", "--set", "depth=2*diameter"];
    let other = printed(&[&["new", "peg"], &set[..]].concat());
    let changed = (text.replace("clearance = 0.1 #", "clearance = 0.05 #"))
        .replace("depth = 20 #", "depth = \"2*diameter\" #");
    assert_eq!(other, changed);
    assert_ne!(other, text);
}

#[test]
fn the_examples_of_help_run() {
    let folder = tempfile::tempdir().unwrap();
    let help = printed(&["new", "--help"]);
    let examples = help.lines().filter_map(|l| l.strip_prefix("  cspace "));
    for line in examples.clone() {
        let words: Vec<&str> = line.split(' ').collect();
        cspace(&words).current_dir(folder.path()).assert().success();
    }
    assert_eq!(examples.count(), 3);
    assert!(folder.path().join("peg.toml").is_file());
}

/// Arguments, and words of the message.
const REFUSED: &str = "\
peg --set clearance=-0.1 | peg with clearance = -0.1 | must be above 0 | default: clearance = 0.1
latch --set lip=2 --set play=0 | play must be above 0 | default: lip = 4, play = 2
peg --set chamfer=30 | part 0 | default: chamfer = 1
peg --set diameter=10mm | 10mm | default: diameter = 10
peg --set length=5 | no parameter \"length\" | diameter, clearance, depth, chamfer
peg --set depth | NAME=VALUE
cam --set nose=25 | square root | default: nose = 6
gears --set pinion=5.5 | whole number | default: pinion = 12
gears --set pressure=40deg | default: pressure = 25deg
geneva --set pin=30 | default: pin = 8
ratchet --set height=60 | default: height = 6
pegg | a similar value exists: 'peg'";

#[test]
fn bad_values_say_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |args: &str, out: &str, words: &[&str]| {
        let mut command = cspace(&["new"]);
        command.args(args.split(' '));
        command.arg("-o").arg(folder.path().join(out));
        fails(command, 2, words);
    };
    for line in REFUSED.lines() {
        let words: Vec<&str> = line.split(" | ").collect();
        refused(words[0], "m.toml", &words[1..]);
    }
    refused("peg", "peg.json", &["peg.json", "ends in .toml"]);
    refused("peg", "none/peg.toml", &["no directory"]);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}
