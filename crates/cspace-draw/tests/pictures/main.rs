//! Pictures of shipped models: against references, against each other in every format, and what they must show.

#![allow(clippy::unwrap_used, clippy::panic)]

mod formats;
mod motions;
mod planes;
mod reference;
mod scenes;
