//! Measures of designs with known values.
#![allow(clippy::panic, clippy::unwrap_used, dead_code)]

mod common;
mod fits;
mod known;
mod motion;
mod over_ranges;
mod sensitivities;
mod solve;
mod tolerances;
