//! Unions of outlines of lines and arcs: what any of several outlines encloses.
//!
//! The edges of all are cut where they meet, and the faces between them are kept that an outline encloses ([`arrange`]). What is left of an
//! edge stays on its line or circle, a vertex that is left is as it was given, and a new one is where two edges meet: in any type of
//! numbers, so that derivatives of what is given become those of the result.

use core::fmt;

use cspace::part::Bounds;
use cspace::part::tolerance::FLAT_BULGE;
use cspace::{Edge, Point, Real, Vector, Vertex};

use crate::arrange::{Arrangement, BoundaryEdge, Faces, boundary, enclosed, split};
use crate::corner::{Level, meeting};

/// Places nearer than this, as a share of the size of all outlines together, are one. It is some times the resolution of parts, and a
/// million times the rounding of a crossing at a wide angle.
const NEAR: f64 = 1e-10;

/// Rounding of coordinates, as a share of the largest.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Edges that meet at a smaller angle (radians) do not determine where: their crossing is off by its rounding over this.
const PARALLEL: f64 = 1e-5;

/// Enclosures wider than this, as a share of the size, may have other crossings than their middles.
const WIDE: f64 = 1e-12;

/// An edge of the outlines that are united.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnitedEdge {
    /// The outline, by number.
    pub outline: usize,
    /// Its loop.
    pub loop_index: usize,
    /// The vertex that the edge leaves, as given.
    pub vertex: usize,
}

/// Outline of what any of several outlines encloses.
#[derive(Debug, Clone, PartialEq)]
pub struct Union<T = f64> {
    /// Its loops, material on the left.
    pub loops: Vec<Vec<Vertex<T>>>,
    /// The edge that each edge of the loops is of, by the vertex that it leaves.
    pub edges: Vec<Vec<UnitedEdge>>,
    /// Where outlines touch. If the numbers vary, each of these must stay 0, or the loops are others.
    pub touches: Vec<Touch<T>>,
}

/// Two edges that touch without crossing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch<T> {
    /// Both.
    pub edges: [UnitedEdge; 2],
    /// How far they are apart, to rounding 0.
    pub gap: T,
}

/// Why outlines have no union.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum UnionError {
    /// Nothing is enclosed.
    Nothing,
    /// The edges meet too often.
    TooMany,
    /// Edges are so near to each other that it is unclear which of them cross.
    Unclear,
}

impl UnionError {
    /// Advice on how to correct the error.
    pub fn help(&self) -> &'static str {
        match self {
            Self::Nothing => {
                "give closed loops that enclose something, and no loop of an outline twice"
            }
            Self::TooMany => "unite fewer outlines, or such as cross less often",
            Self::Unclear => "let outlines overlap by more, or share an edge exactly",
        }
    }
}

impl fmt::Display for UnionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Nothing => "the outlines enclose nothing",
            Self::TooMany => "the outlines meet too often",
            Self::Unclear => "edges are too near to each other to tell which of them cross",
        })
    }
}

impl core::error::Error for UnionError {}

impl fmt::Display for UnitedEdge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            outline,
            loop_index,
            vertex,
        } = self;
        write!(f, "outline {outline}, loop {loop_index}, edge {vertex}")
    }
}

