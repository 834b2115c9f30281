//! Orientations at which three sheets meet: two branches on a sheet pass each other.
//!
//! Where three carriers meet, a trigonometric polynomial of degree four vanishes, whichever of their crossings meet. It
//! is smooth where places are not (at tangencies), and its roots are isolated with a bound on its second derivative.
//! At each root the places of the two branches tell whether it is they that pass each other.

use std::collections::HashMap;

use rayon::prelude::*;

use crate::contact::{Carrier, Geometry, place_on};
use crate::feature::tolerance::NARROWEST_BAND;
use crate::geometry::Vector;
use crate::number::{Ball, Dual, Event, Jet, Real, TrigPolynomial};

use super::active::Active;
use super::branch::{Branch, Encounter};
use super::clusters::Clusters;
use super::gaps::Gaps;

/// Pieces narrower than this are not halved further (radians).
///
/// Two roots within such a piece leave the order as it was; between them the places differ by no more than
/// h² |d″| / 8, some 1e-17, which is below rounding.
const NARROWEST: f64 = 1e-8;

/// How many pieces are looked at where three carriers always share a point, before places count as told apart as far
/// as they can be.
const PLACE_BUDGET: u32 = 2000;

/// The branches on every sheet, as indices; the branches of sheet i are `list[first[i]..first[i + 1]]`.
#[derive(Debug)]
pub(super) struct OnSheet {
    first: Vec<u32>,
    list: Vec<u32>,
}

impl OnSheet {
    pub(super) fn new(sheets: usize, branches: &[Branch]) -> Self {
        let mut first = vec![0u32; sheets + 1];
        for b in branches {
            first[b.first as usize + 1] += 1;
            first[b.second as usize + 1] += 1;
        }
        for i in 0..sheets {
            first[i + 1] += first[i];
        }
        let mut at = first.clone();
        let mut list = vec![0; 2 * branches.len()];
        for (i, b) in (0u32..).zip(branches) {
            for sheet in [b.first, b.second] {
                let slot = &mut at[sheet as usize];
                list[*slot as usize] = i;
                *slot += 1;
            }
        }
        Self { first, list }
    }

    pub(super) fn of(&self, sheet: u32) -> &[u32] {
        &self.list[self.first[sheet as usize] as usize..self.first[sheet as usize + 1] as usize]
    }
}

/// All orientations at which branches pass each other on a sheet where that can matter, with the sheet.
pub(super) fn triple_events(
    geometry: &Geometry,
    branches: &[Branch],
    encounters: &[Encounter],
    on_sheet: &OnSheet,
    clusters: &Clusters,
) -> Vec<(u32, Event)> {
    let meetings = Meetings::new(geometry, encounters);
    (0..geometry.contacts.sheets.len() as u32)
        .into_par_iter()
        .flat_map_iter(|sheet| {
            let mut search = Search {
                geometry,
                branches,
                meetings: &meetings,
                clusters,
                sheet,
                gaps: Gaps::of(geometry, sheet),
                concurrencies: HashMap::new(),
                events: Vec::new(),
            };
            search.run(on_sheet.of(sheet));
            search.events
        })
        .collect()
}

/// Which sheets cross or touch, and when.
struct Meetings<'a> {
    geometry: &'a Geometry,
    encounters: &'a [Encounter],
    /// Encounters in which sheet i is the first of the two: `encounters[start[i]..start[i + 1]]`.
    start: Vec<u32>,
}

impl<'a> Meetings<'a> {
    fn new(geometry: &'a Geometry, encounters: &'a [Encounter]) -> Self {
        let mut start = vec![0u32; geometry.contacts.sheets.len() + 1];
        for e in encounters {
            start[e.first as usize + 1] += 1;
        }
        for i in 1..start.len() {
            start[i] += start[i - 1];
        }
        Self {
            geometry,
            encounters,
            start,
        }
    }

    /// Whether two sheets may have a point in common between two clusters: three sheets meet only where every two do.
    ///
    /// Sheets that share an end or a carrier have that in common without crossing.
    fn may_meet(&self, f: u32, g: u32, from: u32, to: u32) -> bool {
        if f == g {
            return false;
        }
        let (first, second) = (f.min(g), f.max(g));
        let range = self.start[first as usize] as usize..self.start[first as usize + 1] as usize;
        let mine = &self.encounters[range];
        let at = mine.partition_point(|e| e.second < second);
        let encountered = mine[at..]
            .iter()
            .take_while(|e| e.second == second)
            .any(|e| e.from <= to && from <= e.to);
        if encountered {
            return true;
        }
        let contacts = &self.geometry.contacts;
        let shared = contacts.sheets[f as usize]
            .shared_ends(&contacts.sheets[g as usize], contacts.first_vertex_name);
        shared.tangent || shared.corners.iter().any(Option::is_some)
    }
}

