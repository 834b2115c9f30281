//! Results for one pair.

use cspace::{Classification, Configuration, ContactSpace};
use cspace_oracle::Verdict;

/// Fault: a result that must not occur.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fault {
    /// A configuration is classified otherwise than by brute force.
    Wrong {
        /// Configuration.
        at: Configuration,
        /// Verdict of brute force.
        verdict: Verdict,
    },
    /// A slice from scratch that is not doubtful disagrees with brute force.
    Scratch {
        /// Configuration.
        at: Configuration,
        /// Verdict of brute force.
        verdict: Verdict,
    },
    /// In the middle of a band the slice of the space and that from scratch have different numbers of loops, and neither is
    /// doubtful.
    Loops {
        /// The orientation.
        theta: f64,
        /// Loops of the space's slice.
        space: usize,
        /// Loops of the slice from scratch.
        scratch: usize,
        /// The width of the band.
        width: f64,
    },
    /// A curve of a slice of the space that is not doubtful does not begin where the one before it ends.
    Open {
        /// The orientation.
        theta: f64,
        /// Distance of the ends, as a share of the size.
        gap: f64,
    },
    /// One thread and two give different contact spaces.
    Threads,
    /// The space is not read back as plain data.
    Saved,
    /// The inverse pair disagrees with brute force.
    Inverse {
        /// Configuration of the pair itself.
        at: Configuration,
        /// Verdict of brute force.
        verdict: Verdict,
    },
    /// The classifier disagrees with the slice.
    Classifier {
        /// Configuration.
        at: Configuration,
    },
}

/// Results for one pair.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Number of configurations asked.
    pub asked: u64,
    /// Configurations whose verdict counts.
    pub certain: u64,
    /// Certain configurations beside contact.
    pub near: u64,
    /// Certain configurations that are free.
    pub free: u64,
    /// Configurations classified otherwise than by the oracle, but nearer to contact than [`ContactSpace::resolution`].
    pub within_resolution: u64,
    /// Slices taken from the contact space.
    pub slices: u64,
    /// Slices that are doubtful.
    pub doubtful_slices: u64,
    /// Configurations that doubtful slices classify otherwise than the oracle, while the space classifies them
    /// correctly.
    pub doubtful_wrong: u64,
    /// Bands sliced from scratch.
    pub bands: u64,
    /// Bands of which one of the two slices is doubtful: their loops are not counted.
    pub doubtful_bands: u64,
    /// Shells decided cell by cell.
    pub conflicts: u64,
    /// Whether the thorough checks were done.
    pub thorough: bool,
    /// Bytes of patches and links.
    pub bytes: u64,
    /// Features of one part times those of the other.
    pub feature_pairs: u64,
    /// Seconds the contact space took.
    pub computed: f64,
    /// Faults found.
    pub faults: Vec<Fault>,
}

/// Whether the space classifies a configuration as brute force does.
pub(crate) fn is_right(space: &ContactSpace, c: Configuration, verdict: Verdict) -> bool {
    let expected = if verdict.overlap {
        Classification::Blocked
    } else {
        Classification::Free
    };
    space.classify(c) == Some(expected)
}
