//! The period of a symmetric pair's space in which all configurations are looked up.
//!
//! The space of a symmetric pair consists of images of one period of orientations (see `contact/symmetry.rs` of the kernel). Results for
//! the first period hold for all: the motion that takes a configuration's period back to the first takes the configuration with it. This
//! is not assumed but checked, patch by patch: patches come in orbits, with as many consecutive patches as there are periods, each of which
//! is the image of the one before.

use core::f64::consts::{PI, TAU};

use crate::contact::{ContactFunction, SlabMotion, Spiral, Steps};
use crate::feature::tolerance::NARROWEST_BAND;
use crate::geometry::{Point, Rotation, Vector};
use crate::space::{Boundary, ContactSpace, Patch, Window};

/// Tolerance, absolute or relative, of the numbers of a patch and of its image (radians, or length of the pair's frame): copies are made by
/// one motion each, and differ by some roundings.
const SAME: f64 = 1e-12;

/// Tolerance of the orientations at which a patch and its image begin or end (radians): half a turn is rounded.
const SAME_ORIENTATION: f64 = NARROWEST_BAND;

/// Distance of an orientation from a critical one (radians) below which the space itself is asked: reduced to the period, the orientation
/// may be on the other side. More than the rounding of some hundred turns, and than the difference of images.
pub(super) const ASIDE: f64 = 2.0 * SAME_ORIENTATION;

/// A period of a space that repeats, or all orientations of one that does not.
#[derive(Debug, Clone)]
pub(super) struct Slab {
    /// First orientation of the period, radians.
    pub(super) lo: f64,
    /// Last orientation.
    pub(super) hi: f64,
    /// Number of periods; 1 without symmetry.
    pub(super) count: u32,
    full_turn: bool,
    /// Rotation of positions when they are moved from the n-th period to the first, for n from 0 until it repeats.
    homewards: Vec<Rotation>,
}

/// An orientation reduced to the period.
#[derive(Debug, Clone, Copy)]
pub(super) struct Home {
    /// The reduced orientation, up to rounding; unchanged if there is one period only.
    pub(super) theta: f64,
    /// Distance from the beginning of the period (radians).
    pub(super) from_lo: f64,
    /// Number of periods by which it was moved.
    pub(super) slabs: u32,
}

impl Slab {
    pub(super) fn new(space: &ContactSpace) -> Self {
        let Window { lo, hi, full_turn } = space.window();
        let (lo, hi) = if full_turn { (-PI, PI) } else { (lo, hi) };
        let whole = Self {
            lo,
            hi,
            count: 1,
            full_turn,
            homewards: vec![Rotation::by(0.0)],
        };
        let symmetry = space.symmetry();
        let folds = 1..=symmetry.slabs;
        // Data read from a file may be inconsistent.
        let is_sound = symmetry.slabs as usize <= space.patches().len()
            && folds.contains(&symmetry.fixed)
            && folds.contains(&symmetry.moving);
        if !full_turn || symmetry.slabs <= 1 || !is_sound {
            return whole;
        }
        let steps = Steps::new(symmetry.fixed, symmetry.moving);
        match steps.filter(|s| s.slabs == symmetry.slabs && repeats(space.patches(), s)) {
            Some(steps) => Self {
                hi: lo + steps.period(1),
                count: steps.slabs,
                homewards: (0..i64::from(steps.fixed_fold))
                    .map(|slabs| steps.motion(slabs).fixed.inverse())
                    .collect(),
                ..whole
            },
            None => whole,
        }
    }