/// The search on one sheet.
struct Search<'a> {
    geometry: &'a Geometry,
    branches: &'a [Branch],
    meetings: &'a Meetings<'a>,
    clusters: &'a Clusters,
    sheet: u32,
    gaps: Gaps,
    /// What vanishes where two branches pass each other, for pairs already looked at; `None` for pairs that never do.
    concurrencies: HashMap<(u32, u32), Option<TrigPolynomial>>,
    events: Vec<(u32, Event)>,
}

/// An interval between two clusters in which the same branches exist on the sheet.
struct Window<'a> {
    active: &'a [u32],
    lo: f64,
    hi: f64,
    /// For every two of its branches, by their indices, the events found: a range of the list of events.
    found: Vec<Option<(u32, u32)>>,
}

impl Search<'_> {
    fn run(&mut self, list: &[u32]) {
        if list.len() < 2 {
            return;
        }
        let mut times: Vec<u32> = list
            .iter()
            .flat_map(|&b| [self.branches[b as usize].from, self.branches[b as usize].to])
            .collect();
        times.sort_unstable();
        times.dedup();
        let mut all = Active::new(self.branches, list);
        let mut found = Vec::new();
        for w in times.windows(2) {
            let active = all.after(w[0]);
            if active.len() > 1 {
                found.clear();
                found.resize(active.len() * active.len(), None);
                let mut window = Window {
                    active,
                    lo: self.clusters.hi(w[0]),
                    hi: self.clusters.lo(w[1]),
                    found: core::mem::take(&mut found),
                };
                let (lo, hi) = (window.lo, window.hi);
                self.slab(&mut window, lo, hi);
                found = window.found;
            }
        }
    }

    /// Looks at a part of a window, and again at its pieces if some branches pass each other.
    fn slab(&mut self, window: &mut Window, lo: f64, hi: f64) {
        let mut gaps = core::mem::take(&mut self.gaps);
        gaps.arrange(
            self.geometry,
            self.branches,
            self.sheet,
            window.active,
            0.5 * (lo + hi),
        );
        let mut cuts: Vec<Event> = Vec::new();
        for n in 0..gaps.branches() {
            for m in n + 1..gaps.branches() {
                if gaps.passing_matters(n, m) {
                    let (i, j) = (gaps.branch(n), gaps.branch(m));
                    let (from, to) = self.passings(window, i.min(j), i.max(j));
                    cuts.extend(
                        self.events[from as usize..to as usize]
                            .iter()
                            .map(|e| e.1)
                            .filter(|e| lo < e.theta - e.error && e.theta + e.error < hi),
                    );
                }
            }
        }
        self.gaps = gaps;
        if cuts.is_empty() {
            return;
        }
        cuts.sort_by(|a, b| a.theta.total_cmp(&b.theta));
        let mut from = lo;
        for c in cuts {
            if c.theta - c.error - from > NARROWEST_BAND {
                self.slab(window, from, c.theta - c.error);
            }
            from = from.max(c.theta + c.error);
        }
        if hi - from > NARROWEST_BAND {
            self.slab(window, from, hi);
        }
    }

    /// The events at which two branches of a window, given by their order, pass each other in it.
    fn passings(&mut self, window: &mut Window, i: u32, j: u32) -> (u32, u32) {
        let (active, size) = (window.active, window.active.len());
        let index = |b: u32| active.partition_point(|&a| a < b);
        let slot = &mut window.found[index(i) * size + index(j)];
        if let Some(range) = *slot {
            return range;
        }
        let from = self.events.len() as u32;
        let (x, y) = (&self.branches[i as usize], &self.branches[j as usize]);
        let (sheet, events) = (self.sheet, &mut self.events);
        let pair = Passing {
            geometry: self.geometry,
            sheet,
            x,
            y,
        };
        let sheets = &self.geometry.contacts.sheets;
        let known = self.concurrencies.entry((i, j)).or_insert_with(|| {
            let (from, to) = (x.from.max(y.from), x.to.min(y.to));
            let (f, g) = (x.other(sheet), y.other(sheet));
            self.meetings.may_meet(f, g, from, to).then(|| {
                let three = [sheet, f, g].map(|s| &sheets[s as usize]);
                TrigPolynomial::sampled(|cos, sin| concurrency(three.map(|s| s.carrier(cos, sin))))
            })
        });
        if let Some(f) = known {
            pair.isolate(f, window.lo, window.hi, &mut |e| events.push((sheet, e)));
        }
        let range = (from, events.len() as u32);
        *slot = Some(range);
        range
    }
}

