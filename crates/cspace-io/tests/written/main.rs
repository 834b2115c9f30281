//! Files written for a space, and read back.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod glb;
mod saved_axes;
mod saved_damage;
mod saved_lies;
mod saved_schema;
