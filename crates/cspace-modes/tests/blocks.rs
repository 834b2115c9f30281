//! Modes whose number is known by arithmetic.
#![allow(clippy::unwrap_used)]

use cspace::mechanism::{Mechanism, PartEntry};
use cspace::{Axis, Part, Vector};
use cspace_modes::Modes;

fn slide(x: f64, y: f64, reach: f64) -> Axis {
    Axis::prismatic(Vector::new(x, y)).within(-reach, reach)
}

fn mechanism(parts: Vec<(Part, Axis)>) -> Mechanism {
    let mut mechanism = Mechanism::new("test");
    mechanism.parts = (parts.into_iter())
        .map(|(part, axis)| PartEntry::on(part, axis))
        .collect();
    mechanism.pairs = mechanism.every_two();
    mechanism
}

/// Three blocks on one rail, drawn 4 apart and 2 long, each with the same range ±r: each order is a mode if there is room for it.
/// The middle block changes places with either other one where r > 1 + 2. The outer two are 8 apart, so they change places where
/// 2r > 8 + 2, and with the middle block between them where 2r > 8 + 4. Where r is just so, what exactly fits is blocked.
#[test]
fn blocks_on_a_rail_keep_their_order() {
    for (reach, expected) in [
        (20.0, 6),
        (6.5, 6),
        (6.0 + 1e-9, 6),
        (6.0 - 1e-9, 5),
        (6.0, 5),
        (5.0 + 1e-9, 5),
        (5.0, 3),
        (4.5, 3),
    ] {
        let block = |name: &str, x: f64| {
            let part = Part::rectangle(name, (x, 0.0), 2.0, 2.0).unwrap();
            (part, slide(1.0, 0.0, reach))
        };
        let blocks = mechanism(vec![block("a", -4.0), block("b", 0.0), block("c", 4.0)]);
        let modes = Modes::compute(&blocks, [0, 1, 2]).unwrap();
        assert_eq!(modes.list().len(), expected, "{reach}");
    }
}
