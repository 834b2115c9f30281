//! The orientations at which the crossings of two contact curves can come and go, where a large arc is involved.
//!
//! The conditions are those of `condition.rs`. Each is α cos θ + β sin θ + γ = 0, but with such an arc the three are large
//! and all but cancel. So they are not written down. The condition is evaluated at an orientation, with two derivatives,
//! from points near the parts; these three numbers are the function, about that orientation:
//! h + h′ sin δ + h″ (1 − cos δ). Its roots are a quadratic's by tan(δ/2); and found again from where they are.

use core::f64::consts::TAU;

use crate::number::plane::{dot, minus};
use crate::number::{ANGLE_ERROR, Event, LARGEST_ERROR, Real, Series};

use super::bow::Level;
use super::carrier::Carrier;
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
                    Carrier::Circle { radius, .. } => 2.0 * radius.rough().abs(),
                    _ => 1.0,
                };
                (Level::of(&carrier, spiral.place(cos, sin)).c, size)
            }
            Self::Alike(f, g, alike) => {
                // |c − d|² = (r ∓ s)² for the centres c = X − r n and d = Y − s m, over ±2 r s.
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
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::super::condition::conditions;
    use super::super::pair::Geometry;
    use super::super::sheet::SheetKind;
    use super::*;
    use crate::geometry::{Point, Rotation, Vector};
    use crate::number::Ball;
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
            (plain.fixed_point, plain.moving_point) = (u, Point::ORIGIN + -w);
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
                conditions(&plain(f), &plain(g), &shared, |t, _| {
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

    /// The centre of what a sheet is about its centre, and its signed radius; of a line a point, the normal, and no radius.
    fn carried(sheet: &Sheet, theta: f64) -> (Point, Vector, Option<f64>) {
        match plain(sheet).carrier(theta.cos(), theta.sin()) {
            Carrier::Circle { center, radius } => {
                (Point::new(center.0, center.1), Vector::ZERO, Some(radius))
            }
            Carrier::Line { normal, through } => (
                Point::new(through.0, through.1),
                Vector::new(normal.0, normal.1),
                None,
            ),
            Carrier::Bow(_) => unreachable!("a circle about its centre"),
        }
    }

    /// All conditions of two sheets.
    fn all_of<'a>(f: &'a Sheet, g: &'a Sheet) -> Vec<Condition<'a>> {
        let ends = [(&f.start, g), (&f.end, g), (&g.start, f), (&g.end, f)];
        (ends.into_iter().map(|(s, of)| Condition::End(s, of)))
            .chain(tangencies(f, g))
            .collect()
    }

    /// What a condition is by centres and radii, as far as these tell it.
    fn by_centers(condition: &Condition<'_>, theta: f64) -> f64 {
        match *condition {
            Condition::End(spiral, sheet) => {
                let p = Spiral::new(spiral.u + spiral.swing.arm, spiral.turning())
                    .at(Rotation::by(theta));
                let (c, n, radius) = carried(sheet, theta);
                match radius {
                    None => n.dot(p - c),
                    // Of one that is no bow it is multiplied with the radius.
                    Some(r) if sheet.is_circle() => {
                        0.5 * ((p - c).length_squared() - r * r) * r.signum()
                    }
                    Some(r) => 0.5 * ((p - c).length_squared() - r * r) / r,
                }
            }
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

    fn flat_geometry() -> Geometry {
        let fixed = part("fixed", 1.0, [1e-3, 0.3, -8e-4, 0.0]);
        let moving = part("moving", 0.6, [6e-4, 0.0, -7e-4, -0.2]);
        Geometry::new(&fixed, &moving, None, usize::MAX)
    }

    /// Values and slopes against distances of centres, which tell them to some digits.
    #[test]
    fn conditions_are_those_of_centres_and_radii() {
        let geometry = flat_geometry();
        for (f, g, orientations) in flat_pairs(&geometry) {
            for condition in all_of(f, g) {
                for theta in orientations {
                    let h = 1e-3;
                    let at = |t: f64| by_centers(&condition, t);
                    let (cos, sin) = (theta.cos(), theta.sin());
                    let value = condition.at(cos, sin).0;
                    let off = (value - at(theta)).abs();
                    assert!(off < 1e-9, "{off} {value} {f:?} {g:?}");
                    let slope = condition.series(theta).0.slope;
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
            for condition in all_of(f, g) {
                for theta in orientations {
                    let (cos, sin) = Ball::new(theta, 0.0).cos_sin();
                    let (enclosed, size) = condition.at(cos, sin);
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
            .find(|(f, ..)| f.is_bow() && f.swing.is_none())
            .unwrap();
        for angle in [1e-3_f64, 1e-6, -1e-6] {
            let mut g = *f;
            g.normal = Rotation::by(angle) * f.normal;
            // Bows of one curvature through one point: the squares of half the angle and no more.
            let condition = Condition::Alike(f, &g, true);
            let expected = 2.0 * (0.5 * angle).sin().powi(2);
            for value in [condition.at(1.0, 0.0).0, condition.series(0.0).0.value] {
                assert!((value / expected - 1.0).abs() < 1e-9, "{value} {expected}");
            }
        }
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
            // Nothing happens where a condition always holds, however fast what it is made of moves.
            for c in tangencies(f, g) {
                let still = |d: f64| by_centers(&c, theta + d).abs() < 1e-9;
                if [-2.0, -0.7, 0.0, 0.9, 2.1].into_iter().all(still) {
                    c.roots(theta, PI, &mut |e| panic!("{e:?} {f:?} {g:?}"));
                }
            }
            assert_eq!(always_touch(f, g), touch, "{f:?} {g:?}");
            assert_eq!(always_touch(g, f), touch, "{f:?} {g:?}");
        }
        assert!(always > 10, "{always}");
    }

    /// The height of a point that goes around a circle over a fixed line: size sin θ − h.
    fn height(size: f64, h: f64) -> (Spiral, Sheet) {
        let geometry = flat_geometry();
        let of = |s: &&Sheet| s.kind == SheetKind::LineRound && !s.is_flat();
        let mut line = *geometry.contacts.sheets.iter().find(of).unwrap();
        line.normal = Vector::new(0.0, 1.0);
        line.start = Spiral::new(Point::new(0.0, h), Vector::ZERO);
        (Spiral::new(Point::ORIGIN, Vector::new(size, 0.0)), line)
    }

    fn roots_of(h: f64, mid: f64, half: f64) -> Vec<Event> {
        let (point, line) = height(1.0, h);
        let mut events = Vec::new();
        Condition::End(&point, &line).roots(mid, half, &mut |e| events.push(e));
        events.sort_by(|a, b| a.theta.total_cmp(&b.theta));
        events
    }

    /// A circle that stands still.
    fn round(center: Point, radius: f64) -> Sheet {
        let geometry = flat_geometry();
        let mut round = *(geometry.contacts.sheets.iter())
            .find(|s| s.is_circle())
            .unwrap();
        (round.fixed_point, round.moving_point, round.radius) = (center, Point::ORIGIN, radius);
        round
    }

    /// A line, and a circle about a point that goes around a circle: tangent at two orientations and no more.
    #[test]
    fn touching_at_two_orientations_is_not_touching_always() {
        let (_, mut line) = height(1.0, 0.0);
        let mut circle = round(Point::ORIGIN, 0.3);
        circle.moving_point = Point::new(-1.0, 0.0);
        // At these and half a turn less them.
        for at in [0.0, FRAC_PI_2 - 0.05, FRAC_PI_2 + 0.05] {
            line.start = Spiral::new(Point::new(0.0, at.sin() + 0.3), Vector::ZERO);
            let holds = |d: f64| {
                let value = |c: Condition<'_>| c.series(at + d).0.value;
                tangencies(&line, &circle).any(|c| value(c).abs() < 1e-14)
            };
            assert!(holds(0.0) && holds(PI - 2.0 * at) && !holds(0.3));
            let mut during = circle;
            (during.lo, during.hi, line.lo, line.hi) = (at - 0.2, at + 0.2, at - 0.2, at + 0.2);
            assert!(!always_touch(&line, &during), "{at}");
            assert!(!always_touch(&during, &line), "{at}");
        }
    }

    /// From anywhere on the circle, and to the error that is told; beside a tangency that is the square root of the rounding.
    #[test]
    fn roots_are_where_they_are_told_to_be() {
        let rounding = LENGTH_ERROR;
        // 1 − h, and the least and the largest error to be expected.
        for (less, least, largest) in [
            (0.7, 0.0, 10.0 * rounding),
            (1.9, 0.0, 30.0 * rounding),
            (1e-4, 50.0 * rounding, 1e3 * rounding),
            (1e-10, 5e-11, 5e-9),
            (1e-12, 5e-10, 5e-8),
            (4e-15, 5e-8, 1e-6),
        ] {
            let h: f64 = 1.0 - less;
            let apart = (h.recip() * (less * (2.0 - less)).sqrt()).atan();
            let apart = if h < 0.0 { PI + apart } else { apart };
            for mid in [FRAC_PI_2 + 0.3, FRAC_PI_2 - 3.0, FRAC_PI_2 + 7.0] {
                let middle = FRAC_PI_2 + TAU * ((mid - FRAC_PI_2) / TAU).round();
                let events = roots_of(h, mid, PI);
                let mut expected =
                    [middle - apart, middle + apart].map(|t| t - TAU * ((t - mid) / TAU).round());
                expected.sort_by(f64::total_cmp);
                assert_eq!(events.len(), 2, "{less} {mid} {events:?}");
                for (e, t) in events.iter().zip(expected) {
                    let near = 4.0 * f64::EPSILON * t.abs().max(1.0);
                    assert!((e.theta - t).abs() <= e.error + near, "{less} {e:?} {t}");
                    assert!(
                        e.error >= least && e.error <= largest + near * 8.0,
                        "{less} {e:?}"
                    );
                }
                // Those of an interval, and no others.
                for t in expected {
                    let found = |half: f64| {
                        roots_of(h, t + 0.1, half)
                            .iter()
                            .any(|e| (e.theta - t).abs() < 1e-5)
                    };
                    assert!(found(0.1 + 1e-5) && !found(0.1 - 1e-5), "{less}");
                }
            }
        }
        // What stays clear of the line has none, unless by less than rounding.
        for (h, count) in [
            (1.0 + 1e-12, 0),
            (-1.0 - 1e-9, 0),
            (1.5, 0),
            (1.0 + 4.0 * f64::EPSILON, 2),
        ] {
            assert_eq!(roots_of(h, 1.3, PI).len(), count, "{h}");
        }
        // Where nothing moves nothing happens.
        let (_, line) = height(1.0, 0.0);
        for y in [0.0, 1e-16, 0.3] {
            let point = Spiral::new(Point::new(0.4, y), Vector::ZERO);
            Condition::End(&point, &line).roots(0.3, PI, &mut |e| panic!("{e:?}"));
        }
    }

    /// A double root is known the better the more the function bends; a simple one to the rounding of its angle, however fast
    /// what it is made of moves.
    #[test]
    fn errors_of_roots_go_with_slope_and_bend() {
        let error = |size: f64, h: f64| {
            let (point, line) = height(size, h);
            let mut most = 0.0_f64;
            Condition::End(&point, &line).roots(1.0, PI, &mut |e| most = most.max(e.error));
            most
        };
        // √(2 off / bend), off being some 7e-15.
        for (size, least, largest) in [(0.1, 1.5e-7, 9e-7), (1.0, 5e-8, 3e-7), (10.0, 1.5e-8, 9e-8)]
        {
            let found = error(size, size);
            assert!((least..largest).contains(&found), "{size} {found}");
        }
        let found = error(1e4, 0.0);
        assert!((f64::EPSILON..1e-14).contains(&found), "{found}");
    }

    /// Places on a circle are known as those on a line, however large its radius.
    #[test]
    fn errors_of_roots_on_circles_are_those_on_lines() {
        for radius in [1.0, 5.0, 50.0] {
            // The point goes around the origin, through which the circle goes upright.
            let circle = round(Point::new(radius, 0.0), radius);
            let point = Spiral::new(Point::ORIGIN, Vector::new(1.0, 0.0));
            let mut events = Vec::new();
            let condition = Condition::End(&point, &circle);
            condition.roots(1.0, PI, &mut |e| events.push(e));
            assert_eq!(events.len(), 2);
            for e in events {
                let off = (e.theta.cos() - 0.5 / radius).abs();
                assert!(off <= e.error, "{radius} {off} {e:?}");
                assert!((1.0..20.0).contains(&(e.error / LENGTH_ERROR)), "{e:?}");
            }
        }
    }

    /// A root that may be in the interval is one of it.
    #[test]
    fn intervals_are_as_wide_as_errors() {
        let h = 1.0 - 1e-12;
        // The other of the two is on the other side.
        for (root, way) in roots_of(h, 1.0, PI).into_iter().zip([-0.1, 0.1]) {
            let mid = root.theta + way;
            let found = |beyond: f64| !roots_of(h, mid, 0.1 - beyond * root.error).is_empty();
            assert!(found(0.5) && found(-0.5) && !found(1.5));
        }
    }

    /// A function is said to touch zero where both its value and its slope vanish and its bend does not.
    #[test]
    fn touches_are_double_roots() {
        let touches = |h: f64, theta: f64| {
            let (point, line) = height(1.0, h);
            Condition::End(&point, &line).touches(theta)
        };
        assert!(touches(1.0, FRAC_PI_2) && touches(-1.0, -FRAC_PI_2));
        assert!(touches(1.0 + 1e-15, FRAC_PI_2 + 1e-15));
        for (h, theta) in [
            (1.0, FRAC_PI_2 + 1e-11),
            (1.0 + 1e-11, FRAC_PI_2),
            (1.0 - 1e-11, FRAC_PI_2),
            (0.0, 0.0),
            (0.3, FRAC_PI_2),
        ] {
            assert!(!touches(h, theta), "{h} {theta}");
        }
        // What moves fast turns fast, and what is told with the radius is known to as much less.
        let (point, line) = height(1e3, 1e3);
        assert!(Condition::End(&point, &line).touches(FRAC_PI_2));
        let (point, line) = height(1.0, 0.0);
        for (off, expected) in [(2e-14, true), (1e-12, false)] {
            let above = round(Point::new(0.0, 51.0 + off), 50.0);
            assert_eq!(Condition::End(&point, &above).touches(FRAC_PI_2), expected);
        }
        let still = Spiral::new(Point::new(0.4, 0.0), Vector::ZERO);
        assert!(!Condition::End(&still, &line).touches(0.3));
    }

    /// With h, h′ and h″ of a sine about any orientation the ways to its two zeros.
    #[test]
    fn offsets_lead_to_both_zeros() {
        for (middle, apart) in [(0.3_f64, 0.8_f64), (-2.0, 0.1), (1.0, 2.9), (0.0, 1.5)] {
            for theta in [0.0_f64, 0.7, -1.1, 3.0] {
                for factor in [1.0, -3.0] {
                    let s = Series {
                        value: factor * ((theta - middle).cos() - apart.cos()),
                        slope: -factor * (theta - middle).sin(),
                        bend: -factor * (theta - middle).cos(),
                    };
                    let found = offsets(&s).unwrap();
                    for expected in [middle - apart, middle + apart] {
                        let off = |o: f64| {
                            let d = theta + o - expected;
                            (d - TAU * (d / TAU).round()).abs()
                        };
                        assert!(found.iter().any(|&o| off(o) < 1e-14), "{found:?}");
                    }
                    assert!(found.iter().all(|o| o.abs() <= PI));
                }
            }
        }
        // From one of the two zeros: there is no way to it, and one to the other.
        let from_zero = Series {
            value: 0.0,
            slope: 0.6,
            bend: -0.8,
        };
        let found = offsets(&from_zero).unwrap();
        for expected in [0.0, 2.0 * f64::atan(0.75)] {
            assert!(
                found.iter().any(|o| (o - expected).abs() < 1e-15),
                "{found:?}"
            );
        }
        let constant = |value| Series {
            value,
            slope: 0.0,
            bend: 0.0,
        };
        assert_eq!(offsets(&constant(0.0)), None);
        assert_eq!(offsets(&constant(f64::NAN)), None);
    }
}
