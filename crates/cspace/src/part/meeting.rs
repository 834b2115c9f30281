//! Where two edges that share no vertex meet.

use crate::geometry::{Point, Vector};

use super::Edge;

/// Halvings that locate a crossing; 2⁻⁶⁰ of an edge is below the rounding of its points.
const HALVINGS: usize = 60;

/// How two edges meet, and where.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// They pass through each other.
    Crossing(Point),
    /// They come nearer than the tolerance.
    Touching(Point),
}

/// Whether two edges come nearer than `tolerance`.
///
/// Two curves that do not cross are nearest at an end of one of them, or where one normal serves
/// both; so when none of these places is near, a crossing is a clear one.
pub(super) fn meeting(a: &Edge, b: &Edge, tolerance: f64) -> Option<Meeting> {
    touching(a, b, tolerance)
        .map(Meeting::Touching)
        .or_else(|| crossing(a, b).map(Meeting::Crossing))
}

fn touching(a: &Edge, b: &Edge, tolerance: f64) -> Option<Point> {
    let near = |p: &Point, edge: &Edge| edge.distance(*p) <= tolerance;
    let (rounder, flatter) = by_curvature(a, b);
    [a.start, a.end]
        .into_iter()
        .find(|p| near(p, b))
        .or_else(|| [b.start, b.end].into_iter().find(|p| near(p, a)))
        .or_else(|| {
            facing(rounder, flatter)
                .into_iter()
                .flatten()
                .map(|u| rounder.at(u))
                .find(|p| near(p, flatter))
        })
}

/// The one of two edges with the larger |curvature|, then the other.
pub(super) fn by_curvature<'a>(a: &'a Edge, b: &'a Edge) -> (&'a Edge, &'a Edge) {
    if b.is_line() || a.curvature().abs() >= b.curvature().abs() {
        (a, b)
    } else {
        (b, a)
    }
}

/// The fractions of `rounder` at which its normal is normal to the line or circle of `flatter` too.
///
/// They lie on the line of centres. Times both curvatures κ, the way between the centres is
/// κ κ′ (o′ − o) + κ n′ − κ′ n, with starts o and left normals n there: no division, so that a
/// circle may be as large as a line.
pub(super) fn facing(rounder: &Edge, flatter: &Edge) -> [Option<f64>; 2] {
    if rounder.is_line() {
        return [None, None]; // Two lines.
    }
    let (k, l) = (rounder.curvature(), flatter.curvature());
    let (n, m) = (
        rounder.start_direction().left(),
        flatter.start_direction().left(),
    );
    let way = (flatter.start - rounder.start) * (k * l) + m * k - n * l;
    if way == Vector::ZERO {
        return [None, None]; // One centre: the distance does not vary.
    }
    let along = way.unit().left();
    [
        rounder.fraction_heading(along),
        rounder.fraction_heading(-along),
    ]
}

/// A place where edges that are apart at their ends and where they face each other cross.
///
/// Between these places on the rounder edge, its offset from the other's line or circle is
/// monotone: it crosses once where the sign changes, and not otherwise.
fn crossing(a: &Edge, b: &Edge) -> Option<Point> {
    let (rounder, flatter) = by_curvature(a, b);
    let [u, v] = facing(rounder, flatter).map(|u| u.unwrap_or(1.0));
    let stops = [0.0, u.min(v), u.max(v), 1.0];
    stops
        .windows(2)
        .filter_map(|span| sign_change(rounder, flatter, span[0], span[1]))
        .find(|p| flatter.covers(*p))
}

/// Where `a` passes from one side of the line or circle of `b` to the other, in a span of `a` in
/// which it does so at most once.
fn sign_change(a: &Edge, b: &Edge, mut lo: f64, mut hi: f64) -> Option<Point> {
    let side = |u: f64| b.level(a.at(u));
    let (from, to) = (side(lo), side(hi));
    if (from > 0.0) == (to > 0.0) {
        return None;
    }
    if a.is_line() && b.is_line() {
        return Some(a.at(from / (from - to)));
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (lo + hi);
        if (side(middle) > 0.0) == (from > 0.0) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    Some(a.at(lo))
}
