//! A part's material in the pair's frame: distance of a place from its boundary, and containment.

use core::cell::Cell;

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
        !(self.boxes).any(near, |i| self.edges[i as usize].distance(p) < by)
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
                let q = self.edges[i as usize].nearest(p);
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
