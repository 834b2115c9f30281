//! Disjoint sets.

/// Disjoint sets of the numbers 0 … n − 1; the smallest member represents its set.
#[derive(Debug, Clone)]
pub(crate) struct UnionFind {
    parent: Vec<u32>,
}

impl UnionFind {
    pub(crate) fn new(n: usize) -> Self {
        Self {
            parent: (0..n as u32).collect(),
        }
    }

    /// The representative of the set of `i`.
    pub(crate) fn find(&mut self, mut i: u32) -> u32 {
        while self.parent[i as usize] != i {
            let above = self.parent[self.parent[i as usize] as usize];
            self.parent[i as usize] = above;
            i = above;
        }
        i
    }

    /// Joins the sets of `i` and `j`.
    pub(crate) fn union(&mut self, i: u32, j: u32) {
        let (i, j) = (self.find(i), self.find(j));
        let (small, large) = (i.min(j), i.max(j));
        self.parent[large as usize] = small;
    }
}
