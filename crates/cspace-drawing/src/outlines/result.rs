//! Parts made from a drawing, and a report on how.

use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

use cspace::{Part, Point};

use super::settings::{DEFAULT_JOIN, Settings};
use crate::drawing::{Entity, Ignored, Origin, Problem};
use crate::fit::Outline;
use crate::join::CENTRE_LINE;
use crate::shown;
use crate::unit::Unit;

/// The parts of a drawing, and how they came about.
#[derive(Debug, Clone)]
pub struct Outlines {
    /// The parts, in the order of their outermost loops in the file.
    pub parts: Vec<Part>,
    /// The unit that the file names.
    pub unit: Option<Unit>,
    /// Number of entities of each type that the parts are made of.
    pub used: BTreeMap<String, usize>,
    /// Entities that were left out.
    pub ignored: Vec<Ignored>,
    /// Properties that are not followed of entities that are read, such as the width of a line.
    pub unfollowed: Vec<Ignored>,
    /// Layers with several outlines that are separate parts.
    pub apart: Vec<Apart>,
    /// The distance within which ends were joined, though none was given, since all gaps are small and each end has one partner.
    pub closed: Option<f64>,
    /// The gaps that were closed, and where.
    pub joined: Vec<(f64, Point)>,
    /// Report on fitted curves.
    pub fitted: FittedReport,
    /// Outlines of two parts that cross or touch, if there are any: parts may, but a drawing may be wrong.
    pub crossing: Option<Problem>,
    /// A rectangle around everything, with parts in what would be its holes, or as large as the page: it may be the sheet.
    pub sheet: Option<Origin>,
    /// Number of pieces that were drawn twice, or lay within others.
    pub duplicates: usize,
    /// Number of pieces that overlapped others and were merged with them.
    pub merged: usize,
    /// Number of pieces that had no length, or were removed because ends within
    /// [`Settings::join`](crate::Settings::join) are joined.
    pub tiny: usize,
    /// The extent of the largest of them, 0 if none has any.
    pub largest_removed: f64,
}

/// Parts whose outlines are on one layer, apart from each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Apart {
    /// The layer; empty where a format has none.
    pub layer: Arc<str>,
    /// Names of the parts.
    pub parts: Vec<String>,
}

impl Outlines {
    /// Note that gaps were closed though no distance was given; `None` if none were.
    pub fn gaps_closed(&self) -> Option<String> {
        let join = shown::number(self.closed?);
        Some(match self.joined.len() {
            1 => format!(
                "a small gap is closed, as with join {join}: its ends have no other partners"
            ),
            n => {
                format!("{n} small gaps are closed, as with join {join}: each end has one partner")
            }
        })
    }

    /// Note that centre lines were left out, though that was not asked for; `None` if none were.
    pub fn centre_lines(&self) -> Option<String> {
        match self
            .ignored
            .iter()
            .filter(|i| i.reason == CENTRE_LINE)
            .count()
        {
            0 => None,
            1 => {
                Some("a centre line is left out: it goes through the centre of a circle".to_owned())
            }
            n => Some(format!(
                "{n} centre lines are left out: they go through centres of circles"
            )),
        }
    }

    /// Warning that short pieces were removed because ends close to each other are joined by default, and how long they
    /// are; `None` if no piece has any extent, or the distance was given.
    pub fn short_pieces(&self, settings: &Settings) -> Option<String> {
        (settings.join.is_none() && self.largest_removed > 0.0).then(|| {
            format!(
                "{} short {} removed, because ends nearer than {DEFAULT_JOIN:e} of the drawing's size are one; the largest is {:.1e} long",
                self.tiny,
                if self.tiny == 1 { "piece is" } else { "pieces are" },
                self.largest_removed
            )
        })
    }
}

/// Usable parts of a drawing, and the entities that cannot be used.
#[derive(Debug, Clone)]
pub struct Survey {
    /// The parts.
    pub parts: Vec<Part>,
    /// The entities that would be outlines, but are in no part.
    pub unused: Vec<Entity>,
    /// Why.
    pub problems: Vec<Problem>,
}

/// Quality of the fitted lines and arcs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FittedReport {
    /// The number of curves.
    pub curves: usize,
    /// The number of lines and arcs they became.
    pub pieces: usize,
    /// Largest distance of these from the curves.
    pub deviation: f64,
    /// The largest angle between neighbours that should be tangent, in radians; rounding.
    pub kink: f64,
}

impl FittedReport {
    /// Adds the curves of a loop; a curve is in one loop.
    pub(super) fn add(&mut self, outline: &Outline) {
        let curves: HashSet<u32> = outline.curves.iter().copied().collect();
        self.curves += curves.len();
        self.pieces += outline.pieces;
        self.deviation = self.deviation.max(outline.deviation);
        self.kink = self.kink.max(outline.kink);
    }
}
