//! Scenes of the page, and what is asked by another program.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod design;
mod drawings;
mod edits;
mod interrupts;
mod scene;
