//! Contacts whose carriers coincide or are tangent at every orientation.

use crate::feature::tolerance::{SAME_CARRIER, TANGENCY_STEP};
use crate::geometry::{Rotation, Vector};

use super::cycle::Cycle;
use super::sheet::Sheet;

impl Sheet {
    /// Whether two sheets have one circle or tangent ones as carriers at every orientation, by construction: arcs on one circle, halves of
    /// one disc against a side and the corner it ends at, or contacts of one feature with two others that follow each other smoothly. Their
    /// curves do not cross, whatever the rounding. Circles that coincide in the drawing alone, as arcs with equal sums of radii about the
    /// same centres, are moved apart (`feature/perturbation.rs`), and cross.
    ///
    /// The function that vanishes where two cycles are tangent ([`Cycle::apart`]) is α cos θ + β sin θ + γ: if it is 0 at three
    /// orientations far from each other, it is 0 everywhere. Two lines are not tangent.
    pub(super) fn always_tangent(&self, other: &Self) -> bool {
        if self.is_line() && other.is_line() {
            return false;
        }
        // The larger the circle, or the farther the centre about which a point turns, the larger its rounding.
        let size = |s: &Self| match s.is_flat() {
            true => s.locus.carrier.through.turning().length(),
            false => s.locus.carrier.radius.abs(),
        };
        let near = SAME_CARRIER * (size(self) + size(other)).max(1.0);
        let tangent = |f: &Cycle, g: &Cycle| {
            let sum = f.total(g).abs() + f.between(g).length();
            2.0 * f.apart(g).abs() <= near * sum
        };
        let mut sides = [true; 2];
        for turn in self.three_turns(other) {
            let (f, g) = (self.cycle(turn), other.cycle(turn));
            sides = [
                sides[0] && tangent(&f, &g),
                sides[1] && tangent(&f, &g.reversed()),
            ];
            if sides == [false; 2] {
                return self.same_flat_arc(other);
            }
        }
        true
    }

    /// Three orientations far from each other; for flat arcs among those at which both exist.
    fn three_turns(&self, other: &Self) -> [Rotation; 3] {
        if self.is_flat() || other.is_flat() {
            let mid = 0.5 * (self.lo.max(other.lo) + self.hi.min(other.hi));
            return [0.0, -TANGENCY_STEP, TANGENCY_STEP].map(|d| Rotation::by(mid + d));
        }
        let third = |sin| Rotation { cos: -0.5, sin };
        let sin = 0.5 * 3_f64.sqrt();
        [Rotation::IDENTITY, third(sin), third(-sin)]
    }

    /// Whether two flat arcs are one circle at every orientation at which both exist: three places are on both at the first, the middle and
    /// the last.
    fn same_flat_arc(&self, other: &Self) -> bool {
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
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
pub(super) mod tests {
    use super::super::carrier::SheetKind;
    use super::super::pair::Geometry;
    use super::super::sheet::tests::{round, straight};
    use super::super::spiral::Spiral;
    use core::f64::consts::TAU;

    use super::*;
    use crate::geometry::Point;
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

    /// The contact written with circles about their centres, and ends as two vectors: correct as long as the radii are no larger than here.
    pub(in crate::contact) fn plain(sheet: &Sheet) -> Sheet {
        let spiral = |s: &Spiral| Spiral::new(s.u + s.swing.arm, s.turning());
        let mut plain = *sheet;
        let locus = &mut plain.locus;
        (locus.start, locus.end) = (spiral(&locus.start), spiral(&locus.end));
        locus.carrier.through = spiral(&locus.carrier.through);
        if let Some(center) = locus.carrier.center() {
            (locus.carrier.kind, locus.carrier.through) = (SheetKind::RoundRound, center);
        }
        plain
    }

    /// Two functions, by centres and radii, one of which vanishes at an orientation where the carriers are tangent: on one side, or on the
    /// other.
    fn off(f: &Sheet, g: &Sheet, theta: f64) -> Option<[f64; 2]> {
        let [c, d] = [f, g].map(|s| plain(s).cycle(Rotation::by(theta)));
        let (line, circle): (Cycle, Cycle) = match (c.is_line(), d.is_line()) {
            (true, true) => return None,
            (true, false) => (c, d),
            (false, true) => (d, c),
            (false, false) => {
                let apart = c.through.distance(d.through);
                return Some([apart - (c.size + d.size), apart - (c.size - d.size).abs()]);
            }
        };
        let height = line.normal.dot(circle.through - line.through);
        Some([height - circle.size, height + circle.size])
    }

    /// Contacts that are tangent at every orientation, according to centres and radii, are detected; and no others.
    #[test]
    fn what_always_touches_is_told() {
        // Two large arcs and a line that follow each other smoothly.
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
        let sheets = &geometry.contacts.sheets;
        let (mut always, mut flat) = (0, 0);
        let pairs = (sheets.iter()).flat_map(|f| sheets.iter().map(move |g| (f, g)));
        for (f, g) in pairs.filter(|(f, g)| f.lo.max(g.lo) < f.hi.min(g.hi)) {
            let mid = 0.5 * (f.lo.max(g.lo) + f.hi.min(g.hi));
            let tangent = [0, 1].into_iter().any(|side: usize| {
                [-2.0, -0.7, 0.0, 0.9, 2.1]
                    .into_iter()
                    .all(|d| off(f, g, mid + d).is_some_and(|off| off[side].abs() < 1e-9))
            });
            if tangent && f != g {
                always += 1;
                flat += usize::from(f.is_flat() || g.is_flat());
            }
            assert_eq!(f.always_tangent(g), tangent, "{f:?} {g:?}");
        }
        assert!(always > 100 && flat > 10, "{always} {flat}");
    }

    /// A line, and a circle about a point that moves on a circle: tangent at two orientations only.
    #[test]
    fn touching_at_two_orientations_is_not_touching_always() {
        for at in [0.0, 1.52, 1.62, 0.5 * TAU / 3.0] {
            let through = Spiral::new(Point::new(0.0, f64::sin(at) + 0.3), Vector::ZERO);
            let line = straight(0, SheetKind::LineRound, 0.25 * TAU, through);
            let circle = round(1, (0.0, 0.0), (1.0, 0.0), 0.3);
            let holds = |theta| {
                off(&line, &circle, theta)
                    .unwrap()
                    .iter()
                    .any(|x| x.abs() < 1e-14)
            };
            assert!(holds(at) && holds(0.5 * TAU - at) && !holds(at + 0.3));
            for mid in [at, 0.25 * TAU] {
                let (mut during, mut line) = (circle, line);
                (during.lo, during.hi, line.lo, line.hi) =
                    (mid - 0.2, mid + 0.2, mid - 0.2, mid + 0.2);
                assert!(!line.always_tangent(&during), "{at}");
                assert!(!during.always_tangent(&line), "{at}");
            }
        }
    }
}
