//! The eleven pairs of `models/paper`: what they count, and that each does what it is drawn for.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod helpers;
