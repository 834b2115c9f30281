//! Two parts on axes and where they are.

use cspace::{Axis, FixedAxesSpace, Part};
use cspace_model::PartEntry;

/// Two parts on axes and where they are.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    pub(super) parts: [&'a Part; 2],
    pub(super) axes: [Axis; 2],
    pub(super) place: [f64; 2],
}

impl<'a> Pair<'a> {
    /// The fixed and the moving part at motions u and v of them; none if one has no axis. A motion outside of a part's range is that of the
    /// nearer end of it.
    pub fn new(parts: [&'a PartEntry; 2], place: [f64; 2]) -> Option<Self> {
        let axes = [parts[0].axis?, parts[1].axis?];
        let parts = parts.map(|entry| &entry.part);
        Some(Self::on(parts, axes, place))
    }

    /// The parts of a space at motions u and v of them.
    pub(super) fn of(space: &'a FixedAxesSpace, place: [f64; 2]) -> Self {
        let (fixed, moving) = space.axes();
        Self::on([space.fixed(), space.moving()], [fixed, moving], place)
    }

    fn on(parts: [&'a Part; 2], axes: [Axis; 2], place: [f64; 2]) -> Self {
        let held = |k: usize| match axes[k].range {
            Some((lo, hi)) if lo <= hi => place[k].clamp(lo, hi),
            _ => place[k],
        };
        Self {
            parts,
            axes,
            place: [held(0), held(1)],
        }
    }

    /// Where the parts are.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }
}
