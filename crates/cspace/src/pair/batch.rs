//! Spaces of many pairs, computed in parallel.

use crate::parallel;
use crate::part::Part;
use crate::space::Options;

use super::relation::Relation;
use super::space::{PairError, PairSpace};

impl PairSpace {
    /// Computes the spaces of many pairs, passes each with the pair's number to `then`, and returns the results of `then`, in the order of
    /// the pairs.
    ///
    /// It is meant for many small pairs, such as the variants of a tolerance study: pairs go to the threads of the `rayon` pool from which
    /// it is called, and each is computed by a single thread, which is faster than dividing every one of them. A space is dropped after
    /// `then` unless `then` keeps it, so that memory does not grow with the number of pairs. The spaces are those of
    /// [`compute`](Self::compute), and the results do not depend on the number of threads.
    ///
    /// ```
    /// use cspace::{Options, PairSpace, Part, Relation};
    /// // How large a play does a pin need to be free in a hole, among 0, 0.1 and 0.2?
    /// let plate = |play: f64| {
    ///     let hole = Part::circle("hole", (0.0, 0.0), 1.0 + play)?.loops()[0].vertices().to_vec();
    ///     let edge = Part::rectangle("edge", (0.0, 0.0), 4.0, 4.0)?.loops()[0].vertices().to_vec();
    ///     Part::new("plate", vec![edge, hole])
    /// };
    /// let pin = Part::circle("pin", (0.0, 0.0), 1.0)?;
    /// let plates = [plate(0.0)?, plate(0.1)?, plate(0.2)?];
    /// let pairs: Vec<_> = plates.iter().map(|p| (p, &pin, Relation::Planar)).collect();
    /// let regions = PairSpace::compute_each(&pairs, &Options::default(), |_, space| {
    ///     space.map(|s| s.region_count())
    /// });
    /// // Beside the region outside there is one in the hole, where there is play.
    /// assert_eq!(regions, [Ok(1), Ok(2), Ok(2)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute_each<R: Send>(
        pairs: &[(&Part, &Part, Relation)],
        options: &Options,
        then: impl Fn(usize, Result<Self, PairError>) -> R + Sync + Send,
    ) -> Vec<R> {
        parallel::each(pairs, |i, &(fixed, moving, relation)| {
            then(i, Self::compute(fixed, moving, relation, options))
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::Vertex;

    /// Spaces are equal, and in order, on one thread, on several, and one by one.
    #[test]
    fn batches_are_spaces_one_by_one() {
        let star = |points: u32, inner: f64| {
            let at = |k: u32| {
                let angle = core::f64::consts::PI * f64::from(k) / f64::from(points);
                let r = if k.is_multiple_of(2) { 1.0 } else { inner };
                Vertex::new(r * angle.cos(), r * angle.sin(), 0.1 * inner)
            };
            Part::new("star", vec![(0..2 * points).map(at).collect()]).unwrap()
        };
        let parts: Vec<Part> = (0..12)
            .map(|k| star(2 + k % 4, 0.4 + 0.03 * f64::from(k)))
            .collect();
        let pairs: Vec<_> = (parts.windows(2))
            .map(|w| (&w[0], &w[1], Relation::Planar))
            .collect();
        let options = Options::default();
        let patches = |space: Result<PairSpace, PairError>| match space.unwrap() {
            PairSpace::Planar(space) => space.patches().to_vec(),
            _ => unreachable!(),
        };
        let one_by_one: Vec<_> = (pairs.iter())
            .map(|p| patches(PairSpace::compute(p.0, p.1, p.2, &options)))
            .collect();
        for threads in [1, 3] {
            let run = || PairSpace::compute_each(&pairs, &options, |i, space| (i, patches(space)));
            #[cfg(feature = "rayon")]
            let all = (rayon::ThreadPoolBuilder::new().num_threads(threads).build())
                .unwrap()
                .install(run);
            #[cfg(not(feature = "rayon"))]
            let all = {
                let _ = threads;
                run()
            };
            for (k, (i, found)) in all.into_iter().enumerate() {
                assert_eq!(i, k);
                assert!(found == one_by_one[k]);
            }
        }
    }
}
