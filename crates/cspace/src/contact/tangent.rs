//! Contacts that are one circle or tangent at every orientation.
//!
//! Where a flat arc is involved, each condition of tangency is α cos θ + β sin θ + γ = 0, but the three are large and
//! all but cancel. So they are not written down: the condition is evaluated from points near the parts.

use crate::feature::tolerance::{SAME_CARRIER, TANGENCY_STEP};
use crate::geometry::{Rotation, Vector};
use crate::number::Real;

use super::cycle::Cycle;
use super::sheet::Sheet;
use super::spiral::Spiral;

impl Sheet {
    /// Whether two sheets have one circle as carrier at every orientation: arcs on one circle, or equal sums of radii
    /// about the same centres. Their curves do not cross, whatever rounding makes of it.
    pub(crate) fn same_circle(&self, other: &Self) -> bool {
        let apart = |a: Vector, b: Vector| (a - b).length() > SAME_CARRIER;
        let (c, d) = (self.locus.through, other.locus.through);
        self.is_circle()
            && other.is_circle()
            && !apart(c.u.to_vector(), d.u.to_vector())
            && !apart(c.w, d.w)
            && (self.locus.radius.abs() - other.locus.radius.abs()).abs() <= SAME_CARRIER
    }

    /// Whether two flat arcs are one circle at every orientation at which both exist: the same three places are on both at the
    /// first, the middle and the last.
    pub(super) fn same_flat_arc(&self, other: &Self) -> bool {
        if !(self.is_flat_arc() && other.is_flat_arc()) {
            return false;
        }
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        [lo, 0.5 * (lo + hi), hi].iter().all(|&theta| {
            let turn = Rotation::by(theta);
            let (f, g): (Cycle, Cycle) = (self.cycle(turn), other.cycle(turn));
            let on = |u: f64| f.distance(g.at(Vector::new(u, 0.0))).abs() <= SAME_CARRIER;
            f.normal.dot(g.normal_at(f.through)) > 0.0 && [-1.0, 0.0, 1.0].into_iter().all(on)
        })
    }

    /// Whether a line and a circle, or two circles, are tangent at every orientation: halves of one disc against a side and
    /// the corner it ends at, or against two arcs that follow each other smoothly. Their curves do not cross, whatever rounding
    /// makes of it.
    pub(super) fn always_tangent(&self, other: &Self) -> bool {
        if self.is_flat() || other.is_flat() {
            return always_touch(self, other);
        }
        let (line, circle) = match (self.is_circle(), other.is_circle()) {
            (false, false) => return false,
            (false, true) => (self, other),
            (true, false) => (other, self),
            (true, true) => {
                let (c, d) = (self.locus.through, other.locus.through);
                let (u, w) = (c.u - d.u, c.w - d.w);
                let apart = match (u.length() <= SAME_CARRIER, w.length() <= SAME_CARRIER) {
                    (false, true) => u.length(),
                    (true, false) => w.length(),
                    _ => return false,
                };
                let (r, s) = (self.locus.radius.abs(), other.locus.radius.abs());
                return (apart - (r + s)).abs().min((apart - (r - s).abs()).abs()) <= SAME_CARRIER;
            }
        };
        let (stays, turns) = line.locus.seen(&circle.locus.through);
        let off = line.locus.normal.dot(stays).abs() - circle.locus.radius.abs();
        turns.length() <= SAME_CARRIER && off.abs() <= SAME_CARRIER
    }
}

/// A condition of tangency.
#[derive(Clone, Copy)]
enum Condition<'a> {
    /// A line or flat arc tangent to a flat arc, their normals alike or opposed.
    Alike(&'a Sheet, &'a Sheet, bool),
    /// A flat arc, or a line that large arcs move, tangent to a circle, on one of its two sides.
    Circle(&'a Sheet, &'a Sheet, bool),
}

/// Error of a length computed from coordinates near the parts.
const LENGTH_ERROR: f64 = 32.0 * f64::EPSILON;

/// How much larger than its estimate an error may be.
const MARGIN: f64 = 4.0;

/// The conditions under which two curves are tangent, of which one is a flat arc or moves with one.
fn tangencies<'a>(f: &'a Sheet, g: &'a Sheet) -> impl Iterator<Item = Condition<'a>> {
    let of = move |side: bool| match (f.is_circle(), g.is_circle()) {
        (true, true) => None,
        (false, true) => Some(Condition::Circle(f, g, side)),
        (true, false) => Some(Condition::Circle(g, f, side)),
        (false, false) if f.is_line() && g.is_line() => None,
        (false, false) => Some(Condition::Alike(f, g, side)),
    };
    [true, false].into_iter().filter_map(of)
}

