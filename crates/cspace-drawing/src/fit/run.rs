//! Input of fitting: samples of a smooth curve.

use cspace::{Point, Vector};

/// Points along a curve that has no corner, in order, with the left normals of the curve.
#[derive(Debug, Clone)]
pub(crate) struct Run {
    /// The samples. A closed run does not repeat its first.
    pub(crate) points: Vec<Point>,
    /// Smoothed positions of joints at the samples, for points that scatter.
    pub(crate) joints: Option<Vec<Point>>,
    /// Unit vectors to the left of the direction of travel.
    pub(crate) normals: Vec<Vector>,
    pub(crate) is_closed: bool,
    /// Whether the samples are measured points, and not those of a curve.
    pub(crate) is_measured: bool,
    /// Constraints of the directions at the ends of an open run.
    pub(crate) ends: [RunEnd; 2],
    pub(crate) band: Band,
}

/// An end of a run. The end itself stays where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RunEnd {
    /// A corner: any direction.
    Free,
    /// Tangent to the adjacent edge, in this direction of travel.
    Along(Vector),
}

/// Allowed distances of pieces from samples, to the left of the direction of travel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Band {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
}

impl Band {
    /// Either side alike.
    pub(crate) fn both(tolerance: f64) -> Self {
        Self {
            lo: -tolerance,
            hi: tolerance,
        }
    }

    /// The left side alone if `left`, or else the right one.
    pub(crate) fn one_sided(tolerance: f64, left: bool) -> Self {
        if left {
            Self {
                lo: 0.0,
                hi: tolerance,
            }
        } else {
            Self {
                lo: -tolerance,
                hi: 0.0,
            }
        }
    }

    /// Half its width.
    pub(crate) fn width(&self) -> f64 {
        (self.hi - self.lo) / 2.0
    }

    /// Middle of the band.
    pub(crate) fn middle(&self) -> f64 {
        (self.hi + self.lo) / 2.0
    }

    /// The larger of its sides.
    pub(crate) fn tolerance(&self) -> f64 {
        self.hi.max(-self.lo)
    }

    /// Excess of the smallest and largest distances of pieces over the band; 0 within.
    pub(super) fn excess(&self, range: [f64; 2]) -> f64 {
        // The ends of a run are on the curve, whatever the band.
        let excess = (self.lo.min(0.0) - range[0]).max(range[1] - self.hi.max(0.0));
        match excess <= 1e-9 * self.tolerance() {
            true => 0.0,
            false => excess,
        }
    }
}

impl Run {
    /// The number of samples, that of the first again at the end of a closed run included.
    pub(super) fn len(&self) -> usize {
        self.points.len() + usize::from(self.is_closed)
    }

    /// A sample, counted on around a closed run.
    pub(super) fn point(&self, i: usize) -> Point {
        self.points[i % self.points.len()]
    }

    pub(super) fn normal(&self, i: usize) -> Vector {
        self.normals[i % self.points.len()]
    }

    /// Position of a joint at a sample: in the middle of the band, except for the ends of an open run.
    pub(super) fn joint(&self, i: usize) -> Point {
        let is_end = !self.is_closed && (i == 0 || i + 1 == self.points.len());
        if is_end {
            return self.point(i);
        }
        let at = match &self.joints {
            Some(joints) => joints[i % joints.len()],
            None => self.point(i),
        };
        at + self.normal(i) * self.band.middle()
    }
}
