//! Lines and arcs within a tolerance of smooth curves and of measured points, tangent to each other.
//!
//! A smooth run of samples is divided into as few tangent pieces as can be, each a line or an arc between two samples that
//! passes all samples between within the tolerance ([`divide`]). At ends whose direction is given, and where a closed run
//! comes back, a small kink is left; moving the joints and changing the arcs by as little as possible takes it away
//! ([`tangent`]). What then deviates too far ([`deviation`]) is divided anew for a narrower band.
//!
//! Joints on the curve itself lose nothing: along a curve whose curvature changes at the rate k an arc of length L between
//! points of the curve deviates by k L³ / (72 √3) or more, and a chain of tangent arcs reaches that.

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

/// How much narrower the band is made for each next try, and how often: small changes that make pieces tangent take some of
/// it, and a band of a share s asks for s^(-1/3) times the pieces.
const NARROWER: f64 = 0.96;
const TRIES: usize = 24;

/// Fits lines and arcs to a run. None if the samples do not allow it: they are too coarse for the tolerance.
pub(crate) fn fit(run: &Run) -> Option<Fitted> {
    let mut width = 0.999 * run.band.width();
    for _ in 0..TRIES {
        if let Some(division) = divide::divide(run, width) {
            for with_lines in [true, false] {
                let made = tangent::make(run, &division, with_lines);
                if let Some(made) = made.filter(|m| run.band.holds(m)) {
                    return Some(made.fitted);
                }
            }
        }
        width *= NARROWER;
    }
    None
}
