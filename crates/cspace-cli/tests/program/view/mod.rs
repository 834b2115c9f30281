//! The page as a file, and its server.

mod page;
mod server;
