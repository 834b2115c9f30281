//! Lines and arcs within a tolerance of smooth curves and of measured points, tangent to each other.
//!
//! A smooth run of samples is divided into as few pieces as can be, each a line or an arc between two samples that passes
//! all samples between within the tolerance ([`divide`]). The pieces meet with small kinks; moving the joints and changing
//! the arcs by as little as possible makes them tangent ([`tangent`]). What then deviates too far ([`deviation`]) is divided
//! into one piece more.
//!
//! That this is nearly the fewest follows from an expansion: along a curve whose curvature changes at the rate k an arc of
//! length L between points of the curve deviates by k L³ / (72 √3), and of all such chains it is the tangent one that does.

mod bulges;
mod chain;
mod deviation;
mod divide;
mod run;
mod tangent;

pub(crate) use chain::{Outline, Sided, outline};
pub(crate) use deviation::of_others as deviation_of;
use run::Run;

use cspace::{Point, Vertex};

use divide::Division;

/// Lines and arcs fitted to a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Fitted {
    /// The start of every piece, with its bulge; the end of an open run is not among them.
    pub(crate) vertices: Vec<Vertex>,
    /// Where an open run ends.
    pub(crate) end: Point,
    /// How far the samples are from the pieces, at most.
    pub(crate) deviation: f64,
    /// The largest angle between two pieces, in radians.
    pub(crate) kink: f64,
}

/// The fewest pieces more that are tried, and the most as a share of the fewest: four times the pieces bring a sixty-fourth
/// of the deviation.
const MOST_MORE: usize = 8;

/// Fits lines and arcs to a run. None if the samples do not allow it: they are too coarse for the tolerance.
pub(crate) fn fit(run: &Run) -> Option<Fitted> {
    let starts = if run.is_closed { divide::starts(run) } else { vec![0] };
    let first = (starts.iter())
        .map(|&start| divide::fewest(run, start, run.band.width()))
        .min_by_key(Division::len)?;
    let mut division = first.clone();
    let most = MOST_MORE + 4 * first.len();
    loop {
        let balanced = divide::balance(run, &division);
        for with_lines in [true, false] {
            let Some(fitted) = tangent::make(run, &balanced, with_lines) else {
                continue;
            };
            if run.band.holds(&fitted) {
                return Some(fitted.fitted);
            }
        }
        division = divide::more(run, &division)?;
        if division.len() > most {
            return None;
        }
    }
}
