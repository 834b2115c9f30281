//! Branches: crossings of two sheets, followed over the orientations at which they exist.

use crate::contact::{
    Crossing, ExactTurn, Geometry, SharedEnds, Sheet, Ties, bow_events, conditions, crossing,
    exact_crossings, roots, within_ends,
};
use crate::geometry::Rotation;
use crate::number::Dd;
use crate::parallel;

use super::candidates::PairRun;
use super::clusters::{Clusters, Moment};
use super::pinches::{Pinch, is_passed, pinched, placed};
use super::placing::exact_sheet;

/// One crossing of two sheets from one cluster of events to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Branch {
    pub(super) first: u32,
    pub(super) second: u32,
    pub(super) root: u8,
    /// Whether travel along the first enters the blocked side of the second.
    pub(super) enters: bool,
    pub(super) from: u32,
    pub(super) to: u32,
}

impl Branch {
    /// The sheet that is not `sheet`.
    pub(super) fn other(&self, sheet: u32) -> u32 {
        if self.first == sheet {
            self.second
        } else {
            self.first
        }
    }

    /// Whether travel along `sheet` enters the blocked side of the other.
    pub(super) fn enters(&self, sheet: u32) -> bool {
        (self.first == sheet) == self.enters
    }
}

/// The events of pairs that may cross.
#[derive(Debug, Default)]
pub(super) struct PairEvents {
    pub(super) events: Vec<Moment>,
    /// Events of the carriers, beyond the curves: of several at once it is asked whether the carriers are one.
    beyond: Vec<Moment>,
    /// For every pair how many there are of it and those before, and how many beyond.
    until: Vec<[usize; 2]>,
}

impl PairEvents {
    /// Those of a pair, and those beyond its curves.
    fn of(&self, pair: usize) -> [&[Moment]; 2] {
        let from = (pair.checked_sub(1)).map_or([0; 2], |before| self.until[before]);
        let to = self.until[pair];
        [&self.events[from[0]..to[0]], &self.beyond[from[1]..to[1]]]
    }
}

/// The events of every pair.
pub(super) fn pair_events(geometry: &Geometry, pairs: &[PairRun]) -> PairEvents {
    let contacts = &geometry.contacts;
    let found = parallel::chunks(pairs, CHUNK, |_, runs| {
        let mut found = PairEvents::default();
        let (events, beyond) = (&mut found.events, &mut found.beyond);
        for run in runs {
            let (f, g) = (
                &contacts.sheets[run.first as usize],
                &contacts.sheets[run.second as usize],
            );
            // Pairs that are tangent by their making are not among them.
            let shared = SharedEnds {
                tangent: false,
                corners: f.shared_corners(g, contacts.first_vertex_name),
            };
            let (lo, hi) = (run.lo.to_f64(), run.hi.to_f64());
            let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
            let (sin, cos) = mid.sin_cos();
            let ties = Ties::new(&geometry.fixed, &geometry.moving, f, g);
            if f.is_flat() || g.is_flat() {
                bow_events(f, g, &shared, &ties, (lo, hi), |e| events.push(e.into()));
            } else {
                conditions(f, g, &shared, |t, happening| {
                    let tie = t.touch().and_then(|e| ties.explain(e));
                    t.roots(mid, cos, sin, half, |e| {
                        if !within_ends(f, g, &happening, &t, e) {
                            beyond.push(e.into());
                            return;
                        }
                        let known = tie.filter(|t| t.error < e.error);
                        let event = known.map_or(Some(e), |t| t.within(mid, half));
                        events.extend(event.map(Moment::from));
                    });
                });
            }
            found.until.push([events.len(), beyond.len()]);
        }
        found
    });
    all_of(found)
}

/// Those of several lists of pairs, one after the other.
fn all_of(found: Vec<PairEvents>) -> PairEvents {
    let mut all = PairEvents::default();
    for f in found {
        let before = [all.events.len(), all.beyond.len()];
        all.events.extend(f.events);
        all.beyond.extend(f.beyond);
        all.until
            .extend((f.until.into_iter()).map(|n| [before[0] + n[0], before[1] + n[1]]));
    }
    all
}

