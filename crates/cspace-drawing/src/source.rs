//! Selection of a file's content.

/// Selection of a file's content: all of it, or some.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// Layers of a DXF file to be read; if empty, all that are drawn.
    pub layers: Vec<String>,
    /// Id of the only element of an SVG file to be read.
    pub id: Option<String>,
    /// Whether outlines of hatches in a DXF file are read too, which usually repeat other entities.
    pub hatches: bool,
}

/// Why a hatch is left out whose outline can be taken.
pub(crate) const OFFERED: &str = "a fill, whose outline --hatches takes";
