//! The page as a file, and its server.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

mod page;
mod server;
