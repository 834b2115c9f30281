//! Proofs checked, and proofs tampered with.
#![allow(clippy::panic, clippy::unwrap_used)]

mod family;
mod pairs;
mod tampered;
