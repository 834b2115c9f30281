//! Choice of the contacts that keep slightly overlapping parts from overlapping more.
//!
//! ```text
//!   convex corner:              \ b /   one contact is enough: that which is
//!      where both overlap,   ____\ /    nearer to being open
//!      each is between its   a  ● |
//!      feature's ends             |
//!
//!   concave corner:           |         both are needed; where both overlap, one at
//!      the place of a contact |b        least is past its end, and not the one that
//!      is past the end      ● |______   overlaps more
//!                                a
//! ```

use cspace::{FeatureKind, Point};

use crate::pairs::{MovingPair, Pairs, Touch};
use crate::system::System;

use super::bound::{Bound, limit_tolerance, limits};
use super::ends::{ends, is_long};

/// Contacts whose places are closer than this multiple of the displacement are at one corner.
const ONE_CORNER: f64 = 8.0;
/// Distance past the end of an edge that is more than rounding, relative to the size of the mechanism.
const PAST: f64 = 1e-10;

/// A contact that overlaps.
struct Overlap {
    touch: Touch,
    gap: f64,
    place: Point,
    /// Whether the place of contact is past the end of an edge.
    past: bool,
}

/// Contacts and ends of ranges with gap ≤ 0 and penetration ≤ a length, which keep the parts from overlapping more.
/// `None` if a pair has left its space.
pub(crate) fn overlapping(
    system: &System,
    pairs: &Pairs,
    q: &[f64],
    way: f64,
) -> Option<Vec<Bound>> {
    let mut all = Vec::new();
    for (index, pair) in pairs.list().iter().enumerate() {
        let touches = pair.overlaps(index, system, q, way).ok()?;
        let found: Vec<Overlap> = (touches.into_iter())
            .filter_map(|touch| judged(system, pair, touch, q, way))
            .collect();
        let is_kept = |&(i, a): &(usize, &Overlap)| {
            let is_beside = |&(k, b): &(usize, &Overlap)| {
                k != i && b.place.distance(a.place) <= ONE_CORNER * way
            };
            let mut beside = found.iter().enumerate().filter(is_beside);
            if a.past {
                // Also both past their ends: then they are of a concave corner.
                let mut others = beside.peekable();
                others.peek().is_some() && others.all(|(_, b)| b.past || b.gap <= a.gap)
            } else {
                // If two are equally near, either will do.
                beside.all(|(k, b)| b.past || b.gap < a.gap || (b.gap == a.gap && k > i))
            }
        };
        let kept = found.iter().enumerate().filter(is_kept);
        all.extend(kept.map(|(_, o)| Bound::Contact(o.touch)));
    }
    let reached = limits(system, q).into_iter().filter(|(bound, room)| {
        matches!(bound, Bound::Limit { part, .. } if *room <= limit_tolerance(system, *part))
    });
    all.extend(reached.map(|(bound, _)| bound));
    Some(all)
}

/// Judges a contact: `None` if it penetrates by more than a length or one of its features has ended.
fn judged(
    system: &System,
    pair: &MovingPair,
    touch: Touch,
    q: &[f64],
    way: f64,
) -> Option<Overlap> {
    let gap = pair.function(&touch, system, q).value;
    let way = way.max(pair.touch);
    if !(-way..=pair.touch).contains(&gap) {
        return None;
    }
    let turn = way / pair.space.moving().size();
    let slack = PAST * system.size();
    let all = ends(pair, &touch, system, q);
    let mut past = false;
    let (f, m) = touch.features;
    let parts = [(pair.space.fixed(), f), (pair.space.moving(), m)];
    for ((part, feature), values) in parts.into_iter().zip(all.chunks(2)) {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        if feature.name.kind == FeatureKind::Vertex {
            if least < -turn {
                return None;
            }
        } else if least < -slack && !is_long(part, feature) {
            if least < -ONE_CORNER * way {
                return None;
            }
            past = true;
        }
    }
    let place = pair.point(&touch, system, q).ok()?;
    Some(Overlap {
        touch,
        gap,
        place,
        past,
    })
}
