//! An edge of a part in the pair's frame, in double-double.

use super::tolerance::{LARGEST_CIRCLE, NEGLIGIBLE, SMOOTH, STRAIGHT};
use super::types::Near;
use crate::geometry::{Point, Vector};
use crate::number::Dd;
use crate::part::Edge;

/// An edge in the pair's frame, from which a feature is made.
pub(super) struct FramedEdge {
    pub(super) edge: Edge<Dd>,
    /// Centre and radius; `None` for a line.
    pub(super) arc: Option<(Point<Dd>, Dd)>,
    /// Reference point of a large arc.
    pub(super) near: Option<Near>,
    pub(super) start_direction: Vector<Dd>,
    pub(super) end_direction: Vector<Dd>,
    /// The directions in which the edge as drawn begins and ends, before it is replaced by its chord or moved.
    pub(super) drawn: [Vector; 2],
    /// The edge rounded to f64.
    pub(super) rough: Edge,
}

impl FramedEdge {
    pub(super) fn new(edge: &Edge, center: Point, scale: f64) -> Self {
        let along = |x: f64, center: f64| (Dd::from(x) - center).scaled(scale);
        let place = |p: Point| Point::new(along(p.x, center.x), along(p.y, center.y));
        let drawn = [edge.start_direction(), edge.end_direction()];
        let mut edge = Edge {
            start: place(edge.start),
            end: place(edge.end),
            bulge: Dd::from(edge.bulge),
            index: edge.index,
        };
        let rough = rounded(&edge);
        let sweep = rough.sweep().abs();
        if sweep < STRAIGHT || (sweep < SMOOTH && rough.height() < NEGLIGIBLE) {
            edge.bulge = Dd::ZERO;
        }
        Self::of(edge, drawn)
    }

    /// The edge with the directions in which it was drawn.
    pub(super) fn of(edge: Edge<Dd>, drawn: [Vector; 2]) -> Self {
        let rough = rounded(&edge);
        let arc = (!edge.is_line()).then(|| (edge.center(), edge.signed_radius()));
        let (half, chord) = edge.half_sweep();
        let is_large = |arc: &(_, Dd)| arc.1.to_f64().abs() > LARGEST_CIRCLE;
        Self {
            arc,
            near: arc.filter(is_large).map(|_| Near {
                point: rough.middle(),
                normal: (rough.end - rough.start).unit().right(),
            }),
            start_direction: half.inverse() * chord,
            end_direction: half * chord,
            drawn,
            edge,
            rough,
        }
    }

    /// The normal of this edge at a grown corner.
    pub(super) fn normal_at(&self, apex: Point<Dd>, normal: Vector<Dd>, growth: f64) -> Vector<Dd> {
        match self.arc {
            Some((center, radius)) if growth != 0.0 => {
                let v = (apex - center).unit();
                if radius.is_negative() { -v } else { v }
            }
            _ => normal,
        }
    }

    /// Signed distance of a point from the edge's line or circle as grown, outward, to first order; and the outward normal there.
    pub(super) fn off(
        &self,
        p: Point<Dd>,
        normal: Vector<Dd>,
        at: Point<Dd>,
        growth: f64,
    ) -> (Dd, Vector<Dd>) {
        match self.arc {
            None => (normal.dot(p - at) - growth, normal),
            Some((center, radius)) => {
                let r = radius + growth;
                let v = p - center;
                ((v.dot(v) - r * r) / (r * 2.0), v * (Dd::ONE / r))
            }
        }
    }

    pub(super) fn curvature(&self) -> f64 {
        self.arc.map_or(0.0, |(_, radius)| 1.0 / radius.to_f64())
    }
}

fn rounded(edge: &Edge<Dd>) -> Edge {
    Edge {
        start: edge.start.map(Dd::to_f64),
        end: edge.end.map(Dd::to_f64),
        bulge: edge.bulge.to_f64(),
        index: edge.index,
    }
}
