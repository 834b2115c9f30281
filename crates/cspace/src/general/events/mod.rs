//! Events: the orientations at which crossings of sheets come, go and pass each other; and branches, the crossings between
//! events.

pub(crate) mod branch;
pub(crate) mod clusters;
pub(crate) mod meetings;
pub(crate) mod passing;
pub(crate) mod pinches;
pub(crate) mod placing;
pub(crate) mod trace;
pub(crate) mod triple;
