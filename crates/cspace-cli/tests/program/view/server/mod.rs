//! Tests of the server by requests written out byte by byte.

mod client;
mod drawing;
mod guard;
mod routes;
