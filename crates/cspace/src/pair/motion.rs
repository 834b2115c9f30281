//! Contacts along motions: of constant rates, or given by any smooth functions of time, with bounds on their rates.

use crate::fixed_axes::{AxesMotionOutcome, Axis, AxisMotion};
use crate::geometry::{Point, Vector};
use crate::part::Part;
use crate::query::MotionOutcome;

use super::space::ByClass;
use super::{Coordinates, PairContact, PairCrossing, PairMotion, PairSpace, QueryError};

/// A motion given by functions of time with bounded rates.
pub trait SmoothMotion {
    /// The configuration at a time.
    fn at(&self, time: f64) -> Coordinates;

    /// Bounds on the absolute values of the rates of the coordinates at all times of an interval: of x, y and θ; or of u and v, with a
    /// third value that is ignored.
    fn rate_bounds(&self, from: f64, to: f64) -> [f64; 3];
}

/// Outcome of a smooth motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SmoothOutcome {
    /// The motion is free to the end.
    Free,
    /// The motion is free until the parts are nearer to each other than the tolerance.
    Contact {
        /// Time at which they are.
        time: f64,
        /// Configuration at that time.
        at: Coordinates,
    },
    /// The motion is free until it leaves the window of orientations or the range of a part's motion, about at this time.
    Leaves {
        /// Time at which it leaves, approximately.
        time: f64,
    },
    /// The motion is free until this time, and continues so near to contact that it could not be followed further.
    Grazes {
        /// Time until which it is free.
        time: f64,
    },
}

/// Contacts along a motion.
impl PairSpace {
    /// The first contact when the configuration moves from `from` at constant `rates` at times from 0 to `duration`.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins where the parts overlap or outside the space, or the
    /// parts are a lower pair, which is in permanent contact.
    pub fn first_contact(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        self.first_contact_about(from, rates, Vector::ZERO, duration)
    }

    /// The first contact of a motion along which the moving part's point `about`, in the part's frame, moves on a straight line: see
    /// [`ContactSpace::first_contact_about`](crate::ContactSpace::first_contact_about). Parts on fixed axes move as their axes let them,
    /// whatever `about` is.
    ///
    /// # Errors
    /// As [`first_contact`](Self::first_contact).
    pub fn first_contact_about(
        &self,
        from: Coordinates,
        rates: Coordinates,
        about: Vector,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        self.refuse_lower()?;
        let contact = |time, at, patch| PairMotion::Contact(PairContact { time, at, patch });
        Ok(match (self.by_class(from)?, rates) {
            (ByClass::Axes(space, u, v), Coordinates::Axes { u: du, v: dv }) => {
                match space.first_contact((u, v), (du, dv), duration)? {
                    AxesMotionOutcome::Free => PairMotion::Free,
                    AxesMotionOutcome::Leaves { time } => PairMotion::Leaves { time },
                    AxesMotionOutcome::Contact(c) => {
                        contact(c.time, Coordinates::of_axes(c.at), c.patch)
                    }
                }
            }
            (ByClass::Planar(space, c), Coordinates::Planar(d)) => {
                match space.first_contact_about(c, [d.x, d.y, d.theta], about, duration)? {
                    MotionOutcome::Free => PairMotion::Free,
                    MotionOutcome::LeavesWindow { time } => PairMotion::Leaves { time },
                    MotionOutcome::Contact(c) => {
                        contact(c.time, Coordinates::Planar(c.configuration), c.patch)
                    }
                }
            }
            _ => return Err(QueryError::coordinates(self.class(), rates)),
        })
    }

