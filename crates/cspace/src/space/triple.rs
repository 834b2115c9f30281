//! Orientations at which three sheets meet: two branches on a sheet pass each other.
//!
//! Along a sheet f the branches with g and with h are smooth functions of θ; where the difference of their places
//! vanishes, the three meet. Enclosures of the difference and of its derivative isolate every root: a piece of the
//! interval holds none if the difference has a sign, at most one if the derivative has; otherwise it is halved.

use std::collections::BTreeMap;

use rayon::prelude::*;

use crate::contact::{Geometry, place_on, wrap};
use crate::feature::tolerance::NARROWEST_BAND;
use crate::geometry::Vector;
use crate::number::{Ball, Event, Jet, Real};

use super::branch::Branch;
use super::clusters::Clusters;
use super::gaps::Gaps;

/// Pieces narrower than this are not halved further (radians).
///
/// Two roots within such a piece leave the order as it was; between them the places differ by no more than
/// h² |d″| / 8, some 1e-17, which is below rounding.
const NARROWEST: f64 = 1e-8;

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
    on_sheet: &OnSheet,
    clusters: &Clusters,
) -> Vec<(u32, Event)> {
    (0..geometry.contacts.sheets.len() as u32)
        .into_par_iter()
        .flat_map_iter(|sheet| {
            let mut search = Search {
                geometry,
                branches,
                clusters,
                sheet,
                dead: Gaps::dead_ends(geometry, sheet),
                known: BTreeMap::new(),
                ranges: BTreeMap::new(),
                events: Vec::new(),
            };
            search.run(on_sheet.of(sheet));
            search.events
        })
        .collect()
}

