//! Modes whose number is known by arithmetic.

use cspace::{Axis, Part, Vector};
use cspace_model::{Mechanism, PartEntry};
use cspace_plan::modes::Modes;

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

/// Coloured configurations in the plane of two blocks are those where the third one has room in the order of the mode,
/// and none is blocked.
#[test]
fn shadows_are_where_the_third_block_has_room() {
    const REACH: f64 = 10.0;
    const FIELDS: usize = 101;
    let block = |name: &str| {
        let part = Part::rectangle(name, (0.0, 0.0), 2.0, 2.0).unwrap();
        (part, slide(1.0, 0.0, REACH))
    };
    let blocks = mechanism(vec![block("a"), block("b"), block("c")]);
    let modes = Modes::compute(&blocks, [0, 1, 2]).unwrap();
    assert_eq!(modes.list().len(), 6);
    let width = 2.0 * REACH / FIELDS as f64;
    let center = |k: usize| -REACH + width * (k as f64 + 0.5);
    // The third coordinate that is farthest from the others in the order of a mode, or how far it is from having room.
    let room = |order: [usize; 3], known: [(usize, f64); 2], third: usize| {
        let place = |part: usize| order.iter().position(|&p| p == part).unwrap();
        let (mut lo, mut hi) = (-REACH, REACH);
        let [(p, x), (q, y)] = known;
        for (part, at) in known {
            let apart = 2.0 * (place(third) as f64 - place(part) as f64).abs().min(1.0);
            if place(part) < place(third) {
                lo = lo.max(at + apart);
            } else {
                hi = hi.min(at - apart);
            }
        }
        let gap = if place(p) < place(q) { y - x } else { x - y };
        (hi - lo).min(gap - 2.0)
    };
    for (mode, found) in modes.list().iter().enumerate() {
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| found.sample[a].total_cmp(&found.sample[b]));
        for (pair, [first, second]) in [[0, 1], [1, 2], [0, 2]].into_iter().enumerate() {
            let window = [(-REACH, REACH), (-REACH, REACH)];
            let shadow = modes.shadow(mode, pair, window, [FIELDS, FIELDS]);
            let mut coloured = 0;
            for i in 0..FIELDS {
                for j in 0..FIELDS {
                    let third = 3 - first - second;
                    let known = [(first, center(i)), (second, center(j))];
                    let room = room(order, known, third);
                    let is_reached = shadow.reached[i * FIELDS + j];
                    coloured += usize::from(is_reached);
                    // Of fields at the boundary either is right.
                    if room.abs() > 2.0 * width {
                        assert_eq!(is_reached, room > 0.0, "{order:?} {known:?} {room}");
                    }
                }
            }
            assert!(coloured > 1000, "{coloured}");
        }
    }
}
