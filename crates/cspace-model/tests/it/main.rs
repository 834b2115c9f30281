//! Models and saved spaces: read, written, damaged; regressions.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod model;
mod regression;
mod written;
