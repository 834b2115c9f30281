//! Parts that are held between two contacts which all but oppose each other.
//!
//! ```text
//!        ____                     The disc is larger than the hole by a part in a million, and rests on both corners. Where
//!      /      \                   it does is known to the resolution over the slope of the contact functions: patches end
//!  ___(        )___               farther from there than contacts are known, and where a part is wedged at the last
//!      \ ____ /                   orientation at which it fits, they end with it.
//! ```

use cspace::Point;

use crate::pairs::{MovingPair, Pairs, Touch};
use crate::system::System;

use super::bound::{Bound, REACH, SAME_PLACE};

/// Contacts of a pair that clamp its parts between them: at least two, at different places, whose functions vanish
/// within the error of contacts and whose patches are closer than that. Empty if another contact nearby penetrates more
/// deeply.
pub(crate) fn pinching(system: &System, pair: (usize, &MovingPair), q: &[f64]) -> Vec<Touch> {
    within(system, pair, q, pair.1.touch)
}

/// As `pinch`, for every pair whose overlap after a step exceeds the error of contacts.
pub(crate) fn pinched(system: &System, pairs: &Pairs, q: &[f64]) -> Vec<Bound> {
    let of = |pair: (usize, &MovingPair)| within(system, pair, q, REACH * pair.1.touch);
    let all = pairs.list().iter().enumerate().flat_map(of);
    all.map(Bound::Contact).collect()
}

/// As [`pinching`], within another error; the pair comes with its place in the list.
fn within(
    system: &System,
    (index, pair): (usize, &MovingPair),
    q: &[f64],
    depth: f64,
) -> Vec<Touch> {
    let near = SAME_PLACE * system.size();
    let turn = near / pair.space.moving().size();
    let touches = pair.touches_beside(index, pair.coordinates(system, q), near, turn);
    let valued = touches.unwrap_or_default().into_iter().map(|touch| {
        let value = pair.function(&touch, system, q).value;
        (touch, value)
    });
    let valued: Vec<(Touch, f64)> = valued.collect();
    if valued.iter().any(|(_, value)| *value < -depth) {
        return Vec::new();
    }
    let closed: Vec<Touch> = (valued.into_iter())
        .filter(|(_, value)| *value <= depth)
        .map(|(touch, _)| touch)
        .collect();
    let places: Vec<Point> = (closed.iter())
        .filter_map(|touch| pair.point(touch, system, q).ok())
        .collect();
    let apart = |p: &Point| places.iter().any(|r| p.distance(*r) > near);
    if places.iter().any(apart) {
        closed
    } else {
        Vec::new()
    }
}
