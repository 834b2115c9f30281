//! Turns of those parts that turn without limits.

use core::f64::consts::TAU;

use crate::modes::turns::Turns;

/// The most parts that turn without limits.
pub(crate) const MOST_TURNING: usize = 16;

/// Turns of the parts that turn without limits, in order.
pub(crate) type Whole = Turns<MOST_TURNING>;

/// The coordinates that repeat after a turn.
#[derive(Debug)]
pub(crate) struct Turning(pub(crate) Vec<usize>);

impl Turning {
    /// So many turns of one coordinate; of one that does not repeat none.
    pub(crate) fn of_one(&self, coordinate: usize, turns: i32) -> Whole {
        let mut whole = [0; MOST_TURNING];
        if let Some(k) = self.0.iter().position(|&c| c == coordinate) {
            whole[k] = turns;
        }
        whole
    }

    /// Angle by which turns move a coordinate.
    pub(crate) fn angle(&self, coordinate: usize, whole: &Whole) -> f64 {
        let k = self.0.iter().position(|&c| c == coordinate);
        k.map_or(0.0, |k| TAU * f64::from(whole[k]))
    }

    /// The turns of all of `n` coordinates.
    pub(crate) fn of_all(&self, n: usize, whole: &[i64; MOST_TURNING]) -> Vec<i64> {
        let mut all = vec![0; n];
        for (k, &coordinate) in self.0.iter().enumerate() {
            all[coordinate] = whole[k];
        }
        all
    }
}
