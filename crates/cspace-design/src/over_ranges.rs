//! Quantities of two parts on axes over all motions that their ranges allow.

use cspace::{Coordinates, FeatureName, Location, Options, PairSpace, Relation, Silent};
use cspace_model::compute_anew;
use cspace_model::model::{Coordinate, OverRanges};
use cspace_plan::fits_exactly;
use cspace_plan::ranges::{Free, Verdict};

use crate::range::{free_range, wrong_class};
use crate::touching::FeaturePair;
use crate::value::{Measured, Stop, Unmeasured, Value};

/// A gap is known to be the smallest where no smaller one is possible but by this share of it, or of the size of the parts.
const PROVED: f64 = 1e-8;

/// Measures a quantity over the ranges of a pair, in the free region of a configuration.
///
/// # Errors
/// If it has no value.
pub(crate) fn over_ranges(
    space: &PairSpace,
    what: OverRanges,
    at: Coordinates,
) -> Result<Measured, Unmeasured> {
    let Coordinates::Axes { u, v } = at else {
        return Err(wrong_class(space, at));
    };
    if let OverRanges::Backlash(Coordinate::U) = what {
        return exchanged(space, (u, v));
    }
    if space.locate(at)? == Location::Blocked && !fits_exactly(space, at)? {
        return Err(Unmeasured::Blocked);
    }
    if what == OverRanges::Clearance && !space.fixed().meets(space.moving()) {
        return Err(Unmeasured::NeverLevel);
    }
    let compute = compute_anew(&Silent);
    let free = match Free::of(space, [u, v], &compute).map_err(unknown)? {
        Ok(free) => free,
        Err(why) => return Err(Unmeasured::Space(why.to_owned())),
    };
    let measured = match what {
        OverRanges::Clearance => clearance(space, &free)?,
        OverRanges::Reaches(of) => {
            let stops = free.stops().into_iter();
            let stopped = stops.filter(|stop| stop.part == of.index());
            let stops: Vec<Stop> = stopped.map(|s| stop(s.at, &s.features)).collect();
            Measured::at(Value::Truth(stops.is_empty()), stops)
        }
        OverRanges::Together => Measured::truth(free.mesh(&compute).map_err(unknown)?.is_some()),
        OverRanges::Follows(of) => {
            let mesh = free.mesh(&compute).map_err(unknown)?;
            let (v, u) = mesh.ok_or(Unmeasured::TurnsAlone)?.ratio();
            Measured::number(match of {
                Coordinate::U => u as f64 / v as f64,
                _ => v as f64 / u as f64,
            })
        }
        OverRanges::Backlash(_) => backlash(space, &free)?,
    };
    Ok(Measured {
        gap: free.room(),
        ..measured
    })
}

/// Why the space of other parts is not known.
fn unknown(error: impl core::fmt::Display) -> Unmeasured {
    Unmeasured::Space(error.to_string())
}

fn stop((u, v): (f64, f64), features: &[[FeatureName; 2]]) -> Stop {
    let pair = |&[fixed, moving]: &[FeatureName; 2]| -> FeaturePair { (fixed, moving) };
    Stop {
        at: Coordinates::Axes { u, v },
        features: features.iter().map(pair).collect(),
    }
}

fn clearance(space: &PairSpace, free: &Free<'_>) -> Result<Measured, Unmeasured> {
    if free.is_bounded() {
        let contact = free.contact();
        let stops = contact.iter().map(|c| stop(c.at, &c.features));
        return Ok(Measured::at(Value::Number(0.0), stops.collect()));
    }
    let compute = compute_anew(&Silent);
    let tightest = match free.smallest(f64::INFINITY, &compute).map_err(unknown)? {
        Verdict::Clear(tightest) => tightest,
        Verdict::Undecided(why) => return Err(Unmeasured::Space(why.to_owned())),
        Verdict::Touches(_) | Verdict::Beyond => return Err(Unmeasured::Undecided),
    };
    let size = space.fixed().size().max(space.moving().size());
    if tightest.gap - tightest.least > PROVED * size.max(tightest.gap) {
        return Err(Unmeasured::Unproved {
            found: tightest.gap,
        });
    }
    let features: Vec<_> = tightest.features.into_iter().collect();
    let stops = vec![stop(tightest.at, &features)];
    Ok(Measured::at(Value::Number(tightest.gap), stops))
}

/// The largest play of v over a turn of u, with the least and the largest as range, and what ends the largest.
fn backlash(space: &PairSpace, free: &Free<'_>) -> Result<Measured, Unmeasured> {
    let compute = compute_anew(&Silent);
    let mesh = free.mesh(&compute).map_err(unknown)?;
    let found = mesh.ok_or(Unmeasured::TurnsAlone)?.backlash();
    let found = found
        .map_err(unknown)?
        .ok_or(Unmeasured::PassedOnTwoSides)?;
    let (u, v) = found.most_at;
    // Beyond the range of a part, and where the play is less than contacts are known to, nothing is told of what ends it.
    let ends = free_range(space, Coordinate::V, Coordinates::Axes { u, v }).unwrap_or_default();
    let stops: Vec<Stop> = ends.into_iter().flatten().map(|end| end.1).collect();
    let range = (found.least, found.most);
    Ok(Measured::with_range(found.most, range, stops))
}

/// The backlash of u: that of the pair with its parts exchanged.
fn exchanged(space: &PairSpace, (u, v): (f64, f64)) -> Result<Measured, Unmeasured> {
    let at = Coordinates::Axes { u: v, v: u };
    let PairSpace::FixedAxes(axes) = space else {
        return Err(wrong_class(space, at));
    };
    let (moving, fixed) = axes.axes();
    let relation = Relation::Axes { fixed, moving };
    let other = PairSpace::compute(space.moving(), space.fixed(), relation, &Options::default());
    let what = OverRanges::Backlash(Coordinate::V);
    let mut measured = over_ranges(&other.map_err(unknown)?, what, at)?;
    for stop in &mut measured.stops {
        if let Coordinates::Axes { u, v } = &mut stop.at {
            core::mem::swap(u, v);
        }
        for (fixed, moving) in &mut stop.features {
            core::mem::swap(fixed, moving);
        }
    }
    Ok(measured)
}
