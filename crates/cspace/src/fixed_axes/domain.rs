//! Where the coordinates run.

use core::f64::consts::{PI, TAU};

/// The values of one coordinate, in the frame of the pair.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Extent {
    pub(super) lo: f64,
    pub(super) hi: f64,
    pub(super) kind: ExtentKind,
}

/// What is at the two ends of an extent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) enum ExtentKind {
    /// The same place: a full turn.
    Circle,
    /// Limits of a motion by an angle, which may be more than a turn.
    TurnLimits,
    /// Limits of a motion along a direction.
    SlideLimits,
    /// Places beyond which nothing touches, or beyond which all repeats.
    Open,
}

impl Extent {
    /// A full turn, cut at an angle at which nothing is likely to happen.
    pub(super) fn circle() -> Self {
        const CUT: f64 = -PI + 0.012_345_678_9;
        Self {
            lo: CUT,
            hi: CUT + TAU,
            kind: ExtentKind::Circle,
        }
    }

    pub(super) fn is_circle(&self) -> bool {
        self.kind == ExtentKind::Circle
    }

    /// Whether values a turn apart are the same position of the part.
    pub(super) fn repeats(&self) -> bool {
        matches!(self.kind, ExtentKind::Circle | ExtentKind::TurnLimits)
    }

    /// The value brought into the first turn, if values repeat.
    pub(super) fn reduced(&self, t: f64) -> f64 {
        if !self.repeats() {
            return t;
        }
        let r = t - TAU * ((t - self.lo) / TAU).floor();
        if r >= self.lo + TAU { self.lo } else { r }
    }

    /// a − b, less whole turns if values repeat.
    pub(super) fn difference(&self, a: f64, b: f64) -> f64 {
        if self.repeats() {
            wrapped(a - b)
        } else {
            a - b
        }
    }

    /// a − b; where both ends are the same place, the shorter way around.
    pub(super) fn apart(&self, a: f64, b: f64) -> f64 {
        if self.is_circle() {
            wrapped(a - b)
        } else {
            a - b
        }
    }

    /// The value brought into the circle; itself if the ends are not the same place.
    pub(super) fn folded(&self, t: f64) -> f64 {
        if self.is_circle() { self.reduced(t) } else { t }
    }

    /// A value brought by whole turns into a range, give or take some reach, if it is in it; by none if the ends of the extent
    /// are not the same place.
    pub(super) fn brought(&self, t: f64, (lo, hi): (f64, f64), reach: f64) -> Option<f64> {
        let t = if self.is_circle() {
            t + TAU * ((lo - reach - t) / TAU).ceil()
        } else {
            t
        };
        (lo - reach <= t && t <= hi + reach).then_some(t)
    }

    /// From and to of the first turn; of all, if values do not repeat.
    pub(super) fn first_turn(&self) -> (f64, f64) {
        let to = if self.repeats() {
            self.lo + TAU
        } else {
            self.hi
        };
        (self.lo, to)
    }

    /// How many turns there are, the last perhaps not a whole one.
    pub(super) fn turns(&self) -> i32 {
        match self.kind {
            ExtentKind::TurnLimits => ((self.hi - self.lo) / TAU).floor() as i32 + 1,
            _ => 1,
        }
    }
}

/// A value brought between two others, which rounding may have exchanged.
pub(super) fn brought_between(t: f64, lo: f64, hi: f64) -> f64 {
    t.max(lo).min(hi)
}

/// Values that are nearer to the one before than `near`, together: the first and the last of each cluster.
pub(super) fn clusters(mut values: Vec<f64>, near: f64) -> Vec<(f64, f64)> {
    values.sort_by(f64::total_cmp);
    let mut clusters: Vec<(f64, f64)> = Vec::new();
    for x in values {
        match clusters.last_mut() {
            Some(last) if x - last.1 < near => last.1 = x,
            _ => clusters.push((x, x)),
        }
    }
    clusters
}

/// The angle brought to (−π, π] by whole turns.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
