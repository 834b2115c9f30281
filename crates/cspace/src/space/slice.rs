//! Slices of the contact space.

use core::f64::consts::{PI, TAU};

use crate::contact::Cycle;
use crate::feature::PairFrame;
use crate::geometry::{Point, Rotation, Vector};
use crate::ids::PatchId;
use crate::slice::{CurveGeometry, Slice, SliceCurve};

use super::data::SideLink;
use super::doubts::Doubts;
use super::options::Window;
use super::patch::Patch;
use super::walk::Walk;

/// The boundary of free space, from which slices are taken.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Surface<'a> {
    pub(crate) window: Window,
    pub(crate) frame: &'a PairFrame,
    pub(crate) critical_orientations: &'a [f64],
    pub(crate) patches: &'a [Patch],
    pub(crate) side_links: &'a [SideLink],
    pub(crate) walk: &'a Walk,
    /// Doubtful orientations.
    pub(crate) doubtful: &'a [(f64, f64)],
}

impl<'a> Surface<'a> {
    /// Doubtful orientations, for queries.
    #[inline]
    pub(crate) fn doubts(&self) -> Doubts<'a> {
        Doubts {
            intervals: self.doubtful,
            full_turn: self.window.full_turn,
        }
    }

    /// The slice at an orientation; see [`ContactSpace::slice`](crate::ContactSpace::slice).
    pub(crate) fn slice(&self, theta: f64) -> Slice {
        self.slice_of(theta, theta, 0..self.patches.len() as u32)
    }

    /// The slice at `theta`, with positions given at the orientation `asked`, which differs from `theta` by whole turns. `among` lists, in
    /// ascending order, patches that include all those that exist at `theta`.
    pub(crate) fn slice_of(
        &self,
        theta: f64,
        asked: f64,
        among: impl Iterator<Item = u32>,
    ) -> Slice {
        let settled = self.settled(theta);
        let asked = Turned::by(asked);
        let mut turned = Turned::by(settled);
        let (mut curves, mut ends, mut at) = (Vec::new(), Vec::new(), Vec::new());
        for i in among {
            let patch = &self.patches[i as usize];
            if let Some(t) = self.alive(patch, settled) {
                if t != turned.theta {
                    turned = Turned::by(t);
                }
                at.push((PatchId(i), t));
                let (geometry, both) = self.curve_with_ends(patch, turned, asked);
                ends.push(both);
                curves.push(SliceCurve {
                    fixed: patch.fixed,
                    moving: patch.moving,
                    geometry,
                    patch: Some(PatchId(i)),
                    next: u32::MAX,
                });
            }
        }
        for (curve, &(i, t)) in curves.iter_mut().zip(&at) {
            let last = t == self.patches[i.index()].hi;
            let mut links = (self.walk.after(i).iter()).map(|&l| &self.side_links[l as usize]);
            let link = links.find(|l| l.lo <= t && (t < l.hi || (last && t <= l.hi)));
            // The link's orientations are counted as those of the patch before it.
            if let Some(link) = link
                && let Ok(next) = at.binary_search_by_key(&link.after, |a| a.0)
            {
                curve.next = next as u32;
            }
        }
        let doubtful = self.doubts().hold(theta);
        Slice::from_curves_and_ends(asked.theta, curves, &ends, doubtful, self.frame)
    }

    /// The orientation; or if it is critical up to rounding, the smallest one above that is certain to be in the next band.
    ///
    /// Patches that end at a critical orientation, and patches that begin there, may be turns apart, so that their orientations differ by
    /// rounding.
    pub(crate) fn settled(&self, theta: f64) -> f64 {
        /// A few roundings; radians, relative to orientations above one.
        const NEAR: f64 = 4e-15;
        /// Twice as many.
        const ASIDE: f64 = 8e-15;
        let (window, critical) = (&self.window, self.critical_orientations);
        let scale = theta.abs().max(1.0);
        // Critical orientations are in [−π, π), wherever the turn was cut.
        let turns = if window.full_turn {
            TAU * ((theta + PI) / TAU).floor()
        } else {
            0.0
        };
        let turned = theta - turns;
        let next = critical.partition_point(|&c| c < turned - NEAR * scale);
        let wrapped = critical.first().map(|c| c + TAU);
        let Some(c) = critical.get(next).copied().or(wrapped) else {
            return theta;
        };
        let aside = theta + (c - turned) + ASIDE * scale;
        let within = window.full_turn || aside < window.hi;
        if (c - turned).abs() <= NEAR * scale && within {
            aside
        } else {
            theta
        }
    }

    /// The orientation reduced to the interval of a patch, if the patch is part of the slice there: where one patch ends and another
    /// begins, the upper one is part of it; at the end of the window, the last one.
    #[inline]
    pub(crate) fn alive(&self, patch: &Patch, theta: f64) -> Option<f64> {
        if !self.window.full_turn && theta == self.window.hi {
            return (patch.hi >= theta).then_some(patch.hi);
        }
        patch.turned_into(theta).filter(|&t| t < patch.hi)
    }

    /// The curve of a patch at an orientation of its interval.
    pub(crate) fn curve(&self, patch: &Patch, theta: f64) -> CurveGeometry {
        self.curve_as_at(patch, theta, theta)
    }

    /// The curve of a patch at an orientation of its interval, as positions at the orientation `asked`, which differs from it by turns and
    /// rounding: for parts drawn far from their origins the rounding of positions exceeds the change of the curve.
    pub(crate) fn curve_as_at(&self, patch: &Patch, theta: f64, asked: f64) -> CurveGeometry {
        (self.curve_with_ends(patch, Turned::by(theta), Turned::by(asked))).0
    }

    /// The curve as [`curve_as_at`](Self::curve_as_at) gives it, and the points where it begins and ends.
    fn curve_with_ends(
        &self,
        patch: &Patch,
        at: Turned,
        asked: Turned,
    ) -> (CurveGeometry, (Point, Point)) {
        let moved = asked.turn * self.frame.moving_center.to_vector();
        let ends = [&patch.left, &patch.right].map(|b| patch.inner_at_turned(b, at.theta, at.turn));
        on_cycle(&patch.function.cycle(at.turn), ends, self.frame, moved)
    }
}

