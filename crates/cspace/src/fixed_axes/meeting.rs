//! Configurations at which a cycle of one part coincides with an equal one of the other part: their centres coincide.
//!
//! A joint X with the normal n touches a circle of radius r, with opposite normals, where the circle's centre is at X + r n: at the centre
//! of an equal circle that contains X and has the normal −n there.

use super::motion::Motion;
use super::tolerance::INDEPENDENT;
use crate::contact::Cycle;
use crate::geometry::{Point, Rotation, Vector};

/// Coordinates (s, t) of both parts at which two cycles of equal weight and size coincide: at most two. For parts that both turn, only
/// those that are plausible for the second part's orientation relative to the first, t − s.
pub(super) fn meetings(
    (first, p): (Motion, &Cycle),
    (second, q): (Motion, &Cycle),
    plausible: impl Fn(Rotation) -> bool,
    mut found: impl FnMut(u8, f64, f64),
) {
    match (first, second) {
        (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
            let (v, w, between) = (p.arm(c), q.arm(d), (d - c) * p.weight);
            let (e, f, apart) = (v.length(), w.length(), between.length());
            let (sum, less) = (
                e + f,
                p.weight * (p.off(e, p.level(c)) - q.off(f, q.level(d))),
            );
            // Heron's formula: 16 times the square of the area of the triangle of both pivots and the centre.
            let square = (apart - less) * (apart + less) * (sum - apart) * (sum + apart);
            // A point at the pivot does not move: the other cycle is there at every orientation or at none.
            if square < 0.0 || c.distance(d).min(e).min(f) < INDEPENDENT {
                return;
            }
            // The height is twice the area over the base, which has two parts.
            let height = 0.5 * square.sqrt() / apart;
            let along = 0.5 * (apart + less * sum / apart);
            let base = between * (1.0 / apart);
            for (root, up) in [(0, height), (1, -height)] {
                let aside = base.left() * up;
                let s = turn(v, base * along + aside, e * e);
                let t = turn(w, base * (along - apart) + aside, f * f);
                let theta = Rotation {
                    cos: s.cos * t.cos + s.sin * t.sin,
                    sin: s.cos * t.sin - s.sin * t.cos,
                };
                if plausible(theta) {
                    found(root, s.sin.atan2(s.cos), t.sin.atan2(t.cos));
                }
            }
        }
        (Motion::Turn { center }, Motion::Slide { direction }) => {
            slid(p, center, q, direction, found);
        }
        (Motion::Slide { direction }, Motion::Turn { center }) => {
            slid(q, center, p, direction, |root, t, s| found(root, s, t));
        }
        (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
            // λ (s d − t e) is the vector from the arm of one cycle to that of the other.
            let area = d.cross(e);
            if area.abs() >= INDEPENDENT {
                let v = (q.through - p.through) + (p.normal - q.normal) * (1.0 / p.weight);
                found(0, v.cross(e) / area, v.cross(d) / area);
            }
        }
        (Motion::Still, _) | (_, Motion::Still) => {}
    }
}

/// The turn from one vector to another of equal length, whose square is given.
fn turn(from: Vector, to: Vector, square: f64) -> Rotation {
    Rotation {
        cos: from.dot(to) / square,
        sin: from.cross(to) / square,
    }
}

/// Root, angle and distance at which a cycle that turns about a centre coincides with one that slides along a direction.
fn slid(
    turning: &Cycle,
    center: Point,
    sliding: &Cycle,
    d: Vector,
    mut found: impl FnMut(u8, f64, f64),
) {
    let (v, w) = (turning.arm(center), sliding.arm(center));
    let (e, f, along, side) = (v.length(), w.length(), d.dot(w), d.left());
    // A point at the pivot does not move.
    if e < INDEPENDENT {
        return;
    }
    // |v| − ρ, from which |v| ∓ d × w is computed without cancellation.
    let more = turning.weight * turning.off(e, turning.level(center));
    let square = (more + sliding.support(center, -side)) * (more + sliding.support(center, side));
    if square < 0.0 {
        return;
    }
    let less = more - sliding.weight * sliding.off(f, sliding.level(center));
    for (root, half) in [(0, square.sqrt()), (1, -square.sqrt())] {
        // half − along: of two equivalent forms the one without cancellation.
        let distance = if (half < 0.0) == (along < 0.0) {
            less * (e + f) / (half + along)
        } else {
            half - along
        };
        let at = d * half + side * side.dot(w);
        found(
            root,
            v.cross(at).atan2(v.dot(at)),
            distance / turning.weight,
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Results agree whether a circle is given by its centre or by one of two of its points.
    #[test]
    fn circles_coincide_where_they_meet() {
        let turn = |x: f64, y: f64| Motion::Turn {
            center: Point::new(x, y),
        };
        let slide = |angle: f64| Motion::Slide {
            direction: Vector::from_angle(angle),
        };
        let bow = |center: Point, radius: f64, at: f64| {
            let normal = Vector::from_angle(at);
            Cycle::flat(center + normal * radius, normal, 1.0 / radius)
        };
        let (p, q) = (Point::new(0.3, -0.8), Point::new(0.5, 0.1));
        let mut count = 0;
        for (first, second) in [
            (turn(0.1, 0.2), turn(-0.4, 0.3)),
            (turn(0.1, 0.2), slide(0.7)),
            (slide(2.1), turn(-0.4, 0.3)),
            (slide(2.1), slide(0.7)),
        ] {
            for (a, b) in [
                (Cycle::round(p, 0.0), Cycle::round(q, 0.0)),
                (bow(p, 500.0, 1.1), bow(q, 500.0, 1.2)),
                (bow(p, -3000.0, 1.1), bow(q, -3000.0, 1.1)),
            ] {
                meetings(
                    (first, &a),
                    (second, &b),
                    |_| true,
                    |_, s, t| {
                        let from = Point::new(0.7, 0.7);
                        let (a, b) = (first.moved(s, &a), second.moved(t, &b));
                        let off = (a.arm(from) - b.arm(from)).length() / a.weight.abs();
                        assert!(off < 1e-11, "{first:?} {second:?} {a:?} {b:?}");
                        count += 1;
                    },
                );
            }
        }
        assert!(count > 12, "{count}");
    }
}
