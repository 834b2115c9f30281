//! Edges cut where they meet.

use core::f64::consts::FRAC_PI_4;

use cspace::{Edge, Point};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// Maximum number of places at which an edge is cut: curves that cross more often are hatchings, not the edges of parts.
const MOST_MEETINGS: usize = 400_000;

/// Maximum number of places that are compared, whether they cut or not: ends of many curves may lie at one place.
const MOST_PLACES: usize = 4_000_000;

/// Passes at most. Each cuts what the places of the pass before, moved to their vertices, made cross; the second rarely does.
const MOST_PASSES: usize = 8;

/// A stretch of an edge between two vertices that no other piece meets.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    /// The vertices at which it starts and ends.
    pub(crate) ends: [u32; 2],
    pub(crate) bulge: f64,
    /// The edge that it is of, by number, and from which fraction of its length to which.
    pub(crate) edge: u32,
    pub(crate) span: [f64; 2],
    /// The other edges that run along it: a number in [`Arrangement::along`].
    pub(super) also: u32,
}

/// Vertices, and pieces of edges between them.
#[derive(Debug, Default)]
pub(crate) struct Arrangement {
    pub(crate) vertices: Vec<Point>,
    pub(crate) pieces: Vec<Piece>,
    /// Edges, by number, that run along a piece of another one and have no piece there; none in the first list.
    along: Vec<Vec<u32>>,
}

/// Edges that meet at more than [`MOST_MEETINGS`] places, or at more than [`MOST_PLACES`] with those at their ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TooMany;

impl Arrangement {
    /// A piece as the curve between its vertices.
    pub(crate) fn curve(&self, piece: &Piece) -> Edge {
        let [start, end] = piece.ends.map(|v| self.vertices[v as usize]);
        Edge::between(start, end, piece.bulge)
    }

    /// The edges that run along a piece, its own first.
    pub(crate) fn edges_along(&self, piece: &Piece) -> impl Iterator<Item = u32> {
        let others = self.along.get(piece.also as usize).into_iter().flatten();
        core::iter::once(piece.edge).chain(others.copied())
    }
}

/// Cuts edges where they cross, touch or overlap. Places within `near` of a vertex are that vertex; the ends of edges come
/// first, so that vertices at them have the coordinates as given. Of pieces that are one to `near`, one is kept.
pub(crate) fn split(edges: &[Edge], near: f64) -> Result<Arrangement, TooMany> {
    let mut vertices = Vertices::new(near);
    let mut pieces: Vec<Piece> = Vec::with_capacity(edges.len());
    for (i, edge) in edges.iter().enumerate() {
        let [start, end] = [edge.start, edge.end].map(|p| vertices.at(p));
        let whole = Piece {
            ends: [start, end],
            bulge: edge.bulge,
            edge: i as u32,
            span: [0.0, 1.0],
            also: 0,
        };
        // An arc of more than half a turn may return to where it starts.
        if edge.bulge.abs() > 1.0 {
            let middle = vertices.at(edge.at(0.5));
            cut(&whole, &mut [(0.5, middle)], &mut pieces);
        } else if start != end {
            pieces.push(whole);
        }
    }
    let mut along = vec![Vec::new()];
    for _ in 0..MOST_PASSES {
        let mut arrangement = Arrangement {
            vertices: core::mem::take(&mut vertices.points),
            pieces,
            along,
        };
        arrangement.remove_repeated(near);
        let curves: Vec<Edge> = (arrangement.pieces.iter())
            .map(|p| arrangement.curve(p))
            .collect();
        let meetings = meetings(&curves, near)?;
        vertices.points = core::mem::take(&mut arrangement.vertices);
        let mut cuts: Vec<(u32, f64, u32)> = Vec::new();
        for (piece, at) in meetings {
            let vertex = vertices.at(at);
            if !arrangement.pieces[piece as usize].ends.contains(&vertex) {
                let place = vertices.points[vertex as usize];
                cuts.push((piece, curves[piece as usize].fraction_at(place), vertex));
            }
        }
        if cuts.is_empty() {
            arrangement.vertices = vertices.points;
            return Ok(arrangement);
        }
        cuts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        pieces = Vec::with_capacity(arrangement.pieces.len() + cuts.len());
        let mut rest = &cuts[..];
        for (i, piece) in arrangement.pieces.iter().enumerate() {
            let count = rest.iter().take_while(|c| c.0 as usize == i).count();
            let mut own: Vec<(f64, u32)> = rest[..count].iter().map(|c| (c.1, c.2)).collect();
            rest = &rest[count..];
            cut(piece, &mut own, &mut pieces);
        }
        along = arrangement.along;
    }
    let mut arrangement = Arrangement {
        vertices: vertices.points,
        pieces,
        along,
    };
    arrangement.remove_repeated(near);
    Ok(arrangement)
}

