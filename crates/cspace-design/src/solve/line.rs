//! One parameter: where a quantity crosses a value, touches it, or is it over a stretch, between places at which it is known.

use super::problem::{At, Problem};

/// Solutions, breaks and jumps found along one parameter.
#[derive(Debug, Clone, Default)]
pub(super) struct Found {
    /// Where the quantity is the value: from one place to another, which may be the same.
    pub(super) stretches: Vec<(f64, f64)>,
    /// Where it begins or ends to be measurable, jumps over the value, or changes from yes to no.
    pub(super) breaks: Vec<f64>,
    /// Jumps over the value: where, and how far off it is before and after.
    pub(super) jumps: Vec<(f64, f64, f64)>,
    /// Where it changes its kind so often that not all changes were looked for.
    pub(super) left: Vec<(f64, f64)>,
}

/// Changes of kind between two samples, after which no more are looked for.
const MOST_BREAKS: usize = 64;

impl Found {
    /// Makes one of stretches that follow each other, and places of those that are narrower.
    pub(super) fn join(&mut self, place: f64) {
        self.stretches.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut joined: Vec<(f64, f64)> = Vec::new();
        for &(lo, hi) in &self.stretches {
            match joined.last_mut() {
                Some(last) if lo <= last.1 + place => last.1 = last.1.max(hi),
                _ => joined.push((lo, hi)),
            }
        }
        self.stretches = joined;
        for stretch in &mut self.stretches {
            if stretch.1 - stretch.0 <= 2.0 * place {
                let middle = 0.5 * (stretch.0 + stretch.1);
                *stretch = (middle, middle);
            }
        }
    }
}

pub(super) struct Line<'a> {
    pub(super) problem: &'a Problem<'a>,
    /// Intervals as wide as this are not divided.
    pub(super) least: f64,
    /// A quantity that is the value over less than this is so at one place.
    pub(super) place: f64,
    /// A quantity that is off by less is the value.
    pub(super) zero: f64,
}

