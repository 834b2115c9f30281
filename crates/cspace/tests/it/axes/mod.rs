//! Pairs on fixed axes.

mod motion;
mod nearest;
mod oracle;
mod patches;
mod regions;
mod symmetry;
