//! The faces of an arrangement, and which of them is at a point.

use cspace::part::Bounds;
use cspace::{Edge, Point};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use super::cycles::{Cycle, Half, curve, cycles};
use super::split::Arrangement;

/// A bounded face: what its outer boundary encloses, without what lies within it.
#[derive(Debug)]
pub(crate) struct Face {
    /// Outer boundary, then the boundaries of the components within it.
    pub(super) cycles: Vec<u32>,
    /// The area of its material.
    pub(crate) area: f64,
}

/// Bounded faces of an arrangement.
#[derive(Debug)]
pub(crate) struct Faces {
    pub(super) arrangement: Arrangement,
    pub(super) cycles: Vec<Cycle>,
    /// The faces, the largest first.
    pub(crate) faces: Vec<Face>,
    /// The face on the left of each half-edge; none outside of everything.
    pub(super) face_of: Vec<Option<u32>>,
    /// The boxes of the outer boundaries.
    tree: RTree<GeomWithData<Rectangle<[f64; 2]>, u32>>,
}

impl Faces {
    /// The faces into which the pieces of an arrangement divide the plane. Pieces that have one face on both sides are left out.
    pub(crate) fn of(mut arrangement: Arrangement) -> Self {
        let cycles = cycles(&mut arrangement);
        let mut faces: Vec<Face> = (cycles.iter().enumerate())
            .filter(|(_, cycle)| cycle.area > 0.0)
            .map(|(i, cycle)| Face {
                cycles: vec![i as u32],
                area: cycle.area,
            })
            .collect();
        // In this order, the first face whose outer boundary encloses a point is found from the back.
        faces.sort_by(|a, b| b.area.total_cmp(&a.area).then(a.cycles.cmp(&b.cycles)));
        let mut made = Self {
            face_of: vec![None; 2 * arrangement.pieces.len()],
            arrangement,
            cycles,
            faces,
            tree: RTree::new(),
        };
        let boxes = (0..made.faces.len()).map(|face| {
            let b = made.bounds(face);
            let rectangle = Rectangle::from_corners([b.min.x, b.min.y], [b.max.x, b.max.y]);
            GeomWithData::new(rectangle, face as u32)
        });
        made.tree = RTree::bulk_load(boxes.collect());
        let component = made.components();
        for (number, cycle) in made.cycles.iter().enumerate() {
            // The outside of a component lies in the smallest face of another one around it.
            if cycle.area > 0.0 {
                continue;
            }
            let own = component[cycle.halves[0] as usize / 2];
            let place = curve(&made.arrangement, cycle.halves[0]).start;
            let is_other = |face: usize| {
                let outer = &made.cycles[made.faces[face].cycles[0] as usize];
                component[outer.halves[0] as usize / 2] != own
            };
            if let Some(around) = made.enclosing(place, is_other) {
                made.faces[around].area += cycle.area;
                made.faces[around].cycles.push(number as u32);
            }
        }
        made.faces
            .sort_by(|a, b| b.area.total_cmp(&a.area).then(a.cycles.cmp(&b.cycles)));
        made.index();
        made
    }

    /// The face that has a point inside, if one has.
    pub(crate) fn at(&self, p: Point) -> Option<usize> {
        self.enclosing(p, |_| true)
    }

    /// The box of a face.
    pub(crate) fn bounds(&self, face: usize) -> Bounds {
        self.outer(face)
            .fold(Bounds::EMPTY, |b, e| b.union(e.bounds()))
    }

