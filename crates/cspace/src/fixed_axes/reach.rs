//! Ranges of positions of features, by which pairs that never meet are excluded.

use core::f64::consts::{PI, TAU};

use crate::feature::{Feature, Near};
use crate::geometry::{Point, Vector, wrap};

use super::motion::{Motion, Motions};
use super::scene::Scene;

/// Range of a feature's positions, and of the inclination of its normals.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reach {
    /// Smallest and largest distance from the part's pivot, or offset across the direction of sliding.
    distances: (f64, f64),
    /// For a part that turns: the angles from the ray, pivot to contact, to the normal there; their middle and half width.
    lean: (f64, f64),
}

/// Ranges of the features of a part.
pub(super) fn reaches(features: &[Feature], scene: &Scene, is_first: bool) -> Vec<Reach> {
    let (side, motion) = if is_first {
        (&scene.first, scene.motions.first)
    } else {
        (&scene.second, scene.motions.second)
    };
    features
        .iter()
        .map(|f| {
            let points = [side.outline.start(f).point, side.outline.end(f).point];
            let distances = match motion {
                Motion::Turn { center } => distances_from(f, points, center),
                Motion::Slide { direction } => distances_beside(f, points, direction.left()),
                Motion::Still => (0.0, f64::INFINITY),
            };
            let lean = match motion {
                Motion::Turn { center } => lean(f, points, center),
                _ => (0.0, PI),
            };
            Reach { distances, lean }
        })
        .collect()
}

/// Smallest and largest distance of a feature from a point, or bounds on them.
fn distances_from(f: &Feature, [p, q]: [Point; 2], center: Point) -> (f64, f64) {
    let (a, b) = (p.distance(center), q.distance(center));
    if f.is_line() {
        let along = (q - p).unit();
        let at = along.dot(center - p);
        let beside = (0.0..=p.distance(q)).contains(&at);
        let least = if beside {
            along.cross(center - p).abs()
        } else {
            a.min(b)
        };
        return (least, a.max(b));
    }
    if let Some(near) = f.near {
        return distances_of_flat(near, [p, q], center);
    }
    let (m, r) = (f.center.distance(center), f.radius.abs());
    let sees = |toward: Vector| {
        let outward = if f.radius < 0.0 { -toward } else { toward };
        wrap(outward.angle() - 0.5 * (f.lo + f.hi)).abs() < 0.5 * (f.hi - f.lo)
    };
    let toward = center - f.center;
    let least = if m > 0.0 && sees(toward) {
        (m - r).abs()
    } else {
        a.min(b)
    };
    let largest = if m > 0.0 && sees(-toward) {
        m + r
    } else {
        a.max(b)
    };
    if m == 0.0 { (r, r) } else { (least, largest) }
}

/// Bounds on the distances of a large arc from a point: those of a line, extended by the arc's height above the chord.
fn distances_of_flat(near: Near, [p, q]: [Point; 2], center: Point) -> (f64, f64) {
    let (a, b) = (p.distance(center), q.distance(center));
    let along = near.normal.left();
    let height = (near.normal.dot(p - near.point).abs()).max(near.normal.dot(q - near.point).abs());
    let at = |p: Point| along.dot(p - center);
    let least = if (at(p) < 0.0) == (at(q) < 0.0) {
        a.min(b)
    } else {
        near.normal.dot(near.point - center).abs()
    };
    ((least - height).max(0.0), a.max(b) + height)
}

/// The angles from the ray from a pivot to a point of the feature to the normal there, or bounds on them: middle and half width.
///
/// The feature is contained in a disc about its middle, whose radius is half its length, or for an arc of radius r with normals over an
/// angle w the chord of half of it, 2 r sin(w / 4). As seen from the pivot the disc extends by asin(h / m) to both sides.
fn lean(f: &Feature, [p, q]: [Point; 2], center: Point) -> (f64, f64) {
    let normal = 0.5 * (f.lo + f.hi);
    let (middle, half) = if f.is_line() {
        (p + (q - p) * 0.5, 0.5 * p.distance(q))
    } else {
        let out = Vector::from_angle(normal) * f.radius;
        let width = (f.hi - f.lo).min(TAU);
        (
            f.near.map_or(f.center + out, |n| n.point),
            2.0 * f.radius.abs() * (0.25 * width).sin(),
        )
    };
    let ray = middle - center;
    let share = half / ray.length();
    let seen = if share < 1.0 { share.asin() } else { PI };
    let width = 0.5 * (f.hi - f.lo) + seen;
    (
        normal - ray.angle(),
        if width.is_finite() { width } else { PI },
    )
}

