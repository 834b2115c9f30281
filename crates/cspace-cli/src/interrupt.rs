//! Interrupts: how a command is stopped from outside.

use std::io::{IsTerminal, Write};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use crate::failure::{UNANSWERED, tell};
use crate::output;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
/// Whether an interrupt is how the work comes to its end.
static ENDLESS: AtomicBool = AtomicBool::new(false);
/// Whether what is done is kept.
static KEEPS: AtomicBool = AtomicBool::new(false);
/// Whether a computation is going on that looks at [`INTERRUPTED`].
static WATCHED: AtomicBool = AtomicBool::new(false);

/// Lets an interrupt (Ctrl-C, or a request to terminate) end the computation at the next stage, or the process if that takes
/// long. A second one, or one at any other time, ends the process at once. A result that has been written stays, and the
/// command then ends as if there had been no interrupt.
pub(crate) fn catch_interrupts() {
    static ONCE: OnceLock<()> = OnceLock::new();
    ONCE.get_or_init(|| system::listen(interrupted));
}

/// Whether the user wants no more of it.
pub(crate) fn is_interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}

/// From here on the work has no end but an interrupt, which is none that failed.
pub(crate) fn until_interrupted() {
    catch_interrupts();
    ENDLESS.store(true, Ordering::Relaxed);
}

/// From here on the first interrupt ends the work, of which what is done is kept; the second ends the process.
pub(crate) fn keep() {
    KEEPS.store(true, Ordering::Relaxed);
}

/// Work that ends soon after an interrupt by itself goes on until this is dropped.
pub(crate) struct Watched(());

/// Work begins that ends soon after an interrupt by itself.
pub(crate) fn watching() -> Watched {
    WATCHED.store(true, Ordering::Relaxed);
    Watched(())
}

impl Drop for Watched {
    fn drop(&mut self) {
        WATCHED.store(false, Ordering::Relaxed);
    }
}

fn interrupted() {
    /// A stage may take much longer than somebody who wants to stop likes to wait.
    const GRACE: Duration = Duration::from_millis(300);
    if ENDLESS.load(Ordering::Relaxed) {
        std::process::exit(0);
    }
    let is_first = !INTERRUPTED.swap(true, Ordering::Relaxed);
    if is_first && KEEPS.load(Ordering::Relaxed) {
        return;
    }
    if is_first && WATCHED.load(Ordering::Relaxed) {
        std::thread::sleep(GRACE);
    }
    let is_written = output::writing();
    if *is_written && is_first {
        return;
    }
    let mut err = std::io::stderr();
    // The bar may stand on the line.
    let line_break = if err.is_terminal() { "\n" } else { "" };
    let _ = writeln!(err, "{line_break}error: interrupted");
    tell("interrupted");
    std::process::exit(i32::from(UNANSWERED));
}

#[cfg(unix)]
mod system {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    /// Calls `interrupted` for every signal, on a thread of its own.
    pub(super) fn listen(interrupted: fn()) {
        // Without a handler an interrupt ends the process, which is good enough.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM, SIGHUP]) else {
            return;
        };
        let listening = move || signals.forever().for_each(|_| interrupted());
        let _ = std::thread::Builder::new().spawn(listening);
    }
}

#[cfg(not(unix))]
mod system {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::time::Duration;

    use signal_hook::consts::SIGINT;

    /// Interrupts are looked for so often: soon for somebody who waits, and seldom for the processor.
    const PAUSE: Duration = Duration::from_millis(50);

    /// Calls `interrupted` for every interrupt, on a thread of its own.
    pub(super) fn listen(interrupted: fn()) {
        let came = Arc::new(AtomicBool::new(false));
        // Without a handler an interrupt ends the process, which is good enough.
        if signal_hook::flag::register(SIGINT, Arc::clone(&came)).is_err() {
            return;
        }
        let listening = move || {
            loop {
                std::thread::sleep(PAUSE);
                if came.swap(false, Ordering::Relaxed) {
                    interrupted();
                }
            }
        };
        let _ = std::thread::Builder::new().spawn(listening);
    }
}
