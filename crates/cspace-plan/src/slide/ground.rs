//! Space that sliding moves in, in weighted coordinates, all of which count alike.

use cspace::{PatchId, QueryError};

use super::tolerance::{BACK_GROWTH, FINEST, FIRST_BACK, HALVINGS};
use super::vector::Vec3;

/// A contact function at a position: its value and gradient by the weighted coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constraint {
    pub(super) value: f64,
    pub(super) gradient: Vec3,
}

/// Where a straight motion ends, and the patch that stopped it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stop {
    pub(super) at: Vec3,
    pub(super) stopped: Option<PatchId>,
}

/// The surface of a space as sliding sees it.
pub(super) trait Ground {
    /// A configuration in the user's coordinates.
    type At: Copy;

    fn weighted(&self, at: Self::At) -> Vec3;

    fn unweighted(&self, at: Vec3) -> Self::At;

    /// From a configuration that is not blocked straight to another, which is within the window and the ranges: as far as that is not
    /// blocked, and the patch that stops it.
    fn straight_to(
        &self,
        from: Self::At,
        goal: Self::At,
    ) -> Result<(Self::At, Option<PatchId>), QueryError>;

    /// Whether the parts overlap, or nothing was computed there.
    fn is_blocked_at(&self, at: Self::At) -> bool;

    /// The straight way from one position to another up to the first contact; not yet tested for whether it is blocked there.
    fn advance(&self, from: Vec3, to: Vec3) -> Result<Stop, QueryError>;

    /// The patches that touch at a position.
    fn touching(&self, at: Vec3) -> Result<Vec<PatchId>, QueryError>;

    /// The contact function of a patch at a position.
    fn constraint(&self, patch: PatchId, at: Vec3) -> Result<Constraint, QueryError>;

    /// As above, for a position in weighted coordinates.
    fn is_blocked(&self, at: Vec3) -> bool {
        self.is_blocked_at(self.unweighted(at))
    }

    /// How far each coordinate may go; `None` if it may go anywhere.
    fn limits(&self) -> [Option<(f64, f64)>; 3];

    /// Positions nearer to a contact than this are in contact.
    fn contact(&self) -> f64;
}

/// The given time if a motion is not blocked then; or the last before at which it is not, as far as halving tells. `fine` is how long what
/// counts as contact takes to pass.
pub(super) fn last_not_blocked(is_blocked: impl Fn(f64) -> bool, time: f64, fine: f64) -> f64 {
    if !is_blocked(time) {
        return time;
    }
    let (mut lo, mut hi) = (0.0, time);
    // It has mostly gone too far by little.
    let mut back = FIRST_BACK * fine;
    while 0.0 < back && back < time {
        if !is_blocked(time - back) {
            lo = time - back;
            break;
        }
        hi = time - back;
        back *= BACK_GROWTH;
    }
    for _ in 0..HALVINGS {
        if hi - lo <= FINEST * fine {
            break;
        }
        let mid = 0.5 * (lo + hi);
        if is_blocked(mid) {
            hi = mid;
        } else {
            lo = mid;
        }
    }
    lo
}
