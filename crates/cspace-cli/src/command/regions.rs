//! Where free regions are, in words.

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesRegion;
use cspace::{Axis, AxisMotion, ContactSpace, FixedAxesSpace, RegionId};

use crate::wording::{degrees, length};

/// Whether the moving part can leave the fixed part, and in which orientations it is.
pub(super) fn planar(space: &ContactSpace, region: RegionId) -> String {
    let moving = space.moving().name();
    if space.free_regions()[region.index()].unbounded {
        return format!("open: {moving} goes as far away as you like");
    }
    format!(
        "caged: {moving} cannot leave it{}",
        orientations(space, region)
    )
}

/// From where to where the parts on axes can move.
pub(super) fn on_axes(space: &FixedAxesSpace, r: &AxesRegion, unit: &str) -> String {
    let [u, v] = coordinates(space, unit);
    if together(r) {
        return format!("{} and {} turn together for ever", u.name(), v.name());
    }
    // Of a part that does not move nothing is to be told.
    let ranges = [
        (!u.is_still()).then(|| u.range(r.u, r.open_u, r.around_u)),
        (!v.is_still()).then(|| v.range(r.v, r.open_v, r.around_v)),
    ];
    ranges.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// Both coordinates of a pair on fixed axes.
pub(super) fn coordinates<'a>(space: &'a FixedAxesSpace, unit: &'a str) -> [Coordinate<'a>; 2] {
    let (fixed, moving) = space.axes();
    [
        Coordinate::new("u", space.fixed().name(), fixed, unit),
        Coordinate::new("v", space.moving().name(), moving, unit),
    ]
}

/// In which orientations a caged region is: those of the patches on its boundary.
fn orientations(space: &ContactSpace, region: RegionId) -> String {
    let mut patches: Vec<(f64, f64)> = (space.patches().iter())
        .filter(|p| p.region == region)
        .map(|p| (p.lo, p.hi))
        .collect();
    patches.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut union: Vec<(f64, f64)> = Vec::new();
    for (lo, hi) in patches {
        match union.last_mut() {
            Some(last) if lo <= last.1 => last.1 = last.1.max(hi),
            _ => union.push((lo, hi)),
        }
    }
    // What goes on past π begins again at −π.
    if let [first, .., last] = union[..]
        && last.1 - TAU >= first.0
    {
        union[0].0 = last.0 - TAU;
        union.pop();
    }
    match union[..] {
        [(lo, hi)] if hi - lo >= TAU * (1.0 - 1e-12) => ", at all orientations".to_owned(),
        [(lo, hi)] => format!(", theta from {} to {}", degrees(lo), degrees(hi)),
        _ => format!(", at {} intervals of orientation", union.len()),
    }
}

/// Whether both parts turn without end, but only with each other, as gears do.
fn together(r: &AxesRegion) -> bool {
    r.around_u && r.around_v
}

/// One of the two coordinates of a pair on fixed axes, in words.
pub(super) struct Coordinate<'a> {
    letter: &'a str,
    part: &'a str,
    axis: Axis,
    unit: &'a str,
}

impl<'a> Coordinate<'a> {
    pub(super) fn new(letter: &'a str, part: &'a str, axis: Axis, unit: &'a str) -> Self {
        Self {
            letter,
            part,
            axis,
            unit,
        }
    }

    pub(super) fn turns(&self) -> bool {
        matches!(self.axis.motion, AxisMotion::Revolute { .. })
    }

    fn is_still(&self) -> bool {
        self.axis.motion == AxisMotion::Fixed
    }

    pub(super) fn name(&self) -> String {
        format!("{} ({})", self.letter, self.part)
    }

    /// Whole turns (radians) that bring a value into [−π, π), where turns make no difference.
    fn turns_before(&self, t: f64) -> f64 {
        if self.turns() && self.axis.range.is_none() {
            TAU * ((t + PI) / TAU).floor()
        } else {
            0.0
        }
    }

    /// A coordinate of a configuration in a region: reduced to the region's range as printed, or to [−π, π) if it turns for ever.
    pub(super) fn example(&self, t: f64, range: (f64, f64), around: bool) -> String {
        self.value(t - self.turns_before(if around { t } else { range.0 }))
    }

    /// A value with its unit.
    pub(super) fn value(&self, t: f64) -> String {
        if self.turns() {
            format!("{} {}", self.letter, degrees(t))
        } else {
            format!("{} {}{}", self.letter, length(t), self.unit)
        }
    }

    /// From where to where the part can move.
    pub(super) fn range(&self, (lo, hi): (f64, f64), open: (bool, bool), around: bool) -> String {
        if around {
            return format!("{} turns for ever", self.name());
        }
        let turns = self.turns_before(lo);
        let end = |t: f64, open: bool, limit: Option<f64>| {
            if open {
                return "no limit".to_owned();
            }
            let t = t - turns;
            let value = if self.turns() {
                degrees(t)
            } else {
                format!("{}{}", length(t), self.unit)
            };
            // The limit itself, but for rounding.
            match limit {
                Some(limit) if (t - limit).abs() <= 1e-9 * (1.0 + limit.abs()) => {
                    format!("{value}, its limit,")
                }
                _ => value,
            }
        };
        let limits = self.axis.range;
        let from = end(lo, open.0, limits.map(|l| l.0));
        let to = end(hi, open.1, limits.map(|l| l.1));
        format!(
            "{} from {from} to {}",
            self.name(),
            to.trim_end_matches(',')
        )
    }
}
