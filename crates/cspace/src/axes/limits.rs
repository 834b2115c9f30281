//! How large a pair with fixed axes may be: what is refused before it takes memory and time out of all proportion.

/// The largest product of the parts' numbers of edges. Each pair of features is looked at, if only for whether it can touch:
/// about a minute.
pub(super) const MOST_EDGE_PAIRS: usize = 1 << 26;

/// The most meetings of two contact curves' boxes: a tenth of a gigabyte, and where all of them cross and make cells of their
/// own one gigabyte, and a minute.
pub(super) const MOST_MEETINGS: usize = 1 << 23;
