//! Links of every patch, found in constant time.

use crate::grouped::Grouped;
use crate::ids::PatchId;
use crate::parallel;

use super::data::{SideLink, VerticalLink};

/// For every patch, its links by the boundary at which they are.
#[derive(Debug, Clone, Default)]
pub(crate) struct Walk {
    after: Grouped,
    before: Grouped,
    above: Grouped,
    below: Grouped,
}

impl Walk {
    pub(crate) fn new(patches: usize, side: &[SideLink], vertical: &[VerticalLink]) -> Self {
        let side = || (0u32..).zip(side);
        let vertical = || (0u32..).zip(vertical);
        let ((after, before), (above, below)) = parallel::join(
            || {
                parallel::join(
                    || Grouped::new(patches, side().map(|(i, l)| (l.before.0, i))),
                    || Grouped::new(patches, side().map(|(i, l)| (l.after.0, i))),
                )
            },
            || {
                parallel::join(
                    || Grouped::new(patches, vertical().map(|(i, l)| (l.lower.0, i))),
                    || Grouped::new(patches, vertical().map(|(i, l)| (l.upper.0, i))),
                )
            },
        );
        Self {
            after,
            before,
            above,
            below,
        }
    }

    /// Numbers of the side links at the right boundary of a patch, in order of orientation.
    pub(crate) fn after(&self, patch: PatchId) -> &[u32] {
        self.after.of(patch.0)
    }

    /// Numbers of the side links at the left boundary of a patch, in order of orientation.
    pub(crate) fn before(&self, patch: PatchId) -> &[u32] {
        self.before.of(patch.0)
    }

    /// Numbers of the vertical links at the last orientation of a patch.
    pub(crate) fn above(&self, patch: PatchId) -> &[u32] {
        self.above.of(patch.0)
    }

    /// Numbers of the vertical links at the first orientation of a patch.
    pub(crate) fn below(&self, patch: PatchId) -> &[u32] {
        self.below.of(patch.0)
    }
}
