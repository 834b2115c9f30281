//! Overlap test of two parts at one configuration: boundaries intersected, containment tested.

use crate::boxes::Boxes;
use crate::feature::Outline;
use crate::feature::tolerance::{MOVING_GROWTH, WITHIN};
use crate::geometry::{Point, Rotation};
use crate::part::{Bounds, Inside, Layer, Part};

use super::crossing::crossing;
use super::curve::Curve;
use super::cycle::Cycle;

/// A part prepared for overlap tests: each of its layers.
#[derive(Debug)]
pub(crate) struct Body {
    layers: Vec<LayerBody>,
    part: Part,
    center: Point,
    scale: f64,
}

/// A layer prepared for overlap tests: its boundary as curves, and two points at every loop.
#[derive(Debug)]
struct LayerBody {
    curves: Vec<Curve>,
    boxes: Boxes,
    inside: Inside,
    samples: Vec<Point>,
}

impl Body {
    /// Body of a part of a pair whose moving part is smaller than drawn by `room` (length).
    pub(crate) fn new(
        outline: &Outline,
        part: &Part,
        center: Point,
        scale: f64,
        room: f64,
    ) -> Self {
        let first = part.drawn_first();
        let place = |p: Point| Point::ORIGIN + (p - center) * scale;
        let layer = |(index, layer): (usize, &Layer)| {
            let mut is_own = vec![false; part.loops().len()];
            layer.loops().for_each(|l| is_own[first[l]] = true);
            let curves: Vec<Curve> = (outline.features.iter())
                .filter(|f| !f.is_vertex() && is_own[f.name.loop_index as usize])
                .map(|f| {
                    let ends = [outline.start(f), outline.end(f)].map(|joint| joint.point);
                    Curve::new(Cycle::of(outline, f), ends, [f.lo, f.hi])
                })
                .collect();
            // Just outside as drawn, so that an exact fit is an overlap, and just inside, so that a part covers itself; where the moving
            // part is shrunk by `room`, inside by that amount.
            let samples = (part.loops()[layer.loops()].iter())
                .filter_map(|l| l.edges().next())
                .flat_map(|e| {
                    let (on, outward) = (place(e.at(0.5)), e.direction_at(0.5).right());
                    [MOVING_GROWTH, -WITHIN].map(|out| on + outward * (out - room))
                })
                .collect();
            LayerBody {
                boxes: Boxes::new(curves.iter().map(Curve::bounds)),
                curves,
                inside: Inside::of(&part.layer(index)),
                samples,
            }
        };
        Self {
            layers: part.layers().iter().enumerate().map(layer).collect(),
            part: part.clone(),
            center,
            scale,
        }
    }

    pub(crate) fn part(&self) -> &Part {
        &self.part
    }

    /// The point of the part that is the origin of the pair's frame.
    pub(crate) fn center(&self) -> Point {
        self.center
    }

    fn layers(&self) -> impl Iterator<Item = (&Layer, &LayerBody)> {
        self.part.layers().iter().zip(&self.layers)
    }

    fn contains(&self, layer: &LayerBody, p: Point) -> bool {
        let outer = self.center + (p - Point::ORIGIN) * (1.0 / self.scale);
        layer.inside.contains(outer)
    }
}

fn cross(f: &Curve, g: &Curve) -> bool {
    /// A crossing at the joint of two consecutive edges lies on at least one of them within this (length).
    const ROUNDING: f64 = 16.0 * f64::EPSILON;
    let is_on = |curve: &Curve, p: Point| curve.position(p).abs() <= curve.half + ROUNDING;
    (0..2).any(|root| crossing(f, g, root).is_some_and(|c| is_on(f, c.point) && is_on(g, c.point)))
}

/// Whether the moving body at position `p` and orientation `theta` overlaps the fixed one, at any height.
///
/// The result is certain if the boundaries do not merely graze each other; the caller picks configurations away from contact.
pub(crate) fn overlap(fixed: &Body, moving: &Body, p: Point, theta: f64) -> bool {
    let (turn, shift) = (Rotation::by(theta), p.to_vector());
    let back = turn.inverse();
    let of = |f: &LayerBody, m: &LayerBody| {
        let crosses = |g: &Curve| {
            let g = g.moved(shift, turn);
            let around = g.bounds();
            let meets = |b: &Bounds| !b.is_apart(around, 0.0);
            f.boxes.any(meets, |i| cross(&f.curves[i as usize], &g))
        };
        let in_fixed = |&q: &Point| fixed.contains(f, turn * q + shift);
        let in_moving = |&q: &Point| moving.contains(m, back * (q - shift));
        m.curves.iter().any(crosses)
            || m.samples.iter().any(in_fixed)
            || f.samples.iter().any(in_moving)
    };
    fixed
        .layers()
        .any(|(a, f)| moving.layers().any(|(b, m)| a.meets(b) && of(f, m)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::contact::{Bodies, Fit};
    use crate::feature::tolerance::GROWTH;
    use crate::geometry::Configuration;
    use crate::part::{Part, Vertex};

    fn square(r: f64) -> Vec<Vertex> {
        [(-r, -r), (r, -r), (r, r), (-r, r)]
            .map(|(x, y)| Vertex::line(x, y))
            .into()
    }

    fn overlap(fixed: &[Vec<Vertex>], moving: &[Vec<Vertex>], x: f64, theta: f64) -> bool {
        let part = |name, loops: &[Vec<Vertex>]| Part::new(name, loops.to_vec()).unwrap();
        let bodies = Bodies::new(
            &part("fixed", fixed),
            &part("moving", moving),
            Fit::Overlaps,
        );
        bodies.overlap(Configuration::new(x, 0.0, theta))
    }

    /// Where boundaries coincide without crossing: parts of one shape cover each other, a plug fills its hole, and a slightly smaller part
    /// is inside.
    #[test]
    fn coincident_boundaries() {
        let ring = [square(2.0), square(1.0)];
        let quarters = (0..4).map(|k| f64::from(k) * core::f64::consts::FRAC_PI_2);
        for theta in quarters {
            assert!(overlap(&[square(1.0)], &[square(1.0)], 0.0, theta));
            assert!(overlap(&ring, &ring, 0.0, theta));
            assert!(overlap(&ring, &[square(1.0)], 0.0, theta));
            assert!(overlap(&[square(1.0)], &ring, 0.0, theta));
            assert!(!overlap(&ring, &[square(1.0 - 1e-9)], 0.0, theta));
            assert!(overlap(&ring, &[square(1.0 - 1e-9)], 2e-9, theta));
            assert!(!overlap(&[square(1.0)], &[square(1.0)], 2.0 + 1e-9, theta));
            assert!(overlap(&[square(1.0)], &[square(1.0)], 2.0 - 1e-9, theta));
        }
    }

    /// The crossing is exactly where a side of the moving part ends and its arc begins.
    #[test]
    fn a_crossing_at_a_joint() {
        let plate = [square(2.0)];
        let pill = vec![
            Vertex::line(-0.5, -0.25),
            Vertex::new(0.5, -0.25, 1.0),
            Vertex::line(0.5, 0.25),
            Vertex::new(-0.5, 0.25, 1.0),
        ];
        // Growth of the plate, in the model's unit.
        let grown = 4.0 * GROWTH;
        for x in [2.5 + grown, -2.5 - grown] {
            assert!(overlap(&plate, core::slice::from_ref(&pill), x, 0.0), "{x}");
        }
    }
}
