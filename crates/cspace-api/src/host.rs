//! The program that asks.

use std::fmt::Display;

use cspace::{Options, PairError, PairSpace, Part, Progress, Relation, Silent, Stage};

use crate::error::Error;

/// Services of the program that asks: it hears remarks, can interrupt long work, and may keep spaces.
pub trait Host: Sync {
    /// Begins long work that is called `title`: its stages are reported to what is given, which says when it ends before its time. The work
    /// has ended where that is dropped.
    fn begin(&self, title: &str) -> Box<dyn Progress + '_>;

    /// Begins long work of so many pieces of one kind, which has ended where what is given is dropped. Without a place to show how many are
    /// done it is as any long work.
    fn begin_pieces(&self, _count: usize) -> Box<dyn Pieces + '_> {
        Box::new(Uncounted(self.begin("")))
    }

    /// Hears that from here on what is done by then is the answer, where the asker wants no more of long work.
    fn keep(&self) {}

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

/// Long work in pieces.
pub trait Pieces {
    /// So many more pieces are done.
    fn done(&self, count: usize);

    /// Whether the asker wants no more of it.
    fn is_interrupted(&self) -> bool;

    /// Reading of a clock in seconds, since any moment; 0 of a program without one.
    fn seconds(&self) -> f64;
}

/// Work in pieces of which nobody counts those that are done.
struct Uncounted<'a>(Box<dyn Progress + 'a>);

impl Pieces for Uncounted<'_> {
    fn done(&self, _: usize) {}

    fn is_interrupted(&self) -> bool {
        is_interrupted(&*self.0)
    }

    fn seconds(&self) -> f64 {
        self.0.seconds()
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

/// Whether the asker wants no more of long work.
pub(crate) fn is_interrupted(progress: &dyn Progress) -> bool {
    progress.stage(Stage::Sheets).is_err()
}
