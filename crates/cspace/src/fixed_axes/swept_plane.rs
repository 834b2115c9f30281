//! The plane of motions cut along a chosen coordinate: bands, their free gaps, and the curves that bound them.
//!
//! It is used for combinations of several planes with a common coordinate: each plane is swept along the coordinate of the others.

use crate::feature::tolerance::{NARROWEST_BAND, SHORTEST_OVERLAP};
use crate::ids::{PatchId, RegionId};
use crate::number::{Ball, Real};
use crate::part::Part;

use super::axis::{AxesError, Axis, Role};
use super::motion::Extent;
use super::space::FixedAxesSpace;
use core::f64::consts::TAU;
use core::ops::Range;

/// Distance by which rounding may put a curve beside the values at its ends (radians or lengths of the pair's frame): a slope is enclosed
/// over an interval extended by this.
const ROUNDING: f64 = 1e-13;

/// The plane of motions of a pair on fixed axes, swept along the coordinate x of one part; y is that of the other. Both are in radians or
/// the model's unit of length.
///
/// Between two critical values of x, in a *band*, the free values of y are *gaps* between monotone contact curves.
///
/// ```
/// use cspace::fixed_axes::{Role, SweptPlane};
/// use cspace::{Axis, Part, Vector};
/// let slide = |x, y| Axis::prismatic(Vector::new(x, y)).within(-10.0, 10.0);
/// let wall = Part::rectangle("wall", (0.0, 0.0), 2.0, 2.0)?;
/// let slider = Part::rectangle("slider", (5.0, 0.0), 2.0, 2.0)?;
/// let plane = SweptPlane::compute(
///     (&wall, slide(0.0, 1.0)),
///     (&slider, slide(1.0, 0.0)),
///     Role::Moving,
/// )?;
/// // The slider meets the wall while it is within 2 of it, from -7 to -3; then the wall has to be 2 above or below. At -5 the
/// // corners that face each other change.
/// let band = plane.bands().find(|b| b.lo < -4.0 && -4.0 < b.hi).ok_or("no band")?;
/// assert!((band.lo + 5.0).abs() < 1e-9 && (band.hi + 3.0).abs() < 1e-9);
/// let ends: Vec<(f64, f64)> = band.gaps.map(|g| plane.interval(g, -4.0)).collect();
/// assert_eq!(ends.len(), 2);
/// assert!((ends[0].1 + 2.0).abs() < 1e-9 && (ends[1].0 - 2.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SweptPlane {
    space: FixedAxesSpace,
    /// The patch of every cell.
    patches: Vec<Option<PatchId>>,
}

/// An interval of x in which the order of the curves does not change.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneBand {
    /// Its lower end.
    pub lo: f64,
    /// Its upper end.
    pub hi: f64,
    /// The numbers of its gaps, from the lowest.
    pub gaps: Range<usize>,
}

/// A contact curve as a monotone graph y(x) over a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlaneCurve {
    cell: u32,
    turns: i32,
}

/// The curves that bound a gap; `None` at a limit of y, and for a full turn that is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PlaneGap {
    /// The curve below.
    pub lower: Option<PlaneCurve>,
    /// The curve above.
    pub upper: Option<PlaneCurve>,
}

impl SweptPlane {
    /// Computes the plane of a pair, swept along the coordinate of one of its parts.
    ///
    /// # Errors
    /// As [`FixedAxesSpace::compute`].
    pub fn compute(
        fixed: (&Part, Axis),
        moving: (&Part, Axis),
        along: Role,
    ) -> Result<Self, AxesError> {
        let space = FixedAxesSpace::swept(fixed, moving, Some(along))?;
        let mut patches = vec![None; space.data.cells.len()];
        for branch in space.branches() {
            patches[branch.cell as usize] = Some(branch.patch);
        }
        Ok(Self { space, patches })
    }

    /// The space whose plane it is.
    pub fn space(&self) -> &FixedAxesSpace {
        &self.space
    }

    /// The free region of a gap, an index into the space's regions; `None` if there is no such gap.
    pub fn region(&self, gap: usize) -> Option<RegionId> {
        self.space.data.gaps.get(gap).map(|g| RegionId(g.region))
    }

    /// The patch of a curve, an index into the space's patches; `None` of a curve that coincides with another, which has the patch.
    pub fn patch(&self, curve: PlaneCurve) -> Option<PatchId> {
        self.patches.get(curve.cell as usize).copied().flatten()
    }

    /// Number of contradictions in the partition: as [`AxesStatistics::conflicts`](super::AxesStatistics::conflicts).
    pub fn conflicts(&self) -> usize {
        self.space.statistics().conflicts
    }

