//! Check of whether loops make a part, as far as random drawing needs it, and the area of a part.

use cspace::{Part, Point, Vertex};

use super::curve::Curve;
use super::plane::Place;

/// The least distance between two edges that do not follow each other; 0 when edges cross, or when a corner has less
/// than 0.25 radians on either side, or an edge is shorter than 0.05.
pub(crate) fn least_gap(loops: &[Vec<Vertex>]) -> f64 {
    let mut edges: Vec<(usize, usize, usize, Curve<f64>)> = Vec::new();
    for (l, vertices) in loops.iter().enumerate() {
        let n = vertices.len();
        for (i, v) in vertices.iter().enumerate() {
            let place = |p: Point| Place::new(p.x, p.y);
            let end = vertices[(i + 1) % n].point();
            edges.push((l, i, n, Curve::new(place(v.point()), place(end), v.bulge)));
        }
    }
    let mut least = f64::INFINITY;
    for (k, (l, i, n, a)) in edges.iter().enumerate() {
        if (a.end - a.start).length() < 0.05 {
            return 0.0;
        }
        for (m, j, _, b) in &edges[..k] {
            let mut crossing = false;
            let corners: Vec<Place<f64>> =
                match (l == m && (j + 1) % n == *i, l == m && (i + 1) % n == *j) {
                    (false, false) => Vec::new(),
                    (true, false) => vec![a.start],
                    (false, true) => vec![a.end],
                    (true, true) => vec![a.start, a.end],
                };
            a.meet(b, |p| {
                crossing |= corners.iter().all(|&c| (p - c).length() > 1e-9);
            });
            if crossing {
                return 0.0;
            }
            if corners.is_empty() {
                least = least.min(a.distance(b));
            }
            for c in corners {
                if sharpness(a, b, c) < 0.25 {
                    return 0.0;
                }
            }
        }
    }
    least
}

/// The angle between two edges at a corner of both.
fn sharpness(a: &Curve<f64>, b: &Curve<f64>, corner: Place<f64>) -> f64 {
    let away = |c: &Curve<f64>| {
        let (other, turn) = if (c.start - corner).length() < (c.end - corner).length() {
            (c.end, f64::from(c.turn))
        } else {
            (c.start, -f64::from(c.turn))
        };
        if c.is_line() {
            other - corner
        } else {
            (corner - c.center).left().times(turn)
        }
    };
    let (u, v) = (away(a), away(b));
    u.cross(v).atan2(u.dot(v)).abs()
}

/// The area of a part: that of loops within an even number of others, less that of the rest.
///
/// For tests of shapes. It takes the first vertex of a loop to say where the loop is.
pub fn area(part: &Part) -> f64 {
    let loops: Vec<Vec<Curve<f64>>> = part
        .loops()
        .iter()
        .map(|l| {
            let v = l.vertices();
            let place = |i: usize| Place::new(v[i % v.len()].x, v[i % v.len()].y);
            (0..v.len())
                .map(|i| Curve::new(place(i), place(i + 1), v[i].bulge))
                .collect()
        })
        .collect();
    let mut sum = 0.0;
    for (i, l) in loops.iter().enumerate() {
        let p = l[0].start;
        let depth = loops
            .iter()
            .enumerate()
            .filter(|(j, other)| i != *j && other.iter().filter(|c| c.flips(p)).count() % 2 == 1)
            .count();
        let size = swept(l, part.loops()[i].vertices()).abs();
        sum += if depth % 2 == 0 { size } else { -size };
    }
    sum
}

/// The signed area within a loop.
fn swept(curves: &[Curve<f64>], vertices: &[Vertex]) -> f64 {
    let origin = curves[0].start;
    curves
        .iter()
        .zip(vertices)
        .map(|(c, v)| {
            let sweep = 4.0 * v.bulge.atan();
            0.5 * (c.start - origin).cross(c.end - origin)
                + 0.5 * c.radius * c.radius * (sweep - sweep.sin())
        })
        .sum()
}
