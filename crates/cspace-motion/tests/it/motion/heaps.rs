//! Boxes that fall into a bin, slide on a belt against a stop, and tip each other: the motion goes on to its end, parts overlap by no more than
//! bridges say, and energy never rises.

use core::f64::consts::{PI, TAU};
use core::fmt::Write;

use cspace_motion::{EventKind, Record, Sample, Status};
use cspace_oracle::{effort, is_long};

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
    let turned = turned.max(1.0);
    assert!(energy.friction >= -1e-6 * turned, "{energy:?}: {text}");
    assert!(energy.impacts >= -1e-6 * turned, "{energy:?}: {text}");
    assert!(energy.drift.abs() <= 1e-6 * turned, "{energy:?}: {text}");
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

/// Nothing moves in what stands on level ground.
#[track_caller]
fn stands(record: &Record) {
    for sample in &record.samples {
        let off = sample.coordinates.iter().map(|c| c.abs());
        assert!(off.fold(0.0, f64::max) < 1e-9, "{sample:?}");
    }
}

/// Ten boxes on each other, each a little smaller than the one below.
#[test]
fn a_stack_of_ten_stands() {
    let mut text = "gravity = [0, -9.81]\nfriction = 0.5\n".to_owned();
    part(&mut text, "floor", FIXED, &rectangle(-5.0, -1.0, 10.0, 1.0));
    let mut y = 0.0;
    for k in 0..10 {
        let (width, height) = (1.2 - 0.05 * f64::from(k), 0.3 + 0.02 * f64::from(k % 3));
        let place = rectangle(0.03 * f64::from(k % 2) - width / 2.0, y, width, height);
        part(&mut text, &format!("b{k}"), "mass = 1", &place);
        y += height;
    }
    stands(&goes_on(&text, 5.0));
}

/// A pyramid of ten boxes stands, and falls where what is under its middle is drawn away downwards.
#[test]
fn a_pyramid_falls_when_its_key_is_pulled() {
    let mut text = "gravity = [0, -9.81]\nfriction = 0.5\n".to_owned();
    part(&mut text, "left", FIXED, &rectangle(-5.0, -1.0, 3.97, 1.0));
    part(&mut text, "right", FIXED, &rectangle(1.03, -1.0, 3.97, 1.0));
    let slides = "motion = { type = \"prismatic\", direction = [0, -1] }";
    part(&mut text, "key", slides, &rectangle(-1.02, -0.4, 2.04, 0.4));
    let rows = (0..4_u8).flat_map(|row| (0..4 - row).map(move |k| (row, k)));
    for (row, k) in rows {
        let x = 1.05 * (f64::from(k) - 0.5 * f64::from(3 - row));
        let place = rectangle(x - 0.5, 0.6 * f64::from(row), 1.0, 0.6);
        part(&mut text, &format!("b{row}{k}"), "mass = 0.6", &place);
    }
    text += "[[drive]]\npart = \"key\"\n";
    stands(&goes_on(&format!("{text}rate = 0\n"), 0.5));
    let record = goes_on(&format!("{text}rate = 2\n"), 0.6);
    // The key has one coordinate, and the box at the top is the last of three each.
    let heights: Vec<f64> = (record.samples.last().unwrap().coordinates[1..].chunks(3))
        .map(|c| c[1])
        .collect();
    assert_eq!(heights.len(), 10);
    // What stands on the key comes to lie on it, the rest leans into the gap.
    for k in [1, 2, 5] {
        assert!((heights[k] + 1.2).abs() < 1e-9, "{heights:?}");
    }
    assert!(heights[9] < -0.01, "{heights:?}");
}

/// A body of a heap: its mass, its moment of inertia, and where its centre is drawn.
struct Body {
    mass: f64,
    inertia: f64,
    centre: [f64; 2],
}

/// The kinetic and the potential energy of bodies that are all that moves.
fn energy(bodies: &[Body], sample: &Sample) -> f64 {
    let states = sample.coordinates.chunks(3).zip(sample.rates.chunks(3));
    (bodies.iter().zip(states))
        .map(|(body, (q, v))| {
            let [x, y] = body.centre;
            let (sin, cos) = q[2].sin_cos();
            let arm = [cos * x - sin * y, sin * x + cos * y];
            let rate = [v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]];
            let moves = rate[0] * rate[0] + rate[1] * rate[1];
            let turns = body.inertia * v[2] * v[2];
            0.5 * (body.mass * moves + turns) + body.mass * 9.81 * (q[1] + arm[1])
        })
        .sum()
}

/// Triangles, squares, pentagons and discs of many sizes, five pairs of them above each other.
fn heap(seed: u64) -> (String, Vec<Body>) {
    let mut dice = Dice(seed);
    let friction = dice.between(0.2, 0.6);
    let mut text = format!("gravity = [0, -9.81]\nfriction = {friction:.3}\nrestitution = 0.2\n");
    part(&mut text, "bin", FIXED, &BIN);
    let mut bodies = Vec::new();
    for k in 0..10_u32 {
        let radius = dice.between(0.3, 0.5);
        let centre = [
            1.5 * f64::from(k % 2) - 0.75 + dice.between(-0.1, 0.1),
            0.6 + 1.05 * f64::from(k / 2),
        ];
        let (name, mass) = (format!("b{k}"), radius * radius);
        let keys = format!("mass = {mass}");
        let [x, y] = centre;
        let inertia = if k % 4 == 3 {
            let ends = [x - radius, x + radius].map(|x| format!("[{x}, {y}, 1]"));
            let loops = ends.join(", ");
            write!(
                text,
                "[[part]]\nname = \"{name}\"\n{keys}\nloops = [[{loops}]]\n"
            )
            .unwrap();
            0.5 * mass * radius * radius
        } else {
            let (sides, turned) = (3 + k % 3, dice.between(0.0, TAU));
            let corner = |i: u32| {
                let angle = turned + TAU * f64::from(i) / f64::from(sides);
                (x + radius * angle.cos(), y + radius * angle.sin())
            };
            let corners: Vec<(f64, f64)> = (0..sides).map(corner).collect();
            part(&mut text, &name, &keys, &corners);
            let half = (PI / f64::from(sides)).sin();
            0.5 * mass * radius * radius * (1.0 - 2.0 / 3.0 * half * half)
        };
        bodies.push(Body {
            mass,
            inertia,
            centre,
        });
    }
    (text, bodies)
}

/// Bodies of all kinds fall into a bin; given the time they come to rest. Energy is computed from outlines and samples, and never rises.
#[test]
fn ten_bodies_fall_on_a_heap() {
    for seed in 0..effort(1, 8) {
        let (text, bodies) = heap(seed);
        let record = goes_on(&text, effort(0.8, 4.0));
        let all: Vec<f64> = record.samples.iter().map(|s| energy(&bodies, s)).collect();
        let turned = all[0] - all[all.len() - 1];
        assert!(turned > 0.0, "{all:?}");
        for pair in all.windows(2) {
            // Corners are written to four digits.
            assert!(pair[1] <= pair[0] + 1e-3 * turned, "{seed}: {all:?}");
        }
        if is_long() {
            let rates = &record.samples.last().unwrap().rates;
            assert!(rates.iter().all(|v| v.abs() < 1e-6), "{seed}: {rates:?}");
        }
    }
}
