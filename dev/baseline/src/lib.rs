//! General algorithm of Bajaj and Sacks as reviewed in section 2 of Sacks (1999), with which the library is compared.
//!
//! Slices are taken at closely spaced orientations, and a polyhedral surface with straight boundary lines is put
//! through their contours. None of this is part of the product; [`Stack`] and [`Surface`] are here to be timed, and
//! [`compare`] measures their errors.
//!
//! | step of the general algorithm | here |
//! |---|---|
//! | critical orientations | [`critical::search`], timed on its own; for the other steps given for nothing, as [`bands`](cspace::ContactSpace::bands); [`with_bands`] spaces slices within them |
//! | slices at closely spaced orientations | [`Stack`], by the product's own kernel, [`cspace::Slicer`] |
//! | polyhedral approximation from the contours | [`Surface`] |
//!
//! [`paper`] has the pairs of Figure 5 and their published numbers, [`survey`] the shares of section 4. [`kinds`]
//! determines the kinds of the critical orientations of an exact space.

pub mod compare;
pub mod critical;
mod join;
pub mod kinds;
mod orientations;
pub mod paper;
mod stack;
mod surface;
pub mod survey;

pub use orientations::{MOST_SLICES, SEPARATION, SeparationError, evenly, with_bands};
pub use stack::Stack;
pub use surface::{Layer, Surface};
