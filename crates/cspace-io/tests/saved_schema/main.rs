//! The published schemas, held against what is written.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod classes;
mod helpers;
mod labels;
mod planar;
