//! Position and periods of the plane of motions in a picture.

use core::f64::consts::TAU;

use cspace::{Axis, AxisMotion, FixedAxesSpace};

use crate::plot::Plot;
use crate::scene::Dot;

/// Map from coordinates to the picture, with their periods.
pub(crate) struct View {
    pub(crate) plot: Plot,
    /// The periods of u and v, if they have any.
    periods: [Option<f64>; 2],
    /// Smallest and largest computed u and v; beyond them the plane continues as at its ends.
    open: [Option<(f64, f64)>; 2],
}

impl View {
    pub(crate) fn of(space: &FixedAxesSpace, plot: Plot) -> Self {
        let (u, v) = space.axes();
        Self {
            plot,
            periods: [u, v].map(|a| turns_for_ever(a).then_some(TAU)),
            open: [(u, 0), (v, 1)].map(|(a, k)| goes_on(a).then_some(space.extent()[k])),
        }
    }

    pub(crate) fn place(&self, (u, v): (f64, f64)) -> Dot {
        self.plot.place(u, v)
    }

    /// Copy of a configuration with a coordinate at an open end moved out of sight, since the plane continues there.
    pub(crate) fn opened(&self, (u, v): (f64, f64)) -> (f64, f64) {
        let one = |t: f64, open: Option<(f64, f64)>, seen: (f64, f64)| match open {
            Some((lo, _)) if t <= lo => t.min(seen.0),
            Some((_, hi)) if t >= hi => t.max(seen.1),
            _ => t,
        };
        (
            one(u, self.open[0], self.plot.x),
            one(v, self.open[1], self.plot.y),
        )
    }

    /// The motions at a place.
    pub(crate) fn motions(&self, at: Dot) -> (f64, f64) {
        let (du, dv) = self.plot.dot();
        let area = self.plot.area;
        (
            self.plot.x.0 + (at.x - area.lo.x) * du,
            self.plot.y.0 + (area.hi.y - at.y) * dv,
        )
    }

    /// Displacements by whole periods that bring something with least and greatest u and v into sight.
    pub(crate) fn copies(&self, u: (f64, f64), v: (f64, f64)) -> Vec<(f64, f64)> {
        let shifts = |(lo, hi): (f64, f64), seen: (f64, f64), period: Option<f64>| {
            let Some(period) = period else {
                let is_seen = lo <= seen.1 && hi >= seen.0;
                return if is_seen { vec![0.0] } else { Vec::new() };
            };
            // Largest number of periods that can be distinguished.
            const MOST: f64 = 1e3;
            let first = ((seen.0 - hi) / period).ceil();
            let last = ((seen.1 - lo) / period).floor().min(first + MOST);
            let mut all = Vec::new();
            let mut k = first;
            while k <= last {
                all.push(k * period);
                k += 1.0;
            }
            all
        };
        let us = shifts(u, self.plot.x, self.periods[0]);
        let vs = shifts(v, self.plot.y, self.periods[1]);
        us.iter()
            .flat_map(|&du| vs.iter().map(move |&dv| (du, dv)))
            .collect()
    }
}

/// Whether a part returns to its position after a full turn.
pub(crate) fn turns_for_ever(axis: Axis) -> bool {
    matches!(axis.motion, AxisMotion::Revolute { .. }) && axis.range.is_none()
}

/// Whether a part slides without limits, or is fixed, so that beyond the computed range the plane is as at its end.
fn goes_on(axis: Axis) -> bool {
    match axis.motion {
        AxisMotion::Revolute { .. } => false,
        AxisMotion::Prismatic { .. } => axis.range.is_none(),
        AxisMotion::Fixed => true,
    }
}
