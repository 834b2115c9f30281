#![allow(clippy::unwrap_used)]

use super::{
    Drive, DriveMotion, DynamicsFault as Fault, DynamicsItem as Item, Load, LoadKind, Mass,
    PairSurface, PartPosition, PartVelocity, Spring, SpringKind,
};
use cspace::fixed_axes::Axis;
use cspace::geometry::{Configuration, Point, Vector};
use cspace::part::Part;

use crate::mechanism::{Mechanism, MechanismError, PartEntry};

/// A frame, a wheel at x = 4, a slider with limits, and a block that moves freely.
fn four() -> Mechanism {
    let disc = |name: &str, x: f64| Part::circle(name, (x, 0.0), 1.0).unwrap();
    let mut mechanism = Mechanism::new("four");
    let slide = Axis::prismatic(Vector::new(0.0, 1.0)).within(-1.0, 2.0);
    mechanism.parts = vec![
        PartEntry::fixed(disc("frame", 0.0)),
        PartEntry::revolute(disc("wheel", 4.0), (4.0, 0.0)),
        PartEntry::on(disc("slider", 8.0), slide),
        PartEntry::planar(Part::rectangle("block", (0.0, 9.0), 2.0, 1.0).unwrap()),
    ];
    mechanism.pairs = mechanism.every_two();
    mechanism
}

const SPRING: Spring = Spring {
    part: 3,
    other: Some(1),
    kind: SpringKind::Linear {
        at: (Point::ORIGIN, Point::new(4.0, 1.0)),
        stiffness: 2.0,
        length: 0.0,
        damping: 0.0,
    },
};

fn table(points: &[(f64, f64)]) -> Drive {
    Drive {
        part: 2,
        motion: DriveMotion::Table(points.to_vec()),
    }
}

fn all_of_it() -> Mechanism {
    let mut mechanism = four();
    let d = &mut mechanism.dynamics;
    d.gravity = Vector::new(0.0, -9810.0);
    d.friction = 0.1;
    d.restitution = 1.0;
    d.part_mut(0).mass = Some(Mass::Total(5.0));
    d.part_mut(1).start = Some(PartPosition::Axis(0.5));
    d.part_mut(3).mass = Some(Mass::Density(0.1));
    d.part_mut(3).inertia = Some(0.2);
    d.part_mut(3).center_of_mass = Some(Point::new(0.0, 9.1));
    d.part_mut(3).start = Some(PartPosition::Planar(Configuration::new(1.0, 2.0, 3.0)));
    let linear = Vector::new(1.0, 2.0);
    d.part_mut(3).rate = Some(PartVelocity::Planar {
        linear,
        angular: 3.0,
    });
    d.pairs.push(PairSurface {
        parts: (3, 0),
        friction: Some(0.0),
        restitution: Some(0.0),
    });
    d.drives.push(Drive {
        part: 1,
        motion: DriveMotion::Rate(-6.0),
    });
    d.drives.push(table(&[(0.0, -1.0), (1.0, 2.0)]));
    let force = Vector::new(0.0, -3.0);
    d.loads.push(Load {
        part: 3,
        kind: LoadKind::Force { force, at: None },
    });
    d.loads.push(Load {
        part: 1,
        kind: LoadKind::Torque(-0.5),
    });
    d.springs.push(SPRING);
    mechanism
}

#[test]
fn all_that_makes_sense_is_taken() {
    let mechanism = all_of_it();
    mechanism.check().unwrap();
    assert!(!mechanism.dynamics.is_none());
    assert!(four().dynamics.is_none());
    assert_eq!(mechanism.dynamics.restitution_between(0, 3), 0.0);
    assert_eq!(mechanism.dynamics.restitution_between(1, 3), 1.0);
    assert!(mechanism.dynamics.drive_of(2).is_some());
    assert!(mechanism.dynamics.drive_of(3).is_none());
}

#[test]
fn masses_come_from_the_outline_where_not_given() {
    let mut mechanism = four();
    mechanism.dynamics.part_mut(3).mass = Some(Mass::Density(0.25));
    let of = |m: &Mechanism| m.mass_properties(3).unwrap();
    let even = of(&mechanism);
    assert!((even.mass - 0.5).abs() < 1e-15);
    assert!((even.inertia - 0.5 * 5.0 / 12.0).abs() < 1e-15);
    assert_eq!(even.center, Point::new(0.0, 9.0));
    mechanism.dynamics.part_mut(3).mass = Some(Mass::Total(0.5));
    assert_eq!(of(&mechanism), even);
    // About another centre of mass, it is the outline's inertia about that.
    let end = Point::new(1.0, 9.0);
    mechanism.dynamics.part_mut(3).center_of_mass = Some(end);
    let off = of(&mechanism);
    assert_eq!(off.center, end);
    assert!((off.inertia - 0.5 * (5.0 / 12.0 + 1.0)).abs() < 1e-15);
    assert!((off.inertia - even.inertia_about(end)).abs() < 1e-15);
    mechanism.dynamics.part_mut(3).inertia = Some(7.0);
    assert_eq!(of(&mechanism).inertia, 7.0);
    assert_eq!(mechanism.mass_properties(1), None);
    assert_eq!(mechanism.mass_properties(4), None);
}

