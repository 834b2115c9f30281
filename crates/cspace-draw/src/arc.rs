//! Arcs as cubic curves, for formats without arcs.

use cspace::{Edge, Point};

use crate::scene::Dot;

/// An arc as cubic curves: two control points and the end of each.
///
/// A piece of an arc by an angle φ has control points on its end tangents, 4/3 tan(φ/4) radii from the ends: at a quarter of a
/// turn it leaves the circle by 2.7·10⁻⁴ of the radius, which grows with the sixth power of φ.
pub(crate) fn cubics(from: Dot, to: Dot, bulge: f64) -> Vec<[Dot; 3]> {
    /// Largest turn of a piece: with an eighth of a turn it deviates from the circle by 4·10⁻⁶ of the radius.
    const LONGEST: f64 = core::f64::consts::FRAC_PI_4;
    /// Below it an arc of any length that is seen is straight.
    const STRAIGHT: f64 = 1e-9;
    if bulge.abs() < STRAIGHT {
        return vec![[from, to, to]];
    }
    let arc = edge(from, to, bulge);
    let (center, sweep) = (arc.center(), arc.sweep());
    let n = (sweep.abs() / LONGEST).ceil().max(1.0);
    let (sin, cos) = (sweep / n).sin_cos();
    let reach = 4.0 / 3.0 * (0.25 * sweep / n).tan();
    let (mut x, mut y) = (from.x - center.x, from.y - center.y);
    let mut pieces = Vec::new();
    for i in 1..=n as usize {
        let (u, v) = (x * cos - y * sin, x * sin + y * cos);
        let at = |x: f64, y: f64| Dot::new(center.x + x, center.y + y);
        let end = if i == n as usize { to } else { at(u, v) };
        pieces.push([
            at(x - reach * y, y + reach * x),
            at(u + reach * v, v - reach * u),
            end,
        ]);
        (x, y) = (u, v);
    }
    pieces
}

/// An arc, in dots: that y is downwards mirrors the centre as it does the ends.
pub(crate) fn edge(from: Dot, to: Dot, bulge: f64) -> Edge {
    Edge::between(Point::new(from.x, from.y), Point::new(to.x, to.y), bulge)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of the cubic curves are on the circle about a centre that is found independently: both ends are at the
    /// same distance from it, and the sweep is that of the bulge.
    #[test]
    fn cubics_stay_on_the_circle() {
        for bulge in [0.01, 0.3, 1.0, 2.5, -0.2, -1.0, -7.0] {
            let (from, to) = (Dot::new(3.0, 4.0), Dot::new(-1.0, 7.0));
            let arc = edge(from, to, bulge);
            let (c, r) = (Dot::new(arc.center().x, arc.center().y), arc.radius());
            let mut start = from;
            let mut turned = 0.0;
            for [p, q, end] in cubics(from, to, bulge) {
                let mut last = start;
                for k in 1..=8 {
                    let t = f64::from(k) / 8.0;
                    let s = 1.0 - t;
                    let mix = |a: f64, b: f64, c: f64, d: f64| {
                        s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
                    };
                    let x = mix(start.x, p.x, q.x, end.x);
                    let y = mix(start.y, p.y, q.y, end.y);
                    let at = Dot::new(x, y);
                    assert!((at.distance(c) - r).abs() < 5e-6 * r, "{bulge}");
                    let cross = (last.x - c.x) * (y - c.y) - (last.y - c.y) * (x - c.x);
                    turned += (cross / (r * r)).asin();
                    last = at;
                }
                start = end;
            }
            assert_eq!(start, to);
            assert!((turned - 4.0 * bulge.atan()).abs() < 1e-4, "{bulge}");
        }
    }
}
