//! Perturbation of the vertices of a part that makes it generic.
//!
//! A drawing has sides in one line, equal arcs, corners on a circle: coincidences that no arithmetic can distinguish from near ones. Each
//! vertex is moved by its own amount, far below the resolution and far above the rounding of double-double, so that nothing coincides any
//! more; copies by symmetry are moved alike.

use core::f64::consts::TAU;

use super::tolerance::{LAYER_STEP, LEAST_WISH};
use crate::geometry::{Rotation, Vector};
use crate::part::{LoopImage, Part};

/// Parameters of the displacements of a part's vertices.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Perturbation<'a> {
    /// Largest displacement along either axis, and of the middle of an arc (length in the pair's frame).
    pub(crate) size: f64,
    /// Seed, different for the two parts of a pair.
    pub(crate) seed: u64,
    /// Images of its loops under one step of the part's symmetry, if it is drawn about its centre.
    pub(crate) images: Option<&'a [LoopImage]>,
    /// The fold of that symmetry.
    pub(crate) fold: u32,
}

impl Perturbation<'_> {
    /// The perturbation of a part whose layers are moved apart by a length.
    pub(super) fn within(&self, step: f64) -> Self {
        Self {
            size: self.size.min(step / LAYER_STEP),
            ..*self
        }
    }

    /// Requested displacements: for every loop, for every edge in order of travel, of its start along both axes and of its middle outward.
    pub(crate) fn wishes(&self, part: &Part) -> Vec<Vec<[f64; 3]>> {
        let mut wishes: Vec<Vec<Option<[f64; 3]>>> = (part.loops().iter())
            .map(|l| vec![None; l.vertices().len()])
            .collect();
        let step = Rotation::by(TAU / f64::from(self.fold.max(1)));
        let mut random = Random(self.seed);
        for l in 0..wishes.len() {
            for i in 0..wishes[l].len() {
                let [x, y, across] = [0; 3].map(|_| self.size * random.next());
                let (mut at, mut way) = ((l, i), Vector::new(x, y));
                // Goes around the orbit of the vertex, until it is closed.
                while let Some(wish) = wishes[at.0].get_mut(at.1).filter(|w| w.is_none()) {
                    *wish = Some([way.x, way.y, across]);
                    let Some(image) = self.images.and_then(|images| images.get(at.0)) else {
                        break;
                    };
                    at = image.of(at.1);
                    way = step * way;
                }
            }
        }
        let known =
            |w: Vec<Option<[f64; 3]>>| w.into_iter().map(Option::unwrap_or_default).collect();
        wishes.into_iter().map(known).collect()
    }
}

/// Deterministic pseudo-random numbers: `SplitMix64` of Steele, Lea and Flood (2014).
struct Random(u64);

impl Random {
    /// The next number, between −1 and 1 and not near zero.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        let part = (z >> 12) as f64 / (1u64 << 52) as f64;
        let size = LEAST_WISH + (1.0 - LEAST_WISH) * part;
        if z & 1 == 0 { size } else { -size }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::part::Vertex;

    #[test]
    fn every_vertex_is_moved_and_copies_are_moved_alike() {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        let square = corners.map(|(x, y)| Vertex::line(x, y)).to_vec();
        let part = Part::new("square", vec![square]).unwrap();
        let images = [LoopImage::new(0, 1, 4)];
        let of = |images, fold| {
            let size = 1e-3;
            Perturbation {
                size,
                seed: 7,
                images,
                fold,
            }
            .wishes(&part)
            .remove(0)
        };
        let alike = of(Some(&images[..]), 4);
        for i in 0..4 {
            let ([x, y, _], [u, v, _]) = (alike[i], alike[(i + 1) % 4]);
            assert!((u + y).abs() < 1e-18 && (v - x).abs() < 1e-18);
        }
        let apart = of(None, 1);
        for (i, a) in apart.iter().enumerate() {
            assert!(a.iter().all(|x| (2.5e-4..=1e-3).contains(&x.abs())));
            assert!(apart[..i].iter().all(|b| (a[0] - b[0]).abs() > 1e-9));
        }
    }
}
