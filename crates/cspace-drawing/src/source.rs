//! What of a file is read.

/// What of a file is read: all of it, or some.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// Of a DXF file these layers alone; all that are drawn where there are none.
    pub layers: Vec<String>,
    /// Of an SVG file the element of this id alone.
    pub id: Option<String>,
    /// Of a DXF file the outlines of hatches too, which usually repeat what is drawn.
    pub hatches: bool,
}

/// Why a hatch is left out whose outline can be taken.
pub(crate) const OFFERED: &str = "a fill, whose outline --hatches takes";
