//! Nesting of loops.

use cspace::part::Bounds;
use cspace::{Edge, Point, Vertex};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::drawing::edge;
use crate::join::ROUND;

/// A loop by itself, whether or not it may be one of a part.
#[derive(Debug)]
pub(crate) struct Ring {
    edges: Vec<Edge>,
    bounds: Bounds,
}

impl Ring {
    pub(crate) fn of(vertices: &[Vertex]) -> Self {
        let next = vertices.iter().cycle().skip(1);
        let edges: Vec<Edge> = (vertices.iter().zip(next))
            .map(|(from, to)| edge(from.point(), to.point(), from.bulge))
            .collect();
        let bounds = (edges.iter()).fold(Bounds::EMPTY, |all, e| all.union(e.bounds()));
        Self { edges, bounds }
    }

    /// The diagonal of its box.
    pub(crate) fn size(&self) -> f64 {
        self.bounds.diagonal()
    }

    /// Whether its inside is on its left.
    pub(crate) fn turns_left(&self) -> bool {
        let about = self.edges.first().map_or(Point::ORIGIN, |e| e.start);
        let area: f64 = self.edges.iter().map(|e| e.area_swept(about)).sum();
        area > 0.0
    }

    /// Whether it is a rectangle of lines along the axes.
    fn is_upright_rectangle(&self) -> bool {
        let b = self.bounds;
        let near = self.rounding();
        let is_on = |x: f64, of: [f64; 2]| of.iter().any(|side| (x - side).abs() <= near);
        let is_corner = |p: Point| is_on(p.x, [b.min.x, b.max.x]) && is_on(p.y, [b.min.y, b.max.y]);
        self.edges.len() == 4 && (self.edges.iter()).all(|e| e.is_line() && is_corner(e.start))
    }

    /// Whether the sides of its box are those of another, but for a share of its size.
    pub(crate) fn is_as_large_as(&self, other: Bounds, share: f64) -> bool {
        let far = |a: f64, b: f64| (a - b).abs() > share * self.size();
        let (a, b) = (self.bounds, other);
        !(far(a.max.x - a.min.x, b.max.x - b.min.x) || far(a.max.y - a.min.y, b.max.y - b.min.y))
    }

    /// Whether another loop is within this one.
    pub(crate) fn has_within(&self, other: &Self) -> bool {
        !core::ptr::eq(self, other) && self.holds(other)
    }

    fn contains(&self, p: Point) -> bool {
        self.bounds.contains(p) && self.edges.iter().filter(|e| e.toggles(p)).count() % 2 == 1
    }

    fn distance(&self, p: Point) -> f64 {
        (self.edges.iter().map(|e| e.distance(p))).fold(f64::INFINITY, f64::min)
    }

    /// Distance within which a point may lie on the ring.
    fn rounding(&self) -> f64 {
        ROUND * self.size()
    }

    /// Vertices, the middles of edges, and places between, of very many some: a circle in its square lies on it at all of the first two.
    pub(crate) fn places(&self) -> impl Iterator<Item = Point> {
        /// Number of edges that are sampled; loops that cross are found after few.
        const MOST: usize = 256;
        /// A share of an edge at which nothing is that is drawn evenly: the golden section.
        const BETWEEN: f64 = 0.618_033_988_749_894_9;
        let step = self.edges.len().div_ceil(MOST).max(1);
        (self.edges.iter().step_by(step)).flat_map(|e| [e.start, e.at(0.5), e.at(BETWEEN)])
    }

    /// Whether another loop is within this one; it may touch it. Loops that cross, as parts of an assembly do, are not
    /// within each other.
    fn holds(&self, inner: &Self) -> bool {
        let (o, i, near) = (self.bounds, inner.bounds, self.rounding());
        let is_in_box = o.min.x <= i.min.x + near
            && o.min.y <= i.min.y + near
            && o.max.x >= i.max.x - near
            && o.max.y >= i.max.y - near;
        // Points on this loop are not decisive.
        let mut is_inside = false;
        is_in_box
            && inner.places().all(|p| {
                let is_on = || self.distance(p) <= near;
                match self.contains(p) {
                    true => {
                        is_inside = is_inside || !is_on();
                        true
                    }
                    false => is_on(),
                }
            })
            && is_inside
    }
}

/// The rectangle around all other loops, of which there are so many or more.
pub(crate) fn sheet<'r>(loops: impl Iterator<Item = &'r Ring>, least: usize) -> Option<usize> {
    let loops: Vec<&Ring> = loops.collect();
    let largest = (0..loops.len()).filter(|&i| loops[i].is_upright_rectangle());
    let largest = largest.max_by(|&a, &b| loops[a].size().total_cmp(&loops[b].size()))?;
    let mut others = loops.iter().filter(|l| !core::ptr::eq(**l, loops[largest]));
    let holds_all = loops.len() > least && others.all(|l| loops[largest].holds(l));
    holds_all.then_some(largest)
}

/// Largest number of loops around another: a file that is no drawing of parts may have any number, and every two of
/// them are compared.
pub(crate) const MOST_AROUND: usize = 256;

/// Outermost loops with the holes in them, by number; an island in a hole is outermost again. In the order of the loops.
///
/// # Errors
/// The loop with more than [`MOST_AROUND`] around it.
pub(crate) fn nest(loops: &[&Ring]) -> Result<Vec<Vec<usize>>, usize> {
    let tree = RTree::bulk_load(
        (loops.iter().enumerate())
            .map(|(i, l)| {
                let (b, near) = (l.bounds, l.rounding());
                GeomWithData::new(
                    Rectangle::from_corners(
                        [b.min.x - near, b.min.y - near],
                        [b.max.x + near, b.max.y + near],
                    ),
                    i,
                )
            })
            .collect(),
    );
    let mut around: Vec<Vec<usize>> = Vec::with_capacity(loops.len());
    for (i, l) in loops.iter().enumerate() {
        let first = l.edges.first().map_or(Point::ORIGIN, |e| e.start);
        let of_this: Vec<usize> = tree
            .locate_in_envelope_intersecting(AABB::from_point([first.x, first.y]))
            .map(|r| r.data)
            .filter(|&j| j != i && loops[j].holds(l))
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
