//! Counts over all pairs.

use core::fmt;

use serde::{Deserialize, Serialize};

use crate::report::{Fault, Report};

/// Counts over all pairs so far.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Pairs drawn.
    pub pairs: u64,
    /// Pairs of which one of the outlines was refused as a part.
    pub refused: u64,
    /// Pairs given up after the time limit.
    pub given_up: u64,
    /// Number of configurations asked.
    pub asked: u64,
    /// Configurations for which the oracle's verdict counts.
    pub certain: u64,
    /// Certain configurations beside contact.
    pub near: u64,
    /// Certain configurations that are free.
    pub free: u64,
    /// Certain configurations that are classified otherwise than by the oracle.
    pub wrong: u64,
    /// Pairs with a wrong configuration.
    pub wrong_pairs: u64,
    /// Slices taken from contact spaces.
    #[serde(default)]
    pub slices: u64,
    /// Slices that are doubtful.
    #[serde(default)]
    pub doubtful_slices: u64,
    /// Certain configurations that doubtful slices classify wrongly, while the space classifies them correctly.
    #[serde(default)]
    pub doubtful_wrong: u64,
    /// Pairs with such configurations.
    #[serde(default)]
    pub doubtful_wrong_pairs: u64,
    /// Configurations classified otherwise than by the oracle, certain beyond the margin, but nearer to contact than
    /// the resolution that the space itself reports.
    pub within_resolution: u64,
    /// Bands compared with slices from scratch.
    pub bands: u64,
    /// Bands of which one of the two slices is doubtful.
    #[serde(default)]
    pub doubtful_bands: u64,
    /// Configurations at which a slice from scratch disagrees with the oracle, and is not doubtful.
    #[serde(default)]
    pub scratch_wrong: u64,
    /// Bands whose two slices have different numbers of loops.
    pub loops_differ: u64,
    /// Slices in which a curve does not begin where the one before it ends, and that are not doubtful.
    pub open: u64,
    /// Pairs with shells that were decided cell by cell.
    pub conflict_pairs: u64,
    /// Number of such shells.
    pub conflicts: u64,
    /// Pairs checked thoroughly: by one thread and two, with exchanged parts, and with a classifier.
    pub thorough: u64,
    /// Pairs for which one thread and two give different results.
    pub threads_differ: u64,
    /// Pairs whose space is not read back from its data.
    #[serde(default)]
    pub saved_differ: u64,
    /// Configurations at which the inverse pair disagrees with the oracle.
    pub inverse_wrong: u64,
    /// Configurations at which the classifier disagrees with the slice.
    pub classifier_differs: u64,
    /// Pairs at which the library panicked.
    pub panics: u64,
    /// Pairs that took longer than the watchdog's patience.
    pub slow: u64,
    /// The longest a contact space took, seconds.
    pub slowest: f64,
    /// The largest contact space, bytes of its patches and links.
    pub largest_bytes: u64,
    /// The largest number of feature pairs (product of the numbers of features).
    pub largest_pair: u64,
    /// Processor seconds, all pairs together.
    pub seconds: f64,
}

impl Tally {
    /// Counts one more pair.
    pub fn count(&mut self, report: &Report) {
        self.asked += report.asked;
        self.certain += report.certain;
        self.near += report.near;
        self.free += report.free;
        self.within_resolution += report.within_resolution;
        self.slices += report.slices;
        self.doubtful_slices += report.doubtful_slices;
        self.doubtful_wrong += report.doubtful_wrong;
        self.doubtful_wrong_pairs += u64::from(report.doubtful_wrong > 0);
        self.bands += report.bands;
        self.doubtful_bands += report.doubtful_bands;
        self.conflicts += report.conflicts;
        self.conflict_pairs += u64::from(report.conflicts > 0);
        self.thorough += u64::from(report.thorough);
        self.slowest = self.slowest.max(report.computed);
        self.largest_bytes = self.largest_bytes.max(report.bytes);
        self.largest_pair = self.largest_pair.max(report.feature_pairs);
        let mut wrong = false;
        for fault in &report.faults {
            match fault {
                Fault::Wrong { .. } => {
                    self.wrong += 1;
                    wrong = true;
                }
                Fault::Scratch { .. } => self.scratch_wrong += 1,
                Fault::Loops { .. } => self.loops_differ += 1,
                Fault::Open { .. } => self.open += 1,
                Fault::Threads => self.threads_differ += 1,
                Fault::Saved => self.saved_differ += 1,
                Fault::Inverse { .. } => self.inverse_wrong += 1,
                Fault::Classifier { .. } => self.classifier_differs += 1,
            }
        }
        self.wrong_pairs += u64::from(wrong);
    }

