//! Models as they are read.

mod arcs;
mod bodies;
mod dynamics;
mod errors;
mod fits;
mod names;
mod outlines;
mod paper;
mod profile;
mod round_trip;
mod schema;
mod show;
mod slips;
mod snap;
