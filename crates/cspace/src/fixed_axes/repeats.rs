//! Symmetry of a part that turns about its own centre of symmetry: contacts at x recur a k-th of a turn later.
//!
//! With the part mapped to itself by turning it by p = 2π/k about its pivot, let feature g be the image of feature f after s such steps.
//! Then g is at x − s p where f is at x, and a contact of f at (x, y) is one of g at (x − s p, y). So all contact curves follow from those
//! of one feature of every orbit, and the whole plane from a strip of width p.

use core::f64::consts::TAU;

use crate::contact::Permutation;
use crate::feature::{Feature, Outline};

use super::motion::{Extent, ExtentKind};

/// A feature or joint as the image of the representative of its orbit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Image {
    pub(super) of: u32,
    /// Number of symmetry steps that take the representative there, fewer than the fold.
    pub(super) steps: u32,
}

impl Image {
    /// Image of a representative, which is itself.
    pub(super) const fn itself(of: u32) -> Self {
        Self { of, steps: 0 }
    }
}

/// Symmetry of the swept part.
#[derive(Debug)]
pub(super) struct Repeats {
    /// The fold k, or 1.
    pub(super) fold: u32,
    features: Vec<Image>,
    joints: Vec<Image>,
    /// For every number of steps, the images of the features.
    places: Vec<Vec<u32>>,
}

impl Repeats {
    /// The symmetry of a fold; `step` is the permutation of features and joints by a k-th of a turn.
    pub(super) fn new(outline: &Outline, fold: u32, step: &Permutation) -> Self {
        let features = orbits(&step.features);
        let mut joints = orbits(&step.joints);
        // Both ends of a vertex are one point, which must be computed from one vertex.
        for (f, image) in outline.features.iter().zip(&features) {
            if f.is_vertex() {
                let first: &Feature = &outline.features[image.of as usize];
                for (joint, of) in [(f.start, first.start), (f.end, first.end)] {
                    joints[joint as usize] = Image {
                        of,
                        steps: image.steps,
                    };
                }
            }
        }
        let mut places: Vec<Vec<u32>> = vec![(0..outline.features.len() as u32).collect()];
        for _ in 1..fold {
            let Some(last) = places.last() else { break };
            let next = last.iter().map(|&f| step.features[f as usize]).collect();
            places.push(next);
        }
        Self {
            fold,
            features,
            joints,
            places,
        }
    }

    /// No symmetry.
    pub(super) fn none(outline: &Outline) -> Self {
        Self::new(outline, 1, &Permutation::identity(outline))
    }

    pub(super) fn feature(&self, i: u32) -> Image {
        self.features[i as usize]
    }

    pub(super) fn joint(&self, i: u32) -> Image {
        self.joints[i as usize]
    }

    /// Image of a feature after a number of steps.
    pub(super) fn image(&self, feature: u32, steps: u32) -> u32 {
        self.places[(steps % self.fold) as usize][feature as usize]
    }

    /// The period.
    pub(super) fn period(&self) -> f64 {
        TAU / f64::from(self.fold)
    }

    /// The part of a full turn of x that is computed.
    pub(super) fn window(&self, x: &Extent) -> Extent {
        if self.fold == 1 {
            return *x;
        }
        Extent {
            lo: x.lo,
            hi: x.lo + self.period(),
            kind: ExtentKind::Circle,
        }
    }

    /// A value of x as one in the window, and the periods it is above that.
    pub(super) fn split(&self, extent: &Extent, x: f64) -> (f64, u32) {
        let x = extent.reduced(x);
        if self.fold == 1 {
            return (x, 0);
        }
        let (p, lo) = (self.period(), extent.lo);
        let periods = (((x - lo) / p).floor().max(0.0) as u32).min(self.fold - 1);
        ((x - p * f64::from(periods)).clamp(lo, lo + p), periods)
    }
}

/// For each element, the first of its orbit, and the steps from there.
fn orbits(step: &[u32]) -> Vec<Image> {
    let mut images: Vec<Option<Image>> = vec![None; step.len()];
    for first in 0..step.len() as u32 {
        let (mut at, mut steps) = (first, 0);
        while images[at as usize].is_none() {
            images[at as usize] = Some(Image { of: first, steps });
            at = step[at as usize];
            steps += 1;
        }
    }
    let itself = |(i, image): (u32, Option<Image>)| image.unwrap_or(Image::itself(i));
    (0u32..).zip(images).map(itself).collect()
}
