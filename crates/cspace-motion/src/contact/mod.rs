//! What holds a motion on: contacts and ends of ranges, where contacts end, and whether a step meets others.

mod bound;
mod describe;
mod ends;
mod overlap;
mod pinch;
mod watch;

pub(crate) use bound::{Bound, limit_tolerance, limits, nearly_touching, touching};
pub(crate) use describe::named;
pub(crate) use ends::ends;
pub(crate) use overlap::overlapping;
pub(crate) use pinch::pinched;
pub(crate) use watch::{Watch, path};

/// Two touching places of a pair that are nearer to each other than this, relative to the size of the mechanism, are the same
/// contact, which passes from one feature to the next.
pub(crate) const SAME_PLACE: f64 = 1e-6;