/// The places at which curves meet, each for both of them; places that end both curves cut neither and are left out.
fn meetings(curves: &[Edge], near: f64) -> Result<Vec<(u32, Point)>, TooMany> {
    let boxes = curves.iter().enumerate().map(|(i, curve)| {
        let b = curve.bounds();
        let corners = ([b.min.x, b.min.y], [b.max.x, b.max.y]);
        GeomWithData::new(Rectangle::from_corners(corners.0, corners.1), i as u32)
    });
    let tree = RTree::bulk_load(boxes.collect());
    let (mut meetings, mut compared) = (Vec::new(), 0);
    for (i, curve) in curves.iter().enumerate() {
        let b = curve.bounds();
        let reach = AABB::from_corners(
            [b.min.x - near, b.min.y - near],
            [b.max.x + near, b.max.y + near],
        );
        let mut others: Vec<u32> = tree
            .locate_in_envelope_intersecting(reach)
            .map(|other| other.data)
            .filter(|&other| other as usize > i)
            .collect();
        others.sort_unstable();
        for other in others {
            let other_curve = &curves[other as usize];
            let mut kept: Vec<Point> = Vec::new();
            for place in curve.meetings(other_curve, near) {
                compared += 1;
                let ends = [is_end(curve, place), is_end(other_curve, place)];
                let is_one = |&at: &Point| run_together(curve, other_curve, [at, place], near);
                if ends == [false, false] && kept.iter().any(is_one) {
                    continue;
                }
                kept.push(place);
                if ends != [true, true] {
                    meetings.extend([(i as u32, place), (other, place)]);
                }
            }
        }
        if meetings.len() > MOST_MEETINGS || compared > MOST_PLACES {
            return Err(TooMany);
        }
    }
    Ok(meetings)
}

/// Whether two curves stay near each other between two places at which they meet. Then they meet once: where curves are tangent, rounding
/// lets them cross some way off.
fn run_together(curve: &Edge, other: &Edge, places: [Point; 2], near: f64) -> bool {
    let [from, to] = places.map(|p| curve.fraction_at(p));
    other.distance(curve.at(0.5 * (from + to))) <= near
}

fn is_end(curve: &Edge, place: Point) -> bool {
    curve.start == place || curve.end == place
}

/// The parts of a piece between its ends and vertices at fractions of it; without those that end where they start.
fn cut(piece: &Piece, at: &mut [(f64, u32)], pieces: &mut Vec<Piece>) {
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    let [from, to] = piece.span;
    let quarter = piece.bulge.atan();
    let mut start = (0.0, piece.ends[0]);
    for &end in at.iter().chain(&[(1.0, piece.ends[1])]) {
        if end.1 == start.1 {
            continue;
        }
        pieces.push(Piece {
            ends: [start.1, end.1],
            // The bulge of a whole piece stays as given, 0 for a line.
            bulge: match (start.0, end.0) {
                (0.0, 1.0) => piece.bulge,
                _ => ((end.0 - start.0) * quarter)
                    .clamp(-FRAC_PI_4, FRAC_PI_4)
                    .tan(),
            },
            edge: piece.edge,
            span: [start.0, end.0].map(|u: f64| from + u * (to - from)),
            also: piece.also,
        });
        start = end;
    }
}

impl Arrangement {
    /// Removes pieces that are one with another to within `near`; the first is kept, and notes the edges of the others.
    fn remove_repeated(&mut self, near: f64) {
        let mut order: Vec<([u32; 2], u32)> = (self.pieces.iter().enumerate())
            .map(|(i, p)| {
                (
                    [p.ends[0].min(p.ends[1]), p.ends[0].max(p.ends[1])],
                    i as u32,
                )
            })
            .collect();
        order.sort_unstable();
        let mut is_repeated = vec![false; self.pieces.len()];
        for group in order.chunk_by(|a, b| a.0 == b.0).filter(|g| g.len() > 1) {
            let mut kept: Vec<(Point, u32)> = Vec::new();
            for &(_, i) in group {
                let middle = self.curve(&self.pieces[i as usize]).at(0.5);
                // Pieces with both ends in common are as far apart in the middle as anywhere; ends are moved by up to `near`.
                match kept.iter().find(|k| k.0.distance(middle) <= 2.0 * near) {
                    Some(&(_, first)) => {
                        is_repeated[i as usize] = true;
                        self.note(first, i);
                    }
                    None => kept.push((middle, i)),
                }
            }
        }
        let mut repeated = is_repeated.iter();
        self.pieces.retain(|_| repeated.next() != Some(&true));
    }

    /// Notes that the edges along a piece run along another one, too.
    fn note(&mut self, first: u32, repeated: u32) {
        let [kept, removed] = [first, repeated].map(|i| self.pieces[i as usize]);
        let all: Vec<u32> = (self.edges_along(&kept).skip(1))
            .chain(self.edges_along(&removed))
            .collect();
        self.pieces[first as usize].also = self.along.len() as u32;
        self.along.push(all);
    }
}

/// Points, no two within a distance of each other.
struct Vertices {
    points: Vec<Point>,
    tree: RTree<GeomWithData<[f64; 2], u32>>,
    near: f64,
}

impl Vertices {
    fn new(near: f64) -> Self {
        Self {
            points: Vec::new(),
            tree: RTree::new(),
            near,
        }
    }

    /// The vertex nearest to a place if it is near; else a new one there.
    fn at(&mut self, p: Point) -> u32 {
        let nearest = self.tree.nearest_neighbor([p.x, p.y]);
        if let Some(known) = nearest.map(|n| n.data)
            && self.points[known as usize].distance(p) <= self.near
        {
            return known;
        }
        let new = self.points.len() as u32;
        self.points.push(p);
        self.tree.insert(GeomWithData::new([p.x, p.y], new));
        new
    }
}
