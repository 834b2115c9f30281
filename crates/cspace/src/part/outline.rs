//! All edges of the loops of a part's layer in one list, in the frame in which they are checked.

use super::frame::Frame;
use super::{Bounds, Edge, PartError, Vertex};

/// The edges of all loops as given, numbered one after another.
pub(super) struct Outline {
    frame: Frame,
    /// The edges in the frame of size 1 to 2; `index` is the number in this list.
    pub(super) edges: Vec<Edge>,
    /// The box of each edge.
    boxes: Vec<Bounds>,
    /// The edge that starts where each edge ends.
    next: Vec<usize>,
    /// The first edge of each loop.
    pub(super) first: Vec<usize>,
    /// Number of the first loop in the part.
    first_loop: usize,
}

impl Outline {
    /// Lists the edges of some of a part's loops, which passed the checks of their numbers.
    pub(super) fn new(loops: &[Vec<Vertex>], first_loop: usize, bounds: Bounds) -> Self {
        let frame = Frame::new(bounds);
        let count = loops.iter().map(Vec::len).sum();
        let mut edges = Vec::with_capacity(count);
        let mut next = Vec::with_capacity(count);
        let mut first = Vec::with_capacity(loops.len());
        for vertices in loops {
            let start = edges.len();
            first.push(start);
            let n = vertices.len();
            for i in 0..n {
                let j = (i + 1) % n;
                edges.push(frame.edge(vertices[i], vertices[j], start + i));
                next.push(start + j);
            }
        }
        let boxes = edges.iter().map(Edge::bounds).collect();
        Self {
            frame,
            edges,
            boxes,
            next,
            first,
            first_loop,
        }
    }

    /// The length below which places are one place.
    pub(super) fn tolerance(&self) -> f64 {
        self.frame.tolerance
    }

    /// The edge after an edge.
    pub(super) fn after(&self, edge: usize) -> usize {
        self.next[edge]
    }

    /// Whether two edges are the same or share a vertex.
    pub(super) fn are_neighbours(&self, a: usize, b: usize) -> bool {
        a == b || self.next[a] == b || self.next[b] == a
    }

    /// Whether the boxes of two edges are farther apart than the tolerance.
    pub(super) fn are_apart(&self, a: usize, b: usize) -> bool {
        self.boxes[a].is_apart(self.boxes[b], self.tolerance())
    }

    /// The loop of an edge in the part, and its number there.
    pub(super) fn name(&self, edge: usize) -> (usize, usize) {
        let own = self.first.partition_point(|&first| first <= edge) - 1;
        (self.first_loop + own, edge - self.first[own])
    }

    /// The error for two edges that meet.
    pub(super) fn refuse(&self, a: usize, b: usize, meeting: super::meeting::Meeting) -> PartError {
        use super::meeting::Meeting;
        let (loop_index, edge_index) = self.name(a.min(b));
        let (other_loop, other_edge) = self.name(a.max(b));
        match meeting {
            Meeting::Crossing(at) => PartError::Crossing {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at: self.frame.leave(at),
            },
            Meeting::Touching(at) => PartError::Touching {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at: self.frame.leave(at),
            },
        }
    }
}
