//! What of a file is read.

/// What of a file is read: all of it, or some.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Source {
    /// Of a DXF file these layers alone; all that are drawn where there are none.
    pub layers: Vec<String>,
    /// Of an SVG file the element of this id alone.
    pub id: Option<String>,
}
