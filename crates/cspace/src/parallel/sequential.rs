//! Sequential replacements, under their names, of the iterators of `rayon` used here; they run on the caller's thread.

use core::slice::Iter;

/// Iteration over a slice by reference, under `rayon`'s name.
pub(crate) trait ByReference<T> {
    fn par_iter(&self) -> Iter<'_, T>;
}

impl<T> ByReference<T> for [T] {
    fn par_iter(&self) -> Iter<'_, T> {
        self.iter()
    }
}

/// Methods of `rayon`'s parallel iterators that ordinary iterators lack.
pub(crate) trait Divided: Iterator + Sized {
    /// Minimum number of items per thread; ignored here.
    fn with_min_len(self, _: usize) -> Self {
        self
    }

    fn flat_map_iter<U: IntoIterator, F: FnMut(Self::Item) -> U>(
        self,
        work: F,
    ) -> core::iter::FlatMap<Self, U, F> {
        self.flat_map(work)
    }
}

impl<I: Iterator> Divided for I {}
