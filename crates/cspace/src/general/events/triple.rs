//! Orientations at which three sheets meet: two branches on a sheet pass each other.
//!
//! On every sheet, between two clusters in which the same branches exist, the pairs of branches are examined whose passing could change
//! which gaps bound free space.

use std::collections::HashMap;

use crate::contact::{Exact, Geometry, Orientation};
use crate::grouped::Grouped;
use crate::number::TrigPolynomial;
use crate::parallel;

use crate::general::cells::active::Active;
use crate::general::cells::gaps::Gaps;
use crate::general::events::branch::Branch;
use crate::general::events::clusters::{Clusters, Moment, SAME};
use crate::general::events::meetings::Meetings;
use crate::general::events::passing::{Passing, Sample};
use crate::general::events::placing::Placing;
use crate::general::events::trace::Traced;

/// Width of an interval (radians) below which samples of branches decide which of them pass each other.
const NARROW: f64 = 1e-5;

/// Sheets searched at a time by one thread.
const CHUNK: usize = 32;

/// All orientations at which branches pass each other on a sheet, where this can matter, with the sheet.
pub(crate) fn triple_events(
    geometry: &Geometry,
    traced: &Traced,
    on_sheet: &Grouped,
    clusters: &Clusters,
) -> Triples {
    let branches = &traced.branches;
    let meetings = Meetings::new(geometry, &traced.meetings);
    let found = parallel::chunks(&geometry.contacts.sheets, CHUNK, |first, sheets| {
        let mut all = Triples::default();
        for sheet in (first as u32..).take(sheets.len()) {
            let list = on_sheet.of(sheet);
            // At least two branches are needed.
            if list.len() < 2 {
                continue;
            }
            let mut search = Search {
                geometry,
                branches,
                meetings: &meetings,
                clusters,
                sheet,
                gaps: Gaps::of(geometry, sheet),
                concurrencies: HashMap::new(),
                found: Triples::default(),
            };
            search.run(list);
            all.append(search.found);
        }
        all
    });
    let mut all = Triples::default();
    for f in found {
        all.append(f);
    }
    all.agree();
    all
}

/// An orientation at which branches pass each other on a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TripleEvent {
    pub(crate) sheet: u32,
    /// The sheets of both branches and this one, in ascending order.
    three: [u32; 3],
    pub(crate) event: Moment,
}

/// Events found, and counts of how they were decided.
#[derive(Debug, Default)]
pub(crate) struct Triples {
    pub(crate) events: Vec<TripleEvent>,
    /// Intervals in which two branches may pass each other.
    pub(crate) isolated: u64,
    /// Parts of these intervals in which the sign of the polynomial cannot be determined.
    pub(crate) by_places: u64,
}

impl Triples {
    fn append(&mut self, other: Self) {
        self.events.extend(other.events);
        self.isolated += other.isolated;
        self.by_places += other.by_places;
    }

    /// Unifies events of the same three sheets: where three sheets meet, branches pass each other on each of them. Each event is extended
    /// to cover those found on the others, which differ by more than their own rounding where the sheets are almost tangent.
    fn agree(&mut self) {
        /// Distance (radians) below which meetings of the same three sheets are one.
        const SAME_MEETING: f64 = 1e-20;
        let order = |a: &TripleEvent, b: &TripleEvent| {
            (a.three.cmp(&b.three))
                .then(a.event.theta.total_cmp(&b.event.theta))
                .then(a.sheet.cmp(&b.sheet))
        };
        parallel::sort_unstable_by(&mut self.events, order);
        let same = |a: &TripleEvent, b: &TripleEvent| {
            a.three == b.three && (b.event.theta - a.event.theta).to_f64() <= SAME_MEETING
        };
        for one in self.events.chunk_by_mut(same) {
            let (lo, hi) = (one[0].event.theta, one[one.len() - 1].event.theta);
            for m in one {
                let e = &mut m.event;
                e.error = (e.error)
                    .max((e.theta - lo).to_f64())
                    .max((hi - e.theta).to_f64());
            }
        }
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
    /// Polynomials, in f64, that vanish where two branches pass each other, by pair of branches. `None` for pairs that never do;
    /// `Some(None)` until computed; `Some(Some(None))` if a large arc is involved, for which f64 decides nothing.
    concurrencies: HashMap<(u32, u32), Option<Option<Option<TrigPolynomial>>>>,
    found: Triples,
}

/// An interval between two clusters in which the same branches exist on the sheet.
struct Window<'w, 'a> {
    active: &'w [u32],
    /// From the beginning of the one cluster to the end of the other.
    lo: Exact,
    hi: Exact,
    /// For every two of its branches, by their indices, the events found: a range of the list of events.
    found: Vec<Option<(u32, u32)>>,
    /// Samples of branches in a narrow window: for each one requested, if it can be sampled.
    samples: Vec<Option<Option<Sample>>>,
    /// Placings of the sheet at the beginning, in the middle and at the end of a narrow window.
    placings: Option<[Placing<'a, Exact>; 3]>,
}

impl<'a> Search<'a> {
    fn run(&mut self, list: &[u32]) {
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
                let (lo, hi) = self.clusters.exactly_between(w[0], w[1]);
                let mut window = Window {
                    active,
                    lo: self.clusters.exact_ends(w[0]).0,
                    hi: self.clusters.exact_ends(w[1]).1,
                    found: core::mem::take(&mut found),
                    samples: vec![None; active.len()],
                    placings: None,
                };
                self.slab(&mut window, lo, hi);
                found = window.found;
            }
        }
    }

