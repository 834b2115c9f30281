//! Which ways lead along some contacts nearest to where a part is wanted.

use super::tolerance::ROUNDING;
use super::vector::{Vec3, dot, size, weighted, weights_of};

/// Displacements d that a contact leaves open, to first order: normal · d ≥ −room.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfSpace {
    /// Unit normal.
    pub(super) normal: Vec3,
    pub(super) room: f64,
}

#[derive(Debug, Clone)]
pub(super) struct Way {
    pub(super) by: Vec3,
    /// Indices of the half-spaces in whose boundaries it ends.
    pub(super) held: Vec<usize>,
    /// Whether all of the half-spaces allow it.
    pub(super) allowed: bool,
    /// Its squared distance from what is wanted, but for a number that is the same for all.
    off: f64,
}

/// No more contacts hold a part at once than it has degrees of freedom in the plane.
const MOST_HELD: usize = 3;

/// The wanted displacement projected to the boundaries of up to three half-spaces that it is pressed against, the nearest to it first.
///
/// The one that all half-spaces allow comes before any other: it is the projection to all that they have in common. The others are
/// right where an obstacle has an edge: there free space is what either of two contacts allows, and a part goes past it along one of
/// them.
pub(super) fn ways_along(wanted: Vec3, spaces: &[HalfSpace]) -> Vec<Way> {
    let far = spaces.iter().map(|s| -s.room).fold(size(wanted), f64::max);
    let search = Search {
        wanted,
        spaces,
        slack: ROUNDING * far,
    };
    let mut found = Vec::new();
    search.extend(&mut Vec::new(), 0, &mut found);
    found.sort_by(|a, b| {
        let allowed = b.allowed.cmp(&a.allowed);
        allowed.then(a.off.total_cmp(&b.off))
    });
    found
}

struct Search<'a> {
    wanted: Vec3,
    spaces: &'a [HalfSpace],
    /// A way may lead beyond a half-space by this.
    slack: f64,
}

impl Search<'_> {
    /// Adds the ways to the boundaries of some half-spaces, and of these with others from `next` on.
    fn extend(&self, held: &mut Vec<usize>, next: usize, found: &mut Vec<Way>) {
        found.extend(self.way(held));
        if held.len() == MOST_HELD {
            return;
        }
        for i in next..self.spaces.len() {
            held.push(i);
            self.extend(held, i + 1, found);
            held.pop();
        }
    }

    fn way(&self, held: &[usize]) -> Option<Way> {
        let mut rows = [[0.0; 3]; MOST_HELD];
        let mut values = [0.0; MOST_HELD];
        for (k, &i) in held.iter().enumerate() {
            let space = self.spaces[i];
            rows[k] = space.normal;
            values[k] = -space.room - dot(space.normal, self.wanted);
        }
        let n = held.len();
        let weights = weights_of(&rows[..n], &values[..n])?;
        // A contact does not pull.
        if weights[..n].iter().any(|&w| w < -self.slack) {
            return None;
        }
        let by = weighted(&rows[..n], weights, self.wanted);
        let allows = |s: &HalfSpace| dot(s.normal, by) >= -s.room - self.slack;
        Some(Way {
            by,
            held: held.to_vec(),
            allowed: self.spaces.iter().all(allows),
            off: dot(by, by) - 2.0 * dot(by, self.wanted),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// In a right angle, what is wanted into both sides goes nowhere, and what is wanted into one goes along it.
    #[test]
    fn a_corner_leaves_what_its_sides_do() {
        let side = |normal| HalfSpace { normal, room: 0.0 };
        let corner = [side([1.0, 0.0, 0.0]), side([0.0, 1.0, 0.0])];
        let first = |wanted| ways_along(wanted, &corner)[0].by;
        assert!(size(first([-1.0, -1.0, 0.0])) < 1e-12);
        assert_eq!(first([-1.0, 2.0, 0.5]), [0.0, 2.0, 0.5]);
        assert_eq!(first([1.0, 2.0, 0.5]), [1.0, 2.0, 0.5]);
        // Round an edge, where either side is enough, a way that only one allows comes later.
        let all = ways_along([-1.0, -2.0, 0.0], &corner);
        assert!(all.iter().any(|w| !w.allowed && w.by == [0.0, -2.0, 0.0]));
    }
}
