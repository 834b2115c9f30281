//! Boxes that fall into a bin, slide on a belt against a stop, and tip each other: the motion goes on to its end, parts overlap by no more than
//! bridges say, and energy never rises.

use core::fmt::Write;

use cspace_motion::{EventKind, Record, Status};
use cspace_oracle::is_long;

use crate::motion::helpers::{Dice, overlaps, thrown};

/// The scene moves to its end as bodies do.
#[track_caller]
fn goes_on(text: &str, time: f64) -> Record {
    let (simulation, record) = thrown(text, time, time / 20.0);
    assert_eq!(record.status, Status::Done, "{:?}: {text}", record.reason);
    let bridged = record.events.iter().filter_map(|e| e.bridge.as_ref());
    let overlap = bridged.map(|b| b.overlap).fold(0.0, f64::max);
    assert!(overlap <= 1e-5, "{overlap:e}: {text}");
    let found = overlaps(&simulation, &record, 2.0 * overlap);
    assert!(found.is_empty(), "{found:?}: {text}");
    let energy = record.energy.unwrap();
    let turned = energy.friction.abs() + energy.impacts + energy.drives.abs() + energy.start.abs();
    // Contacts and friction take, and never give.
    assert!(energy.friction >= -1e-6 * turned, "{energy:?}: {text}");
    assert!(energy.impacts >= -1e-6 * turned, "{energy:?}: {text}");
    assert!(
        energy.drift.abs() <= 1e-6 * turned.max(1.0),
        "{energy:?}: {text}"
    );
    record
}

fn part(text: &mut String, name: &str, keys: &str, corners: &[(f64, f64)]) {
    let corners: Vec<String> = corners
        .iter()
        .map(|(x, y)| format!("[{x:.4}, {y:.4}]"))
        .collect();
    let loops = corners.join(", ");
    write!(
        text,
        "[[part]]\nname = \"{name}\"\n{keys}\nloops = [[{loops}]]\n"
    )
    .unwrap();
}

fn rectangle(x: f64, y: f64, width: f64, height: f64) -> [(f64, f64); 4] {
    [
        (x, y),
        (x + width, y),
        (x + width, y + height),
        (x, y + height),
    ]
}

const FIXED: &str = "motion = { type = \"fixed\" }";
const BIN: [(f64, f64); 8] = [
    (-3.0, -1.0),
    (3.0, -1.0),
    (3.0, 12.0),
    (2.0, 12.0),
    (2.0, 0.0),
    (-2.0, 0.0),
    (-2.0, 12.0),
    (-3.0, 12.0),
];

/// Four boxes come to rest in a bin: two of them on the floor, and what lies on them.
#[test]
fn four_boxes_come_to_rest_in_a_bin() {
    let mut text = "gravity = [0, -9.81]\nfriction = 0.3\nrestitution = 0.2\n".to_owned();
    part(&mut text, "bin", FIXED, &BIN);
    let places = [(0.495, 0.7), (0.271, 1.8), (-0.607, 2.9), (-1.027, 4.0)];
    for (k, (x, y)) in places.into_iter().enumerate() {
        part(
            &mut text,
            &format!("b{k}"),
            "mass = 1",
            &rectangle(x, y, 0.8, 0.6),
        );
    }
    let record = goes_on(&text, 3.0);
    let rates = &record.samples.last().unwrap().rates;
    assert!(rates.iter().all(|v| v.abs() < 1e-6), "{rates:?}");
    // Several motions agree with friction there, and the event says which.
    let all = record.events.iter();
    let chosen: Vec<_> = all.filter(|e| e.kind == EventKind::Choice).collect();
    assert!(!chosen.is_empty());
    for event in chosen {
        let choice = event.choice.as_ref().unwrap();
        assert_eq!(choice.taken.len(), choice.contacts.len());
        assert!(!choice.others.is_empty() && !choice.others.contains(&choice.taken));
    }
}

/// Boxes of many sizes in a bin.
#[test]
fn boxes_fall_into_a_bin() {
    let tries = if is_long() { 60 } else { 4 };
    for seed in 0..tries {
        let mut dice = Dice(seed);
        let friction = dice.between(0.0, 0.7);
        let mut text = format!("gravity = [0, -9.81]\nfriction = {friction:.3}\n");
        part(&mut text, "bin", FIXED, &BIN);
        for k in 0..3 {
            let (width, height) = (dice.between(0.5, 1.1), dice.between(0.4, 0.9));
            let x = dice.between(-1.2, 0.2);
            let place = rectangle(x, 0.5 + 1.3 * f64::from(k), width, height);
            part(&mut text, &format!("b{k}"), "mass = 1", &place);
        }
        goes_on(&text, 1.5);
    }
}

/// Boxes on a belt are carried against a stop, and against each other.
#[test]
fn boxes_on_a_belt_meet_a_stop() {
    let tries = if is_long() { 60 } else { 6 };
    for seed in 0..tries {
        let mut dice = Dice(seed);
        let friction = dice.between(0.1, 0.7);
        let mut text = format!("gravity = [0, -9.81]\nfriction = {friction:.3}\n");
        let slides = "motion = { type = \"prismatic\", direction = [1, 0] }";
        part(
            &mut text,
            "belt",
            slides,
            &rectangle(-30.0, -1.0, 60.0, 1.0),
        );
        part(&mut text, "stop", FIXED, &rectangle(3.0, 0.01, 0.5, 2.0));
        for k in 0..2 {
            let side = dice.between(0.4, 0.9);
            part(
                &mut text,
                &format!("b{k}"),
                "mass = 1",
                &rectangle(1.5 * f64::from(k) - 3.0, 0.0, side, side),
            );
        }
        let rate = dice.between(0.5, 3.0);
        write!(text, "[[drive]]\npart = \"belt\"\nrate = {rate:.3}\n").unwrap();
        goes_on(&text, 4.0);
    }
}
