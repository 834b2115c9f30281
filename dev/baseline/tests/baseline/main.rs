//! The general algorithm on pairs whose answer is known.
#![allow(clippy::unwrap_used)]

mod critical;
mod kinds;
mod stack;
