//! Endless series of pairs whose contact spaces are checked by brute force.
//!
//! [`Source`] draws pairs: from outlines that favour ties, and from the [families](mod@cspace_oracle::families) that
//! approach degenerate cases. [`check`](fn@check) computes the contact space of one and compares it with the oracle,
//! with slices from scratch and with itself. [`Tally`] counts. The command `cspace-load` does that in a loop; the tests
//! do it once for all families.
//!
//! [`structure`] measures how certain the structure of contact spaces is, for pairs drawn on a grid and for variants
//! with noise. The command `cspace-structure` prints it.
//!
//! ```
//! use cspace::Silent;
//! use cspace_load::{Effort, Source, check};
//!
//! let source = Source::new(1, Some("corners rounded, radius")).ok_or("no such family")?;
//! let mut drawn = source.draw(0);
//! let effort = Effort { configurations: 40, bands: 3, thorough: false };
//! let report = check(&drawn.case?, effort, &mut drawn.rng, &Silent)?;
//! assert!(report.certain > 20 && report.faults.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod check;
pub mod draw;
pub mod outline;
pub mod output;
pub mod report;
pub mod shrink;
pub mod structure;
pub mod tally;
mod trial;

pub use check::{Effort, check};
pub use draw::{Drawn, Source};
pub use report::{Fault, Report};
pub use shrink::shrink;
pub use tally::Tally;
