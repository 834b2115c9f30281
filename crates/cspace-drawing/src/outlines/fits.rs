//! Lines and arcs that chains have become, kept for the next question about the same drawing.

use std::cell::RefCell;
use std::collections::HashMap;

use crate::fit::{NotFitted, Outline, Sided};
use crate::join::Chain;

/// What a fit depends on in one drawing, joined in one way: the chain, a line that closes it counted, and the tolerance.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    first: u32,
    pieces: usize,
    fit: u64,
    sided: Sided,
}

/// The fits of the chains of a drawing.
#[derive(Default)]
pub(super) struct Fits(RefCell<HashMap<Key, Result<Outline, NotFitted>>>);

impl Fits {
    /// The fit of a chain: as found before, or now.
    pub(super) fn of(
        &self,
        chain: &Chain<'_>,
        fit: f64,
        sided: Sided,
        find: impl FnOnce() -> Result<Outline, NotFitted>,
    ) -> Result<Outline, NotFitted> {
        let key = Key {
            first: chain.first,
            pieces: chain.pieces.len(),
            fit: fit.to_bits(),
            sided,
        };
        if let Some(known) = self.0.borrow().get(&key) {
            return known.clone();
        }
        let found = find();
        self.0.borrow_mut().insert(key, found.clone());
        found
    }
}
