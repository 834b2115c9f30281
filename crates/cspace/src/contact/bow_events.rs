//! The orientations at which the crossings of two contact curves can come and go, where a large arc is involved.
//!
//! The conditions are those of `condition.rs`. Each is α cos θ + β sin θ + γ = 0, but with such an arc the three are large
//! and all but cancel. So they are not written down. The condition is evaluated at an orientation, with two derivatives,
//! from points near the parts; these three numbers are the function, about that orientation:
//! h + h′ sin δ + h″ (1 − cos δ). Its roots are a quadratic's by tan(δ/2); and found again from where they are.

use core::f64::consts::TAU;

use crate::number::{ANGLE_ERROR, Event, LARGEST_ERROR, Real, Series};

use super::bow::Level;
use super::carrier::{Carrier, dot, minus};
use super::sheet::{SharedEnds, Sheet};
use super::spiral::Spiral;
use super::ties::{ALIGNMENT_ERROR, Ties};

/// What vanishes.
#[derive(Clone, Copy)]
enum Condition<'a> {
    /// An end on a carrier.
    End(&'a Spiral, &'a Sheet),
    /// A line or bow tangent to a bow, their normals alike or opposed.
    Alike(&'a Sheet, &'a Sheet, bool),
    /// A bow, or a line that large arcs move, tangent to a circle, on one of its two sides.
    Circle(&'a Sheet, &'a Sheet, bool),
}

/// Error of a length computed from coordinates near the parts.
const LENGTH_ERROR: f64 = 32.0 * f64::EPSILON;

/// Errors are estimates.
const MARGIN: f64 = 4.0;

/// Calls `found` with every event of the pair between two orientations.
pub(crate) fn bow_events(
    f: &Sheet,
    g: &Sheet,
    shared: &SharedEnds,
    ties: &Ties,
    (lo, hi): (f64, f64),
    mut found: impl FnMut(Event),
) {
    let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let [f_end_shared, f_start_shared] = shared.corners.map(|c| c.is_some());
    let mut all: Vec<Condition<'_>> = Vec::with_capacity(6);
    if !f_start_shared {
        all.extend([Condition::End(&f.start, g), Condition::End(&g.end, f)]);
    }
    if !f_end_shared {
        all.extend([Condition::End(&f.end, g), Condition::End(&g.start, f)]);
    }
    all.extend(tangencies(f, g));
    for condition in all {
        if let Some(theta) = ties.about(mid).find(|&t| condition.touches(t)) {
            let tie = Event {
                theta,
                error: ALIGNMENT_ERROR,
            };
            tie.within(mid, half).into_iter().for_each(&mut found);
        } else {
            condition.roots(mid, half, &mut found);
        }
    }
}

/// What vanishes where two curves are tangent, of which one is told by a point or moves with a large arc.
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

/// Whether two curves, of which one is told by a point or moves with a large arc, are tangent at every orientation: contacts of
/// one feature with two others that follow each other smoothly.
///
/// The condition is α cos θ + β sin θ + γ = 0: if it is so at three orientations far from each other, it is so at all.
pub(crate) fn always_touch(f: &Sheet, g: &Sheet) -> bool {
    let mid = 0.5 * (f.lo.max(g.lo) + f.hi.min(g.hi));
    /// As far as bows may be followed, radians.
    const APART: f64 = 0.1;
    tangencies(f, g).any(|condition| {
        [-APART, 0.0, APART].into_iter().all(|d| {
            let (sin, cos) = (mid + d).sin_cos();
            let (value, size) = condition.at(cos, sin);
            value.abs() <= MARGIN * LENGTH_ERROR * size * condition.pace()
        })
    })
}