impl PairEvents {
    /// These events, those of some pairs in double-double.
    pub(super) fn refined(self, geometry: &Geometry, pairs: &[PairRun], close: &[bool]) -> Self {
        if !close.contains(&true) {
            return self;
        }
        let chunks: Vec<usize> = (0..pairs.len()).step_by(CHUNK).collect();
        let found = parallel::map(&chunks, 1, |&first| {
            let mut found = Self::default();
            for pair in first..(first + CHUNK).min(pairs.len()) {
                let [events, beyond] = self.of(pair);
                if close[pair] {
                    exact_events(geometry, &pairs[pair], |e| found.events.push(e));
                } else {
                    found.events.extend(events);
                    found.beyond.extend(beyond);
                }
                found.until.push([found.events.len(), found.beyond.len()]);
            }
            found
        });
        all_of(found)
    }

    /// For each pair whether one of its events may be at one orientation with another that is not the same.
    pub(super) fn crowded(&self, pairs: usize, otherwise: &[Moment]) -> Vec<bool> {
        /// No pair.
        const NONE: u32 = u32::MAX;
        /// More than an orientation's rounding (radians).
        const ROUNDING: f64 = 1e-15;
        /// Events with a larger error than this are to be known better in any case (radians).
        const ROUGH: f64 = 1e-12;
        let span = |e: &Moment, pair: u32| {
            let theta = e.theta.to_f64();
            let error = e.error + ROUNDING;
            (theta - error, theta + error, theta.to_bits(), pair)
        };
        let mut all: Vec<(f64, f64, u64, u32)> = otherwise.iter().map(|e| span(e, NONE)).collect();
        let mut close = vec![false; pairs];
        for pair in 0..pairs {
            let events = self.of(pair)[0];
            all.extend(events.iter().map(|e| span(e, pair as u32)));
            close[pair] = events.iter().any(|e| e.error > ROUGH);
        }
        parallel::sort_unstable_by(&mut all, |a, b| {
            a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)).then(a.3.cmp(&b.3))
        });
        let mut from = 0;
        while from < all.len() {
            let (mut end, mut hi) = (from + 1, all[from].1);
            while end < all.len() && all[end].0 <= hi {
                hi = hi.max(all[end].1);
                end += 1;
            }
            let group = &all[from..end];
            if group.iter().any(|e| e.2 != group[0].2) {
                for e in group.iter().filter(|e| e.3 != NONE) {
                    close[e.3 as usize] = true;
                }
            }
            from = end;
        }
        close
    }
}

impl PairEvents {
    /// For each pair whether one of its events, as doubles know it, is in a cluster in which three sheets meet, too; `None` if
    /// there is no such pair.
    pub(super) fn colliding(
        &self,
        pairs: usize,
        clusters: &Clusters,
        meetings: &[Moment],
    ) -> Option<Vec<bool>> {
        /// Clusters of events that are known in double-double are narrower than this (radians).
        const EXACT: f64 = 1e-18;
        let mut hit = vec![false; clusters.len()];
        for m in meetings {
            // The error reaches into one more cluster at most on either side.
            for theta in [m.theta - m.error, m.theta + m.error] {
                let i = clusters.index(theta);
                let (lo, hi) = clusters.exact_ends(i);
                let touches = m.theta + m.error >= lo && m.theta - m.error <= hi;
                hit[i as usize] |= touches && clusters.width(i) > EXACT;
            }
        }
        if !hit.contains(&true) {
            return None;
        }
        let close: Vec<bool> = (0..pairs)
            .map(|pair| {
                let rough = |e: &&Moment| e.error > EXACT;
                (self.of(pair)[0].iter().filter(rough))
                    .any(|e| hit[clusters.index(e.theta) as usize])
            })
            .collect();
        close.contains(&true).then_some(close)
    }
}

/// The events of a pair in double-double.
fn exact_events(geometry: &Geometry, run: &PairRun, mut found: impl FnMut(Moment)) {
    let contacts = &geometry.contacts;
    let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
    let shared = SharedEnds {
        tangent: false,
        corners: f.shared_corners(g, contacts.first_vertex_name),
    };
    let [x, y] = [run.first, run.second].map(|s| exact_sheet(geometry, s));
    x.events(&y, &shared, (run.lo, run.hi), |theta, error| {
        found(Moment { theta, error });
    });
}

/// Two sheets whose curves lie on one carrier at one orientation, not before and not after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Coincidence {
    pub(super) first: u32,
    pub(super) second: u32,
    pub(super) at: u32,
}

/// When two sheets may cross or touch at all: from the first cluster at which something happens between them to the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Encounter {
    pub(super) first: u32,
    pub(super) second: u32,
    pub(super) from: u32,
    pub(super) to: u32,
}

