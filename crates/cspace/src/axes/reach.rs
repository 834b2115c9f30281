//! Where features can come, to tell pairs that never meet.

use crate::feature::Feature;
use crate::geometry::{Point, Vector};

use super::domain::wrapped;
use super::motion::Motion;
use super::nodes::Scene;

/// Where a feature can come: distances from its pivot, or beside its direction of sliding.
pub(super) fn reaches(features: &[Feature], scene: &Scene, is_first: bool) -> Vec<(f64, f64)> {
    let (side, motion) = if is_first {
        (&scene.first, scene.motions.first)
    } else {
        (&scene.second, scene.motions.second)
    };
    features
        .iter()
        .map(|f| {
            let points = [side.outline.start(f).point, side.outline.end(f).point];
            match motion {
                Motion::Turn { center } => distances_from(f, points, center),
                Motion::Slide { direction } => distances_beside(f, points, direction.left()),
                Motion::Still => (0.0, f64::INFINITY),
            }
        })
        .collect()
}

/// The least and largest distance of a feature from a point, or bounds on them.
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
    let (m, r) = (f.center().distance(center), f.radius().abs());
    let sees = |toward: Vector| {
        let outward = if f.radius() < 0.0 { -toward } else { toward };
        wrapped(outward.angle() - 0.5 * (f.lo + f.hi)).abs() < 0.5 * (f.hi - f.lo)
    };
    let toward = center - f.center();
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

/// Between which distances along `side` a feature lies, or bounds on them.
fn distances_beside(f: &Feature, [p, q]: [Point; 2], side: Vector) -> (f64, f64) {
    let (a, b) = (side.dot(p - Point::ORIGIN), side.dot(q - Point::ORIGIN));
    if f.is_line() {
        return (a.min(b), a.max(b));
    }
    let (m, r) = (side.dot(f.center() - Point::ORIGIN), f.radius().abs());
    (m - r, m + r)
}

/// Tells features that never meet from what their motions sweep.
pub(super) struct Apart {
    first: Motion,
    second: Motion,
}

impl Apart {
    /// Room for growth and rounding (length).
    const ROOM: f64 = 1e-9;

    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            first: scene.motions.first,
            second: scene.motions.second,
        }
    }

    pub(super) fn may_meet(&self, a: (f64, f64), b: (f64, f64)) -> bool {
        match (self.first, self.second) {
            (Motion::Turn { center: c }, Motion::Turn { center: d }) => {
                let apart = c.distance(d);
                let room = Self::ROOM;
                apart <= a.1 + b.1 + room && a.0 <= apart + b.1 + room && b.0 <= apart + a.1 + room
            }
            (Motion::Turn { center }, Motion::Slide { direction }) => {
                // The strip beside the centre.
                let at = direction.left().dot(center - Point::ORIGIN);
                b.0 - at <= a.1 + Self::ROOM && at - b.1 <= a.1 + Self::ROOM
            }
            (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
                let cross = d.cross(e);
                if cross != 0.0 {
                    return true;
                }
                let (lo, hi) = if d.dot(e) < 0.0 { (-b.1, -b.0) } else { b };
                a.0 <= hi + Self::ROOM && lo <= a.1 + Self::ROOM
            }
            _ => true,
        }
    }
}
