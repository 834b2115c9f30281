//! Work on many items: by the threads of the `rayon` pool, or without the feature `rayon` by the caller's thread.

#[cfg(feature = "rayon")]
pub(crate) use rayon::prelude;

/// Sequential replacement, under its name, of the iterator of `rayon` used here.
#[cfg(not(feature = "rayon"))]
pub(crate) mod prelude {
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
}
