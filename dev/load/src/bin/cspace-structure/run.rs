//! Specimen after specimen, on all processors.

use std::collections::BTreeMap;
use std::fmt::{Display, Write as _};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError, mpsc};
use std::thread;
use std::time::Duration;

use cspace_load::output::print;
use cspace_load::structure::{Effort, Outcome, Specimen, Totals, measure};

use crate::args::Args;
use crate::rows;

/// Number of slowest pairs that are named.
const SLOWEST: usize = 10;

/// Measures all, and prints rows in order as soon as they are there.
pub(crate) fn run(args: &Args, all: &[Specimen]) -> Result<(), String> {
    let effort = Effort {
        flood: args.flood.then_some(args.depth),
        inverse: args.inverse,
        patience: Duration::from_secs(args.patience),
    };
    let workers = match args.threads {
        0 => thread::available_parallelism().map_or(1, usize::from),
        n => usize::from(n),
    };
    if !args.totals {
        print(&format!("{}\n", rows::heading()))?;
    }
    let next = AtomicUsize::new(0);
    let failed = Mutex::new(None);
    let (send, receive) = mpsc::channel();
    let mut outcomes = Vec::new();
    thread::scope(|scope| {
        for _ in 0..workers {
            let (next, failed, send) = (&next, &failed, send.clone());
            scope.spawn(move || {
                // One thread a pair: the pairs are what is done at the same time.
                let pool = match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
                    Ok(pool) => pool,
                    Err(error) => {
                        let mut failed = failed.lock().unwrap_or_else(PoisonError::into_inner);
                        *failed = Some(format!("there is no thread: {error}"));
                        return;
                    }
                };
                while let Some((i, specimen)) = {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    all.get(i).map(|s| (i, s))
                } {
                    let outcome = pool.install(|| measure(specimen, effort));
                    if send.send((i, outcome)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        for (i, outcome) in receive {
            waiting.insert(i, outcome);
            while let Some(outcome) = waiting.remove(&outcomes.len()) {
                if !args.totals {
                    let row = rows::row(&all[outcomes.len()], &outcome);
                    print(&format!("{row}\n"))?;
                }
                outcomes.push(outcome);
            }
        }
        Ok::<(), String>(())
    })?;
    if let Some(error) = failed.into_inner().unwrap_or_else(PoisonError::into_inner) {
        return Err(error);
    }
    print(&summary(all, &outcomes))
}

/// Totals by family and by change, and the pairs that take longest.
fn summary(all: &[Specimen], outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    let sum = gathered(all, outcomes, |_| "all");
    let families = gathered(all, outcomes, |s| s.family);
    let mut changes = gathered(all, outcomes, |s| s.change.kind());
    changes.sort_by_key(|c| c.0);
    add(&mut text, "family", &families);
    add(&mut text, "", &sum);
    add(&mut text, "change", &changes);
    let _ = writeln!(text, "\nslowest");
    let seconds = |o: &Outcome| match o {
        Outcome::Measured(m) => m.seconds,
        _ => 0.0,
    };
    let mut slowest: Vec<(f64, &Specimen)> = outcomes.iter().map(seconds).zip(all).collect();
    slowest.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (seconds, specimen) in slowest.iter().take(SLOWEST) {
        let _ = writeln!(text, "{seconds:9.3} s  {}", rows::titled(specimen));
    }
    text
}

/// The totals of each group, in the order of the groups' first specimens.
fn gathered<K: Copy + Eq>(
    all: &[Specimen],
    outcomes: &[Outcome],
    group: impl Fn(&Specimen) -> K,
) -> Vec<(K, Totals)> {
    let mut totals: Vec<(K, Totals)> = Vec::new();
    for (specimen, outcome) in all.iter().zip(outcomes) {
        let key = group(specimen);
        let at = totals.iter().position(|t| t.0 == key).unwrap_or_else(|| {
            totals.push((key, Totals::default()));
            totals.len() - 1
        });
        totals[at].1.count(specimen, outcome);
    }
    totals
}

/// Adds a table of totals; without a name it continues the one above.
fn add<K: Display>(text: &mut String, name: &str, totals: &[(K, Totals)]) {
    if !name.is_empty() {
        let _ = writeln!(text, "\n{name:24}{}", Totals::heading());
    }
    for (key, totals) in totals {
        let _ = writeln!(text, "{key:24}{totals}");
    }
}
