//! Selection of a file's content.

use crate::color::Color;

/// Selection of a file's content: all of it, or some.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// Layers of a DXF file to be read; if empty, all that are drawn.
    pub layers: Vec<String>,
    /// Ids of the elements of an SVG file to be read; if empty, all that are drawn.
    pub ids: Vec<String>,
    /// Colours of what is read; if empty, all.
    pub colors: Vec<Color>,
    /// Line types of a DXF file to be read; if empty, all but those of centre lines, hidden edges and the like.
    pub linetypes: Vec<String>,
    /// Whether outlines of hatches in a DXF file are read too, which usually repeat other entities.
    pub hatches: bool,
}

/// Why something of another colour is left out.
pub(crate) const OTHER_COLOR: &str = "its colour was not asked for";

/// Why a hatch is left out whose outline can be taken.
pub(crate) const OFFERED: &str = "a fill, whose outline --hatches takes";
