//! Pieces of contact curves that may be free: those that discs of blocked positions do not cover.

use crate::contact::Sheet;
use crate::geometry::{Point, Rotation, Vector};

use crate::general::broad::disc::Disc;
use crate::general::broad::discs::Layout;

/// The discs of blocked positions near one orientation.
#[derive(Debug)]
pub(crate) struct BlockedDiscs<'a> {
    pub(crate) theta: f64,
    pub(crate) turn: Rotation,
    pub(crate) half: f64,
    pub(crate) largest: Option<Disc>,
    pub(crate) others: Vec<Disc>,
    pub(crate) layout: &'a Layout<'a>,
}

/// Number of rounds in which the middles of the remaining pieces are looked up.
const ROUNDS: usize = 3;

/// Collects in `open` the parts of a parameter range that `covered` leaves uncovered.
fn left_open(covered: &mut [(f64, f64)], (from, to): (f64, f64), open: &mut Vec<(f64, f64)>) {
    covered.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    open.clear();
    let mut at = from;
    for &(lo, hi) in covered.iter().chain([&(to, f64::INFINITY)]) {
        if lo > at {
            open.push((at, lo.min(to)));
        }
        at = at.max(hi);
        if at >= to {
            break;
        }
    }
}

/// Buffers of [`BlockedDiscs::uncovered`], kept for the next call.
#[derive(Debug, Default)]
pub(crate) struct Uncovered {
    covered: Vec<(f64, f64)>,
    /// Ranges of the parameter that no disc covers.
    pub(crate) open: Vec<(f64, f64)>,
}

/// A length far above the rounding of places, in the pair's frame.
const MARGIN: f64 = 1e-10;

impl<'a> BlockedDiscs<'a> {
    /// The discs at an orientation, for orientations within `half` of it.
    pub(crate) fn new(layout: &'a Layout<'a>, theta: f64, half: f64) -> Self {
        let turn = Rotation::by(theta);
        Self {
            theta,
            turn,
            half,
            largest: layout.largest.map(|p| p.at(turn)),
            others: layout.others.iter().map(|o| o.0.at(turn)).collect(),
            layout,
        }
    }

    /// The pieces of a sheet's curves that no disc covers at all orientations from `lo` to `hi`, which lie within `half` of the middle one:
    /// ranges of the fraction along a line, or of the angle of the normal on a circle.
    ///
    /// At one fraction or angle, a point of the curve is P + R w. Relative to a disc about a − R b it moves by R (w + b), so it is inside
    /// at all orientations if at the middle one it is inside by |w + b| times `half`.
    pub(crate) fn uncovered(&self, sheet: &Sheet, lo: f64, hi: f64, work: &mut Uncovered) {
        let Uncovered { covered, open } = work;
        covered.clear();
        open.clear();
        let (mut from, mut to) = (0.0, 1.0);
        let (mut middle, mut half_angle) = (0.0, 0.0);
        if sheet.is_circle() {
            let ends = [sheet.start, sheet.end];
            middle = 0.5 * (ends[0].angle_at(self.theta) + ends[1].angle_at(self.theta));
            // Angles are linear in the orientation, so their extremes are those at its ends.
            for angle in ends.iter().flat_map(|e| [e.angle_at(lo), e.angle_at(hi)]) {
                half_angle = (angle - middle).abs().max(half_angle);
            }
            // Sines are monotonous up to a quarter turn; longer arcs are seldom covered.
            if half_angle > 1.5 {
                open.push((middle - half_angle, middle + half_angle));
                return;
            }
            to = half_angle.sin();
            from = -to;
        }
        let curve = MiddleCurve::new(sheet, self.turn, half_angle);
        let mut take = |disc: &Disc| {
            let range = curve.within(disc, self.half);
            covered.extend(range);
            range.is_some_and(|(lo, hi)| lo <= from && hi >= to)
        };
        if self.largest.as_ref().is_some_and(&mut take) {
            return;
        }
        let mut near = self.layout.near(curve.middle, curve.reach);
        if near.any(|i| take(&self.others[i])) {
            return;
        }
        left_open(covered, (from, to), open);
        if let Some(tables) = self.layout.tables {
            for _ in 0..ROUNDS {
                let before = covered.len();
                for &(lo, hi) in open.iter() {
                    let pairs = tables.overlaps(curve.at(0.5 * (lo + hi)), self.turn);
                    let discs = pairs.map(|pair| pair.at(self.turn));
                    covered.extend(discs.filter_map(|d| curve.within(&d, self.half)));
                }
                if covered.len() == before {
                    break;
                }
                left_open(covered, (from, to), open);
            }
        }
        if sheet.is_circle() {
            let angle = |sine: f64| {
                let edge = sine <= from || sine >= to;
                middle
                    + if edge {
                        half_angle.copysign(sine)
                    } else {
                        sine.asin()
                    }
            };
            for (lo, hi) in open {
                (*lo, *hi) = (angle(*lo), angle(*hi));
            }
        }
    }
}

