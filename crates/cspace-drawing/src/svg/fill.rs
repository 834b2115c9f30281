//! Which of the loops of a path bound what it fills.

use cspace::{Point, Vector};

use crate::drawing::{Path, Piece, edge};

/// Whether each of some closed paths bounds what they fill by the rule *nonzero*: the numbers of turns that all of them make about its two
/// sides are not both zero, nor both something else. A loop in another of its direction bounds nothing, as inside and outside are filled.
pub(super) fn bounds(paths: &[Path]) -> Vec<bool> {
    let polygons: Vec<Vec<Point>> = paths.iter().map(polygon).collect();
    let each = polygons.iter().enumerate();
    each.map(|(i, own)| {
        let (Some(&a), Some(&b)) = (own.first(), own.get(1)) else {
            return true;
        };
        let at = a.midpoint(b);
        let others = polygons.iter().enumerate().filter(|(j, _)| *j != i);
        let outside: i32 = others.map(|(_, other)| turns(other, at)).sum();
        let inside = outside + if area(own) > 0.0 { 1 } else { -1 };
        (outside == 0) != (inside == 0)
    })
    .collect()
}

/// Points along a path; which side of it another is on depends on no more, unless the two nearly touch.
fn polygon(path: &Path) -> Vec<Point> {
    /// Points on an arc or a span of a curve.
    const POINTS: u32 = 16;
    let mut points = vec![path.start];
    for piece in &path.pieces {
        let from = points[points.len() - 1];
        match piece {
            Piece::Edge { to, bulge } => {
                let edge = edge(from, *to, *bulge);
                if !edge.is_line() {
                    let shares = (1..POINTS).map(|k| f64::from(k) / f64::from(POINTS));
                    points.extend(shares.map(|s| edge.at(s)));
                }
                points.push(*to);
            }
            Piece::Curve(curve) => {
                for span in 0..curve.spans() {
                    let shares = (1..=POINTS).map(|k| f64::from(k) / f64::from(POINTS));
                    points.extend(shares.map(|s| curve.at(span, s).0));
                }
            }
        }
    }
    points.dedup();
    if points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    points
}

fn sides(polygon: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().copied().zip(next.copied())
}

/// Twice the area, positive counter-clockwise.
fn area(polygon: &[Point]) -> f64 {
    let from = polygon.first().copied().unwrap_or(Point::ORIGIN);
    sides(polygon)
        .map(|(a, b)| (a - from).cross(b - from))
        .sum()
}

/// The number of turns that a polygon makes about a point, positive counter-clockwise.
fn turns(polygon: &[Point], at: Point) -> i32 {
    let crossed = |(a, b): (Point, Point)| {
        let [a, b]: [Vector; 2] = [a - at, b - at];
        match (a.y <= 0.0, b.y <= 0.0) {
            (true, false) if a.cross(b) > 0.0 => 1,
            (false, true) if a.cross(b) < 0.0 => -1,
            _ => 0,
        }
    };
    sides(polygon).map(crossed).sum()
}
