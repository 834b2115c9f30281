//! Motions with known answers, judged by brute force.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod cycle;
mod dynamic;
mod motion;
mod report;
mod stepping;
