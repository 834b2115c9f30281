//! Parts that fit exactly at the start: nominal on nominal, as a key in its slot is drawn first.
//!
//! Their contact space has no room there. The motion is that of the mechanism in which one of the two is smaller by a gap.

use cspace::Part;
use cspace_model::Mechanism;
use cspace_plan::{fits_exactly, with_gap};
use schemars::JsonSchema;
use serde::Serialize;

use crate::contact::{names, overlap_at_start, overlap_error};
use crate::error::SimulateError;
use crate::pairs::Pairs;
use crate::system::System;

/// A part that is smaller than drawn, all around, because it fits exactly into another.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Gap {
    /// Name of the part.
    pub part: String,
    /// How much smaller it is, in the model's unit of length.
    pub gap: f64,
}

/// The mechanism with room where parts fit exactly at a position, and the parts that are smaller for it; `None` where none do.
///
/// The part that moves in the frame of the other is smaller, unless one of the two is smaller already.
///
/// # Errors
/// If parts overlap and do not fit exactly, or a part that has to be smaller has edges too short for it.
pub(crate) fn with_room(
    system: &System,
    pairs: &Pairs,
    q: &[f64],
) -> Result<Option<(Mechanism, Vec<Gap>)>, SimulateError> {
    // All pairs as they are drawn, before one is given room: that would hide how others overlap.
    let mut exact = Vec::new();
    for (index, pair) in pairs.list().iter().enumerate() {
        let Some(depth) = overlap_at_start(system, pairs, index, q)? else {
            continue;
        };
        if !fits_exactly(&pair.space, pair.coordinates(system, q)).unwrap_or(false) {
            return Err(overlap_error(system, pairs, index, depth));
        }
        exact.push(pair);
    }
    let mut smaller: Vec<(usize, Part, f64)> = Vec::new();
    for pair in exact {
        if (smaller.iter()).any(|(i, ..)| [pair.fixed, pair.moving].contains(i)) {
            continue;
        }
        let Some((part, gap)) = with_gap(pair.space.fixed(), pair.space.moving()) else {
            let [fixed, moving] = names(pair, system);
            return Err(SimulateError::ExactFit { fixed, moving });
        };
        smaller.push((pair.moving, part, gap));
    }
    if smaller.is_empty() {
        return Ok(None);
    }
    let mut mechanism = system.mechanism().clone();
    let mut gaps = Vec::with_capacity(smaller.len());
    for (index, part, gap) in smaller {
        gaps.push(Gap {
            part: part.name().to_owned(),
            gap,
        });
        mechanism = mechanism.with_outline(index, part);
    }
    Ok(Some((mechanism, gaps)))
}
