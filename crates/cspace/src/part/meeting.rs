//! Meetings of two edges that share no vertex.

use crate::geometry::{Point, Vector};

use super::Edge;

/// Number of halvings that locate a crossing; 2⁻⁶⁰ of an edge is below the rounding of its points.
const HALVINGS: usize = 60;

/// Kind and place of the meeting of two edges.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Meeting {
    /// They pass through each other.
    Crossing(Point),
    /// They come nearer than the tolerance.
    Touching(Point),
}

/// Whether, and how, two edges come nearer than `tolerance`.
///
/// Two curves that do not cross are nearest at an end of one of them, or at a common normal; so if no such place is near, a crossing is a
/// clear one.
pub(super) fn meeting(a: &Edge, b: &Edge, tolerance: f64) -> Option<Meeting> {
    touching(a, b, tolerance)
        .map(Meeting::Touching)
        .or_else(|| crossing(a, b).map(Meeting::Crossing))
}

impl Edge {
    /// The places at which two edges cross or come nearer than `tolerance`: the ends of one that are near the other, the places near the
    /// other at which both have a common normal, and the crossings. For two edges that overlap these are the ends of the overlap.
    ///
    /// ```
    /// use cspace::{Edge, Point};
    /// let edge = |a: (f64, f64), b: (f64, f64), bulge| Edge { start: a.into(), end: b.into(), bulge, index: 0 };
    /// let (line, half_circle) = (edge((-2.0, -0.5), (2.0, -0.5), 0.0), edge((-1.0, 0.0), (1.0, 0.0), 1.0));
    /// let places = half_circle.meetings(&line, 1e-9);
    /// assert_eq!(places.len(), 2);
    /// assert!(places.iter().all(|p| (p.distance(Point::ORIGIN) - 1.0).abs() < 1e-12));
    /// ```
    pub fn meetings(&self, other: &Self, tolerance: f64) -> Vec<Point> {
        touchings(self, other, tolerance)
            .chain(crossings(self, other))
            .collect()
    }
}

fn touching(a: &Edge, b: &Edge, tolerance: f64) -> Option<Point> {
    touchings(a, b, tolerance).next()
}

fn touchings<'a>(
    a: &'a Edge,
    b: &'a Edge,
    tolerance: f64,
) -> impl Iterator<Item = Point> + use<'a> {
    let (rounder, flatter) = by_curvature(a, b);
    let facing = core::iter::once_with(move || facing(rounder, flatter))
        .flatten()
        .flatten()
        .map(move |u| (rounder.at(u), flatter));
    [(a.start, b), (a.end, b), (b.start, a), (b.end, a)]
        .into_iter()
        .chain(facing)
        .filter(move |(p, edge)| edge.distance(*p) <= tolerance)
        .map(|(p, _)| p)
}

/// The one of two edges with the larger |curvature|, then the other.
pub(super) fn by_curvature<'a>(a: &'a Edge, b: &'a Edge) -> (&'a Edge, &'a Edge) {
    if b.is_line() || a.curvature().abs() >= b.curvature().abs() {
        (a, b)
    } else {
        (b, a)
    }
}

/// The fractions of `rounder` at which its normal is also normal to the line or circle of `flatter`.
///
/// They lie on the line of centres. Times both curvatures κ, the vector between the centres is κ κ′ (o′ − o) + κ n′ − κ′ n, with starts o
/// and left normals n there: without division, so that a circle may be as large as a line.
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

/// A crossing of edges that are apart at their ends and where they face each other.
fn crossing(a: &Edge, b: &Edge) -> Option<Point> {
    crossings(a, b).next()
}

/// The places where two edges cross.
///
/// Between these places on the rounder edge, its offset from the other's line or circle is
/// monotone: it crosses once where the sign changes, and not otherwise.
fn crossings<'a>(a: &'a Edge, b: &'a Edge) -> impl Iterator<Item = Point> + use<'a> {
    let (rounder, flatter) = by_curvature(a, b);
    let [u, v] = facing(rounder, flatter).map(|u| u.unwrap_or(1.0));
    [(0.0, u.min(v)), (u.min(v), u.max(v)), (u.max(v), 1.0)]
        .into_iter()
        .filter_map(move |(lo, hi)| sign_change(rounder, flatter, lo, hi))
        .filter(|p| flatter.covers(*p))
}

/// The place where `a` passes from one side of the line or circle of `b` to the other, in a range of `a` in which it does so at most once.
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
