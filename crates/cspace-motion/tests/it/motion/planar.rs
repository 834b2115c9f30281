//! Parts that move in the plane, and joints.

use std::f64::consts::TAU;

use cspace::pair::Joint;
use cspace::{Part, Point, Vector, Vertex};
use cspace_model::{JointEntry, Load, LoadKind, Mass, Mechanism, PartEntry, PartPosition};
use cspace_motion::{EventKind, Settings, SimulateError, Simulation, Status};

use crate::motion::helpers::{
    at, driven, judge, keyed, mechanism, near, polygon, run, thrown_model,
};

/// A rod is pushed beside its middle: v = u ρ²/(ρ² + b²) and ω = u b/(ρ² + b²), ρ its radius of gyration.
#[test]
fn a_rod_turns_away_from_what_pushes_it() {
    let (long, wide, off) = (10.0, 1.0, 3.0);
    let rod = Part::rectangle("rod", (0.0, 2.0), long, wide).unwrap();
    let finger = Part::circle("finger", (off, 0.5), 0.5).unwrap();
    let parts = vec![
        PartEntry::prismatic(finger, (0.0, 1.0)),
        PartEntry::planar(rod),
    ];
    let (_, record) = run(&driven(mechanism(parts), 0, 1.0), 2.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    assert!((record.events[0].t - 0.5).abs() < 1e-10);
    let square = (long * long + wide * wide) / 12.0;
    let first = record.samples.iter().find(|s| s.t > 0.5 + 1e-9).unwrap();
    let before = record.samples.iter().rfind(|s| s.t < 0.5 - 1e-9).unwrap();
    assert_eq!(before.rates[1..], [0.0; 3]);
    let omega = off / (square + off * off);
    assert!((first.rates[3] - omega).abs() < 1e-3, "{}", first.rates[3]);
    // The velocity of the middle, which is at (0, 2) in the rod's frame.
    let speed = square / (square + off * off);
    let theta = first.coordinates[3];
    let middle = first.rates[2] - 2.0 * theta.sin() * first.rates[3];
    assert!((middle - speed).abs() < 1e-3, "{middle} {speed}");
}

/// A disc in a trough, which a load pulls down: it rolls nowhere, slides down one side, and rests on both.
#[test]
fn a_disc_comes_to_rest_in_a_trough() {
    let trough = polygon(
        "trough",
        &[
            (-9.0, 9.0),
            (-10.0, 9.0),
            (-10.0, -2.0),
            (10.0, -2.0),
            (10.0, 9.0),
            (9.0, 9.0),
            (0.0, 0.0),
        ],
    );
    let disc = Part::circle("disc", (3.0, 6.0), 1.0).unwrap();
    let mut mechanism = mechanism(vec![PartEntry::fixed(trough), PartEntry::planar(disc)]);
    let kind = LoadKind::Force {
        force: Vector::new(0.0, -10.0),
        at: None,
    };
    mechanism.dynamics.loads.push(Load { part: 1, kind });
    let (_, record) = run(&mechanism, 10.0, 0.05);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let kinds: Vec<EventKind> = record.events.iter().map(|e| e.kind).collect();
    assert_eq!(kinds, [EventKind::Snap, EventKind::Touch, EventKind::Touch]);
    assert!(record.events.iter().all(|e| e.t == 0.0));
    let end = at(&record, 10.0);
    assert!((end[0] + 3.0).abs() < 1e-9 && (end[1] - 2.0_f64.sqrt() + 6.0).abs() < 1e-9);
    assert!(end[2].abs() < 1e-9);
}

/// A peg that is pushed along a slot comes to its bottom and jams.
#[test]
fn a_peg_jams_at_the_bottom() {
    let slot = polygon(
        "slot",
        &[
            (-5.0, 0.0),
            (-1.01, 0.0),
            (-1.01, -8.0),
            (1.01, -8.0),
            (1.01, 0.0),
            (5.0, 0.0),
            (5.0, -10.0),
            (-5.0, -10.0),
        ],
    );
    let peg = Part::rectangle("peg", (0.0, 0.0), 2.0, 6.0).unwrap();
    let pusher = Part::rectangle("pusher", (0.3, 5.0), 1.0, 2.0).unwrap();
    let parts = vec![
        PartEntry::fixed(slot),
        PartEntry::planar(peg),
        PartEntry::prismatic(pusher, (0.0, -1.0)),
    ];
    let (_, record) = run(&driven(mechanism(parts), 2, 1.0), 20.0, 0.1);
    assert_eq!(record.status, Status::Jammed, "{:?}", record.reason);
    // 1 to the peg, 5 to the bottom, and what leaning against the walls adds.
    assert!((record.until - 6.0).abs() < 0.05, "{}", record.until);
    assert!(record.obstacles.len() >= 2);
}

fn slider_crank(crank_driven: bool) -> Mechanism {
    let crank = Part::rectangle("crank", (1.0, 0.0), 2.4, 0.4).unwrap();
    let rod = Part::rectangle("rod", (4.5, 0.0), 5.4, 0.4).unwrap();
    let slider = Part::rectangle("slider", (7.0, 0.0), 1.0, 1.0).unwrap();
    let mut mechanism = Mechanism::new("slider-crank");
    mechanism.parts = vec![
        PartEntry::revolute(crank, (0.0, 0.0)),
        PartEntry::planar(rod),
        PartEntry::prismatic(slider, (1.0, 0.0)),
    ];
    let joint = |x: f64, parts| JointEntry {
        joint: Joint::Revolute {
            at: Point::new(x, 0.0),
        },
        parts,
    };
    mechanism.joints = vec![joint(2.0, (0, 1)), joint(7.0, (1, 2))];
    mechanism.pairs = mechanism.every_two();
    if crank_driven {
        driven(mechanism, 0, TAU)
    } else {
        mechanism
    }
}

/// Through both dead points, as the crank drives.
#[test]
fn a_slider_crank_follows_its_crank() {
    let (_, record) = run(&slider_crank(true), 3.0, 0.01);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for sample in &record.samples {
        let (sin, cos) = (TAU * sample.t).sin_cos();
        let position = 2.0 * cos + (25.0 - 4.0 * sin * sin).sqrt() - 7.0;
        assert!(
            (sample.coordinates[4] - position).abs() < 1e-11,
            "{}",
            sample.t
        );
    }
}

/// A slider that is driven cannot take its crank past a dead point.
#[test]
fn a_slider_crank_jams_at_a_dead_point() {
    let mut mechanism = slider_crank(false);
    // Begun with the crank at 90 degrees: the slider is at √21, and may go out to 7.
    let quarter = std::f64::consts::FRAC_PI_2;
    mechanism.dynamics.part_mut(0).start = Some(PartPosition::Axis(quarter));
    mechanism.dynamics.part_mut(2).start = Some(PartPosition::Axis(21.0_f64.sqrt() - 7.0));
    let lean = -(2.0_f64 / 5.0).asin();
    let (sin, cos) = lean.sin_cos();
    let rod = cspace::Configuration::new(-2.0 * cos, 2.0 - 2.0 * sin, lean);
    mechanism.dynamics.part_mut(1).start = Some(PartPosition::Planar(rod));
    let mut mechanism = driven(mechanism, 2, 1.0);
    let (_, slow) = run(&mechanism, 9.0, 0.01);
    for part in [0, 1] {
        mechanism.dynamics.part_mut(part).mass = Some(Mass::Total(0.1));
    }
    let (_, heavy) = thrown_model(&mechanism, 9.0, 0.01);
    for record in [slow, heavy] {
        assert_eq!(record.status, Status::Jammed, "{:?}", record.reason);
        near("the end", record.until, 7.0 - 21.0_f64.sqrt(), 1e-6);
        let why = record.reason.unwrap();
        let place = "crank and rod are in line, a dead point, where slider is at";
        assert!(
            why.starts_with(place) && why.ends_with("its range ends here"),
            "{why}"
        );
    }
}

/// Joints that do not meet, and parts that overlap, are reported by name.
#[test]
fn what_cannot_start_is_told() {
    let mut apart = slider_crank(true);
    let rod = Part::rectangle("rod", (4.5, 0.0), 5.4, 0.4).unwrap();
    apart.parts[1] = PartEntry::revolute(rod, (2.0, 5.0));
    apart.dynamics.part_mut(0).start = Some(PartPosition::Axis(1.0));
    let error = Simulation::new(&apart).unwrap_err();
    assert!(matches!(&error, SimulateError::Joints { .. }), "{error}");
    let parts = vec![
        PartEntry::fixed(Part::rectangle("table", (0.0, 0.0), 4.0, 4.0).unwrap()),
        PartEntry::planar(Part::rectangle("block", (2.5, 0.0), 2.0, 2.0).unwrap()),
    ];
    let error = Simulation::new(&mechanism(parts)).unwrap_err();
    let SimulateError::Overlap {
        fixed,
        moving,
        depth,
    } = &error
    else {
        panic!("{error}")
    };
    assert_eq!((fixed.as_str(), moving.as_str()), ("table", "block"));
    assert!((depth - 0.5).abs() < 1e-9);
}

/// A slider that is drawn flush on its rail, and a key that is drawn in its slot to size, move: they are smaller by a gap, and keep their
/// mass. What overlaps by more than rounding is refused.
#[test]
fn exact_fits_move() {
    let slider = |overlap: f64| {
        let mechanism = mechanism(vec![
            PartEntry::fixed(Part::rectangle("rail", (10.0, -0.5), 20.0, 1.0).unwrap()),
            PartEntry::prismatic(
                Part::rectangle("slider", (3.0, 1.0 - overlap), 2.0, 2.0).unwrap(),
                (1.0, 0.0),
            ),
        ]);
        driven(mechanism, 1, 5.0)
    };
    let (simulation, record) = run(&slider(0.0), 1.0, 0.1);
    let [gap] = simulation.gaps() else {
        panic!("{:?}", simulation.gaps())
    };
    assert_eq!(gap.part, "slider");
    assert!(gap.gap > 0.0 && gap.gap < 1e-4, "{gap:?}");
    assert_eq!(record.status, Status::Done);
    assert!((record.samples.last().unwrap().coordinates[0] - 5.0).abs() < 1e-9);
    let error = Simulation::new(&slider(1e-6)).unwrap_err();
    assert!(matches!(&error, SimulateError::Overlap { .. }), "{error}");

    let mut keyed = keyed();
    let force = |x: f64, y: f64| LoadKind::Force {
        force: Vector::new(x, y),
        at: None,
    };
    keyed.dynamics.loads.push(Load {
        part: 1,
        kind: force(0.0, 3.0),
    });
    keyed.dynamics.part_mut(1).mass = Some(Mass::Density(0.01));
    let dynamic = |keyed: &Mechanism| {
        let simulation = Simulation::new(keyed).unwrap();
        let settings = Settings {
            time: 2.0,
            every: None,
        };
        let record = simulation.dynamic(&settings).unwrap();
        judge(&simulation, &record);
        (simulation, record)
    };
    let (simulation, record) = dynamic(&keyed);
    assert_eq!(simulation.gaps()[0].part, "key");
    // It slides out by ½ (3 / 1) 2² with the mass of the drawn outline.
    let last = &record.samples.last().unwrap().coordinates;
    assert!(
        (last[1] - 6.0).abs() < 1e-9 && last[0].abs() < 1e-9,
        "{last:?}"
    );
    keyed.dynamics.loads[0].kind = force(0.0, -3.0);
    let (simulation, record) = dynamic(&keyed);
    let gap = simulation.gaps()[0].gap;
    let last = &record.samples.last().unwrap().coordinates;
    assert!(
        (last[1] + gap).abs() < 1e-9 && last[0].abs() < 1e-9,
        "{last:?}"
    );
}

/// A square shaft that fits its hub exactly follows it, though the space of the two has no contact; where they overlap they are refused,
/// also beside an exact fit.
#[test]
fn a_space_without_contact_is_no_free_one() {
    let hub = |hole: f64| {
        let square = |half: f64| {
            let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
            corners.map(|(x, y)| Vertex::line(x, y)).to_vec()
        };
        let rim = vec![Vertex::new(-10.0, 0.0, 1.0), Vertex::new(10.0, 0.0, 1.0)];
        let hub = Part::new("hub", vec![rim, square(hole)]).unwrap();
        let shaft = Part::new("shaft", vec![square(3.0)]).unwrap();
        mechanism(vec![
            PartEntry::revolute(hub, (0.0, 0.0)),
            PartEntry::revolute(shaft, (0.0, 0.0)),
        ])
    };
    let (simulation, record) = run(&driven(hub(3.0), 0, TAU), 1.0, 0.1);
    assert_eq!(simulation.gaps().len(), 1);
    let last = &record.samples.last().unwrap().coordinates;
    assert!((last[1] - TAU).abs() < 1e-4, "{last:?}");
    let error = Simulation::new(&driven(hub(3.0 - 1e-6), 0, TAU)).unwrap_err();
    assert!(matches!(&error, SimulateError::Overlap { .. }), "{error}");
    let part = |name: &str, x: f64, w: f64| Part::rectangle(name, (x, 0.0), w, 4.0).unwrap();
    let mut row = mechanism(vec![
        PartEntry::fixed(part("left", -2.0, 4.0)),
        PartEntry::planar(part("middle", 2.0, 4.0)),
        PartEntry::fixed(part("right", 6.0, 4.0)),
        PartEntry::planar(part("cap", 10.0 - 1e-6, 4.0)),
    ]);
    row.dynamics.loads.push(Load {
        part: 3,
        kind: LoadKind::Torque(1.0),
    });
    let error = Simulation::new(&row).unwrap_err();
    let SimulateError::Overlap { fixed, moving, .. } = &error else {
        panic!("{error}")
    };
    assert_eq!((fixed.as_str(), moving.as_str()), ("right", "cap"));
}

/// A body of two parts is pushed as one and, on a prismatic joint, slides along a part that turns.
#[test]
fn a_body_slides_along_a_part_that_turns() {
    let mut mechanism = Mechanism::new("joints");
    let slide = PartEntry::planar(Part::rectangle("slide", (3.0, 0.0), 1.0, 1.0).unwrap());
    let flag = PartEntry::planar(Part::rectangle("flag", (3.0, 2.0), 1.0, 1.0).unwrap());
    mechanism.parts = vec![
        PartEntry::revolute(
            Part::rectangle("arm", (3.0, 0.0), 6.0, 0.5).unwrap(),
            (0.0, 0.0),
        ),
        PartEntry::body(&[slide, flag]).unwrap(),
    ];
    let direction = Vector::new(1.0, 0.0);
    let along = Joint::Prismatic {
        direction,
        at: Point::ORIGIN,
    };
    mechanism.joints = vec![JointEntry {
        joint: along,
        parts: (0, 1),
    }];
    let kind = LoadKind::Force {
        force: Vector::new(2.0, 0.0),
        at: None,
    };
    mechanism.dynamics.loads.push(Load { part: 1, kind });
    // A spring holds the slide against the load.
    mechanism.dynamics.springs.push(cspace_model::Spring {
        part: 1,
        other: None,
        kind: cspace_model::SpringKind::Linear {
            at: (Point::new(3.0, 0.0), Point::ORIGIN),
            stiffness: 4.0,
            length: 3.0,
            damping: 0.0,
        },
    });
    let (simulation, record) = run(&driven(mechanism, 0, 1.0), 3.0, 0.05);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    let system = simulation.system();
    for sample in &record.samples {
        let q = &sample.coordinates;
        let slide = system.relative(0, 1, q);
        assert!(
            slide.y.abs() < 1e-11 && slide.theta.abs() < 1e-11,
            "{slide:?}"
        );
    }
    // Along the arm the load's share, 2 cos φ, is that of the spring, 4 times its way.
    for sample in &record.samples {
        let out = system.relative(0, 1, &sample.coordinates).x;
        let phi = sample.coordinates[0];
        assert!((4.0 * out - 2.0 * phi.cos()).abs() < 1e-10, "{phi}: {out}");
    }
}
