//! A tree of boxes that finds which of many things come near a place, without examining all of them.
//!
//! Things are halved by the middles of their boxes, along the longest side of the box of those middles, until few are left. The tree takes
//! memory in proportion to the number of things, whatever their sizes.

use core::cmp::Reverse;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use std::collections::BinaryHeap;
use std::sync::OnceLock;

use crate::part::Bounds;

/// Number of things up to which they are examined one by one, which is faster than dividing them.
const FEW: usize = 8;

/// A box of the plane, or one over an interval of orientations.
pub(crate) trait Volume: Copy {
    /// The empty box.
    const EMPTY: Self;
    /// The smallest box that contains this one and another.
    fn with(self, other: Self) -> Self;
    /// The middle of the box; missing coordinates are 0.
    fn middle(&self) -> [f64; 3];
}

impl Volume for Bounds {
    const EMPTY: Self = Self::EMPTY;

    fn with(self, other: Self) -> Self {
        self.union(other)
    }

    fn middle(&self) -> [f64; 3] {
        let p = self.center();
        [p.x, p.y, 0.0]
    }
}

/// A box of positions over an interval of orientations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Swath {
    pub(crate) bounds: Bounds,
    /// First orientation, radians.
    pub(crate) lo: f64,
    /// Last orientation, radians.
    pub(crate) hi: f64,
}

impl Volume for Swath {
    const EMPTY: Self = Self {
        bounds: Bounds::EMPTY,
        lo: f64::INFINITY,
        hi: f64::NEG_INFINITY,
    };

    fn with(self, other: Self) -> Self {
        Self {
            bounds: self.bounds.union(other.bounds),
            lo: self.lo.min(other.lo),
            hi: self.hi.max(other.hi),
        }
    }

    fn middle(&self) -> [f64; 3] {
        /// Lengths that a radian counts in the division: queries have one orientation, and positions near and far.
        const RADIAN: f64 = 16.0;
        let p = self.bounds.center();
        [p.x, p.y, 0.5 * RADIAN * (self.lo + self.hi)]
    }
}

/// Things with boxes, by their numbers.
#[derive(Debug)]
pub(crate) struct Boxes<B = Bounds> {
    /// Nodes in depth-first order: each before its children.
    nodes: Vec<Node<B>>,
    /// The things with their boxes; those of a leaf are consecutive.
    things: Vec<(u32, B)>,
}

/// A tree that is built after so many queries that this pays off.
#[derive(Debug, Default)]
pub(crate) struct Places {
    asked: AtomicU32,
    boxes: OnceLock<Boxes<Swath>>,
}

impl Places {
    /// The tree, if it has been built.
    pub(crate) fn made(&self) -> Option<&Boxes<Swath>> {
        self.boxes.get()
    }

    /// The tree, unless this is one of the first queries.
    pub(crate) fn after(
        &self,
        first: u32,
        make: impl FnOnce() -> Boxes<Swath>,
    ) -> Option<&Boxes<Swath>> {
        let early = self.boxes.get().is_none() && self.asked.fetch_add(1, Relaxed) < first;
        (!early).then(|| self.boxes.get_or_init(make))
    }
}

#[derive(Debug)]
struct Node<B> {
    bounds: B,
    /// The things of a leaf: first index and number. Other nodes have none.
    first: usize,
    count: usize,
    /// Index of the next node in a traversal that skips this node's children.
    after: usize,
}

impl<B: Volume> Boxes<B> {
    /// Tree of the given boxes, numbered from 0 in their order.
    pub(crate) fn new(bounds: impl Iterator<Item = B>) -> Self {
        Self::numbered((0..).zip(bounds).collect())
    }

    /// Tree of numbered boxes; several boxes may have the same number.
    pub(crate) fn numbered(mut things: Vec<(u32, B)>) -> Self {
        let mut nodes = Vec::new();
        divide(&mut things, 0, &mut nodes);
        Self { nodes, things }
    }

