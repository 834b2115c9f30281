//! Which edit is the newest: while a vertex is dragged they come faster than spaces are computed, and only the last counts.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use cspace::space::Stage;
use cspace::{ComputeError, Progress};

/// The last sequence numbers seen, by session: every loaded page is one.
#[derive(Debug, Clone, Default)]
pub(super) struct Newest(Arc<Mutex<HashMap<String, u64>>>);

/// An edit in its session.
#[derive(Debug)]
pub(super) struct Ticket {
    newest: Newest,
    session: String,
    sequence: u64,
}

impl Newest {
    /// More sessions at a time are those of pages that are closed.
    const MOST_SESSIONS: usize = 64;

    fn seen(&self) -> MutexGuard<'_, HashMap<String, u64>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins an edit; none if one of a higher number, or of the same, was seen before.
    pub(super) fn begin(&self, session: &str, sequence: u64) -> Option<Ticket> {
        let mut seen = self.seen();
        if seen.get(session).is_some_and(|&newest| newest >= sequence) {
            return None;
        }
        if seen.len() >= Self::MOST_SESSIONS {
            seen.clear();
        }
        seen.insert(session.to_owned(), sequence);
        Some(Ticket {
            newest: self.clone(),
            session: session.to_owned(),
            sequence,
        })
    }

    /// A page is loaded, and counts from the beginning.
    pub(super) fn forget(&self) {
        self.seen().clear();
    }
}

impl Ticket {
    /// Whether a newer edit has come.
    pub(super) fn is_superseded(&self) -> bool {
        let seen = self.newest.seen();
        seen.get(&self.session)
            .is_some_and(|&newest| newest > self.sequence)
    }
}

impl Progress for Ticket {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        if self.is_superseded() {
            Err(ComputeError::Interrupted)
        } else {
            Ok(())
        }
    }
}
