//! Operating modes with known numbers, and against floods.

mod blocks;
mod flood;
mod gears;
mod interlock;
mod lock;
mod tree;
