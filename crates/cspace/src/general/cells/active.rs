//! The branches on a sheet that exist between two clusters, updated from cluster to cluster in order.

use crate::general::events::branch::Branch;

/// The branches of a sheet from one cluster to the next.
#[derive(Debug)]
pub(crate) struct Active<'a> {
    branches: &'a [Branch],
    /// All branches of the sheet, sorted by the clusters at which they begin.
    by_start: Vec<u32>,
    /// Number of these that have begun.
    begun: usize,
    now: Vec<u32>,
}

impl<'a> Active<'a> {
    pub(crate) fn new(branches: &'a [Branch], on_sheet: &[u32]) -> Self {
        let mut by_start = on_sheet.to_vec();
        by_start.sort_unstable_by_key(|&b| (branches[b as usize].from, b));
        Self {
            branches,
            by_start,
            begun: 0,
            now: Vec::new(),
        }
    }

    /// Branches that exist just after a cluster, in the order of their indices. Clusters must come in order.
    pub(crate) fn after(&mut self, cluster: u32) -> &[u32] {
        let branches = self.branches;
        self.now.retain(|&b| branches[b as usize].to > cluster);
        let begun = self.begun;
        while let Some(&b) = self.by_start.get(self.begun) {
            let branch = &branches[b as usize];
            if branch.from > cluster {
                break;
            }
            if branch.to > cluster {
                self.now.push(b);
            }
            self.begun += 1;
        }
        if self.begun > begun {
            self.now.sort_unstable();
        }
        &self.now
    }
}
