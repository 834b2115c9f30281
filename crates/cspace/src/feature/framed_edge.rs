//! An edge of a part in the pair's frame, in double-double.

use super::tolerance::{LARGEST_CIRCLE, NEGLIGIBLE, SMOOTH, STRAIGHT};
use super::types::Near;
use crate::geometry::{Point, Rotation, Vector};
use crate::number::Dd;
use crate::part::Edge;

/// An edge in the pair's frame, from which a feature is made.
pub(super) struct FramedEdge {
    pub(super) edge: Edge,
    pub(super) start: Point<Dd>,
    pub(super) end: Point<Dd>,
    /// Centre and radius; `None` for a line.
    pub(super) arc: Option<(Point<Dd>, Dd)>,
    /// Reference point of a large arc.
    pub(super) near: Option<Near>,
    pub(super) start_direction: Vector<Dd>,
    pub(super) end_direction: Vector<Dd>,
    /// The directions in which the edge as drawn begins and ends, before it is replaced by its chord or moved.
    pub(super) drawn: [Vector; 2],
    pub(super) sweep: f64,
}

impl FramedEdge {
    pub(super) fn new(edge: &Edge, center: Point, scale: f64) -> Self {
        let place = |p: Point| {
            let along = |x: f64, center: f64| (Dd::from(x) - center).scaled(scale);
            Point::new(along(p.x, center.x), along(p.y, center.y))
        };
        let near = |p: Point| Point::ORIGIN + (p - center) * scale;
        let (start, end) = (place(edge.start), place(edge.end));
        let drawn = [edge.start_direction(), edge.end_direction()];
        let mut edge = Edge {
            start: near(edge.start),
            end: near(edge.end),
            ..*edge
        };
        let sweep = edge.sweep();
        let height = 0.5 * edge.bulge.abs() * edge.start.distance(edge.end);
        if sweep.abs() < STRAIGHT || (sweep.abs() < SMOOTH && height < NEGLIGIBLE) {
            edge.bulge = 0.0;
        }
        Self::of(edge, drawn, (start, end), Dd::from(edge.bulge))
    }

    /// The edge with the given ends and bulge in double-double; `edge` gives approximate lengths.
    pub(super) fn of(
        edge: Edge,
        drawn: [Vector; 2],
        (start, end): (Point<Dd>, Point<Dd>),
        b: Dd,
    ) -> Self {
        let chord = end - start;
        let span = chord.length();
        let (one, square) = (Dd::ONE, b * b);
        let arc = (!edge.is_line()).then(|| {
            let middle = start.midpoint(end);
            let up = (one - square) / (b * 4.0);
            (
                middle + chord.left() * up,
                span * (one + square) / (b * 4.0),
            )
        });
        // With b = tan(sweep/4), cos(sweep/2) = (1 − b²)/(1 + b²) and sin(sweep/2) = 2b/(1 + b²).
        let (cos, sin) = ((one - square) / (one + square), b * 2.0 / (one + square));
        let direction = chord * (one / span);
        let half = Rotation { cos, sin };
        let near = arc
            .filter(|a| a.1.to_f64().abs() > LARGEST_CIRCLE)
            .map(|_| {
                let chord = edge.end - edge.start;
                Near {
                    point: edge.start.midpoint(edge.end) + chord.right() * (0.5 * edge.bulge),
                    normal: chord.unit().right(),
                }
            });
        Self {
            edge,
            start,
            end,
            arc,
            near,
            start_direction: half.inverse() * direction,
            end_direction: half * direction,
            drawn,
            sweep: edge.sweep(),
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
