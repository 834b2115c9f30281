//! A part's material in the pair's frame: distance of a place from its boundary, and containment.

use core::cell::Cell;

use super::tolerance::FLAT_BULGE;
use crate::boxes::Boxes;
use crate::geometry::Point;
use crate::part::{Bounds, Edge, Inside, Part};

/// A part's material about a centre and scaled, prepared for many queries.
#[derive(Debug)]
pub(crate) struct Material {
    pub(super) edges: Vec<Edge>,
    boxes: Boxes,
    inside: Inside,
    center: Point,
    scale: f64,
}

impl Material {
    /// Material of the part as drawn, without growth.
    pub(crate) fn new(part: &Part, center: Point, scale: f64) -> Self {
        let edges = in_frame(part, center, scale);
        Self {
            boxes: Boxes::new(edges.iter().map(Edge::bounds)),
            inside: Inside::of(part),
            edges,
            center,
            scale,
        }
    }

    /// Whether a place is in the material.
    pub(crate) fn contains(&self, p: Point) -> bool {
        let outer = self.center + (p - Point::ORIGIN) * (1.0 / self.scale);
        self.inside.contains(outer)
    }

    /// Whether the distance of the boundary from a place is at least `by`.
    pub(super) fn is_clear(&self, p: Point, by: f64) -> bool {
        let near = |b: &Bounds| !b.is_apart(Bounds::of(p, p), by);
        !(self.boxes).any(near, |i| distance(&self.edges[i as usize], p) < by)
    }

    /// A place of the boundary and its distance, if that is less than `within`; no place is nearer than `share` times that distance.
    ///
    /// With a share below 1, a query in the middle of a wheel does not examine all of its rim.
    pub(crate) fn closest(&self, p: Point, within: f64, share: f64) -> Option<(Point, f64)> {
        let least = Cell::new(within);
        let mut found = None;
        self.boxes.any(
            |b| !b.is_apart(Bounds::of(p, p), share * least.get()),
            |i| {
                let q = closest(&self.edges[i as usize], p);
                let d = p.distance(q);
                if d < least.get() {
                    least.set(d);
                    found = Some((q, d));
                }
                false
            },
        );
        found
    }
}

/// A part's edges about a centre and scaled.
pub(super) fn in_frame(part: &Part, center: Point, scale: f64) -> Vec<Edge> {
    let place = |p: Point| Point::ORIGIN + (p - center) * scale;
    part.edges().map(|e| e.placed(place)).collect()
}

/// Distance of a point from an edge.
pub(super) fn distance(edge: &Edge, p: Point) -> f64 {
    closest(edge, p).distance(p)
}

/// The place of an edge that is nearest to a point.
fn closest(edge: &Edge, p: Point) -> Point {
    let end = if p.distance(edge.start) <= p.distance(edge.end) {
        edge.start
    } else {
        edge.end
    };
    let chord = edge.end - edge.start;
    if edge.is_line() {
        let s = (p - edge.start).dot(chord);
        let len2 = chord.length_squared();
        if s <= 0.0 || s >= len2 {
            return end;
        }
        return edge.start + chord * (s / len2);
    }
    // About a centre far away, the place would be lost in rounding.
    if edge.bulge.abs() < FLAT_BULGE {
        return edge.foot(p).unwrap_or(end);
    }
    let c = edge.center();
    let v = p - c;
    let (mut from, mut to) = (edge.start - c, edge.end - c);
    if edge.bulge < 0.0 {
        core::mem::swap(&mut from, &mut to);
    }
    let beside = if edge.bulge.abs() <= 1.0 {
        from.cross(v) >= 0.0 && v.cross(to) >= 0.0
    } else {
        from.cross(v) >= 0.0 || v.cross(to) >= 0.0
    };
    let length = v.length();
    if beside && length > 0.0 {
        c + v * (edge.radius() / length)
    } else {
        end
    }
}
