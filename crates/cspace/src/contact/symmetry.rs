//! Symmetries of the configuration space of a pair that come from symmetric parts.
//!
//! Let the fixed part be mapped to itself by turning it by α about its centre, the moving part by turning it by β about its own. In the
//! pair's frame, in which both centres are the origins, the parts overlap at (p, θ) if and only if they overlap at (`R_α` p, θ + α), and if
//! and only if they overlap at (p, θ + β). With folds k and m, the smallest turn of θ obtained in this way is T = 2π / lcm(k, m), by taking
//! α = 2πa/k and β = 2πb/m with a/k + b/m = 1/lcm(k, m) up to whole turns. This motion (p, θ) → (`R_α` p, θ + T) maps the space to itself,
//! and a contact of features f and g to one of the features to which `R_α` takes f and `R_−β` takes g. All orientations consist of copies
//! of one period (slab) of width T (figure 4 of Sacks 1999, where the moving part is the symmetric one and α = 0), and sheets are made in
//! the span of one period only.

use core::f64::consts::{PI, TAU};
use std::collections::BTreeMap;

use crate::feature::tolerance::CLEAR_CUT;
use crate::feature::{Feature, FeatureName, Outline};
use crate::geometry::{Point, Rotation, Vector};
use crate::number::Dd;
use crate::part::LoopImage;

use super::carrier::Carrier;
use super::curve::Curve;
use super::function::ContactFunction;
use super::spiral::{Spiral, Swing};

/// Images of a part's features and joints under one step of its symmetry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Permutation {
    pub(crate) features: Vec<u32>,
    pub(crate) joints: Vec<u32>,
}

impl Permutation {
    /// The identity.
    pub(crate) fn identity(outline: &Outline) -> Self {
        Self {
            features: (0..outline.features.len() as u32).collect(),
            joints: (0..outline.joints.len() as u32).collect(),
        }
    }

    /// The permutation from the images of loops that are drawn in order of travel. `None` if features do not correspond.
    pub(crate) fn of_loops(outline: &Outline, loops: &[LoopImage]) -> Option<Self> {
        let by_name: BTreeMap<_, u32> = (0u32..)
            .zip(&outline.features)
            .map(|(i, f)| (f.name, i))
            .collect();
        let mut joints = vec![u32::MAX; outline.joints.len()];
        let mut take = |from: u32, to: u32| {
            let image = &mut joints[from as usize];
            let free = *image == u32::MAX || *image == to;
            *image = to;
            free.then_some(())
        };
        let mut features = Vec::with_capacity(outline.features.len());
        for f in &outline.features {
            let image = loops.get(f.name.loop_index as usize)?;
            let (target, vertex) = image.of(f.name.index as usize);
            let to = *by_name.get(&FeatureName {
                kind: f.name.kind,
                loop_index: target as u32,
                index: vertex as u32,
            })?;
            let g: &Feature = &outline.features[to as usize];
            take(f.start, g.start)?;
            take(f.end, g.end)?;
            features.push(to);
        }
        let whole = joints.iter().all(|&j| j != u32::MAX);
        whole.then_some(Self { features, joints })
    }

    /// The permutation applied so many times.
    fn power(&self, exponent: u32) -> Self {
        let times = |step: &[u32]| {
            let image = |i| (0..exponent).fold(i, |i, _| step[i as usize]);
            (0..step.len() as u32).map(image).collect()
        };
        Self {
            features: times(&self.features),
            joints: times(&self.joints),
        }
    }
}

/// Periodicity of a pair's space: see the module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Steps {
    /// Number of periods in a turn: lcm(k, m).
    pub(crate) slabs: u32,
    /// Fold k of the fixed part.
    pub(crate) fixed_fold: u32,
    /// Fold m of the moving part.
    pub(crate) moving_fold: u32,
    /// Steps a and b of the two parts for one period.
    pub(crate) fixed: u32,
    pub(crate) moving: u32,
}

impl Steps {
    /// No symmetry: the period is the turn.
    pub(crate) const NONE: Self = Self {
        slabs: 1,
        fixed_fold: 1,
        moving_fold: 1,
        fixed: 0,
        moving: 0,
    };

    /// Periodicity for a fixed part of fold k and a moving part of fold m. `None` if there are more periods than can be numbered.
    pub(crate) fn new(k: u32, m: u32) -> Option<Self> {
        let slabs = u32::try_from(u64::from(k) / u64::from(gcd(k, m)) * u64::from(m)).ok()?;
        let (per_fixed, per_moving) = (u64::from(slabs / k), u64::from(slabs / m));
        // a · lcm/k + b · lcm/m = 1 modulo lcm; the two factors have no common divisor. The smallest a is used.
        let n = u64::from(slabs);
        let fixed = (0..u64::from(k))
            .find(|a| ((1 + n - a * per_fixed % n) % n).is_multiple_of(per_moving))?;
        let moving = (1 + n - fixed * per_fixed % n) % n / per_moving;
        Some(Self {
            slabs,
            fixed_fold: k,
            moving_fold: m,
            fixed: fixed as u32,
            moving: moving as u32,
        })
    }

    /// Angle in radians of a number of periods.
    pub(crate) fn period(&self, slabs: i64) -> f64 {
        TAU * (slabs as f64 / f64::from(self.slabs))
    }

    /// The angle by which positions turn, modulo a turn: α times the number of periods.
    pub(crate) fn angle(&self, slabs: i64) -> f64 {
        part_of_turn(self.fixed, self.fixed_fold, slabs)
    }

