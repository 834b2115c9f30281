//! The oracle and the shapes drawn for it.

mod judge;
mod pairs;
mod shapes;