impl Line<'_> {
    fn at(&self, p: f64) -> At {
        self.problem.at(&[p])
    }

    /// Searches between two values at which the quantity is known.
    pub(super) fn search(&self, a: &(f64, At), b: &(f64, At), found: &mut Found) {
        match (&a.1, &b.1) {
            (At::Off(f, s), At::Off(g, t)) => match (self.sign(*f), self.sign(*g)) {
                (0, 0) => found.stretches.push((a.0, b.0)),
                (0, _) => {
                    let (last, beyond) = self.end(a, b);
                    found.stretches.push((a.0, last.0));
                    self.search(&beyond, b, found);
                }
                (_, 0) => {
                    let (last, beyond) = self.end(b, a);
                    found.stretches.push((last.0, b.0));
                    self.search(a, &beyond, found);
                }
                (above, below) if above != below => self.crossing(a, b, found),
                _ if comes_nearer(*f, s[0][1], *g, t[0][0]) => {
                    self.dip(a.clone(), b.clone(), found);
                }
                _ => {}
            },
            (At::Is(f), At::Is(g)) if f == g => {}
            (At::None(_), At::None(_)) | (At::Undecided(_), At::Undecided(_)) => {}
            // What is so at both ends changes between: on both sides of the change the search goes on.
            _ => {
                let (near_a, near_b) = self.change(a.clone(), b.clone());
                found.breaks.push(0.5 * (near_a.0 + near_b.0));
                for (a, b) in [(a, &near_a), (&near_b, b)] {
                    if found.breaks.len() > MOST_BREAKS {
                        found.left.push((a.0, b.0));
                    } else if a.0 < b.0 {
                        self.search(a, b, found);
                    }
                }
            }
        }
    }

    fn sign(&self, off: f64) -> i8 {
        match off {
            _ if off.abs() <= self.zero => 0,
            _ if off > 0.0 => 1,
            _ => -1,
        }
    }

    fn is_zero(&self, at: &At) -> bool {
        matches!(at, At::Off(off, _) if self.sign(*off) == 0)
    }

    /// From a place where the quantity is the value towards one where it is not: the last place where it is, and one beyond.
    fn end(&self, from: &(f64, At), to: &(f64, At)) -> ((f64, At), (f64, At)) {
        let way = (to.0 - from.0).signum();
        let near = from.0 + way * self.place.min(0.5 * (to.0 - from.0).abs());
        let at = self.at(near);
        let (mut last, mut beyond) = if self.is_zero(&at) {
            ((near, at), to.clone())
        } else {
            return (from.clone(), (near, at));
        };
        while (beyond.0 - last.0).abs() > self.least {
            let p = 0.5 * (last.0 + beyond.0);
            if p == last.0 || p == beyond.0 {
                break;
            }
            let at = self.at(p);
            if self.is_zero(&at) {
                last = (p, at);
            } else {
                beyond = (p, at);
            }
        }
        (last, beyond)
    }

    /// Two places next to each other between which what is known changes its kind.
    fn change(&self, mut a: (f64, At), mut b: (f64, At)) -> ((f64, At), (f64, At)) {
        while b.0 - a.0 > self.least {
            let p = 0.5 * (a.0 + b.0);
            if p <= a.0 || p >= b.0 {
                break;
            }
            let at = self.at(p);
            if is_alike(&at, &a.1) {
                a = (p, at);
            } else {
                b = (p, at);
            }
        }
        (a, b)
    }

    /// Where a quantity crosses the value between two places on both sides of it: by Newton's method within a bracket, halving
    /// where a step leaves it or does not shorten it.
    fn crossing(&self, a: &(f64, At), b: &(f64, At), found: &mut Found) {
        /// The error of a quantity, relative to how far off it is at the ends.
        const ROUNDING: f64 = 1e-12;
        /// A quantity that is not so many times as steep as an even one has no jump.
        const STEEPER: f64 = 1e3;
        let (mut lo, mut hi) = (a.clone(), b.clone());
        let off = |at: &At| match at {
            At::Off(off, _) => *off,
            _ => f64::NAN,
        };
        let scale = off(&a.1).abs().max(off(&b.1).abs());
        let mut from = lo.clone();
        let mut width = hi.0 - lo.0;
        while hi.0 - lo.0 > self.least {
            let newton = match &from.1 {
                At::Off(off, slopes) => {
                    let is_lower = from.0 == lo.0;
                    from.0 - off / slopes[0][usize::from(is_lower)]
                }
                _ => f64::NAN,
            };
            let middle = 0.5 * (lo.0 + hi.0);
            // A little beyond the root, so that the bracket closes from both sides.
            let beyond = newton + 0.25 * self.least * (middle - newton).signum();
            let good = lo.0 < beyond && beyond < hi.0 && (beyond - from.0).abs() <= 0.5 * width;
            let p = if good { beyond } else { middle };
            width = if good {
                (p - from.0).abs()
            } else {
                hi.0 - lo.0
            };
            if p <= lo.0 || p >= hi.0 {
                break;
            }
            let at = self.at(p);
            match &at {
                At::Off(..) if !self.is_zero(&at) => {}
                // What has no value on the way is a break; where it is the value, it may be so over a stretch.
                _ => {
                    let here = (p, at);
                    self.search(a, &here, found);
                    self.search(&here, b, found);
                    return;
                }
            }
            from = (p, at.clone());
            if (off(&at) < 0.0) == (off(&lo.1) < 0.0) {
                lo = (p, at);
            } else {
                hi = (p, at);
            }
        }
        let (f, g) = (off(&lo.1), off(&hi.1));
        let slope = [&lo.1, &hi.1].map(|at| match at {
            At::Off(_, s) => s[0]
                .into_iter()
                .map(f64::abs)
                .filter(|s| s.is_finite())
                .fold(0.0, f64::max),
            _ => 0.0,
        });
        let steep = slope[0].max(slope[1]) * (hi.0 - lo.0);
        // Of a quantity without derivatives what it changes from end to end says how steep it is.
        let even = scale * (hi.0 - lo.0) / (b.0 - a.0);
        if (g - f).abs() <= 16.0 * steep + STEEPER * even + ROUNDING * scale.max(1.0) {
            let p = lo.0 - f * (hi.0 - lo.0) / (g - f);
            let p = p.clamp(lo.0, hi.0);
            found.stretches.push((p, p));
        } else {
            found.breaks.push(0.5 * (lo.0 + hi.0));
            found.jumps.push((0.5 * (lo.0 + hi.0), f, g));
        }
    }

    /// Where a quantity comes nearest to the value between two places on one side of it: by the sign of its derivative. Where it
    /// crosses the value there, both crossings are found.
    fn dip(&self, mut a: (f64, At), mut b: (f64, At), found: &mut Found) {
        /// Where the quantity is nearer than this to the value, relative to how far off it is at the ends, it touches it.
        const TOUCHES: f64 = 1e-12;
        let (from, to) = (a.clone(), b.clone());
        let mut scale = 0.0_f64;
        while b.0 - a.0 > self.least {
            let (At::Off(f, _), At::Off(g, _)) = (&a.1, &b.1) else {
                return;
            };
            scale = scale.max(f.abs()).max(g.abs());
            let p = 0.5 * (a.0 + b.0);
            if p <= a.0 || p >= b.0 {
                break;
            }
            let at = self.at(p);
            let At::Off(off, slopes) = &at else {
                let here = (p, at);
                self.search(&from, &here, found);
                self.search(&here, &to, found);
                return;
            };
            let (off, [below, above]) = (*off, slopes[0]);
            if self.sign(off) != self.sign(*f) {
                let here = (p, at);
                self.search(&from, &here, found);
                self.search(&here, &to, found);
                return;
            }
            if below.is_nan() || above.is_nan() {
                let here = self.least_of(a, b);
                a = here.clone();
                b = here;
                break;
            }
            if below * off < 0.0 && above * off > 0.0 {
                // A kink is the nearest place.
                (a, b) = ((p, at.clone()), (p, at));
                break;
            }
            if above * off < 0.0 {
                a = (p, at);
            } else {
                b = (p, at);
            }
        }
        if let At::Off(off, slopes) = &a.1 {
            let steep = slopes[0].into_iter().map(f64::abs).fold(0.0, f64::max);
            // At a corner without derivatives what it changes towards it says how steep it is.
            let even = scale / (to.0 - from.0);
            if off.abs() <= TOUCHES * scale + 16.0 * steep.max(even) * self.least {
                found.stretches.push((a.0, b.0));
            }
        }
    }
}

