//! Random parts pushed about by a paddle: brute force judges every sample.

use cspace::{Part, Vertex};
use cspace_model::PartEntry;
use cspace_motion::Status;

use crate::motion::helpers::{Dice, driven, mechanism, run};

/// A convex part of lines and arcs about a centre.
fn pebble(dice: &mut Dice, name: &str, (x, y): (f64, f64)) -> Part {
    let n = 3 + (dice.roll() * 4.0) as usize;
    let size = dice.between(0.8, 1.4);
    let vertices = (0..n).map(|i| {
        let angle = std::f64::consts::TAU * (i as f64 + dice.between(-0.2, 0.2)) / n as f64;
        let bulge = if dice.roll() < 0.4 {
            dice.between(0.05, 0.2)
        } else {
            0.0
        };
        Vertex::new(x + size * angle.cos(), y + size * angle.sin(), bulge)
    });
    Part::new(name, vec![vertices.collect()]).unwrap()
}

fn scene(seed: u64) {
    let mut dice = Dice(seed);
    let paddle = Part::rectangle("paddle", (2.5, 0.0), 5.0, 0.6).unwrap();
    let mut parts = vec![PartEntry::revolute(paddle, (0.0, 0.0))];
    let places = [(3.0, 2.5), (-2.5, 3.5), (-4.0, -1.0)];
    for (i, place) in places.into_iter().enumerate() {
        let name = format!("pebble {i}");
        parts.push(PartEntry::planar(pebble(&mut dice, &name, place)));
    }
    parts.push(PartEntry::revolute(
        pebble(&mut dice, "knob", (0.5, -5.6)),
        (0.4, -5.8),
    ));
    let (_, record) = run(&driven(mechanism(parts), 0, 1.0), 12.0, 0.05);
    let last = record.samples.last().unwrap();
    if std::env::var("SHOW").is_ok() {
        eprintln!(
            "{seed}: {:?} {} {} events {:?}",
            record.status,
            record.until,
            record.events.len(),
            record.reason
        );
    }
    assert_ne!(
        record.status,
        Status::Undetermined,
        "{seed}: {:?} at {}",
        record.reason,
        last.t
    );
}

#[test]
fn pebbles_are_pushed_about() {
    (0..6).for_each(scene);
}

#[test]
#[ignore = "some minutes"]
fn many_pebbles_are_pushed_about() {
    (100..300).for_each(scene);
}
