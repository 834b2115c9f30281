//! The commands.

pub(crate) mod assembly;
pub(crate) mod check;
pub(crate) mod clash;
pub(crate) mod classify;
pub(crate) mod completions;
pub(crate) mod compute;
pub(crate) mod contacts;
pub(crate) mod draw;
pub(crate) mod escape;
pub(crate) mod evaluate;
pub(crate) mod export;
pub(crate) mod import;
pub(crate) mod info;
pub(crate) mod man;
pub(crate) mod motion;
pub(crate) mod new;
mod page;
pub(crate) mod plan;
pub(crate) mod play;
mod record;
mod regions;
mod rows;
mod several;
pub(crate) mod simulate;
pub(crate) mod slice;
pub(crate) mod solve;
pub(crate) mod sweep;
pub(crate) mod view;

use serde::Serialize;

use crate::failure::Failure;

/// Indented JSON with a line break at the end.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = serde_json::to_vec_pretty(value).map_err(Failure::work)?;
    bytes.push(b'\n');
    Ok(bytes)
}
