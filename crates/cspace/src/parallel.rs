//! Work divided among threads, unless there is only one or the work is too small.
//!
//! A call into a thread pool from outside wakes a thread and waits for it, which takes longer than some stages of a small pair. With one
//! thread, and without the feature `rayon`, the caller does all the work.

use core::cmp::Ordering;

/// Iterators whose items may go to several threads.
#[cfg(feature = "rayon")]
pub(crate) use rayon::prelude;
/// Sequential replacements under the same names; they run on the caller's thread.
#[cfg(not(feature = "rayon"))]
pub(crate) use sequential as prelude;

#[cfg(feature = "rayon")]
use rayon::prelude::*;

#[cfg(not(feature = "rayon"))]
pub(crate) mod sequential;

#[cfg(feature = "rayon")]
fn is_alone() -> bool {
    UNDIVIDED.get() || rayon::current_num_threads() == 1
}

#[cfg(feature = "rayon")]
std::thread_local! {
    /// Whether this thread does one of many pieces of work, which it must not divide further.
    static UNDIVIDED: core::cell::Cell<bool> = const { core::cell::Cell::new(false) };
}

/// The number of threads that work is divided among.
pub fn threads() -> usize {
    #[cfg(feature = "rayon")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "rayon"))]
    1
}

/// Results of `work` for every item and its number, in order. Items are distributed to several threads; each item is processed by one
/// thread.
pub(crate) fn each<T: Sync, R: Send>(
    items: &[T],
    work: impl Fn(usize, &T) -> R + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    if items.len() > 1 && !is_alone() {
        /// Restores the thread's previous setting, also if the work panics.
        struct Before(bool);
        impl Drop for Before {
            fn drop(&mut self) {
                UNDIVIDED.set(self.0);
            }
        }
        let undivided = |(i, item)| {
            let _before = Before(UNDIVIDED.replace(true));
            work(i, item)
        };
        return items.par_iter().enumerate().map(undivided).collect();
    }
    (items.iter().enumerate())
        .map(|(i, item)| work(i, item))
        .collect()
}

/// Runs work of several stages within the pool, so that it is entered only once.
pub(crate) fn within<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    #[cfg(feature = "rayon")]
    if !is_alone() {
        return rayon::scope(|_| work());
    }
    work()
}

/// Results of `work` for every item, in order. The items are divided among threads; each thread gets at least `least` items.
///
/// ```
/// let squares = cspace::parallel::map(&[1, 2, 3], 1, |x| x * x);
/// assert_eq!(squares, [1, 4, 9]);
/// ```
#[cfg_attr(not(feature = "rayon"), allow(unused_variables))]
pub fn map<T: Sync, R: Send>(
    items: &[T],
    least: usize,
    work: impl Fn(&T) -> R + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    if items.len() >= 2 * least && !is_alone() {
        let items = items.par_iter().with_min_len(least);
        return items.map(work).collect();
    }
    items.iter().map(work).collect()
}

/// Results of `work` for every chunk of `size` consecutive items, in order; `work` also gets the number of the chunk's first item.
pub(crate) fn chunks<T: Sync, R: Send>(
    items: &[T],
    size: usize,
    work: impl Fn(usize, &[T]) -> R + Sync,
) -> Vec<R> {
    let work = |(i, chunk)| work(i * size, chunk);
    #[cfg(feature = "rayon")]
    if items.len() > size && !is_alone() {
        return items.par_chunks(size).enumerate().map(work).collect();
    }
    items.chunks(size).enumerate().map(work).collect()
}

/// Results of `work` for the numbers below `count`, in order, written directly into the output. Each thread gets at least `least` numbers.
#[cfg_attr(not(feature = "rayon"), allow(unused_variables))]
pub(crate) fn numbered<R: Send>(
    count: usize,
    least: usize,
    work: impl Fn(usize) -> R + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    if count >= 2 * least && !is_alone() {
        let numbers = (0..count).into_par_iter().with_min_len(least);
        return numbers.map(work).collect();
    }
    (0..count).map(work).collect()
}

/// Results of both functions, which may run on two threads.
pub(crate) fn join<A: Send, B: Send>(
    first: impl FnOnce() -> A + Send,
    second: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "rayon")]
    if !is_alone() {
        return rayon::join(first, second);
    }
    (first(), second())
}

/// Stable sort.
pub(crate) fn sort_by<T: Send>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Sync) {
    #[cfg(feature = "rayon")]
    if !is_alone() {
        return items.par_sort_by(order);
    }
    items.sort_by(order);
}

/// Unstable sort: equal items may come in any order.
pub(crate) fn sort_unstable_by<T: Send>(
    items: &mut [T],
    order: impl Fn(&T, &T) -> Ordering + Sync,
) {
    #[cfg(feature = "rayon")]
    if !is_alone() {
        return items.par_sort_unstable_by(order);
    }
    items.sort_unstable_by(order);
}

#[cfg(all(test, feature = "rayon"))]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Results are in order, and equal for any number of threads.
    #[test]
    fn threads_do_not_matter() {
        let items: Vec<u64> = (0..5000).map(|i| i * 7919 % 5003).collect();
        let work = || {
            let (mut by_tens, mut sorted) = (items.clone(), items.clone());
            sort_by(&mut by_tens, |a, b| (a / 10).cmp(&(b / 10)));
            sort_unstable_by(&mut sorted, u64::cmp);
            let firsts = chunks(&items, 7, |first, chunk| (first, chunk.to_vec()));
            let (doubled, none) = join(|| map(&items, 3, |i| 2 * i), || map(&[0; 0], 3, |i| *i));
            (by_tens, sorted, firsts, doubled, none)
        };
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build().unwrap().install(|| within(work))
        };
        let alone = with(1);
        assert_eq!(alone, with(3));
        let mut by_tens = items.clone();
        by_tens.sort_by_key(|i| i / 10);
        assert_eq!(alone.0, by_tens);
        assert!(alone.1.is_sorted());
        for (first, chunk) in &alone.2 {
            assert_eq!(&items[*first..*first + chunk.len()], &chunk[..]);
        }
        assert!(alone.3.iter().zip(&items).all(|(d, i)| *d == 2 * i));
        assert_eq!((alone.2.len(), alone.4.len()), (5000usize.div_ceil(7), 0));
    }
}