    /// Adds the counts of another.
    pub fn add(&mut self, other: &Self) {
        let sums: [(&mut u64, u64); 27] = [
            (&mut self.pairs, other.pairs),
            (&mut self.refused, other.refused),
            (&mut self.given_up, other.given_up),
            (&mut self.asked, other.asked),
            (&mut self.certain, other.certain),
            (&mut self.near, other.near),
            (&mut self.free, other.free),
            (&mut self.wrong, other.wrong),
            (&mut self.wrong_pairs, other.wrong_pairs),
            (&mut self.slices, other.slices),
            (&mut self.doubtful_slices, other.doubtful_slices),
            (&mut self.doubtful_wrong, other.doubtful_wrong),
            (&mut self.doubtful_wrong_pairs, other.doubtful_wrong_pairs),
            (&mut self.within_resolution, other.within_resolution),
            (&mut self.bands, other.bands),
            (&mut self.doubtful_bands, other.doubtful_bands),
            (&mut self.scratch_wrong, other.scratch_wrong),
            (&mut self.loops_differ, other.loops_differ),
            (&mut self.open, other.open),
            (&mut self.conflict_pairs, other.conflict_pairs),
            (&mut self.conflicts, other.conflicts),
            (&mut self.thorough, other.thorough),
            (&mut self.threads_differ, other.threads_differ),
            (&mut self.saved_differ, other.saved_differ),
            (&mut self.inverse_wrong, other.inverse_wrong),
            (&mut self.classifier_differs, other.classifier_differs),
            (&mut self.panics, other.panics),
        ];
        for (sum, more) in sums {
            *sum += more;
        }
        self.slow += other.slow;
        self.slowest = self.slowest.max(other.slowest);
        self.largest_bytes = self.largest_bytes.max(other.largest_bytes);
        self.largest_pair = self.largest_pair.max(other.largest_pair);
        self.seconds += other.seconds;
    }

    /// Whether no faults were found. Conflicts are decided by another method and do not count, nor do slow pairs.
    pub fn is_clean(&self) -> bool {
        [
            self.wrong,
            self.scratch_wrong,
            self.loops_differ,
            self.open,
            self.threads_differ,
            self.saved_differ,
            self.inverse_wrong,
            self.classifier_differs,
            self.panics,
            self.given_up,
        ]
        .iter()
        .all(|&n| n == 0)
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows: [(&str, String); 18] = [
            (
                "pairs",
                format!("{} ({} refused as parts)", self.pairs, self.refused),
            ),
            ("configurations asked", self.asked.to_string()),
            (
                "certain",
                format!(
                    "{} ({} near contact, {} free)",
                    self.certain, self.near, self.free
                ),
            ),
            (
                "wrong",
                format!("{} in {} pairs", self.wrong, self.wrong_pairs),
            ),
            (
                "doubtful slices",
                format!(
                    "{} of {}, wrong at {} in {} pairs",
                    self.doubtful_slices,
                    self.slices,
                    self.doubtful_wrong,
                    self.doubtful_wrong_pairs
                ),
            ),
            ("within the resolution", self.within_resolution.to_string()),
            (
                "bands sliced from scratch",
                format!("{} ({} doubtful)", self.bands, self.doubtful_bands),
            ),
            ("slices from scratch wrong", self.scratch_wrong.to_string()),
            ("other number of loops", self.loops_differ.to_string()),
            ("loops not closed", self.open.to_string()),
            (
                "conflicts",
                format!("{} in {} pairs", self.conflicts, self.conflict_pairs),
            ),
            ("pairs looked at thoroughly", self.thorough.to_string()),
            (
                "threads, saved, inverse, classifier",
                format!(
                    "{} and {} differ, {} wrong, {} differ",
                    self.threads_differ,
                    self.saved_differ,
                    self.inverse_wrong,
                    self.classifier_differs
                ),
            ),
            ("panics", self.panics.to_string()),
            (
                "slow, given up",
                format!("{}, {}", self.slow, self.given_up),
            ),
            ("slowest contact space", format!("{:.2} s", self.slowest)),
            (
                "largest contact space",
                format!(
                    "{:.1} MB; most feature pairs {}",
                    self.largest_bytes as f64 * 1e-6,
                    self.largest_pair
                ),
            ),
            ("processor time", format!("{:.0} s", self.seconds)),
        ];
        for (name, value) in rows {
            writeln!(f, "{name:<37}{value}")?;
        }
        Ok(())
    }
}
