//! The program that asks.

use std::fmt::Display;

use cspace::{Options, PairError, PairSpace, Part, Progress, Relation, Silent};

use crate::error::Error;

/// What a question needs of the program that asks it: ears for remarks, patience for long work, and a place for spaces.
pub trait Host: Sync {
    /// Begins long work that is called `title`: its stages are reported to what is given, which says when it ends before its time. The work
    /// has ended where that is dropped.
    fn begin(&self, title: &str) -> Box<dyn Progress + '_>;

    /// Hears what the asker should know of an answer that is given all the same.
    fn note(&self, note: &dyn Display);

    /// Hears what is most likely not meant, and what to do about it.
    fn warn(&self, warning: &Error);

    /// How the asker writes the option of this name.
    fn option(&self, name: &str) -> String;

    /// The space of two parts, and whether it was computed before and kept.
    ///
    /// # Errors
    /// As [`PairSpace::compute_with`].
    fn space(
        &self,
        (fixed, moving): (&Part, &Part),
        relation: Relation,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<(PairSpace, bool), PairError> {
        let space = PairSpace::compute_with(fixed, moving, relation, options, progress)?;
        Ok((space, false))
    }
}

/// A program that hears nothing, never interrupts, and keeps nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Deaf;

impl Host for Deaf {
    fn begin(&self, _: &str) -> Box<dyn Progress + '_> {
        Box::new(Silent)
    }

    fn note(&self, _: &dyn Display) {}

    fn warn(&self, _: &Error) {}

    fn option(&self, name: &str) -> String {
        format!("`{name}`")
    }
}

/// A function that gives the spaces of pairs, of which the program may keep some.
pub fn spaces<'a>(
    host: &'a dyn Host,
    progress: &'a dyn Progress,
) -> impl Fn(&Part, &Part, Relation, &Options) -> Result<PairSpace, PairError> + Sync + 'a {
    move |fixed, moving, relation, options| {
        Ok(host.space((fixed, moving), relation, options, progress)?.0)
    }
}
