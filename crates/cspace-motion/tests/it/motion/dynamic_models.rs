//! Models that ship, with their masses or with some: energy, free space, and how they are written down.

use cspace_model::{Mass, Mechanism, PartDynamics};
use cspace_motion::{Event, EventKind, Record, Settings, Simulation, Status, What};
use cspace_oracle::effort;

use crate::motion::helpers::{judge, model, near, thrown_model};
use crate::motion::invariance::{about, exchanged, reversed};

/// Models with masses, and how long each is followed, s.
const WEIGHED: [(&str, f64); 4] = [
    ("woodpecker", 0.2),
    ("gears_backlash", 0.5),
    ("slider_crank_clearance", 0.1),
    ("escapement_pendulum", 1.0),
];

/// Models that are driven and have no masses: they get some.
const DRIVEN: [(&str, f64); 7] = [
    ("geneva", 1.1),
    ("gears_on_shafts", 0.6),
    ("ratchet_mechanism", 1.1),
    ("cam_tappet", 1.1),
    ("cam_roller", 1.1),
    ("film_advance", 1.1),
    ("rack_pinion", 0.6),
];

/// Scale of the energy balance: the largest of the energy present, put in or lost.
fn through(record: &Record) -> f64 {
    let e = record.energy.unwrap();
    (e.start.abs() + e.end.abs())
        .max(e.drives.abs())
        .max(e.friction + e.impacts)
}

fn weighed(name: &str) -> Mechanism {
    let mut mechanism = model(name);
    let count = mechanism.parts.len();
    mechanism
        .dynamics
        .parts
        .resize(count, PartDynamics::default());
    for part in &mut mechanism.dynamics.parts {
        // Steel, 5 mm thick.
        part.mass.get_or_insert(Mass::Density(3.9e-5));
    }
    mechanism
}

/// All of them, followed for a share of their time.
fn all(share: f64) -> Vec<(String, Mechanism, f64)> {
    let own = WEIGHED
        .iter()
        .map(|&(name, time)| (name, model(name), time));
    let given = DRIVEN
        .iter()
        .map(|&(name, time)| (name, weighed(name), time));
    own.chain(given)
        .map(|(n, m, t)| (n.to_owned(), m, share * t))
        .collect()
}

#[test]
fn energy_is_kept_and_nothing_overlaps() {
    for (name, mechanism, time) in all(effort(0.2, 1.0)) {
        let (simulation, record) = thrown_model(&mechanism, time, time / 400.0);
        judge(&simulation, &record);
        assert_eq!(record.status, Status::Done, "{name}: {:?}", record.reason);
        near(
            &name,
            record.energy.unwrap().drift / through(&record),
            0.0,
            1e-6,
        );
    }
}

/// The first events of both, as many as are the same before what is chaotic in impacts makes rounding large.
#[track_caller]
fn begin_alike(what: &str, a: &Record, b: &Record) {
    const FIRST: usize = 11;
    assert_eq!(a.status, b.status, "{what}: {:?} {:?}", a.reason, b.reason);
    for (k, event) in a.events.iter().take(FIRST).enumerate() {
        let alike = |e: &&Event| {
            e.kind == event.kind && about(e) == about(event) && (e.t - event.t).abs() < 1e-9
        };
        assert!(
            b.events.iter().any(|e| alike(&e)),
            "{what}: event {k}, {event:?} among {:?}",
            b.events.iter().take(FIRST).collect::<Vec<_>>()
        );
    }
}

#[test]
fn how_a_model_is_written_changes_no_first_events() {
    for (name, mechanism, time) in all(effort(0.2, 1.0)) {
        let one = thrown_model(&mechanism, time, time).1;
        let other = thrown_model(&exchanged(&mechanism), time, time).1;
        begin_alike(&format!("{name}, exchanged"), &one, &other);
        let other = thrown_model(&reversed(&mechanism), time, time).1;
        begin_alike(&format!("{name}, reversed"), &one, &other);
    }
}

#[test]
fn threads_and_samples_change_nothing() {
    for (name, mechanism, time) in all(effort(0.1, 1.0)).into_iter().step_by(effort(3, 1)) {
        let by = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build()
                .unwrap()
                .install(|| thrown_model(&mechanism, time, time / 3.0).1)
        };
        let one = by(1);
        assert_eq!(one, by(3), "{name}");
        let simulation = Simulation::new(&mechanism).unwrap();
        let settings = Settings {
            time,
            every: Some(time / 777.0),
        };
        let many = simulation.dynamic(&settings).unwrap();
        assert_eq!(one.events, many.events, "{name}");
    }
}

/// Events are consistent: a closed contact has no event of touching, and an open one none of release; a contact closed
/// at an impact stays closed; a resting one has no event of touching; and no contact both sticks and slips at one time.
#[test]
fn events_are_told_in_a_sane_order() {
    for (name, mechanism, time) in all(effort(0.2, 1.0)) {
        let record = thrown_model(&mechanism, time, time).1;
        let mut last = 0.0;
        for (k, event) in record.events.iter().enumerate() {
            assert!(event.t >= last, "{name}: {event:?} after {last}");
            last = event.t;
            let same = |e: &&Event| e.t == event.t && e.what == event.what;
            let now: Vec<EventKind> = record.events[..k]
                .iter()
                .filter(same)
                .map(|e| e.kind)
                .collect();
            assert!(!now.contains(&event.kind), "{name}: twice {event:?}");
            let forbidden: &[EventKind] = match event.kind {
                EventKind::Touch => &[EventKind::Rest, EventKind::Release],
                EventKind::Stick => &[EventKind::Slip, EventKind::Release],
                EventKind::Slip => &[EventKind::Stick, EventKind::Release],
                EventKind::Release => &[EventKind::Touch, EventKind::Rest],
                _ => &[],
            };
            for kind in forbidden {
                assert!(!now.contains(kind), "{name}: {kind:?} then {event:?}");
            }
            assert!(matches!(
                event.what,
                What::Contact { .. } | What::Limit { .. }
            ));
        }
    }
}
