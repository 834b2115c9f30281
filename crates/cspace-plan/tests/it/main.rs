//! Paths, assemblies, clashes and slides with known answers, judged by brute force.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod assembly;
mod clash;
mod escape;
mod slide;
mod ways;
