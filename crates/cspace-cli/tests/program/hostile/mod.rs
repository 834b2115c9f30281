//! Hostile input: broken and enormous files, odd places, control characters, interruptions. The command says what is
//! wrong, leaves with the right code, leaves nothing half-written, and takes neither for ever nor all memory.

mod angles;
mod bounds;
mod files;
mod outputs;
mod text;
