//! How far two flat arcs are apart.
//!
//! Two lines are nearest at an end of one of them, which is a piece of its own. Two arcs may have a common normal between their ends,
//! but only while their tangents are all but parallel. Then the distance of the two, ends included, is found at the middle of the
//! interval; over the interval it changes no faster than their points move relative to each other.
//!
//! In the frame of the first arc, with W from its middle to that of the second, whose tangent is turned by φ, the centres are along
//!
//! ```text
//! E = k₁ k₂ W + σ k₁ (cos φ n − sin φ t) − k₂ n,   σ = ±1: the normals agree or oppose each other
//! ```
//!
//! and the common normal is u = cos ψ n − sin ψ t, parallel to E. The distance along it is
//!
//! ```text
//! u·W + σ (cos (φ − ψ) − 1) / k₂ − (cos ψ − 1) / k₁
//! ```

use cspace::Point;

use super::apart::{Apart, ROUNDING};
use super::flat::Flat;
use super::pose::Placed;

/// A common normal of two flat arcs, in the frame of the first.
#[derive(Debug, Clone, Copy)]
pub(super) struct Common {
    /// The signed distance along the normal, positive if the second is to the left of the first.
    pub(super) gap: f64,
    /// Where it meets the two, along their chords.
    pub(super) feet: (f64, f64),
}

/// The second arc in the frame of the first.
fn brought((a, _): (&Placed, &Flat), (b, other): (&Placed, &Flat)) -> Flat {
    let turn = a.turn.inverse();
    Flat {
        middle: a.back(b.point(other.middle).at),
        along: turn * (b.turn * other.along),
        ..*other
    }
}

/// The sign of the second arc's normal along the first's, and the angle from the one to the other.
fn angle(first: &Flat, second: &Flat) -> (f64, f64) {
    let sign = if first.along.dot(second.along) < 0.0 {
        -1.0
    } else {
        1.0
    };
    (
        sign,
        (first.along.cross(second.along * sign))
            .clamp(-1.0, 1.0)
            .asin(),
    )
}

/// The common normal of two arcs in one frame, if there is one between their ends.
pub(super) fn common(first: &Flat, second: &Flat) -> Option<Common> {
    let (sign, phi) = angle(first, second);
    let (k, l) = (first.curvature, second.curvature);
    let (t, n) = (first.along, first.along.left());
    let w = second.middle - first.middle;
    let along_n = k * l * w.dot(n) + sign * k * phi.cos() - l;
    let along_t = k * l * w.dot(t) - sign * k * phi.sin();
    if along_n == 0.0 {
        return None;
    }
    let psi = (-along_t / along_n).atan();
    let u = n * psi.cos() - t * psi.sin();
    // cos x − 1, without subtracting.
    let less = |x: f64| -2.0 * (0.5 * x).sin().powi(2);
    let over = |c: f64, k: f64| if k == 0.0 { 0.0 } else { c / k };
    let gap = u.dot(w) + sign * over(less(phi - psi), l) - over(less(psi), k);
    // Of a line the foot is that of the other's.
    let (x, y);
    if k == 0.0 {
        y = sign * (psi - phi).sin() / l;
        x = (second.point(y) - first.middle).dot(t);
    } else {
        x = psi.sin() / k;
        y = if l == 0.0 {
            (first.point(x) - second.middle).dot(second.along)
        } else {
            sign * (psi - phi).sin() / l
        };
    }
    (first.has(x, ROUNDING) && second.has(y, ROUNDING)).then_some(Common { gap, feet: (x, y) })
}

/// The distance of two arcs in one frame, 0 where they cross, and that along a common normal.
fn distance(first: &Flat, second: &Flat) -> (f64, f64) {
    let (sign, _) = angle(first, second);
    let between = common(first, second).map(|c| c.gap);
    let mut gaps: Vec<f64> = between.into_iter().collect();
    for end in second.ends() {
        let seen = first.seen(end);
        if first.has(seen.foot, ROUNDING) {
            gaps.push(seen.height);
        }
    }
    for end in first.ends() {
        let seen = second.seen(end);
        if second.has(seen.foot, ROUNDING) {
            gaps.push(-sign * seen.height);
        }
    }
    let crosses = gaps.iter().any(|&g| g > 0.0) && gaps.iter().any(|&g| g < 0.0);
    if crosses {
        return (0.0, 0.0);
    }
    let ends = (first.ends().iter())
        .flat_map(|p: &Point| second.ends().map(|q| p.distance(q)))
        .fold(f64::INFINITY, f64::min);
    let nearest = gaps.iter().map(|g| g.abs()).fold(ends, f64::min);
    (nearest, between.map_or(f64::INFINITY, f64::abs))
}

/// Bounds of the distance of two flat arcs over an interval, beside that at their ends.
pub(super) fn flats(a: (&Placed, &Flat), b: (&Placed, &Flat), half: f64) -> Apart {
    if a.1.curvature == 0.0 && b.1.curvature == 0.0 {
        return Apart::NONE;
    }
    let second = brought(a, b);
    let (_, phi) = angle(a.1, &second);
    let turning = (b.0.turning - a.0.turning).abs() * half;
    // Angles are as certain as the ends of the arcs.
    let parallel = (a.1.turn() + second.turn()) * (1.0 + ROUNDING) + f64::EPSILON;
    if phi.abs() > parallel + turning {
        return Apart::NONE;
    }
    let (nearest, here) = distance(a.1, &second);
    let here = if phi.abs() > parallel {
        f64::INFINITY
    } else {
        here
    };
    // No point of the second arc moves faster in the frame of the first.
    let moved = a.0.seen(b.0.point(b.1.middle), half);
    let speed = moved.velocity.length()
        + moved.bend * half
        + 2.0 * b.1.half * (b.0.turning - a.0.turning).abs();
    Apart {
        least: (nearest - speed * half).max(0.0),
        here,
    }
}

/// A common normal of two arcs in the frame of the assembly: the points where it meets them.
pub(super) fn common_points(a: (&Placed, &Flat), b: (&Placed, &Flat)) -> Option<(Point, Point)> {
    if a.1.curvature == 0.0 && b.1.curvature == 0.0 {
        return None;
    }
    let second = brought(a, b);
    let found = common(a.1, &second)?;
    let p = a.0.point(a.1.point(found.feet.0)).at;
    let q = b.0.point(b.1.point(found.feet.1)).at;
    Some((p, q))
}

/// Whether two flat arcs cross.
pub(super) fn cross(a: (&Placed, &Flat), b: (&Placed, &Flat)) -> bool {
    let second = brought(a, b);
    let first = a.1;
    // Each has points on both sides of the other, or they bow through each other between their ends.
    let sides = |one: &Flat, other: &Flat| -> f64 {
        let [p, q] = other.ends().map(|e| one.seen(e).height);
        p * q
    };
    if sides(first, &second) < 0.0 && sides(&second, first) < 0.0 {
        return true;
    }
    (first.curvature != 0.0 || second.curvature != 0.0)
        && common(first, &second).is_some()
        && distance(first, &second).0 == 0.0
}
