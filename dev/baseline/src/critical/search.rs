//! Base of the searches for all three kinds of criticalities: the parts, the known orientations, and the examination of
//! a solution.

use cspace::{Part, Point, Rotation};
use rayon::prelude::*;

use super::bernstein::Basis;
use super::body::Body;
use super::contact::{Contact, contacts};
use super::found::{Criticalities, Known};
use super::grouped::{Grouped, reduced};
use super::outline::Outline;
use super::tolerance::SAME;

/// Search for critical orientations of a pair, with those found so far.
pub(super) struct Search<'a> {
    pub(super) pair: Pair<'a>,
    known: Grouped,
    counts: Counts,
}

/// Data that do not change during the search.
pub(super) struct Pair<'a> {
    pub(super) fixed: Outline,
    pub(super) moving: Outline,
    bodies: [Body; 2],
    pub(super) contacts: Vec<Contact>,
    pub(super) basis: Basis,
    skips: bool,
    go_on: &'a (dyn Fn() -> bool + Sync),
}

#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    candidates: u64,
    skipped: u64,
    overlap_tests: u64,
}

/// Piece of work with its findings, beside the orientations known before.
pub(super) struct Work<'a> {
    pub(super) pair: &'a Pair<'a>,
    known: &'a Grouped,
    found: Vec<f64>,
    counts: Counts,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        fixed: &Part,
        moving: &Part,
        known: Known,
        go_on: &'a (dyn Fn() -> bool + Sync),
    ) -> Self {
        let scale = 1.0 / fixed.size().max(moving.size());
        let (fixed, moving) = (Outline::new(fixed, scale), Outline::new(moving, scale));
        Self {
            pair: Pair {
                bodies: [Body::new(&fixed), Body::new(&moving)],
                contacts: contacts(&fixed, &moving),
                fixed,
                moving,
                basis: Basis::new(),
                skips: known == Known::Skipped,
                go_on,
            },
            known: Grouped::default(),
            counts: Counts::default(),
        }
    }

    /// Calls `work` for every number below `n`, on all threads; `None` if the search is stopped.
    ///
    /// Results become known after a fixed number of them, so that the number of skipped candidates does not depend on
    /// the threads.
    pub(super) fn each(
        &mut self,
        n: usize,
        work: impl Fn(&mut Work<'_>, usize) + Sync,
    ) -> Option<()> {
        /// Pieces of work after which all that was found is known.
        const AT_ONCE: usize = 64;
        for first in (0..n).step_by(AT_ONCE) {
            if !(self.pair.go_on)() {
                return None;
            }
            let done: Vec<(Vec<f64>, Counts)> = (first..n.min(first + AT_ONCE))
                .into_par_iter()
                .map(|i| {
                    let mut mine = Work {
                        pair: &self.pair,
                        known: &self.known,
                        found: Vec::new(),
                        counts: Counts::default(),
                    };
                    work(&mut mine, i);
                    (mine.found, mine.counts)
                })
                .collect();
            for (_, counts) in &done {
                self.counts.candidates += counts.candidates;
                self.counts.skipped += counts.skipped;
                self.counts.overlap_tests += counts.overlap_tests;
            }
            self.known.add(done.into_iter().flat_map(|d| d.0));
        }
        (self.pair.go_on)().then_some(())
    }

    pub(super) fn finish(self) -> Criticalities {
        Criticalities {
            orientations: self.known.finish(),
            contacts: self.pair.contacts.len(),
            candidates: self.counts.candidates,
            skipped: self.counts.skipped,
            overlap_tests: self.counts.overlap_tests,
        }
    }
}

impl Work<'_> {
    /// Whether the search was stopped; the remaining work is then skipped.
    pub(super) fn stopped(&self) -> bool {
        !(self.pair.go_on)()
    }

    /// Counts a solution; whether it is to be examined.
    pub(super) fn is_candidate(&mut self, theta: f64) -> bool {
        self.counts.candidates += 1;
        let theta = reduced(theta);
        let known = self.pair.skips
            && (self.known.has(theta) || self.found.iter().any(|f| (f - theta).abs() <= SAME));
        self.counts.skipped += u64::from(known);
        !known
    }

    /// Whether the parts are free or touch at a configuration.
    pub(super) fn is_apart(&mut self, p: Point, theta: f64) -> bool {
        self.counts.overlap_tests += 1;
        let [fixed, moving] = &self.pair.bodies;
        !fixed.overlaps(moving, p, theta, Rotation::by(theta))
    }

    pub(super) fn realised(&mut self, theta: f64) {
        self.found.push(reduced(theta));
    }

    /// Examines a solution: the contacts must touch there, and the parts not overlap.
    pub(super) fn examine(&mut self, contacts: &[&Contact], p: Point, theta: f64) {
        let turn = Rotation::by(theta);
        let (fixed, moving) = (&self.pair.fixed, &self.pair.moving);
        let touch = |c: &&Contact| c.touches(fixed, moving, p, theta, turn);
        if contacts.iter().all(touch) && self.is_apart(p, theta) {
            self.realised(theta);
        }
    }
}
