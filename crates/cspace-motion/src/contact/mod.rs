//! Bounds of a motion: contacts and ends of ranges, ends of contacts, and whether a step meets further ones.

mod bound;
mod classes;
mod cleared;
mod corner;
mod describe;
mod ends;
mod meeting;
mod overlap;
mod path;
mod pinch;
mod start;
mod straight;
#[cfg(test)]
mod tests;
mod watch;

pub(crate) use bound::{
    Bound, SAME_PLACE, brakes, limit_tolerance, limits, nearly_touching, nearly_touching_of,
    touching,
};
pub(crate) use corner::one_is_enough;
pub(crate) use describe::named;
pub(crate) use ends::{PAST_END, ends, goes_past};
pub(crate) use overlap::overlapping;
pub(crate) use path::Path;
pub(crate) use pinch::pinched;
pub(crate) use start::{check_start, names, overlap, overlap_error};
pub(crate) use watch::{LONGEST, Watch};
