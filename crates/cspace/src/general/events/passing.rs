//! The orientations at which two branches on one sheet pass each other, because three sheets meet.
//!
//! Where three cycles meet, a trigonometric polynomial of degree four vanishes, whichever of their crossings meet. It is smooth where
//! places are not (at tangencies), and its roots are isolated with a bound on its third derivative. At each root the places of the two
//! branches show whether these are the crossings that meet.

use crate::contact::{Cycle, Exact, Geometry, Sheet};
use crate::feature::tolerance::LONGEST;
use crate::geometry::{Rotation, Vector};
use crate::number::{Dual, Event, Real, TrigPolynomial};

use crate::general::events::branch::Branch;
use crate::general::events::clusters::Moment;
use crate::general::events::order::{apart, exactly_apart};
use crate::general::events::placing::Placing;

/// Width (radians) below which intervals are not halved further.
///
/// Two roots within such an interval leave the order as it was; between them the places differ by no more than h² |d″| / 8, some 1e-17,
/// which is below rounding.
const NARROWEST: f64 = 1e-8;

/// Width of an interval (radians) below which f64 is not used.
const NARROW: f64 = 1e-6;

/// As [`NARROWEST`] in double-double.
const NARROWEST_EXACT: f64 = 1e-18;

/// A function without roots or divisions that vanishes where the three sheets meet.
///
/// The most curved of the three, with its level F = n·v + λ (v² − c) / 2 at p = P + v, reduces the others to lines: with μ the ratio of the
/// weights, F′ − μ F is linear in v, so that a·v = e with a = ∇F′(P) − μ n and e = −(F′(P) + λ′ c / 2). For two circles this is their
/// radical line. With d = a₁ × a₂ and w = d v, which is right(a₂) e₁ − right(a₁) e₂, d² F = d n·w + λ (w² − c d²) / 2. For three lines n·p
/// = e it is the determinant of the three.
///
/// A large circle is written by a point near the parts, and in the frame of its normal no term has a higher degree than about a centre: it
/// is a trigonometric polynomial of degree four at most. Returned with the size of its terms.
pub(crate) fn concurrency<T: Real>(mut three: [Cycle<T>; 3]) -> (T, f64) {
    // A circle written by its centre may be as small as a point.
    let bend = |c: &Cycle<T>| {
        if c.is_centred() {
            f64::INFINITY
        } else {
            c.weight.value().abs()
        }
    };
    let most = [1, 2].into_iter().fold(0, |most, i| {
        if bend(&three[i]) > bend(&three[most]) {
            i
        } else {
            most
        }
    });
    three.swap(0, most);
    let size = |v: Vector<T>| v.x.value().hypot(v.y.value());
    // Lengths near the parts count as one; a point with a long arm is far away at other orientations.
    let far = |length: f64| (length / LONGEST).max(1.0);
    let base = &three[0];
    if base.is_line() {
        let line = |c: &Cycle<T>| (c.normal, c.normal.dot(c.through.to_vector()));
        let [(l, d), (m, e), (n, g)] = [line(&three[0]), line(&three[1]), line(&three[2])];
        let farthest = three.iter().map(|c| far(size(c.through.to_vector())));
        let terms = 8.0 * farthest.fold(1.0, f64::max);
        return (d * m.cross(n) + e * n.cross(l) + g * l.cross(m), terms);
    }
    let (point, half) = (base.through, T::constant(0.5));
    let radius = if base.is_centred() {
        base.size
    } else {
        T::constant(0.0)
    };
    let linear = |other: &Cycle<T>| {
        let (ratio, to) = (other.weight / base.weight, point - other.through);
        let a = (other.normal - base.normal * ratio) + to * other.weight;
        let e = -(other.level(point) + half * other.weight * radius * radius);
        let (weight, length) = (other.weight.value().abs(), size(to));
        let steep = size(other.normal) + ratio.value().abs() * size(base.normal) + weight * length;
        let own = other.size.value();
        let squares = length.powi(2) + own.powi(2) + radius.value().powi(2);
        let along = size(other.normal) * far(length);
        (a, e, steep, along + weight * squares)
    };
    let ((a, e, s, p), (b, g, t, q)) = (linear(&three[1]), linear(&three[2]));
    let w = (b * e - a * g).right();
    let d = a.cross(b);
    let arm = radius * d;
    let value = base.normal.dot(w) * d + half * base.weight * (w.length_squared() - arm * arm);
    let (long, wide) = (t * p + s * q, s * t);
    let terms = size(base.normal) * long * wide
        + 0.5 * base.weight.value().abs() * (long.powi(2) + (radius.value() * wide).powi(2));
    (value, terms)
}

