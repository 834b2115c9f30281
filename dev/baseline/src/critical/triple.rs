//! Criticalities of three contacts at once.

use cspace::{Point, Rotation, Vector};

use super::bernstein::Polynomial;
use super::contact::{Contact, Wave};
use super::search::{Search, Work};
use super::span::{Interval, Span};
use super::tolerance::{BEYOND, PARALLEL};
use super::twofold::unit;

/// a x + b y + c = 0 with waves for coefficients.
type Line = [Wave; 3];

/// Three carriers as lines, and a circle if there is any: differences of circles are lines.
struct Combined {
    lines: Vec<Line>,
    circle: Option<Line>,
}

/// Every two contacts, with all that follow.
pub(super) fn search(search: &mut Search<'_>) -> Option<()> {
    let n = search.pair.contacts.len();
    for i in 0..n {
        search.each(n - i - 1, |work, k| third(work, i, i + 1 + k))?;
    }
    Some(())
}

fn third(work: &mut Work<'_>, i: usize, j: usize) {
    let pair = work.pair;
    let (f, g) = (&pair.contacts[i], &pair.contacts[j]);
    for both in f.span.common(&g.span).into_iter().flatten() {
        for h in &pair.contacts[j + 1..] {
            if work.stopped() {
                return;
            }
            for all in both.common(&h.span).into_iter().flatten() {
                meetings(work, [f, g, h], &all);
            }
        }
    }
}

fn meetings(work: &mut Work<'_>, contacts: [&Contact; 3], span: &Span) {
    let Some(combined) = Combined::new(contacts) else {
        return;
    };
    let basis = &work.pair.basis;
    span.intervals(|on| {
        let polynomial = combined.polynomial(on);
        basis.roots(&polynomial, |s| {
            let theta = on.theta(s);
            if work.is_candidate(theta) {
                for p in combined.places(theta).into_iter().flatten() {
                    if let Some((p, theta)) = refined(contacts, p, theta) {
                        work.examine(&contacts, p, theta);
                    }
                }
            }
        });
    });
}

impl Combined {
    /// `None` if two carriers are the same at all orientations.
    fn new(contacts: [&Contact; 3]) -> Option<Self> {
        let mut lines = Vec::with_capacity(3);
        let mut circle: Option<Line> = None;
        for c in contacts.map(|c| &c.carrier) {
            let own = [c.a, c.b, c.c];
            if !c.round {
                lines.push(own);
            } else if let Some(first) = &circle {
                lines.push(difference(&own, first)?);
            } else {
                circle = Some(own);
            }
        }
        Some(Self { lines, circle })
    }

    /// Zero where all three have a point in common: the determinant of three lines, or X² + Y² + a X D + b Y D + c D² for a
    /// circle and the crossing (X, Y) / D of two lines.
    fn polynomial(&self, on: &Interval) -> Polynomial {
        let over = |line: &Line| line.map(|w| w.over(on));
        let [a, b, c] = over(&self.lines[0]);
        let [d, e, f] = over(&self.lines[1]);
        let minor = |a: &Polynomial, b: &Polynomial, c: &Polynomial, d: &Polynomial| {
            a.times(d).plus(&b.times(c), -1.0)
        };
        let x = minor(&b, &c, &e, &f);
        let y = minor(&c, &a, &f, &d);
        let z = minor(&a, &b, &d, &e);
        if let (None, Some(third)) = (&self.circle, self.lines.get(2)) {
            let [g, h, i] = over(third);
            return (g.times(&x))
                .plus(&h.times(&y), 1.0)
                .plus(&i.times(&z), 1.0);
        }
        let Some(circle) = &self.circle else {
            return Polynomial::ONE;
        };
        let [g, h, i] = over(circle);
        let square = x.times(&x).plus(&y.times(&y), 1.0).times(&unit(on));
        let linear = g.times(&x).plus(&h.times(&y), 1.0).times(&z);
        square.plus(&linear, 1.0).plus(&i.times(&z).times(&z), 1.0)
    }

