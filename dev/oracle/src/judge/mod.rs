//! Brute-force test of whether two parts overlap at one configuration.
//!
//! The boundaries are cut where they meet, and a point of each piece is tested for being inside the other part. The
//! test uses doubles; cases that are too close to contact for them are repeated in pairs of doubles.

mod compare;
mod curve;
mod gap;
mod outline;
mod plane;
mod real;

use cspace::{Configuration, Part, Point, Vector};

use compare::{Finding, compare, overlap_beside};
pub use gap::area;
pub(crate) use gap::least_gap;
use outline::Outline;
use plane::{Frame, Place};
use real::{Double, Real};

/// Verdict of the [`Oracle`] on one configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// Whether the open interiors meet. Parts that merely touch do not overlap: penetration of less than
    /// 1e-15 times [`Oracle::size`] counts as touching, being less than the rounding of the input.
    pub overlap: bool,
    /// The distance between the boundaries; 0 where they meet, and when the parts overlap. It is right to about 1e-14
    /// times the size, or times the largest radius of an arc, if that is no more than a thousand sizes.
    pub clearance: f64,
    /// No translation shorter than this changes the verdict. Free: the clearance. Overlapping: how far some point of
    /// one part lies inside the other. A verdict is certain when this exceeds 1e-12 times [`Oracle::size`].
    pub margin: f64,
}

/// Two parts, prepared for many questions.
#[derive(Debug, Clone)]
pub struct Oracle {
    /// A point amid each part; all is computed relative to it.
    centers: [Point; 2],
    fixed: Outline<f64>,
    moving: Outline<f64>,
    fixed_fine: Outline<Double>,
    moving_fine: Outline<Double>,
    size: f64,
    /// Margin above which a verdict in doubles is trusted, unless arcs are flat.
    trust: f64,
    /// Whether there are arcs so flat, or edges so short, that doubles are not sufficient: they do not determine on
    /// which side of its chord an arc is, nor where on a short one it meets a long one.
    fine: bool,
}

/// Fixed or moving part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Body {
    Fixed,
    Moving,
}

/// Arcs of a larger radius are flat, in sizes: for doubles they are a few thousand roundings high at the least.
const FLAT: f64 = 1e3;

/// Edges shorter than this are short, in sizes.
const SHORT: f64 = 1e-4;

/// Whether two parts overlap at one configuration. For many configurations of a pair use [`Oracle`].
pub fn judge(fixed: &Part, moving: &Part, c: Configuration) -> Verdict {
    Oracle::new(fixed, moving).judge(c)
}

impl Oracle {
    /// Prepares the pair.
    pub fn new(fixed: &Part, moving: &Part) -> Self {
        let centers = [middle(fixed), middle(moving)];
        let fixed_fine = Outline::<Double>::new(fixed, centers[0]);
        let moving_fine = Outline::<Double>::new(moving, centers[1]);
        let size = fixed_fine
            .frame
            .diagonal()
            .max(moving_fine.frame.diagonal());
        let radius = fixed_fine
            .largest_radius()
            .max(moving_fine.largest_radius());
        let flat = radius > FLAT * size;
        let shortest = fixed_fine.shortest().min(moving_fine.shortest());
        Self {
            centers,
            fixed: fixed_fine.rough(),
            moving: moving_fine.rough(),
            fixed_fine,
            moving_fine,
            size,
            trust: 1e-13 * (size + if flat { 0.0 } else { radius }),
            fine: flat || shortest < SHORT * size,
        }
    }

    /// The larger of the diagonals of the boxes about the two parts: what margins are measured by.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// Centre of the box about the fixed part, in its own frame.
    pub fn fixed_center(&self) -> Point {
        self.centers[0]
    }

    /// Centre of the box about the moving part, in its own frame.
    pub fn moving_center(&self) -> Point {
        self.centers[1]
    }

    /// Whether the parts overlap at the configuration, and by how much.
    pub fn judge(&self, c: Configuration) -> Verdict {
        let turn = f64::sin_cos(c.theta);
        let [f, m] = self.centers;
        let far = [f, m, c.position()]
            .iter()
            .any(|p| p.x.abs() + p.y.abs() > 4.0 * self.size);
        let shift = if far {
            self.shift::<Double>(c).rough()
        } else {
            self.shift::<f64>(c)
        };
        let trust = self.trust + 1e-14 * (shift.x.abs() + shift.y.abs());
        let clear = if self.fine {
            clear(&self.fixed_fine, &self.moving_finely(c), trust, self.size)
        } else {
            clear(
                &self.fixed,
                &self.moving.moved(turn, shift),
                trust,
                self.size,
            )
        };
        clear.unwrap_or_else(|| self.judge_finely(c, trust))
    }

