//! Cache of the classifications of pairs' configurations: the end of one step is the beginning of the next, and all
//! trials of a step begin at the same configuration.

use std::cell::RefCell;

use cspace::{Classification, Coordinates, QueryError};

use crate::pairs::MovingPair;

/// Classifications kept for each pair: those at both ends of a step, and at two configurations between.
const KEPT: usize = 4;

/// Last classifications of each pair.
#[derive(Debug)]
pub(super) struct Classes(RefCell<Vec<[Option<Known>; KEPT]>>);

/// A configuration and its classification.
type Known = (Coordinates, Classification);

impl Classes {
    /// Creates an empty cache for a number of pairs.
    pub(super) fn new(pairs: usize) -> Self {
        Self(RefCell::new(vec![[None; KEPT]; pairs]))
    }

    /// Classification of a pair's configuration, from the cache if it is there.
    ///
    /// # Errors
    /// If nothing was computed there.
    pub(super) fn of(
        &self,
        index: usize,
        pair: &MovingPair,
        at: Coordinates,
    ) -> Result<Classification, QueryError> {
        let known = self.0.borrow()[index];
        let known = known.into_iter().flatten().find(|known| known.0 == at);
        let class = match known {
            Some((_, class)) => class,
            None => pair.space.classify(at)?,
        };
        self.tell(index, at, class);
        Ok(class)
    }

    /// Stores the classification of a pair's configuration.
    pub(super) fn tell(&self, index: usize, at: Coordinates, class: Classification) {
        let kept = &mut self.0.borrow_mut()[index];
        let last = kept.iter().position(|k| k.is_some_and(|k| k.0 == at));
        kept[..=last.unwrap_or(KEPT - 1)].rotate_right(1);
        kept[0] = Some((at, class));
    }
}
