//! Which loop is in which.

use cspace::{Part, Point};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// A loop by itself.
pub(crate) struct Lone {
    pub(crate) part: Part,
    pub(crate) first: Point,
}

/// Whether a loop is within another. Loops that cross, as parts of an assembly do, are not within each other.
fn holds(outer: &Part, inner: &Part) -> bool {
    /// Vertices that are looked at; those of loops that cross are on both sides soon.
    const MOST: usize = 256;
    let (o, i) = (outer.bounds(), inner.bounds());
    let is_in_box =
        o.min.x < i.min.x && o.min.y < i.min.y && o.max.x > i.max.x && o.max.y > i.max.y;
    let vertices = inner.loops()[0].vertices();
    let step = vertices.len().div_ceil(MOST);
    is_in_box
        && vertices
            .iter()
            .step_by(step)
            .all(|v| outer.contains(v.point()))
}

/// The most loops around another: what is no drawing of parts may have any number, and every two of them are compared.
pub(crate) const MOST_AROUND: usize = 256;

/// Outermost loops with the holes in them, by number; an island in a hole is outermost again. In the order of the loops.
///
/// # Errors
/// The loop with more than [`MOST_AROUND`] around it.
pub(crate) fn nest(loops: &[Lone]) -> Result<Vec<Vec<usize>>, usize> {
    let tree = RTree::bulk_load(
        (loops.iter().enumerate())
            .map(|(i, l)| {
                let b = l.part.bounds();
                GeomWithData::new(
                    Rectangle::from_corners([b.min.x, b.min.y], [b.max.x, b.max.y]),
                    i,
                )
            })
            .collect(),
    );
    let mut around: Vec<Vec<usize>> = Vec::with_capacity(loops.len());
    for (i, l) in loops.iter().enumerate() {
        let at = [l.first.x, l.first.y];
        let of_this: Vec<usize> = tree
            .locate_in_envelope_intersecting(AABB::from_point(at))
            .map(|r| r.data)
            .filter(|&j| j != i && holds(&loops[j].part, &l.part))
            .take(MOST_AROUND + 1)
            .collect();
        if of_this.len() > MOST_AROUND {
            return Err(i);
        }
        around.push(of_this);
    }
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut group_of = vec![usize::MAX; loops.len()];
    for (i, depth) in around.iter().map(Vec::len).enumerate() {
        if depth % 2 == 0 {
            group_of[i] = groups.len();
            groups.push(vec![i]);
        }
    }
    for (i, outer) in around.iter().enumerate() {
        if outer.len() % 2 == 0 {
            continue;
        }
        // The loop next around a hole has one loop fewer around it.
        let next = outer.iter().copied().max_by_key(|&j| around[j].len());
        if let Some(group) = next.and_then(|j| groups.get_mut(group_of[j])) {
            group.push(i);
        }
    }
    Ok(groups)
}
