//! Operating modes of three parts on fixed axes.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod column;
mod error;
mod extent;
mod graph;
mod locate;
mod mode;
mod modes;
mod plane;
mod roots;
mod section;
mod shadow;
mod shape;
mod sweep;
mod trio;
mod turns;

pub use error::ModesError;
pub use locate::ModePlace;
pub use mode::Mode;
pub use modes::Modes;
pub use shadow::Shadow;
pub use trio::{PAIRS, TrioPair, moving_parts};
