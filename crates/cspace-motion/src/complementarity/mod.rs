//! Which contacts bear, stick and slide: Coulomb's law as a problem of complementarity, with inertia and without.

mod friction;
mod lemke;
mod modes;
#[cfg(test)]
pub(crate) mod numbers;
mod problem;
mod reduced;

pub use problem::Mode;
pub(crate) use problem::{Bearing, Problem, Solution};
