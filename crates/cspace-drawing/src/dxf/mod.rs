//! Drawings in DXF: text and binary, of R12 to R2018.
//!
//! A file is read group by group ([`groups`]). Its tables determine which layers are drawn ([`tables`]), its entities
//! become paths in coordinates of their own block ([`entity`], [`shapes`], [`polyline`], [`spline`], [`hatch`]), and
//! inserting the blocks makes a flat drawing of them ([`insert`]).

mod entity;
mod error;
mod file;
mod groups;
mod hatch;
mod insert;
mod item;
mod names;
mod polyline;
mod record;
mod shapes;
mod spline;
mod tables;

pub(crate) use error::DxfError;
pub(crate) use groups::is_binary;

use crate::drawing::Drawing;
use crate::source::Source;

/// Reads the drawing in the bytes of a file, or its requested part.
pub(crate) fn read(bytes: &[u8], source: &Source) -> Result<Drawing, DxfError> {
    insert::flatten(file::read(bytes)?, source)
}
