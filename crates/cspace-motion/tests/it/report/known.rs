//! Cycles and sentences with known answers.

use core::f64::consts::TAU;

use cspace::{Part, Vertex};
use cspace_model::{Drive, DriveMotion, Mechanism, PartEntry};
use cspace_motion::{
    ContactForce, Cycle, DriveForce, DrivePeak, Forces, PartCycle, Peak, Report, Trajectory, What,
};

use crate::report::{model, run, told};

#[track_caller]
fn says(report: &Report, sentence: &str) {
    let found = report.summary.iter().any(|s| s == sentence);
    assert!(found, "{sentence}: {:#?}", report.summary);
}

fn part(cycle: &Cycle, part: usize) -> &PartCycle {
    cycle.parts.iter().find(|p| p.part == part).unwrap()
}

/// Six slots: a step is a sixth of a turn, in the opposite direction.
#[test]
fn a_geneva_wheel_goes_in_steps() {
    let report = told("geneva", 2.0);
    let cycle = report.cycle.as_ref().unwrap();
    assert_eq!(cycle.driver, Some(1));
    assert!((cycle.period - 1.0).abs() < 1e-12);
    assert!((cycle.ratio(0).unwrap() + 1.0 / 6.0).abs() < 1e-12);
    assert!((part(cycle, 0).stroke(0) - TAU / 6.0).abs() < 1e-4);
    says(
        &report,
        "the wheel turns 60.000 deg per turn of the driver, the other way",
    );
    assert!(report.drops.is_empty());
}

/// Twenty teeth: 18 degrees a turn. The link's stroke is the eccentric's throw as seen from its pivot, less the play in the
/// fork: at most 2 asin(19.5 / 100).
#[test]
fn a_ratchet_goes_on_by_a_tooth() {
    let report = told("ratchet_mechanism", 2.5);
    let cycle = report.cycle.as_ref().unwrap();
    assert!((cycle.ratio(4).unwrap() - 0.05).abs() < 1e-12);
    assert_eq!(part(cycle, 2).advance, [0.0]);
    let most = 2.0 * (0.195_f64).asin();
    let stroke = part(cycle, 2).stroke(0);
    assert!(
        stroke < most && stroke > most - 0.2_f64.to_radians(),
        "{stroke}"
    );
    says(
        &report,
        "the ratchet turns 18.000 deg per turn of the driver",
    );
    let [drop] = &report.drops[..] else {
        panic!("{:?}", report.drops);
    };
    assert_eq!((drop.part, drop.off), (3, 4));
    let swing = drop.swing.unwrap();
    assert_eq!(swing.part, 2);
    assert!((swing.spare.unwrap() - (stroke - TAU / 20.0)).abs() < 1e-12);
    assert!(swing.goes_on > 0.0 && swing.goes_on < swing.spare.unwrap());
    let spare = swing.spare.unwrap().to_degrees();
    says(
        &report,
        &format!("{spare:.3} deg of the stroke of the link are to spare"),
    );
    // The drop is between a release and a touch of the two that are told as events.
    let contacts = report.contacts.iter().filter(|c| c.moving == "pawl");
    let ends: Vec<f64> = contacts.clone().filter_map(|c| c.to).collect();
    assert!(ends.contains(&drop.leaves) && contacts.clone().any(|c| c.from == drop.lands));
}

/// Thirty teeth, one for each swing to and fro; a drop on either side.
#[test]
fn an_escape_wheel_goes_on_by_a_tooth() {
    let report = told("escapement", 3.0);
    let cycle = report.cycle.as_ref().unwrap();
    assert_eq!(cycle.driver, None);
    // The drive is a spline: periodic but for what its ends do.
    assert!((cycle.period - 1.0).abs() < 1e-6);
    assert!((part(cycle, 0).advance[0] + TAU / 30.0).abs() < 1e-12);
    assert!((part(cycle, 1).stroke(0) - 8_f64.to_radians()).abs() < 1e-4);
    says(&report, "the wheel turns 12.000 deg clockwise per cycle");
    says(
        &report,
        "the anchor swings through 8.000 deg, from -4.000 to 4.000 deg",
    );
    assert_eq!(report.drops.len(), 2);
    assert!(report.drops.iter().all(|d| d.part == 0 && d.off == 1));
}

/// A cycle is a tooth, the ratio that of the teeth, whatever the samples and their number.
#[test]
fn gears_have_the_ratio_of_their_teeth() {
    for every in [None, Some(1.0), Some(0.0317)] {
        let (simulation, record) = run(&model("gears_on_shafts"), 1.0, every);
        let report = Report::of(&simulation, &record);
        let cycle = report.cycle.as_ref().unwrap();
        assert!((cycle.period - 1.0 / 12.0).abs() < 1e-12, "{every:?}");
        assert!((cycle.ratio(1).unwrap() + 1.2).abs() < 1e-12);
        says(
            &report,
            "the pinion turns 432.000 deg per turn of the gear, the other way; the ratio is -1.2",
        );
    }
}

