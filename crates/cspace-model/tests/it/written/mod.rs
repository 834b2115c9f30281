//! Files written for a space, and read back.

mod glb;
mod saved_axes;
mod saved_damage;
mod saved_lies;
mod saved_schema;
