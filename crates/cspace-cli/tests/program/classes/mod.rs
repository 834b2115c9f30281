//! The command on pairs of every class.

mod helpers;
mod refusals;
mod saved;
mod summary;
mod works;
