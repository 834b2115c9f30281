//! The configuration of free space at which a point of the moving part is farthest in a direction, over all orientations.
//!
//! For a point q of the moving part and a unit vector d,
//!
//! ```text
//! reach(p, θ) = d · (p + R_θ q)
//! ```
//!
//! is linear in p. So at one orientation it is largest where a contact curve begins, or inside an arc where the normal towards free space is
//! −d. Over the orientations the places of the second kind move as centres do, and reach is a constant and one wave, whose top is known; those
//! of the first kind follow the boundary curves of patches. On a boundary curve the interval of orientations is halved until enclosures
//! of reach and its first two derivatives say of each piece that all of it is too low, that reach is largest at an end, or that it has
//! one top, which is found to rounding. Nothing is sampled.

use crate::contact::{Carrier, Spiral};
use crate::feature::tolerance::CONTACT;
use crate::geometry::{Configuration, Point, Rotation, Vector, wrap};
use crate::ids::PatchId;
use crate::number::{Ball, Dual, NARROWEST, Real, SecondOrder, halved};
use crate::space::{Boundary, ContactSpace, Patch};

use super::Classification;

/// The farthest configuration, and how far it is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Farthest {
    /// A configuration on the boundary of free space.
    pub configuration: Configuration,
    /// How far the point is in the direction there, from the origin of the fixed part: right to the
    /// [resolution](ContactSpace::resolution).
    pub reach: f64,
}

impl ContactSpace {
    /// The configuration at which a point `about` of the moving part, in its frame, is farthest in a direction, among all of the closed
    /// free regions that end everywhere; `None` without such regions, and for a direction without length.
    ///
    /// Among configurations that are as far, to the [resolution](Self::resolution), it is the one that is farthest to the right of the
    /// direction: for downwards the lowest and then the leftmost. Of those it is the one with the least turn. Where the point stays as far
    /// along all of a patch, as the centre of an arc that rolls on a floor, the whole patch is looked at; configurations beside a
    /// smooth top that are as far only to the resolution are not.
    ///
    /// ```
    /// use cspace::{ContactSpace, Options, Part, Point, Vector};
    /// // A bar of 1 × 3 in a V of a right angle, closed above: it lies flat on a side, in the corner.
    /// let walls = Part::new("walls", vec![
    ///     cspace::part::polygon_loop(&[(-20.0, -10.0), (20.0, -10.0), (20.0, 20.0), (-20.0, 20.0)]),
    ///     cspace::part::polygon_loop(&[(0.0, 0.0), (9.0, 9.0), (-9.0, 9.0)]),
    /// ])?;
    /// let bar = Part::rectangle("bar", (0.0, 0.0), 3.0, 1.0)?;
    /// let space = ContactSpace::compute(&walls, &bar, &Options::default())?;
    /// let lowest = space.farthest(Vector::new(0.0, -1.0), Point::ORIGIN).ok_or("it does not fit")?;
    /// // Its middle is 1.5 and 0.5 from the sides, and so 2/√2 above the corner.
    /// assert!((lowest.reach + 2.0_f64.sqrt()).abs() < 1e-9);
    /// assert!(lowest.configuration.x < 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn farthest(&self, direction: Vector, about: Point) -> Option<Farthest> {
        let unit = direction.unit();
        if !unit.x.is_finite() || !unit.y.is_finite() || !about.is_finite() {
            return None;
        }
        let frame = &self.data.frame;
        let mut search = Search {
            space: self,
            along: [unit, unit.right()],
            arm: (about - frame.moving_center) * frame.scale,
            top: f64::NEG_INFINITY,
            best: None,
            is_top_known: false,
        };
        search.all();
        search.is_top_known = true;
        search.all();
        let (_, configuration) = search.best?;
        let place = configuration.fixed_from_moving(about);
        Some(Farthest {
            configuration,
            reach: unit.dot(place.to_vector()),
        })
    }
}

/// The search for the top, and then for the configuration farthest to the right among those that are as far.
struct Search<'a> {
    space: &'a ContactSpace,
    /// The direction, and to the right of it.
    along: [Vector; 2],
    /// The point, from the centre of the moving part in the pair's frame.
    arm: Vector,
    top: f64,
    is_top_known: bool,
    best: Option<(f64, Configuration)>,
}

