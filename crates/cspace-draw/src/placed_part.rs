//! A part in a picture.

use cspace::{Axis, Configuration, Part};

/// A part and where it is.
#[derive(Debug, Clone, Copy)]
pub struct PlacedPart<'a> {
    /// The part.
    pub part: &'a Part,
    /// Takes points of the part to the assembly.
    pub assembly_from_part: Configuration,
    /// Axis of its motion, in the assembly; `None` if it moves freely in the plane.
    pub axis: Option<Axis>,
    /// Number in the model, which determines its colour.
    pub number: usize,
}
