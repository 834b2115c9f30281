//! The area of blocked space at one orientation: of a slice, and certain bounds by brute force.

use cspace::{Configuration, CurveGeometry, Point, Slice, Vector};
use cspace_oracle::Oracle;

/// The area to the left of the slice's curves: ½ ∮ (x dy − y dx), about a point near them.
pub(crate) fn blocked(slice: &Slice, about: Point) -> f64 {
    let swept = |c: &CurveGeometry| {
        let (p, q) = (c.point(0.0) - about, c.point(1.0) - about);
        match *c {
            CurveGeometry::Segment { .. } => p.cross(q),
            CurveGeometry::FlatArc { start, end, bulge } => {
                // Between arc and chord there are two thirds of height times chord, but for a share of the bulge's square.
                let chord = (end - start).length_squared();
                p.cross(q) + 2.0 / 3.0 * bulge * chord * (1.0 + bulge * bulge / 5.0)
            }
            CurveGeometry::Arc {
                center,
                radius,
                sweep,
                ..
            } => radius * radius * sweep + (center - about).cross(q - p),
        }
    };
    0.5 * slice.curves.iter().map(|c| swept(&c.geometry)).sum::<f64>()
}

/// A position about which all that is blocked lies, within the oracle's size.
pub(crate) fn middle(oracle: &Oracle, theta: f64) -> Point {
    let turned = Configuration::new(0.0, 0.0, theta).fixed_from_moving(oracle.moving_center());
    Point::ORIGIN + (oracle.fixed_center() - turned)
}

/// Halvings of the square of positions.
const DEPTH: u32 = 6;

/// Lower and upper bound of the blocked area.
///
/// A square of positions is free or blocked as a whole if the margin of the verdict in its middle is more than half its
/// diagonal; otherwise it is quartered. The remaining squares count for the upper bound only.
pub(crate) fn bounds(oracle: &Oracle, theta: f64) -> (f64, f64) {
    let half = oracle.size();
    let (mut blocked, mut unknown) = (0.0, 0.0);
    let mut todo = vec![(middle(oracle, theta), half, 0)];
    while let Some((p, half, depth)) = todo.pop() {
        let verdict = oracle.judge(Configuration::new(p.x, p.y, theta));
        if verdict.margin > half * core::f64::consts::SQRT_2 * (1.0 + 1e-9) {
            if verdict.overlap {
                blocked += 4.0 * half * half;
            }
        } else if depth == DEPTH {
            unknown += 4.0 * half * half;
        } else {
            let h = 0.5 * half;
            for (dx, dy) in [(-h, -h), (h, -h), (h, h), (-h, h)] {
                todo.push((p + Vector::new(dx, dy), h, depth + 1));
            }
        }
    }
    (blocked, blocked + unknown)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cspace::{Part, Vertex};

    #[test]
    fn a_disc_about_a_disc_blocks_a_disc() {
        let disc = |r: f64| vec![vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)]];
        let (fixed, moving) = (
            Part::new("f", disc(1.0)).unwrap(),
            Part::new("m", disc(0.5)).unwrap(),
        );
        let oracle = Oracle::new(&fixed, &moving);
        let exact = core::f64::consts::PI * 1.5 * 1.5;
        let slice = Slice::compute(&fixed, &moving, 0.3);
        assert!((blocked(&slice, middle(&oracle, 0.3)) - exact).abs() < 1e-10);
        let (lo, hi) = bounds(&oracle, 0.3);
        assert!(
            lo < exact && exact < hi && hi - lo < 0.3 * exact,
            "{lo} {hi}"
        );
    }
}