    /// A point inside of a face, far from its boundary if that is simple to find: in the middle of the widest of some
    /// stretches along lines across it.
    pub(crate) fn inside(&self, face: usize) -> Option<Point> {
        /// Lines across the face.
        const LINES: usize = 15;
        let edges: Vec<Edge> = self.edges(face).collect();
        let bounds = self.bounds(face);
        let wider = |places: Vec<Point>| {
            (places.into_iter().map(|p| (nearest(&edges, p), p))).max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let mut best: Option<(f64, Point)> = None;
        for i in 0..LINES {
            // Not at halves and quarters, where drawings have their corners.
            let t = (i as f64 + 0.45) / LINES as f64;
            let at = bounds.min.lerp(bounds.max, t);
            let level = stretches(&edges, at, bounds, false);
            let found = wider(level).and_then(|(_, p)| {
                let upright = stretches(&edges, p, bounds, true);
                wider(upright.into_iter().chain([p]).collect())
            });
            if let Some(found) = found.filter(|f| best.is_none_or(|b| f.0 > b.0)) {
                best = Some(found);
            }
        }
        best.map(|(_, p)| p)
    }

    /// The distance of a point from the boundary of a face.
    pub(crate) fn room(&self, face: usize, p: Point) -> f64 {
        let edges: Vec<Edge> = self.edges(face).collect();
        nearest(&edges, p)
    }

    /// The edges of a face's outer boundary.
    fn outer(&self, face: usize) -> impl Iterator<Item = Edge> {
        self.curves(self.faces[face].cycles[0])
    }

    /// Edges around a face, including those of the components within it.
    pub(super) fn edges(&self, face: usize) -> impl Iterator<Item = Edge> {
        (self.faces[face].cycles.iter()).flat_map(|&cycle| self.curves(cycle))
    }

    fn curves(&self, cycle: u32) -> impl Iterator<Item = Edge> {
        let halves: &[Half] = &self.cycles[cycle as usize].halves;
        halves.iter().map(|&h| curve(&self.arrangement, h))
    }

    /// The face with the smallest outer boundary around a point, of those that may be meant.
    fn enclosing(&self, p: Point, may_be: impl Fn(usize) -> bool) -> Option<usize> {
        let around = self
            .tree
            .locate_in_envelope_intersecting(AABB::from_point([p.x, p.y]));
        around
            .map(|b| b.data as usize)
            .filter(|&face| may_be(face))
            .filter(|&face| self.outer(face).filter(|e| e.toggles(p)).count() % 2 == 1)
            .min_by(|&a, &b| {
                let size = |face: usize| self.cycles[self.faces[face].cycles[0] as usize].area;
                size(a).total_cmp(&size(b)).then(b.cmp(&a))
            })
    }

    /// Notes where faces are after they were put in order.
    fn index(&mut self) {
        let mut boxes = Vec::with_capacity(self.faces.len());
        for face in 0..self.faces.len() {
            let b = self.bounds(face);
            let rectangle = Rectangle::from_corners([b.min.x, b.min.y], [b.max.x, b.max.y]);
            boxes.push(GeomWithData::new(rectangle, face as u32));
            for &cycle in &self.faces[face].cycles {
                for &half in &self.cycles[cycle as usize].halves {
                    self.face_of[half as usize] = Some(face as u32);
                }
            }
        }
        self.tree = RTree::bulk_load(boxes);
    }

    /// Number of the connected component of each piece.
    fn components(&self) -> Vec<u32> {
        let mut lowest: Vec<u32> = (0..self.arrangement.vertices.len() as u32).collect();
        fn root(lowest: &mut [u32], mut v: u32) -> u32 {
            while lowest[v as usize] != v {
                lowest[v as usize] = lowest[lowest[v as usize] as usize];
                v = lowest[v as usize];
            }
            v
        }
        for piece in &self.arrangement.pieces {
            let [a, b] = piece.ends.map(|v| root(&mut lowest, v));
            lowest[a.max(b) as usize] = a.min(b);
        }
        (self.arrangement.pieces.iter())
            .map(|piece| root(&mut lowest, piece.ends[0]))
            .collect()
    }
}

/// Number of the widest stretches of a line whose middles are tried.
const WIDEST: usize = 8;

/// The middles of the widest stretches inside of edges on the line through a point, along one axis or the other.
fn stretches(edges: &[Edge], through: Point, bounds: Bounds, upright: bool) -> Vec<Point> {
    let beyond = bounds.diagonal();
    let [start, end] = [-1.0, 1.0].map(|side| match upright {
        true => Point::new(through.x, bounds.center().y + side * beyond),
        false => Point::new(bounds.center().x + side * beyond, through.y),
    });
    let line = Edge::between(start, end, 0.0);
    let mut places: Vec<f64> = (edges.iter())
        .flat_map(|e| line.meetings(e, 0.0))
        .map(|p| line.fraction_at(p))
        .collect();
    places.sort_by(f64::total_cmp);
    let mut pairs: Vec<[f64; 2]> = places.windows(2).map(|p| [p[0], p[1]]).collect();
    pairs.sort_by(|a, b| (b[1] - b[0]).total_cmp(&(a[1] - a[0])));
    pairs.truncate(WIDEST);
    (pairs.iter())
        .map(|[from, to]| line.at(0.5 * (from + to)))
        .filter(|&p| edges.iter().filter(|e| e.toggles(p)).count() % 2 == 1)
        .collect()
}

/// The distance of a point from the nearest of some edges.
fn nearest(edges: &[Edge], p: Point) -> f64 {
    (edges.iter().map(|e| e.distance(p))).fold(f64::INFINITY, f64::min)
}