/// What there is between two sheets.
#[derive(Debug, Default)]
pub(super) struct Traced {
    /// Sorted by their sheets and then by orientation.
    pub(super) branches: Vec<Branch>,
    pub(super) coincidences: Vec<Coincidence>,
    /// Sheets so short that they pass another within one cluster, and where: what they are does not go on beyond.
    pub(super) swallowed: Vec<(u32, u32)>,
    /// Sheets of which some comes behind another within one cluster.
    pub(super) pinches: Vec<Pinch>,
    /// Sorted like the branches.
    pub(super) encounters: Vec<Encounter>,
}

/// All branches, coincidences and encounters.
pub(super) fn branches(
    geometry: &Geometry,
    pairs: &[PairRun],
    events: &PairEvents,
    clusters: &Clusters,
) -> Traced {
    let found = parallel::chunks(pairs, CHUNK, |first, runs| {
        let mut tracer = Tracer {
            geometry,
            clusters,
            found: Traced::default(),
            times: Vec::new(),
        };
        for (pair, run) in (first..).zip(runs) {
            tracer.trace(run, events.of(pair));
        }
        tracer.found
    });
    let mut all = Traced::default();
    for f in found {
        all.branches.extend(f.branches);
        all.coincidences.extend(f.coincidences);
        all.swallowed.extend(f.swallowed);
        all.pinches.extend(f.pinches);
        all.encounters.extend(f.encounters);
    }
    all
}

/// Pairs handled at a time by one thread.
const CHUNK: usize = 256;

struct Tracer<'a> {
    geometry: &'a Geometry,
    clusters: &'a Clusters,
    found: Traced,
    times: Vec<u32>,
}

impl Tracer<'_> {
    fn exact_crossings_between(&self, run: &PairRun, theta: Dd) -> [Option<bool>; 2] {
        let contacts = &self.geometry.contacts;
        let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
        let [x, y] = [run.first, run.second].map(|s| exact_sheet(self.geometry, s));
        let shared = SharedEnds {
            tangent: false,
            corners: f.shared_corners(g, contacts.first_vertex_name),
        };
        exact_crossings(&x, &y, &shared, &ExactTurn::by(theta))
    }

    fn trace(&mut self, run: &PairRun, [events, beyond]: [&[Moment]; 2]) {
        let clusters = self.clusters;
        let (from, to) = (clusters.index(run.lo), clusters.index(run.hi));
        self.times.clear();
        self.times
            .extend(events.iter().map(|e| clusters.index(e.theta)));
        self.times.sort_unstable();
        /// A short curve passes another with both its ends at once.
        const ENDS: usize = 2;
        let passing: Vec<u32> = (self.times.chunk_by(|a, b| a == b))
            .filter(|c| c.len() >= ENDS)
            .map(|c| c[0])
            .collect();
        // When carriers coincide, both ends of each curve are on the other's carrier: four events at once.
        const EVENTS_AT_ONCE: usize = 3;
        let mut all = self.times.clone();
        all.extend(beyond.iter().map(|e| clusters.index(e.theta)));
        all.sort_unstable();
        let at_once = (all.chunk_by(|a, b| a == b))
            .filter(|c| c.len() >= EVENTS_AT_ONCE)
            .map(|c| c[0]);
        // A curve of a line comes and goes with all its length; some of the four may then be just beyond.
        let sheets = &self.geometry.contacts.sheets;
        let (f, g) = (&sheets[run.first as usize], &sheets[run.second as usize]);
        let begins = run.lo <= f.from || run.lo <= g.from;
        let ends = run.hi >= f.to || run.hi >= g.to;
        let parallel = f.is_parallel(g);
        let whole = [begins.then_some(from), ends.then_some(to)]
            .into_iter()
            .flatten()
            .filter(|at| {
                parallel || !f.is_circle() && !g.is_circle() && self.times.binary_search(at).is_ok()
            });
        let mut same: Vec<u32> = (at_once.filter(|at| (from..=to).contains(at)))
            .chain(whole)
            .filter(|&at| coincide(self.geometry, run, clusters.exact_at(at)))
            .collect();
        same.sort_unstable();
        same.dedup();
        (self.found.coincidences).extend(same.into_iter().map(|at| Coincidence {
            first: run.first,
            second: run.second,
            at,
        }));
        let events = self.times.first().copied().zip(self.times.last().copied());
        let first_branch = self.found.branches.len();
        self.times.retain(|&i| from < i && i < to);
        self.times.extend([from, to]);
        self.times.sort_unstable();
        self.times.dedup();
        let mut open: [Option<Branch>; 2] = [None; 2];
        let mut apart = false;
        for w in self.times.windows(2) {
            let now = if clusters.are_close(w[0], w[1]) {
                self.exact_crossings_between(run, clusters.exact_between(w[0], w[1]))
            } else {
                crossings_between(self.geometry, run, clusters.between(w[0], w[1]))
            };
            let before = core::mem::replace(&mut apart, now == [None; 2]);
            if before && apart && passing.binary_search(&w[0]).is_ok() {
                let (at, beside) = (w[0], clusters.just_beside(w[0]));
                let short = swallowed(self.geometry, run, beside);
                self.found.swallowed.extend(short.map(|s| (s, at)));
                let (f, g) = (run.first, run.second);
                if short.is_none() && pinched(self.geometry, (f, g), beside) {
                    let both = [(f, g), (g, f)];
                    let pinch = |(sheet, other)| Pinch { sheet, at, other };
                    self.found.pinches.extend(both.map(pinch));
                }
            }
            for (root, enters) in now.into_iter().enumerate() {
                match (&mut open[root], enters) {
                    (Some(b), Some(enters)) if b.enters == enters => b.to = w[1],
                    (slot, enters) => {
                        self.found.branches.extend(slot.take());
                        *slot = enters.map(|enters| Branch {
                            first: run.first,
                            second: run.second,
                            root: root as u8,
                            enters,
                            from: w[0],
                            to: w[1],
                        });
                    }
                }
            }
        }
        self.found.branches.extend(open.into_iter().flatten());
        let lives = self.found.branches[first_branch..]
            .iter()
            .map(|b| (b.from, b.to));
        let all = lives.chain(events);
        if let Some((from, to)) = all.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))) {
            self.found.encounters.push(Encounter {
                first: run.first,
                second: run.second,
                from,
                to,
            });
        }
    }
}

