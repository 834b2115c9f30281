//! The connected components of free space, as the user sees them.

use super::motion::Extent;
use super::motion::ExtentKind;
use super::motion::Motion;
use super::setup::Setting;
use super::space::FixedAxesSpace;
use super::sweep::Band;
use super::sweep::Gap;
use super::sweep::Swept;
use core::f64::consts::TAU;

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AxesRegion {
    /// A configuration (u, v) within it, between the least and greatest u and v below.
    pub sample: (f64, f64),
    /// Least and largest u, in radians or the model's unit of length; unrolled where it goes on past a turn.
    pub u: (f64, f64),
    /// Least and largest v.
    pub v: (f64, f64),
    /// Whether u goes on without limit below its least and beyond its greatest value: nothing touches there.
    pub open_u: (bool, bool),
    /// Whether v does.
    pub open_v: (bool, bool),
    /// Whether the part called fixed can turn for ever within it.
    pub around_u: bool,
    /// Whether the moving part can.
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

/// The values of a coordinate that a region reaches, and whether it goes on without limit at either end.
fn reached(range: (f64, f64), extent: &Extent, motion: Motion) -> ((f64, f64), (bool, bool)) {
    if motion == Motion::Still {
        return ((0.0, 0.0), (false, false));
    }
    let open = extent.kind == ExtentKind::Open;
    let ends = (range.0 <= extent.lo, range.1 >= extent.hi);
    (range, (open && ends.0, open && ends.1))
}

// The connected components of free space: gaps that hang together.

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

// Free space in the plane of the motions: its regions, and its picture.

impl FixedAxesSpace {
    /// The connected components of free space.
    pub fn regions(&self) -> Vec<AxesRegion> {
        let regions = self.data.regions.iter();
        regions.map(|r| AxesRegion::new(r, &self.setting)).collect()
    }

    /// The free region that holds a configuration, an index into [`regions`](Self::regions): two free configurations can
    /// be joined by a motion if and only if theirs is the same. `None` where the parts touch or overlap, and outside the
    /// ranges of motion.
    ///
    /// ```
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector, Vertex};
    /// let square = |name: &str, x: f64| {
    ///     let corners = [(x - 1.0, -1.0), (x + 1.0, -1.0), (x + 1.0, 1.0), (x - 1.0, 1.0)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slide = Axis::prismatic(Vector::new(1.0, 0.0));
    /// let space = FixedAxesSpace::compute(&square("wall", 0.0)?, Axis::FIXED, &square("slider", 5.0)?, slide)?;
    /// // It cannot come to the other side of the wall.
    /// assert_ne!(space.region_at(0.0, 0.0), space.region_at(0.0, -10.0));
    /// assert_eq!(space.region_at(0.0, -5.0), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn region_at(&self, u: f64, v: f64) -> Option<u32> {
        let (x, y) = self.setting.placed(u, v)?;
        if self.is_touching(x, y) {
            return None;
        }
        // Beyond the window nothing touches: a way leads straight to its border.
        let into = |t: f64, extent: &Extent| t.clamp(extent.lo, extent.hi);
        let (x, y) = (into(x, &self.setting.x), into(y, &self.setting.y));
        self.gaps().region(x, y)
    }

    /// Least and greatest u and v of a picture: the ranges of motion, a turn, or as far as parts that slide can touch. For a
    /// part that does not move it is a strip about 0 of no meaning, so that there is something to see.
    pub fn extent(&self) -> [(f64, f64); 2] {
        let Setting { map, x, y, .. } = &self.setting;
        let (lo, hi) = (map.outer(x.lo, y.lo), map.outer(x.hi, y.hi));
        [(lo.0, hi.0), (lo.1, hi.1)]
    }

    /// Free space as polygons of points (u, v), for pictures: every side is a contact curve sampled at `points` places, or
    /// straight. On a circle a polygon may reach beyond the extent; it then comes once more, a turn lower. Along the coordinate
    /// of a part that does not move it is as wide as the extent and stands for the coordinate 0.
    pub fn free_areas(&self, points: usize) -> Vec<Vec<(f64, f64)>> {
        let graphs = self.graphs();
        let points = points.max(1);
        let mut areas = Vec::new();
        for band in &self.data.bands {
            for gap in &self.data.gaps[band.gaps.start as usize..band.gaps.end as usize] {
                let x = |k: usize| band.lo + (band.hi - band.lo) * k as f64 / points as f64;
                let ends: Vec<(f64, (f64, f64))> = (0..=points)
                    .map(|k| (x(k), graphs.interval(gap, x(k))))
                    .collect();
                let highest = ends.iter().map(|e| e.1.1).fold(f64::NEG_INFINITY, f64::max);
                let copies = if self.setting.y.is_circle() && highest > self.setting.y.hi {
                    2
                } else {
                    1
                };
                for copy in 0..copies {
                    let down = TAU * f64::from(copy);
                    let lower = ends.iter().map(|&(x, (lo, _))| (x, lo - down));
                    let upper = ends.iter().rev().map(|&(x, (_, hi))| (x, hi - down));
                    areas.push(
                        lower
                            .chain(upper)
                            .map(|(x, y)| self.setting.map.outer(x, y))
                            .collect(),
                    );
                }
            }
        }
        areas
    }
}
