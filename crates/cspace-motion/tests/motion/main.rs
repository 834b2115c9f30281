//! Motions with known answers.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod agreement;
mod answers;
mod axes;
mod free_space;
mod helpers;
mod hostile;
mod invariance;
mod models;
mod oversize;
mod planar;
mod random;
