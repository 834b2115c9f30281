//! Pairs on fixed axes.
#![allow(clippy::unwrap_used)]

mod motion;
mod nearest;
mod oracle;
mod patches;
mod regions;
mod symmetry;
