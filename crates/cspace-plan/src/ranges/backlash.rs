//! The play of the moving part while the other is held, over a turn of parts that turn together.

use core::f64::consts::TAU;

use cspace::fixed_axes::{Role, SweptPlane};
use cspace::{AxesError, FixedAxesSpace};

use super::answer::Backlash;
use super::region::{Loop, loops, regions};
use super::widths::{Between, Extreme};

/// The play is right to this (radians).
const EXACT: f64 = 1e-9;

/// The least and the largest width in v of the region of a place, over all u or those of a range; none if something in the region is passed on
/// two sides.
///
/// The region winds around both coordinates between two closed curves. With u held, what lies between the one and the other is the play; what
/// lies between two stretches of one curve is a pocket beside it, where the parts come together from elsewhere only.
pub(super) fn backlash(
    space: &FixedAxesSpace,
    place: [f64; 2],
    range: Option<(f64, f64)>,
) -> Result<Option<Backlash>, AxesError> {
    let (fixed, moving) = space.axes();
    let plane = SweptPlane::compute(
        (space.fixed(), fixed),
        (space.moving(), moving),
        Role::Fixed,
    )?;
    let [region] = regions(plane.space(), place)[..] else {
        return Ok(None);
    };
    let loops = loops(plane.space(), region);
    let winding = |l: &Loop| l.turns != (0, 0);
    if plane.conflicts() > 0 || !loops.iter().all(winding) {
        return Ok(None);
    }
    let mut side = vec![None; plane.space().patches().len()];
    for (number, l) in loops.iter().enumerate() {
        for &patch in &l.patches {
            side[patch.index()] = Some(number);
        }
    }
    let of = |curve| plane.patch(curve).and_then(|patch| side[patch.index()]);
    // Each with a v in the play.
    let mut least: Option<(Extreme, f64)> = None;
    let mut most = least;
    for band in plane.bands() {
        for gap in band
            .gaps
            .clone()
            .filter(|&g| plane.region(g) == Some(region))
        {
            let curves = plane.gap(gap);
            let (Some(lower), Some(upper)) = (curves.lower, curves.upper) else {
                return Ok(None);
            };
            let sides = (of(lower), of(upper));
            if sides.0.is_some() && sides.0 == sides.1 {
                continue;
            }
            for part in within((band.lo, band.hi), range) {
                let between = Between {
                    plane: &plane,
                    lower,
                    upper,
                    band: part,
                };
                for (sign, known) in [(1.0, &mut most), (-1.0, &mut least)] {
                    let best = known.map(|k| k.0);
                    let found = between.largest(sign, best, EXACT);
                    if let Some(found) = found.filter(|&f| Some(f) != best) {
                        let (from, to) = plane.interval(gap, found.x);
                        *known = Some((found, 0.5 * (from + to)));
                    }
                }
            }
        }
    }
    Ok(least
        .zip(most)
        .map(|((least, v), (most, most_v))| Backlash {
            least: -least.width,
            most: most.width,
            at: (least.x, v),
            most_at: (most.x, most_v),
        }))
}

/// The parts of a band, in the turn in which it is, that are in a range in any turn.
fn within((lo, hi): (f64, f64), range: Option<(f64, f64)>) -> Vec<(f64, f64)> {
    let Some((from, to)) = range.filter(|(from, to)| to - from < TAU) else {
        return vec![(lo, hi)];
    };
    let first = ((from - hi) / TAU).ceil();
    (0..2)
        .map(|turn| TAU * (first + f64::from(turn)))
        .map(|turned| (lo.max(from - turned), hi.min(to - turned)))
        .filter(|(lo, hi)| lo <= hi)
        .collect()
}
