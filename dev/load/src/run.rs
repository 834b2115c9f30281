//! Pair after pair, on all processors.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use cspace::{ComputeError, Configuration, PartError};
use cspace_load::output::{note, panic_text};
use cspace_load::{Drawn, Effort, Fault, Report, Source, Tally, check, shrink};
use cspace_oracle::{Case, Verdict};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;

use crate::args::Args;
use crate::findings;
use crate::state::State;
use crate::watch::{Deadline, PATIENCE, Watch};

/// Pairs done, for each worker, before the state is written.
const BATCH: usize = 50;

/// Bands sliced from scratch at each pair.
const BANDS: usize = 30;

/// The tally is shown so often.
const SHOWN: Duration = Duration::from_secs(60);

static STOP: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Lets an interrupt or a request to terminate end the run as soon as the pairs at hand allow.
pub(crate) fn stop_by_signals() -> std::io::Result<()> {
    for signal in [SIGINT, SIGTERM] {
        flag::register(signal, Arc::clone(&STOP))?;
    }
    Ok(())
}

fn stopped() -> bool {
    STOP.load(Ordering::Relaxed)
}

/// Runs until enough pairs are done, time is over, or the run is interrupted; the state records its progress.
pub(crate) fn run(args: &Args, source: &Source, state: &mut State) -> Result<(), String> {
    let begin = Instant::now();
    let workers = match args.threads {
        0 => thread::available_parallelism().map_or(1, usize::from),
        n => usize::from(n),
    };
    let last = args.only.map_or(args.pairs, |number| number + 1);
    let in_time = || {
        let minutes = args.minutes.unwrap_or(f64::INFINITY);
        begin.elapsed().as_secs_f64() < 60.0 * minutes
    };
    let watch = Watch::new(workers);
    let mut shown = Instant::now();
    thread::scope(|scope| {
        scope.spawn(|| {
            watch.look(&|number| {
                let drawn = source.draw(number);
                tell(args, number, &drawn, "slow", &["It takes long.".to_owned()]);
            });
        });
        let result = (|| {
            while state.next < last && in_time() && !stopped() {
                let count = (BATCH * workers).min((last - state.next) as usize);
                let tallies = batch(args, source, state.next, count, workers, &watch, &in_time);
                for tally in tallies.into_iter().map_while(|t| t) {
                    state.tally.add(&tally);
                    state.next += 1;
                }
                if let Some(path) = &args.state {
                    state.write(path)?;
                }
                if shown.elapsed() > SHOWN {
                    shown = Instant::now();
                    let t = &state.tally;
                    let rate = t.pairs as f64 / t.seconds;
                    note(format_args!(
                        "pair {}: {} certain, {} wrong in {} pairs, {} conflicts, {rate:.1} pairs a processor second",
                        state.next, t.certain, t.wrong, t.wrong_pairs, t.conflicts
                    ));
                }
            }
            Ok(())
        })();
        watch.finish();
        result
    })
}

/// Results of some pairs in order; after the first one that was not begun or was broken off, results may be missing.
fn batch(
    args: &Args,
    source: &Source,
    first: u64,
    count: usize,
    workers: usize,
    watch: &Watch,
    in_time: &(dyn Fn() -> bool + Sync),
) -> Vec<Option<Tally>> {
    let taken = AtomicUsize::new(0);
    let done = Mutex::new(vec![None; count]);
    thread::scope(|scope| {
        for worker in 0..workers {
            let (taken, done) = (&taken, &done);
            scope.spawn(move || {
                // One thread a pair: the pairs are what is done at the same time.
                let Ok(pool) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else {
                    return;
                };
                while in_time() && !stopped() {
                    let i = taken.fetch_add(1, Ordering::Relaxed);
                    if i >= count {
                        break;
                    }
                    let number = first + i as u64;
                    let drawn = source.draw(number);
                    watch.begin(worker, number, &drawn.name);
                    let tally = pool.install(|| one(args, number, drawn));
                    watch.end(worker);
                    done.lock().unwrap_or_else(PoisonError::into_inner)[i] = tally;
                }
            });
        }
    });
    done.into_inner().unwrap_or_else(PoisonError::into_inner)
}