/// The search on one sheet.
struct Search<'a> {
    geometry: &'a Geometry,
    branches: &'a [Branch],
    clusters: &'a Clusters,
    sheet: u32,
    dead: (bool, bool),
    /// Orientations at which two branches pass each other, for pairs already looked at.
    known: BTreeMap<(u32, u32), Vec<Event>>,
    /// Where branches are on the sheet, by slots of orientation.
    ranges: BTreeMap<(u32, i32), Ball>,
    events: Vec<(u32, Event)>,
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
        let mut active = Vec::new();
        for w in times.windows(2) {
            active.clear();
            active.extend(list.iter().copied().filter(|&b| {
                let b = &self.branches[b as usize];
                b.from <= w[0] && b.to >= w[1]
            }));
            if active.len() > 1 {
                self.slab(&active, self.clusters.hi(w[0]), self.clusters.lo(w[1]));
            }
        }
    }

    /// Looks at an interval in which the same branches exist, and again at its pieces if some pass each other.
    fn slab(&mut self, active: &[u32], lo: f64, hi: f64) {
        let gaps = Gaps::new(
            self.geometry,
            self.branches,
            self.sheet,
            active,
            0.5 * (lo + hi),
            self.dead,
        );
        let mut cuts: Vec<Event> = Vec::new();
        for (n, &(_, i)) in gaps.order.iter().enumerate() {
            for (m, &(_, j)) in gaps.order.iter().enumerate().skip(n + 1) {
                if gaps.passing_matters(n, m) {
                    let found = self.passings(i.min(j), i.max(j));
                    cuts.extend(
                        found
                            .iter()
                            .filter(|e| lo < e.theta - e.error && e.theta + e.error < hi),
                    );
                }
            }
        }
        if cuts.is_empty() {
            return;
        }
        cuts.sort_by(|a, b| a.theta.total_cmp(&b.theta));
        let mut from = lo;
        for c in cuts {
            if c.theta - c.error - from > NARROWEST_BAND {
                self.slab(active, from, c.theta - c.error);
            }
            from = from.max(c.theta + c.error);
        }
        if hi - from > NARROWEST_BAND {
            self.slab(active, from, hi);
        }
    }

    /// Whether the ranges of two branches on the sheet meet in a slot of orientation.
    fn may_meet(&mut self, i: u32, j: u32, slot: i32) -> bool {
        let (x, y) = (self.range(i, slot), self.range(j, slot));
        let apart = if self.geometry.contacts.sheets[self.sheet as usize].is_circle() {
            wrap(x.mid - y.mid)
        } else {
            x.mid - y.mid
        };
        // Not with the operator the other way round: an unbounded range may meet any other.
        !(apart.abs() > x.radius + y.radius)
    }

    /// The places of a branch in a slot: on a line from the start of the curve, on a circle the direction from its
    /// centre.
    fn range(&mut self, branch: u32, slot: i32) -> Ball {
        if let Some(&known) = self.ranges.get(&(branch, slot)) {
            return known;
        }
        let b = &self.branches[branch as usize];
        let lo = self.clusters.hi(b.from).max(f64::from(slot) * SLOT);
        let hi = self.clusters.lo(b.to).min(f64::from(slot + 1) * SLOT);
        let range = place_range(self.geometry, self.sheet, b, lo, hi);
        self.ranges.insert((branch, slot), range);
        range
    }

    fn passings(&mut self, i: u32, j: u32) -> Vec<Event> {
        if let Some(found) = self.known.get(&(i, j)) {
            return found.clone();
        }
        let (x, y) = (&self.branches[i as usize], &self.branches[j as usize]);
        let (from, to) = (x.from.max(y.from), x.to.min(y.to));
        let mut found = Vec::new();
        if x.other(self.sheet) != y.other(self.sheet) {
            let (lo, hi) = (self.clusters.hi(from), self.clusters.lo(to));
            let pair = Passing {
                geometry: self.geometry,
                sheet: self.sheet,
                x,
                y,
            };
            for slot in (lo / SLOT).floor() as i32..=(hi / SLOT).floor() as i32 {
                if self.may_meet(i, j, slot) {
                    let (lo, hi) = (
                        lo.max(f64::from(slot) * SLOT),
                        hi.min(f64::from(slot + 1) * SLOT),
                    );
                    pair.isolate(lo, hi, &mut |e| found.push(e));
                }
            }
        }
        self.events.extend(found.iter().map(|&e| (self.sheet, e)));
        self.known.insert((i, j), found.clone());
        found
    }
}

/// Width of the slots in which branches are first told apart, radians.
const SLOT: f64 = core::f64::consts::PI / 90.0;

