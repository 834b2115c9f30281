//! The time that one cycle of drives takes.

use core::f64::consts::TAU;

use cspace::AxisMotion;
use cspace_model::DriveMotion;

use crate::system::{PartCoordinates, System};

/// Drives that turn at constant rates come back together after no more turns of each than this.
pub const MOST_TURNS: u32 = 360;
/// Rates are in a ratio of whole numbers to this share.
const SAME: f64 = 1e-9;

/// Rates of drives (radians or the model's unit a second) of which squares and reciprocals are numbers that rounding leaves whole.
const RATES: core::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Why drives have no cycle.
#[derive(Debug, Clone, PartialEq)]
pub enum NoCycle {
    /// No drive moves.
    Still,
    /// A part, by its number, slides on for ever.
    Endless(usize),
    /// The rate of a part, by its number, is smaller or larger than any machine's.
    Extreme(usize),
    /// Two parts, by their numbers, turn at rates of no ratio of small whole numbers.
    Incommensurable([usize; 2]),
}

/// One cycle of drives: its time and turns.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Its first and last time (s).
    pub times: [f64; 2],
    /// Parts that turn round, with the number of their turns.
    pub turns: Vec<(usize, u32)>,
    /// A driven part that comes to the end of its range at the last time.
    pub ends: Option<usize>,
}

/// One cycle of some driven parts: whole turns of those that turn at constant rates, all of a table, or until a part comes to the end of its
/// range; of several the longest, but no longer than the ranges allow.
pub(super) fn span(system: &System, driven: &[usize]) -> Result<Span, NoCycle> {
    let mut turning: Vec<(usize, f64)> = Vec::new();
    let mut table: Option<[f64; 2]> = None;
    let mut end: Option<(f64, usize)> = None;
    let mut endless = None;
    let drives = &system.mechanism().dynamics.drives;
    for drive in drives.iter().filter(|d| driven.contains(&d.part)) {
        let PartCoordinates::Axis {
            first,
            motion,
            range,
        } = system.parts()[drive.part]
        else {
            continue;
        };
        match &drive.motion {
            DriveMotion::Table(points) => {
                if let ([(from, _), ..], [.., (to, _)]) = (&points[..], &points[..]) {
                    let [a, b] = table.unwrap_or([*from, *to]);
                    table = Some([a.min(*from), b.max(*to)]);
                }
            }
            DriveMotion::Rate(0.0) => {}
            DriveMotion::Rate(rate) if !RATES.contains(&rate.abs()) => {
                return Err(NoCycle::Extreme(drive.part));
            }
            DriveMotion::Rate(rate) => {
                let curve = system.drives().iter().find(|d| d.0 == first);
                let start = curve.map_or(0.0, |d| d.1.at(0.0).value);
                if let Some((lo, hi)) = range {
                    let time = (if *rate > 0.0 { hi - start } else { lo - start }) / rate;
                    if end.is_none_or(|e| time < e.0) {
                        end = Some((time, drive.part));
                    }
                }
                match motion {
                    AxisMotion::Revolute { .. } => turning.push((drive.part, *rate)),
                    _ if range.is_none() => endless = Some(drive.part),
                    _ => {}
                }
            }
        }
    }
    let (round, turns) = match turning.first() {
        None => (0.0, Vec::new()),
        Some(&first) => common(first, &turning)?,
    };
    let [from, until] = table.unwrap_or([0.0, 0.0]);
    // What follows from a table that begins later stands still before.
    let from = if turning.is_empty() && end.is_none() {
        from
    } else {
        0.0
    };
    let mut to = (from + round).max(until);
    let slides = end.is_some_and(|(_, part)| turning.iter().all(|t| t.0 != part));
    let mut ends = None;
    if let Some((time, part)) = end
        && (time < to || to <= from || slides)
    {
        to = time;
        ends = Some(part);
    }
    match endless {
        Some(part) if to <= from => Err(NoCycle::Endless(part)),
        _ if to <= from => Err(NoCycle::Still),
        _ => Ok(Span {
            times: [from, to],
            // What ends at a range does not go round.
            turns: if ends.is_some() { Vec::new() } else { turns },
            ends,
        }),
    }
}

/// The shortest time in which all make whole turns, and how many each makes.
fn common(
    (part, rate): (usize, f64),
    turning: &[(usize, f64)],
) -> Result<(f64, Vec<(usize, u32)>), NoCycle> {
    let mut worst = None;
    for own in 1..=MOST_TURNS {
        let counts = turning.iter().map(|&(other, of)| {
            let count = f64::from(own) * (of / rate).abs();
            let whole = count.round();
            let is_whole = (1.0..=f64::from(MOST_TURNS)).contains(&whole)
                && (count - whole).abs() <= SAME * whole;
            match is_whole {
                true => Ok((other, whole as u32)),
                false => Err(other),
            }
        });
        match counts.collect::<Result<Vec<_>, _>>() {
            Ok(counts) => return Ok((f64::from(own) * TAU / rate.abs(), counts)),
            Err(other) => worst = Some(other),
        }
    }
    Err(NoCycle::Incommensurable([part, worst.unwrap_or(part)]))
}
