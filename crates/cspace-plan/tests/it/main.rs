//! Paths, assemblies, clashes, slides, modes and proofs with known answers, judged by brute force.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod assembly;
mod clash;
mod escape;
mod involute;
mod layers;
mod modes;
mod nest;
mod proof;
mod ranges;
mod slide;
mod ways;
