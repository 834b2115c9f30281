//! The progress bar of a long computation.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use cspace::{ComputeError, Progress, Stage};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::failure::is_quiet;
use crate::interrupt;

/// Nothing is shown for work that is done by then.
const PATIENCE: Duration = Duration::from_secs(1);

/// A bar on stderr with the stages, if stderr is a terminal and the work takes more than a second.
pub(crate) struct Bar {
    title: String,
    begin: Instant,
    news: Mutex<News>,
}

/// News that the bar does not show yet.
#[derive(Default)]
struct News {
    stage: Option<Stage>,
    /// Words that are told above the bar once it is shown.
    known: Option<String>,
}

impl Bar {
    pub(crate) fn new(title: String) -> Self {
        Self {
            title,
            begin: Instant::now(),
            news: Mutex::default(),
        }
    }

    fn news(&self) -> MutexGuard<'_, News> {
        self.news.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Runs a computation, with the bar kept up to date by a thread of its own.
    pub(crate) fn watch<T: Send>(&self, work: impl FnOnce(&Self) -> T + Send) -> T {
        let done = AtomicBool::new(false);
        std::thread::scope(|scope| {
            let ticker = scope.spawn(|| {
                let mut bar = None;
                while !done.load(Ordering::Relaxed) {
                    std::thread::park_timeout(Duration::from_millis(100));
                    if self.begin.elapsed() >= PATIENCE && !is_quiet() {
                        self.draw(bar.get_or_insert_with(|| self.open()));
                    }
                }
                if let Some(bar) = bar {
                    bar.finish_and_clear();
                }
            });
            let result = interrupt::watched(|| work(self));
            done.store(true, Ordering::Relaxed);
            ticker.thread().unpark();
            result
        })
    }

    /// Tells what is known so far above the bar, if there is one: where stderr is a terminal, and the work takes more than a second.
    pub(crate) fn tell(&self, known: String) {
        self.news().known = Some(known);
    }

    fn draw(&self, bar: &ProgressBar) {
        let News { stage, known } = core::mem::take(&mut *self.news());
        if let Some(known) = known {
            bar.println(known);
        }
        if let Some(stage) = stage {
            bar.set_position(stage as u64);
            bar.set_message(name(stage));
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

/// A bar on stderr over pieces of work, if stderr is a terminal and they take more than a second.
pub(crate) struct Steps {
    begin: Instant,
    bar: ProgressBar,
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
        }
    }

    /// Does several pieces at once.
    pub(crate) fn steps<T>(&self, count: u64, work: impl FnOnce() -> T) -> T {
        if self.begin.elapsed() >= PATIENCE && self.bar.is_hidden() && !is_quiet() {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        let result = work();
        self.bar.inc(count);
        result
    }
}

impl Drop for Steps {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Progress for Bar {
    fn stage(&self, stage: Stage) -> Result<(), ComputeError> {
        self.news().stage = Some(stage);
        if interrupt::is_interrupted() {
            return Err(ComputeError::Interrupted);
        }
        Ok(())
    }

    fn seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
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