#[track_caller]
fn refused(change: impl Fn(&mut Mechanism), item: Item, key: &str, fault: Fault) {
    let mut mechanism = all_of_it();
    change(&mut mechanism);
    let MechanismError::Dynamics(error) = mechanism.check().unwrap_err() else {
        panic!("another error");
    };
    assert_eq!((error.item, error.key, error.fault), (item, key, fault));
    assert!(error.to_string().contains(fault.help()), "{error}");
}

#[test]
fn numbers_of_the_whole_and_of_parts() {
    let whole = Item::Mechanism;
    refused(
        |m| m.dynamics.gravity.x = f64::NAN,
        whole,
        "gravity",
        Fault::NotFinite,
    );
    refused(
        |m| m.dynamics.friction = -0.1,
        whole,
        "friction",
        Fault::Negative(-0.1),
    );
    refused(
        |m| m.dynamics.restitution = 1.1,
        whole,
        "restitution",
        Fault::NotUpToOne(1.1),
    );
    let part = Item::Part(3);
    for (mass, key) in [(Mass::Total(0.0), "mass"), (Mass::Density(0.0), "density")] {
        refused(
            |m| m.dynamics.part_mut(3).mass = Some(mass),
            part,
            key,
            Fault::NotPositive(0.0),
        );
    }
    let infinite = Some(Mass::Total(f64::INFINITY));
    refused(
        |m| m.dynamics.part_mut(3).mass = infinite,
        part,
        "mass",
        Fault::NotFinite,
    );
    refused(
        |m| m.dynamics.part_mut(3).mass = None,
        part,
        "inertia",
        Fault::NoMass,
    );
    refused(
        |m| m.dynamics.part_mut(3).inertia = Some(-1.0),
        part,
        "inertia",
        Fault::NotPositive(-1.0),
    );
    let nowhere = Some(Point::new(0.0, f64::NAN));
    refused(
        |m| m.dynamics.part_mut(3).center_of_mass = nowhere,
        part,
        "center_of_mass",
        Fault::NotFinite,
    );
    let beyond = Fault::NoSuchPart { part: 4, parts: 4 };
    refused(
        |m| m.dynamics.part_mut(4).mass = None,
        Item::Part(4),
        "part",
        beyond,
    );
}

#[test]
fn starts_and_rates_fit_the_motion() {
    let start =
        |i: usize, s: PartPosition| move |m: &mut Mechanism| m.dynamics.part_mut(i).start = Some(s);
    let rate =
        |i: usize, r: PartVelocity| move |m: &mut Mechanism| m.dynamics.part_mut(i).rate = Some(r);
    let planar = PartPosition::Planar(Configuration::default());
    let moves = PartVelocity::Planar {
        linear: Vector::ZERO,
        angular: 0.0,
    };
    refused(
        start(0, PartPosition::Axis(0.0)),
        Item::Part(0),
        "start",
        Fault::StandsStill,
    );
    refused(start(1, planar), Item::Part(1), "start", Fault::OnAnAxis);
    refused(
        start(3, PartPosition::Axis(0.0)),
        Item::Part(3),
        "start",
        Fault::InThePlane,
    );
    refused(
        rate(0, PartVelocity::Axis(0.0)),
        Item::Part(0),
        "rate",
        Fault::StandsStill,
    );
    refused(rate(2, moves), Item::Part(2), "rate", Fault::OnAnAxis);
    refused(
        rate(3, PartVelocity::Axis(0.0)),
        Item::Part(3),
        "rate",
        Fault::InThePlane,
    );
    let out = Fault::OutOfRange {
        value: 2.5,
        lo: -1.0,
        hi: 2.0,
    };
    refused(
        start(2, PartPosition::Axis(2.5)),
        Item::Part(2),
        "start",
        out,
    );
    refused(
        rate(1, PartVelocity::Axis(0.0)),
        Item::Part(1),
        "rate",
        Fault::Driven { drive: 0 },
    );
    let driven = Fault::Driven { drive: 1 };
    refused(
        start(2, PartPosition::Axis(0.5)),
        Item::Part(2),
        "start",
        driven,
    );
    refused(
        rate(
            3,
            PartVelocity::Planar {
                linear: Vector::ZERO,
                angular: f64::NAN,
            },
        ),
        Item::Part(3),
        "rate",
        Fault::NotFinite,
    );
}

