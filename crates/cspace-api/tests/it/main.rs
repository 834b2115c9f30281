//! Scenes of the page.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod design;
mod drawings;
mod edits;
mod scene;
