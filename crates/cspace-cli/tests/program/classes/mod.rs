//! The command on pairs of every class.

mod refusals;
mod saved;
mod summary;
mod works;
