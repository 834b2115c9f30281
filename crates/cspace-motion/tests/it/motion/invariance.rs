//! Motions do not depend on how a mechanism is written down: which part of a pair is called fixed, the order of the
//! parts, the number of threads, and when samples are taken.

use cspace_model::{Dynamics, Mechanism};
use cspace_motion::{Event, Record, Settings, Simulation, What};
use cspace_oracle::effort;

use crate::motion::helpers::model;

/// Models that drives move, and how long.
const DRIVEN: [(&str, f64); 9] = [
    ("geneva", 2.3),
    ("gears_on_shafts", 1.3),
    ("ratchet_mechanism", 2.2),
    ("escapement", 2.2),
    ("cam_tappet", 1.7),
    ("rack_pinion", 1.2),
    ("cam_roller", 1.7),
    ("film_advance", 2.2),
    ("snap_in", 2.5),
];

/// Every second of them by default.
fn driven() -> impl Iterator<Item = (&'static str, f64)> {
    DRIVEN.into_iter().step_by(effort(2, 1))
}

/// Events are at the same times to this, seconds.
const TIME: f64 = 1e-9;

fn moved(mechanism: &Mechanism, time: f64, every: f64) -> (Simulation, Record) {
    let simulation = Simulation::new(mechanism).unwrap();
    let every = Some(every);
    let record = simulation.kinematic(&Settings { time, every }).unwrap();
    (simulation, record)
}

/// The pairs seen from their other part.
pub(crate) fn exchanged(mechanism: &Mechanism) -> Mechanism {
    let mut other = mechanism.clone();
    for pair in &mut other.pairs {
        std::mem::swap(&mut pair.fixed, &mut pair.moving);
    }
    other
}

/// The parts in the reverse order, and all lists that name them.
pub(crate) fn reversed(mechanism: &Mechanism) -> Mechanism {
    let count = mechanism.parts.len();
    let turned = |i: usize| count - 1 - i;
    let mut other = mechanism.clone();
    other.parts.reverse();
    for pair in &mut other.pairs {
        (pair.fixed, pair.moving) = (turned(pair.fixed), turned(pair.moving));
    }
    for joint in &mut other.joints {
        joint.parts = (turned(joint.parts.0), turned(joint.parts.1));
    }
    let Dynamics {
        parts,
        pairs,
        drives,
        loads,
        springs,
        ..
    } = &mut other.dynamics;
    parts.resize(count, Default::default());
    parts.reverse();
    for surface in pairs {
        surface.parts = (turned(surface.parts.0), turned(surface.parts.1));
    }
    drives.iter_mut().for_each(|d| d.part = turned(d.part));
    loads.iter_mut().for_each(|l| l.part = turned(l.part));
    for spring in springs {
        spring.part = turned(spring.part);
        spring.other = spring.other.map(turned);
    }
    other.pairs.reverse();
    other.joints.reverse();
    other
}

/// The names of what an event is about, in one order.
pub(crate) fn about(event: &Event) -> [String; 2] {
    match &event.what {
        What::Contact { fixed, moving, .. } => {
            let mut names = [fixed.clone(), moving.clone()];
            names.sort();
            names
        }
        What::Part { part } => [part.clone(), String::new()],
        What::Limit { part, limit } => [part.clone(), limit.to_string()],
    }
}

#[track_caller]
fn same(what: &str, one: &(Simulation, Record), other: &(Simulation, Record)) {
    let (a, b) = (&one.1, &other.1);
    assert_eq!(a.status, b.status, "{what}: {:?} {:?}", a.reason, b.reason);
    assert_eq!(a.events.len(), b.events.len(), "{what}");
    for event in &a.events {
        let found = b.events.iter().any(|e| {
            e.kind == event.kind && (e.t - event.t).abs() < TIME && about(e) == about(event)
        });
        assert!(found, "{what}: {event:?}");
    }
    let end = |(simulation, record): &(Simulation, Record)| {
        let system = simulation.system();
        let q = &record.samples.last().unwrap().coordinates;
        let mut named: Vec<(String, Vec<f64>)> = (system.parts().iter().enumerate())
            .map(|(i, part)| {
                let name = system.mechanism().parts[i].part.name().to_owned();
                (name, q[part.indices()].to_vec())
            })
            .collect();
        named.sort_by(|a, b| a.0.cmp(&b.0));
        named
    };
    for ((name, a), (_, b)) in end(one).iter().zip(&end(other)) {
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() < 1e-9, "{what}: {name} {a} {b}");
        }
    }
}

#[test]
fn roles_in_pairs_change_nothing() {
    for (name, time) in driven() {
        let mechanism = model(name);
        let one = moved(&mechanism, time, 0.1);
        same(name, &one, &moved(&exchanged(&mechanism), time, 0.1));
    }
}

#[test]
fn the_order_of_parts_changes_nothing() {
    for (name, time) in driven() {
        let mechanism = model(name);
        let one = moved(&mechanism, time, 0.1);
        same(name, &one, &moved(&reversed(&mechanism), time, 0.1));
    }
}

#[test]
fn threads_change_not_a_bit() {
    for (name, time) in driven() {
        let mechanism = model(name);
        let by = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build()
                .unwrap()
                .install(|| moved(&mechanism, time, 0.1).1)
        };
        assert_eq!(by(1), by(3), "{name}");
    }
}

#[test]
fn samples_do_not_move_events() {
    for (name, time) in driven() {
        let mechanism = model(name);
        let (few, many) = (
            moved(&mechanism, time, time).1,
            moved(&mechanism, time, effort(0.011, 0.003)).1,
        );
        assert_eq!(few.events, many.events, "{name}");
        let end = |r: &Record| r.samples.last().unwrap().coordinates.clone();
        for (a, b) in end(&few).iter().zip(&end(&many)) {
            assert!((a - b).abs() < 1e-12, "{name}: {a} {b}");
        }
    }
}
