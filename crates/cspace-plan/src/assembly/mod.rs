//! Whether parts that are put together come apart: in which order, by which motions.
//!
//! One part or one group moves at a time, as a rigid body, all the way out; the others stay where they are drawn, and together are one
//! fixed part with several outlines. A group can be taken out if and only if the configuration as drawn lies in the region of the
//! contact space of the two that goes on without limit. What is taken away is no longer in the way, so the order in which
//! things are tried does not change whether all comes apart.
//!
//! Parts that touch as drawn are made smaller: every boundary is moved inward by half of a gap.

mod answer;
mod blocking;
mod error;
mod exact;
mod inset;
mod search;
mod units;

use cspace::{Mechanism, Part, Progress, Silent};

pub use answer::{Enclosure, Locked, Outcome, PartFeature, Step, TakenApart};
pub use error::AssemblyError;

use search::Search;
use units::Units;

/// Parts put together.
///
/// Parts that do not move, or move on an axis, stay where they are drawn. Parts joined by joints move as one. All parts lie in one
/// plane: every two are in each other's way, whichever pairs the mechanism lists.
///
/// ```
/// use cspace::{Mechanism, Part, mechanism::PartEntry};
/// use cspace_plan::assembly::{Assembly, Outcome};
/// // A block in a slot that it fills, and a lid on both.
/// let slot = [(-3.0, -2.0), (3.0, -2.0), (3.0, 0.0), (1.0, 0.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 0.0), (-3.0, 0.0)];
/// let mut mechanism = Mechanism::new("box");
/// mechanism.parts.push(PartEntry::fixed(Part::polygon("box", &slot)?));
/// mechanism.parts.push(PartEntry::planar(Part::rectangle("block", (0.0, -0.5), 2.0, 1.0)?));
/// mechanism.parts.push(PartEntry::planar(Part::rectangle("lid", (0.0, 0.5), 6.0, 1.0)?));
/// let apart = Assembly::new(&mechanism, None)?.take_apart()?;
/// assert_eq!(apart.outcome, Outcome::Apart);
/// let order: Vec<_> = apart.steps.iter().map(|s| s.moving[0]).collect();
/// assert_eq!(order, [2, 1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Assembly {
    units: Units,
}

impl Assembly {
    /// Opens a gap between parts, in the model's unit of length; a millionth of the size unless it is given.
    ///
    /// # Errors
    /// If there is nothing to take apart, parts overlap by more than the gap, or have edges too small for it.
    pub fn new(mechanism: &Mechanism, gap: Option<f64>) -> Result<Self, AssemblyError> {
        Ok(Self {
            units: Units::new(mechanism, gap)?,
        })
    }

    /// The gap between parts that touch as drawn, in the model's unit of length.
    pub fn gap(&self) -> f64 {
        self.units.gap
    }

    /// The parts with the gap opened, in the mechanism's order: those of which paths and enclosures are told.
    pub fn parts(&self) -> &[Part] {
        &self.units.parts
    }

    /// Takes it apart.
    ///
    /// # Errors
    /// If a contact space cannot be computed.
    pub fn take_apart(&self) -> Result<TakenApart, AssemblyError> {
        self.take_apart_with(&Silent)
    }

    /// As [`take_apart`](Self::take_apart), telling `progress` of every stage of every contact space.
    ///
    /// # Errors
    /// As [`take_apart`](Self::take_apart); and what `progress` returns.
    pub fn take_apart_with(&self, progress: &dyn Progress) -> Result<TakenApart, AssemblyError> {
        Search::new(&self.units, progress).run()
    }
}
