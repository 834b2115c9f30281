//! The eleven pairs of `models/paper`: what they count, and that each does what it is drawn for.
//!
//! Expected values follow from the drawings: lifts, plays and jamming angles are worked out here from the dimensions
//! that the files give in their comments, not taken from a computation.

mod cams;
mod counts;
mod film;
mod helpers;
mod holding;
mod knee;
mod oracle;
mod wheels;