    /// Whether `hit` holds for any thing whose box satisfies `reaches`. Stops at the first such thing; the order of visits is
    /// deterministic.
    ///
    /// `reaches` must hold for a box if it holds for any box inside it.
    pub(crate) fn any(
        &self,
        reaches: impl Fn(&B) -> bool,
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

    /// Visits the things whose boxes are not farther than a limit, which each visit may lower by its result: nodes of the tree in order of
    /// their distance, and every thing of a leaf within the limit.
    ///
    /// Distances are not negative, and those of boxes are no less than those of a box that contains them; `None` excludes a box.
    pub(crate) fn visit_near(
        &self,
        distance: impl Fn(&B) -> Option<f64>,
        mut limit: f64,
        mut visit: impl FnMut(u32) -> f64,
    ) {
        // Non-negative numbers have the order of their bits.
        let mut waiting = BinaryHeap::new();
        let wait = |waiting: &mut BinaryHeap<_>, at: usize| {
            if let Some(d) = self.nodes.get(at).and_then(|n| distance(&n.bounds)) {
                waiting.push(Reverse((d.to_bits(), at)));
            }
        };
        wait(&mut waiting, 0);
        while let Some(Reverse((bits, at))) = waiting.pop() {
            if f64::from_bits(bits) > limit {
                return;
            }
            let node = &self.nodes[at];
            for (i, b) in &self.things[node.first..node.first + node.count] {
                if distance(b).is_some_and(|d| d <= limit) {
                    limit = visit(*i);
                }
            }
            // An inner node has two children: the next node, and the one after that node's subtree.
            if node.after > at + 1 {
                wait(&mut waiting, at + 1);
                wait(&mut waiting, self.nodes[at + 1].after);
            }
        }
    }
}

/// Adds the tree of some things, whose first has the index `first`.
fn divide<B: Volume>(things: &mut [(u32, B)], first: usize, nodes: &mut Vec<Node<B>>) {
    let mut bounds = B::EMPTY;
    let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for (_, b) in things.iter() {
        bounds = bounds.with(*b);
        for (k, m) in b.middle().into_iter().enumerate() {
            least[k] = least[k].min(m);
            most[k] = most[k].max(m);
        }
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
        let [x, y, z] = core::array::from_fn(|k| most[k] - least[k]);
        let flat = if x > y { 0 } else { 1 };
        let axis = if z > x.max(y) { 2 } else { flat };
        let half = count / 2;
        things.select_nth_unstable_by(half, |(i, a), (j, b)| {
            let (a, b) = (a.middle()[axis], b.middle()[axis]);
            a.total_cmp(&b).then(i.cmp(j))
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
    use crate::geometry::Point;

    /// The tree finds the same as an examination of every box, for any number of boxes.
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

    /// The nearest thing, and all within a limit, for boxes over intervals, compared with an examination of all.
    #[test]
    fn visits_what_is_near() {
        let mut rng = ChaCha8Rng::seed_from_u64(12);
        for count in [0, 1, FEW, FEW + 1, 1000] {
            let mut number = |reach: f64| rng.random_range(-reach..reach);
            let all: Vec<(u32, Swath)> = (0..count as u32)
                .map(|i| {
                    let p = Point::new(number(1.0), number(1.0));
                    let q = Point::new(p.x + number(0.1), p.y + number(0.1));
                    let (lo, length) = (number(1.0), number(0.5).abs());
                    let swath = Swath {
                        bounds: Bounds::of(p, q),
                        lo,
                        hi: lo + length,
                    };
                    (i, swath)
                })
                .collect();
            let boxes = Boxes::numbered(all.clone());
            for _ in 0..50 {
                let (p, t) = (Point::new(number(1.5), number(1.5)), number(1.0));
                let away = |s: &Swath| {
                    let holds = s.lo <= t && t <= s.hi;
                    holds.then(|| s.bounds.distance(p))
                };
                let mut expected: Vec<(f64, u32)> = (all.iter())
                    .filter_map(|(i, s)| Some((away(s)?, *i)))
                    .collect();
                expected.sort_by(|a, b| a.0.total_cmp(&b.0));
                let nearest = expected.first().map_or(f64::INFINITY, |e| e.0);
                let (mut found, mut visits) = (f64::INFINITY, 0);
                boxes.visit_near(away, f64::INFINITY, |i| {
                    visits += 1;
                    found = away(&all[i as usize].1).map_or(found, |d| found.min(d));
                    found
                });
                assert_eq!(found, nearest);
                assert!(visits <= expected.len().min(8 * FEW), "{visits}");
                let limit = 0.4;
                let mut within = Vec::new();
                boxes.visit_near(away, limit, |i| {
                    within.push(i);
                    limit
                });
                within.sort_unstable();
                expected.retain(|e| e.0 <= limit);
                let mut expected: Vec<u32> = expected.iter().map(|e| e.1).collect();
                expected.sort_unstable();
                assert_eq!(within, expected);
            }
        }
    }
}
