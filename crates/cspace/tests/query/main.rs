//! Questions to spaces, and to pairs of any class.
#![allow(clippy::unwrap_used)]

mod classifier;
mod lower;
mod motion;
mod nearest;
mod pairs;
