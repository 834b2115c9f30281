//! The developers' programs, the general algorithm, the oracle and its shapes.
#![allow(clippy::unwrap_used, clippy::panic)]

mod baseline;
mod no_fit;
mod oracle;
mod programs;