impl Search<'_> {
    fn all(&mut self) {
        for (i, patch) in self.space.data.patches.iter().enumerate() {
            if !self.space.data.free_regions[patch.region.index()].unbounded {
                self.boundary(patch);
                self.arc(patch, PatchId(i as u32));
            }
        }
    }

    /// How far a place of the pair's frame is, in one of the two directions.
    fn reach<T: Real>(&self, p: Point<T>, turn: Rotation<T>, k: usize) -> T {
        let at = p + turn * self.arm.map(T::constant);
        self.along[k].map(T::constant).dot(at.to_vector())
    }

    /// The least reach that is still looked at.
    fn enough(&self) -> f64 {
        self.top - if self.is_top_known { CONTACT } else { 0.0 }
    }

    /// Looks at a place of the boundary.
    fn look(&mut self, p: Point, theta: f64) {
        let turn = Rotation::by(theta);
        let reach = self.reach(p, turn, 0);
        if reach.is_nan() || reach < self.enough() {
            return;
        }
        let at = (self.space.data.frame).outer_from_inner(p, wrapped(theta, self.space));
        let is_doubtful = self.space.surface().doubts().hold(theta);
        if is_doubtful && self.space.classify(at) == Some(Classification::Blocked) {
            return;
        }
        if !self.is_top_known {
            self.top = reach;
            return;
        }
        let aside = self.reach(p, turn, 1);
        let is_better = self.best.is_none_or(|(known, other)| {
            let farther = aside - known;
            farther > CONTACT || farther >= -CONTACT && at.theta.abs() < other.theta.abs()
        });
        if is_better {
            self.best = Some((aside, at));
        }
    }

    /// The top of a wave: a point that moves with the orientation of a patch is looked at where it begins, where it ends, and where it is
    /// farthest.
    fn wave(&mut self, moves: &Spiral, patch: &Patch, look: impl Fn(&mut Self, f64)) {
        let arm = moves.turning() + self.arm;
        let top = patch.turned_into(self.along[0].angle() - arm.angle());
        for theta in [Some(patch.lo), top, Some(patch.hi)].into_iter().flatten() {
            look(self, theta);
        }
    }

    /// Where the contact curve of a patch begins: every vertex of a slice is one of these.
    fn boundary(&mut self, patch: &Patch) {
        let at = |this: &mut Self, theta: f64| this.look(patch.inner_at(&patch.left, theta), theta);
        match &patch.left {
            Boundary::End { spiral } => self.wave(spiral, patch, at),
            Boundary::Crossing { with, .. } => {
                at(self, patch.lo);
                at(self, patch.hi);
                let [own, other] = [patch.function.carrier(), with.carrier()];
                let stays = [&own, &other].map(|c| self.stays(c));
                if stays == [true; 2] {
                    return;
                }
                // A point that stays as far on a floor goes along it.
                let is_level = |c: &Carrier| self.stays(c) && self.is_floor(c);
                let k = usize::from(is_level(&own) || is_level(&other));
                if k == 0 || self.is_top_known && self.reach_at(patch, patch.lo, 0) >= self.enough()
                {
                    self.crossing(patch, k);
                }
            }
        }
    }

    /// Whether a line or circle stays where it is as seen from the point, to the resolution.
    fn stays(&self, carrier: &Carrier) -> bool {
        !carrier.turns() && (carrier.through.turning() + self.arm).length() <= 0.25 * CONTACT
    }

    /// Whether a carrier is a line across the direction.
    fn is_floor(&self, carrier: &Carrier) -> bool {
        carrier.center().is_none() && carrier.normal.cross(self.along[0]).abs() <= 0.25 * CONTACT
    }

    fn reach_at(&self, patch: &Patch, theta: f64, k: usize) -> f64 {
        let turn = Rotation::by(theta);
        self.reach(patch.inner_at(&patch.left, theta), turn, k)
    }

    /// The tops along a boundary curve at which two contacts cross.
    fn crossing(&mut self, patch: &Patch, k: usize) {
        let mut waiting = vec![(patch.lo, patch.hi)];
        while let Some((lo, hi)) = waiting.pop() {
            let middle = 0.5 * (lo + hi);
            let theta = SecondOrder::<1, _>::variable(Ball::between(lo, hi), 0);
            let over = self.over(patch, theta, k);
            let known = self.reach_at(patch, middle, k);
            let most = |b: Ball| b.mid.abs() + b.radius;
            // The direct enclosure, or that of the mean value theorem, whichever is lower.
            let steps = known + most(over.gradient[0]) * 0.5 * (hi - lo);
            let highest = [over.value.mid + over.value.radius, steps]
                .into_iter()
                .fold(f64::INFINITY, f64::min);
            let enough = match k {
                0 => self.enough(),
                _ => self.best.map_or(f64::NEG_INFINITY, |b| b.0),
            };
            if highest < enough || over.gradient[0].sign() != 0 || over.hessian[0][0].sign() > 0 {
                continue;
            }
            if over.hessian[0][0].sign() < 0 {
                let rises = |theta: f64| {
                    let at = Dual::<1>::variable(theta, 0);
                    self.over(patch, at, k).slope[0] > 0.0
                };
                let (theta, _) = halved((lo, hi), 0.0, rises);
                self.look(patch.inner_at(&patch.left, theta), theta);
                continue;
            }
            let is_level = highest - known <= 0.25 * CONTACT;
            if !self.is_top_known || is_level || hi - lo <= NARROWEST {
                self.look(patch.inner_at(&patch.left, middle), middle);
            }
            if !is_level && hi - lo > NARROWEST {
                waiting.extend([(lo, middle), (middle, hi)]);
            }
        }
    }

    /// How far the beginning of the contact curve is, in any arithmetic.
    fn over<T: Real>(&self, patch: &Patch, theta: T, k: usize) -> T {
        let turn = Rotation::by(theta);
        self.reach(patch.left.inner(&patch.function, turn), turn, k)
    }

    /// Inside an arc, where its normal is against the direction.
    fn arc(&mut self, patch: &Patch, id: PatchId) {
        let Some(center) = patch.function.carrier().center() else {
            return;
        };
        let against = -self.along[0];
        let at = |this: &mut Self, theta: f64| {
            let (space, frame) = (this.space, &this.space.data.frame);
            let place = patch
                .function
                .cycle(Rotation::by(theta))
                .place_of_normal(against);
            let place = frame.outer_from_inner(place, theta).position();
            // Where the normal is not on the arc, the end that is nearest.
            if let Some(curve) = space.curve_at(id, theta) {
                let p = curve.nearest(place);
                this.look(
                    frame.inner_from_outer(Configuration::new(p.x, p.y, theta)),
                    theta,
                );
            }
        };
        self.wave(&center, patch, at);
    }
}

/// An orientation in the turn about 0, of a space of all orientations.
fn wrapped(theta: f64, space: &ContactSpace) -> f64 {
    match space.data.window.full_turn {
        true => wrap(theta),
        false => theta,
    }
}
