//! How far a coordinate goes until something touches, the others held.

use core::f64::consts::TAU;

use cspace::pair::{PairContact, PairMotion};
use cspace::{Axis, AxisMotion, Configuration, Coordinates, PairSpace, Point, QueryError};
use cspace_model::model::Coordinate;

use crate::motion::Motion;
use crate::touching::touching;
use crate::value::{Stop, Unmeasured};

/// How far a coordinate goes down and up from a free configuration when it alone changes, and what stops it there; nothing where it
/// goes on without end.
///
/// # Errors
/// If the configuration is not free, or has no such coordinate.
pub fn free_range(
    space: &PairSpace,
    of: Coordinate,
    at: Coordinates,
) -> Result<[Option<(f64, Stop)>; 2], Unmeasured> {
    let now = of.of(at).ok_or_else(|| wrong_class(space, at))?;
    let far = reach(space, at, of);
    let mut ends = [None, None];
    for (end, way) in ends.iter_mut().zip([-1.0, 1.0]) {
        let motion = Motion::new(at, unit(of, way));
        let (time, features) = match motion.first_contact(space, far)? {
            PairMotion::Free => continue,
            PairMotion::Leaves { time } => (time, Vec::new()),
            PairMotion::Contact(contact) => (
                as_drawn(space, &motion, &contact)?,
                touching(space, &motion, &contact)?,
            ),
        };
        let stop = Stop {
            at: motion.at(time),
            features,
        };
        *end = Some((now + way * time, stop));
    }
    Ok(ends)
}

/// The time of a contact at which the features touch as they are drawn.
///
/// A space is that of parts that are larger by 10⁻¹² of their size and displaced by as little, so that contacts come early by
/// somewhat more than that. The contact function of the features as drawn has a root nearby, found by Newton's method; where it has none, as beside a
/// tangency, the contact's own time remains.
pub(crate) fn as_drawn(
    space: &PairSpace,
    motion: &Motion,
    contact: &PairContact,
) -> Result<f64, QueryError> {
    const STEPS: usize = 6;
    let features = space.patch(contact.patch)?.contact()?;
    // How far off, as drawn, a contact of the space may be (length).
    let near = 1e3 * space.resolution();
    let mut time = contact.time;
    for step in 0..STEPS {
        let found = features.evaluate(motion.at(time))?;
        let rate: f64 = match motion.rates {
            Coordinates::Planar(d) => {
                let [x, y, theta] = found.gradient;
                x * d.x + y * d.y + theta * d.theta
            }
            Coordinates::Axes { u, v } => found.gradient[0] * u + found.gradient[1] * v,
        };
        let next = time - found.value / rate;
        let is_near = found.value.abs() <= near && (next - contact.time).abs() * rate.abs() <= near;
        if !is_near {
            return Ok(contact.time);
        }
        if step > 1 && next == time {
            break;
        }
        time = next;
    }
    Ok(time)
}

pub(crate) fn wrong_class(space: &PairSpace, given: Coordinates) -> Unmeasured {
    Unmeasured::Query(QueryError::Coordinates {
        class: space.class(),
        wanted: match space {
            PairSpace::FixedAxes(_) => "u, v",
            _ => "x, y, theta",
        },
        given: given.names(),
    })
}

/// Coordinates as numbers, of fixed axes two and a 0.
pub(crate) fn numbers(at: Coordinates) -> [f64; 3] {
    match at {
        Coordinates::Planar(c) => [c.x, c.y, c.theta],
        Coordinates::Axes { u, v } => [u, v, 0.0],
    }
}

/// A rate of one coordinate.
pub(crate) fn unit(of: Coordinate, rate: f64) -> Coordinates {
    match of {
        Coordinate::X => Coordinates::Planar(Configuration::new(rate, 0.0, 0.0)),
        Coordinate::Y => Coordinates::Planar(Configuration::new(0.0, rate, 0.0)),
        Coordinate::Theta => Coordinates::Planar(Configuration::new(0.0, 0.0, rate)),
        Coordinate::U => Coordinates::Axes { u: rate, v: 0.0 },
        Coordinate::V => Coordinates::Axes { u: 0.0, v: rate },
    }
}

/// How far from a configuration a coordinate changes until all contact is behind: a turn of an orientation; of a slide without a range
/// beyond the parts; with a range, beyond it.
pub fn reach(space: &PairSpace, at: Coordinates, of: Coordinate) -> f64 {
    match (space, at, of) {
        (_, _, Coordinate::Theta) => TAU,
        (PairSpace::FixedAxes(axes), Coordinates::Axes { u, v }, _) => {
            let (fixed, moving): (Axis, Axis) = axes.axes();
            let [u_extent, v_extent] = axes.extent();
            let (axis, (lo, hi), now) = match of {
                Coordinate::U => (fixed, u_extent, u),
                _ => (moving, v_extent, v),
            };
            match (axis.range, axis.motion) {
                (Some((lo, hi)), _) => 2.0 * (hi - lo),
                (None, AxisMotion::Revolute { .. }) => TAU,
                (None, _) => (hi - lo) + (now - lo).abs() + (now - hi).abs(),
            }
        }
        (_, Coordinates::Planar(c), _) => {
            // Farther apart than their sizes nothing touches.
            let sizes = space.fixed().size() + space.moving().size();
            let reach = |p: Point| p.to_vector().length();
            let bounds = [space.fixed().bounds(), space.moving().bounds()];
            let arms: f64 = bounds.iter().map(|b| reach(b.min).max(reach(b.max))).sum();
            2.0 * (c.x.hypot(c.y) + arms + sizes)
        }
        _ => TAU,
    }
}
