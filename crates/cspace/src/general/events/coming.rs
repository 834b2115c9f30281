//! The orientations at which crossings of two sheets appear and disappear: by an f64 filter, then in double-double.

use crate::contact::{Exact, Geometry, Precision, conditions};
use crate::number::Event;
use crate::parallel;

use crate::general::broad::candidates::PairRun;
use crate::general::events::clusters::Moment;

/// Pairs handled at a time by one thread.
const CHUNK: usize = 256;

/// The events of pairs that may cross.
#[derive(Debug, Default)]
pub(crate) struct PairEvents {
    pub(crate) events: Vec<Moment>,
    /// For every pair, the number of events up to and including it.
    until: Vec<usize>,
}

impl PairEvents {
    pub(super) fn of(&self, pair: usize) -> &[Moment] {
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

/// Result of the f64 filter for the roots of a condition.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Rough {
    /// There is no root.
    None,
    /// The roots, to within [`Rough::ERROR`].
    At([Option<f64>; 2]),
    /// Nothing is certain.
    Unknown,
}

impl Rough {
    /// Error above which roots are not certain (radians).
    const ERROR: f64 = 1e-11;

    /// The result with one more root.
    fn and(self, root: Event) -> Self {
        match self {
            _ if root.error > Self::ERROR => Self::Unknown,
            Self::None => Self::At([Some(root.theta), None]),
            Self::At([first, None]) => Self::At([first, Some(root.theta)]),
            _ => Self::Unknown,
        }
    }
}

/// The events of one pair in double-double, from the conditions that may have roots according to the f64 filter.
fn events_of(
    geometry: &Geometry,
    run: &PairRun,
    rough: &mut Vec<Rough>,
    mut found: impl FnMut(Moment),
) {
    let contacts = &geometry.contacts;
    let [f, g] = [run.first, run.second].map(|s| &contacts.sheets[s as usize]);
    let corners = f.shared_corners(g, contacts.first_vertex_name);
    rough.clear();
    if !f.is_flat() && !g.is_flat() {
        let (lo, hi) = (run.lo.to_f64(), run.hi.to_f64());
        let (mid, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
        let (sin, cos) = mid.sin_cos();
        conditions(
            &f.locus,
            &g.locus,
            corners,
            |_| true,
            |_, condition| {
                let mut all = Rough::None;
                condition.roots(mid, cos, sin, half, |root| all = all.and(root));
                rough.push(all);
            },
        );
        if rough.iter().all(|r| *r == Rough::None) {
            return;
        }
    }
    let rough = |condition: usize| rough.get(condition).map_or(Rough::Unknown, |r| *r);
    let middle = (run.lo + run.hi).scaled(0.5);
    let half = (run.hi - run.lo).scaled(0.5).to_f64();
    let mut take = |theta: Exact, error| {
        let turns = ((theta - middle) / Exact::TAU).to_f64().round();
        let theta = theta - Exact::TAU * turns;
        if (theta - middle).to_f64().abs() <= half + error {
            found(Moment { theta, error });
        }
    };
    let [f, g] = [run.first, run.second].map(|s| Exact::locus(geometry, s));
    let asked = |number| rough(number) != Rough::None;
    conditions(f, g, corners, asked, |number, condition| {
        match rough(number) {
            Rough::At(roots)
                if (roots.iter().flatten()).all(|&r| condition.is_simple(r, Rough::ERROR)) =>
            {
                for r in roots.into_iter().flatten() {
                    let (theta, error) = condition.root_near(r);
                    take(theta, error);
                }
            }
            _ => condition.exact_roots(&mut take),
        }
    });
}