/// Two branches on one sheet.
pub(crate) struct Passing<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) sheet: u32,
    pub(crate) x: &'a Branch,
    pub(crate) y: &'a Branch,
}

/// Places of a branch along its sheet's curve at the beginning, in the middle and at the end of a narrow interval.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    places: [Exact; 3],
    /// Bound on the deviation from the parabola through these.
    rest: f64,
}

impl Sample {
    /// Samples a branch on a sheet; `None` where it crosses at too small an angle for the interval.
    pub(crate) fn new(
        geometry: &Geometry,
        sheet: u32,
        placings: &[Placing<'_, Exact>; 3],
        b: &Branch,
        length: f64,
    ) -> Option<Self> {
        /// Bound, per radian, on the rate of change of the squared sine of the angle of crossing, times the smallest radius: where the sine
        /// vanishes, places are singular.
        const SPEED: f64 = 16.0;
        /// Largest admissible length of the interval as a share of the distance to such a singularity.
        const NARROW: f64 = 1e-2;
        let sheets = &geometry.contacts.sheets;
        let both = [sheet, b.other(sheet)].map(|s| &sheets[s as usize]);
        let radii = both.iter().filter(|s| s.is_circle());
        let least = radii
            .map(|s| s.locus.carrier.radius.abs())
            .fold(1.0, f64::min);
        let share = SPEED * length / (placings[1].sharpness(b).powi(2) * least);
        (share < NARROW && !both.iter().any(|s| s.is_flat())).then(|| Self {
            places: [0, 1, 2].map(|i: usize| placings[i].place(b)),
            rest: share.powi(3),
        })
    }

    /// Whether the order of two branches changes once in the interval (`Some(true)`) or never (`Some(false)`); `None` if that is not
    /// certain.
    fn change(&self, other: &Self) -> Option<bool> {
        let d = [0, 1, 2].map(|i| (self.places[i] - other.places[i]).to_f64());
        let rest = self.rest + other.rest;
        // Q(s) = d₁ + (d₂ − d₀) s / 2 + c s², −1 ≤ s ≤ 1.
        let c = (0.5 * (d[0] + d[2]) - d[1]).abs();
        let one_sign = d.iter().all(|&x| x > 0.0) || d.iter().all(|&x| x < 0.0);
        let least = d.iter().map(|x| x.abs()).fold(f64::INFINITY, f64::min);
        if one_sign && least > c + rest {
            Some(false)
        } else if d[0] * d[2] < 0.0
            && 0.5 * (d[2] - d[0]).abs() > 2.0 * c + 4.0 * rest
            && d[0].abs().min(d[2].abs()) > rest
        {
            Some(true)
        } else {
            None
        }
    }
}

impl Passing<'_> {
    /// Finds passings as [`isolate`](Self::isolate) does, in a narrow interval, from samples of both branches. Returns whether the samples
    /// decide.
    pub(crate) fn told_by(
        &self,
        [x, y]: [&Sample; 2],
        lo: Exact,
        hi: Exact,
        found: &mut impl FnMut(Moment),
    ) -> bool {
        match x.change(y) {
            Some(true) => {
                self.change_of_order(lo, hi, None)
                    .into_iter()
                    .for_each(found);
                true
            }
            Some(false) => true,
            None => false,
        }
    }

