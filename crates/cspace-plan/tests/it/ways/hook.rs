//! Hooks out of an eye, by formulas.
//!
//! The eye is a bar of width 2 ρ around a chamber, with round ends, the lips, `GAP` apart on the line y = 0. The hook is a
//! stem, a bend of a quarter of a turn and a foot. It leaves by the stem, then turns about the left lip, then draws the foot
//! through the gap.

use core::f64::consts::{FRAC_PI_2, SQRT_2};

use cspace::{Coordinates, Part, Vertex};
use cspace_oracle::shapes::bulge_of;
use cspace_plan::Clearance;

use crate::ways::thresholds::{asked, at, passes_up_to, space};

/// The distance of the lips.
const GAP: f64 = 1.0;
/// Their radius, half the width of the eye's bar.
const LIP: f64 = 0.5;
/// The length of stem and foot.
const ARM: f64 = 3.0;

/// Anyhow in the chamber, and outside. Stem and foot are drawn upwards and to the left.
pub(crate) const ENDS: [(f64, f64, f64); 2] = [(1.0, -5.0, 2.0), (0.5, 8.0, 0.4)];

fn ends() -> (Coordinates, Coordinates) {
    let [from, to] = ENDS.map(|(x, y, theta)| at(x, y, theta));
    (from, to)
}

/// The eye with lips of a radius, so far apart.
pub(crate) fn eye(gap: f64, radius: f64) -> Part {
    let (half, depth, bar) = (7.0, 9.0, 2.0 * radius);
    let lip = 0.5 * gap + radius;
    let outline = vec![
        Vertex::line(-lip, radius),
        Vertex::line(-half - bar, radius),
        Vertex::line(-half - bar, -depth - bar),
        Vertex::line(half + bar, -depth - bar),
        Vertex::line(half + bar, radius),
        Vertex::new(lip, radius, 1.0),
        Vertex::line(lip, -radius),
        Vertex::line(half, -radius),
        Vertex::line(half, -depth),
        Vertex::line(-half, -depth),
        Vertex::line(-half, -radius),
        Vertex::new(-lip, -radius, 1.0),
    ];
    Part::new("eye", vec![outline]).unwrap()
}

/// A hook of a thickness, drawn about the centre of its bend, whose inner radius may be 0.
pub(crate) fn hook(thickness: f64, inner: f64) -> Part {
    let (outer, quarter) = (inner + thickness, bulge_of(FRAC_PI_2));
    let mut outline = vec![
        Vertex::line(-ARM, -outer),
        Vertex::new(0.0, -outer, quarter),
        Vertex::line(outer, 0.0),
        Vertex::line(outer, ARM),
        Vertex::line(inner, ARM),
    ];
    if inner > 0.0 {
        outline.push(Vertex::new(inner, 0.0, -quarter));
    }
    outline.extend([Vertex::line(0.0, -inner), Vertex::line(-ARM, -inner)]);
    Part::new("hook", vec![outline]).unwrap()
}

#[test]
#[ignore = "long: seconds"]
fn a_hook_with_a_round_bend_leaves_an_eye_up_to_its_thickness() {
    // A disc as wide as the hook is thick, t, lies in its bend. On the way out its centre comes to the line y = 0, where the eye
    // leaves nothing free but the gap g, and there it is t wide: t ≤ g. With t < g the hook goes with (g − t)/2 to spare on
    // both sides: stem, bend and foot are t thick, and the lip fits into the bend, whose inner radius is larger.
    let inner = 0.8;
    assert!(inner > LIP);
    passes_up_to(GAP, ends(), |thickness| {
        (eye(GAP, LIP), hook(thickness, inner))
    });
}

#[test]
#[ignore = "long: seconds"]
fn a_hook_with_a_sharp_notch_leaves_an_eye_up_to_the_formula() {
    // The notch is a right angle with its corner at K, the outer side of the bend an arc of radius t about K. Let A and B be the
    // centres of the lips, ρ their radius, and d the direction from K that halves the notch. Before the bend is in the gap the
    // lip at B is beside one arm, and after it beside the other, so in between B is at K − b d. It is outside the bend:
    // b ≥ t + ρ. The lip at A is inside the notch, at least ρ from both its sides: (A − K)·d ≥ √2 ρ. Together
    // |A − B| ≥ (A − B)·d ≥ √2 ρ + t + ρ, and |A − B| = g + 2 ρ, so t ≤ g − (√2 − 1) ρ.
    // If it is less, the hook goes: with the lip at A in the notch K is √2 ρ from A in some direction, and nearest to B if
    // that is towards B, where b = g + 2 ρ − √2 ρ > t + ρ.
    let threshold = GAP - (SQRT_2 - 1.0) * LIP;
    passes_up_to(threshold, ends(), |thickness| {
        (eye(GAP, LIP), hook(thickness, 0.0))
    });
}

#[test]
fn the_widest_way_out_of_an_eye_is_as_wide_as_the_formula_says() {
    // With c of clearance the lips and the outside of the bend are grown by c, and so is the lip in the notch:
    // √2 (ρ + c) + (t + c) + ρ = g + 2 ρ.
    let thickness = 0.7;
    let widest = (GAP + LIP - SQRT_2 * LIP - thickness) / (SQRT_2 + 1.0);
    let space = space(&eye(GAP, LIP), &hook(thickness, 0.0), None);
    let (from, to) = ends();
    let bottleneck = asked(&space, from, to, Clearance::Widest)
        .bottleneck
        .unwrap();
    let (found, most) = (bottleneck.narrow.clearance, bottleneck.most.unwrap());
    assert!((found - widest).abs() < 1e-8, "{found} {widest}");
    assert!((most - widest).abs() < 1e-8, "{most} {widest}");
}
