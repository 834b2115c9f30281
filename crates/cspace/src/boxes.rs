//! A tree of boxes: which of many things come near a place, without a look at each of them.
//!
//! Things are halved by the middles of their boxes, along the longer side of what holds those middles, until few are left.
//! The tree takes memory in proportion to the number of things, whatever their sizes.

use crate::geometry::Point;
use crate::part::Bounds;

/// So many things are looked at one by one faster than they are divided.
const FEW: usize = 8;

/// Things with boxes, by their numbers.
#[derive(Debug)]
pub(crate) struct Boxes {
    /// In the order of a walk that comes to a node before what it holds.
    nodes: Vec<Node>,
    /// The things with their boxes; those of a leaf stand together.
    things: Vec<(u32, Bounds)>,
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    /// The things of a leaf: so many from the first. Other nodes have none of their own.
    first: usize,
    count: usize,
    /// Where a walk goes on that leaves out what the node holds.
    after: usize,
}

impl Boxes {
    /// Of boxes that are numbered from 0.
    pub(crate) fn new(bounds: impl Iterator<Item = Bounds>) -> Self {
        let mut things: Vec<(u32, Bounds)> = (0..).zip(bounds).collect();
        let mut nodes = Vec::new();
        divide(&mut things, 0, &mut nodes);
        Self { nodes, things }
    }

    /// Whether `hit` is true of a thing whose box `reaches`. Stops at the first; the order is always the same.
    ///
    /// A box must reach if one inside it does.
    pub(crate) fn any(
        &self,
        reaches: impl Fn(&Bounds) -> bool,
        mut hit: impl FnMut(u32) -> bool,
    ) -> bool {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            if !reaches(&node.bounds) {
                at = node.after;
                continue;
            }
            let things = &self.things[node.first..node.first + node.count];
            if things.iter().any(|(i, b)| reaches(b) && hit(*i)) {
                return true;
            }
            at += 1;
        }
        false
    }
}

/// Adds the tree of some things, of which the first stands at `first` among all.
fn divide(things: &mut [(u32, Bounds)], first: usize, nodes: &mut Vec<Node>) {
    let (mut bounds, mut middles) = (Bounds::EMPTY, Bounds::EMPTY);
    for (_, b) in things.iter() {
        bounds = bounds.union(*b);
        middles = middles.union(Bounds::of(b.center(), b.center()));
    }
    let (here, count) = (nodes.len(), things.len());
    let leaf = count <= FEW;
    nodes.push(Node {
        bounds,
        first,
        count: if leaf { count } else { 0 },
        after: 0,
    });
    if !leaf {
        let wide = middles.max.x - middles.min.x > middles.max.y - middles.min.y;
        let key = |p: Point| if wide { p.x } else { p.y };
        let half = count / 2;
        things.select_nth_unstable_by(half, |(i, a), (j, b)| {
            key(a.center()).total_cmp(&key(b.center())).then(i.cmp(j))
        });
        let (low, high) = things.split_at_mut(half);
        divide(low, first, nodes);
        divide(high, first + half, nodes);
    }
    nodes[here].after = nodes.len();
}

#[cfg(test)]
mod tests {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    /// The tree finds what a look at every box finds, for any number of boxes.
    #[test]
    fn finds_what_a_look_at_each_finds() {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        for count in [0, 1, FEW, FEW + 1, 100, 1000] {
            let mut point = |reach: f64| {
                Point::new(
                    rng.random_range(-reach..reach),
                    rng.random_range(-reach..reach),
                )
            };
            let all: Vec<Bounds> = (0..count)
                .map(|_| {
                    let p = point(1.0);
                    Bounds::of(p, p + point(0.2).to_vector())
                })
                .collect();
            let boxes = Boxes::new(all.iter().copied());
            for _ in 0..50 {
                let asked = Bounds::of(point(1.2), point(1.2));
                let reaches = |b: &Bounds| !b.is_apart(asked, 0.0);
                let mut found = Vec::new();
                assert!(!boxes.any(reaches, |i| {
                    found.push(i);
                    false
                }));
                found.sort_unstable();
                let expected: Vec<u32> = (0..)
                    .zip(&all)
                    .filter(|(_, b)| reaches(b))
                    .map(|(i, _)| i)
                    .collect();
                assert_eq!(found, expected, "{count}");
                assert_eq!(boxes.any(reaches, |_| true), !expected.is_empty());
            }
        }
    }
}
