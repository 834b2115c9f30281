//! The edges and vertices of a loop as the equations need them.

use crate::feature::tolerance::{GROWTH, LARGEST_PART, SAGITTA_PART, SLIDE};
use crate::geometry::Vector;
use crate::number::Dd;
use crate::part::{Edge, Vertex};

/// The edge of a loop that starts at a vertex, with index 0.
pub(crate) fn edge_from(vertices: &[Vertex<Dd>], i: usize) -> Edge<Dd> {
    let (start, end) = (vertices[i], vertices[(i + 1) % vertices.len()]);
    Edge::between(start.point(), end.point(), start.bulge)
}

/// A vector in f64.
pub(super) fn vector(v: Vector<Dd>) -> Vector {
    v.map(Dd::to_f64)
}

/// Data of an edge that the equations need.
pub(super) struct Side {
    /// Unit directions of travel at both ends.
    pub(super) exact_leave: Vector<Dd>,
    pub(super) exact_arrive: Vector<Dd>,
    pub(super) leave: Vector,
    pub(super) arrive: Vector,
    /// Unit direction of the chord.
    pub(super) along: Vector,
    pub(super) chord: f64,
    pub(super) bulge: f64,
    /// cos and sin of half the sweep.
    pub(super) half: (f64, f64),
    /// Signed curvature, 2 sin h / L.
    pub(super) bend: f64,
}

impl Side {
    /// The data of an edge; `None` if it has no length.
    fn new(edge: &Edge<Dd>) -> Option<Self> {
        let chord = edge.chord().to_f64();
        if !(chord > 0.0 && chord.is_finite() && edge.bulge.to_f64().is_finite()) {
            return None;
        }
        let (turn, along) = edge.half_sweep();
        let (exact_leave, exact_arrive) = (turn.inverse() * along, turn * along);
        let half = (turn.cos.to_f64(), turn.sin.to_f64());
        Some(Self {
            exact_leave,
            exact_arrive,
            leave: vector(exact_leave),
            arrive: vector(exact_arrive),
            along: vector(along),
            chord,
            bulge: edge.bulge.to_f64(),
            half,
            bend: 2.0 * half.1 / chord,
        })
    }

    pub(super) fn is_line(&self) -> bool {
        self.bulge == 0.0
    }

    /// Half the chord times |b|.
    pub(super) fn sagitta(&self) -> f64 {
        0.5 * self.chord * self.bulge.abs()
    }

    /// Ratio by which the ends of an arc of almost the whole circle may be moved less than those of a shorter arc: the arc moves sideways
    /// by their lateral displacement over sin h.
    fn opening(&self) -> f64 {
        if self.half.0 < 0.0 {
            (2.0 * self.half.1.abs()).min(1.0)
        } else {
            1.0
        }
    }
}

/// The edges of a loop.
pub(super) fn sides(vertices: &[Vertex<Dd>]) -> Option<Vec<Side>> {
    (0..vertices.len())
        .map(|i| Side::new(&edge_from(vertices, i)))
        .collect()
}

/// Data of a vertex that the equations need.
pub(super) struct Knot {
    pub(super) smooth: bool,
    /// Directions of its two unknowns: along travel and to the left of it if the vertex is smooth, otherwise x and y.
    pub(super) axes: [Vector; 2],
    pub(super) weights: [f64; 2],
    /// Weight of the sagitta of the arc that starts here; 0 for a line.
    pub(super) sagitta_weight: f64,
    /// The shorter chord of its edges.
    pub(super) shortest: f64,
    /// The smaller opening of its edges.
    pub(super) opening: f64,
    /// The mean of the curvatures of its edges, and their difference.
    pub(super) bend: f64,
    pub(super) bends: f64,
}

/// The vertices of a loop.
pub(super) fn knots(sides: &[Side], smooth: &[bool]) -> Vec<Knot> {
    let n = sides.len();
    (0..n)
        .map(|i| {
            let (before, after) = (&sides[(i + n - 1) % n], &sides[i]);
            let shortest = before.chord.min(after.chord);
            let opening = before.opening().min(after.opening());
            let room = shortest * (LARGEST_PART / GROWTH);
            let across = room.min(1.0) * opening;
            let along = if smooth[i] { room.min(SLIDE) } else { across };
            let travel = (before.arrive + after.leave).unit();
            let axes = if smooth[i] {
                [travel, travel.left()]
            } else {
                [Vector::new(1.0, 0.0), Vector::new(0.0, 1.0)]
            };
            let sagitta = (after.sagitta() * (SAGITTA_PART / GROWTH)).min(1.0);
            Knot {
                smooth: smooth[i],
                axes,
                weights: [along * along, across * across],
                sagitta_weight: sagitta * sagitta,
                shortest,
                opening,
                bend: 0.5 * (before.bend + after.bend),
                bends: after.bend - before.bend,
            }
        })
        .collect()
}
