//! One quantity, measured on a space.

use core::f64::consts::TAU;

use cspace::pair::{PairContact, PairMotion};
use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Location, MotionError, PairSpace, Point,
    QueryError, RegionId,
};
use cspace_model::model::{Coordinate, Quantity};
use cspace_plan::{Clearance, PlanError, Planner, Verdict, Wishes};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::motion::Motion;
use crate::touching::{FeaturePair, texts, touching};

/// Measured value of a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// A length in the model's unit, or an angle in radians.
    Number(f64),
    /// Yes or no.
    Truth(bool),
}

/// A quantity and what it comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: Value,
    /// For a play the two ends of the range, as values of its coordinate.
    pub range: Option<(f64, f64)>,
    /// Stops that determine the quantity: for a play both ends, the lower first; for a position the contact; for a clearance the
    /// configuration itself.
    pub stops: Vec<Stop>,
}

/// A configuration that decides a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// The configuration, features touching as they are drawn.
    pub at: Coordinates,
    /// The features of both parts that touch there, or are nearest; none at the end of a part's range.
    pub features: Vec<FeaturePair>,
}

impl Measured {
    /// A number that no configuration of a pair decides.
    pub(crate) const fn number(value: f64) -> Self {
        Self {
            value: Value::Number(value),
            range: None,
            stops: Vec::new(),
        }
    }

    /// Features in contact where the quantity ends: of the fixed and of the moving part, as messages call them.
    pub fn touching(&self, space: &PairSpace) -> Vec<[String; 2]> {
        let mut all: Vec<FeaturePair> = Vec::new();
        for &pair in self.stops.iter().flat_map(|s| &s.features) {
            if !all.contains(&pair) {
                all.push(pair);
            }
        }
        all.into_iter().map(|pair| texts(space, pair)).collect()
    }
}

/// Why a quantity has no value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Unmeasured {
    /// The parts overlap at the configuration at which it is measured.
    #[error("the parts overlap at the configuration: choose one that is free")]
    Blocked,
    /// Nothing ends a play.
    #[error("nothing stops the part in this coordinate: there is no play to measure")]
    Unlimited,
    /// A motion meets nothing.
    #[error("nothing touches along the motion: give a longer `along`, or another direction")]
    NoContact,
    /// A motion ends at the limit of a range or window before it meets anything.
    #[error(
        "the motion leaves the range of a part's motion, or the window of orientations, before anything touches"
    )]
    Leaves,
    /// No motion leads from one configuration to another.
    #[error("no motion without overlap leads there")]
    NoWay,
    /// Whether a motion leads from one configuration to another is not known.
    #[error("it is not known whether a motion leads there: the space is doubtful on the way")]
    Undecided,
    /// A configuration in contact is between regions.
    #[error("the configuration is in contact between two free regions: choose one in either")]
    Between,
    /// A coordinate of a region goes on without end.
    #[error("the coordinate has no end in the free region: it goes on")]
    Endless,
    /// Nothing moves at a contact.
    #[error("the point where the parts touch does not move when this coordinate changes")]
    Still,
    /// The question has no answer at the configuration.
    #[error("{0}")]
    Query(QueryError),
    /// An event does not happen.
    #[error("this does not happen within the time: give a longer `time`, or another event")]
    Never,
    /// A part does not go on, so that there is no ratio by it.
    #[error("the part `by` does not move on: there is no ratio")]
    NoAdvance,
    /// A motion does not come to the end of its time.
    #[error("the motion ends at {until} s: {why}")]
    EndsEarly {
        /// When it ends, in seconds.
        until: f64,
        /// Why.
        why: &'static str,
        /// Whether it is known that it does not go on.
        is_known: bool,
    },
    /// The pair's configuration space cannot be computed, or the motion cannot be followed.
    #[error("{0}")]
    Space(String),
    /// The requirement is not one of the model.
    #[error("the requirement is not one of the model")]
    Unknown,
}

impl Unmeasured {
    /// Whether the quantity may have a value, which could not be found: nothing is known of it, not even that it has none.
    pub fn is_undecided(&self) -> bool {
        match self {
            Self::Undecided | Self::Space(_) | Self::Unknown => true,
            Self::EndsEarly { is_known, .. } => !is_known,
            _ => false,
        }
    }
}

