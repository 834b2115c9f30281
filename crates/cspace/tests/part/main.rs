//! What is a part, and what is none.
#![allow(clippy::unwrap_used, clippy::panic)]

mod outline;
mod random;
mod validation;
