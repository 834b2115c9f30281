//! This program as the one that asks for an assistant.

use std::fmt::Display;
use std::sync::{Mutex, PoisonError};

use cspace::{ComputeError, Options, PairError, PairSpace, Part, Progress, Relation, Stage};
use cspace_api::{Error, Host};
use tokio_util::sync::CancellationToken;

use crate::cache;

/// Remarks are kept for the answer, and a call that is cancelled ends at the next stage.
pub(super) struct Caller {
    cancelled: CancellationToken,
    notes: Mutex<Vec<String>>,
}

impl Caller {
    pub(super) fn new(cancelled: CancellationToken) -> Self {
        Self {
            cancelled,
            notes: Mutex::default(),
        }
    }

    /// Remarks so far, which are taken.
    pub(super) fn notes(&self) -> Vec<String> {
        core::mem::take(&mut self.notes.lock().unwrap_or_else(PoisonError::into_inner))
    }

    pub(super) fn hear(&self, note: String) {
        let mut notes = self.notes.lock().unwrap_or_else(PoisonError::into_inner);
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
}

impl Progress for Caller {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        match self.cancelled.is_cancelled() {
            true => Err(ComputeError::Interrupted),
            false => Ok(()),
        }
    }
}

impl Host for Caller {
    fn begin(&self, _: &str) -> Box<dyn Progress + '_> {
        Box::new(self)
    }

    fn note(&self, note: &dyn Display) {
        self.hear(format!("note: {note}"));
    }

    fn warn(&self, warning: &Error) {
        let help = warning.help.as_deref().map(|help| format!("; {help}"));
        self.hear(format!("warning: {warning}{}", help.unwrap_or_default()));
    }

    fn option(&self, name: &str) -> String {
        format!("`{}`", name.replace('-', "_"))
    }

    fn space(
        &self,
        parts: (&Part, &Part),
        relation: Relation,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<(PairSpace, bool), PairError> {
        cache::space(true, parts, relation, options, progress)
    }
}
