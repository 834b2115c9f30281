//! A tree of discs over the pieces of a part.

use cspace::{Layer, Part, Point, Vector};

use super::shape::Piece;

/// A disc with what is in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) middle: Point,
    pub(super) reach: f64,
    pub(super) holds: Holds,
}

/// Content of a disc of the tree.
#[derive(Debug, Clone, Copy)]
pub(super) enum Holds {
    /// A piece, by its index.
    Piece(u32),
    /// Two nodes.
    Nodes(u32, u32),
}

/// A part for measuring distances: a tree for each of its layers.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    pub(super) pieces: Vec<Piece>,
    pub(super) nodes: Vec<Node>,
    /// Each layer, with the node that holds all of it.
    layers: Vec<(Layer, u32)>,
}

impl Tree {
    /// The vertices and edges of a part, with an offset taken from every point.
    pub(super) fn new(part: &Part, origin: Vector) -> Self {
        let pieces = Piece::all(part, origin);
        let mut tree = Self {
            nodes: Vec::with_capacity(2 * pieces.len()),
            pieces,
            layers: Vec::with_capacity(part.layers().len()),
        };
        for layer in part.layers() {
            let loops = layer.loops();
            let is_own = |i: &u32| {
                let name = tree.pieces[*i as usize].name;
                loops.contains(&(name.loop_index as usize))
            };
            let mut order: Vec<u32> = (0..tree.pieces.len() as u32).filter(is_own).collect();
            let root = tree.build(&mut order);
            tree.layers.push((layer.clone(), root));
        }
        tree
    }

    /// The nodes that hold layers of two parts that meet.
    pub(super) fn roots(&self, other: &Self) -> impl Iterator<Item = (u32, u32)> {
        self.layers.iter().flat_map(move |(layer, root)| {
            let meets = other.layers.iter().filter(|(l, _)| layer.meets(l));
            meets.map(move |(_, of)| (*root, *of))
        })
    }

    /// The diameter of a disc around the largest layer.
    pub(super) fn extent(&self) -> f64 {
        let reach = |(_, root): &(Layer, u32)| self.nodes[*root as usize].reach;
        2.0 * self.layers.iter().map(reach).fold(0.0, f64::max)
    }

    fn build(&mut self, order: &mut [u32]) -> u32 {
        let piece = |i: u32| &self.pieces[i as usize];
        let node = if let [one] = order {
            Node {
                middle: piece(*one).middle,
                reach: piece(*one).reach,
                holds: Holds::Piece(*one),
            }
        } else {
            let (mut lo, mut hi) = (piece(order[0]).middle, piece(order[0]).middle);
            for &i in order.iter() {
                let p = piece(i).middle;
                lo = Point::new(lo.x.min(p.x), lo.y.min(p.y));
                hi = Point::new(hi.x.max(p.x), hi.y.max(p.y));
            }
            let wide = hi.x - lo.x > hi.y - lo.y;
            let key = |i: u32| {
                let p = piece(i).middle;
                if wide { p.x } else { p.y }
            };
            order.sort_by(|&a, &b| key(a).total_cmp(&key(b)).then(a.cmp(&b)));
            let (left, right) = order.split_at_mut(order.len() / 2);
            let (a, b) = (self.build(left), self.build(right));
            let (middle, reach) = around(&self.nodes[a as usize], &self.nodes[b as usize]);
            Node {
                middle,
                reach,
                holds: Holds::Nodes(a, b),
            }
        };
        self.nodes.push(node);
        self.nodes.len() as u32 - 1
    }
}

/// The least disc around two.
fn around(a: &Node, b: &Node) -> (Point, f64) {
    /// More than rounding takes away.
    const SLACK: f64 = 1.0 + 8.0 * f64::EPSILON;
    let way: Vector = b.middle - a.middle;
    let apart = way.length();
    if apart + b.reach <= a.reach {
        return (a.middle, a.reach);
    }
    if apart + a.reach <= b.reach {
        return (b.middle, b.reach);
    }
    let reach = 0.5 * (apart + a.reach + b.reach);
    let middle = a.middle + way * ((reach - a.reach) / apart);
    (middle, reach * SLACK)
}
