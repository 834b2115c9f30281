//! Parts that are symmetric about their pivots are computed in one period of their motion and copied. With limits a full turn apart, the
//! pair is computed over all of it without symmetry; every answer must be equal.

use core::f64::consts::TAU;

use cspace::fixed_axes::{AxisMotion, BranchForm, FixedAxesSpace};
use cspace::{Axis, FeatureName, Part, PatchId, Point, Vertex};
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, mechanisms};
use cspace_oracle::shapes::{circle, gear, shifted};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn compute(m: &Mechanism) -> FixedAxesSpace {
    FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap()
}

fn unlimited(axis: &Axis) -> bool {
    axis.range.is_none() && matches!(axis.motion, AxisMotion::Revolute { .. })
}

/// The pair computed without symmetry: every turn has limits.
fn whole(m: &Mechanism) -> FixedAxesSpace {
    let limited = |axis: Axis| {
        if unlimited(&axis) {
            axis.within(0.0, TAU)
        } else {
            axis
        }
    };
    compute(&Mechanism {
        fixed_axis: limited(m.fixed_axis),
        moving_axis: limited(m.moving_axis),
        ..m.clone()
    })
}

fn names(s: &FixedAxesSpace) -> Vec<(FeatureName, FeatureName)> {
    let mut names: Vec<_> = s.patches().iter().map(|p| (p.fixed, p.moving)).collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// Total lengths of all contact curves along u and along v: contact at the limits is not a curve.
fn length(s: &FixedAxesSpace) -> f64 {
    (s.branches().iter())
        .map(|b| (b.end.0 - b.start.0).abs() + (b.end.1 - b.start.1).abs())
        .sum()
}

/// Compares the space of a mechanism with that computed without symmetry.
fn compare(m: &Mechanism) -> (FixedAxesSpace, FixedAxesSpace) {
    let (copied, whole) = (compute(m), whole(m));
    assert_eq!(names(&copied), names(&whole), "{}", m.name);
    let (a, b) = (length(&copied), length(&whole));
    assert!((a - b).abs() < 1e-6 * (1.0 + a), "{}: {a} {b}", m.name);
    let mut rng = ChaCha8Rng::seed_from_u64(17);
    let mut coordinate = |axis: &Axis| match (axis.motion, axis.range) {
        (AxisMotion::Fixed, _) => 0.0,
        (_, Some((lo, hi))) => rng.random_range(lo..hi),
        (AxisMotion::Revolute { .. }, None) => rng.random_range(0.0..TAU),
        (AxisMotion::Prismatic { .. }, None) => rng.random_range(-6.0..6.0),
    };
    for _ in 0..500 {
        let (u, v) = (coordinate(&m.fixed_axis), coordinate(&m.moving_axis));
        let (a, b) = (copied.classify(u, v), whole.classify(u, v));
        assert_eq!(a, b, "{}: {u} {v}", m.name);
    }
    // The curves are equal, with equal features, at the places of the others.
    let turned = |axis: &Axis, t: f64| {
        if unlimited(axis) {
            t.rem_euclid(TAU)
        } else {
            t
        }
    };
    for (i, b) in copied.branches().iter().enumerate().step_by(5) {
        let middle = match b.form {
            BranchForm::VOfU => 0.5 * (b.start.0 + b.end.0),
            BranchForm::UOfV => 0.5 * (b.start.1 + b.end.1),
        };
        let ((u, v), _) = copied.branch_at(i, middle).unwrap();
        let (u, v) = (turned(&m.fixed_axis, u), turned(&m.moving_axis, v));
        let patch = &copied.patches()[b.patch.index()];
        let named = |p: PatchId| {
            let p = &whole.patches()[p.index()];
            (p.fixed, p.moving) == (patch.fixed, patch.moving)
        };
        let there = whole.contacts(u, v, 1e-9 + copied.resolution());
        assert!(
            there.iter().any(|t| named(t.0)),
            "{}: {patch:?} at {u} {v}: {there:?}",
            m.name
        );
    }
    (copied, whole)
}

#[test]
fn mechanisms_are_the_same_without_symmetry() {
    let turning = |m: &Mechanism| unlimited(&m.fixed_axis) || unlimited(&m.moving_axis);
    let mut copies = 0;
    for m in mechanisms().iter().filter(|m| turning(m)) {
        let (copied, whole) = compare(m);
        // The number of overlap tests shows that symmetry was used.
        let (a, b) = (copied.statistics().tests, whole.statistics().tests);
        copies += usize::from(4 * a < b);
    }
    assert!(copies >= 6, "{copies}");
}

/// A drawing's coordinates are rounded: the part computed is the nearest symmetric one, and the resolution includes the deviation.
#[test]
fn a_drawing_with_nine_digits_is_symmetric_enough() {
    let m = gears(10, 9);
    let rounded = |part: &Part| {
        let digits = |t: f64| (t * 1e9).round() / 1e9;
        let vertex = |v: &Vertex| Vertex::new(digits(v.x), digits(v.y), digits(v.bulge));
        let loops = part.loops().iter();
        let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
        Part::new(part.name(), loops.collect()).unwrap()
    };
    let m = Mechanism {
        fixed: rounded(&m.fixed),
        moving: rounded(&m.moving),
        ..m
    };
    let (copied, whole) = compare(&m);
    assert!(4 * copied.statistics().tests < whole.statistics().tests);
    assert!(copied.resolution() > whole.resolution() + 1e-11);
    assert!(copied.resolution() < whole.resolution() + 1e-8);
}

/// A bore of two half circles about the pivot does not break the symmetry of a wheel, and its contact is reported with the two arcs as
/// drawn. A pin in it swings about another pivot.
#[test]
fn a_bore_of_two_half_circles_is_no_hindrance() {
    let wheel = gear(10, 1.0);
    let mut loops: Vec<Vec<Vertex>> = wheel
        .loops()
        .iter()
        .map(|l| l.vertices().to_vec())
        .collect();
    loops.push(vec![
        Vertex::new(2.0, 0.0, 1.0),
        Vertex::new(-2.0, 0.0, 1.0),
    ]);
    let m = Mechanism {
        name: "pin in a bore".into(),
        fixed: Part::new("wheel", loops).unwrap(),
        fixed_axis: Axis::revolute(Point::new(0.0, 0.0)),
        moving: shifted(&circle(0.5), 1.0, 0.0),
        moving_axis: Axis::revolute(Point::new(0.0, 1.0)),
    };
    let (copied, _) = compare(&m);
    let arcs: Vec<u32> = copied.patches().iter().map(|p| p.fixed.index).collect();
    assert!(arcs.contains(&0) && arcs.contains(&1), "{arcs:?}");
    // Two arcs touch two half circles of the pin, at the entry and at the exit, once or twice each.
    assert!(arcs.len() <= 16, "{}", arcs.len());
}

/// A part whose pivot is not its centre does not repeat itself, however small the distance.
#[test]
fn a_pivot_off_the_centre_is_not_taken_for_it() {
    let m = gears(10, 9);
    for aside in [1e-3, 1e-6, 1e-7] {
        let off = Mechanism {
            fixed_axis: Axis::revolute(Point::new(aside, 0.0)),
            moving_axis: Axis::revolute(Point::new(9.55 + aside, 0.0)),
            ..m.clone()
        };
        // Neither gear may count as symmetric: the other one's pivot is displaced as well.
        let (copied, whole) = compare(&off);
        assert_eq!(copied.resolution(), whole.resolution());
    }
}
