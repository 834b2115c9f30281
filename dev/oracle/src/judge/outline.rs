//! The boundary of a part, in some frame.

use cspace::{Part, Point};

use super::curve::Curve;
use super::plane::{Frame, Place};
use super::real::Real;

/// Edges of a part.
#[derive(Debug, Clone)]
pub(super) struct Outline<S> {
    pub(super) curves: Vec<Curve<S>>,
    /// The box about each curve.
    pub(super) frames: Vec<Frame>,
    /// The box about everything.
    pub(super) frame: Frame,
    /// The index of the first curve of each loop.
    pub(super) loops: Vec<usize>,
}

impl<S: Real> Outline<S> {
    /// The part's boundary as seen from `origin`.
    pub(super) fn new(part: &Part, origin: Point) -> Self {
        let seen =
            |p: Point| Place::new(S::of(p.x) - S::of(origin.x), S::of(p.y) - S::of(origin.y));
        let (mut curves, mut loops) = (Vec::new(), Vec::new());
        for l in part.loops() {
            loops.push(curves.len());
            let vertices = l.vertices();
            for (i, v) in vertices.iter().enumerate() {
                let next = vertices[(i + 1) % vertices.len()];
                curves.push(Curve::new(seen(v.point()), seen(next.point()), v.bulge));
            }
        }
        Self::of(curves, loops)
    }

    fn of(curves: Vec<Curve<S>>, loops: Vec<usize>) -> Self {
        let frames: Vec<Frame> = curves.iter().map(Curve::frame).collect();
        let frame = frames.iter().fold(Frame::EMPTY, |a, b| a.with(*b));
        Self {
            curves,
            frames,
            frame,
            loops,
        }
    }

    pub(super) fn moved(&self, turn: (S, S), shift: Place<S>) -> Self {
        let curves = self.curves.iter().map(|c| c.moved(turn, shift)).collect();
        Self::of(curves, self.loops.clone())
    }

    pub(super) fn rough(&self) -> Outline<f64> {
        Outline {
            curves: self.curves.iter().map(Curve::rough).collect(),
            frames: self.frames.clone(),
            frame: self.frame,
            loops: self.loops.clone(),
        }
    }

    /// Whether the point is in the interior. The result is undefined for points on the boundary. `slack` is the boxes'
    /// precision.
    pub(super) fn holds(&self, p: Place<S>, slack: f64) -> bool {
        let rough = p.rough();
        let mut inside = false;
        for (curve, frame) in self.curves.iter().zip(&self.frames) {
            if rough.y >= frame.low[1] - slack
                && rough.y <= frame.high[1] + slack
                && rough.x <= frame.high[0] + slack
            {
                inside ^= curve.flips(p);
            }
        }
        inside
    }

    /// The distance from the point to the boundary, to within `slack` of the boxes' precision.
    pub(super) fn distance(&self, p: Place<S>, slack: f64) -> f64 {
        let rough = p.rough();
        let here = Frame::around(rough, rough);
        let mut best = f64::INFINITY;
        for (curve, frame) in self.curves.iter().zip(&self.frames) {
            let bound = best + slack;
            if frame.distance_squared(&here) <= bound * bound {
                best = best.min(curve.nearest(p).1.to_f64());
            }
        }
        best
    }

    /// The length of the shortest chord.
    pub(super) fn shortest(&self) -> f64 {
        self.curves.iter().fold(f64::INFINITY, |l, c| {
            l.min((c.end - c.start).length().to_f64())
        })
    }

    /// The largest radius of an arc.
    pub(super) fn largest_radius(&self) -> f64 {
        self.curves
            .iter()
            .fold(0.0, |r, c| r.max(c.radius.to_f64()))
    }
}