/// The union of outlines, each of which is a list of loops and encloses what an odd number of these does. Loops may cross and touch, those
/// of one outline too.
///
/// Whether the result is a part is checked by [`Part::new`](cspace::Part::new): outlines that touch in single points make none.
///
/// ```
/// use cspace::{Part, Vertex};
/// let rectangle = |x: f64, y: f64| vec![Vertex::line(-x, -y), Vertex::line(x, -y), Vertex::line(x, y), Vertex::line(-x, y)];
/// let outlines = [vec![rectangle(3.0, 1.0)], vec![rectangle(1.0, 3.0)]];
/// let cross = Part::new("cross", cspace_drawing::union(&outlines)?.loops)?;
/// assert_eq!((cross.area(), cross.edges().count()), (20.0, 12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If nothing is enclosed, edges meet too often, or are too near to each other.
pub fn union<T: Real>(outlines: &[Vec<Vec<Vertex<T>>>]) -> Result<Union<T>, UnionError> {
    let given = Given::new(outlines);
    let plain: Vec<Edge> = given.edges.iter().map(value).collect();
    let bounds = plain
        .iter()
        .fold(Bounds::EMPTY, |all, e| all.union(e.bounds()));
    let corners = [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y];
    let farthest = corners
        .into_iter()
        .fold(0.0, |far: f64, x| far.max(x.abs()));
    let size = bounds.diagonal();
    let near = NEAR * size + ROUNDING * farthest;
    let arrangement = split(&plain, near).map_err(|_| UnionError::TooMany)?;
    let mut touches = given.touches(&arrangement);
    let faces = Faces::of(arrangement);
    let set_of: Vec<u32> = given.names.iter().map(|n| n.outline as u32).collect();
    let is_inside = enclosed(&faces, &set_of).ok_or(UnionError::Unclear)?;
    let inside: Vec<usize> = (0..is_inside.len()).filter(|&f| is_inside[f]).collect();
    let found = boundary(&faces, &inside);
    if found.is_empty() {
        return Err(UnionError::Nothing);
    }
    let mut made = Union {
        loops: (found.iter())
            .map(|l| given.vertices(l, near, &mut touches))
            .collect(),
        edges: (found.iter())
            .map(|l| l.iter().map(|e| given.names[e.edge as usize]).collect())
            .collect(),
        touches,
    };
    if given.spread() > WIDE * size {
        for vertex in made.loops.iter_mut().flatten() {
            *vertex = Vertex::new(
                vertex.x.unknown(),
                vertex.y.unknown(),
                vertex.bulge.unknown(),
            );
        }
    }
    Ok(made)
}

/// The edges that are given, one after another.
struct Given<T> {
    edges: Vec<Edge<T>>,
    names: Vec<UnitedEdge>,
    /// The edge that begins where each edge ends.
    next: Vec<usize>,
}

impl<T: Real> Given<T> {
    fn new(outlines: &[Vec<Vec<Vertex<T>>>]) -> Self {
        let mut given = Self {
            edges: Vec::new(),
            names: Vec::new(),
            next: Vec::new(),
        };
        for (outline, loops) in outlines.iter().enumerate() {
            for (loop_index, vertices) in loops.iter().enumerate() {
                let (first, count) = (given.edges.len(), vertices.len());
                for (index, here) in vertices.iter().enumerate() {
                    let bulge = match here.bulge.value().abs() <= FLAT_BULGE {
                        true => T::constant(0.0),
                        false => here.bulge,
                    };
                    given.edges.push(Edge {
                        start: here.point(),
                        end: vertices[(index + 1) % count].point(),
                        bulge,
                        index,
                    });
                    given.names.push(UnitedEdge {
                        outline,
                        loop_index,
                        vertex: index,
                    });
                    given.next.push(first + (index + 1) % count);
                }
            }
        }
        given
    }

    /// The widest of the enclosures that are given.
    fn spread(&self) -> f64 {
        let of = |e: &Edge<T>| {
            let bend = e.bulge.spread() * value(e).length();
            // That of an enclosure of all reals may be no number, which a sum keeps.
            match e.start.x.spread() + e.start.y.spread() + bend {
                wide if wide.is_finite() => wide,
                _ => f64::INFINITY,
            }
        };
        self.edges.iter().map(of).fold(0.0, f64::max)
    }

    /// The gaps of edges that run along each other.
    fn touches(&self, arrangement: &Arrangement) -> Vec<Touch<T>> {
        let mut touches = Vec::new();
        for piece in &arrangement.pieces {
            let first = piece.edge as usize;
            for other in arrangement.edges_along(piece).skip(1) {
                let other = other as usize;
                // Lines and circles that have three places in common are one.
                let along = &self.edges[other];
                let middle = value(along).at(0.5);
                for p in [plain(along.start), middle, plain(along.end)] {
                    touches.push(self.touch([first, other], p));
                }
            }
        }
        touches
    }

    /// The gap at a place between edges that have one direction there.
    fn touch(&self, edges: [usize; 2], place: Point) -> Touch<T> {
        let [one, two] = edges.map(|e| level(&self.edges[e], constant(place)));
        let gap = match one.normal.dot(two.normal).value() < 0.0 {
            true => one.off + two.off,
            false => one.off - two.off,
        };
        let edges = edges.map(|e| self.names[e]);
        Touch { edges, gap }
    }