/// The sheet, of two whose curves do not cross just below and just above a cluster, that is on different sides of the
/// other then: all of it has passed in between.
fn swallowed(geometry: &Geometry, run: &PairRun, beside: (f64, f64)) -> Option<u32> {
    [(run.first, run.second), (run.second, run.first)]
        .into_iter()
        .find(|&(short, long)| {
            let [short, long] = [short, long].map(|s| placed(geometry, s, beside));
            is_passed(&long, short.map(|c| c.point(0.0)))
        })
        .map(|pair| pair.0)
}

/// Whether two sheets have one carrier at an orientation.
fn coincide(geometry: &Geometry, run: &PairRun, theta: Dd) -> bool {
    let turn = ExactTurn::by(theta);
    let [f, g] = [run.first, run.second].map(|s| exact_sheet(geometry, s).curve(&turn));
    f.is_one_with(&g)
}

/// For each root whether the curves cross there, and if so whether the first enters.
fn crossings_between(geometry: &Geometry, run: &PairRun, theta: f64) -> [Option<bool>; 2] {
    let contacts = &geometry.contacts;
    let (fs, gs) = (
        &contacts.sheets[run.first as usize],
        &contacts.sheets[run.second as usize],
    );
    let turn = Rotation::by(theta);
    let origin = fs.close_to(gs).map(|c| c.0);
    let curve = |sheet: &Sheet| match origin {
        Some(o) => sheet.about(&o).curve(theta, turn),
        None => sheet.curve(theta, turn),
    };
    let (f, g) = (curve(fs), curve(gs));
    let mut found: [Option<Crossing>; 2] = [None; 2];
    for root in 0..roots(&f, &g) {
        found[usize::from(root)] = crossing(&f, &g, root);
    }
    let corners = fs.shared_corners(gs, contacts.first_vertex_name);
    for spiral in corners.into_iter().flatten() {
        let p = origin.map_or(spiral, |o| spiral.about(&o)).at(turn);
        let distance = |c: &Option<Crossing>| c.map_or(f64::INFINITY, |c| c.point.distance(p));
        let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
        found[nearest] = None;
    }
    let (half_f, half_g) = (f.half_length(), g.half_length());
    found.map(|c| {
        c.filter(|c| f.position(c.point).abs() < half_f && g.position(c.point).abs() < half_g)
            .map(|c| c.enters)
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
