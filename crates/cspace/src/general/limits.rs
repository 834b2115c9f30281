//! Limits of size: larger pairs are refused before they take memory and time out of all proportion.
//!
//! The limits do not depend on the machine or on the number of threads, so that a pair is refused everywhere or nowhere. Two outlines of
//! 2500 vertices each, which touch at every pair of features, are within all limits, with 15 gigabytes and some minutes.

/// The most edges of a part. A search over a part place by place, such as for its symmetry and for discs in its material, takes seconds;
/// and two parts make more contacts than [`MOST_SHEETS`] anyway, except for a few highly symmetric ones.
pub(crate) const MOST_EDGES: usize = 1 << 18;

/// The largest product of the parts' numbers of edges. Ends of sheets are numbered by features and joints, of which there are up to two for
/// each edge: at most 12 names for each pair of edges, which fit into 32 bits.
pub(crate) const MOST_EDGE_PAIRS: usize = 1 << 23;

/// The most sheets. At some 300 bytes each they take 4 gigabytes; polygons have one to two for each pair of edges.
pub(crate) const MOST_SHEETS: usize = 3 << 22;

/// The most patches. With their links they take some 450 bytes each: 4 gigabytes. Symmetric parts have a copy of each patch in every period
/// of a turn.
pub(crate) const MOST_PATCHES: usize = 1 << 23;

/// The most meetings of two sheets' boxes, counted in every interval of orientations: 4 gigabytes, some minutes.
pub(crate) const MOST_MEETINGS: usize = 1 << 28;

/// The most meetings of two sheets' boxes in one interval: half a gigabyte. These are of pairs that all differ, except for sheets of
/// several pieces and sheets that never cross: with more of them there are more than [`MOST_CROSSING`].
pub(crate) const MOST_IN_SLOT: usize = 2 * MOST_CROSSING;

/// The most pairs of sheets that may cross. Each takes some 600 bytes until the computation ends, for its events, its branches and the
/// cells into which these cut: 20 gigabytes, some minutes.
pub(crate) const MOST_CROSSING: usize = 1 << 25;
