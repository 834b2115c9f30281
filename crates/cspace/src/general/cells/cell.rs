//! Cells: pieces into which branches cut a sheet.

/// In place of a branch: the end of the sheet's contact curves.
pub(crate) const END: u32 = u32::MAX;

/// A piece of a sheet whose left and right bounds stay the same from one cluster of events to another.
///
/// The cell as a whole is on the boundary of free space, or not.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cell {
    pub(crate) sheet: u32,
    pub(crate) from: u32,
    pub(crate) to: u32,
    /// The branch at which it begins in the direction of travel, or [`END`].
    pub(crate) left: u32,
    /// The branch at which it ends, or [`END`].
    pub(crate) right: u32,
    /// Whether its bounds show that it is in blocked space.
    pub(crate) blocked: bool,
    /// Whether it begins, or ends, where its sheet's interval of orientations does.
    pub(crate) at_bottom: bool,
    pub(crate) at_top: bool,
}

/// Two cells that continue each other in orientation, and the part of the contact curve that they share there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct VerticalContact {
    pub(crate) lower: u32,
    pub(crate) upper: u32,
    /// The cluster of events they share.
    pub(crate) at: u32,
    /// Range of places on the lower cell's contact curve.
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether the shared piece is certainly longer than its error.
    pub(crate) certain: bool,
}

/// Two cells that follow each other along the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SideContact {
    /// The cell that ends in the direction of travel, and the cell that begins there.
    pub(crate) before: u32,
    pub(crate) after: u32,
    pub(crate) from: u32,
    pub(crate) to: u32,
    /// The branch at which they meet, or [`END`] for a shared end.
    pub(crate) branch: u32,
}
