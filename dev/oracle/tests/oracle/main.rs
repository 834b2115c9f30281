//! The oracle and the shapes drawn for it.
#![allow(clippy::unwrap_used)]

mod judge;
mod pairs;
mod shapes;
