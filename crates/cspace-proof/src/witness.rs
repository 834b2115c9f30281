//! Two discs of material that overlap at every configuration of a triangle.

use cspace::{Part, Point, Rotation, Vector};

/// Radii are this share less than the distance to the boundary, so that rounding leaves the discs inside.
const SPARE: f64 = 1e-9;
/// Of a triangle so much less, as a share of the depth, is a witness: rounding leaves it one.
const MARGIN: f64 = 1e-6;

/// A disc of the moving part's material about a point from the pivot, and one of the fixed part's.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Witness {
    pub(crate) moving: (Vector, f64),
    pub(crate) fixed: (Point, f64),
}

impl Witness {
    /// How much the discs overlap at least, at all configurations between three of the pivot.
    pub(crate) fn overlap(&self, corners: &[[f64; 3]; 3]) -> f64 {
        let ((q, r), (c, s)) = (self.moving, self.fixed);
        let apart = |[x, y, theta]: [f64; 3]| {
            let v = Point::new(x, y) + Rotation::by(theta) * q - c;
            v.length()
        };
        let theta = corners.map(|c| c[2]);
        let range = theta[0].max(theta[1]).max(theta[2]) - theta[0].min(theta[1]).min(theta[2]);
        let farthest = corners.map(apart).into_iter().fold(0.0, f64::max);
        r + s - farthest - q.length() * range * range / 8.0
    }
}

/// Where discs may be.
pub(crate) struct Materials<'a> {
    pub(crate) fixed: &'a Part,
    pub(crate) moving: &'a Part,
    pub(crate) pivot: Point,
    pub(crate) depth: f64,
}

/// The radius of the largest disc about a point within a part; negative outside.
fn room(part: &Part, p: Point) -> f64 {
    let nearest = part
        .edges()
        .map(|e| e.distance(p))
        .fold(f64::INFINITY, f64::min);
    if part.contains(p) {
        nearest * (1.0 - SPARE)
    } else {
        -nearest
    }
}

/// Discs about places that lie from a point in directions about one, up to a distance.
fn discs(part: &Part, from: Point, inwards: Vector, depth: f64, slack: f64) -> Vec<(Point, f64)> {
    const SIDEWAYS: [f64; 7] = [0.0, 0.35, -0.35, 0.7, -0.7, 1.1, -1.1];
    let mut found = Vec::new();
    for turn in SIDEWAYS {
        let along = Rotation::by(turn) * inwards;
        let mut step = if turn == 0.0 { 0.0 } else { 0.25 * depth };
        while step < part.size() {
            let center = from + along * step;
            let radius = room(part, center);
            if radius > 0.0 && radius > step - slack {
                found.push((center, radius));
            } else if step > depth {
                break;
            }
            step = if step == 0.0 {
                0.25 * depth
            } else {
                1.6 * step
            };
        }
    }
    found
}

impl Materials<'_> {
    pub(crate) fn is_enough(&self, overlap: f64) -> bool {
        overlap > MARGIN * self.depth
    }

    /// The discs that overlap most in a triangle; `touch` is where the shrunk part touches in its middle, with the fixed
    /// part's outward normal and the orientation there.
    pub(crate) fn best(
        &self,
        corners: &[[f64; 3]; 3],
        touch: Point,
        normal: Vector,
    ) -> Option<(Witness, f64)> {
        let middle: [f64; 3] =
            core::array::from_fn(|k| (corners[0][k] + corners[1][k] + corners[2][k]) / 3.0);
        let back = Rotation::by(-middle[2]);
        let q = back * (touch - Point::new(middle[0], middle[1]));
        let of_moving = discs(
            self.moving,
            self.pivot + q,
            back * normal,
            self.depth,
            -0.2 * self.depth,
        );
        let of_fixed = discs(self.fixed, touch, -normal, self.depth, 0.8 * self.depth);
        let mut best: Option<(Witness, f64)> = None;
        for &(p, r) in &of_moving {
            for &fixed in &of_fixed {
                let moving = (p - self.pivot, r);
                let witness = Witness { moving, fixed };
                let overlap = witness.overlap(corners);
                if best.is_none_or(|(_, most)| overlap > most) {
                    best = Some((witness, overlap));
                }
            }
        }
        best
    }
}
