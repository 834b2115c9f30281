//! Sums over specimens.

use std::fmt;

use super::{Flood, Outcome, Specimen};

/// Doubtful orientations of more than this, radians, are counted.
const DOUBTFUL: [f64; 3] = [1e-9, 1e-6, 1e-3];

/// Sums over several specimens.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Totals {
    /// Specimens measured, or that panicked.
    pub pairs: u64,
    /// Specimens with a conflict.
    pub conflicts: u64,
    /// Specimens that are doubtful for more than 10⁻⁹, 10⁻⁶ and 10⁻³ rad.
    pub doubtful: [u64; 3],
    /// Specimens of which the number of free regions is known.
    pub expected: u64,
    /// Specimens that have another number than the known one.
    pub wrong: u64,
    /// Specimens whose regions a flood fill contradicts.
    pub flooded: u64,
    /// Specimens with more free regions than a flood fill, which may miss pockets smaller than a box.
    pub fewer: u64,
    /// Specimens for which a flood fill determines the number of regions, but for such pockets.
    pub told: u64,
    /// Specimens with another number of free regions when fixed and moving part are exchanged.
    pub unequal: u64,
    /// Specimens at which the library panicked.
    pub panics: u64,
    /// Outlines that are no parts, and pairs that have no space or not in time.
    pub refused: u64,
    /// Duration of the computations.
    pub seconds: f64,
}

impl Totals {
    /// Counts one.
    pub fn count(&mut self, specimen: &Specimen, outcome: &Outcome) {
        let m = match outcome {
            Outcome::Measured(m) => m,
            Outcome::Panicked(_) => {
                self.pairs += 1;
                self.panics += 1;
                return;
            }
            Outcome::Refused(_) | Outcome::GivenUp(_) => {
                self.refused += 1;
                return;
            }
        };
        self.pairs += 1;
        self.conflicts += u64::from(m.conflicts > 0);
        for (count, least) in self.doubtful.iter_mut().zip(DOUBTFUL) {
            *count += u64::from(m.doubtful > least);
        }
        self.expected += u64::from(specimen.expected.is_some());
        self.wrong += u64::from(specimen.expected.is_some_and(|n| n != m.regions));
        self.flooded += u64::from(matches!(m.flood, Some(Flood::Wrong(_))));
        self.fewer += u64::from(matches!(m.flood, Some(Flood::Fewer(_))));
        let told = matches!(m.flood, Some(Flood::Agrees(_) | Flood::Fewer(_)));
        self.told += u64::from(told);
        self.unequal += u64::from(m.inverse.is_some_and(|n| n != m.regions));
        self.seconds += m.seconds;
    }

    /// Heading of the columns, as wide as [`Display`](fmt::Display) makes them.
    pub fn heading() -> &'static str {
        " pairs conflict   >1e-9   >1e-6   >1e-3  wrong/known   flood wrong+fewer/told unequal panics refused   seconds"
    }
}

impl fmt::Display for Totals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.doubtful;
        let wrong = format!("{}/{}", self.wrong, self.expected);
        let flood = format!("{}+{}/{}", self.flooded, self.fewer, self.told);
        write!(
            f,
            "{:6} {:8} {a:7} {b:7} {c:7} {wrong:>12} {flood:>24} {:7} {:6} {:7} {:9.1}",
            self.pairs, self.conflicts, self.unequal, self.panics, self.refused, self.seconds
        )
    }
}
