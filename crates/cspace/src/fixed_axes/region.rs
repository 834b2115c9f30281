//! The connected components of free space, as the user sees them.

use super::components::Region;
use super::domain::{Extent, ExtentKind};
use super::motion::Motion;
use super::setting::Setting;

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
