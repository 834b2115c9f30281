//! Inputs made of bytes.
//!
//! Bytes that have run out count as zeros, so every sequence of bytes is an input, and a small change of one makes a small
//! change of the other.

use core::f64::consts::PI;

use arbitrary::Unstructured;
use cspace::{Part, PartError, Vertex};
use cspace_load::draw::ties;
use cspace_oracle::{Case, families};
use rand::RngCore;

/// Distances of a number from the tie at which it was drawn: rounding, the resolution, and clearly different ones.
const NUDGES: [f64; 12] = [
    0.0, 0.0, 0.0, 0.0, 1e-16, 1e-15, 1e-13, 1e-12, 1e-10, 1e-8, 1e-5, 1e-2,
];

/// The bytes of an input, read from the front.
pub struct Bytes<'a>(Unstructured<'a>);

impl<'a> Bytes<'a> {
    /// The bytes of an input.
    pub fn new(data: &'a [u8]) -> Self {
        Self(Unstructured::new(data))
    }

    /// Whether all bytes are read.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Bytes that are not read yet.
    pub fn rest(self) -> &'a [u8] {
        self.0.take_rest()
    }

    /// Next byte.
    pub fn byte(&mut self) -> u8 {
        self.0.arbitrary().unwrap_or_default()
    }

    /// A number below `n`, which is at most 256.
    pub fn below(&mut self, n: usize) -> usize {
        usize::from(self.byte()) % n.max(1)
    }

    /// Chooses one of some values.
    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// Between 0 and 1, evenly.
    pub fn share(&mut self) -> f64 {
        let bits: u32 = self.0.arbitrary().unwrap_or_default();
        f64::from(bits) / f64::from(u32::MAX)
    }

    /// A number, with a nudge up or down.
    pub fn nudged(&mut self, x: f64) -> f64 {
        let k = self.below(2 * NUDGES.len());
        let nudge = NUDGES[k / 2];
        x + if k.is_multiple_of(2) { nudge } else { -nudge }
    }

    /// A number from −1 to 1 that favours ties: on a coarse lattice, a cosine of a multiple of 15°, or any; and nearly so.
    pub fn unit(&mut self) -> f64 {
        let x = match self.below(4) {
            0 | 1 => 0.125 * (self.below(17) as f64 - 8.0),
            2 => (self.below(24) as f64 * PI / 12.0).cos(),
            _ => 2.0 * self.share() - 1.0,
        };
        self.nudged(x).clamp(-1.0, 1.0)
    }

    /// An orientation that favours ties, radians: a multiple of 15°, or any; and nearly so.
    pub fn orientation(&mut self) -> f64 {
        let theta = if self.below(2) == 0 {
            (self.below(25) as f64 - 12.0) * (PI / 12.0)
        } else {
            PI * (2.0 * self.share() - 1.0)
        };
        self.nudged(theta)
    }

    /// A double of any bits.
    pub fn any(&mut self) -> f64 {
        self.0.arbitrary().unwrap_or_default()
    }
}

impl RngCore for Bytes<'_> {
    fn next_u32(&mut self) -> u32 {
        self.0.arbitrary().unwrap_or_default()
    }

    fn next_u64(&mut self) -> u64 {
        self.0.arbitrary().unwrap_or_default()
    }

    fn fill_bytes(&mut self, all: &mut [u8]) {
        all.fill_with(|| self.byte());
    }
}

/// Two outlines that favour ties, with some vertices moved and some arcs bent slightly.
///
/// # Errors
/// If the outlines are no parts.
pub fn nearly_tied(bytes: &mut Bytes<'_>) -> Result<Case, PartError> {
    let mut case = ties(bytes)?;
    for part in [&mut case.fixed, &mut case.moving] {
        if bytes.below(3) == 0 {
            let mut loops: Vec<Vec<Vertex>> =
                part.loops().iter().map(|l| l.vertices().to_vec()).collect();
            for _ in 0..=bytes.below(3) {
                let all = loops.iter().map(Vec::len).sum();
                let chosen = bytes.below(all);
                if let Some(v) = loops.iter_mut().flatten().nth(chosen) {
                    v.x = bytes.nudged(v.x);
                    v.y = bytes.nudged(v.y);
                    if v.bulge != 0.0 {
                        v.bulge = bytes.nudged(v.bulge);
                    }
                }
            }
            *part = Part::new(part.name(), loops)?;
        }
    }
    Ok(case)
}

/// Pair of one of the families that approach degenerate cases, at one of its values or near it.
///
/// # Errors
/// If the outlines are no parts.
pub fn member(bytes: &mut Bytes<'_>) -> Result<Case, PartError> {
    let families = families();
    let family = &families[bytes.below(families.len())];
    family.build(family.draw(bytes))
}