/// A function without roots or divisions that vanishes where the three sheets meet.
///
/// With a circle of centre c and radius r among them, and p = c + v: |v| = r, and each of the others is linear in
/// v, a·v = e (a circle by the radical line of the two). So v (a₁ × a₂) = e₁ right(a₂) − e₂ right(a₁), and
/// |e₁ a₂ − e₂ a₁|² = r² (a₁ × a₂)². For three lines n·p = d it is the determinant of the three.
///
/// It is a trigonometric polynomial of degree four at most. Returned with the size of its terms.
fn concurrency(mut three: [Carrier<f64>; 3]) -> (f64, f64) {
    if let Some(circle) = three
        .iter()
        .position(|c| matches!(c, Carrier::Circle { .. }))
    {
        three.swap(0, circle);
    }
    let vector = |v: (f64, f64)| Vector::new(v.0, v.1);
    match three[0] {
        Carrier::Circle { center, radius } => {
            let center = vector(center);
            let linear = |other: &Carrier<f64>| match *other {
                Carrier::Line { normal, through } => {
                    let n = vector(normal);
                    (n, n.dot(vector(through) - center), 1.0)
                }
                Carrier::Circle {
                    center: c,
                    radius: r,
                } => {
                    let a = vector(c) - center;
                    let terms = a.length_squared() + r * r + radius * radius;
                    (
                        a,
                        0.5 * (a.length_squared() - (r - radius) * (r + radius)),
                        terms,
                    )
                }
            };
            let ((a, e, p), (b, g, q)) = (linear(&three[1]), linear(&three[2]));
            let v = b * e - a * g;
            let d = radius * a.cross(b);
            let terms = (b.length() * p + a.length() * q).powi(2)
                + (radius * a.length() * b.length()).powi(2);
            (v.length_squared() - d * d, terms)
        }
        Carrier::Line { .. } => {
            let line = |c: &Carrier<f64>| match *c {
                Carrier::Line { normal, through } => {
                    (vector(normal), vector(normal).dot(vector(through)))
                }
                Carrier::Circle { center, .. } => (vector(center), 0.0),
            };
            let [(l, d), (m, e), (n, g)] = [line(&three[0]), line(&three[1]), line(&three[2])];
            (d * m.cross(n) + e * n.cross(l) + g * l.cross(m), 8.0)
        }
    }
}

/// Two branches on one sheet.
struct Passing<'a> {
    geometry: &'a Geometry,
    sheet: u32,
    x: &'a Branch,
    y: &'a Branch,
}

