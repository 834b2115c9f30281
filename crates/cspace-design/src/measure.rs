//! One quantity, measured on a space.

use cspace::pair::PairMotion;
use cspace::{Axis, AxisMotion, Coordinates, Location, PairSpace, QueryError, RegionId, Silent};
use cspace_model::model::{Coordinate, Quantity};
use cspace_plan::fits::fits;
use cspace_plan::{Clearance, PlanError, Planner, Verdict, Wishes};

use crate::motion::Motion;
use crate::over_ranges::over_ranges;
use crate::range::{as_drawn, free_range, wrong_class};
use crate::touching::{FeaturePair, touching};
use crate::value::{Measured, Stop, Unmeasured, Value};

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
        Quantity::Clearance { at } => {
            let clearance = space.clearance(at)?;
            if clearance.is_infinite() {
                return Err(Unmeasured::NeverLevel);
            }
            let features = nearest(space, at)?;
            Ok(Measured::at(
                Value::Number(clearance),
                vec![Stop { at, features }],
            ))
        }
        Quantity::Angle { at, along, of } => angle(space, at, along, of),
        Quantity::Bottleneck { at, to } => bottleneck(space, at, to),
        Quantity::Extreme { at, of, upper } => extreme(space, at, of, upper),
        Quantity::Caged { at } => {
            let region = region(space, at)?;
            let region = space.regions().into_iter().find(|r| r.id == region);
            Ok(Measured::truth(region.is_some_and(|r| !r.unbounded)))
        }
        Quantity::Ranges { what, at } => over_ranges(space, what, at),
        Quantity::Fits { at, within } => fit(space, at, within),
        Quantity::Connected { at, to } => {
            Ok(Measured::truth(region(space, at)? == region(space, to)?))
        }
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

fn play(space: &PairSpace, of: Coordinate, at: Coordinates) -> Result<Measured, Unmeasured> {
    let [below, above] = free_range(space, of, at)?;
    let (Some((lo, first)), Some((hi, second))) = (below, above) else {
        return Err(Unmeasured::Unlimited);
    };
    let stops = vec![first, second];
    Ok(Measured::with_range(hi - lo, (lo, hi), stops))
}

fn position(
    space: &PairSpace,
    from: Coordinates,
    along: Coordinates,
    of: Coordinate,
) -> Result<Measured, Unmeasured> {
    let stop = first_stop(space, from, along)?;
    let value = of.of(stop.at).ok_or_else(|| wrong_class(space, from))?;
    Ok(Measured::at(Value::Number(value), vec![stop]))
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
    let angle = (along_normal.abs() / arm).min(1.0).acos();
    Ok(Measured::at(Value::Number(angle), vec![stop]))
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
            let stop = Stop {
                at: narrow.at,
                features: narrow.features.into_iter().collect(),
            };
            let clearance = Value::Number(narrow.clearance);
            Ok(Measured::at(clearance, vec![stop]))
        }
        Verdict::FromBlocked(_) | Verdict::ToBlocked(_) => Err(Unmeasured::Blocked),
        Verdict::Unknown(_) => Err(Unmeasured::Undecided),
        Verdict::NoPath(_) | Verdict::TooNarrow => Err(Unmeasured::NoWay),
    }
}

/// The most room in a box, with what it is between.
fn fit(space: &PairSpace, at: Coordinates, within: [f64; 3]) -> Result<Measured, Unmeasured> {
    /// Less of the parts' size is nothing beside what a value is known to.
    const PROVED: f64 = 1e-7;
    let Coordinates::Planar(around) = at else {
        return Err(wrong_class(space, at));
    };
    let found = fits(space, around, within, &Silent);
    let found = found.map_err(|e| Unmeasured::Space(e.to_string()))?;
    let found = found.ok_or_else(|| wrong_class(space, at))?;
    let size = space.fixed().size().max(space.moving().size());
    if found.most - found.least > PROVED * size {
        return Err(Unmeasured::Unproved {
            found: found.clearance,
        });
    }
    let features = found.features.into_iter();
    let stop = Stop {
        at: Coordinates::Planar(found.at),
        features: features.map(|[fixed, moving]| (fixed, moving)).collect(),
    };
    let range = (found.least, found.most);
    Ok(Measured::with_range(found.clearance, range, vec![stop]))
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
    Ok(Measured::with_range(value, range, Vec::new()))
}

/// The features that are as near to each other as the parts.
fn nearest(space: &PairSpace, at: Coordinates) -> Result<Vec<FeaturePair>, Unmeasured> {
    let clearance = space.clearance(at)?;
    let within = clearance + 4.0 * space.resolution();
    let near = space.near_features(at, within)?;
    Ok(near.iter().map(crate::touching::pair_of).collect())
}
