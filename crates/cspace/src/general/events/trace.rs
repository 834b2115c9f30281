//! Where crossings of two sheets come and go, and the branches between.

use crate::contact::{
    Crossing, ExactTurn, Geometry, Rough, SharedEnds, Sheet, conditions, crossing, exact_crossings,
};
use crate::geometry::Rotation;
use crate::number::Dd;
use crate::parallel;

use crate::general::broad::candidates::PairRun;
use crate::general::events::branch::Branch;
use crate::general::events::clusters::{Clusters, Moment};
use crate::general::events::pinches::{Pinch, pinched, swallowed, turns_beside};
use crate::general::events::placing::exact_sheet;

/// The events of pairs that may cross.
#[derive(Debug, Default)]
pub(crate) struct PairEvents {
    pub(crate) events: Vec<Moment>,
    /// For every pair how many there are of it and those before.
    until: Vec<usize>,
}

impl PairEvents {
    fn of(&self, pair: usize) -> &[Moment] {
        let from = (pair.checked_sub(1)).map_or(0, |before| self.until[before]);
        &self.events[from..self.until[pair]]
    }
}

/// The events of every pair.
pub(crate) fn pair_events(geometry: &Geometry, pairs: &[PairRun]) -> PairEvents {
    let found = parallel::chunks(pairs, CHUNK, |_, runs| {
        let mut found = PairEvents::default();
        let mut rough = Vec::new();
        for run in runs {
            let events = &mut found.events;
            events_of(geometry, run, &mut rough, |e| events.push(e));
            found.until.push(found.events.len());
        }
        found
    });
    let mut all = PairEvents::default();
    for f in found {
        let before = all.events.len();
        all.events.extend(f.events);
        all.until.extend(f.until.into_iter().map(|n| before + n));
    }
    all
}

/// The events of one pair in double-double, of those conditions that have any as far as doubles tell.
fn events_of(
    geometry: &Geometry,
    run: &PairRun,
    rough: &mut Vec<Rough>,
    mut found: impl FnMut(Moment),
) {
    let contacts = &geometry.contacts;
    let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
    // Pairs that are tangent by their making are not among them.
    let shared = SharedEnds {
        tangent: false,
        corners: f.shared_corners(g, contacts.first_vertex_name),
    };
    rough.clear();
    if !f.is_flat() && !g.is_flat() {
        let (lo, hi) = (run.lo.to_f64(), run.hi.to_f64());
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let (sin, cos) = mid.sin_cos();
        conditions(f, g, &shared, |t| {
            let mut all = Rough::None;
            t.roots(mid, cos, sin, half, |root| {
                all = match all {
                    _ if root.error > Rough::ERROR => Rough::Unknown,
                    Rough::None => Rough::At([Some(root.theta), None]),
                    Rough::At([first, None]) => Rough::At([first, Some(root.theta)]),
                    _ => Rough::Unknown,
                };
            });
            rough.push(all);
        });
        if rough.iter().all(|r| *r == Rough::None) {
            return;
        }
    }
    let [x, y] = [run.first, run.second].map(|s| exact_sheet(geometry, s));
    let rough = |condition: usize| rough.get(condition).map_or(Rough::Unknown, |r| *r);
    x.events(&y, &shared, (run.lo, run.hi), rough, |theta, error| {
        found(Moment { theta, error });
    });
}

/// Two sheets whose curves lie on one carrier at one orientation, not before and not after.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coincidence {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) at: u32,
}

/// When two sheets may cross or touch at all: from the first cluster at which something happens between them to the last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Encounter {
    pub(crate) first: u32,
    pub(crate) second: u32,
    pub(crate) from: u32,
    pub(crate) to: u32,
}

/// What there is between two sheets.
#[derive(Debug, Default)]
pub(crate) struct Traced {
    /// Sorted by their sheets and then by orientation.
    pub(crate) branches: Vec<Branch>,
    pub(crate) coincidences: Vec<Coincidence>,
    /// Sheets so short that they pass another within one cluster, and where: what they are does not go on beyond.
    pub(crate) swallowed: Vec<(u32, u32)>,
    /// Sheets of which some comes behind another within one cluster.
    pub(crate) pinches: Vec<Pinch>,
    /// Sorted like the branches.
    pub(crate) encounters: Vec<Encounter>,
}

/// All branches, coincidences and encounters.
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
    fn trace(&mut self, run: &PairRun, events: &[Moment]) {
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
        let at_once = (self.times.chunk_by(|a, b| a == b))
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
                let (at, beside) = (w[0], turns_beside(clusters, w[0]));
                let both = (run.first, run.second);
                let short = swallowed(self.geometry, both, &beside);
                self.found.swallowed.extend(short.map(|s| (s, at)));
                let (f, g) = (run.first, run.second);
                if short.is_none() && pinched(self.geometry, (f, g), &beside) {
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

/// Whether the curves of two sheets lie on one line or circle at an orientation.
fn coincide(geometry: &Geometry, run: &PairRun, theta: Dd) -> bool {
    /// Orientations at which circles become one are known to the square root of the rounding (length, and sine of an angle).
    const SAME: f64 = 1e-14;
    let turn = ExactTurn::by(theta);
    let [f, g] = [run.first, run.second].map(|s| exact_sheet(geometry, s).cycle(&turn));
    f.is_one_with(&g, SAME)
}

/// The same as [`crossings_between`] in double-double.
fn exact_crossings_between(geometry: &Geometry, run: &PairRun, theta: Dd) -> [Option<bool>; 2] {
    let contacts = &geometry.contacts;
    let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
    let [x, y] = [run.first, run.second].map(|s| exact_sheet(geometry, s));
    let shared = SharedEnds {
        tangent: false,
        corners: f.shared_corners(g, contacts.first_vertex_name),
    };
    exact_crossings(&x, &y, &shared, &ExactTurn::by(theta))
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
    for root in 0..2 {
        found[usize::from(root)] = crossing(&f, &g, root);
    }
    let corners = fs.shared_corners(gs, contacts.first_vertex_name);
    for spiral in corners.into_iter().flatten() {
        let p = origin.map_or(spiral, |o| spiral.about(&o)).at(turn);
        let distance = |c: &Option<Crossing>| c.map_or(f64::INFINITY, |c| c.point.distance(p));
        let nearest = usize::from(distance(&found[1]) < distance(&found[0]));
        found[nearest] = None;
    }
    let (half_f, half_g) = (f.half, g.half);
    found.map(|c| {
        c.filter(|c| f.position(c.point).abs() < half_f && g.position(c.point).abs() < half_g)
            .map(|c| c.enters)
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
