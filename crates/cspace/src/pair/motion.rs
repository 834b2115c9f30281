//! Contacts along motions: of constant rates, or given by any smooth functions of time, with bounds on their rates.

use crate::fixed_axes::{AxesMotionOutcome, Axis, AxisMotion};
use crate::geometry::{Point, Vector};
use crate::part::Part;
use crate::query::MotionOutcome;

use super::locate::{covered, distance};
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

pub(super) fn first_contact_about(
    space: &PairSpace,
    (from, rates): (Coordinates, Coordinates),
    about: Vector,
    duration: f64,
) -> Result<PairMotion, QueryError> {
    space.refuse_lower()?;
    let contact = |time, at, patch| PairMotion::Contact(PairContact { time, at, patch });
    Ok(match (space.by_class(from)?, rates) {
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
        _ => return Err(QueryError::coordinates(space.class(), rates)),
    })
}

pub(super) fn crossings(
    space: &PairSpace,
    (from, rates): (Coordinates, Coordinates),
    duration: f64,
) -> Result<Vec<PairCrossing>, QueryError> {
    space.refuse_lower()?;
    let found = match (space.by_class(from)?, rates) {
        (ByClass::Axes(space, u, v), Coordinates::Axes { u: du, v: dv }) => {
            space.crossings((u, v), (du, dv), duration)?
        }
        (ByClass::Planar(space, c), Coordinates::Planar(d)) => {
            space.crossings(c, [d.x, d.y, d.theta], duration)?
        }
        _ => return Err(QueryError::coordinates(space.class(), rates)),
    };
    let found = found.into_iter().map(|(time, patch, enters)| PairCrossing {
        time,
        patch,
        enters,
    });
    Ok(found.collect())
}

pub(super) fn first_contact_along(
    space: &PairSpace,
    motion: &impl SmoothMotion,
    duration: f64,
    tolerance: f64,
) -> Result<SmoothOutcome, QueryError> {
    /// Number of steps after which a motion that stays beside contact is given up.
    const MOST_STEPS: usize = 100_000;
    space.refuse_lower()?;
    let tolerance = tolerance.max(space.resolution());
    let levers = levers(space);
    let mut time = 0.0;
    let mut step = duration;
    for taken in 0..MOST_STEPS {
        let at = motion.at(time);
        // Only the start can be in an overlap: no step is longer than the parts stay apart.
        let clearance = match covered(space, at) {
            Err(QueryError::Outside) if taken > 0 => return Ok(SmoothOutcome::Leaves { time }),
            Ok(()) if taken > 0 => distance(space, at)?,
            _ => space.clearance(at)?,
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