    /// Finds every orientation at which the two branches pass each other. Returns the number of parts of the interval in which the sign of
    /// the polynomial is not known. `f` is the polynomial in f64; `None` if f64 is not to be used.
    pub(crate) fn isolate(
        &self,
        f: Option<&TrigPolynomial>,
        lo: Exact,
        hi: Exact,
        found: &mut impl FnMut(Moment),
    ) -> u64 {
        /// Minimum distance around a meeting at which f64 decides (radians).
        const AROUND: f64 = 1e-7;
        // Intervals in which f64 decides nothing.
        let mut unclear: Vec<(Exact, Exact)> = Vec::new();
        let mut vague: Vec<(Exact, Exact)> = Vec::new();
        let (first, last) = (lo.to_f64(), hi.to_f64());
        // The ends are not rounded: there may be a meeting between an end and the nearest double.
        let exactly = |t: f64| match t {
            _ if t <= first => lo,
            _ if t >= last => hi,
            _ => Exact::from(t),
        };
        match f {
            Some(f) if (hi - lo).to_f64() >= NARROW => {
                let mut brackets = Vec::new();
                f.brackets(
                    first,
                    last,
                    NARROWEST,
                    &mut |a, b| brackets.push((a, b)),
                    &mut |a, b| unclear.push((exactly(a), exactly(b))),
                );
                for (a, b) in brackets {
                    // The sign at an end may be unknown in f64, too.
                    let told = |t: f64| f.at(t).0.abs() > f.error();
                    if b - a <= 2.0 * NARROWEST || !told(a) || !told(b) {
                        unclear.push((exactly(a), exactly(b)));
                    } else if let Some(e) = self.refine(f, a, b) {
                        let around = AROUND.max(8.0 * e.error);
                        let from = exactly((e.theta - around).max(a));
                        let to = exactly((e.theta + around).min(b));
                        self.change_of_order(from, to, Some(e.theta))
                            .into_iter()
                            .for_each(&mut *found);
                    }
                }
            }
            _ => unclear.push((lo, hi)),
        }
        if !unclear.is_empty() {
            let exact = self.polynomial();
            for (a, b) in unclear {
                let mut brackets = Vec::new();
                exact.brackets(
                    a,
                    b,
                    NARROWEST_EXACT,
                    &mut |a, b| brackets.push((a, b)),
                    &mut |a, b| vague.push((a, b)),
                );
                let changes =
                    (brackets.into_iter()).filter_map(|(a, b)| self.change_of_order(a, b, None));
                changes.for_each(&mut *found);
            }
        }
        let count = vague.len() as u64;
        for (a, b) in vague {
            self.change_of_order(a, b, None)
                .into_iter()
                .for_each(&mut *found);
        }
        count
    }

    /// The orientation between two others at which the two branches pass each other, if their order changes: by secants, started where f64
    /// indicates the root, and by halving where a secant leaves the interval or does not shorten it.
    ///
    /// Where several crossings of the three carriers meet within a short interval, the polynomial vanishes to a higher order than the
    /// difference of places does.
    fn change_of_order(&self, lo: Exact, hi: Exact, near: Option<f64>) -> Option<Moment> {
        /// Length below which a difference is rounding: where three carriers always share a point.
        const NONE: f64 = 1e-29;
        /// Ratio of the difference of two values to their rounding above which they determine a slope.
        const MARGIN: f64 = 16.0;
        let both = [self.x, self.y];
        let at = |theta: Exact| {
            let apart = apart(self.geometry, self.sheet, both, theta);
            (apart.to_f64().abs() >= NONE).then_some(apart)
        };
        let ((mut a, at_a), (mut b, at_b)) = ((lo, at(lo)?), (hi, at(hi)?));
        if at_a.is_negative() == at_b.is_negative() {
            return None;
        }
        // The secant through the ends, and its zero.
        let mut slope = (at_b - at_a) / (b - a);
        let mut c = near.map_or_else(|| a - at_a / slope, Exact::from);
        let mut last: Option<(Exact, Exact)> = None;
        // The longest step that counts as a secant step.
        let mut longest = (b - a).to_f64();
        for _ in 0..MOST_STEPS {
            if (b - a).to_f64() <= SAME_EXACT {
                break;
            }
            if !(a < c && c < b) {
                c = (a + b).scaled(0.5);
            }
            let (at_c, rounding) = exactly_apart(self.geometry, self.sheet, both, c);
            if at_c.is_negative() == at_a.is_negative() {
                a = c;
            } else {
                b = c;
            }
            // The difference of two values that are rounding is not a slope: where almost parallel lines cross, the places have few digits.
            if let Some((before, at_before)) = last
                && at_before.to_f64().abs() > MARGIN * NONE
                && (at_c - at_before).to_f64().abs() > MARGIN * rounding
            {
                slope = (at_c - at_before) / (c - before);
            }
            let step = -(at_c / slope);
            let size = step.to_f64().abs();
            last = Some((c, at_c));
            if at_c.to_f64().abs() < 0.01 * NONE || size < SAME_EXACT {
                (a, b) = (c, c);
                break;
            }
            longest *= 0.5;
            c = if size <= longest {
                c + step
            } else {
                (a + b).scaled(0.5)
            };
        }
        let theta = (a + b).scaled(0.5);
        let (_, at_last) = last?;
        // Places on opposite sides of a circle also change their order.
        if at_last.to_f64().abs() > NEAR {
            return None;
        }
        let error = (b - a).to_f64() + exact_error(NONE, slope.to_f64());
        // The orientation is between those at which the order is known.
        let error = error.min((hi - lo).to_f64());
        Some(Moment { theta, error })
    }

    /// The function that vanishes where the three carriers meet, in f64; `None` if a large arc is involved: terms that turn with its radius
    /// leave few digits in f64, and places on it are not known in f64.
    pub(crate) fn rough_polynomial(&self) -> Option<TrigPolynomial> {
        let sheets = &self.geometry.contacts.sheets;
        let three = self.sheets().map(|s| &sheets[s as usize]);
        let flat = three.iter().any(|s| s.is_flat());
        (!flat).then(|| TrigPolynomial::sampled(|turn| concurrency(three.map(|s| s.cycle(turn)))))
    }

