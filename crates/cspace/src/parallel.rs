//! Work divided among threads, unless there is but one or too little to divide.
//!
//! A call into a thread pool from outside wakes a thread and waits for it, which takes longer than some stages of a small
//! pair. With one thread all is done by the caller.

use core::cmp::Ordering;

use rayon::prelude::*;

fn is_alone() -> bool {
    rayon::current_num_threads() == 1
}

/// Runs work of several stages within the pool, so that its doors are not passed again at every stage.
pub(crate) fn within<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    if is_alone() {
        work()
    } else {
        rayon::scope(|_| work())
    }
}

/// What `work` makes of every item, in their order; no thread is given fewer than `least`.
pub(crate) fn map<T: Sync, R: Send>(
    items: &[T],
    least: usize,
    work: impl Fn(&T) -> R + Sync + Send,
) -> Vec<R> {
    if items.len() < 2 * least || is_alone() {
        return items.iter().map(work).collect();
    }
    let items = items.par_iter().with_min_len(least);
    items.map(work).collect()
}

/// What `work` makes of every so many items in a row, given the number of the first of them; in their order.
pub(crate) fn chunks<T: Sync, R: Send>(
    items: &[T],
    size: usize,
    work: impl Fn(usize, &[T]) -> R + Sync,
) -> Vec<R> {
    let work = |(i, chunk)| work(i * size, chunk);
    if items.len() <= size || is_alone() {
        return items.chunks(size).enumerate().map(work).collect();
    }
    items.par_chunks(size).enumerate().map(work).collect()
}

/// What both make.
pub(crate) fn join<A: Send, B: Send>(
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    if is_alone() {
        (first(), second())
    } else {
        rayon::join(first, second)
    }
}

/// Sorts; what is equal stays in its order.
pub(crate) fn sort_by<T: Send>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Sync) {
    if is_alone() {
        items.sort_by(order);
    } else {
        items.par_sort_by(order);
    }
}

/// Sorts by an order in which equal is the same: what is equal may come in any order.
pub(crate) fn sort_unstable_by<T: Send>(
    items: &mut [T],
    order: impl Fn(&T, &T) -> Ordering + Sync,
) {
    if is_alone() {
        items.sort_unstable_by(order);
    } else {
        items.par_sort_unstable_by(order);
    }
}