    /// The vertices of a loop of the boundary. Where edges of one direction meet, that is noted.
    fn vertices(
        &self,
        found: &[BoundaryEdge],
        near: f64,
        touches: &mut Vec<Touch<T>>,
    ) -> Vec<Vertex<T>> {
        let count = found.len();
        let at: Vec<(Point<T>, Option<usize>)> = (0..count)
            .map(|i| {
                let pair = [found[(i + count - 1) % count], found[i]];
                self.vertex(pair, near).unwrap_or_else(|| {
                    let place = found[i].start;
                    touches.push(self.touch(pair.map(|e| e.edge as usize), place));
                    (constant(place), None)
                })
            })
            .collect();
        (0..count)
            .map(|i| {
                let bulge = self.bulge(&found[i], at[i], at[(i + 1) % count]);
                let (here, _) = at[i];
                Vertex::new(here.x, here.y, bulge)
            })
            .collect()
    }

    /// The vertex at which one edge arrives and another leaves, and its number if it is one that was given; `None` if edges that have one
    /// direction there do not determine it.
    fn vertex(&self, pair: [BoundaryEdge; 2], near: f64) -> Option<(Point<T>, Option<usize>)> {
        let place = pair[1].start;
        let [of_first, of_second] = pair.map(|e| {
            let mut ends = self.ends(e.edge as usize).into_iter();
            ends.find(|&v| plain(self.edges[v].start).distance(place) <= near)
        });
        if of_first.is_some() && of_first == of_second {
            return of_first.map(|v| (self.edges[v].start, of_first));
        }
        let [one, two] = pair.map(|e| level(&self.edges[e.edge as usize], constant(place)));
        let sine = one.normal.cross(two.normal).value().abs();
        let end = of_first.or(of_second);
        if sine > PARALLEL
            && let Some(way) = meeting(one, two)
            && way.length_squared().value().sqrt() <= 4.0 * near / sine
        {
            let found = constant(place) + way;
            // The end of one edge that lies on the other keeps the digits that it was given with.
            let kept = match end {
                Some(v) if plain(self.edges[v].start) == place => place,
                _ => plain(found),
            };
            let back = kept - plain(found);
            return Some((found + Vector::new(back.x, back.y).map(T::constant), None));
        }
        // Where edges of one direction follow each other, one of them ends.
        end.map(|v| (self.edges[v].start, end))
    }

    /// The vertices at the ends of an edge, by the edges that leave them.
    fn ends(&self, edge: usize) -> [usize; 2] {
        [edge, self.next[edge]]
    }

    /// The bulge of what is left of an edge between two places.
    fn bulge(
        &self,
        of: &BoundaryEdge,
        (start, first): (Point<T>, Option<usize>),
        (end, last): (Point<T>, Option<usize>),
    ) -> T {
        let edge = &self.edges[of.edge as usize];
        let direction = T::constant(if of.is_backward { -1.0 } else { 1.0 });
        if edge.bulge.value() == 0.0 {
            return edge.bulge;
        }
        let mut ends = self.ends(of.edge as usize);
        if of.is_backward {
            ends.reverse();
        }
        if [first, last] == ends.map(Some) {
            return edge.bulge * direction;
        }
        // Half of the sweep is the angle from the direction at the start to the chord.
        let normal = level(edge, start).normal;
        let tangent = normal.right() * direction;
        let chord = end - start;
        let (side, along) = (tangent.cross(chord), tangent.dot(chord));
        let turns = if of.bulge < 0.0 { -1.0 } else { 1.0 };
        let half = (side * T::constant(turns)).atan2(along);
        (half * T::constant(0.5)).tan() * T::constant(turns)
    }
}

/// An edge's line or circle about a place; the normal is the left one.
fn level<T: Real>(edge: &Edge<T>, place: Point<T>) -> Level<T> {
    let half = edge.curvature() * T::constant(0.5);
    let way = place - edge.start;
    let left = edge.start_direction().left();
    Level {
        normal: left - way * edge.curvature(),
        off: half * way.length_squared() - left.dot(way),
        bend: half,
    }
}

fn constant<T: Real>(p: Point) -> Point<T> {
    p.map(T::constant)
}

fn plain<T: Real>(p: Point<T>) -> Point {
    p.map(T::value)
}

fn value<T: Real>(edge: &Edge<T>) -> Edge {
    Edge {
        start: plain(edge.start),
        end: plain(edge.end),
        bulge: edge.bulge.value(),
        index: edge.index,
    }
}
