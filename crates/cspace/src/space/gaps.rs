//! The gaps between branches on a contact curve, and which of them can bound free space.
//!
//! Right after a curve has entered the blocked side of another, and right before it leaves it, it is in blocked space.
//! So is an end that no other curve continues. A gap is open if nothing of that kind bounds it.

use crate::contact::Geometry;

use super::branch::Branch;
use super::sweep::Placing;

/// The branches that cross a contact curve at one orientation, in order of travel.
#[derive(Debug)]
pub(super) struct Gaps {
    /// Places and branches.
    pub(super) order: Vec<(f64, u32)>,
    /// For each branch in order whether the curve enters blocked space there.
    pub(super) enters: Vec<bool>,
    dead: (bool, bool),
}

impl Gaps {
    /// Whether nothing continues the sheet at its start, and at its end.
    pub(super) fn dead_ends(geometry: &Geometry, sheet: u32) -> (bool, bool) {
        let contacts = &geometry.contacts;
        let sheet = &contacts.sheets[sheet as usize];
        (
            contacts.ending_at(sheet.start_name).next().is_none(),
            contacts.starting_at(sheet.end_name).next().is_none(),
        )
    }

    pub(super) fn new(
        geometry: &Geometry,
        branches: &[Branch],
        sheet: u32,
        active: &[u32],
        theta: f64,
        dead: (bool, bool),
    ) -> Self {
        let placing = Placing::new(geometry, sheet, theta);
        let mut order: Vec<(f64, u32)> = active
            .iter()
            .map(|&b| (placing.place(&branches[b as usize]), b))
            .collect();
        order.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let enters = order
            .iter()
            .map(|&(_, b)| branches[b as usize].enters(sheet))
            .collect();
        Self {
            order,
            enters,
            dead,
        }
    }

    /// Whether the gap before branch `gap` in order (or after the last) may bound free space by what bounds it.
    pub(super) fn is_open(&self, gap: usize) -> bool {
        let left = if gap == 0 {
            !self.dead.0
        } else {
            !self.enters[gap - 1]
        };
        let right = self.enters.get(gap).map_or(!self.dead.1, |&enters| enters);
        left && right
    }

    /// Whether two branches, by their place in the order, may pass each other and change an open gap: one of them
    /// bounds one, or the first enters and the second leaves, so that their passing makes one.
    pub(super) fn passing_matters(&self, first: usize, second: usize) -> bool {
        (self.enters[first] && !self.enters[second])
            || [first, first + 1, second, second + 1]
                .into_iter()
                .any(|g| self.is_open(g))
    }
}