/// The lift is 12, the cam's dwell 30 degrees.
#[test]
fn a_tappet_slides_by_the_lift() {
    let report = told("cam_tappet", 2.0);
    let cycle = report.cycle.as_ref().unwrap();
    assert!((part(cycle, 1).stroke(0) - 12.0).abs() < 1e-9);
    says(
        &report,
        "the tappet slides to and fro by 12.000 mm, from -12.100 to -0.100 mm",
    );
    says(&report, "cam and tappet touch all the time");
}

/// A motion seen for less than a cycle and a half does not repeat, nor does one that goes on from one place to the
/// next.
#[test]
fn nothing_is_said_without_a_cycle() {
    let report = told("geneva", 1.2);
    assert_eq!(report.cycle, None);
    assert!(!report.summary.iter().any(|s| s.contains("cycle")));
    let block = |name: &str, x: f64| Part::rectangle(name, (x, 0.0), 2.0, 2.0).unwrap();
    let mut mechanism = Mechanism::new("blocks");
    (mechanism.parts).push(PartEntry::prismatic(block("a", 0.0), (1.0, 0.0)));
    (mechanism.parts).push(PartEntry::prismatic(block("b", 4.0), (1.0, 0.0)));
    mechanism.pairs = mechanism.every_two();
    let motion = DriveMotion::Rate(1.0);
    mechanism.dynamics.drives.push(Drive { part: 0, motion });
    let (simulation, record) = run(&mechanism, 5.0, None);
    let report = Report::of(&simulation, &record);
    assert_eq!(report.cycle, None);
    assert_eq!(report.summary, ["a and b touch from 2.000 s on"]);
}

/// A roller on an eccentric is pushed, once: it comes to rest at its farthest, so that nothing but the cam repeats.
#[test]
fn rest_is_a_cycle_of_what_goes_on() {
    let disc = |name: &str, x: f64| {
        let ends = vec![
            Vertex::new(x - 10.0, 0.0, 1.0),
            Vertex::new(x + 10.0, 0.0, 1.0),
        ];
        Part::new(name, vec![ends]).unwrap()
    };
    let mut mechanism = Mechanism::new("cam and roller");
    (mechanism.parts).push(PartEntry::revolute(disc("cam", 3.0), (0.0, 0.0)));
    (mechanism.parts).push(PartEntry::prismatic(disc("roller", 22.0), (1.0, 0.0)));
    mechanism.pairs = mechanism.every_two();
    mechanism.dynamics.part_mut(0).start = Some(cspace_model::PartPosition::Axis(1.5));
    let motion = DriveMotion::Rate(TAU);
    mechanism.dynamics.drives.push(Drive { part: 0, motion });
    let (simulation, record) = run(&mechanism, 3.0, None);
    let report = Report::of(&simulation, &record);
    let cycle = report.cycle.as_ref().unwrap();
    assert!((cycle.period - 1.0).abs() < 1e-12);
    assert_eq!(part(cycle, 1).advance, [0.0]);
    assert!(part(cycle, 1).stroke(0) < 1e-9);
    // It was pushed to where the discs are in line.
    let trajectory = Trajectory::of(&record);
    assert!((trajectory.at(3.0, 1) - 1.0).abs() < 1e-9);
}

/// The report gives the largest force between each two parts, of all their contacts together, and each drive's maximum
/// and mean power.
#[test]
fn forces_are_told_where_they_are_known() {
    let (simulation, mut record) = run(&model("gears_on_shafts"), 1.0, Some(0.25));
    for (k, sample) in record.samples.iter_mut().enumerate() {
        let k = k as f64;
        let what = What::Contact {
            fixed: "gear".into(),
            moving: "pinion".into(),
            features: ["a".into(), "b".into()],
        };
        sample.forces = Some(Forces {
            contacts: vec![
                ContactForce {
                    what,
                    at: None,
                    normal: 10.0 * k * (4.0 - k),
                    tangential: 1.0,
                };
                2
            ],
            joints: Vec::new(),
            drives: vec![DriveForce {
                part: "gear".into(),
                force: k * (k - 4.0),
                power: 2.0 * k,
            }],
        });
    }
    record.energy = Some(cspace_motion::Energy {
        start: 0.0,
        end: 5.0,
        drives: 5.0,
        friction: 0.0,
        impacts: 0.0,
        drift: 0.0,
    });
    let report = Report::of(&simulation, &record);
    let drive = DrivePeak {
        part: "gear".into(),
        force: Peak {
            value: -4.0,
            t: 0.5,
        },
        power: Peak { value: 8.0, t: 1.0 },
    };
    assert_eq!(report.peaks.as_ref().unwrap().drives, [drive]);
    says(
        &report,
        "gear and pinion press on each other with at most 80.000 mN at the samples, at 180.0 deg of the gear",
    );
    // Impacts are in the energy alone.
    says(
        &report,
        "the drive of the gear gives at most 4.0000 mN·mm, at 180.0 deg of the gear, and 8.0000 µW, at 0.0 deg, at the samples",
    );
    says(
        &report,
        "the drive gives 5.0000 µW on average, impacts included",
    );
}
