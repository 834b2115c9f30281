//! Operating modes with known numbers, and against floods.
#![allow(clippy::panic, clippy::unwrap_used)]

mod blocks;
mod flood;
mod gears;
mod interlock;
