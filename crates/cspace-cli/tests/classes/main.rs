//! The command on pairs of every class.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod helpers;
mod refusals;
mod saved;
mod summary;
mod works;