impl Passing<'_> {
    /// The difference of the places of the two branches; `None` where they cannot meet.
    ///
    /// On a line a difference of lengths; on a circle the sine of the angle from x to y, times the radius squared.
    fn difference<T: Real>(&self, cos: T, sin: T) -> T {
        let sheets = &self.geometry.contacts.sheets;
        let f = &sheets[self.sheet as usize];
        let carrier = f.carrier(cos, sin);
        let place = |b: &Branch| {
            let g = sheets[b.other(self.sheet) as usize].carrier(cos, sin);
            place_on(&carrier, &g, b.root, b.second == self.sheet)
        };
        let (p, q) = (place(self.x), place(self.y));
        if f.is_circle() {
            p.0 * q.1 - p.1 * q.0
        } else {
            p.0 - q.0
        }
    }

    /// Finds every orientation at which the two branches pass each other.
    fn isolate(&self, f: &TrigPolynomial, lo: f64, hi: f64, found: &mut impl FnMut(Event)) {
        let mut vague: Vec<(f64, f64)> = Vec::new();
        f.brackets(
            lo,
            hi,
            NARROWEST,
            &mut |lo, hi| self.refine(f, lo, hi, found),
            &mut |lo, hi| vague.push((lo, hi)),
        );
        for (lo, hi) in vague {
            let mut budget = PLACE_BUDGET;
            self.isolate_places(lo, hi, &mut budget, found);
        }
    }

    /// The same where the three carriers have a point in common at every orientation, so that the polynomial tells
    /// nothing: by enclosures of the difference of the places themselves.
    fn isolate_places(&self, lo: f64, hi: f64, budget: &mut u32, found: &mut impl FnMut(Event)) {
        *budget = budget.saturating_sub(1);
        /// Places are told apart down to this width (radians), or this difference (length, or length times radius).
        const NARROWEST: f64 = 1e-6;
        const SAME_PLACE: f64 = 1e-11;
        let (cos, sin) = Jet::cos_sin(Ball::between(lo, hi));
        let d = self.difference(cos, sin);
        if d.value.sign() != 0 {
            return;
        }
        let mid = 0.5 * (lo + hi);
        let (cos, sin) = Ball::constant(mid).cos_sin();
        let at_mid = self.difference(cos, sin);
        let reach = (d.slope.mid.abs() + d.slope.radius) * 0.5 * (hi - lo);
        if Ball::new(at_mid.mid, at_mid.radius + reach).sign() != 0 {
            return;
        }
        let (at_lo, at_hi) = (self.gap(lo).value, self.gap(hi).value);
        if d.slope.sign() != 0 {
            if at_lo * at_hi <= 0.0 {
                found(self.meeting(lo, hi, at_lo));
            }
        } else if *budget == 0 || hi - lo < NARROWEST || at_mid.mid.abs() + reach < SAME_PLACE {
            if at_lo.abs() > SAME_PLACE && at_hi.abs() > SAME_PLACE && at_lo * at_hi < 0.0 {
                found(self.meeting(lo, hi, at_lo));
            }
        } else {
            self.isolate_places(lo, mid, budget, found);
            self.isolate_places(mid, hi, budget, found);
        }
    }

    /// Where the places of the two branches agree in an interval in which their difference changes sign.
    fn meeting(&self, mut lo: f64, mut hi: f64, at_lo: f64) -> Event {
        /// Rounding of a place, and the largest error reported, radians.
        const PLACE_ERROR: f64 = 64.0 * f64::EPSILON;
        const LARGEST_ERROR: f64 = 1e-9;
        while hi - lo > 4.0 * f64::EPSILON * (1.0 + lo.abs()) {
            let mid = 0.5 * (lo + hi);
            if (self.gap(mid).value > 0.0) == (at_lo > 0.0) {
                lo = mid;
            } else {
                hi = mid;
            }
        }
        let theta = 0.5 * (lo + hi);
        let rest = PLACE_ERROR / self.gap(theta).slope.abs().max(f64::MIN_POSITIVE);
        let error = if rest.is_nan() {
            LARGEST_ERROR
        } else {
            rest.min(LARGEST_ERROR)
        };
        Event {
            theta,
            error: error + 4.0 * f64::EPSILON,
        }
    }

    /// The difference of the places of the two branches, with its derivative.
    fn gap(&self, theta: f64) -> Dual {
        let (sin, cos) = theta.sin_cos();
        let (cos, sin) = (
            Dual {
                value: cos,
                slope: -sin,
            },
            Dual {
                value: sin,
                slope: cos,
            },
        );
        self.difference(cos, sin)
    }

    /// The root in an interval: of the smooth function first, by bisection with the secant; then, if it is these two
    /// branches that meet there and not others of the same sheets, of the difference of their places.
    fn refine(&self, f: &TrigPolynomial, mut lo: f64, mut hi: f64, found: &mut impl FnMut(Event)) {
        /// Branches further apart than this (length, or length times radius) at the root are not those that meet.
        const NEAR: f64 = 1e-4;
        /// Rounding of a place.
        const PLACE_ERROR: f64 = 64.0 * f64::EPSILON;
        /// No root is reported with a larger error, radians.
        const LARGEST_ERROR: f64 = 1e-9;
        /// Steps shorter than this are rounding, radians.
        const SAME: f64 = 1e-15;
        let (first, last) = (lo, hi);
        let at_lo = f.at(lo).0;
        let mut theta = 0.5 * (lo + hi);
        // By Newton's rule, halving the bracket where a step leaves it or does not shorten it enough.
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
        let mut d = self.gap(theta);
        if d.value.abs() > NEAR {
            return;
        }
        for _ in 0..4 {
            let next = theta - d.value / d.slope;
            if !(first..=last).contains(&next) {
                break;
            }
            let at_next = self.gap(next);
            // NaN where the places are lost.
            if at_next.value.is_nan() || at_next.value.abs() >= d.value.abs() {
                break;
            }
            (theta, d) = (next, at_next);
        }
        let rest = (d.value.abs() + PLACE_ERROR) / d.slope.abs().max(f64::MIN_POSITIVE);
        let error = if rest.is_nan() {
            LARGEST_ERROR
        } else {
            rest.min(LARGEST_ERROR)
        };
        found(Event {
            theta,
            error: error + 4.0 * f64::EPSILON,
        });
    }
}
