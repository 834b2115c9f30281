//! Lines and arcs that chains have become, kept for the next question about the same drawing.

use std::cell::RefCell;
use std::collections::HashMap;

use super::copies::Copies;
use crate::fit::{NotFitted, Outline, Sided};
use crate::join::{Chain, Shape};

/// Key of a fit in one drawing, joined in one way: the chain, a line that closes it counted, and the tolerance.
#[derive(PartialEq, Eq, Hash)]
struct Key {
    first: u32,
    pieces: usize,
    fit: u64,
    sided: Sided,
}

/// The fits of the chains of a drawing.
#[derive(Default)]
pub(super) struct Fits {
    known: RefCell<HashMap<Key, Result<Outline, NotFitted>>>,
    copies: RefCell<Copies>,
}

impl Fits {
    /// The fit of a chain: as found before, of it or of a copy, or now.
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
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let has_curves = chain
            .pieces
            .iter()
            .any(|p| matches!(p.shape, Shape::Curve(_)));
        let copied = match has_curves {
            true => self.copies.borrow().of(chain, fit, sided),
            false => None,
        };
        let found = match copied {
            Some(outline) => Ok(outline),
            None => {
                let found = find();
                if let Ok(outline) = &found
                    && has_curves
                {
                    self.copies.borrow_mut().keep(chain, fit, sided, outline);
                }
                found
            }
        };
        self.known.borrow_mut().insert(key, found.clone());
        found
    }
}
