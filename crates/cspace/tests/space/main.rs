//! Contact spaces and slices.
#![allow(clippy::unwrap_used, clippy::panic)]

mod frames;
mod graph;
mod hard_cases;
mod large;
mod oracle;
mod random;
mod regions;
mod slice_oracle;
mod slivers;
mod symmetry;
mod windows;
