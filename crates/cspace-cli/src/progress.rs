//! The progress bar of a long computation.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use cspace::{ComputeError, Progress, Stage};
use cspace_api::Pieces;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::failure::is_quiet;
use crate::interrupt::{self, Watched};

/// Nothing is shown for work that is done by then.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar on stderr with the stages, or how many pieces are done, if stderr is a terminal and the work takes more than a second. It is kept up
/// to date by a thread of its own, until it is dropped.
pub(crate) struct Bar {
    shown: Arc<Shown>,
    ticker: Option<JoinHandle<()>>,
    _watched: Watched,
}

/// How far work has come.
#[derive(Debug, Clone, Copy)]
enum At {
    /// It is in this stage.
    Stage(Stage),
    /// So many pieces of so many are done.
    Pieces(u64, u64),
}

/// Text and stage that are shown.
struct Shown {
    title: String,
    begin: Instant,
    at: Mutex<Option<At>>,
    done: AtomicBool,
}

impl Bar {
    /// Work of this title begins.
    pub(crate) fn new(title: String) -> Self {
        let shown = Arc::new(Shown {
            title,
            begin: Instant::now(),
            at: Mutex::new(None),
            done: AtomicBool::new(false),
        });
        let ticking = Arc::clone(&shown);
        Self {
            shown,
            // Without a thread there is no bar.
            ticker: std::thread::Builder::new()
                .spawn(move || ticking.tick())
                .ok(),
            _watched: interrupt::watching(),
        }
    }
}

/// Words that are told above the bar once one is shown.
static KNOWN: Mutex<Option<String>> = Mutex::new(None);

/// Tells what is known so far above the bar, if there is one: where stderr is a terminal, and the work takes more than a second.
pub(crate) fn tell_above(known: String) {
    *lock(&KNOWN) = Some(known);
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.shown.done.store(true, Ordering::Relaxed);
        if let Some(ticker) = self.ticker.take() {
            ticker.thread().unpark();
            // It ends at once, with nothing to say.
            let _ = ticker.join();
        }
    }
}

impl Shown {
    /// Draws the bar again and again while the work is not done, and clears it.
    fn tick(&self) {
        let mut bar = None;
        while !self.done.load(Ordering::Relaxed) {
            std::thread::park_timeout(Duration::from_millis(100));
            if self.begin.elapsed() >= PATIENCE && !is_quiet() {
                self.draw(bar.get_or_insert_with(|| self.open()));
            }
        }
        if let Some(bar) = bar {
            bar.finish_and_clear();
        }
    }

    fn draw(&self, bar: &ProgressBar) {
        if let Some(known) = lock(&KNOWN).take() {
            bar.println(known);
        }
        let at = *lock(&self.at);
        match at {
            None => {}
            Some(At::Stage(stage)) => {
                bar.set_length(Stage::COUNT);
                bar.set_position(stage as u64);
                bar.set_message(name(stage));
            }
            Some(At::Pieces(done, of)) => {
                bar.set_length(of);
                bar.set_position(done);
                bar.set_message(format!("{done} of {of}"));
            }
        }
        bar.tick();
    }

    fn open(&self) -> ProgressBar {
        // The target is hidden by itself where stderr is no terminal.
        let bar = ProgressBar::with_draw_target(Some(Stage::COUNT), ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{prefix} [{bar:24}] {elapsed} {msg}") {
            bar.set_style(style.progress_chars("=> "));
        }
        bar.set_prefix(self.title.clone());
        bar.with_elapsed(self.begin.elapsed())
    }
}

/// Content of a mutex; nothing is left half done where a thread panics.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A bar on stderr over pieces of work, if stderr is a terminal and they take more than a second.
pub(crate) struct Steps {
    begin: Instant,
    bar: ProgressBar,
    _watched: Watched,
}

impl Steps {
    pub(crate) fn new(count: usize) -> Self {
        let bar = ProgressBar::with_draw_target(Some(count as u64), ProgressDrawTarget::hidden());
        if let Ok(style) = ProgressStyle::with_template("[{bar:24}] {pos}/{len} {elapsed}") {
            bar.set_style(style.progress_chars("=> "));
        }
        Self {
            begin: Instant::now(),
            bar,
            _watched: interrupt::watching(),
        }
    }
}

impl Pieces for Steps {
    fn done(&self, count: usize) {
        if self.begin.elapsed() >= PATIENCE && self.bar.is_hidden() && !is_quiet() {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(count as u64);
    }

    fn is_interrupted(&self) -> bool {
        interrupt::is_interrupted()
    }

    fn seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }
}

impl Drop for Steps {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Bar {
    fn stage(&self, stage: Stage) -> Result<(), ComputeError> {
        let mut at = lock(&self.shown.at);
        // Each piece may have stages of its own.
        if !matches!(*at, Some(At::Pieces(..))) {
            *at = Some(At::Stage(stage));
        }
        drop(at);
        if interrupt::is_interrupted() {
            return Err(ComputeError::Interrupted);
        }
        Ok(())
    }

    fn pieces(&self, done: u64, of: u64) {
        let mut at = lock(&self.shown.at);
        match *at {
            // Threads tell it in any order.
            Some(At::Pieces(most, _)) if most >= done && done < of => {}
            _ if done >= of => *at = None,
            _ => *at = Some(At::Pieces(done, of)),
        }
    }

    fn seconds(&self) -> f64 {
        self.shown.begin.elapsed().as_secs_f64()
    }
}

fn name(stage: Stage) -> &'static str {
    match stage {
        Stage::Sheets => "features in contact",
        Stage::Candidates => "contacts that may meet",
        Stage::PairEvents => "where two contacts meet",
        Stage::Branches => "boundary curves",
        Stage::TripleEvents => "where three contacts meet",
        Stage::Cells => "cells",
        Stage::Shells => "free or blocked",
        Stage::Graph => "patches and links",
    }
}
