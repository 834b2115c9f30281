//! Proofs checked, and proofs tampered with.

mod family;
mod pairs;
mod tampered;
