//! Crossings of two lines or arcs.
//!
//! A line or circle is the zeros of n · q − κ q² / 2, with q the vector from the edge's start, n its left normal there
//! and κ its curvature, so that arcs of any radius are computed as well as lines.

use cspace::{Edge, Point, Vector};

/// The line or circle of an edge about an origin: c + m · p − κ p² / 2.
#[derive(Clone, Copy)]
struct Carrier {
    c: f64,
    m: Vector,
    curvature: f64,
}

impl Carrier {
    fn new(edge: &Edge, origin: Point) -> Self {
        let (n, s) = (edge.start_direction().left(), edge.start - origin);
        let curvature = if edge.is_line() {
            0.0
        } else {
            edge.curvature()
        };
        Self {
            c: -n.dot(s) - 0.5 * curvature * s.length_squared(),
            m: n + s * curvature,
            curvature,
        }
    }

    fn value(&self, p: Vector) -> f64 {
        self.c + self.m.dot(p) - 0.5 * self.curvature * p.length_squared()
    }

    fn gradient(&self, p: Vector) -> Vector {
        self.m - p * self.curvature
    }
}

/// The places at which the lines or circles of two edges cross, those on both edges within `near`.
pub(super) fn crossings(a: &Edge, b: &Edge, near: f64) -> impl Iterator<Item = Point> + use<> {
    let origin = a.start;
    let carriers = [a, b].map(|e| Carrier::new(e, origin));
    let (a, b) = (*a, *b);
    common(carriers)
        .into_iter()
        .flatten()
        .map(move |p| placed(origin + polished(carriers, p), &a, &b))
        .filter(move |&p| p.is_finite() && a.distance(p) <= near && b.distance(p) <= near)
}

/// The place of an edge's line or circle that is next to a place close by.
pub(super) fn onto(edge: &Edge, p: Point) -> Point {
    let carrier = Carrier::new(edge, p);
    let gradient = carrier.gradient(Vector::ZERO);
    // The second step would be of the square of the way to the carrier.
    p - gradient * (carrier.value(Vector::ZERO) / gradient.length_squared())
}

/// The common zeros of two carriers.
fn common([a, b]: [Carrier; 2]) -> [Option<Vector>; 2] {
    let largest = a.curvature.abs().max(b.curvature.abs());
    if largest == 0.0 {
        let det = a.m.cross(b.m);
        let p = Vector::new(a.m.y * b.c - b.m.y * a.c, b.m.x * a.c - a.m.x * b.c);
        return [(det != 0.0).then(|| p * (1.0 / det)), None];
    }
    // The line through what two circles have in common.
    let (ka, kb) = (a.curvature / largest, b.curvature / largest);
    let m = a.m * kb - b.m * ka;
    let c = a.c * kb - b.c * ka;
    let square = m.length_squared();
    if square == 0.0 {
        return [None; 2];
    }
    let foot = m * (-c / square);
    let along = m.left().unit();
    let of = if a.curvature.abs() >= b.curvature.abs() {
        a
    } else {
        b
    };
    // −κ t² / 2 + 2 h t + v = 0, solved so that nothing cancels.
    let h = 0.5 * of.gradient(foot).dot(along);
    let v = of.value(foot);
    let root = h * h + 0.5 * of.curvature * v;
    if root < 0.0 {
        return [None; 2];
    }
    let q = h + root.sqrt().copysign(h);
    let t = [2.0 * q / of.curvature, -v / q];
    t.map(|t| t.is_finite().then(|| foot + along * t))
}

/// A common zero after two steps of Newton's method.
fn polished([a, b]: [Carrier; 2], mut p: Vector) -> Vector {
    for _ in 0..2 {
        let (ga, gb) = (a.gradient(p), b.gradient(p));
        let (va, vb) = (a.value(p), b.value(p));
        let det = ga.cross(gb);
        let step = Vector::new(ga.y * vb - gb.y * va, gb.x * va - ga.x * vb) * (1.0 / det);
        if !step.length().is_finite() {
            break;
        }
        p = p + step;
    }
    p
}

/// The place, with the coordinate that a line along an axis gives.
fn placed(mut p: Point, a: &Edge, b: &Edge) -> Point {
    for line in [a, b].into_iter().filter(|e| e.is_line()) {
        if line.start.x == line.end.x {
            p.x = line.start.x;
        }
        if line.start.y == line.end.y {
            p.y = line.start.y;
        }
    }
    p
}