    /// The function that vanishes where the three carriers meet, in double-double.
    fn polynomial(&self) -> TrigPolynomial<Exact> {
        let three = self.sheets();
        TrigPolynomial::sampled(|turn| concurrency(three.map(|s| self.geometry.cycle(s, turn))))
    }

    /// The sheet, and the other sheets of both branches.
    fn sheets(&self) -> [u32; 3] {
        [
            self.sheet,
            self.x.other(self.sheet),
            self.y.other(self.sheet),
        ]
    }

    /// The difference of the places of the two branches; on a circle the sine of the angle between them.
    fn gap(&self, theta: f64) -> Dual<1> {
        let turn = Rotation::by(Dual::variable(theta, 0));
        let sheets = &self.geometry.contacts.sheets;
        let f = &sheets[self.sheet as usize];
        let cycle = f.cycle(turn);
        let place = |b: &Branch| {
            let g = &sheets[b.other(self.sheet) as usize];
            let (swapped, root) = (b.second == self.sheet, b.root);
            if let Some((o, _)) = f.close_to(g) {
                let about = |s: &Sheet| s.locus.about(&o).carrier.lift().cycle(turn);
                return about(f).root(&about(g), root, swapped);
            }
            cycle.root(&g.cycle(turn), root, swapped)
        };
        let (p, q) = (place(self.x), place(self.y));
        if f.is_circle() {
            p.cross(q) * Dual::constant(1.0 / f.locus.carrier.radius.abs())
        } else {
            p.x - q.x
        }
    }

    /// The root in an interval that contains one, by Newton's method within a bracket; `None` if the two branches are apart there.
    fn refine(&self, f: &TrigPolynomial, mut lo: f64, mut hi: f64) -> Option<Event> {
        /// Length of a step below which it is rounding, radians.
        const SAME: f64 = 1e-15;
        /// Error of a root from rounding of the orientation and from the last step, radians.
        const ROOT_ERROR: f64 = 8.0 * SAME;
        let at_lo = f.at(lo).0;
        let mut theta = 0.5 * (lo + hi);
        // The bracket is halved where a step leaves it or does not shorten it enough.
        let mut width = hi - lo;
        for _ in 0..100 {
            let (value, slope) = f.at(theta);
            if (value > 0.0) == (at_lo > 0.0) {
                lo = theta;
            } else {
                hi = theta;
            }
            let next = theta - value / slope;
            let step = (next - theta).abs();
            let good = lo < next && next < hi && step <= 0.5 * width;
            let next = if good { next } else { 0.5 * (lo + hi) };
            width = if good { step } else { hi - lo };
            if width <= SAME || value == 0.0 {
                break;
            }
            theta = next;
        }
        let d = self.gap(theta);
        // Accuracy of the root, and of the places there: for lines that are nearly parallel, places move fast.
        let off = f.error() / f.at(theta).1.abs() + ROOT_ERROR;
        let near = d.value.abs() <= NEAR + off * d.slope[0].abs();
        (near || d.value.is_nan()).then(|| event(theta, d.value, d.slope[0]))
    }
}

/// Distance of branches (length), where their order changes, above which they are not the crossings that meet.
const NEAR: f64 = 1e-4;

/// Length of a step below which it is rounding in double-double, radians.
const SAME_EXACT: f64 = 1e-30;

/// Maximum number of steps towards a meeting.
const MOST_STEPS: usize = 200;

/// Error of a root of a function, given the error of the function and its slope there.
fn exact_error(error: f64, slope: f64) -> f64 {
    error / slope.abs().max(f64::MIN_POSITIVE) + SAME_EXACT
}

/// A meeting at an orientation at which the places of two branches still differ by `off`, and their difference changes by
/// `slope` per radian.
fn event(theta: f64, off: f64, slope: f64) -> Event {
    /// Rounding of a place, in the pair's frame.
    const PLACE_ERROR: f64 = 64.0 * f64::EPSILON;
    /// Largest error that is reported, radians.
    const LARGEST_ERROR: f64 = 1e-9;
    let error = (off.abs() + PLACE_ERROR) / slope.abs().max(f64::MIN_POSITIVE);
    let error = if error.is_nan() {
        LARGEST_ERROR
    } else {
        error.min(LARGEST_ERROR)
    };
    Event {
        theta,
        error: error + 4.0 * f64::EPSILON,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