impl Line<'_> {
    /// Where a quantity is nearest to the value between two places, by values alone: golden sections.
    fn least_of(&self, mut a: (f64, At), mut b: (f64, At)) -> (f64, At) {
        /// Share of an interval that is left by each step.
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let far = |at: &At| match at {
            At::Off(off, _) => off.abs(),
            _ => f64::INFINITY,
        };
        let between = |a: &(f64, At), b: &(f64, At), share: f64| {
            let p = a.0 + share * (b.0 - a.0);
            (p, self.at(p))
        };
        let mut c = between(&a, &b, 1.0 - GOLDEN);
        let mut d = between(&a, &b, GOLDEN);
        while b.0 - a.0 > self.least {
            if far(&c.1) <= far(&d.1) {
                (b, d) = (d, c);
                c = between(&a, &b, 1.0 - GOLDEN);
            } else {
                (a, c) = (c, d);
                d = between(&a, &b, GOLDEN);
            }
        }
        if far(&c.1) <= far(&d.1) { c } else { d }
    }
}

/// Whether a quantity on one side of a value comes nearer to it from both of two places.
fn comes_nearer(f: f64, slope_f: f64, g: f64, slope_g: f64) -> bool {
    f * slope_f < 0.0 && g * slope_g > 0.0
}

/// Whether two are of one kind.
fn is_alike(a: &At, b: &At) -> bool {
    match (a, b) {
        (At::Is(a), At::Is(b)) => a == b,
        _ => core::mem::discriminant(a) == core::mem::discriminant(b),
    }
}