/// A sheet's curve at the middle orientation.
struct MiddleCurve {
    shape: Shape,
    /// The spiral's w at both ends.
    ends: (Vector, Vector),
    /// Disc that contains the curve: its middle and radius.
    middle: Point,
    reach: f64,
    /// Largest distance of the curve from the shape.
    off: f64,
}

enum Shape {
    Line {
        start: Point,
        along: Vector,
    },
    /// Circle; `mid` is the normal in the middle.
    Circle {
        center: Point,
        radius: f64,
        mid: Vector,
    },
}

impl MiddleCurve {
    fn new(sheet: &Sheet, turn: Rotation, half_angle: f64) -> Self {
        let (start, end) = (sheet.locus.start.at(turn), sheet.locus.end.at(turn));
        if sheet.is_circle() {
            let spiral = sheet.locus.carrier.through;
            let (center, radius) = (spiral.at(turn), sheet.locus.carrier.radius);
            let both = ((start - center) + (end - center)) * radius.signum();
            let mid = both * (1.0 / both.length());
            Self {
                shape: Shape::Circle {
                    center,
                    radius,
                    mid,
                },
                ends: (spiral.w, spiral.w),
                middle: center + mid * radius,
                reach: radius.abs() * half_angle,
                off: 0.0,
            }
        } else {
            Self {
                shape: Shape::Line {
                    start,
                    along: end - start,
                },
                ends: (sheet.locus.start.turning(), sheet.locus.end.turning()),
                middle: start.midpoint(end),
                reach: 0.5 * (end - start).length(),
                off: sheet.height(),
            }
        }
    }

    /// The place at a parameter.
    fn at(&self, t: f64) -> Point {
        match self.shape {
            Shape::Line { start, along } => start + along * t,
            Shape::Circle {
                center,
                radius,
                mid,
            } => {
                let normal = mid * ((1.0 - t) * (1.0 + t)).max(0.0).sqrt() + mid.left() * t;
                center + normal * radius
            }
        }
    }