/// Encloses the places of a branch on a sheet over an interval of orientation.
fn place_range(geometry: &Geometry, sheet: u32, b: &Branch, lo: f64, hi: f64) -> Ball {
    let sheets = &geometry.contacts.sheets;
    let (f, g) = (&sheets[sheet as usize], &sheets[b.other(sheet) as usize]);
    let swapped = b.second == sheet;
    let (cos, sin) = Jet::cos_sin(Ball::between(lo, hi));
    let over = place_on(&f.carrier(cos, sin), &g.carrier(cos, sin), b.root, swapped);
    let (cos, sin) = Ball::constant(0.5 * (lo + hi)).cos_sin();
    let mid = place_on(&f.carrier(cos, sin), &g.carrier(cos, sin), b.root, swapped);
    let tighter = |over: Jet, mid: Ball| {
        let reach = mid.radius + (over.slope.mid.abs() + over.slope.radius) * 0.5 * (hi - lo);
        if reach < over.value.radius {
            Ball::new(mid.mid, reach)
        } else {
            over.value
        }
    };
    let x = tighter(over.0, mid.0);
    if !f.is_circle() {
        return x;
    }
    let y = tighter(over.1, mid.1);
    let v = Vector::new(x.mid, y.mid);
    let sine = x.radius.hypot(y.radius) / v.length();
    // Rounding of the angle is far below this.
    const ROUNDING: f64 = 1e-12;
    let half = if sine < 1.0 {
        sine.asin() + ROUNDING
    } else {
        f64::INFINITY
    };
    Ball::new(v.angle(), half)
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
    fn difference<T: Real>(&self, cos: T, sin: T) -> (T, Option<T>) {
        let sheets = &self.geometry.contacts.sheets;
        let f = &sheets[self.sheet as usize];
        let carrier = f.carrier(cos, sin);
        let place = |b: &Branch| {
            let g = sheets[b.other(self.sheet) as usize].carrier(cos, sin);
            place_on(&carrier, &g, b.root, b.second == self.sheet)
        };
        let (p, q) = (place(self.x), place(self.y));
        if f.is_circle() {
            (p.0 * q.1 - p.1 * q.0, Some(p.0 * q.0 + p.1 * q.1))
        } else {
            (p.0 - q.0, None)
        }
    }

    fn isolate(&self, lo: f64, hi: f64, found: &mut impl FnMut(Event)) {
        let interval = Ball::between(lo, hi);
        let (cos, sin) = Jet::cos_sin(interval);
        let (d, facing) = self.difference(cos, sin);
        // On a circle the sine also vanishes half a turn apart; there the cosine is negative.
        if d.value.sign() != 0 || facing.is_some_and(|c| c.value.sign() < 0) {
            return;
        }
        let mid = 0.5 * (lo + hi);
        // About the middle: d(θ) is within |slope| h of d(mid).
        let (cos, sin) = Ball::constant(mid).cos_sin();
        let at_mid = self.difference(cos, sin).0;
        let reach = (d.slope.mid.abs() + d.slope.radius) * 0.5 * (hi - lo);
        if Ball::new(at_mid.mid, at_mid.radius + reach).sign() != 0 {
            return;
        }
        if d.slope.sign() != 0 {
            if self.sign_at(lo) * self.sign_at(hi) <= 0.0 {
                found(self.root_between(lo, hi, d.slope));
            }
        } else if hi - lo < NARROWEST {
            if self.sign_at(lo) * self.sign_at(hi) <= 0.0 {
                found(self.root_between(lo, hi, Ball::constant(1.0)));
            }
        } else {
            self.isolate(lo, mid, found);
            self.isolate(mid, hi, found);
        }
    }

    fn sign_at(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let d = self.difference::<f64>(cos, sin).0;
        if d.is_nan() { 0.0 } else { d }
    }

    /// The root in an interval on which the derivative does not vanish, by bisection with regula falsi.
    fn root_between(&self, mut lo: f64, mut hi: f64, slope: Ball) -> Event {
        let (mut at_lo, mut at_hi) = (self.sign_at(lo), self.sign_at(hi));
        let steepness = (slope.mid.abs() - slope.radius).max(f64::MIN_POSITIVE);
        for step in 0..200 {
            if hi - lo <= 4.0 * f64::EPSILON * (1.0 + lo.abs()) {
                break;
            }
            let secant = lo - at_lo * (hi - lo) / (at_hi - at_lo);
            let mid = if step % 3 == 2 || !(lo < secant && secant < hi) {
                0.5 * (lo + hi)
            } else {
                secant
            };
            let d = self.sign_at(mid);
            if d == 0.0 {
                (lo, hi) = (mid, mid);
            } else if (d > 0.0) == (at_lo > 0.0) {
                (lo, at_lo) = (mid, d);
            } else {
                (hi, at_hi) = (mid, d);
            }
        }
        // The place of a branch is right to a few ulps over the sine of the angle of crossing, which the slope reflects.
        const PLACE_ERROR: f64 = 64.0 * f64::EPSILON;
        const LARGEST_ERROR: f64 = 1e-9;
        let error =
            0.5 * (hi - lo) + (PLACE_ERROR / steepness).min(LARGEST_ERROR) + 4.0 * f64::EPSILON;
        Event {
            theta: 0.5 * (lo + hi),
            error,
        }
    }
}
