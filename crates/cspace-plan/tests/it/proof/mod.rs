//! Proofs checked, and proofs tampered with.

mod family;
mod pairs;
mod tampered;

pub(crate) use tampered::python;
