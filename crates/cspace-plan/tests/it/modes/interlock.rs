//! Interlocks: rails that a plunger between them lets move one at a time, and the lengths of the plunger at which that changes.

use cspace::{Axis, Part, Vector, Vertex};
use cspace_model::{Mechanism, PartEntry};
use cspace_plan::modes::{ModePlace, Modes, TreeModes};

const GAP: f64 = 10.0;
const DEPTH: f64 = 2.0;
const TRAVEL: f64 = 12.0;

/// A rail above (1) or below (−1) the plunger, with notches of 45 degrees at some places.
fn rail(name: &str, side: f64, notches: &[f64]) -> Part {
    let mut points = vec![(-60.0, GAP / 2.0)];
    for at in notches {
        let mouth = [
            (at - 5.0, GAP / 2.0),
            (at - 5.0 + DEPTH, GAP / 2.0 + DEPTH),
            (at + 5.0 - DEPTH, GAP / 2.0 + DEPTH),
            (at + 5.0, GAP / 2.0),
        ];
        points.extend(mouth);
    }
    points.extend([
        (60.0, GAP / 2.0),
        (60.0, GAP / 2.0 + 8.0),
        (-60.0, GAP / 2.0 + 8.0),
    ]);
    let vertices = points
        .iter()
        .map(|&(x, y)| Vertex::line(x, side * y))
        .collect();
    Part::new(name, vec![vertices]).unwrap()
}

fn plunger(length: f64) -> Part {
    let (half, tip, side) = (length / 2.0, 4.9 - DEPTH, 4.9);
    let corners = [(tip, half), (side, half - DEPTH)];
    let upper = corners.iter().map(|&(x, y)| (x, y));
    let mut points: Vec<(f64, f64)> = vec![];
    points.extend(upper.clone().map(|(x, y)| (x, -y)));
    points.extend(upper.clone().rev());
    points.extend(upper.clone().map(|(x, y)| (-x, y)));
    points.extend(upper.rev().map(|(x, y)| (-x, -y)));
    let vertices = points.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new("plunger", vec![vertices]).unwrap()
}

fn interlock(length: f64, notches: [&[f64]; 2]) -> Mechanism {
    let mut mechanism = Mechanism::new("interlock");
    let along = Axis::prismatic(Vector::new(1.0, 0.0)).within(-TRAVEL, TRAVEL);
    let across = Axis::prismatic(Vector::new(0.0, 1.0)).within(-4.0, 4.0);
    mechanism.parts = vec![
        PartEntry::on(rail("first", 1.0, notches[0]), along),
        PartEntry::on(plunger(length), across),
        PartEntry::on(rail("second", -1.0, notches[1]), along),
    ];
    mechanism.pairs = mechanism.every_two();
    mechanism
}

fn place(modes: &Modes, at: [f64; 3]) -> ModePlace {
    modes.locate(at).unwrap()
}

#[test]
fn one_rail_moves_while_the_other_is_in_neutral() {
    let modes = Modes::compute(&interlock(11.9, [&[0.0], &[0.0]]), [0, 1, 2]).unwrap();
    assert_eq!(modes.list().len(), 1);
    let drawn = place(&modes, [0.0; 3]);
    assert_eq!(drawn, ModePlace::Mode(0));
    assert_eq!(place(&modes, [10.0, -1.0, 0.0]), drawn);
    assert_eq!(place(&modes, [0.0, 1.0, -10.0]), drawn);
    for v in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        assert!(matches!(
            place(&modes, [10.0, v, 10.0]),
            ModePlace::Blocked(_)
        ));
    }
    // In its notch the plunger has (gap + 2 depth - length) / 2 either way.
    let v = modes.list()[0].ranges[1];
    assert!(
        (v.0 + 1.05).abs() < 1e-8 && (v.1 - 1.05).abs() < 1e-8,
        "{v:?}"
    );
}

/// With three notches in each rail the plunger blocks both rails when it is in a notch of both, which gives nine modes,
/// unless it is shorter than the gap and one depth: then one rail moves while the other is in any of its notches.
#[test]
fn modes_merge_at_the_length_of_gap_and_depth() {
    let notches: [&[f64]; 2] = [&[-11.0, 0.0, 11.0]; 2];
    let size = 60.0;
    // The rails do not touch each other: the other method, for trees, has the same modes.
    let as_tree = |length: f64| {
        let tree = TreeModes::compute(&interlock(length, notches), &[0, 1, 2]);
        tree.unwrap().list().len()
    };
    assert_eq!(as_tree(GAP + DEPTH), 9);
    for play in [0.1, 1e-3, 1e-6 * size, 1e-9 * size] {
        let modes = |length: f64| Modes::compute(&interlock(length, notches), [0, 1, 2]).unwrap();
        let tree = (as_tree(GAP + DEPTH - play), as_tree(GAP + DEPTH + play));
        assert_eq!(tree, (1, 9), "{play}");
        let (shorter, longer) = (modes(GAP + DEPTH - play), modes(GAP + DEPTH + play));
        assert_eq!(
            (shorter.list().len(), longer.list().len()),
            (1, 9),
            "{play}"
        );
        assert_eq!((shorter.doubts(), longer.doubts()), (0, 0));
    }
    // What exactly fits is blocked.
    let exact = Modes::compute(&interlock(GAP + DEPTH, notches), [0, 1, 2]).unwrap();
    assert_eq!(exact.list().len(), 9);
    // And shorter than the gap it holds nothing.
    let free = Modes::compute(&interlock(GAP - 1e-6, notches), [0, 1, 2]).unwrap();
    assert_eq!(place(&free, [5.5, 0.0, 5.5]), ModePlace::Mode(0));
    let held = Modes::compute(&interlock(GAP + 1e-6, notches), [0, 1, 2]).unwrap();
    assert!(matches!(
        place(&held, [5.5, 0.0, 5.5]),
        ModePlace::Blocked(_)
    ));
}