/// Result of one pair; `None` if it was broken off.
fn one(args: &Args, number: u64, mut drawn: Drawn) -> Option<Tally> {
    let begin = Instant::now();
    let mut tally = Tally {
        pairs: 1,
        ..Tally::default()
    };
    let Ok(case) = &drawn.case else {
        tally.refused = 1;
        return Some(tally);
    };
    let effort = Effort {
        configurations: args.per_pair as usize,
        bands: BANDS,
        thorough: number.is_multiple_of(args.thorough),
    };
    let deadline = Deadline::new(stopped);
    let checked = catch_unwind(AssertUnwindSafe(|| {
        check(case, effort, &mut drawn.rng, &deadline)
    }));
    match checked {
        Ok(Ok(report)) => {
            tally.count(&report);
            if !report.faults.is_empty() {
                let kind = kind(&report.faults);
                let mut report = report;
                if args.shrink {
                    (drawn.case, report) = shrunk(case, effort, kind, report);
                }
                let said: Vec<String> = report.faults.iter().map(describe).collect();
                tell(args, number, &drawn, kind, &said);
            } else if report.conflicts > 0 {
                let said = [format!("{} conflicts", report.conflicts)];
                tell(args, number, &drawn, "conflict", &said);
            }
        }
        Ok(Err(ComputeError::Interrupted)) if stopped() => return None,
        Ok(Err(error)) => {
            tally.given_up = 1;
            tell(args, number, &drawn, "given-up", &[error.to_string()]);
        }
        Err(panic) => {
            tally.panics = 1;
            let said = format!("panic: {}", panic_text(&*panic));
            tell(args, number, &drawn, "panic", &[said]);
        }
    }
    let took = begin.elapsed();
    tally.slow = u64::from(took > PATIENCE);
    tally.seconds = took.as_secs_f64();
    Some(tally)
}

/// A smaller pair whose worst fault is of the same kind, with its faults.
fn shrunk(
    case: &Case,
    effort: Effort,
    wanted: &str,
    report: Report,
) -> (Result<Case, PartError>, Report) {
    let again = |case: &Case| -> Option<Report> {
        let mut rng = ChaCha8Rng::seed_from_u64(0);
        let deadline = Deadline::new(stopped);
        catch_unwind(AssertUnwindSafe(|| {
            check(case, effort, &mut rng, &deadline).ok()
        }))
        .ok()
        .flatten()
    };
    let same = |r: &Report| !r.faults.is_empty() && kind(&r.faults) == wanted;
    let small = shrink(case, &|case| again(case).is_some_and(|r| same(&r)));
    let found = again(&small).filter(same).unwrap_or(report);
    (Ok(small), found)
}

/// Worst of the faults, as the end of a file's name.
fn kind(faults: &[Fault]) -> &'static str {
    let kinds = faults.iter().map(|f| match f {
        Fault::Wrong { .. } => "0-wrong",
        Fault::Threads => "1-threads",
        Fault::Saved => "1-saved",
        Fault::Inverse { .. } => "2-inverse",
        Fault::Classifier { .. } => "3-classifier",
        Fault::Scratch { .. } => "4-scratch",
        Fault::Loops { .. } => "5-loops",
        Fault::Open { .. } => "6-open",
    });
    kinds.min().map_or("", |k| &k[2..])
}

fn describe(fault: &Fault) -> String {
    let place = |at: &Configuration, verdict: &Verdict| {
        format!(
            "wrong at x = {:?}, y = {:?}, theta = {:?}: {} by {:e}",
            at.x,
            at.y,
            at.theta,
            if verdict.overlap { "blocked" } else { "free" },
            verdict.margin,
        )
    };
    match fault {
        Fault::Wrong { at, verdict } => place(at, verdict),
        Fault::Scratch { at, verdict } => {
            format!("the slice from scratch is {}", place(at, verdict))
        }
        other => format!("{other:?}"),
    }
}

/// Writes a finding, if a folder was given, and prints a note.
fn tell(args: &Args, number: u64, drawn: &Drawn, kind: &str, said: &[String]) {
    note(format_args!(
        "pair {number} ({}): {kind}: {}",
        drawn.name,
        said.first().map_or("", String::as_str)
    ));
    if let (Some(folder), Ok(case)) = (&args.findings, &drawn.case)
        && let Err(error) = findings::write(folder, number, &drawn.name, kind, case, said)
    {
        note(error);
    }
}