/// Whether two curves, of which one is a flat arc or moves with one, are tangent at every orientation: contacts of one feature
/// with two others that follow each other smoothly.
///
/// The condition is α cos θ + β sin θ + γ = 0: if it is so at three orientations far from each other, it is so at all.
fn always_touch(f: &Sheet, g: &Sheet) -> bool {
    let mid = 0.5 * (f.lo.max(g.lo) + f.hi.min(g.hi));
    tangencies(f, g).any(|condition| {
        [-TANGENCY_STEP, 0.0, TANGENCY_STEP].into_iter().all(|d| {
            let (value, size) = condition.at(Rotation::by(mid + d));
            value.abs() <= MARGIN * LENGTH_ERROR * size * condition.pace()
        })
    })
}

impl Condition<'_> {
    /// Its value, and the error of a value in units of [`LENGTH_ERROR`].
    fn at<T: Real>(&self, turn: Rotation<T>) -> (T, f64) {
        let (real, half) = (T::constant, T::constant(0.5));
        match *self {
            Self::Alike(f, g, alike) => {
                // |c − d|² = (r ∓ s)² for the centres c = X − r n and d = Y − s m, over ±2 r s.
                let (f, g) = (f.cycle(turn), g.cycle(turn));
                let (v, side) = (f.through - g.through, if alike { 1.0 } else { -1.0 });
                let (n, k) = (f.normal, f.weight);
                let (m, l) = (g.normal * real(side), g.weight * real(side));
                let (cross, along) = (n.cross(m), n.dot(m));
                let less = if along.value() > 0.0 {
                    cross * cross / (real(1.0) + along)
                } else {
                    real(1.0) - along
                };
                let value = v.length_squared() * half * k * l - v.dot(n) * l + v.dot(m) * k + less;
                (value, 8.0 * (k.value().abs() + l.value().abs()))
            }
            Self::Circle(f, g, outer) => {
                // |c − d|² = (r ± s)² for the centre c = X − r n and a circle about d, over −2 r.
                let f = f.cycle(turn);
                let r = real(if outer {
                    g.locus.radius
                } else {
                    -g.locus.radius
                });
                let v = f.through - g.locus.through.lift().at(turn);
                let value = v.dot(f.normal) + r - (v.length_squared() - r * r) * half * f.weight;
                (value, 1.0)
            }
        }
    }

    /// How fast what it is made of moves, per radian, if that is more than the size of the parts.
    fn pace(&self) -> f64 {
        let of = |s: &Spiral| s.turning().length();
        let (Self::Alike(f, g, _) | Self::Circle(f, g, _)) = *self;
        1.0 + of(&f.locus.through) + of(&g.locus.through)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
pub(super) mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::super::pair::Geometry;
    use super::super::sheet::SheetKind;
    use super::*;
    use crate::geometry::{Point, Rotation, Vector};
    use crate::number::{Ball, Dual};
    use crate::part::{Part, Vertex};

    fn part(name: &str, size: f64, bulges: [f64; 4]) -> Part {
        let at = |x: f64, y: f64, b: f64| Vertex::new(x * size, y * size, b);
        let [a, b, c, d] = bulges;
        let outline = vec![
            at(-1.0, -1.0, a),
            at(1.0, -0.9, b),
            at(1.1, 1.0, c),
            at(-0.4, 1.2, d),
        ];
        Part::new(name, vec![outline]).unwrap()
    }

    /// The same contact with circles about their centres, and ends as two vectors: right as long as the radii are no larger
    /// than here.
    pub(in crate::contact) fn plain(sheet: &Sheet) -> Sheet {
        let spiral = |s: &Spiral| Spiral::new(s.u + s.swing.arm, s.turning());
        let mut plain = *sheet;
        let locus = &mut plain.locus;
        (locus.start, locus.end) = (spiral(&locus.start), spiral(&locus.end));
        locus.through = spiral(&locus.through);
        if let Some(center) = locus.center() {
            (locus.kind, locus.through) = (SheetKind::RoundRound, center);
        }
        plain
    }

    /// The centre of what a sheet is about its centre, and its signed radius; of a line a point, the normal, and no radius.
    fn carried(sheet: &Sheet, theta: f64) -> (Point, Vector, Option<f64>) {
        let Cycle {
            through,
            normal,
            weight,
            size,
        } = plain(sheet).cycle(Rotation::by(theta));
        (through, normal, (weight != 0.0).then_some(weight * size))
    }

    /// What a condition is by centres and radii, as far as these tell it.
    fn by_centers(condition: &Condition<'_>, theta: f64) -> f64 {
        match *condition {
            Condition::Alike(f, g, alike) => {
                let ((c, _, r), (d, m, s)) = (carried(f, theta), carried(g, theta));
                let side = if alike { 1.0 } else { -1.0 };
                match (r, s) {
                    (Some(r), Some(s)) => {
                        let sum = r - side * s;
                        ((c - d).length_squared() - sum * sum) / (2.0 * r * s * side)
                    }
                    (Some(r), None) => (m.dot(c - d) * side + r) / r,
                    (None, _) => {
                        // The same with the roles exchanged.
                        let n = carried(f, theta).1;
                        let s = s.unwrap();
                        ((n * side).dot(d - c) + s) / s
                    }
                }
            }
            Condition::Circle(f, g, outer) => {
                let ((c, n, r), (d, _, s)) = (carried(f, theta), carried(g, theta));
                let s = s.unwrap() * if outer { 1.0 } else { -1.0 };
                match r {
                    Some(r) => ((c - d).length_squared() - (r + s) * (r + s)) / (-2.0 * r),
                    None => n.dot(c - d) + s,
                }
            }
        }
    }

    /// Pairs of sheets with large arcs, and orientations at which both exist.
    fn flat_pairs(geometry: &Geometry) -> Vec<(&Sheet, &Sheet, [f64; 3])> {
        let sheets = &geometry.contacts.sheets;
        let mut pairs = Vec::new();
        for (i, f) in sheets.iter().enumerate() {
            for g in &sheets[..i] {
                let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
                if lo < hi && (f.is_flat() || g.is_flat()) {
                    pairs.push((f, g, [0.2, 0.5, 0.9].map(|s| lo + s * (hi - lo))));
                }
            }
        }
        assert!(pairs.len() > 100, "{}", pairs.len());
        pairs
    }

    /// Contacts that are tangent at every orientation, as centres and radii tell, are found to be; and no others.
    #[test]
    fn what_always_touches_is_told() {
        // Two large arcs and a line that go on into each other smoothly.
        let (a, b) = (0.004_f64, 0.003_f64);
        let (mut at, mut heading) = (Point::new(-1.0, -1.0), 0.0);
        let mut outline = Vec::new();
        for half in [a, b, 0.0] {
            outline.push(Vertex::new(at.x, at.y, (0.5 * half).tan()));
            at += Vector::from_angle(heading + half) * 0.7;
            heading += 2.0 * half;
        }
        outline.extend([(at.x, at.y), (1.1, 1.0), (-0.4, 1.2)].map(|(x, y)| Vertex::line(x, y)));
        let fixed = Part::new("fixed", vec![outline]).unwrap();
        let moving = part("moving", 0.6, [6e-4, 0.0, -7e-4, -0.2]);
        let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
        let mut always = 0;
        for (f, g, [_, theta, _]) in flat_pairs(&geometry) {
            let touch = [true, false].into_iter().any(|side| {
                [-2.0, -0.7, 0.0, 0.9, 2.1].into_iter().all(|d| {
                    tangencies(f, g)
                        .nth(usize::from(side))
                        .is_some_and(|c| by_centers(&c, theta + d).abs() < 1e-9)
                })
            });
            always += usize::from(touch);
            assert_eq!(always_touch(f, g), touch, "{f:?} {g:?}");
            assert_eq!(always_touch(g, f), touch, "{f:?} {g:?}");
        }
        assert!(always > 10, "{always}");
    }

    fn flat_geometry() -> Geometry {
        let fixed = part("fixed", 1.0, [1e-3, 0.3, -8e-4, 0.0]);
        let moving = part("moving", 0.6, [6e-4, 0.0, -7e-4, -0.2]);
        Geometry::new(&fixed, &moving, None, usize::MAX)
    }

    /// Value and derivative of a condition.
    fn dual(condition: &Condition<'_>, theta: f64) -> Dual<1> {
        condition.at(Rotation::by(Dual::variable(theta, 0))).0
    }

    /// Values and slopes against distances of centres, which tell them to some digits.
    #[test]
    fn conditions_are_those_of_centres_and_radii() {
        let geometry = flat_geometry();
        for (f, g, orientations) in flat_pairs(&geometry) {
            for condition in tangencies(f, g) {
                for theta in orientations {
                    let h = 1e-3;
                    let at = |t: f64| by_centers(&condition, t);
                    let value = condition.at(Rotation::by(theta)).0;
                    let off = (value - at(theta)).abs();
                    assert!(off < 1e-9, "{off} {value} {f:?} {g:?}");
                    let slope = dual(&condition, theta).slope[0];
                    let expected = (at(theta + h) - at(theta - h)) / (2.0 * h);
                    let near = 1e-6 * (1.0 + condition.pace());
                    assert!((slope - expected).abs() < near, "{slope} {expected}");
                }
            }
        }
    }

    /// What is said to be the error of a value is about its rounding, as an enclosure tells it.
    #[test]
    fn errors_of_values_are_those_of_rounding() {
        let geometry = flat_geometry();
        for (f, g, orientations) in flat_pairs(&geometry) {
            for condition in tangencies(f, g) {
                for theta in orientations {
                    let (enclosed, size) = condition.at(Rotation::by(Ball::new(theta, 0.0)));
                    let said = MARGIN * LENGTH_ERROR * size * condition.pace();
                    let bounds = enclosed.radius / said;
                    assert!((1e-5..10.0).contains(&bounds), "{bounds}");
                }
            }
        }
    }

    /// Two lines through one point that are all but parallel: the little by which they are not has all its digits.
    #[test]
    fn what_is_all_but_tangent_is_known_to_its_own_digits() {
        let geometry = flat_geometry();
        let (f, ..) = (flat_pairs(&geometry).into_iter())
            .find(|(f, ..)| f.is_flat_arc() && f.locus.through.swing.is_none())
            .unwrap();
        for angle in [1e-3_f64, 1e-6, -1e-6] {
            let mut g = *f;
            g.locus.normal = Rotation::by(angle) * f.locus.normal;
            // Flat arcs of one curvature through one point: the squares of half the angle and no more.
            let condition = Condition::Alike(f, &g, true);
            let expected = 2.0 * (0.5 * angle).sin().powi(2);
            for value in [
                condition.at(Rotation::IDENTITY).0,
                dual(&condition, 0.0).value,
            ] {
                assert!((value / expected - 1.0).abs() < 1e-9, "{value} {expected}");
            }
        }
    }

    /// A line that stands still, with its normal upwards.
    fn upright() -> Sheet {
        let geometry = flat_geometry();
        let of = |s: &&Sheet| s.locus.kind == SheetKind::LineRound && !s.is_flat();
        let mut line = *geometry.contacts.sheets.iter().find(of).unwrap();
        line.locus.normal = Vector::new(0.0, 1.0);
        line
    }

    /// A circle that stands still.
    fn round(center: Point, radius: f64) -> Sheet {
        let geometry = flat_geometry();
        let mut round = *(geometry.contacts.sheets.iter())
            .find(|s| s.is_circle())
            .unwrap();
        (round.locus.through, round.locus.radius) = (Spiral::new(center, Vector::ZERO), radius);
        round
    }

    /// A line, and a circle about a point that goes around a circle: tangent at two orientations and no more.
    #[test]
    fn touching_at_two_orientations_is_not_touching_always() {
        let mut line = upright();
        let mut circle = round(Point::ORIGIN, 0.3);
        circle.locus.through.w = Vector::new(1.0, 0.0);
        // At these and half a turn less them.
        for at in [0.0, FRAC_PI_2 - 0.05, FRAC_PI_2 + 0.05] {
            line.locus.through = Spiral::new(Point::new(0.0, at.sin() + 0.3), Vector::ZERO);
            let holds = |d: f64| {
                let value = |c: Condition<'_>| dual(&c, at + d).value;
                tangencies(&line, &circle).any(|c| value(c).abs() < 1e-14)
            };
            assert!(holds(0.0) && holds(PI - 2.0 * at) && !holds(0.3));
            let mut during = circle;
            (during.lo, during.hi, line.lo, line.hi) = (at - 0.2, at + 0.2, at - 0.2, at + 0.2);
            assert!(!always_touch(&line, &during), "{at}");
            assert!(!always_touch(&during, &line), "{at}");
        }
    }
}