    /// The smallest opening of x and of y that is resolved, in radians or the model's unit of length: 10⁻¹¹ of the pair's size.
    pub fn smallest_openings(&self) -> (f64, f64) {
        let (x, y) = self.units();
        (SHORTEST_OVERLAP * x, SHORTEST_OVERLAP * y)
    }

    /// Distance of critical values of x below which they are one: 1.2·10⁻¹⁰ radians, or of the pair's size.
    pub fn narrowest_band(&self) -> f64 {
        NARROWEST_BAND * self.units().0
    }

    fn units(&self) -> (f64, f64) {
        let map = &self.space.setting.map;
        (map.x_unit, map.y_unit)
    }

    /// Minimum and maximum x, and whether they are one place, a full turn apart.
    pub fn x(&self) -> ((f64, f64), bool) {
        of(&self.space.setting.x, self.units().0)
    }

    /// Minimum and maximum y, and whether they are one place.
    pub fn y(&self) -> ((f64, f64), bool) {
        of(&self.space.setting.y, self.units().1)
    }

    /// The bands in order of x.
    pub fn bands(&self) -> impl Iterator<Item = PlaneBand> + '_ {
        let unit = self.units().0;
        self.space.data.bands.iter().map(move |b| PlaneBand {
            lo: b.lo * unit,
            hi: b.hi * unit,
            gaps: b.gaps.start as usize..b.gaps.end as usize,
        })
    }

    /// The curves that bound a gap. `None` in both if there is no such gap.
    pub fn gap(&self, gap: usize) -> PlaneGap {
        let curve = |cell: Option<u32>, turns| cell.map(|cell| PlaneCurve { cell, turns });
        let found = self.space.data.gaps.get(gap).map(|g| PlaneGap {
            lower: curve(g.lower, g.turns.0),
            upper: curve(g.upper, g.turns.1),
        });
        found.unwrap_or_default()
    }

    /// Ends of a gap at an x of its band; for a full turn that is free, minimum and maximum y.
    pub fn interval(&self, gap: usize, x: f64) -> (f64, f64) {
        let PlaneGap { lower, upper } = self.gap(gap);
        let (lo, hi) = self.y().0;
        let from = lower.map_or(lo, |c| self.value(c, x));
        let to = upper.map_or(hi, |c| self.value(c, x));
        (from, to.max(from))
    }

    /// y of a curve at an x of its band; beyond the band, at its nearer end.
    pub fn value(&self, curve: PlaneCurve, x: f64) -> f64 {
        let (x_unit, y_unit) = self.units();
        let y = self.space.graphs().at(curve.cell, x / x_unit) + TAU * f64::from(curve.turns);
        y * y_unit
    }

    /// An enclosure of the slope dy/dx = −(∂f/∂x) / (∂f/∂y) of a curve over an interval of its band, f being the contact function; its
    /// radius is infinite where the curve may be vertical.
    pub fn slope(&self, curve: PlaneCurve, (lo, hi): (f64, f64)) -> Ball {
        let (x_unit, y_unit) = self.units();
        let graphs = self.space.graphs();
        let (lo, hi) = (lo / x_unit, hi / x_unit);
        let (a, b) = (graphs.at(curve.cell, lo), graphs.at(curve.cell, hi));
        let x = Ball::between(lo - ROUNDING, hi + ROUNDING);
        let y = Ball::between(a.min(b) - ROUNDING, a.max(b) + ROUNDING);
        let condition = graphs.condition(curve.cell);
        let (first, second) = condition.moved(x, y);
        let (by_x, by_y) = condition.slopes(&first, &second);
        -(by_x / by_y) * Ball::constant(y_unit / x_unit)
    }

    /// The intervals of y, in the first turn, in which contact does not depend on y, between the end of a band and the beginning of the
    /// next; after the last band of a full turn comes the first.
    pub fn walls(&self, band: usize) -> Vec<(f64, f64)> {
        let data = &self.space.data;
        let Some(left) = data.bands.get(band) else {
            return Vec::new();
        };
        let next = data.bands.get(band + 1);
        let (first, unit) = (&data.bands[0], self.units().1);
        let between = |x: f64| match next {
            Some(right) => left.hi <= x && x <= right.lo,
            None => x >= left.hi || (self.space.setting.x.is_circle() && x <= first.lo),
        };
        let graphs = self.space.graphs();
        (0..data.cells.len() as u32)
            .map(|i| graphs.cell(i))
            .filter(|(_, p)| p.vertical && between(p.start.x))
            .map(|(c, _)| (c.from * unit, c.to * unit))
            .collect()
    }
}