/// The piece between two points of a cycle of the pair's frame, in the user's frame, and its end points; `moved` is the moving part's
/// centre, turned.
pub(crate) fn on_cycle(
    cycle: &Cycle,
    [start, end]: [Point; 2],
    frame: &PairFrame,
    moved: Vector,
) -> (CurveGeometry, (Point, Point)) {
    let outer = |p: Point| frame.fixed_center + (p.to_vector() * (1.0 / frame.scale) - moved);
    let ends = (outer(start), outer(end));
    if cycle.is_line() {
        let (start, end) = ends;
        return (CurveGeometry::Segment { start, end }, ends);
    }
    if cycle.is_large() {
        let bulge = cycle.bulge(cycle.place(start), cycle.place(end));
        let (start, end) = ends;
        return (CurveGeometry::FlatArc { start, end, bulge }, ends);
    }
    let (c, radius) = (cycle.through, cycle.radius());
    let sweep = sweep(start - c, end - c, radius);
    let arc = CurveGeometry::Arc {
        center: outer(c),
        radius: frame.outer_length(radius.abs()),
        start_angle: (start - c).angle(),
        sweep,
    };
    let on_circle = |p: Point, s: f64| {
        let arm = p - c;
        let p = c + arm * (radius.abs() / arm.length());
        if p.is_finite() {
            outer(p)
        } else {
            arc.point(s)
        }
    };
    // An arc that has just ended is one point.
    let end = if sweep == 0.0 { start } else { end };
    (arc, (on_circle(start, 0.0), on_circle(end, 1.0)))
}

/// An orientation and its rotation.
#[derive(Debug, Clone, Copy)]
struct Turned {
    theta: f64,
    turn: Rotation,
}

impl Turned {
    fn by(theta: f64) -> Self {
        Self {
            theta,
            turn: Rotation::by(theta),
        }
    }
}

/// Distance of the ends of an arc, as a share of the radius, below which ends in the wrong order count as one point and not as a full turn:
/// next to a critical orientation, which may have an error of 1e-6, a patch may be evaluated that has just ended.
pub(crate) const PASSED_ENDS: f64 = 1e-5;

/// The angle travelled from one direction to another, counter-clockwise if the radius is positive.
pub(crate) fn sweep(from: Vector, to: Vector, radius: f64) -> f64 {
    let turned = from.cross(to).atan2(from.dot(to)) * radius.signum();
    let sweep = if turned < -PASSED_ENDS {
        turned + TAU
    } else {
        turned.max(0.0)
    };
    sweep * radius.signum()
}
