//! The plane of motions cut along a coordinate of choice: bands, their free gaps, and the curves that bound them.
//!
//! For sets that are made of several planes with a coordinate in common: a plane is swept along the coordinate that the others
//! are swept along, too.

use crate::feature::tolerance::{NARROWEST_BAND, SHORTEST_OVERLAP};
use crate::number::{Ball, Real};
use crate::part::Part;

use super::axis::{AxesError, Axis, Role};
use super::motion::Extent;
use super::space::FixedAxesSpace;
use core::f64::consts::TAU;
use core::ops::Range;

/// How far rounding may put a curve beside the values at its ends (radians or lengths of the pair's frame): a slope is enclosed
/// over so much more.
const ROUNDING: f64 = 1e-13;

/// The plane of motions of a pair on fixed axes, swept along the coordinate x of one part; y is that of the other. Both are in
/// radians or the model's unit of length.
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
/// // The slider meets the wall while it is within 2 of it, from -7 to -3; then the wall has to be 2 above or below.
/// let band = plane.bands().find(|b| b.lo < -5.0 && -5.0 < b.hi).ok_or("no band")?;
/// assert!((band.lo + 7.0).abs() < 1e-9 && (band.hi + 3.0).abs() < 1e-9);
/// let ends: Vec<(f64, f64)> = band.gaps.map(|g| plane.interval(g, -5.0)).collect();
/// assert_eq!(ends.len(), 2);
/// assert!((ends[0].1 + 2.0).abs() < 1e-9 && (ends[1].0 - 2.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SweptPlane {
    space: FixedAxesSpace,
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

/// What bounds a gap; `None` at a limit of y, and of a full turn that is free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
        Ok(Self { space })
    }

    /// Places at which the partition contradicts itself: as [`AxesStatistics::conflicts`](super::AxesStatistics::conflicts).
    pub fn conflicts(&self) -> usize {
        self.space.statistics().conflicts
    }

    /// The smallest opening of x and of y that counts as one, in radians or the model's unit of length: 10⁻¹¹ of the pair's size.
    pub fn smallest_openings(&self) -> (f64, f64) {
        let (x, y) = self.units();
        (SHORTEST_OVERLAP * x, SHORTEST_OVERLAP * y)
    }

    /// Critical values of x nearer to each other than this are one: 1.2·10⁻¹⁰ radians, or of the pair's size.
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
        self.space.data.gaps.get(gap).map_or(
            PlaneGap {
                lower: None,
                upper: None,
            },
            |g| PlaneGap {
                lower: curve(g.lower, g.turns.0),
                upper: curve(g.upper, g.turns.1),
            },
        )
    }

    /// From and to of a gap at an x of its band: of a full turn that is free, minimum and maximum y.
    pub fn interval(&self, gap: usize, x: f64) -> (f64, f64) {
        let PlaneGap { lower, upper } = self.gap(gap);
        let (lo, hi) = self.y().0;
        let from = lower.map_or(lo, |c| self.value(c, x));
        let to = upper.map_or(hi, |c| self.value(c, x));
        (from, to.max(from))
    }

    /// y of a curve at an x of its band; at the band's nearer end if beyond.
    pub fn value(&self, curve: PlaneCurve, x: f64) -> f64 {
        let (x_unit, y_unit) = self.units();
        let y = self.space.graphs().at(curve.cell, x / x_unit) + TAU * f64::from(curve.turns);
        y * y_unit
    }

    /// An enclosure of the slope dy/dx = −(∂f/∂x) / (∂f/∂y) of a curve over an interval of its band, f being the contact function; of
    /// infinite radius where the curve may be vertical.
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

    /// The stretches of y, in the first turn, in which contact does not depend on y, from the end of a band to the beginning of the next
    /// one; after the last band of a full turn the first follows.
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
