//! Operating modes of three parts on fixed axes.

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod column;
mod extent;
mod graph;
mod plane;
mod roots;
mod section;
mod sweep;
mod turns;