impl Condition<'_> {
    /// Its value, and the error of a value in units of [`LENGTH_ERROR`].
    fn at<T: Real>(&self, cos: T, sin: T) -> (T, f64) {
        let real = T::constant;
        match *self {
            Self::End(spiral, sheet) => {
                let carrier = sheet.carrier(cos, sin);
                // Of a circle times its radius.
                let size = match carrier {
                    Carrier::Circle { radius, .. } => 2.0 * radius.abs(),
                    _ => 1.0,
                };
                (Level::of(&carrier, spiral.place(cos, sin)).c, size)
            }
            Self::Alike(f, g, alike) => {
                // |c − d|² = (r ∓ s)² for the centres c = X − r n and d = Y − s m, over −2 r s.
                let ((x, n, k), (y, m, l)) = (straight(f, cos, sin), straight(g, cos, sin));
                let (v, side) = (minus(x, y), if alike { 1.0 } else { -1.0 });
                let m = (m.0 * real(side), m.1 * real(side));
                let l = l * side;
                let (cross, along) = (n.0 * m.1 - n.1 * m.0, dot(n, m));
                let less = if along.rough() > 0.0 {
                    (cross * cross).over(real(1.0) + along)
                } else {
                    real(1.0) - along
                };
                let value = dot(v, v) * real(0.5 * k * l) - dot(v, n) * real(l)
                    + dot(v, m) * real(k)
                    + less;
                (value, 8.0 * (k.abs() + l.abs()))
            }
            Self::Circle(f, g, outer) => {
                // |c − d|² = (r ± s)² for the centre c = X − r n and a circle about d, over −2 r.
                let (x, n, k) = straight(f, cos, sin);
                let d = g.center().place(cos, sin);
                let r = real(if outer { g.radius } else { -g.radius });
                let v = minus(x, d);
                let value = dot(v, n) + r - (dot(v, v) - r * r) * real(0.5 * k);
                (value, 1.0)
            }
        }
    }

    /// How fast what it is made of moves, per radian, if that is more than the size of the parts.
    fn pace(&self) -> f64 {
        let of = |s: &Spiral| s.turning().length();
        let both = match *self {
            Self::End(spiral, sheet) => [of(spiral), of(&sheet.any())],
            Self::Alike(f, g, _) | Self::Circle(f, g, _) => [of(&f.any()), of(&g.any())],
        };
        1.0 + both[0] + both[1]
    }

    fn series(&self, theta: f64) -> (Series, f64) {
        let (cos, sin) = Series::cos_sin(theta);
        self.at(cos, sin)
    }

    /// Whether it touches zero at an orientation, as far as rounding can tell, and is not constant.
    fn touches(&self, theta: f64) -> bool {
        let (here, size) = self.series(theta);
        let error = MARGIN * LENGTH_ERROR * size;
        let turned = error * self.pace();
        here.value.abs() <= error && here.slope.abs() <= turned && here.bend.abs() > turned
    }

    /// Finds the roots in the interval (mid − half, mid + half).
    fn roots(&self, mid: f64, half: f64, found: &mut impl FnMut(Event)) {
        /// Each step squares what is wrong.
        const STEPS: usize = 4;
        let Some(first) = offsets(&self.series(mid).0) else {
            return;
        };
        let pace = self.pace();
        for offset in first {
            let mut theta = mid + offset;
            theta -= TAU * ((theta - mid) / TAU).round();
            for _ in 0..STEPS {
                let Some([a, b]) = offsets(&self.series(theta).0) else {
                    break;
                };
                let step = if a.abs() < b.abs() { a } else { b };
                theta += step;
                if step.abs() < f64::EPSILON {
                    break;
                }
            }
            let (here, size) = self.series(theta);
            let value_error = LENGTH_ERROR * size;
            let turned = ANGLE_ERROR * here.slope.abs();
            // Where the roots are two or none, the function is least there. And it may be constant: where an end is always on
            // the other carrier, the derivatives are the rounding of what moves it.
            let none = here.value.abs() > MARGIN * (value_error + turned);
            if none || here.slope.abs() + here.bend.abs() <= MARGIN * value_error * pace {
                continue;
            }
            let off = here.value.abs() + value_error;
            let (slope, bend) = (here.slope.abs(), here.bend.abs());
            let error = if slope * slope > 4.0 * off * bend {
                2.0 * off / slope
            } else {
                (slope + (slope * slope + 2.0 * off * bend).sqrt()) / bend
            };
            let error = (error + ANGLE_ERROR).min(LARGEST_ERROR);
            if (theta - mid).abs() <= half + error {
                found(Event { theta, error });
            }
        }
    }
}

