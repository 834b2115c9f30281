//! Numbers sorted into groups, stored in one list.

/// Items of consecutive groups: those of group g are `items[first[g]..first[g + 1]]`, in the order in which they were given.
#[derive(Debug, Clone, Default)]
pub(crate) struct Grouped {
    first: Vec<u32>,
    items: Vec<u32>,
}

impl Grouped {
    /// Sorts pairs of a group and an item. The iterator is traversed twice.
    pub(crate) fn new(groups: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let first = starts(groups, pairs.clone().map(|p| p.0));
        let mut at = first.clone();
        let mut items = vec![0; first[groups] as usize];
        for (group, item) in pairs {
            let slot = &mut at[group as usize];
            items[*slot as usize] = item;
            *slot += 1;
        }
        Self { first, items }
    }

    /// The items of a group; empty if there is no such group.
    #[inline]
    pub(crate) fn of(&self, group: u32) -> &[u32] {
        let g = group as usize;
        match self.first.get(g..=g + 1) {
            Some(&[first, end]) => &self.items[first as usize..end as usize],
            _ => &[],
        }
    }
}

/// Beginning of each group in a list sorted by group, and at last the end of the list.
pub(crate) fn starts(groups: usize, members: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut first = vec![0u32; groups + 1];
    for group in members {
        first[group as usize + 1] += 1;
    }
    for g in 0..groups {
        first[g + 1] += first[g];
    }
    first
}
