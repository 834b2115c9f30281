//! Tests of the server by requests written out byte by byte.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod client;
mod drawing;
mod guard;
mod routes;
