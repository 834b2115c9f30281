//! The gaps between branches on a contact curve, and which of them can bound free space.
//!
//! Right after a curve has entered the blocked side of another, and right before it leaves it, it is in blocked space. The same holds at an
//! end that no other curve continues. A gap is open if neither of its bounds is of this kind.

use crate::contact::{Exact, Geometry};

use crate::general::cells::cell::END;
use crate::general::events::branch::Branch;
use crate::general::events::order::Order;

/// The branches that cross a contact curve at one orientation, in order of travel.
#[derive(Debug, Default)]
pub(crate) struct Gaps {
    /// Branches, in order.
    order: Vec<u32>,
    sorting: Order,
    /// For each branch in order, whether the curve enters blocked space there.
    enters: Vec<bool>,
    /// Whether no sheet continues this one at its start, and at its end.
    dead: (bool, bool),
}

impl Gaps {
    /// Gaps of a sheet, without branches yet.
    pub(crate) fn of(geometry: &Geometry, sheet: u32) -> Self {
        let contacts = &geometry.contacts;
        let sheet = &contacts.sheets[sheet as usize];
        Self {
            dead: (
                contacts.ending_at(sheet.start.name).next().is_none(),
                contacts.starting_at(sheet.end.name).next().is_none(),
            ),
            ..Self::default()
        }
    }

    /// Sorts the branches along the curve at an orientation.
    pub(crate) fn arrange(
        &mut self,
        geometry: &Geometry,
        branches: &[Branch],
        sheet: u32,
        active: &[u32],
        theta: Exact,
    ) {
        (self.sorting).sort(geometry, (sheet, theta), branches, active, &mut self.order);
        self.enters.clear();
        self.enters.extend(
            self.order
                .iter()
                .map(|&b| branches[b as usize].enters(sheet)),
        );
    }

    /// Number of branches.
    pub(crate) fn branches(&self) -> usize {
        self.order.len()
    }

    /// A branch by its position in the order.
    pub(crate) fn branch(&self, place: usize) -> u32 {
        self.order[place]
    }

    /// The branches on both sides of a gap, [`END`] where it extends to the end of the curve.
    pub(crate) fn bounds(&self, gap: usize) -> (u32, u32) {
        let before = gap.checked_sub(1).map_or(END, |i| self.order[i]);
        let after = self.order.get(gap).map_or(END, |o| *o);
        (before, after)
    }

    /// Whether the bounds of the gap before branch `gap` in order (or after the last) admit that it bounds free space.
    pub(crate) fn is_open(&self, gap: usize) -> bool {
        let (left, right) = self.open_sides(gap);
        left && right
    }

    /// Whether a gap is closed: its bounds block it on both sides, so that no other cell follows it on either.
    pub(crate) fn is_shut(&self, gap: usize) -> bool {
        let (left, right) = self.open_sides(gap);
        !left && !right
    }

    /// Whether the bound of a gap leaves it open, on the left and on the right.
    fn open_sides(&self, gap: usize) -> (bool, bool) {
        let left = if gap == 0 {
            !self.dead.0
        } else {
            !self.enters[gap - 1]
        };
        let right = self.enters.get(gap).map_or(!self.dead.1, |&enters| enters);
        (left, right)
    }

    /// Whether two branches, by their position in the order, may pass each other and change an open gap: one of them bounds one, or the
    /// first enters and the second leaves, so that their passing makes one.
    pub(crate) fn passing_matters(&self, first: usize, second: usize) -> bool {
        (self.enters[first] && !self.enters[second])
            || [first, first + 1, second, second + 1]
                .into_iter()
                .any(|g| self.is_open(g))
    }
}