/// Smallest and largest coordinate of a feature along `side`, or bounds on them.
fn distances_beside(f: &Feature, [p, q]: [Point; 2], side: Vector) -> (f64, f64) {
    let (a, b) = (side.dot(p - Point::ORIGIN), side.dot(q - Point::ORIGIN));
    if f.is_line() {
        return (a.min(b), a.max(b));
    }
    if let Some(near) = f.near {
        // Neither end is farther from the tangent at the middle than the arc is high.
        let height = |p: Point| near.normal.dot(p - near.point).abs();
        let height = height(p).max(height(q));
        return (a.min(b) - height, a.max(b) + height);
    }
    let (m, r) = (side.dot(f.center - Point::ORIGIN), f.radius.abs());
    (m - r, m + r)
}

/// Margin for growth and rounding (length).
const ROOM: f64 = 1e-9;
/// Margin for rounding of angles near a limit of the inverse cosine (radians).
const TURN: f64 = 1e-4;

impl Motions {
    /// Whether features may meet: not if the areas that they sweep are disjoint.
    pub(super) fn may_meet(&self, a: &Reach, b: &Reach) -> bool {
        let leans = (a.lean, b.lean);
        let (a, b) = (a.distances, b.distances);
        match (self.first, self.second) {
            (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
                let apart = c.distance(d);
                apart <= a.1 + b.1 + ROOM
                    && a.0 <= apart + b.1 + ROOM
                    && b.0 <= apart + a.1 + ROOM
                    && Self::may_oppose(apart, (a, leans.0), (b, leans.1))
            }
            (Motion::Turn { center }, Motion::Slide { direction }) => {
                // The strip beside the centre.
                let at = direction.left().dot(center - Point::ORIGIN);
                b.0 - at <= a.1 + ROOM && at - b.1 <= a.1 + ROOM
            }
            (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
                let cross = d.cross(e);
                if cross != 0.0 {
                    return true;
                }
                let (lo, hi) = if d.dot(e) < 0.0 { (-b.1, -b.0) } else { b };
                a.0 <= hi + ROOM && lo <= a.1 + ROOM
            }
            _ => true,
        }
    }

    /// Whether normals can oppose each other where two features on turning parts touch.
    ///
    /// The contact is at an angle α from the line of the pivots as seen from the first, and β from the second; the normals are inclined by
    /// a from the first ray, by b from the second. They oppose each other if a + α = b + β up to whole turns.
    fn may_oppose(
        apart: f64,
        ((a0, a1), (a, a_width)): ((f64, f64), (f64, f64)),
        ((b0, b1), (b, b_width)): ((f64, f64), (f64, f64)),
    ) -> bool {
        let aside = Self::aside(apart, (a0, a1), b1) + Self::aside(apart, (b0, b1), a1);
        wrap(a - b).abs() <= a_width + b_width + aside + TURN
    }

    /// The largest angle from the line of the pivots, as seen from the first, of points at distances from r₀ to r₁ from the first pivot,
    /// and no farther than s from the other.
    ///
    /// Its cosine is (d² + r² − s²) / (2 d r), smallest at r² = d² − s² if that is in between, else at an end.
    fn aside(d: f64, (r0, r1): (f64, f64), s: f64) -> f64 {
        let (s, r0) = (s + ROOM, (r0 - ROOM).max(0.0));
        let cosine = |r: f64| (d * d + r * r - s * s) / (2.0 * d * r);
        let turning = (d * d - s * s).max(0.0).sqrt().clamp(r0, r1.max(r0));
        let cosines = [cosine(r0), cosine(r1), cosine(turning)];
        // Not finite if a pivot is on the feature or the pivots coincide: anything is possible.
        if cosines.iter().all(|c| c.is_finite()) {
            cosines
                .iter()
                .fold(1.0, |a: f64, &c| a.min(c))
                .max(-1.0)
                .acos()
        } else {
            PI
        }
    }
}
