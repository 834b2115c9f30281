//! Connected regions of a stack: what a user of slices makes of them.

/// Faces of slices, joined where they overlap.
#[derive(Default)]
pub(crate) struct Regions {
    parent: Vec<usize>,
}

impl Regions {
    /// A new face, joined to none.
    pub(crate) fn add(&mut self) -> usize {
        self.parent.push(self.parent.len());
        self.parent.len() - 1
    }

    fn root(&self, mut i: usize) -> usize {
        while self.parent[i] != i {
            i = self.parent[i];
        }
        i
    }

    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }

    pub(crate) fn are_joined(&self, a: usize, b: usize) -> bool {
        self.root(a) == self.root(b)
    }

    /// Number of sets that are left.
    pub(crate) fn count(&self) -> usize {
        (0..self.parent.len())
            .filter(|&i| self.parent[i] == i)
            .count()
    }
}
