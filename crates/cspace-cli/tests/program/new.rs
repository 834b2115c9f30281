//! Models to begin with: they are read and computed, and mean what their dimensions say.

use core::f64::consts::PI;
use cspace_oracle::{Schema, effort};

use serde_json::Value;
use tempfile::TempDir;

use crate::helpers::{classes, cspace, fails, json, printed};

const TEMPLATES: [&str; 6] = ["latch", "cam", "gears", "geneva", "ratchet", "peg"];

/// A model in a folder of its own.
struct Model {
    _folder: TempDir,
    file: String,
}

impl Model {
    #[track_caller]
    fn new(template: &str, options: &[(&str, f64)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("m.toml").to_str().unwrap().to_owned();
        let options: Vec<String> = (options.iter())
            .map(|(name, value)| format!("--{name}={value}"))
            .collect();
        let mut args = vec!["new", template, "-o", &file];
        args.extend(options.iter().map(String::as_str));
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
    fn are(&self, header: &str, class: &str, rows: &[Vec<f64>]) {
        let found = classes(&[&self.file], header, rows);
        for (row, found) in rows.iter().zip(found) {
            assert_eq!(found, class, "{row:?}");
        }
    }

    #[track_caller]
    fn planar(&self, class: &str, rows: &[[f64; 3]]) {
        self.are("x,y,theta", class, &rows.map_vec());
    }

    #[track_caller]
    fn axes(&self, class: &str, rows: &[[f64; 2]]) {
        self.are("u,v", class, &rows.map_vec());
    }
}

trait Rows {
    fn map_vec(&self) -> Vec<Vec<f64>>;
}

impl<const N: usize> Rows for [[f64; N]] {
    fn map_vec(&self) -> Vec<Vec<f64>> {
        self.iter().map(|r| r.to_vec()).collect()
    }
}

#[test]
fn the_peg_fits_with_its_clearance() {
    for [d, c, h, k] in [
        [10.0, 0.1, 20.0, 1.0],
        [6.0, 0.5, 9.0, 0.0],
        [25.0, 0.02, 60.0, 3.0],
    ] {
        let m = Model::new(
            "peg",
            &[
                ("diameter", d),
                ("clearance", c),
                ("depth", h),
                ("chamfer", k),
            ],
        );
        assert_eq!(m.result()["free_regions"], 1);
        let (in_hole, bottom) = (-0.5 * h, 0.001 * h);
        let side = |share: f64| [0.5 * c * share, in_hole, 0.0];
        m.planar("free", &[side(0.99), side(-0.99), [0.0, bottom - h, 0.0]]);
        m.planar(
            "blocked",
            &[side(1.01), side(-1.01), [0.0, -bottom - h, 0.0]],
        );
        // The chamfer's walls are half the clearance and what is left of the chamfer beside the peg.
        let caught = |share: f64| [0.5 * c + 0.5 * k * share, -0.5 * k, 0.0];
        if k > 0.0 {
            m.planar("free", &[caught(0.99)]);
            m.planar("blocked", &[caught(1.01)]);
        }
        let face = 0.5 * c + 1.01 * k + 0.01 * d;
        m.planar(
            "blocked",
            &[[face, -0.01 * d, 0.0], [-face, -0.01 * d, 0.0]],
        );
        // The widest tilt on the bottom: the peg is d cos θ + (h − k) tan θ wide at the edge, and the hole d + c.
        let too_wide = |t: f64| d * t.cos() + (h - k) * t.tan() > d + c;
        let mut tilt = (0.0, 0.1);
        for _ in 0..60 {
            let middle = 0.5 * (tilt.0 + tilt.1);
            if too_wide(middle) {
                tilt.1 = middle;
            } else {
                tilt.0 = middle;
            }
        }
        let leaning = |share: f64, x: f64| {
            let t = tilt.0 * share;
            let (right, low) = (0.5 * (d + c) - 0.5 * d * t.cos(), 0.5 * d * t.sin() - h);
            [right - x * c, low + 1e-9 * h, t]
        };
        m.planar("free", &[leaning(0.99, 0.004)]);
        let xs = [0.0, 0.001, 0.01, 0.1, 0.3];
        m.planar("blocked", &xs.map(|x| leaning(1.01, x)));
    }
}

#[test]
fn the_latch_has_its_play_and_holds_what_is_too_wide() {
    for [head, stem, mouth, play, side, regions] in [
        [10.0, 4.0, 6.0, 2.0, 1.0, 2.0],
        [10.0, 4.0, 10.2, 2.0, 1.0, 1.0],
        [30.0, 10.0, 11.0, 0.5, 3.0, 2.0],
    ] {
        let m = Model::new(
            "latch",
            &[
                ("head", head),
                ("stem", stem),
                ("mouth", mouth),
                ("play", play),
                ("side", side),
            ],
        );
        assert_eq!(m.result()["free_regions"], regions as u64);
        let up = |share: f64| [0.0, 0.5 * play * share, 0.0];
        let beside = 0.5 * (mouth - stem).min(2.0 * side + (mouth - head).max(0.0));
        let aside = |share: f64| [beside * share, 0.0, 0.0];
        m.planar(
            "free",
            &[up(0.0), up(0.999), up(-0.999), aside(0.999), aside(-0.999)],
        );
        m.planar("blocked", &[up(-1.001), aside(1.001), aside(-1.001)]);
        let held = if head > mouth { "blocked" } else { "free" };
        m.planar(held, &[up(1.001)]);
    }
}

/// The face stands on the base circle or on the nose: R and D cos u + r, D = R + lift − r from the axis.
#[test]
fn the_cam_lifts_as_it_is_told() {
    for [base, lift, nose, face] in [
        [20.0, 8.0, 6.0, 40.0],
        [15.0, 3.0, 15.0, 8.0],
        [30.0, 25.0, 2.0, 110.0],
    ] {
        let m = Model::new(
            "cam",
            &[
                ("base", base),
                ("lift", lift),
                ("nose", nose),
                ("face", face),
            ],
        );
        assert_eq!(m.result()["free_regions"], 1);
        let height = |degrees: f64| {
            let down = base + lift - nose;
            (nose - down * degrees.to_radians().cos() - base).max(0.0)
        };
        let rows = |off: f64| -> Vec<[f64; 2]> {
            (0..120)
                .map(|i| 3.0 * f64::from(i))
                .map(|u| [u.to_radians(), height(u) + off])
                .collect()
        };
        assert!((height(180.0) - lift).abs() < 1e-12);
        m.axes("free", &rows(1e-7 * base));
        m.axes("blocked", &rows(-1e-7 * base));
        m.axes("contact", &[[PI, lift], [0.0, 0.0]]);
    }
}

#[test]
fn the_gears_turn_with_their_backlash() {
    for [gear, pinion, module, angle, backlash] in [
        [20.0, 12.0, 4.0, 25.0, 0.2],
        [36.0, 24.0, 1.5, 20.0, 0.1],
        [17.0, 17.0, 2.0, 25.0, 0.3],
    ] {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("g.toml").to_str().unwrap().to_owned();
        let option = |name: &str, value: f64| format!("--{name}={value}");
        let angle = format!("--pressure-angle={angle}deg");
        printed(&[
            "new",
            "gears",
            "-o",
            &file,
            &angle,
            &option("gear", gear),
            &option("pinion", pinion),
            &option("module", module),
            &option("backlash", backlash),
        ]);
        let m = Model {
            _folder: folder,
            file,
        };
        let result = m.result();
        assert!(result["free_regions"].as_u64().unwrap() > 0);
        // Half the backlash, along the pinion's pitch circle.
        let half = 0.5 * backlash / (0.5 * module * pinion);
        // The arcs are off the involute by up to 0.003 modules a flank, four flanks.
        let off = 0.012 * module / backlash;
        let rows = |share: f64| -> Vec<[f64; 2]> {
            (0..200)
                .map(|i| 0.0371 * f64::from(i))
                .flat_map(|u| [share, -share].map(|s| [u, -u * gear / pinion + s * half]))
                .collect()
        };
        assert!(off < 0.6, "{off}");
        m.axes("free", &rows(0.98 - off));
        m.axes("blocked", &rows(1.02 + off));
    }
}

/// The pin's place tells the wheel's angle while it is in a slot; otherwise the wheel stands.
#[test]
fn the_geneva_driver_turns_free_and_holds_the_wheel() {
    for [slots, distance, pin, play] in [
        [6.0, 60.0, 8.0, 0.1],
        [4.0, 60.0, 8.0, 0.1],
        [3.0, 100.0, 10.0, 0.2],
        [8.0, 80.0, 6.0, 0.05],
        [12.0, 100.0, 5.0, 0.1],
    ] {
        let m = Model::new(
            "geneva",
            &[
                ("slots", slots),
                ("distance", distance),
                ("pin", pin),
                ("play", play),
            ],
        );
        let result = m.result();
        // Elsewhere the pin may be caught between slots; one region goes around, that of the drive.
        let regions = result["regions"].as_array().unwrap();
        let around = regions.iter().filter(|r| r["around_u"] == true);
        assert_eq!(around.count(), 1, "{slots}");
        let half_step = PI / slots;
        let crank = distance * half_step.sin();
        let wheel = |u: f64| {
            let (sin, cos) = u.sin_cos();
            let enters = 0.5 * PI + half_step;
            if u < enters {
                0.0
            } else if u > 2.0 * PI - enters {
                -2.0 * half_step
            } else {
                (crank * sin).atan2(distance + crank * cos) - half_step
            }
        };
        let path: Vec<[f64; 2]> = (0..=720)
            .map(|i| (0.5 * f64::from(i)).to_radians())
            .map(|u| [u, wheel(u)])
            .collect();
        m.axes("free", &path);
        // Half way the pin has its play in the slot; at dwell the wheel does not turn by a tenth of a step.
        let give = play / (distance - crank);
        let way = |share: f64| [PI, share * give - half_step];
        m.axes("free", &[way(0.95), way(-0.95)]);
        m.axes(
            "blocked",
            &[
                way(1.05),
                way(-1.05),
                [0.0, 0.2 * half_step],
                [0.0, -0.2 * half_step],
            ],
        );
    }
}

/// The tip of the tooth comes to the pawl's upright face, `play` away: asin(play / radius).
#[test]
fn the_ratchet_turns_one_way() {
    for [teeth, radius, height, play] in [
        [12.0, 50.0, 6.0, 0.2],
        [24.0, 50.0, 4.0, 0.5],
        [6.0, 20.0, 4.0, 0.1],
        [60.0, 100.0, 3.0, 0.05],
    ] {
        let m = Model::new(
            "ratchet",
            &[
                ("teeth", teeth),
                ("radius", radius),
                ("height", height),
                ("play", play),
            ],
        );
        let result = m.result();
        assert_eq!(result["free_regions"], 1);
        let held = (play / radius).asin();
        let turn = |share: f64| [-held * share, 0.0];
        m.axes("free", &[turn(0.0), turn(0.999)]);
        m.axes("blocked", &[turn(1.001), turn(2.0), turn(5.0)]);
        // Lifted all the way, the wheel turns.
        let text = std::fs::read_to_string(&m.file).unwrap();
        let range = text.split("range = [\"").nth(1).unwrap();
        let lifted: f64 = range.split("deg").next().unwrap().parse().unwrap();
        assert!((-45.0..0.0).contains(&lifted), "{lifted}");
        let lifted = lifted.to_radians();
        let rows: Vec<[f64; 2]> = (0..360)
            .map(|i| [(f64::from(i)).to_radians(), 0.999 * lifted])
            .collect();
        m.axes("free", &rows);
        // Counter-clockwise the tooth before lifts the pawl: it is not held, but neither does the pawl stay.
        let pitch = 2.0 * PI / teeth;
        m.axes("blocked", &[[0.9 * pitch, 0.0]]);
        m.axes("free", &[[pitch, 0.0], [5.0 * pitch, 0.0]]);
    }
}

#[test]
fn the_model_goes_to_standard_output_or_to_a_file() {
    for template in TEMPLATES {
        let text = printed(&["new", template]);
        let m = Model::new(template, &[]);
        assert_eq!(std::fs::read_to_string(&m.file).unwrap(), text);
        // It says how it was made, and that makes it again.
        let made = text
            .lines()
            .find(|l| l.starts_with("# Written by: cspace "))
            .unwrap();
        let words: Vec<&str> = made["# Written by: cspace ".len()..].split(' ').collect();
        assert_eq!(printed(&words), text);
        // What it says to ask can be asked.
        let command = text
            .lines()
            .find(|l| l.contains("| cspace classify FILE"))
            .unwrap();
        let rows = command.split('\'').nth(1).unwrap().replace("\\n", "\n");
        let answer = cspace(&["classify", &m.file])
            .write_stdin(rows)
            .assert()
            .success();
        let answer = String::from_utf8(answer.get_output().stdout.clone()).unwrap();
        assert!(answer.contains(",free"), "{answer}");
        assert!(text.lines().all(|l| l.len() <= 130), "{template}");
        // Its requirements can be measured, and what is on a shaft moves.
        cspace(&["check", &m.file]).assert().success();
        assert_eq!(
            text.contains("revolute"),
            text.contains("[[drive]]"),
            "{template}"
        );
    }
}

#[test]
fn help_lists_the_dimensions_with_their_defaults() {
    let help = printed(&["new", "--help"]);
    for template in TEMPLATES {
        assert!(help.contains(&format!("\n  {template} ")), "{help}");
    }
    let help = printed(&["new", "peg", "--help"]);
    for words in [
        "--diameter <D>",
        "[default: 10]",
        "--clearance <L>",
        "[default: 0.1]",
        "--depth <L>",
        "[default: 20]",
    ] {
        assert!(help.contains(words), "{words} is not in {help}");
    }
    let folder = tempfile::tempdir().unwrap();
    let help = printed(&["new", "--help"]);
    let examples = help
        .lines()
        .map(str::trim)
        .filter(|l| l.starts_with("cspace new "));
    let mut count = 0;
    for line in examples {
        let words: Vec<&str> = line.split(' ').skip(1).collect();
        cspace(&words).current_dir(folder.path()).assert().success();
        count += 1;
    }
    assert_eq!(count, 3);
    assert!(folder.path().join("peg.toml").is_file());
}

#[test]
fn bad_dimensions_say_what_to_do() {
    for (args, words) in [
        (
            "peg --clearance -0.1",
            &["--clearance", "more than 0"] as &[&str],
        ),
        ("peg --clearance 0", &["--clearance", "more than 0"]),
        ("peg --diameter nan", &["--diameter", "give a length"]),
        ("peg --diameter 10mm", &["--diameter", "give a length"]),
        ("peg --chamfer=-1", &["--chamfer", "or 0 for none"]),
        (
            "peg --chamfer 20",
            &[
                "the chamfer, 20, is as deep as the hole, 20",
                "help: give a --chamfer",
            ],
        ),
        ("peg --length 5", &["--length"]),
        (
            "latch --stem 6",
            &["does not go through the mouth", "help: give a --stem"],
        ),
        (
            "latch --stem 12 --mouth 14",
            &["no narrower than the head", "help: give a --stem"],
        ),
        (
            "cam --face 33",
            &["too narrow", "up to 16.971", "at least 33.942"],
        ),
        (
            "cam --nose 21",
            &[
                "larger radius, 21, than the base circle, 20",
                "help: give a --nose",
            ],
        ),
        ("cam --lift 0", &["--lift", "more than 0"]),
        (
            "gears --pinion 8",
            &["cut into the feet of 8 teeth", "help: give more teeth"],
        ),
        ("gears --pinion 5", &["--pinion", "6..=200"]),
        (
            "gears --pressure-angle 20",
            &["--pressure-angle", "10deg to 35deg"],
        ),
        (
            "gears --backlash 2",
            &["thin teeth", "a quarter of --module"],
        ),
        (
            "geneva --pin 30",
            &["a pin of diameter 30", "help: give a smaller --pin"],
        ),
        ("geneva --slots 2", &["--slots", "3..=24"]),
        (
            "geneva --slots 24",
            &["a pin of diameter 8", "fewer --slots"],
        ),
        (
            "ratchet --height 20",
            &["too high", "help: give a --height of at most 10"],
        ),
        ("ratchet --play 3", &["the play, 3", "a fifth of --height"]),
        ("ratchet --teeth 3", &["--teeth", "6..=200"]),
        ("pegg", &["pegg", "peg"]),
    ] {
        let args: Vec<&str> = ["new"].into_iter().chain(args.split(' ')).collect();
        fails(cspace(&args), 2, words);
    }
    let folder = tempfile::tempdir().unwrap();
    let out = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fails(
        cspace(&["new", "peg", "-o", &out("peg.json")]),
        2,
        &["peg.json", "ends in .toml"],
    );
    fails(
        cspace(&["new", "peg", "-o", &out("none/peg.toml")]),
        2,
        &["no directory"],
    );
    fails(
        cspace(&["new", "peg", "--depth", "1", "-o", &out("peg.toml")]),
        2,
        &["help:"],
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn the_published_schema_takes_every_model() {
    for template in TEMPLATES {
        let model: Value = toml::from_str(&printed(&["new", template])).unwrap();
        Schema::new("model").takes(&model, template);
    }
}

/// Whatever the dimensions: a model that is computed, or a message that says what to do.
#[test]
fn any_dimensions_give_a_model_or_a_reason() {
    let mut state = 1_u64;
    let mut random = |lo: f64, hi: f64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        lo * (hi / lo).powf((state >> 11) as f64 / (1_u64 << 53) as f64)
    };
    let mut made = 0;
    type Dimensions<'a> = &'a [(&'a str, f64)];
    let templates: [(&str, Dimensions<'_>, Dimensions<'_>); 6] = [
        (
            "latch",
            &[
                ("head", 10.0),
                ("rim", 1.0),
                ("stem", 4.0),
                ("mouth", 6.0),
                ("lip", 4.0),
                ("play", 2.0),
                ("side", 1.0),
            ],
            &[],
        ),
        (
            "cam",
            &[("base", 20.0), ("lift", 8.0), ("nose", 6.0), ("face", 50.0)],
            &[],
        ),
        (
            "gears",
            &[("module", 4.0), ("backlash", 0.2)],
            &[("gear", 24.0), ("pinion", 20.0)],
        ),
        (
            "geneva",
            &[("distance", 60.0), ("pin", 6.0), ("play", 0.1)],
            &[("slots", 6.0)],
        ),
        (
            "ratchet",
            &[("radius", 50.0), ("height", 5.0), ("play", 0.2)],
            &[("teeth", 14.0)],
        ),
        (
            "peg",
            &[
                ("diameter", 10.0),
                ("clearance", 0.1),
                ("depth", 20.0),
                ("chamfer", 1.0),
            ],
            &[],
        ),
    ];
    for (template, lengths, whole) in templates {
        let mut of_template = 0;
        for _ in 0..effort(6, 25) {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("m.toml").to_str().unwrap().to_owned();
            let mut args = vec![
                "new".to_owned(),
                template.to_owned(),
                "-o".to_owned(),
                file.clone(),
            ];
            args.extend(
                lengths
                    .iter()
                    .map(|(l, d)| format!("--{l}={:.4}", random(0.2 * d, 5.0 * d))),
            );
            args.extend(
                whole
                    .iter()
                    .map(|(w, d)| format!("--{w}={:.0}", random(0.4 * d, 4.0 * d))),
            );
            let words: Vec<&str> = args.iter().map(String::as_str).collect();
            let output = cspace(&words).output().unwrap();
            let said = String::from_utf8(output.stderr).unwrap();
            match output.status.code() {
                Some(0) => {
                    printed(&["compute", &file]);
                    of_template += 1;
                }
                Some(2) => {
                    assert!(
                        said.contains("help:") || said.contains("--help"),
                        "{args:?}: {said}"
                    );
                    assert!(!said.contains("do not go together"), "{args:?}: {said}");
                }
                code => panic!("{args:?}: {code:?}: {said}"),
            }
        }
        assert!(of_template >= effort(1, 4), "{template}: {of_template}");
        made += of_template;
    }
    assert!(made >= effort(12, 60), "{made}");
}
