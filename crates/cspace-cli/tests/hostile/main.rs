//! What nobody means well: broken and enormous files, odd places, control characters, interruptions. The command says what is
//! wrong, leaves with the right code, leaves nothing half-written, and takes neither for ever nor all memory.

#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod angles;
mod bounds;
mod files;
mod outputs;
mod text;
