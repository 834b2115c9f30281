//! Trains of gears: how many modes there are, and by what turns they come back, is arithmetic.
//!
//! Gears with a, b and c teeth that mesh in a row turn by a u + b v = const and b v + c w = const, each modulo a turn. On the torus
//! of (u, v, w) these are gcd(ab, ac, bc) closed curves. Where the first and the last mesh, too, they are 2abc points.

use core::f64::consts::TAU;

use cspace::{Part, Point, Vector, Vertex};
use cspace_model::{Mechanism, PartEntry};
use cspace_plan::modes::{ModePlace, Modes};

/// The gear (12 teeth, about the origin) and the pinion (10 teeth, about (44, 0)) of a model that is drawn with its shafts.
fn drawn() -> [Part; 2] {
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../models/gears_on_shafts.toml"
    );
    let cspace_model::Document::Model(model) =
        cspace_model::read(std::path::Path::new(file)).unwrap()
    else {
        unreachable!()
    };
    let part = |i: usize| model.mechanism.parts[i].part.clone();
    [part(0), part(1)]
}

/// A part with another name, moved.
fn moved(part: &Part, name: &str, by: Vector) -> Part {
    let vertex = |v: &Vertex| Vertex::new(v.x + by.x, v.y + by.y, v.bulge);
    let loops = part.loops().iter();
    let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
    Part::new(name, loops.collect()).unwrap()
}

fn train(last: Point) -> Mechanism {
    let [gear, pinion] = drawn();
    let mut mechanism = Mechanism::new("train");
    let third = moved(&gear, "third", last.to_vector());
    mechanism.parts = vec![
        PartEntry::revolute(gear, (0.0, 0.0)),
        PartEntry::revolute(pinion, (44.0, 0.0)),
        PartEntry::revolute(third, last),
    ];
    mechanism.pairs = mechanism.every_two();
    mechanism
}

#[test]
fn gears_in_a_row_turn_together() {
    let mechanism = train(Point::new(88.0, 0.0));
    for parts in [[0, 1, 2], [2, 0, 1]] {
        let modes = Modes::compute(&mechanism, parts).unwrap();
        // gcd(12 * 10, 12 * 12, 10 * 12)
        assert_eq!((modes.list().len(), modes.doubts()), (24, 0));
        for (k, mode) in modes.list().iter().enumerate() {
            let of = |part: usize| parts.iter().position(|&p| p == part).unwrap();
            let turns: Vec<[i64; 3]> = (mode.turns.iter())
                .map(|t| [0, 1, 2].map(|part| t[of(part)]))
                .collect();
            let turns = turns[0].map(|t| t * turns[0][0].signum());
            assert_eq!((turns, mode.turns.len()), ([5, -6, 5], 1));
            // A tooth further, all three: the train turns. The first gear alone: another of the modes.
            let by = |teeth: [f64; 3]| {
                let mut at = mode.sample;
                at[of(0)] += TAU * teeth[0] / 12.0;
                at[of(1)] -= TAU * teeth[1] / 10.0;
                at[of(2)] += TAU * teeth[2] / 12.0;
                modes.locate(at).unwrap()
            };
            assert_eq!(by([1.0; 3]), ModePlace::Mode(k));
            let other = by([1.0, 0.0, 0.0]);
            assert!(matches!(other, ModePlace::Mode(_)) && other != ModePlace::Mode(k));
        }
    }
}

#[test]
fn gears_in_a_triangle_are_locked() {
    // 44 from the pinion's shaft and 48 from the gear's.
    let x = (48.0_f64.powi(2)) / (2.0 * 44.0);
    let last = Point::new(x, (48.0_f64.powi(2) - x * x).sqrt());
    let modes = Modes::compute(&train(last), [0, 1, 2]).unwrap();
    assert_eq!((modes.list().len(), modes.doubts()), (2 * 12 * 10 * 12, 0));
    assert!(modes.list().iter().all(|m| m.turns.is_empty()));
}

/// A turn of the driver takes the wheel of six slots on by a sixth; a third part that meets neither turns by itself.
#[test]
fn a_geneva_drive_comes_back_after_six_turns_of_its_driver() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/geneva.toml");
    let cspace_model::Document::Model(model) =
        cspace_model::read(std::path::Path::new(file)).unwrap()
    else {
        unreachable!()
    };
    let mut mechanism = model.mechanism;
    let knob = Part::rectangle("knob", (500.0, 0.0), 20.0, 5.0).unwrap();
    let knob = PartEntry::revolute(knob, (500.0, 0.0));
    mechanism.parts.push(knob);
    let knob = mechanism.parts.len() - 1;
    let index = |name: &str| mechanism.part_index(name).unwrap();
    let modes = Modes::compute(&mechanism, [index("wheel"), index("driver"), knob]).unwrap();
    assert_eq!((modes.list().len(), modes.doubts()), (1, 0));
    let turns = &modes.list()[0].turns;
    assert_eq!(turns.len(), 2);
    assert_eq!((turns[0][0], turns[0][1].abs(), turns[0][2]), (1, 6, 0));
    assert_eq!(turns[1], [0, 0, 1]);
}
