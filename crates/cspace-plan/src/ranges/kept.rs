//! A space that is known, or one that was computed in its place.

use core::ops::Deref;

use cspace::FixedAxesSpace;

#[derive(Debug)]
pub(super) enum Kept<'a> {
    Known(&'a FixedAxesSpace),
    Computed(Box<FixedAxesSpace>),
}

impl Deref for Kept<'_> {
    type Target = FixedAxesSpace;

    fn deref(&self) -> &FixedAxesSpace {
        match self {
            Self::Known(space) => space,
            Self::Computed(space) => space,
        }
    }
}
