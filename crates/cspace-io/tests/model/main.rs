//! Models as they are read.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod errors;
mod paper;
mod round_trip;
mod slips;
