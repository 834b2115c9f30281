//! Models as they are read.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod arcs;
mod dynamics;
mod errors;
mod paper;
mod profile;
mod round_trip;
mod schema;
mod slips;
mod snap;
