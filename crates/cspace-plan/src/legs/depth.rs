//! Whether parts overlap deeply.

use cspace::{Edge, Part, Point};

use super::at::{At, Layers, any_layers};
use super::near::Near;
use super::overlap::coincide;
use super::search::Search;

/// A piece whose ends are close to an edge goes along it all the way if it is shorter than this share of the radii of both.
const LONGEST: f64 = 0.25;
/// Points of one boundary that are deepest in the other are looked for on common normals up to so many depths long.
pub(super) const NORMALS: f64 = 8.0;
/// Pieces of the boundary are halved down to so many of the depths that are asked for.
const SHORTEST: f64 = 4.0;

/// Whether some point of one part's boundary lies deeper in the other's material than a depth: then the parts overlap wherever no
/// point of them has moved farther than that against the other.
///
/// A boundary is deepest in a corner, on a common normal, of which `feet` are the ends, or where two places of the other boundary are
/// equally near. The last are found if they are deep enough for pieces of the boundary to show it.
pub(super) fn is_deep(a: &At<'_>, b: &At<'_>, feet: &[Near], depth: f64) -> bool {
    any_layers(a, b, |Layers { a, b, loops }| {
        let own = |near: &&Near| {
            let (f, m) = near.features;
            loops.0.contains(&(f.loop_index as usize)) && loops.1.contains(&(m.loop_index as usize))
        };
        let of_a = feet.iter().filter(own).map(|near| near.points.0 + a.origin);
        let of_b = feet.iter().filter(own).map(|near| near.points.1 + b.origin);
        within(a, b, of_a, depth) || within(b, a, of_b, depth)
    })
}

/// Whether a point of the first part's boundary is deep in the second.
fn within(
    outline: &At<'_>,
    material: &At<'_>,
    mut feet: impl Iterator<Item = Point>,
    depth: f64,
) -> bool {
    let seen = |q: Point| material.back(outline.out(q));
    let is_deep = |q: Point| {
        let p = seen(q);
        nearest(material.part, p).is_some_and(|(d, _)| d > depth) && material.part.contains(p)
    };
    let corners = outline.part.loops().iter().flat_map(|l| l.vertices());
    let pieces = Pieces {
        material: material.part,
        depth,
    };
    corners.into_iter().any(|v| is_deep(v.point()))
        || feet.any(is_deep)
        || (outline.part.edges()).any(|e| pieces.any_deep(&e, (0.0, 1.0), &seen))
}

/// The search along the pieces of a boundary.
struct Pieces<'a> {
    material: &'a Part,
    depth: f64,
}

impl Pieces<'_> {
    fn any_deep(&self, e: &Edge, (lo, hi): (f64, f64), seen: &impl Fn(Point) -> Point) -> bool {
        let middle = 0.5 * (lo + hi);
        let half = 0.5 * (hi - lo) * e.length();
        if half < SHORTEST * self.depth {
            return false;
        }
        let p = seen(e.at(middle));
        let Some((distance, edge)) = nearest(self.material, p) else {
            return false;
        };
        let inside = self.material.contains(p);
        if inside && distance > self.depth {
            return true;
        }
        if !inside && half <= distance + self.depth {
            return false;
        }
        // Along one edge the whole piece is about as near to it as its ends, and on the side of its middle.
        let ends = [lo, hi].map(|u| seen(e.at(u)));
        let bent = half * half * self.bend(e, &edge, ends);
        let along = if inside {
            let farther = ends.map(|q| edge.distance(q));
            farther[0].max(farther[1]) + bent <= self.depth
        } else {
            bent <= self.depth
                && ends.iter().all(|&q| {
                    nearest(self.material, q).is_some_and(|(_, other)| other == edge)
                        && !self.material.contains(q)
                })
        };
        if along {
            return false;
        }
        self.any_deep(e, (lo, middle), seen) || self.any_deep(e, (middle, hi), seen)
    }
}

impl Pieces<'_> {
    /// How much the distance from an edge bends at most along a piece of a boundary with these ends: the second derivative.
    fn bend(&self, piece: &Edge, edge: &Edge, ends: [Point; 2]) -> f64 {
        let (k, m) = (piece.curvature(), edge.curvature());
        let most = k.abs().max(m.abs());
        let is_long = ends[0].distance(ends[1]) * most > LONGEST;
        if is_long || ends.iter().any(|&q| edge.distance(q) > self.depth) {
            return k.abs() + m.abs();
        }
        // Both ends are close to the edge, so the piece goes along it, and bends from it by the difference of the curvatures.
        let along = if edge.is_line() {
            edge.end - edge.start
        } else {
            (ends[0].midpoint(ends[1]) - edge.center()).left() * edge.bulge
        };
        let same_way = (ends[1] - ends[0]).dot(along) >= 0.0;
        (k - if same_way { m } else { -m }).abs() + most * most * self.depth
    }
}

/// The distance of the nearest edge, with the edge.
fn nearest(part: &Part, p: Point) -> Option<(f64, Edge)> {
    (part.edges())
        .map(|e| (e.distance(p), e))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Whether parts overlap at the start of a search deeper than a depth, also where their boundaries coincide. What overlaps five times as
/// deep is always found.
pub(super) fn overlaps_deeper(search: &Search<'_>, a: &At<'_>, b: &At<'_>, depth: f64) -> bool {
    // Where no boundaries cross, every edge is in the other part as a whole or not at all.
    if any_layers(a, b, |l| {
        coincide(&l.a, &l.b, depth) || coincide(&l.b, &l.a, depth)
    }) {
        return true;
    }
    if !search.crosses() {
        return false;
    }
    let mut feet = Vec::new();
    search.within(NORMALS * depth, |near| feet.push(near));
    is_deep(a, b, &feet, depth)
}