/// A line or bow: a point of it, the normal there and the curvature.
fn straight<T: Real>(sheet: &Sheet, cos: T, sin: T) -> ((T, T), (T, T), f64) {
    match sheet.carrier(cos, sin) {
        Carrier::Line { normal, through } => (through, normal, 0.0),
        Carrier::Bow(bow) => (bow.through, bow.normal, bow.curvature),
        Carrier::Circle { center, .. } => (center, center, f64::NAN),
    }
}

/// Where h + h′ sin δ + h″ (1 − cos δ) vanishes: with t = tan(δ/2), (h + 2 h″) t² + 2 h′ t + h = 0. Where it just does not, the
/// place where it is least, twice.
fn offsets(s: &Series) -> Option<[f64; 2]> {
    let square = s.value + 2.0 * s.bend;
    let root = (s.slope * s.slope - s.value * square).max(0.0).sqrt();
    let sum = -(s.slope + root.copysign(s.slope));
    let both = [s.value.atan2(sum), sum.atan2(square)].map(|half| {
        let turn = 2.0 * half;
        turn - TAU * (turn / TAU).round()
    });
    (both[0].is_finite() && both[1].is_finite() && (sum != 0.0 || s.value != 0.0)).then_some(both)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::condition::conditions;
    use super::super::pair::Geometry;
    use super::super::sheet::SheetKind;
    use super::*;
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
    fn plain(sheet: &Sheet) -> Sheet {
        let spiral = |s: &Spiral| Spiral::new(s.u + s.swing.arm, s.turning());
        let mut plain = *sheet;
        (plain.start, plain.end) = (spiral(&sheet.start), spiral(&sheet.end));
        let near = spiral(&sheet.any());
        if sheet.is_bow() {
            let inward = -(sheet.normal * sheet.radius);
            let (mut u, mut w) = (near.u, near.w);
            if sheet.kind == SheetKind::MovingBow {
                w = w + inward;
            } else {
                u += inward;
            }
            plain.kind = SheetKind::RoundRound;
            (plain.fixed_point, plain.moving_point) = (u, crate::Point::ORIGIN + -w);
        }
        plain
    }

    /// Up to a few hundred sizes of radius, the events are those of circles about their centres.
    #[test]
    fn events_are_those_of_circles() {
        let fixed = part("fixed", 1.0, [1e-3, 0.3, -8e-4, 0.0]);
        let moving = part("moving", 0.6, [6e-4, 0.0, -7e-4, -0.2]);
        let geometry = Geometry::new(&fixed, &moving, None, usize::MAX);
        let contacts = &geometry.contacts;
        let sheets = &contacts.sheets;
        let mut compared = 0;
        for (i, f) in sheets.iter().enumerate() {
            for g in &sheets[..i] {
                let (lo, hi) = (f.lo.max(g.lo), f.hi.min(g.hi));
                let shared = f.shared_ends(g, contacts.first_vertex_name);
                if lo >= hi || shared.tangent || !(f.is_flat() || g.is_flat()) {
                    continue;
                }
                let (mut ours, mut theirs) = (Vec::new(), Vec::new());
                let ties = Ties::new(&geometry.fixed, &geometry.moving, f, g);
                bow_events(f, g, &shared, &ties, (lo, hi), |e| ours.push(e));
                let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
                conditions(&plain(f), &plain(g), &shared, |t| {
                    let found = |e| theirs.push(e);
                    t.roots(mid, mid.cos(), mid.sin(), half, found);
                });
                // What is known well, and not at the very end, is found by both.
                for (of, among) in [(&ours, &theirs), (&theirs, &ours)] {
                    let known = of.iter().filter(|e: &&Event| e.error < 1e-10);
                    for e in known.filter(|e| (e.theta - mid).abs() < half - 1e-8) {
                        compared += 1;
                        let off = |o: &Event| (o.theta - e.theta).abs() - o.error;
                        assert!(among.iter().any(|o| off(o) < 1e-9), "{e:?} {f:?} {g:?}");
                    }
                }
            }
        }
        assert!(compared > 200, "{compared}");
    }
}
