//! The first contact along a motion of constant rates.

use super::along::{Along, Way};
use super::domain::{Extent, ExtentKind};
use super::motion::Motion;
use super::space::FixedAxesSpace;
use super::tolerance::NEAR;
use super::visits::Visits;
use crate::query::{Classification, MotionError};

/// Where a motion on fixed axes first touches.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesContact {
    /// When, in the unit of time of the rates.
    pub time: f64,
    /// The configuration (u, v) then.
    pub at: (f64, f64),
    /// The patch it touches: one of them, where it touches several.
    pub patch: u32,
}

/// What becomes of a motion on fixed axes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum AxesMotionOutcome {
    /// It is free to the end.
    Free,
    /// It touches.
    Contact(AxesContact),
    /// It is free until it leaves the range of a part's motion, at this time.
    Leaves {
        /// When.
        time: f64,
    },
}

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
    /// use cspace::fixed_axes::AxesMotionOutcome;
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(-1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// let AxesMotionOutcome::Contact(contact) = space.first_contact((0.0, 0.0), (0.0, 2.0), 10.0)? else {
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
    ) -> Result<AxesMotionOutcome, MotionError> {
        check(from, rates, duration)?;
        let touches = match self.classify(from.0, from.1) {
            None => return Err(MotionError::StartsOutside),
            Some(Classification::Blocked) => return Err(MotionError::StartsBlocked),
            Some(class) => class == Classification::Contact,
        };
        let way = self.way(from, rates);
        let leaves = self.time_in_ranges(&way).filter(|&t| t < duration);
        let end = leaves.unwrap_or(duration);
        let mut first: Option<(f64, u32)> = None;
        for b in &self.data.branches {
            let until = first.map_or(end, |f| f.0);
            if let Some(time) = self.meets(&way, b.cell, until, touches) {
                let earlier = first.is_none_or(|f| (time, b.patch) < f);
                if earlier {
                    first = Some((time, b.patch));
                }
            }
        }
        Ok(match (first, leaves) {
            (Some((time, patch)), _) => AxesMotionOutcome::Contact(AxesContact {
                time,
                at: (from.0 + rates.0 * time, from.1 + rates.1 * time),
                patch,
            }),
            (None, Some(time)) => AxesMotionOutcome::Leaves { time },
            (None, None) => AxesMotionOutcome::Free,
        })
    }

    /// Every contact that the motion comes through, for times from 0 to `duration`, also where the parts overlap: when, which
    /// patch, and whether the motion goes into blocked space there; in order of time.
    ///
    /// Roots are found as those of [`first_contact`](Self::first_contact); a motion that only touches comes through nothing.
    ///
    /// # Errors
    /// If numbers are not finite, or the motion begins outside the ranges.
    pub fn crossings(
        &self,
        from: (f64, f64),
        rates: (f64, f64),
        duration: f64,
    ) -> Result<Vec<(f64, u32, bool)>, MotionError> {
        check(from, rates, duration)?;
        if self.setting.placed(from.0, from.1).is_none() {
            return Err(MotionError::StartsOutside);
        }
        let way = self.way(from, rates);
        let end = self
            .time_in_ranges(&way)
            .map_or(duration, |t| t.min(duration));
        // What rises on the way falls on the way back.
        let back = Way {
            x: way.x + way.dx * end,
            y: way.y + way.dy * end,
            dx: -way.dx,
            dy: -way.dy,
        };
        let mut found = Vec::new();
        for b in &self.data.branches {
            let mut add = |way: &Way, enters: bool| {
                self.falls_through(way, b.cell, end, |time| {
                    let time = if enters { time } else { end - time };
                    found.push((time, b.patch, enters));
                    false
                });
            };
            add(&way, true);
            add(&back, false);
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        Ok(found)
    }

    /// The motion in the coordinates of the sweep.
    fn way(&self, from: (f64, f64), rates: (f64, f64)) -> Way {
        let (x, y) = self.setting.map.inner(from.0, from.1);
        let (dx, dy) = self.setting.map.inner(rates.0, rates.1);
        // As configurations are placed.
        match self.setting.on_one_line() {
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
        let of = |extent: &Extent, motion: Motion, t: f64, rate: f64| {
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
        let a = of(&self.setting.x, self.setting.motions.first, way.x, way.dx);
        let b = of(&self.setting.y, self.setting.motions.second, way.y, way.dy);
        match (a, b) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        }
    }

    /// The first time at which the motion goes through a cell into blocked space, up to `until`.
    fn meets(&self, way: &Way, cell: u32, until: f64, starts_touching: bool) -> Option<f64> {
        let along = Along {
            condition: self.graphs().condition(cell),
            way,
        };
        let mut found = None;
        let distance = self.setting.inner_contact_distance();
        if starts_touching && self.touches_at(way, cell, 0.0) {
            let (value, slope) = along.distance(0.0);
            if value.abs() <= distance && slope < 0.0 {
                return Some(0.0);
            }
        }
        self.falls_through(way, cell, until, |time| {
            found = Some(time);
            true
        });
        found
    }

    /// Calls `take` with every time at which the motion goes through a cell into blocked space, until it returns true.
    fn falls_through(&self, way: &Way, cell: u32, until: f64, mut take: impl FnMut(f64) -> bool) {
        let along = Along {
            condition: self.graphs().condition(cell),
            way,
        };
        // Only while the way is in the cell's box.
        let (x_range, y_range) = self.graphs().cell_box(cell);
        let both = (
            Visits::new((way.x, way.dx), x_range, self.setting.x.is_circle(), until),
            Visits::new((way.y, way.dy), y_range, self.setting.y.is_circle(), until),
        );
        let (Some(in_x), Some(in_y)) = both else {
            return;
        };
        in_x.shared(&in_y, until, |lo, hi| {
            along.falls(lo, hi, &mut |time| {
                self.touches_at(way, cell, time) && take(time)
            })
        });
    }

    fn touches_at(&self, way: &Way, cell: u32, time: f64) -> bool {
        let (u, v) = self
            .setting
            .map
            .outer(way.x + way.dx * time, way.y + way.dy * time);
        let distance = self.setting.inner_contact_distance();
        self.setting.placed(u, v).is_some_and(|(x, y)| {
            self.in_box(cell, x, y, NEAR) && self.on_own_root(cell, x, y, distance)
        })
    }
}

/// Whether a motion is one.
fn check(from: (f64, f64), rates: (f64, f64), duration: f64) -> Result<(), MotionError> {
    let numbers = [from.0, from.1, rates.0, rates.1, duration];
    let finite = numbers.iter().all(|n| (n * n).is_finite());
    if finite && duration >= 0.0 {
        Ok(())
    } else {
        Err(MotionError::NotFinite)
    }
}
