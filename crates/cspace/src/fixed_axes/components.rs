//! The connected components of free space: gaps that hang together.

use core::f64::consts::TAU;

use super::domain::Extent;
use super::gaps::{Band, Gap};
use super::sweep::Swept;

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Region {
    pub(super) sample: (f64, f64),
    pub(super) x: (f64, f64),
    pub(super) y: (f64, f64),
    pub(super) around_x: bool,
    pub(super) around_y: bool,
}

/// The bands, the gaps with their regions, and the regions. Walks through linked gaps, keeping count of turns.
pub(super) fn components(swept: Swept, y: &Extent) -> (Vec<Band>, Vec<Gap>, Vec<Region>) {
    let Swept {
        bands,
        mut gaps,
        spans,
        links,
        ..
    } = swept;
    let n = gaps.len();
    let mut regions: Vec<Region> = Vec::new();
    // The links of each gap, side by side.
    let mut beside: Vec<(u32, u32, i32, i32)> = Vec::with_capacity(2 * links.len());
    for l in &links {
        beside.push((l.from, l.to, l.x_turns, l.y_turns));
        beside.push((l.to, l.from, -l.x_turns, -l.y_turns));
    }
    beside.sort_unstable();
    let beside_of = |gap: u32| {
        let from = beside.partition_point(|b| b.0 < gap);
        beside[from..].iter().take_while(move |b| b.0 == gap)
    };
    let mut band_of = vec![0u32; n];
    for (k, band) in (0u32..).zip(&bands) {
        for g in band.gaps.clone() {
            band_of[g as usize] = k;
        }
    }
    let mut turns = vec![(0, 0); n];
    for seed in 0..n as u32 {
        if gaps[seed as usize].region != u32::MAX {
            continue;
        }
        let index = regions.len() as u32;
        let mut region = Region {
            sample: (0.0, 0.0),
            x: (f64::INFINITY, f64::NEG_INFINITY),
            y: (f64::INFINITY, f64::NEG_INFINITY),
            around_x: false,
            around_y: false,
        };
        let mut largest = -1.0;
        let mut stack = vec![seed];
        gaps[seed as usize].region = index;
        while let Some(g) = stack.pop() {
            let (tx, ty) = turns[g as usize];
            let gap = gaps[g as usize];
            let band = &bands[band_of[g as usize] as usize];
            if gap.lower == gap.upper && y.is_circle() && gap.lower.is_none() {
                region.around_y = true;
            }
            let middle = 0.5 * (band.lo + band.hi);
            let size = |(p, q): (f64, f64)| q - p;
            let (dx, dy) = (TAU * f64::from(tx), TAU * f64::from(ty));
            let at = spans[g as usize][1];
            let measure = size(at).min(band.hi - band.lo);
            if measure > largest {
                largest = measure;
                // In the turn in which the walk came to it, as the region's ranges are.
                region.sample = (middle + dx, 0.5 * (at.0 + at.1) + dy);
            }
            region.x.0 = region.x.0.min(band.lo + dx);
            region.x.1 = region.x.1.max(band.hi + dx);
            for (p, q) in spans[g as usize] {
                region.y.0 = region.y.0.min(p + dy);
                region.y.1 = region.y.1.max(q + dy);
            }
            for &(_, other, dx, dy) in beside_of(g) {
                // The neighbour, seen from here, is dx turns of x and dy turns of y farther than where it is drawn.
                let there = (tx + dx, ty + dy);
                if gaps[other as usize].region == u32::MAX {
                    gaps[other as usize].region = index;
                    turns[other as usize] = there;
                    stack.push(other);
                } else {
                    let known = turns[other as usize];
                    region.around_x |= known.0 != there.0;
                    region.around_y |= known.1 != there.1;
                }
            }
        }
        regions.push(region);
    }
    (bands, gaps, regions)
}
