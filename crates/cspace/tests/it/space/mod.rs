//! Contact spaces and slices.

mod frames;
mod graph;
mod hard_cases;
mod large;
mod layers;
mod oracle;
mod random;
mod regions;
mod slice_oracle;
mod slivers;
mod symmetry;
mod windows;