    /// Searches a part of a window, and recursively its pieces if some branches pass each other.
    fn slab(&mut self, window: &mut Window<'_, 'a>, lo: Exact, hi: Exact) {
        let mut gaps = core::mem::take(&mut self.gaps);
        gaps.arrange(
            self.geometry,
            self.branches,
            self.sheet,
            window.active,
            (lo + hi).scaled(0.5),
        );
        let mut cuts: Vec<Moment> = Vec::new();
        for n in 0..gaps.branches() {
            for m in n + 1..gaps.branches() {
                if gaps.passing_matters(n, m) {
                    let (i, j) = (gaps.branch(n), gaps.branch(m));
                    let (from, to) = self.passings(window, i.min(j), i.max(j));
                    cuts.extend(
                        self.found.events[from as usize..to as usize]
                            .iter()
                            .map(|m| m.event)
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
            let (until, beyond) = (c.theta - c.error, c.theta + c.error);
            if (until - from).to_f64() > SAME {
                self.slab(window, from, until);
            }
            if beyond > from {
                from = beyond;
            }
        }
        if (hi - from).to_f64() > SAME {
            self.slab(window, from, hi);
        }
    }

    /// Samples a branch of a narrow window, given by its index there, at the window's beginning, middle and end.
    fn sample(&self, window: &mut Window<'_, 'a>, index: usize, b: &Branch) -> Option<Sample> {
        let (lo, hi) = (window.lo, window.hi);
        let length = (hi - lo).to_f64();
        if length >= NARROW {
            return None;
        }
        let (geometry, sheet) = (self.geometry, self.sheet);
        let placings = window.placings.get_or_insert_with(|| {
            [lo, (lo + hi).scaled(0.5), hi]
                .map(|theta| Placing::new(geometry, sheet, Orientation::by(theta)))
        });
        *window.samples[index]
            .get_or_insert_with(|| Sample::new(geometry, sheet, placings, b, length))
    }

    /// The events at which two branches of a window, given by their order, pass each other in it.
    fn passings(&mut self, window: &mut Window<'_, 'a>, i: u32, j: u32) -> (u32, u32) {
        let (active, size) = (window.active, window.active.len());
        let index = |b: u32| active.partition_point(|&a| a < b);
        let slot = index(i) * size + index(j);
        if let Some(range) = window.found[slot] {
            return range;
        }
        let (x, y) = (&self.branches[i as usize], &self.branches[j as usize]);
        let sheet = self.sheet;
        let (meetings, from) = (self.meetings, self.found.events.len() as u32);
        let known = self.concurrencies.entry((i, j)).or_insert_with(|| {
            let (from, to) = (x.from.max(y.from), x.to.min(y.to));
            let (f, g) = (x.other(sheet), y.other(sheet));
            meetings.may_meet(f, g, from, to).then_some(None)
        });
        if known.is_some() {
            let (lo, hi) = (window.lo, window.hi);
            let samples = [(index(i), x), (index(j), y)].map(|(k, b)| self.sample(window, k, b));
            let pair = Passing {
                geometry: self.geometry,
                sheet,
                x,
                y,
            };
            let found = &mut self.found;
            let events = &mut found.events;
            let mut three = [sheet, x.other(sheet), y.other(sheet)];
            three.sort_unstable();
            let mut take = |event: Moment| {
                if lo <= event.theta && event.theta <= hi {
                    events.push(TripleEvent {
                        sheet,
                        three,
                        event,
                    });
                }
            };
            let told = match &samples {
                [Some(x), Some(y)] => pair.told_by([x, y], lo, hi, &mut take),
                _ => false,
            };
            if !told && let Some(Some(f)) = self.concurrencies.get_mut(&(i, j)) {
                let f = f.get_or_insert_with(|| pair.rough_polynomial());
                found.by_places += pair.isolate(f.as_ref(), lo, hi, &mut take);
            }
            found.isolated += 1;
        }
        let found = &self.found;
        let range = (from, found.events.len() as u32);
        window.found[slot] = Some(range);
        range
    }
}
