//! Bounds of a motion, functions that must not become negative: contact functions, and distances to the ends of ranges.

use cspace::Point;

use crate::pairs::{Pairs, Touch};
use crate::system::{PartCoordinates, Row, System};

/// A function of the coordinates that may not become negative.
// There are a few of them at a time, nearly all of them contacts.
#[allow(clippy::large_enum_variant)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Bound {
    /// Contact of two features.
    Contact(Touch),
    /// Limit: a part at an end of its range.
    Limit {
        /// The part.
        part: usize,
        /// Whether the upper end of the range is reached, and not the lower.
        upper: bool,
    },
    /// Brake of a part: it holds in both directions.
    Brake {
        /// The part.
        part: usize,
        /// Coordinate at which it stands.
        at: f64,
    },
}

impl Bound {
    pub(crate) fn is_brake(&self) -> bool {
        matches!(self, Self::Brake { .. })
    }

    /// Whether two bounds are of the same features, or the same end of a range.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Contact(a), Self::Contact(b)) => a.pair == b.pair && a.features == b.features,
            (Self::Brake { part: a, .. }, Self::Brake { part: b, .. }) => a == b,
            _ => self == other,
        }
    }

    /// Place of a contact, in the assembly's frame; `None` of other bounds.
    pub(crate) fn place(&self, system: &System, pairs: &Pairs, q: &[f64]) -> Option<Point> {
        match self {
            Self::Contact(touch) => pairs.list()[touch.pair].point(touch, system, q).ok(),
            Self::Limit { .. } | Self::Brake { .. } => None,
        }
    }

    /// Value and derivatives of the bound's function.
    pub(crate) fn function(&self, system: &System, pairs: &Pairs, q: &[f64]) -> Row {
        match self {
            Self::Contact(touch) => pairs.list()[touch.pair].function(touch, system, q),
            Self::Brake { part, at } => {
                let mut row = Row::default();
                if let Some(i) = system.parts()[*part].indices().next() {
                    row = Row::new(q[i] - at);
                    row.push(i, 1.0);
                }
                row
            }
            Self::Limit { part, upper } => {
                let PartCoordinates::Axis {
                    first,
                    range: Some((lo, hi)),
                    ..
                } = system.parts()[*part]
                else {
                    return Row::default();
                };
                let (value, slope) = if *upper {
                    (hi - q[first], -1.0)
                } else {
                    (q[first] - lo, 1.0)
                };
                let mut row = Row::new(value);
                row.push(first, slope);
                row
            }
        }
    }
}

/// Distance beyond the end of a range that counts as rounding, in radians or relative to the size of the mechanism: the
/// accuracy of contacts.
const AT_LIMIT: f64 = 1e-10;

/// A range's end within reach: the part, its upper or lower end, and how far it is to go.
pub(crate) fn limits(system: &System, q: &[f64]) -> Vec<(Bound, f64)> {
    let mut all = Vec::new();
    for (part, coordinates) in system.parts().iter().enumerate() {
        if let PartCoordinates::Axis {
            first,
            range: Some((lo, hi)),
            ..
        } = *coordinates
        {
            all.push((Bound::Limit { part, upper: false }, q[first] - lo));
            all.push((Bound::Limit { part, upper: true }, hi - q[first]));
        }
    }
    all
}

/// The tolerance of the coordinate of a part at the end of its range.
pub(crate) fn limit_tolerance(system: &System, part: usize) -> f64 {
    match system.parts()[part].orientation() {
        Some(_) => AT_LIMIT,
        None => AT_LIMIT * system.size(),
    }
}

/// Two touching places of a pair that are nearer to each other than this, relative to the size of the mechanism, are the same
/// contact, which passes from one feature to the next.
pub(crate) const SAME_PLACE: f64 = 1e-6;

/// Contacts are searched up to this multiple of the distance at which they open.
pub(super) const REACH: f64 = 4.0;

/// The brakes of parts, where they stand.
pub(crate) fn brakes(system: &System, q: &[f64]) -> Vec<Bound> {
    let braked = system.braked().iter().copied();
    let brake = |part: usize| {
        let at = q[system.parts()[part].indices().start];
        Bound::Brake { part, at }
    };
    braked.map(brake).collect()
}

/// The contacts that touch, and the ends of ranges that are reached.
pub(crate) fn touching(system: &System, pairs: &Pairs, q: &[f64]) -> Vec<Bound> {
    nearly_touching(system, pairs, q, 0.0)
}

/// Bounds that are closed or closer to it than a length.
pub(crate) fn nearly_touching(system: &System, pairs: &Pairs, q: &[f64], near: f64) -> Vec<Bound> {
    let of = |pair: usize| nearly_touching_of(system, pairs, pair, q, near);
    let mut all: Vec<Bound> = (0..pairs.list().len()).flat_map(of).collect();
    let reached = limits(system, q).into_iter().filter(|(bound, room)| {
        matches!(bound, Bound::Limit { part, .. } if *room < REACH * limit_tolerance(system, *part))
    });
    all.extend(reached.map(|(bound, _)| bound));
    all
}

/// The contacts of one pair that touch, or nearly: within a length.
pub(crate) fn nearly_touching_of(
    system: &System,
    pairs: &Pairs,
    index: usize,
    q: &[f64],
    near: f64,
) -> Vec<Bound> {
    let pair = &pairs.list()[index];
    // Outside of its space nothing touches, and the motion does not go on.
    let touches = pair.touches(index, system, q, near.max(REACH * pair.touch));
    let touches = touches.unwrap_or_default().into_iter();
    touches.map(Bound::Contact).collect()
}
