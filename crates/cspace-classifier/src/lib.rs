//! Fast classification of many configurations: a [`ContactSpace`](cspace::ContactSpace) is prepared once, and each configuration then takes
//! less than a tenth of a microsecond.
//!
//! ```
//! use cspace::{Classification, Configuration, ContactSpace, Options, Part};
//! use cspace_classifier::Classifier;
//! let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
//! let block = Part::rectangle("block", (0.0, 0.0), 2.0, 2.0)?;
//! let space = ContactSpace::compute(&table, &block, &Options::default())?;
//! let classifier = Classifier::new(&space);
//! let at = |x| classifier.classify(Configuration::new(x, 0.0, 1e-3));
//! assert_eq!(at(4.0), Some(Classification::Free));
//! assert_eq!(at(2.0), Some(Classification::Blocked));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

// This crate reads no files and prints nothing.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod board;
mod cells;
mod centers;
mod classifier;
mod grid;
mod nearby;
mod raster;
mod ray;
mod slab;
mod slot;
mod walk;

pub use classifier::Classifier;