    /// All contacts that a motion of constant rates crosses at times from 0 to `duration`, also where the parts overlap, in order of time.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins outside the space, or the parts are a
    /// lower pair.
    pub fn crossings(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<Vec<PairCrossing>, QueryError> {
        self.refuse_lower()?;
        let found = match (self.by_class(from)?, rates) {
            (ByClass::Axes(space, u, v), Coordinates::Axes { u: du, v: dv }) => {
                space.crossings((u, v), (du, dv), duration)?
            }
            (ByClass::Planar(space, c), Coordinates::Planar(d)) => {
                space.crossings(c, [d.x, d.y, d.theta], duration)?
            }
            _ => return Err(QueryError::coordinates(self.class(), rates)),
        };
        let found = found.into_iter().map(|(time, patch, enters)| PairCrossing {
            time,
            patch,
            enters,
        });
        Ok(found.collect())
    }

    /// The first contact along a smooth motion, at times from 0 to `duration`.
    ///
    /// In a time dt, no point of the moving part can come nearer to the fixed part than by dt times a bound on its speed: for a planar
    /// configuration |(ẋ, ẏ)| + ρ |θ̇|, with ρ the largest distance of the part's boundary from its origin; for fixed axes the sum of both
    /// parts' speeds. So the [clearance](Self::clearance) divided by that bound is a time without contact, and steps of such times approach
    /// the first contact without ever passing through one.
    ///
    /// A contact is where the clearance is less than `tolerance` (model length), which is raised to the [resolution](Self::resolution) if
    /// it is smaller.
    ///
    /// # Errors
    /// If coordinates are of another class, or the motion begins where the parts overlap or outside the space, or the parts
    /// are a lower pair.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation, SmoothMotion, SmoothOutcome, Vertex};
    /// let disc = |r: f64| Part::new("disc", vec![vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)]]);
    /// let space = PairSpace::compute(&disc(2.0)?, &disc(1.0)?, Relation::Planar, &Options::default())?;
    /// /// Along the parabola y = x², from the far left.
    /// struct Parabola;
    /// impl SmoothMotion for Parabola {
    ///     fn at(&self, t: f64) -> Coordinates {
    ///         Coordinates::Planar(Configuration::new(t - 3.0, (t - 3.0).powi(2), 0.0))
    ///     }
    ///     fn rate_bounds(&self, from: f64, to: f64) -> [f64; 3] {
    ///         [1.0, 2.0 * (from - 3.0).abs().max((to - 3.0).abs()), 0.0]
    ///     }
    /// }
    /// let SmoothOutcome::Contact { time, .. } = space.first_contact_along(&Parabola, 6.0, 1e-9)? else {
    ///     panic!("it should touch");
    /// };
    /// // x² + x⁴ = 9.
    /// let x = -((37.0_f64.sqrt() - 1.0) / 2.0).sqrt();
    /// assert!((time - 3.0 - x).abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn first_contact_along(
        &self,
        motion: &impl SmoothMotion,
        duration: f64,
        tolerance: f64,
    ) -> Result<SmoothOutcome, QueryError> {
        /// Number of steps after which a motion that stays beside contact is given up.
        const MOST_STEPS: usize = 100_000;
        self.refuse_lower()?;
        let tolerance = tolerance.max(self.resolution());
        let levers = levers(self);
        let mut time = 0.0;
        let mut step = duration;
        for taken in 0..MOST_STEPS {
            let at = motion.at(time);
            // Only the start can be in an overlap: no step is longer than the parts stay apart.
            let clearance = match self.covered(at) {
                Err(QueryError::Outside) if taken > 0 => return Ok(SmoothOutcome::Leaves { time }),
                Ok(here) if taken > 0 => self.distance(&here),
                _ => self.clearance(at)?,
            };
            if clearance <= tolerance {
                return Ok(SmoothOutcome::Contact { time, at });
            }
            if time >= duration {
                return Ok(SmoothOutcome::Free);
            }
            // Step for which the clearance lasts; slightly less, so that parts that approach at the bound are still apart.
            let lasts = clearance - 0.5 * tolerance;
            step = (4.0 * step).min(duration - time);
            let passes = |step: f64| {
                let bounds = motion.rate_bounds(time, time + step);
                let speed: f64 = (levers.iter().zip(bounds)).map(|(l, b)| l * b.abs()).sum();
                speed * step <= lasts
            };
            while !passes(step) {
                step *= 0.5;
                if time + step <= time {
                    return Ok(SmoothOutcome::Grazes { time });
                }
            }
            time = if step >= duration - time {
                duration
            } else {
                time + step
            };
        }
        Ok(SmoothOutcome::Grazes { time })
    }
}

/// Largest speed at which the nearest points can approach, for each unit rate of a coordinate.
fn levers(space: &PairSpace) -> [f64; 3] {
    let reach = |part: &Part, from: Point| {
        let discs = part.edges().map(|e| e.disc());
        (discs.map(|(middle, radius)| from.distance(middle) + radius)).fold(0.0, f64::max)
    };
    let along = |part: &Part, axis: Axis| match axis.motion {
        AxisMotion::Fixed => 0.0,
        AxisMotion::Revolute { center } => reach(part, center),
        AxisMotion::Prismatic { .. } => 1.0,
    };
    match space {
        PairSpace::FixedAxes(space) => {
            let (a, b) = space.axes();
            [along(space.fixed(), a), along(space.moving(), b), 0.0]
        }
        _ => [1.0, 1.0, reach(space.moving(), Point::ORIGIN)],
    }
}
