//! Free space in the plane of the motions: its regions, and its gaps for drawing.

use crate::ids::RegionId;

use super::region::AxesRegion;
use super::setup::Setting;
use super::space::FixedAxesSpace;
use super::sweep::{Band, Gap};

impl FixedAxesSpace {
    /// The connected components of free space.
    pub fn regions(&self) -> Vec<AxesRegion> {
        let regions = self.data.regions.iter();
        regions.map(|r| AxesRegion::new(r, &self.setting)).collect()
    }

    /// Smallest and largest u and v for drawing: the ranges of motion, a turn, or the range in which sliding parts can touch. For a part
    /// that does not move it is an arbitrary strip about 0, so that there is something to see.
    pub fn extent(&self) -> [(f64, f64); 2] {
        let Setting { map, x, y, .. } = &self.setting;
        let (lo, hi) = (map.outer(x.lo, y.lo), map.outer(x.hi, y.hi));
        [(lo.0, hi.0), (lo.1, hi.1)]
    }

    /// Free space cut at the critical values of one coordinate: between two of them it consists of gaps between contact curves. The gaps
    /// come in order of that coordinate. On a circle a gap may extend beyond the extent by less than a turn.
    ///
    /// ```
    /// use cspace::{Axis, FixedAxesSpace, Part, Vector};
    /// let slide = |x, y| Axis::prismatic(Vector::new(x, y)).within(-10.0, 10.0);
    /// let wall = Part::rectangle("wall", (0.0, 0.0), 2.0, 2.0)?;
    /// let slider = Part::rectangle("slider", (5.0, 0.0), 2.0, 2.0)?;
    /// let space = FixedAxesSpace::compute(&wall, slide(0.0, 1.0), &slider, slide(1.0, 0.0))?;
    /// let area: f64 = (space.free_gaps())
    ///     .map(|gap| {
    ///         let [[a, b], [c, d]] = [gap.ends(0.0), gap.ends(1.0)];
    ///         ((c.0 - a.0) * (d.1 - a.1) - (d.0 - a.0) * (c.1 - a.1)).abs()
    ///             .max(((b.0 - a.0) * (d.1 - a.1) - (d.0 - a.0) * (b.1 - a.1)).abs())
    ///     })
    ///     .sum();
    /// // All of the 20 by 20 but where they overlap, which is 4 by 4.
    /// assert!((area - 384.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn free_gaps(&self) -> impl Iterator<Item = FreeGap<'_>> {
        self.data.bands.iter().flat_map(move |band| {
            let gaps = &self.data.gaps[band.gaps.start as usize..band.gaps.end as usize];
            gaps.iter().map(move |gap| FreeGap {
                space: self,
                band,
                gap,
            })
        })
    }
}

/// A piece of free space between two contact curves or limits, over an interval of one coordinate.
#[derive(Debug, Clone, Copy)]
pub struct FreeGap<'a> {
    space: &'a FixedAxesSpace,
    band: &'a Band,
    gap: &'a Gap,
}

impl FreeGap<'_> {
    /// The region it belongs to, an index into [`FixedAxesSpace::regions`].
    pub fn region(&self) -> RegionId {
        RegionId(self.gap.region)
    }

    /// The two configurations (u, v) at its ends at a fraction of its interval, 0 to 1: they differ in one coordinate, and between them all
    /// is free. For a part that does not move, its coordinate there represents 0.
    pub fn ends(&self, fraction: f64) -> [(f64, f64); 2] {
        let x = self.band.lo + (self.band.hi - self.band.lo) * fraction;
        let (from, to) = self.space.graphs().interval(self.gap, x);
        [from, to].map(|y| self.space.setting.map.outer(x, y))
    }
}
