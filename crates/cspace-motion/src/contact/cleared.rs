//! Cache of the parts of a motion in which pairs meet nothing, for trials with shorter steps.

use super::bound::Bound;
use super::path::Path;

/// Longest steps from one state, with the same bounds held, in which pairs met nothing.
#[derive(Debug)]
pub(super) struct Cleared {
    /// The coordinates and rates with which they begin.
    begin: [Vec<f64>; 2],
    held: Vec<Bound>,
    /// Duration of the longest step in which each pair met nothing, s.
    until: Vec<f64>,
}

impl Cleared {
    /// Creates an empty record for a number of pairs.
    pub(super) fn new(pairs: usize) -> Self {
        Self {
            begin: [Vec::new(), Vec::new()],
            held: Vec::new(),
            until: vec![0.0; pairs],
        }
    }

    /// Prepares for a step with some bounds held. Results of steps that begin in another state are discarded.
    pub(super) fn begin(&mut self, held: &[Bound], path: &Path<'_>) {
        let begin = [path.from(), path.begins()];
        let is_same = self.begin.iter().zip(begin).all(|(a, b)| a == b) && self.held == held;
        if !is_same {
            self.begin = begin.map(<[f64]>::to_vec);
            self.held = held.to_vec();
            self.until.fill(0.0);
        }
    }

    /// Whether the pair met nothing in a step that was at least as long.
    pub(super) fn covers(&self, pair: usize, path: &Path<'_>) -> bool {
        path.duration() <= self.until[pair]
    }

    /// Records that a pair met nothing in the step.
    pub(super) fn tell(&mut self, pair: usize, path: &Path<'_>) {
        self.until[pair] = self.until[pair].max(path.duration());
    }
}