    fn outline(&self, body: Body) -> &Outline<f64> {
        match body {
            Body::Fixed => &self.fixed,
            Body::Moving => &self.moving,
        }
    }

    /// The corners of the box about a part, as seen from its middle.
    pub(crate) fn frame(&self, body: Body) -> (Point, Point) {
        let Frame { low, high } = self.outline(body).frame;
        (Point::new(low[0], low[1]), Point::new(high[0], high[1]))
    }

    /// The radius of the largest disc inside a part about a place that is seen from its middle; negative if it is outside.
    pub(crate) fn depth_inside(&self, body: Body, at: Vector) -> f64 {
        let (outline, p) = (self.outline(body), Place::new(at.x, at.y));
        let distance = outline.distance(p, self.trust);
        if outline.holds(p, self.trust) {
            distance
        } else {
            -distance
        }
    }

    fn moving_finely(&self, c: Configuration) -> Outline<Double> {
        let turn = <Double as Real>::sin_cos(c.theta);
        self.moving_fine.moved(turn, self.shift(c))
    }

    /// The verdict where doubles do not suffice.
    fn judge_finely(&self, c: Configuration, trust: f64) -> Verdict {
        let moving = self.moving_finely(c);
        let found = compare(&self.fixed_fine, &moving, trust, self.size, true);
        let touching = 1e-15 * self.size;
        if !found.meeting && found.clearance > touching {
            return apart(&found);
        }
        let mut depth = found.depth;
        if depth <= touching {
            // Shared stretches of boundary: their own points are inside nothing, points beside them may be.
            depth = found
                .shared
                .iter()
                .map(|&(p, n)| {
                    if self.fine {
                        return overlap_beside(&self.fixed_fine, &moving, p, n, self.size, trust);
                    }
                    overlap_beside(&self.fixed, &moving.rough(), p, n, self.size, trust)
                })
                .fold(0.0, f64::max);
        }
        if depth > touching {
            return inside(depth);
        }
        let clearance = if found.meeting { 0.0 } else { found.clearance };
        Verdict {
            overlap: false,
            clearance,
            margin: clearance,
        }
    }

    /// Vector from the fixed part's centre to the moving part's: (x, y) + R m − f.
    fn shift<S: Real>(&self, c: Configuration) -> Place<S> {
        let [f, m] = self.centers.map(|p| Place::new(S::of(p.x), S::of(p.y)));
        m.moved(S::sin_cos(c.theta), Place::new(S::of(c.x), S::of(c.y))) - f
    }
}

/// The verdict, if it is clearer than the rounding.
fn clear<S: Real>(a: &Outline<S>, b: &Outline<S>, trust: f64, size: f64) -> Option<Verdict> {
    let found = compare(a, b, trust, size, false);
    if found.meeting {
        (found.depth > trust).then(|| inside(found.depth))
    } else {
        (found.clearance > trust).then(|| apart(&found))
    }
}

fn inside(depth: f64) -> Verdict {
    Verdict {
        overlap: true,
        clearance: 0.0,
        margin: depth,
    }
}

/// The verdict on boundaries that do not meet.
fn apart(found: &Finding) -> Verdict {
    let overlap = found.depth > 0.0;
    Verdict {
        overlap,
        clearance: if overlap { 0.0 } else { found.clearance },
        margin: found.clearance.max(found.depth),
    }
}

/// The middle of the box about the part.
fn middle(part: &Part) -> Point {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for v in part.loops().iter().flat_map(|l| l.vertices()) {
        low = [low[0].min(v.x), low[1].min(v.y)];
        high = [high[0].max(v.x), high[1].max(v.y)];
    }
    // A rough box, from a corner of it, where rounding does not matter, to the box of the arcs as well.
    let corner = Point::new(low[0], low[1]);
    let f = Outline::<f64>::new(part, corner).frame;
    Point::new(
        corner.x + 0.5 * (f.low[0] + f.high[0]),
        corner.y + 0.5 * (f.low[1] + f.high[1]),
    )
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::{near_contact_about, pairs};

    #[test]
    fn doubles_and_pairs_of_doubles_agree() {
        for pair in pairs() {
            let oracle = Oracle::new(&pair.fixed, &pair.moving);
            let mut rng = ChaCha8Rng::seed_from_u64(9);
            for near in near_contact_about(&oracle, &pair.notable, &mut rng, 60) {
                let c = near.configuration;
                let v = oracle.judge(c);
                let w = oracle.judge_finely(c, oracle.trust);
                assert_eq!(v.overlap, w.overlap, "{}: {c:?} {v:?} {w:?}", pair.name);
                assert!((v.clearance - w.clearance).abs() < oracle.trust);
            }
        }
    }
}
