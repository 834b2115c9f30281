//! Contacts of neighbouring features, which touch each other by their making.
//!
//! Features a and a′ of the fixed part meet at a joint X with the normal ν, b and b′ of the moving part at a joint Y with the
//! normal n. Where these normals oppose each other, at one orientation θ₀, the contacts of a with b and of a′ with b′ go both
//! through X − R Y, with one normal. So their carriers touch there, and the ends that lie at the joints are on the other's
//! carrier. Neither is a sign of anything that changes from one side to the other: with signed radii a, a′, b, b′ each of
//! these conditions is, for two lengths p and q,
//!
//! ```text
//! |p ν − q R n|² − (p + q)² = −2 p q (1 + ν·R n)
//! ```
//!
//! and with a line something similar: it vanishes at θ₀ and nowhere else, with its slope. A double root is known to the square root of
//! the rounding, and the more radii there are to cancel, the worse; θ₀ is known from two angles, to the last bits.

use core::f64::consts::{PI, TAU};

use crate::feature::{Feature, Outline};
use crate::number::Event;

use super::sheet::Sheet;

/// Error of the orientation at which two normals oppose each other, radians.
pub(crate) const ALIGNMENT_ERROR: f64 = 16.0 * f64::EPSILON;

/// Error with which such a tangency is told, radians: about 3e-8.
///
/// Its orientation is known much better. But nearer to it than the square root of the rounding, places at which the two curves
/// cross cannot be told apart, and so nothing is to be looked at there.
const TIE_ERROR: f64 = 1.0 / (1u64 << 25) as f64;

/// The orientations at which two contacts touch by their making, each up to whole turns: none unless both features differ and
/// follow each other. Two loops of two features each have four.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ties {
    orientations: [f64; 4],
    count: usize,
}

impl Ties {
    /// Those of two sheets of a pair.
    pub(crate) fn new(fixed: &Outline, moving: &Outline, f: &Sheet, g: &Sheet) -> Self {
        let mut ties = Self {
            orientations: [0.0; 4],
            count: 0,
        };
        let joints = |outline: &Outline, i: u32, j: u32| -> [Option<f64>; 2] {
            let (a, b): (&Feature, &Feature) =
                (&outline.features[i as usize], &outline.features[j as usize]);
            let angle = |joint: u32| outline.joints[joint as usize].angle;
            let apart = i != j;
            [
                (apart && a.start == b.end).then(|| angle(a.start)),
                (apart && a.end == b.start).then(|| angle(a.end)),
            ]
        };
        let of_moving = joints(moving, f.moving, g.moving);
        for x in joints(fixed, f.fixed, g.fixed).into_iter().flatten() {
            for y in of_moving.into_iter().flatten() {
                ties.orientations[ties.count] = x - y - PI;
                ties.count += 1;
            }
        }
        ties
    }

    /// Those of them that are nearest to an orientation, of all their copies by whole turns.
    pub(crate) fn about(&self, mid: f64) -> impl Iterator<Item = f64> + '_ {
        let near = move |t: f64| t - TAU * ((t - mid) / TAU).round();
        self.orientations[..self.count]
            .iter()
            .map(move |&t| near(t))
    }

    /// The one that an event is, if it is one; itself up to whole turns.
    pub(crate) fn explain(&self, event: Event) -> Option<Event> {
        let slack = event.error + ALIGNMENT_ERROR;
        self.about(event.theta)
            .find(|t| (t - event.theta).abs() <= slack)
            .map(|theta| Event {
                theta,
                error: TIE_ERROR,
            })
    }
}