    /// Reduces an orientation to the period; `None` outside the window.
    #[inline]
    pub(super) fn home(&self, theta: f64) -> Option<Home> {
        let mut t = theta - self.lo;
        let inside = if self.full_turn {
            (0.0..=TAU).contains(&t)
        } else {
            (self.lo..=self.hi).contains(&theta)
        };
        if !inside {
            if !self.full_turn {
                return None;
            }
            t -= TAU * (t / TAU).floor();
        }
        if self.count == 1 {
            return Some(Home {
                theta,
                from_lo: t,
                slabs: 0,
            });
        }
        let period = self.hi - self.lo;
        let slabs = ((t / period) as u32).min(self.count - 1);
        let from_lo = t - TAU * (f64::from(slabs) / f64::from(self.count));
        Some(Home {
            theta: self.lo + from_lo,
            from_lo,
            slabs,
        })
    }

    /// A position of the pair's frame, moved to the period.
    #[inline]
    pub(super) fn position(&self, p: Point, home: Home) -> Point {
        if self.count == 1 {
            return p;
        }
        self.homewards[home.slabs as usize % self.homewards.len()] * p
    }

    /// The patch of the space that corresponds to a patch of the period, for configurations that were moved by this many periods.
    #[inline]
    pub(super) fn image(&self, patch: u32, home: Home) -> u32 {
        if self.count == 1 {
            return patch;
        }
        let place = patch % self.count;
        patch - place + (place + home.slabs) % self.count
    }

    /// Number of bytes in memory, without itself.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.homewards.as_slice())
    }

    /// One patch of every orbit, with its number.
    pub(super) fn representatives<'a>(
        &self,
        space: &'a ContactSpace,
    ) -> impl Iterator<Item = (u32, &'a Patch)> + use<'a> {
        (0..).zip(space.patches()).step_by(self.count as usize)
    }
}

/// Whether patches come in orbits in which every patch is the image of the one before.
fn repeats(patches: &[Patch], steps: &Steps) -> bool {
    let motion = steps.motion(1);
    let period = steps.period(1);
    let orbit = steps.slabs as usize;
    patches.len().is_multiple_of(orbit)
        && patches.chunks(orbit).all(|orbit| {
            let pairs = orbit.windows(2);
            pairs
                .into_iter()
                .all(|p| is_image(&motion, period, &p[0], &p[1]))
        })
}

fn is_image(motion: &SlabMotion, period: f64, from: &Patch, to: &Patch) -> bool {
    let boundary = |from: &Boundary, to: &Boundary| match (*from, *to) {
        (Boundary::End { spiral: a }, Boundary::End { spiral: b }) => {
            is_same_spiral(&motion.spiral(a), &b)
        }
        (Boundary::Crossing { with: a, root: i }, Boundary::Crossing { with: b, root: j }) => {
            i == j && is_same_function(motion, &a, &b)
        }
        _ => false,
    };
    is_turned(to.lo - from.lo - period, SAME_ORIENTATION)
        && ((to.hi - to.lo) - (from.hi - from.lo)).abs() <= SAME_ORIENTATION
        && is_same_function(motion, &from.function, &to.function)
        && boundary(&from.left, &to.left)
        && boundary(&from.right, &to.right)
}

/// Whether an angle is a multiple of a turn, within a tolerance.
fn is_turned(by: f64, within: f64) -> bool {
    (by - TAU * (by / TAU).round()).abs() <= within
}

fn is_near(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(1.0)
}

fn is_same_vector(a: Vector, b: Vector) -> bool {
    is_near(a.x, b.x) && is_near(a.y, b.y)
}

fn is_same_spiral(a: &Spiral, b: &Spiral) -> bool {
    is_same_vector(a.u.to_vector(), b.u.to_vector())
        && is_same_vector(a.w, b.w)
        && is_same_vector(a.swing.arm, b.swing.arm)
        && (a.swing.is_none() || is_turned(a.swing.rest - b.swing.rest, SAME))
}

fn is_same_function(motion: &SlabMotion, from: &ContactFunction, to: &ContactFunction) -> bool {
    let (a, b) = (motion.function(*from).carrier(), to.carrier());
    a.kind == b.kind
        && is_near(a.radius, b.radius)
        && is_same_vector(a.normal, b.normal)
        && is_same_spiral(&a.through, &b.through)
}
