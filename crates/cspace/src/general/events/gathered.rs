//! All events and branches of a pair, with clusters numbered once for all of them.

use crate::grouped::Grouped;

use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::events::trace::{Coincidence, Traced};
use crate::general::events::triple::Triples;

/// All events between sheets, by clusters.
pub(crate) struct Gathered {
    pub(crate) clusters: Clusters,
    pub(crate) branches: Vec<Branch>,
    /// The branches on every sheet.
    pub(crate) on_sheet: Grouped,
    pub(crate) coincidences: Vec<Coincidence>,
    /// Sheets with the clusters at which branches pass each other on them, sorted.
    pub(crate) passings: Vec<(u32, u32)>,
    /// Sheets with the clusters at which another sheet lies on the same carrier, sorted: their cells end there.
    pub(crate) splits: Vec<(u32, u32)>,
}

impl Gathered {
    /// Adds the events of three sheets to the clusters of the events of two, and renumbers everything by the resulting clusters.
    pub(crate) fn new(
        traced: Traced,
        on_sheet: Grouped,
        triples: &Triples,
        clusters: &Clusters,
    ) -> Self {
        let more = triples.events.iter().map(|m| m.event).collect();
        let (clusters, moved) = clusters.with(more);
        let index = |old: u32| moved[old as usize];
        let branches = (traced.branches.into_iter())
            .map(|b| Branch {
                from: index(b.from),
                to: index(b.to),
                ..b
            })
            .collect();
        let coincidences: Vec<Coincidence> = (traced.coincidences.into_iter())
            .map(|c| Coincidence {
                at: index(c.at),
                ..c
            })
            .collect();
        let swallowed = traced
            .swallowed
            .iter()
            .map(|&(sheet, at)| (sheet, index(at)));
        let splits = (coincidences.iter())
            .flat_map(|c| [(c.first, c.at), (c.second, c.at)])
            .chain(swallowed);
        let passings = (triples.events.iter()).map(|m| (m.sheet, clusters.index(m.event.theta)));
        Self {
            splits: sorted(splits),
            passings: sorted(passings),
            clusters,
            branches,
            on_sheet,
            coincidences,
        }
    }
}

/// All items in order, each once.
fn sorted<T: Ord>(all: impl Iterator<Item = T>) -> Vec<T> {
    let mut all: Vec<T> = all.collect();
    all.sort_unstable();
    all.dedup();
    all
}
