//! The programs of this crate, and what they do.

#[cfg(unix)]
mod command;
mod corpus;
mod structure;