fn of(extent: &Extent, unit: f64) -> ((f64, f64), bool) {
    ((extent.lo * unit, extent.hi * unit), extent.is_circle())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::geometry::{Point, Vector};
    use crate::part::Vertex;
    use crate::query::Classification;

    fn star(x: f64, teeth: u32) -> Part {
        let at = |k: u32| {
            let p = Vector::from_angle(core::f64::consts::PI * f64::from(k) / f64::from(teeth));
            let p = p * if k.is_multiple_of(2) { 1.0 } else { 0.7 };
            Vertex::new(x + p.x, p.y, if k.is_multiple_of(2) { 0.1 } else { 0.0 })
        };
        Part::new("star", vec![(0..2 * teeth).map(at).collect()]).unwrap()
    }

    /// Axes of all kinds, for the star about (0, 0) and for that about (1.8, 0).
    fn axes() -> Vec<(Axis, Axis)> {
        let turn = |x: f64| Axis::revolute(Point::new(x, 0.0));
        let slide = |x: f64, y: f64| Axis::prismatic(Vector::new(x, y)).within(-2.0, 2.0);
        vec![
            (turn(0.0), turn(1.8)),
            (turn(0.1), turn(1.7).within(-1.0, 7.5)),
            (turn(0.1), slide(0.6, 0.8)),
            (slide(0.6, 0.8), turn(1.8)),
            (slide(0.0, 1.0), slide(1.0, 0.3)),
        ]
    }

    /// Whether y, moved by whole turns, is in an interval.
    fn holds(circle: bool, y: f64, (from, to): (f64, f64)) -> bool {
        let y = if circle {
            y + TAU * ((from - y) / TAU).ceil()
        } else {
            y
        };
        from <= y && y <= to
    }

    #[test]
    fn swept_along_either_coordinate_a_plane_leaves_the_same_free() {
        let (a, b) = (star(0.0, 5), star(1.8, 4));
        for (first, second) in axes() {
            let space = FixedAxesSpace::compute(&a, first, &b, second).unwrap();
            for along in [Role::Fixed, Role::Moving] {
                let plane = SweptPlane::compute((&a, first), (&b, second), along).unwrap();
                assert_eq!(plane.conflicts(), 0);
                let (((x0, x1), _), ((y0, y1), circle)) = (plane.x(), plane.y());
                let mut free = 0;
                for k in 0..2000 {
                    let share = |by: f64| (f64::from(k) * by).fract();
                    let x = x0 + (x1 - x0) * share(0.754_877_666);
                    let y = y0 + (y1 - y0) * share(0.569_840_291);
                    let (u, v) = match along {
                        Role::Fixed => (x, y),
                        Role::Moving => (y, x),
                    };
                    let band = plane.bands().find(|b| b.lo <= x && x <= b.hi);
                    let Some(mut gaps) = band.map(|b| b.gaps) else {
                        continue;
                    };
                    let is_free = gaps.any(|g| holds(circle, y, plane.interval(g, x)));
                    free += u32::from(is_free);
                    match space.classify(u, v) {
                        Some(Classification::Free) => assert!(is_free, "{along} {u} {v}"),
                        Some(Classification::Blocked) => assert!(!is_free, "{along} {u} {v}"),
                        _ => {}
                    }
                }
                assert!((100..1900).contains(&free), "{free}");
            }
        }
    }

    #[test]
    fn gaps_end_at_contacts_with_slopes_within_their_enclosures() {
        let (a, b) = (star(0.0, 5), star(1.8, 4));
        for (first, second) in axes() {
            let space = FixedAxesSpace::compute(&a, first, &b, second).unwrap();
            for along in [Role::Fixed, Role::Moving] {
                let plane = SweptPlane::compute((&a, first), (&b, second), along).unwrap();
                let mut curves = 0;
                for band in plane.bands().filter(|b| b.hi - b.lo > 1e-3) {
                    let at = |share: f64| band.lo + share * (band.hi - band.lo);
                    for gap in band.gaps.clone().map(|g| plane.gap(g)) {
                        for curve in [gap.lower, gap.upper].into_iter().flatten() {
                            curves += 1;
                            let (x, z) = (at(0.45), at(0.55));
                            let (y, w) = (plane.value(curve, x), plane.value(curve, z));
                            let (u, v) = match along {
                                Role::Fixed => (x, y),
                                Role::Moving => (y, x),
                            };
                            assert_eq!(space.classify(u, v), Some(Classification::Contact));
                            let [lo, hi] = plane.slope(curve, (x, z)).ends();
                            let slope = (w - y) / (z - x);
                            assert!(
                                lo <= slope + 1e-9 && slope - 1e-9 <= hi,
                                "{lo} {slope} {hi}"
                            );
                            assert!(hi - lo < 10.0 * (1.0 + slope.abs()), "{lo} {slope} {hi}");
                        }
                    }
                }
                assert!(curves > 8, "{curves}");
            }
        }
    }
}
