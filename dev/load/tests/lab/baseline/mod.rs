//! The general algorithm on pairs whose answer is known.

mod critical;
mod kinds;
mod stack;
