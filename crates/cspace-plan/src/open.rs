//! Entry of a search's queue: the least first.

use core::cmp::Ordering;

/// A state to go on from with what it costs; of two the one that costs less is the greater, so that a heap has it first.
#[derive(Debug, PartialEq)]
pub(crate) struct Open<S> {
    pub(crate) cost: f64,
    pub(crate) state: S,
}

impl<S: PartialEq> Eq for Open<S> {}

impl<S: Ord> PartialOrd for Open<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Ord> Ord for Open<S> {
    fn cmp(&self, other: &Self) -> Ordering {
        (other.cost.total_cmp(&self.cost)).then(other.state.cmp(&self.state))
    }
}
