//! Index of the patches that may exist at an orientation, which avoids examining all of them.

use core::f64::consts::{PI, TAU};

use crate::grouped::Grouped;

use super::options::Window;
use super::patch::Patch;

/// Margin by which a patch's interval is extended at both ends (radians): above the rounding of orientations and of whole turns added to
/// them.
const SLACK: f64 = 1e-9;

/// Absolute orientation (radians, some hundred turns) above which rounding may exceed [`SLACK`].
const FARTHEST_ORIENTATION: f64 = 1024.0;

/// Equal intervals of orientation, of the mean length of a patch, with the patches that overlap each of them: about half of these exist at
/// a given orientation.
#[derive(Debug, Clone)]
pub(crate) struct Alive {
    lo: f64,
    hi: f64,
    full_turn: bool,
    /// Intervals per radian, and their number.
    density: f64,
    count: usize,
    patches: Grouped,
}

impl Alive {
    pub(crate) fn new(window: Window, patches: &[Patch]) -> Self {
        let (lo, hi) = if window.full_turn {
            (-PI, PI)
        } else {
            (window.lo, window.hi)
        };
        let lengths: f64 = patches.iter().map(|p| p.hi - p.lo).sum();
        let most = patches.len().max(1) as f64;
        let count = (most * (hi - lo) / lengths).clamp(1.0, most);
        let mut this = Self {
            lo,
            hi,
            full_turn: window.full_turn,
            density: count.floor() / (hi - lo),
            count: count as usize,
            patches: Grouped::default(),
        };
        let places = (0u32..)
            .zip(patches)
            .flat_map(|(i, patch)| this.intervals(patch).map(move |place| (place, i)));
        this.patches = Grouped::new(this.count, places);
        this
    }

    /// Indices of the intervals that a patch overlaps, each once.
    fn intervals(&self, patch: &Patch) -> impl Iterator<Item = u32> + Clone + use<> {
        let place = |theta: f64| ((theta - self.lo) * self.density).floor() as i64;
        let (first, last) = (place(patch.lo - SLACK), place(patch.hi + SLACK));
        let (count, full_turn) = (self.count as i64, self.full_turn);
        let places = if full_turn {
            first..=last.min(first + count - 1)
        } else {
            first.max(0)..=last.min(count - 1)
        };
        places.map(move |place| place.rem_euclid(count) as u32)
    }

    /// A list, in ascending order, that includes all patches that exist at an orientation; `None` if the orientation is too far from zero.
    pub(crate) fn at(&self, theta: f64) -> Option<&[u32]> {
        let mut from_lo = theta - self.lo;
        if self.full_turn && theta.abs() <= FARTHEST_ORIENTATION {
            from_lo -= TAU * (from_lo / TAU).floor();
        } else if self.full_turn || !(self.lo..=self.hi).contains(&theta) {
            return None;
        }
        let place = (from_lo * self.density) as usize;
        Some(self.patches.of(place.min(self.count - 1) as u32))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use core::f64::consts::TAU;

    use crate::part::{Part, Vertex};
    use crate::space::{ContactSpace, Options, Symmetry};

    fn part(name: &str, size: f64) -> Part {
        let at = |x: f64, y: f64, bulge: f64| Vertex {
            bulge,
            ..Vertex::line(x * size, y * size)
        };
        let outline = vec![
            at(-1.0, -1.0, 0.0),
            at(1.0, -0.9, 0.4),
            at(1.1, 1.0, 0.0),
            at(0.2, 0.1, -0.3),
            at(-0.4, 1.2, 0.2),
        ];
        Part::new(name, vec![outline]).unwrap()
    }

    /// Slices equal those found by examining all patches: at orientations where patches begin and end, beside these, elsewhere, and whole
    /// turns away.
    #[test]
    fn slices_are_those_of_a_look_at_all_patches() {
        let square = Part::rectangle("square", (0.3, 0.2), 1.0, 1.0).unwrap();
        let coin = Part::circle("coin", (0.0, 0.0), 0.4).unwrap();
        let mut asked = 0;
        for (fixed, moving) in [
            (part("fixed", 1.0), part("moving", 0.6)),
            (part("fixed", 1.0), square.clone()),
            (square, coin),
        ] {
            for window in [None, Some((-0.4, 0.9)), Some((1002.0, 1007.0))] {
                for symmetry in [Symmetry::Detect, Symmetry::Ignore] {
                    let options = Options { window, symmetry };
                    let space = ContactSpace::compute(&fixed, &moving, &options).unwrap();
                    let window = space.window();
                    let ends = space.patches().iter().flat_map(|p| [p.lo, p.hi]);
                    let others = (0..60).map(|i| f64::from(i) * 0.217 - 6.0);
                    for theta in ends.chain(others).chain([window.lo, window.hi]) {
                        for off in [0.0, 1e-14, -1e-14, 1e-10, -1e-10, 1e-6] {
                            for turns in [0.0, 1.0, -3.0, 160.0, 1e5] {
                                let theta = theta + off + turns * TAU;
                                let slice = space.slice(theta);
                                assert_eq!(slice, space.surface().slice(theta), "{theta}");
                                asked += slice.curves.len();
                            }
                        }
                    }
                    // Only few of the patches are examined.
                    let n = space.patches().len();
                    if n > 30 && space.window().full_turn {
                        let mid = 0.1234;
                        let few = super::Alive::new(window, space.patches());
                        let few = few.at(mid).unwrap().len();
                        let there = space.slice(mid).curves.len();
                        assert!(few <= 4 * there && few < n, "{few} of {n}, {there} there");
                    }
                }
            }
        }
        assert!(asked > 50_000, "{asked}");
    }
}
