//! Pairs that take too long.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use cspace::{ComputeError, Progress, Stage};
use cspace_load::output::note;

/// A pair that takes longer is reported.
pub(crate) const PATIENCE: Duration = Duration::from_secs(20);

/// A pair that takes longer is given up when its next stage begins.
const LIMIT: Duration = Duration::from_secs(300);

/// Interval between checks by the watchdog.
const TICK: Duration = Duration::from_millis(200);

/// Current task of each worker.
pub(crate) struct Watch {
    at: Vec<Mutex<Option<At>>>,
    over: AtomicBool,
}

#[derive(Clone)]
struct At {
    number: u64,
    name: String,
    since: Instant,
    told: bool,
}

impl Watch {
    pub(crate) fn new(workers: usize) -> Self {
        Self {
            at: (0..workers).map(|_| Mutex::new(None)).collect(),
            over: AtomicBool::new(false),
        }
    }

    pub(crate) fn begin(&self, worker: usize, number: u64, name: &str) {
        let at = At {
            number,
            name: name.to_owned(),
            since: Instant::now(),
            told: false,
        };
        *self.at[worker]
            .lock()
            .unwrap_or_else(PoisonError::into_inner) = Some(at);
    }

    pub(crate) fn end(&self, worker: usize) {
        *self.at[worker]
            .lock()
            .unwrap_or_else(PoisonError::into_inner) = None;
    }

    /// Reports every pair that takes too long, until [`finish`](Self::finish). A pair that is reported here may never
    /// end, so it is also passed on at once.
    pub(crate) fn look(&self, slow: &(dyn Fn(u64) + Sync)) {
        while !self.over.load(Ordering::Relaxed) {
            for at in &self.at {
                let mut at = at.lock().unwrap_or_else(PoisonError::into_inner);
                if let Some(at) = at.as_mut()
                    && !at.told
                    && at.since.elapsed() > PATIENCE
                {
                    at.told = true;
                    let (number, name) = (at.number, &at.name);
                    note(format_args!(
                        "pair {number} ({name}) takes over {PATIENCE:?}"
                    ));
                    slow(at.number);
                }
            }
            std::thread::sleep(TICK);
        }
    }

    pub(crate) fn finish(&self) {
        self.over.store(true, Ordering::Relaxed);
    }
}

/// Ends a computation that has taken too long, or is no longer wanted.
pub(crate) struct Deadline {
    begin: Instant,
    stopped: fn() -> bool,
}

impl Deadline {
    pub(crate) fn new(stopped: fn() -> bool) -> Self {
        Self {
            begin: Instant::now(),
            stopped,
        }
    }
}

impl Progress for Deadline {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        if (self.stopped)() || self.begin.elapsed() > LIMIT {
            return Err(ComputeError::Interrupted);
        }
        Ok(())
    }

    fn seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }
}
