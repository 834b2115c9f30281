//! How large a pair may be: what is refused before it takes memory and time out of all proportion.
//!
//! None of these limits depends on the machine or on the number of threads, so that a pair is refused everywhere or nowhere.

/// The most edges of a part. Whatever is asked of a part place by place, such as its symmetry and where its material is, takes
/// seconds; and two parts make more contacts than [`MOST_SHEETS`] anyway, but for a few that are almost all symmetry.
pub(super) const MOST_EDGES: usize = 1 << 18;

/// The largest product of the parts' numbers of edges. Ends of sheets are numbered by features and joints, of which
/// there are up to two for each edge: 12 names for each pair of edges at most, which 32 bits have room for.
pub(super) const MOST_EDGE_PAIRS: usize = 1 << 23;

/// The most sheets. At some 250 bytes each they take half a gigabyte; polygons have up to two for each pair of edges.
pub(super) const MOST_SHEETS: usize = 1 << 24;

/// The most patches. With their links they take a kilobyte each: 2 gigabytes. Symmetric parts have a patch over and over,
/// once for every slab of a turn.
pub(super) const MOST_PATCHES: usize = 1 << 24;

/// The most meetings of two sheets' boxes, counted in every slot of orientations: half a gigabyte, some minutes.
pub(super) const MOST_MEETINGS: usize = 1 << 29;

/// The most pairs of sheets that may cross. Each takes up to a kilobyte until the computation ends, for its events, its
/// branches and the cells that these cut: 4 gigabytes, some minutes.
pub(super) const MOST_CROSSING: usize = 1 << 25;