#[test]
fn surfaces_of_pairs() {
    let own = |a: usize, b: usize, friction: f64, restitution: f64| {
        move |m: &mut Mechanism| {
            let (friction, restitution) = (Some(friction), Some(restitution));
            m.dynamics.pairs.push(PairSurface {
                parts: (a, b),
                friction,
                restitution,
            });
        }
    };
    refused(
        own(0, 3, 0.0, 0.0),
        Item::Pair(0, 3),
        "pair",
        Fault::PairTwice,
    );
    refused(own(0, 4, 0.0, 0.0), Item::Pair(0, 4), "pair", Fault::NoPair);
    refused(
        own(1, 0, -1.0, 0.0),
        Item::Pair(1, 0),
        "friction",
        Fault::Negative(-1.0),
    );
    refused(
        own(1, 0, 0.0, -1.0),
        Item::Pair(1, 0),
        "restitution",
        Fault::NotUpToOne(-1.0),
    );
}

#[test]
fn drives() {
    let drive = |d: Drive| move |m: &mut Mechanism| m.dynamics.drives[1] = d.clone();
    let rate = |part, rate| Drive {
        part,
        motion: DriveMotion::Rate(rate),
    };
    let item = Item::Drive(1);
    refused(drive(rate(0, 1.0)), item, "part", Fault::StandsStill);
    refused(
        drive(rate(1, 1.0)),
        item,
        "part",
        Fault::DrivenTwice { first: 0 },
    );
    refused(drive(rate(3, 1.0)), item, "part", Fault::MovesFreely);
    refused(
        drive(rate(7, 1.0)),
        item,
        "part",
        Fault::NoSuchPart { part: 7, parts: 4 },
    );
    refused(drive(rate(2, f64::NAN)), item, "rate", Fault::NotFinite);
    refused(
        drive(table(&[(0.0, 1.0)])),
        item,
        "table",
        Fault::ShortTable { points: 1 },
    );
    refused(
        drive(table(&[(0.0, 1.0), (f64::INFINITY, 1.0)])),
        item,
        "table",
        Fault::NotFinite,
    );
    let order = Fault::TimeOrder {
        point: 2,
        time: 1.0,
        before: 1.0,
    };
    refused(
        drive(table(&[(0.0, 1.0), (1.0, 1.0), (1.0, 1.0)])),
        item,
        "table",
        order,
    );
    let out = Fault::OutOfRange {
        value: 3.0,
        lo: -1.0,
        hi: 2.0,
    };
    refused(drive(table(&[(0.0, 1.0), (1.0, 3.0)])), item, "table", out);
}

#[test]
fn loads_and_springs() {
    let load = |part, kind| move |m: &mut Mechanism| m.dynamics.loads[0] = Load { part, kind };
    let force = Vector::new(1.0, f64::NAN);
    refused(
        load(3, LoadKind::Force { force, at: None }),
        Item::Load(0),
        "force",
        Fault::NotFinite,
    );
    let at = Some(Point::new(f64::NAN, 0.0));
    refused(
        load(
            3,
            LoadKind::Force {
                force: Vector::ZERO,
                at,
            },
        ),
        Item::Load(0),
        "at",
        Fault::NotFinite,
    );
    refused(
        load(3, LoadKind::Torque(f64::NAN)),
        Item::Load(0),
        "torque",
        Fault::NotFinite,
    );
    refused(
        load(0, LoadKind::Torque(1.0)),
        Item::Load(0),
        "part",
        Fault::StandsStill,
    );
    refused(
        load(4, LoadKind::Torque(1.0)),
        Item::Load(0),
        "part",
        Fault::NoSuchPart { part: 4, parts: 4 },
    );
    let spring = |s: Spring| move |m: &mut Mechanism| m.dynamics.springs[0] = s;
    let item = Item::Spring(0);
    refused(
        spring(Spring {
            other: Some(3),
            ..SPRING
        }),
        item,
        "parts",
        Fault::OnePart,
    );
    refused(
        spring(Spring {
            other: Some(4),
            ..SPRING
        }),
        item,
        "parts",
        Fault::NoSuchPart { part: 4, parts: 4 },
    );
    // A spring between the ground and a part that does not move.
    let still = Spring {
        part: 0,
        other: None,
        ..SPRING
    };
    refused(spring(still), item, "parts", Fault::StandsStill);
    let linear = |stiffness, length, damping| Spring {
        kind: SpringKind::Linear {
            at: (Point::ORIGIN, Point::ORIGIN),
            stiffness,
            length,
            damping,
        },
        ..SPRING
    };
    refused(
        spring(linear(1.0, -1.0, 0.0)),
        item,
        "length",
        Fault::Negative(-1.0),
    );
    refused(
        spring(linear(-1.0, 1.0, 0.0)),
        item,
        "stiffness",
        Fault::Negative(-1.0),
    );
    refused(
        spring(linear(1.0, 1.0, -1.0)),
        item,
        "damping",
        Fault::Negative(-1.0),
    );
    refused(
        spring(linear(0.0, 1.0, 0.0)),
        item,
        "stiffness",
        Fault::Idle,
    );
    let kind = SpringKind::Torsion {
        stiffness: 1.0,
        angle: f64::NAN,
        damping: 0.0,
    };
    refused(
        spring(Spring { kind, ..SPRING }),
        item,
        "angle",
        Fault::NotFinite,
    );
}