    /// The range of the parameter in which the curve is certainly in a disc: the fraction along a line, or on a circle the sine of the
    /// angle from the middle.
    fn within(&self, disc: &Disc, half: f64) -> Option<(f64, f64)> {
        let speed = (self.ends.0 + disc.moving)
            .length_squared()
            .max((self.ends.1 + disc.moving).length_squared())
            .sqrt();
        let room = disc.reach - speed * half - MARGIN - self.off;
        if room <= 0.0 {
            return None;
        }
        match self.shape {
            Shape::Line { start, along } => {
                // |A + t D| < r.
                let a = start - disc.center;
                let (dd, ad) = (along.length_squared(), a.dot(along));
                let square = ad * ad - dd * (a.length_squared() - room * room);
                if square <= 0.0 {
                    return None;
                }
                let root = square.sqrt();
                Some(((-ad - root) / dd, (-ad + root) / dd))
            }
            Shape::Circle {
                center,
                radius,
                mid,
            } => {
                // |ρ n − d| < r: n within an angle α of ±d.
                let d = (disc.center - center) * radius.signum();
                let length = d.length();
                let least = radius * radius + length * length - room * room;
                let cos = least / (2.0 * radius.abs() * length);
                if cos >= 1.0 || cos.is_nan() {
                    return None;
                }
                let toward = d * (1.0 / length);
                let all = (f64::NEG_INFINITY, f64::INFINITY);
                if cos <= -1.0 {
                    return Some(all);
                }
                let (across, sin) = (toward.left(), ((1.0 - cos) * (1.0 + cos)).sqrt());
                let ends = [toward * cos + across * (-sin), toward * cos + across * sin];
                // Sines of their angles from the middle, if they are within a quarter turn of it.
                let [lo, hi] = ends.map(|n| (mid.dot(n) > 0.0).then(|| mid.cross(n)));
                match (lo, hi) {
                    (None, None) => (mid.dot(toward) > cos).then_some(all),
                    (lo, hi) => {
                        let (lo, hi) = (lo.unwrap_or(all.0), hi.unwrap_or(all.1));
                        (lo < hi).then_some((lo, hi))
                    }
                }
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use rand::{Rng, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::contact::Geometry;
    use crate::general::broad::discs::Cores;
    use crate::part::{Part, Vertex};

    /// A wheel with teeth and a round bump between any two of them.
    fn wheel(teeth: u32, bulge: f64) -> Part {
        let step = core::f64::consts::TAU / f64::from(teeth);
        let at = |k: u32, share: f64, r: f64, bulge: f64| {
            let angle = step * (f64::from(k) + share);
            Vertex::new(r * angle.cos(), r * angle.sin(), bulge)
        };
        let outline = (0..teeth).flat_map(|k| {
            [
                at(k, 0.0, 1.0, 0.1),
                at(k, 0.4, 1.0, 0.0),
                at(k, 0.5, 0.7, bulge),
                at(k, 0.9, 0.7, 0.0),
            ]
        });
        Part::new("wheel", vec![outline.collect()]).unwrap()
    }

    /// Covered places are blocked, at any orientation of the interval; and a good deal is covered.
    #[test]
    fn covered_curves_are_blocked() {
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let (mut covered, mut asked) = (0, 0);
        // Few sheets, all of them at each orientation; and so many that discs are looked up.
        for (teeth, bulge, step) in [((7, 5), 0.3, 1), ((7, 5), -0.3, 1), ((110, 12), 0.3, 97)] {
            let (a, b) = (wheel(teeth.0, bulge), wheel(teeth.1, -bulge));
            let geometry = Geometry::new(&a, &b, None, usize::MAX);
            let cores = Cores::new(&geometry);
            assert_eq!(cores.about(0.0).tables.is_some(), step > 1);
            let mut work = Uncovered::default();
            for _ in 0..40 {
                let (theta, half) = (rng.random_range(-3.0..3.0), rng.random_range(0.001..0.04));
                let layout = cores.about(theta + rng.random_range(-0.05..0.05));
                let discs = BlockedDiscs::new(&layout, theta, half);
                for sheet in geometry.contacts.sheets.iter().step_by(step) {
                    let (lo, hi) = (sheet.lo.max(theta - half), sheet.hi.min(theta + half));
                    if lo >= hi {
                        continue;
                    }
                    discs.uncovered(sheet, lo, hi, &mut work);
                    let at = rng.random_range(lo..hi);
                    let turn = Rotation::by(at);
                    let share: f64 = rng.random_range(0.0..1.0);
                    let (parameter, point) = if sheet.is_circle() {
                        let ends = [sheet.start, sheet.end].map(|e| e.angle_at(at));
                        let angle = ends[0] + (ends[1] - ends[0]) * share;
                        let normal = Vector::from_angle(angle);
                        (
                            angle,
                            sheet.locus.carrier.through.at(turn)
                                + normal * sheet.locus.carrier.radius,
                        )
                    } else {
                        let (start, end) = (sheet.locus.start.at(turn), sheet.locus.end.at(turn));
                        (share, start + (end - start) * share)
                    };
                    asked += 1;
                    let open = |&(lo, hi): &(f64, f64)| lo <= parameter && parameter <= hi;
                    if !work.open.iter().any(open) {
                        covered += 1;
                        assert!(geometry.overlaps(point, at), "{sheet:?} {parameter} {at}");
                    }
                }
            }
        }
        assert!(2 * covered > asked, "{covered} of {asked} covered");
    }
}
