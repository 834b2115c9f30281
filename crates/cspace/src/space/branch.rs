//! Branches: crossings of two sheets, followed over the orientations at which they exist.

use rayon::prelude::*;

use crate::contact::{Crossing, Geometry, conditions, crossing, roots};
use crate::geometry::Rotation;
use crate::number::Event;

use super::candidates::PairRun;
use super::clusters::Clusters;

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

    /// The crossing at an orientation.
    pub(super) fn at(&self, geometry: &Geometry, theta: f64, turn: Rotation) -> Option<Crossing> {
        let sheets = &geometry.contacts.sheets;
        let f = sheets[self.first as usize].curve(theta, turn);
        let g = sheets[self.second as usize].curve(theta, turn);
        crossing(&f, &g, self.root)
    }
}

/// The events of every pair.
pub(super) fn pair_events(geometry: &Geometry, pairs: &[PairRun]) -> Vec<Vec<Event>> {
    let contacts = &geometry.contacts;
    pairs
        .par_iter()
        .map(|run| {
            let (f, g) = (
                &contacts.sheets[run.first as usize],
                &contacts.sheets[run.second as usize],
            );
            let shared = f.shared_ends(g, contacts.first_vertex_name);
            let (mid, half) = (0.5 * (run.lo + run.hi), 0.5 * (run.hi - run.lo));
            let (sin, cos) = mid.sin_cos();
            let mut events = Vec::new();
            conditions(f, g, &shared, |t| {
                t.roots(mid, cos, sin, half, |e| events.push(e))
            });
            events
        })
        .collect()
}

/// All branches, sorted by their sheets and then by orientation.
pub(super) fn branches(
    geometry: &Geometry,
    pairs: &[PairRun],
    events: &[Vec<Event>],
    clusters: &Clusters,
) -> Vec<Branch> {
    pairs
        .par_iter()
        .zip(events)
        .flat_map_iter(|(run, events)| branches_of(geometry, run, events, clusters))
        .collect()
}

fn branches_of(
    geometry: &Geometry,
    run: &PairRun,
    events: &[Event],
    clusters: &Clusters,
) -> Vec<Branch> {
    let (from, to) = (clusters.index(run.lo), clusters.index(run.hi));
    let mut times = vec![from, to];
    times.extend(
        events
            .iter()
            .map(|e| clusters.index(e.theta))
            .filter(|&i| from < i && i < to),
    );
    times.sort_unstable();
    times.dedup();
    let mut all: Vec<Branch> = Vec::new();
    let mut open: [Option<Branch>; 2] = [None; 2];
    for w in times.windows(2) {
        let now = crossings_between(geometry, run, clusters.between(w[0], w[1]));
        for (root, enters) in now.into_iter().enumerate() {
            match (&mut open[root], enters) {
                (Some(b), Some(enters)) if b.enters == enters => b.to = w[1],
                (slot, enters) => {
                    all.extend(slot.take());
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
    all.extend(open.into_iter().flatten());
    all
}

/// For each root whether the curves cross there, and if so whether the first enters.
fn crossings_between(geometry: &Geometry, run: &PairRun, theta: f64) -> [Option<bool>; 2] {
    let contacts = &geometry.contacts;
    let (fs, gs) = (
        &contacts.sheets[run.first as usize],
        &contacts.sheets[run.second as usize],
    );
    let turn = Rotation::by(theta);
    let (f, g) = (fs.curve(theta, turn), gs.curve(theta, turn));
    let mut found: [Option<Crossing>; 2] = [None; 2];
    for root in 0..roots(&f, &g) {
        found[usize::from(root)] = crossing(&f, &g, root);
    }
    let shared = fs.shared_ends(gs, contacts.first_vertex_name);
    for spiral in shared.corners.into_iter().flatten() {
        let p = spiral.at(turn);
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
