//! The program, run on files.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod answers;
mod cache;
mod classes;
mod clearance;
mod command;
mod disassemble;
#[cfg(unix)]
mod docs;
mod draw;
mod escape;
mod exact_fits;
mod helpers;
#[cfg(unix)]
mod hostile;
mod import;
mod info;
mod mcp;
mod meshes;
mod modes;
mod new;
mod page;
mod parameters;
mod plan;
mod play;
mod questions;
mod random;
mod resume;
mod schemas;
mod simulate;
mod view;
