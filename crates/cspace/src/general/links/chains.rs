//! Chains of free cells that continue each other without a change of bounds: each makes a patch, and all its copies.

use core::f64::consts::TAU;

use crate::contact::{Curve, Geometry, Seam, Sheet};

use crate::general::cells::cell::{Cell, END};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::verdict::shells::Shells;

/// Bound of a cell, in terms that do not depend on how sheets were cut: an end of features, or a crossing with a feature pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum BoundKey {
    End(u32),
    Crossing {
        fixed: u32,
        moving: u32,
        root: u8,
        enters: bool,
    },
}

/// A cluster, and the number of periods by which it lies above the reference period.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ClusterInPeriod {
    pub(crate) cluster: u32,
    pub(crate) slabs: i32,
}

/// A chain of cells that make one patch.
#[derive(Debug)]
pub(crate) struct Chain {
    pub(crate) first: u32,
    pub(crate) last: u32,
    /// Beginning, in the period of its first cell, and end.
    pub(crate) from: ClusterInPeriod,
    pub(crate) to: ClusterInPeriod,
    /// Orientations of both ends, in radians.
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether the chain goes around the whole turn and continues itself.
    pub(crate) closed: bool,
}

/// The chain of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Member {
    pub(crate) chain: u32,
    /// Number of periods above the chain's first cell.
    pub(crate) slabs: i32,
}

impl Member {
    /// Placeholder: the cell is in no chain.
    const NONE: Self = Self {
        chain: NONE,
        slabs: 0,
    };

    fn is_some(self) -> bool {
        self.chain != NONE
    }

    /// Number of periods above the chain's first cell.
    pub(crate) fn slabs(self) -> i64 {
        i64::from(self.slabs)
    }
}

/// All chains, in the order of their smallest cells.
#[derive(Debug)]
pub(crate) struct Chains {
    pub(crate) chains: Vec<Chain>,
    /// For every cell its chain, if the cell is free.
    pub(crate) members: Members,
}

/// For every cell its chain.
#[derive(Debug, Default)]
pub(crate) struct Members(Vec<Member>);

impl Members {
    /// The chain of a cell, if it is free.
    pub(crate) fn of(&self, cell: u32) -> Option<Member> {
        Some(self.0[cell as usize]).filter(|m| m.is_some())
    }
}

/// Data from which chains are linked.
#[derive(Clone, Copy)]
pub(crate) struct Linker<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) clusters: &'a Clusters,
    pub(crate) branches: &'a [Branch],
    pub(crate) cells: &'a [Cell],
}

/// Placeholder for a cell.
const NONE: u32 = u32::MAX;