    /// The motion of the space onto itself by a number of periods.
    pub(crate) fn motion(&self, slabs: i64) -> SlabMotion {
        SlabMotion {
            fixed: Rotation::by(self.angle(slabs)),
            moving: Rotation::by(part_of_turn(self.moving, self.moving_fold, slabs)).inverse(),
        }
    }
}

/// 2π · steps · slabs / fold, modulo a turn, with a single rounding.
fn part_of_turn(steps: u32, fold: u32, slabs: i64) -> f64 {
    let fold = i128::from(fold);
    let part = (i128::from(steps) * i128::from(slabs)).rem_euclid(fold);
    TAU * (part as f64 / fold as f64)
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The motion of the space onto itself by a number of periods: `R_α` for vectors of the fixed part, `R_−β` for those that turn with θ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlabMotion {
    /// `R_α`.
    pub(crate) fixed: Rotation,
    /// `R_−β`.
    pub(crate) moving: Rotation,
}

impl SlabMotion {
    /// Image of a position of the pair's frame.
    pub(crate) fn point(&self, p: Point) -> Point {
        self.fixed * p
    }

    /// Image of a point that moves with orientation.
    pub(crate) fn spiral(&self, s: Spiral) -> Spiral {
        Spiral {
            u: self.fixed * s.u,
            w: self.moving * s.w,
            swing: self.swing(s.swing),
        }
    }

    /// Positions turn by α, the orientation by α + β.
    fn swing(&self, s: Swing) -> Swing {
        if s.is_none() {
            return s;
        }
        let (a, b) = (self.fixed, self.moving);
        let by = (a.sin * b.cos - a.cos * b.sin).atan2(a.cos * b.cos + a.sin * b.sin);
        Swing {
            arm: a * s.arm,
            rest: s.rest + by,
        }
    }

    /// The function f(`R_−α` p, θ − T), again in closed form.
    pub(crate) fn function(&self, f: ContactFunction) -> ContactFunction {
        let seen = f.carrier();
        let turn = if seen.turns() {
            self.moving
        } else {
            self.fixed
        };
        Carrier {
            through: self.spiral(seen.through),
            normal: turn * seen.normal,
            ..seen
        }
        .function()
    }

    /// Image of a curve at one orientation.
    pub(crate) fn curve(&self, c: &Curve) -> Curve {
        c.moved(Vector::ZERO, self.fixed)
    }
}

/// Periodicity of the space: from period to period, features and joints of both parts are permuted.
#[derive(Debug, Clone)]
pub(crate) struct Period {
    pub(crate) steps: Steps,
    /// Permutations by one period up.
    pub(crate) fixed: Permutation,
    pub(crate) moving: Permutation,
    /// Permutations by one period down.
    pub(crate) fixed_back: Permutation,
    pub(crate) moving_back: Permutation,
}

/// Images of a part's loops under one step of its symmetry; `None` without symmetry.
type LoopImages<'a> = Option<&'a [LoopImage]>;

impl Period {
    /// The period is the turn: the permutations are identities.
    pub(crate) fn none(fixed: &Outline, moving: &Outline) -> Self {
        let (fixed, moving) = (Permutation::identity(fixed), Permutation::identity(moving));
        Self {
            steps: Steps::NONE,
            fixed_back: fixed.clone(),
            moving_back: moving.clone(),
            fixed,
            moving,
        }
    }

    /// The periodicity of a pair; `None` if the features of a part do not correspond under its symmetry.
    pub(super) fn new(
        steps: Steps,
        fixed: (&Outline, LoopImages<'_>),
        moving: (&Outline, LoopImages<'_>),
    ) -> Option<Self> {
        let step = |(outline, images): (&Outline, LoopImages<'_>)| match images {
            Some(images) => Permutation::of_loops(outline, images),
            None => Some(Permutation::identity(outline)),
        };
        // A number of steps of a fold, and those that undo them.
        let both = |p: Permutation, by: u32, fold: u32| [by, fold - by].map(|s| p.power(s % fold));
        let [fixed, fixed_back] = both(step(fixed)?, steps.fixed, steps.fixed_fold);
        // A feature of the moving part is mapped by R_−β.
        let [moving_back, moving] = both(step(moving)?, steps.moving, steps.moving_fold);
        Some(Self {
            steps,
            fixed,
            moving,
            fixed_back,
            moving_back,
        })
    }
}

/// The window of orientations, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Span {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether it is a full turn, or one period of it, so that sheets that end at one end continue at the other.
    pub(crate) full: bool,
}

impl Span {
    /// Beginning of the window, in double-double.
    pub(crate) fn from(&self) -> Dd {
        Dd::from(self.lo)
    }

    pub(crate) fn to(&self) -> Dd {
        Dd::from(self.hi)
    }

    /// The first of `slabs` equal periods of the full turn, not cut at an orientation where two normals oppose each other.
    pub(crate) fn slab(fixed: &Outline, moving: &Outline, slabs: u32) -> Self {
        // Irrational steps: one of the cuts is clear unless the normals are dense on that scale.
        let cuts = (0..64).map(|i| -PI + 0.01234 + 0.000_761_3 * f64::from(i));
        let clear = |cut: f64| {
            fixed.joints.iter().all(|a| {
                moving.joints.iter().all(|b| {
                    let t = (a.angle - b.angle - PI - cut) / TAU;
                    (t - t.round()).abs() * TAU > CLEAR_CUT
                })
            })
        };
        let lo = cuts.clone().find(|&c| clear(c)).unwrap_or(-PI + 0.01234);
        Self {
            lo,
            hi: lo + TAU / f64::from(slabs),
            full: true,
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
