//! Shapes for measuring distances of a part: circles with a range of directions, and lines and flat arcs.
//!
//! A vertex is a circle of radius 0. So there are three kinds of minimum distance: between two circles along the line of their
//! centres, between a circle and a flat arc along the normal of the arc, and between two flat arcs (`flats.rs`).

use core::f64::consts::TAU;

use cspace::{Edge, FeatureKind, FeatureName, Part, Point, Vector};

use super::flat::Flat;

/// An arc is flat if its radius is so many sizes of its part or more: from its centre, distances would be rounded by as many
/// roundings, and its points seem to be bent off their ways by as much.
const FLAT: f64 = 8.0;

/// A piece of a part's boundary, in the part's own frame.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    /// A circle, on which the directions from `from` counter-clockwise by `sweep` (radians) belong to the part.
    Circle {
        center: Point,
        radius: f64,
        from: f64,
        sweep: f64,
    },
    /// A line or a flat arc.
    Flat(Flat),
}

/// A piece with what is needed to pass it over.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) shape: Shape,
    /// A disc that holds it.
    pub(super) middle: Point,
    pub(super) reach: f64,
    pub(super) name: FeatureName,
}

impl Piece {
    /// The vertices and edges of a part, with an offset taken from every point.
    pub(super) fn all(part: &Part, origin: Vector) -> Vec<Self> {
        let mut all = Vec::new();
        let bounds = part.bounds();
        let flat = FLAT * (bounds.max - bounds.min).length();
        for (loop_index, boundary) in (0u32..).zip(part.loops()) {
            for e in boundary.edges() {
                let moved = e.placed(|p| p - origin);
                let name = |kind, index: usize| FeatureName {
                    kind,
                    loop_index,
                    index: index as u32,
                };
                all.push(Self {
                    shape: Shape::Circle {
                        center: moved.start,
                        radius: 0.0,
                        from: 0.0,
                        sweep: TAU,
                    },
                    middle: moved.start,
                    reach: 0.0,
                    name: name(FeatureKind::Vertex, boundary.start_of(e.index)),
                });
                all.push(Self::of(
                    &moved,
                    name(FeatureKind::of_bulge(e.bulge), e.index),
                    flat,
                ));
            }
        }
        all
    }

    fn of(e: &Edge, name: FeatureName, flat: f64) -> Self {
        let middle = e.start.midpoint(e.end);
        let chord = e.end - e.start;
        let length = chord.length();
        // An arc of less than half a turn is within the disc over its chord; of others all of the circle is taken.
        if e.is_line() || e.radius() >= flat {
            return Self {
                shape: Shape::Flat(Flat::of(e)),
                middle,
                reach: 0.5 * length,
                name,
            };
        }
        let (center, radius, sweep) = (e.center(), e.radius(), e.sweep());
        let first = if sweep > 0.0 { e.start } else { e.end };
        let half = sweep.abs() <= core::f64::consts::PI;
        Self {
            shape: Shape::Circle {
                center,
                radius,
                from: (first - center).angle(),
                sweep: sweep.abs(),
            },
            middle: if half { middle } else { center },
            reach: if half { 0.5 * length } else { radius },
            name,
        }
    }
}

/// How far a direction is outside of those from `from` by `sweep`, in radians; 0 within.
pub(super) fn beyond(from: f64, sweep: f64, direction: f64) -> f64 {
    let turned = (direction - from).rem_euclid(TAU);
    if turned <= sweep {
        0.0
    } else {
        (turned - sweep).min(TAU - turned)
    }
}