impl From<QueryError> for Unmeasured {
    fn from(error: QueryError) -> Self {
        match error {
            QueryError::Blocked | QueryError::Motion(MotionError::StartsBlocked) => Self::Blocked,
            other => Self::Query(other),
        }
    }
}

/// Measures a quantity.
///
/// A play is the sum of two motions of constant rates from the configuration to their first contacts or to the ends of the part's range. A
/// position is that of the first contact along the motion.
///
/// # Errors
/// If the quantity has no value there.
pub fn measure(space: &PairSpace, quantity: &Quantity) -> Result<Measured, Unmeasured> {
    match *quantity {
        Quantity::Play { of, at } => play(space, of, at),
        Quantity::Position { from, along, of } => position(space, from, along, of),
        Quantity::Clearance { at } => Ok(Measured {
            value: Value::Number(space.clearance(at)?),
            range: None,
            stops: vec![Stop {
                at,
                features: nearest(space, at)?,
            }],
        }),
        Quantity::Angle { at, along, of } => angle(space, at, along, of),
        Quantity::Bottleneck { at, to } => bottleneck(space, at, to),
        Quantity::Extreme { at, of, upper } => extreme(space, at, of, upper),
        Quantity::Caged { at } => {
            let region = region(space, at)?;
            let region = space.regions().into_iter().find(|r| r.id == region);
            Ok(truth(region.is_some_and(|r| !r.unbounded)))
        }
        Quantity::Connected { at, to } => Ok(truth(region(space, at)? == region(space, to)?)),
    }
}

/// The free region of a configuration; of one in contact, the region that its contacts bound.
fn region(space: &PairSpace, at: Coordinates) -> Result<RegionId, Unmeasured> {
    /// Contacts within so many resolutions are those at a configuration.
    const TOUCHING: f64 = 8.0;
    match space.locate(at)? {
        Location::Free(region) => Ok(region),
        Location::Outside => Err(QueryError::Outside.into()),
        Location::Blocked => Err(Unmeasured::Blocked),
        Location::Contact => {
            let mut found = None;
            for (patch, _) in space.contacts(at, TOUCHING * space.resolution())? {
                let region = space.patch(patch)?.region()?;
                match (found, region) {
                    (None, Some(region)) => found = Some(region),
                    (Some(a), Some(b)) if a != b => return Err(Unmeasured::Between),
                    _ => {}
                }
            }
            found.ok_or(Unmeasured::Blocked)
        }
    }
}

fn truth(value: bool) -> Measured {
    Measured {
        value: Value::Truth(value),
        range: None,
        stops: Vec::new(),
    }
}

fn play(space: &PairSpace, of: Coordinate, at: Coordinates) -> Result<Measured, Unmeasured> {
    let [below, above] = free_range(space, of, at)?;
    let (Some((lo, first)), Some((hi, second))) = (below, above) else {
        return Err(Unmeasured::Unlimited);
    };
    Ok(Measured {
        value: Value::Number(hi - lo),
        range: Some((lo, hi)),
        stops: vec![first, second],
    })
}

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

fn position(
    space: &PairSpace,
    from: Coordinates,
    along: Coordinates,
    of: Coordinate,
) -> Result<Measured, Unmeasured> {
    let stop = first_stop(space, from, along)?;
    let value = of.of(stop.at).ok_or_else(|| wrong_class(space, from))?;
    Ok(Measured {
        value: Value::Number(value),
        range: None,
        stops: vec![stop],
    })
}

/// The first contact of a motion of constant rates.
fn first_stop(
    space: &PairSpace,
    from: Coordinates,
    along: Coordinates,
) -> Result<Stop, Unmeasured> {
    let motion = Motion::new(from, along);
    match motion.first_contact(space, 1.0)? {
        PairMotion::Free => Err(Unmeasured::NoContact),
        PairMotion::Leaves { .. } => Err(Unmeasured::Leaves),
        PairMotion::Contact(contact) => Ok(Stop {
            at: motion.at(as_drawn(space, &motion, &contact)?),
            features: touching(space, &motion, &contact)?,
        }),
    }
}