    /// Positions at which the carriers meet at a root: the crossing of the two lines that are least parallel, or, if
    /// all are parallel, the crossings of a line and the circle.
    fn places(&self, theta: f64) -> [Option<Point>; 2] {
        let turn = Rotation::by(theta);
        let lines: Vec<(Vector, f64)> = (self.lines.iter())
            .map(|l| {
                let normal = Vector::new(l[0].at(turn), l[1].at(turn));
                let length = normal.length();
                (normal * (1.0 / length), l[2].at(turn) / length)
            })
            .collect();
        let mut best = (PARALLEL, None);
        for (k, (n, c)) in lines.iter().enumerate() {
            for (m, d) in &lines[k + 1..] {
                let across = n.cross(*m);
                if across.abs() > best.0 {
                    let p = (n.right() * *d - m.right() * *c) * (1.0 / across);
                    best = (across.abs(), Some(Point::ORIGIN + p));
                }
            }
        }
        if best.1.is_some() {
            return [best.1, None];
        }
        let (Some(circle), Some((n, c))) = (&self.circle, lines.first()) else {
            return [None, None];
        };
        let value = |w: &Wave| w.at(turn);
        let center = Point::new(-0.5 * value(&circle[0]), -0.5 * value(&circle[1]));
        let radius = (center.to_vector().length_squared() - value(&circle[2])).max(0.0);
        let height = n.dot(center.to_vector()) + c;
        let half = (radius - height * height).max(0.0).sqrt();
        [half, -half].map(|h| Some(center + *n * -height + n.left() * h))
    }
}

/// The radical line of two circles, scaled to coefficients of order one.
fn difference(f: &Line, g: &Line) -> Option<Line> {
    /// Circles that differ by less are the same.
    const SAME_CIRCLE: f64 = 1e-11;
    let line = [0, 1, 2].map(|k| Wave([0, 1, 2].map(|i| f[k].0[i] - g[k].0[i])));
    let largest = (line.iter().flat_map(|w| w.0)).fold(0.0, |m: f64, c| m.max(c.abs()));
    (largest > SAME_CIRCLE).then(|| line.map(|w| Wave(w.0.map(|c| c / largest))))
}

/// A few of Newton's steps towards zero distance from all three; `None` where that does not lead there.
fn refined(contacts: [&Contact; 3], mut p: Point, mut theta: f64) -> Option<(Point, f64)> {
    const STEPS: usize = 4;
    /// Steps that are longer lead elsewhere.
    const LONGEST: f64 = 1e-3;
    /// Linear dependence of derivatives below which they determine no direction: the carriers are tangent or coincide.
    const DEPENDENT: f64 = 1e-9;
    let at = |p: Point, theta: f64| {
        let turn = Rotation::by(theta);
        contacts.map(|c| c.carrier.distance(p, turn))
    };
    for _ in 0..STEPS {
        let rows = at(p, theta);
        let [r0, r1, r2] = rows.map(|(_, n, by_theta)| [n.x, n.y, by_theta]);
        let values = rows.map(|r| r.0);
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [
                a[1] * b[2] - a[2] * b[1],
                a[2] * b[0] - a[0] * b[2],
                a[0] * b[1] - a[1] * b[0],
            ]
        };
        let columns = [cross(r1, r2), cross(r2, r0), cross(r0, r1)];
        let determinant: f64 = r0.iter().zip(columns[0]).map(|(a, b)| a * b).sum();
        if determinant.abs() < DEPENDENT {
            break;
        }
        let step = [0, 1, 2].map(|k| {
            let sum: f64 = (0..3).map(|i| columns[i][k] * values[i]).sum();
            -sum / determinant
        });
        let length = step.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        if length > LONGEST {
            break;
        }
        p = Point::new(p.x + step[0], p.y + step[1]);
        theta += step[2];
    }
    (at(p, theta).iter().all(|d| d.0.abs() <= BEYOND)).then_some((p, theta))
}
