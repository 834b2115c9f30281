//! Branches of crossings of two sheets, between the events at which crossings appear and disappear.

use crate::contact::{Exact, Geometry, Orientation, Sheet, crossings};
use crate::geometry::Rotation;
use crate::parallel;

use crate::general::broad::candidates::PairRun;
use crate::general::events::branch::Branch;
use crate::general::events::clusters::{Clusters, Moment};
use crate::general::events::coming::PairEvents;
use crate::general::events::swallowed::swallowed;

/// Two sheets whose curves lie on one carrier at one orientation, but not before and after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coincidence {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) at: u32,
}

/// Clusters between which two sheets may cross or touch: from their first common event to the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SheetMeeting {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) from: u32,
    pub(crate) to: u32,
}

/// Branches and events between pairs of sheets.
#[derive(Debug, Default)]
pub(crate) struct Traced {
    /// Branches, sorted by their sheets and then by orientation.
    pub(crate) branches: Vec<Branch>,
    pub(crate) coincidences: Vec<Coincidence>,
    /// Pairs (sheet, cluster): the sheet crosses another one completely within the cluster, so it must not be continued past it.
    pub(crate) swallowed: Vec<(u32, u32)>,
    /// Encounters, sorted like the branches.
    pub(crate) meetings: Vec<SheetMeeting>,
}

/// Finds all branches, coincidences and meetings.
pub(crate) fn branches(
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
        all.meetings.extend(f.meetings);
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
    fn trace(&mut self, run: &PairRun, events: &[Moment]) {
        let clusters = self.clusters;
        let (from, to) = (clusters.index(run.lo), clusters.index(run.hi));
        self.times.clear();
        self.times
            .extend(events.iter().map(|e| clusters.index(e.theta)));
        self.times.sort_unstable();
        /// A short curve passes another one with both its ends at once.
        const ENDS: usize = 2;
        let passing: Vec<u32> = (self.times.chunk_by(|a, b| a == b))
            .filter(|c| c.len() >= ENDS)
            .map(|c| c[0])
            .collect();
        // When carriers coincide, both ends of each curve are on the other's carrier: four events at once.
        const EVENTS_AT_ONCE: usize = 3;
        let at_once = (self.times.chunk_by(|a, b| a == b))
            .filter(|c| c.len() >= EVENTS_AT_ONCE)
            .map(|c| c[0]);
        // A curve on a line appears and disappears with all its length; some of the four events may then be just beyond.
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
        let small = f.is_small() || g.is_small();
        let mut open: [Option<Branch>; 2] = [None; 2];
        let mut apart = false;
        for w in self.times.windows(2) {
            let now = if small || clusters.are_close(w[0], w[1]) {
                exact_crossings_between(self.geometry, run, clusters.exact_between(w[0], w[1]))
            } else {
                crossings_between(self.geometry, run, clusters.between(w[0], w[1]))
            };
            let before = core::mem::replace(&mut apart, now == [None; 2]);
            if before && apart && passing.binary_search(&w[0]).is_ok() {
                let (at, both) = (w[0], (run.first, run.second));
                let short = swallowed(self.geometry, clusters, both, at);
                self.found.swallowed.extend(short.map(|s| (s, at)));
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
            self.found.meetings.push(SheetMeeting {
                first: run.first,
                second: run.second,
                from,
                to,
            });
        }
    }
}

/// Whether the curves of two sheets lie on one line or circle at an orientation.
fn coincide(geometry: &Geometry, run: &PairRun, theta: Exact) -> bool {
    /// Tolerance for carriers that coincide: the orientation is known to the square root of the rounding (length, and sine of an angle).
    const SAME: f64 = 1e-14;
    let turn = Rotation::by(theta);
    let [f, g] = [run.first, run.second].map(|s| geometry.cycle(s, turn));
    f.is_one_with(&g, SAME)
}

/// For each root, whether the curves cross there in double-double, and if so whether the first enters the blocked side of the second.
fn exact_crossings_between(geometry: &Geometry, run: &PairRun, theta: Exact) -> [Option<bool>; 2] {
    let at = Orientation::by(theta);
    let [f, g] = [run.first, run.second].map(|s| geometry.curve(s, &at));
    crossings(&f, &g, corners(geometry, run))
}

/// Computes [`exact_crossings_between`] in f64.
fn crossings_between(geometry: &Geometry, run: &PairRun, theta: f64) -> [Option<bool>; 2] {
    let [f, g] = [run.first, run.second].map(|s| &geometry.contacts.sheets[s as usize]);
    let at = Orientation::by(theta);
    let origin = f.close_to(g).map(|c| c.0);
    let curve = |sheet: &Sheet| match origin {
        Some(o) => sheet.curve_on(&sheet.locus.about(&o), &at),
        None => sheet.curve_on(&sheet.locus, &at),
    };
    crossings(&curve(f), &curve(g), corners(geometry, run))
}

/// Whether two sheets share a corner where the first ends, and where it starts.
fn corners(geometry: &Geometry, run: &PairRun) -> [bool; 2] {
    let contacts = &geometry.contacts;
    let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
    f.shared_corners(g, contacts.first_vertex_name)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
