//! The first contact along a motion of constant rates.

use crate::pair::{Coordinates, PairContact, PairMotion, PatchId};
use crate::query::{Classification, MotionError};

use super::along::{Along, Way};
use super::classify::NEAR;
use super::condition::Condition;
use super::domain::ExtentKind;
use super::motion::Motion;
use super::space::FixedAxesSpace;
use super::visits::Visits;

impl FixedAxesSpace {
    /// The first contact when the parts move from `from` at constant rates (du/dt, dv/dt) for times from 0 to `duration`.
    ///
    /// Along the motion the contact condition of each curve is a smooth function of time (for two arcs the square of the
    /// centres' distance). A bound on its second derivative tells for any interval of time that it holds no root, or one
    /// at most; other intervals are halved. A root counts if the parts come closer there and the configuration is on the
    /// curve. Nothing is found by sampling. Motions that touch without going deeper go on. A motion that asks a part to move that does not leaves its range at once.
    ///
    /// The time this takes grows with the number of turns until the contact.
    ///
    /// # Errors
    /// If numbers are not finite, or the motion begins in blocked space or outside the ranges.
    ///
    /// ```
    /// use cspace::pair::PairMotion;
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(-1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// let PairMotion::Contact(contact) = space.first_contact((0.0, 0.0), (0.0, 2.0), 10.0)? else {
    ///     panic!("it should touch");
    /// };
    /// assert!((contact.time - 1.5).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact(
        &self,
        from: (f64, f64),
        rates: (f64, f64),
        duration: f64,
    ) -> Result<PairMotion, MotionError> {
        let numbers = [from.0, from.1, rates.0, rates.1, duration];
        if !numbers.iter().all(|n| (n * n).is_finite()) || duration < 0.0 {
            return Err(MotionError::NotFinite);
        }
        let touches = match self.classify(from.0, from.1) {
            None => return Err(MotionError::StartsOutside),
            Some(Classification::Blocked) => return Err(MotionError::StartsBlocked),
            Some(class) => class == Classification::Contact,
        };
        let way = self.way(from, rates);
        let leaves = self.time_in_ranges(&way).filter(|&t| t < duration);
        let end = leaves.unwrap_or(duration);
        let mut first: Option<(f64, u32)> = None;
        for b in &self.branches {
            let until = first.map_or(end, |f| f.0);
            if let Some(time) = self.meets(&way, b.cell(), until, touches) {
                let earlier = first.is_none_or(|f| (time, b.patch) < f);
                if earlier {
                    first = Some((time, b.patch));
                }
            }
        }
        Ok(match (first, leaves) {
            (Some((time, patch)), _) => PairMotion::Contact(PairContact {
                time,
                at: Coordinates::Axes {
                    u: from.0 + rates.0 * time,
                    v: from.1 + rates.1 * time,
                },
                patch: PatchId(patch),
            }),
            (None, Some(time)) => PairMotion::Leaves { time },
            (None, None) => PairMotion::Free,
        })
    }

    /// The motion in the coordinates of the sweep.
    fn way(&self, from: (f64, f64), rates: (f64, f64)) -> Way {
        let (x, y) = self.map.inner(from.0, from.1);
        let (dx, dy) = self.map.inner(rates.0, rates.1);
        // As configurations are placed.
        match self.on_one_line() {
            Some(share) => Way {
                x: 0.0,
                y: y - x * share,
                dx: 0.0,
                dy: dy - dx * share,
            },
            None => Way { x, y, dx, dy },
        }
    }

    /// When the motion leaves the ranges, if it does.
    fn time_in_ranges(&self, way: &Way) -> Option<f64> {
        let of = |extent: &super::domain::Extent, motion: Motion, t: f64, rate: f64| {
            if motion == Motion::Still && rate != 0.0 {
                return Some(0.0);
            }
            let limited = matches!(
                extent.kind,
                ExtentKind::TurnLimits | ExtentKind::SlideLimits
            );
            match rate {
                r if !limited || r == 0.0 => None,
                r if r > 0.0 => Some(((extent.hi - t) / r).max(0.0)),
                r => Some(((extent.lo - t) / r).max(0.0)),
            }
        };
        let a = of(&self.x, self.motions.first, way.x, way.dx);
        let b = of(&self.y, self.motions.second, way.y, way.dy);
        match (a, b) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }

    /// The first time at which the motion goes through a cell into blocked space, up to `until`.
    fn meets(&self, way: &Way, cell: u32, until: f64, starts_touching: bool) -> Option<f64> {
        let along = Along {
            condition: self.condition_of(cell),
            way,
        };
        let mut found = None;
        let distance = self.contact_distance() * self.map.frame.scale;
        if starts_touching && self.touches_at(way, cell, 0.0) {
            let (value, slope) = along.distance(0.0);
            if value.abs() <= distance && slope < 0.0 {
                return Some(0.0);
            }
        }
        // Only while the way is in the cell's box.
        let (x_range, y_range) = self.cell_box(cell);
        let both = (
            Visits::new((way.x, way.dx), x_range, self.x.is_circle(), until),
            Visits::new((way.y, way.dy), y_range, self.y.is_circle(), until),
        );
        let (Some(in_x), Some(in_y)) = both else {
            return None;
        };
        in_x.shared(&in_y, until, |lo, hi| {
            along.falls(lo, hi, &mut |time| {
                let here = self.touches_at(way, cell, time);
                if here {
                    found = Some(time);
                }
                here
            })
        });
        found
    }

    fn condition_of(&self, cell: u32) -> &Condition {
        let (_, piece) = self.cell_and_piece(cell);
        &self.pairs[piece.pair as usize].condition
    }

    fn touches_at(&self, way: &Way, cell: u32, time: f64) -> bool {
        let (u, v) = self.map.outer(way.x + way.dx * time, way.y + way.dy * time);
        let distance = self.contact_distance() * self.map.frame.scale;
        self.placed(u, v).is_some_and(|(x, y)| {
            self.in_box(cell, x, y, NEAR) && self.on_own_root(cell, x, y, distance)
        })
    }
}
