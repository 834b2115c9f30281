//! Motions with known answers.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod axes;
mod helpers;
mod models;
mod planar;
mod random;
