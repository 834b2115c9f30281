//! Work away from the interpreter: its lock is released, Ctrl-C is heard, and threads are those of this process.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use cspace::space::Stage;
use cspace::{ComputeError, Progress};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::error::{error, internal};

/// So often it is asked whether the user has pressed Ctrl-C.
const LISTEN: Duration = Duration::from_millis(50);

/// The variable with the number of threads, which for a worker of many is 1.
const THREADS: &str = "CSPACE_NUM_THREADS";

/// The threads of one process: a process that is forked from it has none of them, and makes its own.
struct Threads {
    process: u32,
    pool: Arc<ThreadPool>,
}

static POOL: Mutex<Option<Threads>> = Mutex::new(None);

/// The number of threads that is asked for; 0 for one per processor.
fn asked() -> PyResult<usize> {
    match std::env::var(THREADS) {
        Err(_) => Ok(0),
        Ok(text) => text.trim().parse().map_err(|_| {
            error(format_args!(
                "{THREADS} is {text:?} where a number of threads is expected"
            ))
        }),
    }
}

fn build(threads: usize) -> PyResult<Arc<ThreadPool>> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    Ok(Arc::new(pool.map_err(error)?))
}

/// Uses so many threads from now on; 0 for one per processor.
pub(crate) fn set_threads(threads: usize) -> PyResult<()> {
    let pool = build(threads)?;
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    replace(&mut known, pool);
    Ok(())
}

fn replace(known: &mut Option<Threads>, pool: Arc<ThreadPool>) {
    let process = std::process::id();
    let new = Threads { process, pool };
    if let Some(old) = known.replace(new)
        && old.process != process
    {
        // Its threads are the parent's: waiting for their end would never end.
        core::mem::forget(old.pool);
    }
}

/// The threads of this process.
pub(crate) fn pool() -> PyResult<Arc<ThreadPool>> {
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(threads) = &*known
        && threads.process == std::process::id()
    {
        return Ok(Arc::clone(&threads.pool));
    }
    let pool = build(asked()?)?;
    replace(&mut known, Arc::clone(&pool));
    Ok(pool)
}

/// The callable of Python that hears of long work: that of `cspace.progress`, if there is one.
pub(crate) struct Listener(Option<Py<PyAny>>);

impl Listener {
    pub(crate) fn of(py: Python<'_>) -> PyResult<Self> {
        let found = py.import("cspace._progress")?.getattr("heard")?.call0()?;
        Ok(Self((!found.is_none()).then(|| found.unbind())))
    }

    /// Tells what is at work, after so many seconds, and which share of it is done where that is known.
    pub(crate) fn tell(
        &self,
        py: Python<'_>,
        (stage, seconds, share): (&str, f64, Option<f64>),
    ) -> PyResult<()> {
        match &self.0 {
            Some(heard) => heard.call1(py, (stage, seconds, share)).map(drop),
            None => Ok(()),
        }
    }
}

/// News of work that its asker has not heard yet.
#[derive(Default)]
struct Told {
    stages: Vec<(Stage, f64)>,
    pieces: Option<(f64, f64)>,
}

/// Ends a computation at its next stage once the user wants no more of it, and keeps what it tells.
struct Watched {
    ended: AtomicBool,
    begin: Instant,
    told: Option<Mutex<Told>>,
}

impl Watched {
    fn told(&self) -> Option<MutexGuard<'_, Told>> {
        let told = self.told.as_ref()?;
        Some(told.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Hands on what has been told.
    fn hand_on(&self, py: Python<'_>, listener: &Listener) -> PyResult<()> {
        let Some(told) = self.told().map(|mut told| core::mem::take(&mut *told)) else {
            return Ok(());
        };
        for (stage, seconds) in told.stages {
            let name = serde_json::to_value(stage).map_err(error)?;
            listener.tell(py, (name.as_str().unwrap_or_default(), seconds, None))?;
        }
        match told.pieces {
            Some((share, seconds)) => listener.tell(py, ("pieces", seconds, Some(share))),
            None => Ok(()),
        }
    }
}

impl Progress for Watched {
    fn stage(&self, stage: Stage) -> Result<(), ComputeError> {
        let seconds = self.seconds();
        if let Some(mut told) = self.told() {
            told.stages.push((stage, seconds));
        }
        match self.ended.load(Ordering::Relaxed) {
            true => Err(ComputeError::Interrupted),
            false => Ok(()),
        }
    }

    fn pieces(&self, done: u64, of: u64) {
        let seconds = self.seconds();
        if let Some(mut told) = self.told() {
            told.pieces = Some((done as f64 / of as f64, seconds));
        }
    }

    fn seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }
}

/// Does long work on the pool, of which the listener hears. Ctrl-C raises `KeyboardInterrupt` at once, as does an error of the listener;
/// what is at work then ends at its next stage.
pub(crate) fn run<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&dyn Progress) -> Result<T, String> + Send + 'static,
) -> PyResult<T> {
    let listener = Listener::of(py)?;
    let watched = Arc::new(Watched {
        ended: AtomicBool::new(false),
        begin: Instant::now(),
        told: listener.0.is_some().then(Mutex::default),
    });
    let (sender, receiver) = channel();
    let watching = Arc::clone(&watched);
    pool()?.spawn(move || {
        let done = catch_unwind(AssertUnwindSafe(|| work(&*watching)));
        // Nobody listens any more after Ctrl-C.
        let _ = sender.send(done);
    });
    let mut receiver = receiver;
    loop {
        let heard;
        (receiver, heard) = py.detach(move || {
            let heard = receiver.recv_timeout(LISTEN);
            (receiver, heard)
        });
        let told = (watched.hand_on(py, &listener)).and_then(|()| py.check_signals());
        if let Err(interrupt) = told {
            watched.ended.store(true, Ordering::Relaxed);
            return Err(interrupt);
        }
        match heard {
            Ok(Ok(done)) => return done.map_err(error),
            Ok(Err(panic)) => return Err(internal(said(&*panic))),
            Err(RecvTimeoutError::Disconnected) => return Err(internal("the work was lost")),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Does short work here, without the interpreter's lock.
pub(crate) fn here<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> PyResult<T> + Send,
) -> PyResult<T> {
    py.detach(|| catch_unwind(AssertUnwindSafe(work)))
        .unwrap_or_else(|panic| Err(internal(said(&*panic))))
}

/// Message of a panic.
fn said(panic: &(dyn core::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("it says nothing").to_owned()
}