impl<'a> Linker<'a> {
    pub(crate) fn sheet(&self, cell: u32) -> &'a Sheet {
        &self.geometry.contacts.sheets[self.cells[cell as usize].sheet as usize]
    }

    /// The curve of a cell's sheet at a cluster.
    pub(crate) fn curve(&self, cell: u32, at: u32) -> Curve {
        let (theta, turn) = (self.clusters.exact_at(at), self.clusters.turn(at));
        (self.geometry).rounded_curve(self.cells[cell as usize].sheet, theta, turn)
    }

    /// Whether a cell ends at the end of the period, and continues at its beginning.
    pub(crate) fn is_wrap(&self, lower: u32) -> bool {
        matches!(self.sheet(lower).top, Seam::Wrap(..)) && self.cells[lower as usize].at_top
    }

    /// The number of a branch's root as seen from one of its sheets: sides are exchanged between two circles, and with a large circle.
    pub(crate) fn own_root(&self, b: &Branch, sheet: u32) -> u8 {
        let sheets = &self.geometry.contacts.sheets;
        let (f, g) = (&sheets[b.first as usize], &sheets[b.second as usize]);
        let exchanged = f.is_circle() && g.is_circle() || f.is_flat_arc() || g.is_flat_arc();
        if exchanged && b.second == sheet {
            1 - b.root
        } else {
            b.root
        }
    }

    /// Bounds of a cell; with `below`, the corresponding bounds one period lower.
    fn keys(&self, cell: u32, below: bool) -> [BoundKey; 2] {
        let c = &self.cells[cell as usize];
        let sheet = self.sheet(cell);
        let contacts = &self.geometry.contacts;
        let key = |bound: u32, end: u32| {
            if bound == END {
                return BoundKey::End(if below { contacts.name_below(end) } else { end });
            }
            let b = &self.branches[bound as usize];
            let other = &contacts.sheets[b.other(c.sheet) as usize];
            let (fixed, moving) = self.pair(other, below);
            BoundKey::Crossing {
                fixed,
                moving,
                root: self.own_root(b, c.sheet),
                enters: b.enters(c.sheet),
            }
        };
        [key(c.left, sheet.start.name), key(c.right, sheet.end.name)]
    }

    fn pair(&self, sheet: &Sheet, below: bool) -> (u32, u32) {
        if below {
            self.geometry.contacts.pair_below(sheet.fixed, sheet.moving)
        } else {
            (sheet.fixed, sheet.moving)
        }
    }

    /// Whether the upper cell continues the lower one without a change: the same features between the same bounds.
    fn same(&self, lower: u32, upper: u32) -> bool {
        let below = self.is_wrap(lower);
        self.pair(self.sheet(lower), below) == self.pair(self.sheet(upper), false)
            && self.keys(lower, below) == self.keys(upper, false)
    }

    pub(crate) fn chains(&self, shells: &Shells) -> Chains {
        let n = self.cells.len();
        let (mut up, mut down) = (vec![NONE; n], vec![NONE; n]);
        for v in &shells.vertical {
            let (l, u) = (v.lower as usize, v.upper as usize);
            let open = up[l] == NONE && down[u] == NONE;
            if shells.free[l] && shells.free[u] && open && self.same(v.lower, v.upper) {
                up[l] = v.upper;
                down[u] = v.lower;
            }
        }
        let mut members = vec![Member::NONE; n];
        // Chains, with the smallest cell of each.
        let mut found: Vec<(u32, Chain)> = Vec::new();
        // First the chains with a first cell; the remaining ones go around the turn.
        for first in [true, false] {
            for i in 0..n as u32 {
                let free = shells.free[i as usize] && !members[i as usize].is_some();
                if free && (!first || down[i as usize] == NONE) {
                    let number = found.len() as u32;
                    found.push(self.follow(i, number, &up, &mut members));
                }
            }
        }
        // Chains are in the order of their smallest cells, however they were found.
        let mut order: Vec<u32> = (0..found.len() as u32).collect();
        order.sort_by_key(|&c| found[c as usize].0);
        let mut rank = vec![0u32; found.len()];
        for (r, &c) in (0..).zip(&order) {
            rank[c as usize] = r;
        }
        for m in members.iter_mut().filter(|m| m.is_some()) {
            m.chain = rank[m.chain as usize];
        }
        found.sort_by_key(|f| f.0);
        Chains {
            chains: found.into_iter().map(|f| f.1).collect(),
            members: Members(members),
        }
    }

    /// Follows cells upwards as long as they are in no chain, and for at most a turn.
    fn follow(&self, first: u32, chain: u32, up: &[u32], members: &mut [Member]) -> (u32, Chain) {
        let steps = &self.geometry.contacts.period.steps;
        let from = ClusterInPeriod {
            cluster: self.cells[first as usize].from,
            slabs: 0,
        };
        let lo = self.clusters.at(from.cluster);
        let (mut last, mut slabs, mut smallest) = (first, 0, first);
        let member = |slabs: i64| Member {
            chain,
            slabs: slabs as i32,
        };
        members[first as usize] = member(slabs);
        let top = |cell: u32, slabs: i64| {
            self.clusters.at(self.cells[cell as usize].to) + steps.period(slabs)
        };
        let mut closed = false;
        loop {
            let next = up[last as usize];
            if next == NONE {
                break;
            }
            let beyond = slabs + i64::from(self.is_wrap(last));
            if members[next as usize].is_some() {
                closed = next == first;
                break;
            }
            // The slack is for rounding, and far below the narrowest band.
            if top(next, beyond) - lo > TAU * (1.0 + 1e-14) {
                break;
            }
            (last, slabs) = (next, beyond);
            smallest = smallest.min(next);
            members[last as usize] = member(slabs);
        }
        let to = ClusterInPeriod {
            cluster: self.cells[last as usize].to,
            slabs: slabs as i32,
        };
        let hi = top(last, slabs);
        let chain = Chain {
            first,
            last,
            from,
            to,
            lo,
            hi,
            closed,
        };
        (smallest, chain)
    }
}
