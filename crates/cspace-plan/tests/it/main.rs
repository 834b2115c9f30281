//! Paths, assemblies, clashes, slides and modes with known answers, judged by brute force.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod assembly;
mod clash;
mod escape;
mod modes;
mod slide;
mod ways;
