//! Parts that fit exactly where a motion begins: nominal on nominal, as a key in its slot is drawn first.
//!
//! Their contact space has no room there. The motion is that of the mechanism in which one of the two is smaller by a gap.

use cspace::Part;
use cspace_model::{Compute, Mechanism};
use cspace_plan::{fits_exactly, with_gap};
use schemars::JsonSchema;
use serde::Serialize;

use crate::contact::{names, overlap};
use crate::error::SimulateError;
use crate::pairs::{MovingPair, Pairs};
use crate::system::System;

/// A part that is smaller than drawn, all around, because it fits exactly into another.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Gap {
    /// Name of the part.
    pub part: String,
    /// How much smaller it is, in the model's unit of length.
    pub gap: f64,
}

impl Gap {
    /// A sentence on it, for a mechanism with that part.
    pub fn sentence(&self, mechanism: &Mechanism) -> String {
        let Self { part, gap } = self;
        let unit = mechanism
            .unit
            .as_ref()
            .map_or(String::new(), |unit| format!(" {unit}"));
        format!(
            "gap {gap:.1e}{unit}: the parts fit exactly, and {part} is smaller by it all around"
        )
    }
}

/// The pairs that overlap at a configuration, and do not only touch.
#[derive(Debug, Default)]
pub(crate) struct Overlaps<'a> {
    /// Pairs that fit exactly.
    pub exact: Vec<&'a MovingPair>,
    /// All others, with the distance to the nearest contact.
    pub deep: Vec<(&'a MovingPair, f64)>,
}

/// Tells exact fits at a configuration from parts that overlap.
///
/// # Errors
/// If a pair's space was not computed at this configuration.
pub(crate) fn overlaps<'a>(
    system: &System,
    pairs: impl Iterator<Item = &'a MovingPair>,
    q: &[f64],
) -> Result<Overlaps<'a>, SimulateError> {
    let mut found = Overlaps::default();
    for pair in pairs {
        let Some(depth) = overlap(pair, system, q)? else {
            continue;
        };
        match fits_exactly(&pair.space, pair.coordinates(system, q)).unwrap_or(false) {
            true => found.exact.push(pair),
            false => found.deep.push((pair, depth)),
        }
    }
    Ok(found)
}

/// A mechanism with room where parts fit exactly.
pub(crate) struct Room {
    pub mechanism: Mechanism,
    /// The parts that are smaller, by their numbers.
    smaller: Vec<usize>,
    pub gaps: Vec<Gap>,
}

impl Room {
    /// The mechanism of a system with room for pairs that fit exactly. The part that moves in the frame of the other is smaller, unless one
    /// of the two is smaller already.
    ///
    /// # Errors
    /// If a part that has to be smaller has edges too short for it.
    pub(crate) fn of(system: &System, exact: &[&MovingPair]) -> Result<Self, SimulateError> {
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
        let mut room = Self {
            mechanism: system.mechanism().clone(),
            smaller: Vec::new(),
            gaps: Vec::new(),
        };
        for (index, part, gap) in smaller {
            let name = part.name().to_owned();
            room.gaps.push(Gap { part: name, gap });
            room.smaller.push(index);
            room.mechanism = room.mechanism.with_outline(index, part);
        }
        Ok(room)
    }

    /// The pairs of the mechanism: spaces of parts that are smaller take the places of those that were.
    ///
    /// # Errors
    /// Errors that `compute` returns.
    pub(crate) fn put_in(
        &self,
        pairs: &mut Pairs,
        compute: &Compute<'_>,
    ) -> Result<(), SimulateError> {
        Ok(pairs.reshape(&self.mechanism, &self.smaller, compute)?)
    }
}
