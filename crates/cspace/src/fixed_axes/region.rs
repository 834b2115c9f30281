//! The connected components of free space, for users.

use super::motion::{Extent, ExtentKind, Motion};
use super::setup::Setting;
use super::sweep::{Band, Gap, Swept};
use core::f64::consts::TAU;

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesRegion {
    /// A configuration (u, v) within it, between the smallest and largest u and v below.
    pub sample: (f64, f64),
    /// Smallest and largest u, in radians or the model's unit of length; unrolled where the region extends past a turn.
    pub u: (f64, f64),
    /// Smallest and largest v.
    pub v: (f64, f64),
    /// Whether u is unbounded below its smallest and above its largest value: nothing touches there.
    pub open_u: (bool, bool),
    /// Whether v is unbounded below and above.
    pub open_v: (bool, bool),
    /// Whether the part called fixed can turn without end within the region.
    pub around_u: bool,
    /// Whether the moving part can turn without end within the region.
    pub around_v: bool,
}

impl AxesRegion {
    pub(super) fn new(r: &Region, setting: &Setting) -> Self {
        let (map, motions) = (&setting.map, &setting.motions);
        let (x, open_x) = reached(r.x, &setting.x, motions.first);
        let (y, open_y) = reached(r.y, &setting.y, motions.second);
        let (lo, hi) = (map.outer(x.0, y.0), map.outer(x.1, y.1));
        let (open_u, open_v) = map.exchanged(open_x, open_y);
        let (around_u, around_v) = map.exchanged(r.around_x, r.around_y);
        Self {
            sample: setting.outer(r.sample.0, r.sample.1),
            u: (lo.0, hi.0),
            v: (lo.1, hi.1),
            open_u,
            open_v,
            around_u,
            around_v,
        }
    }
}

/// The values of a coordinate in a region, and whether it is unbounded at either end.
fn reached(range: (f64, f64), extent: &Extent, motion: Motion) -> ((f64, f64), (bool, bool)) {
    if motion == Motion::Still {
        return ((0.0, 0.0), (false, false));
    }
    let open = extent.kind == ExtentKind::Open;
    let ends = (range.0 <= extent.lo, range.1 >= extent.hi);
    (range, (open && ends.0, open && ends.1))
}

// The connected components of free space: connected gaps.

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

/// The bands, the gaps with their regions, and the regions. Traverses linked gaps, counting turns.
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
                // In the turn in which the traversal reached it, as the region's ranges are.
                region.sample = (middle + dx, 0.5 * (at.0 + at.1) + dy);
            }
            region.x.0 = region.x.0.min(band.lo + dx);
            region.x.1 = region.x.1.max(band.hi + dx);
            for (p, q) in spans[g as usize] {
                region.y.0 = region.y.0.min(p + dy);
                region.y.1 = region.y.1.max(q + dy);
            }
            for &(_, other, dx, dy) in beside_of(g) {
                // The neighbour is dx turns of x and dy turns of y farther than its stored place.
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
