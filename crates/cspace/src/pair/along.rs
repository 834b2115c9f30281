//! The first contact along a motion that is given by any smooth functions of time, with bounds on their rates.

use crate::fixed_axes::{Axis, AxisMotion};
use crate::geometry::Point;
use crate::part::Part;

use super::answers::QueryError;
use super::relation::Coordinates;
use super::space::PairSpace;

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

impl PairSpace {
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
        if matches!(self, Self::Lower(_)) {
            return Err(QueryError::Permanent);
        }
        let tolerance = tolerance.max(self.resolution());
        let levers = self.levers();
        let mut time = 0.0;
        let mut step = duration;
        for taken in 0..MOST_STEPS {
            let at = motion.at(time);
            let clearance = match self.clearance(at) {
                Err(QueryError::Outside) if taken > 0 => {
                    return Ok(SmoothOutcome::Leaves { time });
                }
                // The parts as drawn touch slightly later than the parts as computed.
                Err(QueryError::Blocked) if taken > 0 => 0.0,
                clearance => clearance?,
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

    /// Largest speed at which the nearest points can approach, for each unit rate of a coordinate.
    fn levers(&self) -> [f64; 3] {
        let reach = |part: &Part, from: Point| {
            let discs = part.edges().map(|e| e.disc());
            (discs.map(|(middle, radius)| from.distance(middle) + radius)).fold(0.0, f64::max)
        };
        let along = |part: &Part, axis: Axis| match axis.motion {
            AxisMotion::Fixed => 0.0,
            AxisMotion::Revolute { center } => reach(part, center),
            AxisMotion::Prismatic { .. } => 1.0,
        };
        match self {
            Self::FixedAxes(space) => {
                let (a, b) = space.axes();
                [along(self.fixed(), a), along(self.moving(), b), 0.0]
            }
            _ => [1.0, 1.0, reach(self.moving(), Point::ORIGIN)],
        }
    }
}
