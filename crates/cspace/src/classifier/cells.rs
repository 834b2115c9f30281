//! Contents of the cells of a grid, packed.

use super::grid::TILE;
use super::walk::Content;

/// Content of a cell that has patches: one patch, or a list of patches.
///
/// A list is stored as its index with the highest bit set; the first number at that index is the length of the list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Entry(u32);

const LIST: u32 = 1 << 31;

impl Entry {
    /// Entry of a cell that has not been examined.
    pub(super) const UNKNOWN: Self = Self(0);

    /// An entry for patches; if there are more than one, they are appended to the lists.
    pub(super) fn listed(patches: &[u32], lists: &mut Vec<u32>) -> Self {
        if let [patch] = *patches {
            return Self(patch);
        }
        let at = lists.len() as u32;
        lists.push(patches.len() as u32);
        lists.extend(patches);
        Self(LIST | at)
    }

    /// The patches of a cell that is not pure.
    #[inline]
    pub(super) fn patches<'a>(&'a self, lists: &'a [u32]) -> &'a [u32] {
        if self.0 & LIST == 0 {
            return core::slice::from_ref(&self.0);
        }
        let at = (self.0 & !LIST) as usize;
        &lists[at + 1..][..lists[at] as usize]
    }
}

/// A square of cells, at least one of which has patches or differs from the others.
#[derive(Debug, Clone, Copy)]
struct Tile {
    /// Bit set of the cells that have patches, by rows.
    mixed: u64,
    /// Bit set of the cells without patches that are free.
    free: u64,
    /// Index of the first of the tile's entries.
    first: u32,
}

/// Cells of a tile that are free at all orientations, and those that are blocked at all.
#[derive(Debug, Clone, Copy)]
struct Constant {
    free: u64,
    blocked: u64,
}

const FREE_TILE: u32 = 0;
const BLOCKED_TILE: u32 = 1;
const FIRST_TILE: u32 = 2;

/// The cells of all intervals of orientation, one interval after the other.
#[derive(Debug, Clone, Default)]
pub(super) struct CellStore {
    /// For each interval and tile: free, blocked, or a tile's index plus [`FIRST_TILE`].
    directory: Vec<u32>,
    tiles: Vec<Tile>,
    /// The content of mixed cells.
    entries: Vec<Entry>,
    lists: Vec<u32>,
    /// Constant cells, for each tile of positions: so few that they stay in the nearest cache, and they decide most queries.
    constant: Vec<Constant>,
}

impl CellStore {
    /// Lists of patches, to which those of the next intervals are appended.
    pub(super) fn lists(&mut self) -> &mut Vec<u32> {
        &mut self.lists
    }

    pub(super) fn patches<'a>(&'a self, entry: &'a Entry) -> &'a [u32] {
        entry.patches(&self.lists)
    }

    /// Appends a tile of the current interval: the cells that have patches, the other cells that are free, by rows, and the contents of the
    /// former. Tiles come by rows.
    pub(super) fn add(&mut self, mixed: u64, free: u64, entries: impl Iterator<Item = Entry>) {
        self.directory.push(match (mixed, free) {
            (0, u64::MAX) => FREE_TILE,
            (0, 0) => BLOCKED_TILE,
            _ => {
                let first = self.entries.len() as u32;
                self.tiles.push(Tile { mixed, free, first });
                self.entries.extend(entries);
                FIRST_TILE + self.tiles.len() as u32 - 1
            }
        });
    }

    /// Appends the intervals of another store.
    pub(super) fn append(&mut self, other: &Self) {
        let tiles = self.tiles.len() as u32;
        let entries = self.entries.len() as u32;
        let lists = self.lists.len() as u32;
        let later = |&t: &u32| if t < FIRST_TILE { t } else { t + tiles };
        self.directory.extend(other.directory.iter().map(later));
        self.tiles.extend(other.tiles.iter().map(|t| Tile {
            first: t.first + entries,
            ..*t
        }));
        let moved = |e: &Entry| Entry(if e.0 & LIST == 0 { e.0 } else { e.0 + lists });
        self.entries.extend(other.entries.iter().map(moved));
        self.lists.extend(&other.lists);
    }

    /// Finds the cells that are constant over all intervals, when all intervals are there; frees unused memory.
    pub(super) fn finish(&mut self, side: usize) {
        let tiles = (side / TILE) * (side / TILE);
        let all = Constant {
            free: u64::MAX,
            blocked: u64::MAX,
        };
        self.constant = vec![all; tiles];
        for slot in self.directory.chunks(tiles) {
            for (constant, &tile) in self.constant.iter_mut().zip(slot) {
                let (free, blocked) = match tile {
                    FREE_TILE => (u64::MAX, 0),
                    BLOCKED_TILE => (0, u64::MAX),
                    _ => {
                        let tile = self.tiles[(tile - FIRST_TILE) as usize];
                        (tile.free, !(tile.free | tile.mixed))
                    }
                };
                constant.free &= free;
                constant.blocked &= blocked;
            }
        }
        self.directory.shrink_to_fit();
        self.tiles.shrink_to_fit();
        self.entries.shrink_to_fit();
        self.lists.shrink_to_fit();
    }

    /// Content of a cell at one interval of orientations.
    #[inline]
    pub(super) fn content(
        &self,
        side: usize,
        slot: usize,
        column: usize,
        row: usize,
    ) -> Content<'_> {
        let tiles = side / TILE;
        let place = (row / TILE) * tiles + column / TILE;
        let bit = (row % TILE) * TILE + column % TILE;
        let constant = &self.constant[place];
        if (constant.free | constant.blocked) >> bit & 1 == 1 {
            return Content::Pure {
                free: constant.free >> bit & 1 == 1,
            };
        }
        let tile = self.directory[slot * tiles * tiles + place];
        if tile < FIRST_TILE {
            return Content::Pure {
                free: tile == FREE_TILE,
            };
        }
        let tile = &self.tiles[(tile - FIRST_TILE) as usize];
        if tile.mixed >> bit & 1 == 0 {
            return Content::Pure {
                free: tile.free >> bit & 1 == 1,
            };
        }
        let before = (tile.mixed & ((1 << bit) - 1)).count_ones();
        let entry = &self.entries[(tile.first + before) as usize];
        Content::Mixed(entry.patches(&self.lists))
    }

    /// Number of bytes in memory.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>()
            + size_of_val(&*self.directory)
            + size_of_val(&*self.tiles)
            + size_of_val(&*self.entries)
            + size_of_val(&*self.lists)
            + size_of_val(&*self.constant)
    }
}
