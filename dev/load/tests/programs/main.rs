//! The programs of this crate, and what they do.
#![allow(clippy::unwrap_used, clippy::panic)]

#[cfg(unix)]
mod command;
mod corpus;
mod structure;