/// The angle between the normal n at a contact and the velocity w of its point when a coordinate changes: cos = |n·w| / |w|, where n·w is the
/// derivative of the contact function.
fn angle(
    space: &PairSpace,
    at: Coordinates,
    along: Option<Coordinates>,
    of: Coordinate,
) -> Result<Measured, Unmeasured> {
    let stop = match along {
        None => Stop {
            at,
            features: nearest(space, at)?,
        },
        Some(along) => first_stop(space, at, along)?,
    };
    let (fixed, moving) = *stop.features.first().ok_or(Unmeasured::NoContact)?;
    let contact = space.contact_of(fixed, moving)?;
    let along_normal = contact.evaluate(stop.at)?.gradient[of.index()];
    let touching = contact.touching(stop.at)?;
    // How far the point is from what it turns about.
    let arm = match (space, stop.at) {
        (_, Coordinates::Planar(c)) => match of {
            Coordinate::Theta => touching.on_moving.distance(c.position()),
            _ => 1.0,
        },
        (PairSpace::FixedAxes(axes), Coordinates::Axes { u, .. }) => {
            let (a, b): (Axis, Axis) = axes.axes();
            let in_ground = a.configuration(u).fixed_from_moving(touching.on_fixed);
            match if of == Coordinate::U { a } else { b }.motion {
                AxisMotion::Revolute { center } => in_ground.distance(center),
                _ => 1.0,
            }
        }
        _ => return Err(wrong_class(space, stop.at)),
    };
    if arm == 0.0 {
        return Err(Unmeasured::Still);
    }
    Ok(Measured {
        value: Value::Number((along_normal.abs() / arm).min(1.0).acos()),
        range: None,
        stops: vec![stop],
    })
}

fn bottleneck(space: &PairSpace, at: Coordinates, to: Coordinates) -> Result<Measured, Unmeasured> {
    let unplanned = |e: PlanError| Unmeasured::Space(e.to_string());
    let wishes = Wishes {
        clearance: Clearance::Widest,
        ..Wishes::default()
    };
    let planner = Planner::new(space).map_err(unplanned)?;
    let answer = planner.plan(at, to, &wishes).map_err(unplanned)?;
    match answer.verdict {
        Verdict::Path(path) => {
            let narrow = answer.bottleneck.map_or(path.narrowest, |b| b.narrow);
            Ok(Measured {
                value: Value::Number(narrow.clearance),
                range: None,
                stops: vec![Stop {
                    at: narrow.at,
                    features: narrow.features.into_iter().collect(),
                }],
            })
        }
        Verdict::FromBlocked(_) | Verdict::ToBlocked(_) => Err(Unmeasured::Blocked),
        Verdict::Unknown(_) => Err(Unmeasured::Undecided),
        Verdict::NoPath(_) | Verdict::TooNarrow => Err(Unmeasured::NoWay),
    }
}

fn extreme(
    space: &PairSpace,
    at: Coordinates,
    of: Coordinate,
    upper: bool,
) -> Result<Measured, Unmeasured> {
    let PairSpace::FixedAxes(axes) = space else {
        return Err(Unmeasured::Blocked);
    };
    let region = &axes.regions()[region(space, at)?.index()];
    let (range, open, around) = match of {
        Coordinate::U => (region.u, region.open_u, region.around_u),
        _ => (region.v, region.open_v, region.around_v),
    };
    let (value, is_open) = if upper {
        (range.1, open.1)
    } else {
        (range.0, open.0)
    };
    if is_open || around {
        return Err(Unmeasured::Endless);
    }
    Ok(Measured {
        value: Value::Number(value),
        range: Some(range),
        stops: Vec::new(),
    })
}

/// The time of a contact at which the features touch as they are drawn.
///
/// A space is that of parts that are larger by 10⁻¹² of their size and displaced by as little, so that contacts come early by
/// somewhat more than that. The contact function of the features as drawn has a root nearby, found by Newton's method; where it has none, as beside a
/// tangency, the contact's own time remains.
fn as_drawn(space: &PairSpace, motion: &Motion, contact: &PairContact) -> Result<f64, QueryError> {
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

/// The features that are as near to each other as the parts.
fn nearest(space: &PairSpace, at: Coordinates) -> Result<Vec<FeaturePair>, Unmeasured> {
    let clearance = space.clearance(at)?;
    let within = clearance + 4.0 * space.resolution();
    let near = space.near_features(at, within)?;
    Ok(near.iter().map(crate::touching::pair_of).collect())
}

fn wrong_class(space: &PairSpace, given: Coordinates) -> Unmeasured {
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
