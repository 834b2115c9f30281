//! Whether parts that are put together come apart: in which order, by which motions.
//!
//! One part or one group moves at a time, as a rigid body; the others stay, and together are one fixed part with several outlines. A
//! group can be taken out if and only if its configuration lies in the region of the contact space of the two that goes on
//! without limit; a straight way is found without that space. What is taken away is no longer in the way, so the order in which things
//! are tried does not change whether all comes apart.
//!
//! Where nothing leaves, single parts make room and stay among the others: parts on axes along these, up to contact or the end of
//! their range, others straight. Only where one of two parts encloses the other is it proved that nothing helps.
//!
//! Parts that touch as drawn are made smaller: every boundary is moved inward by half of a gap.

mod answer;
mod aside;
mod blocking;
mod error;
mod exact;
mod inset;
mod onward;
mod search;
mod travel;
mod units;
mod way_out;
mod wider;

use cspace::{Part, Progress, Silent};
use cspace_model::Mechanism;

pub use answer::{
    Branch, Enclosure, Kind, Locked, Outcome, PartFeature, Step, TakenApart, Tree, Tried,
};
pub use error::AssemblyError;

pub(crate) use inset::inset;
use search::Search;
pub(crate) use units::GAP;
use units::Units;

/// Parts put together.
///
/// Parts that do not move stay where they are drawn, parts on an axis move along it and never go out. Parts joined by joints move as
/// one; those of them on an axis stay. All parts lie in one
/// plane: every two are in each other's way, whichever pairs the mechanism lists.
///
/// ```
/// use cspace::Part;
/// use cspace_model::{Mechanism, PartEntry};
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

    /// The parts as drawn, with the gap opened, in the mechanism's order: those of which paths and enclosures are told.
    pub fn parts(&self) -> &[Part] {
        &self.units.drawn
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
