//! What a designer asks first: do the parts fit as drawn, where can they be, what can touch.

use core::f64::consts::{PI, TAU};
use std::collections::BTreeSet;
use std::fmt::{self, Write};

use cspace::fixed_axes::AxesRegion;
use cspace::{
    Axis, AxisMotion, Configuration, ContactSpace, Coordinates, FixedAxesSpace, FreeRegion,
    Location, PairSpace,
};

use crate::subject::Chosen;
use crate::wording::{count, degrees, length};

/// Regions that are listed; of more the first are.
const MOST_LISTED: usize = 12;

/// How far from contact an example of the unbounded region is taken, as a share of the larger part.
const BESIDE: f64 = 0.05;

pub(super) fn describe(text: &mut String, pair: &Chosen<'_>, space: &PairSpace) -> fmt::Result {
    let Some(drawn) = as_drawn(space) else {
        return Ok(());
    };
    as_drawn_is(text, pair, space, drawn)?;
    match space {
        PairSpace::Planar(space) => {
            planar_regions(text, pair, space)?;
            planar_contact(text, space)
        }
        PairSpace::FixedAxes(space) => {
            axes_regions(text, pair, space)?;
            axes_contact(text, space)
        }
        PairSpace::Lower(_) => Ok(()),
    }
}

/// The configuration at zero motion; a lower pair is in contact in all of them.
fn as_drawn(space: &PairSpace) -> Option<Coordinates> {
    match space {
        PairSpace::Lower(_) => None,
        PairSpace::FixedAxes(_) => Some(Coordinates::Axes { u: 0.0, v: 0.0 }),
        PairSpace::Planar(_) => Some(Coordinates::Planar(Configuration::default())),
    }
}

fn as_drawn_is(
    text: &mut String,
    pair: &Chosen<'_>,
    space: &PairSpace,
    at: Coordinates,
) -> fmt::Result {
    let unit = pair.unit();
    let is = match space.locate(at) {
        Ok(Location::Free(region)) => {
            let clearance = space.clearance(at).unwrap_or(0.0);
            format!(
                "free, in region {region}, {}{unit} apart",
                length(clearance)
            )
        }
        Ok(Location::Contact) => "in contact".to_owned(),
        Ok(Location::Blocked) => "blocked: the parts overlap".to_owned(),
        Ok(Location::Outside) | Err(_) => "outside of what was computed".to_owned(),
    };
    writeln!(text, "  as drawn       {is}")
}

fn planar_regions(text: &mut String, pair: &Chosen<'_>, space: &ContactSpace) -> fmt::Result {
    let regions = space.free_regions();
    let caged = regions.iter().filter(|r| !r.unbounded).count();
    writeln!(
        text,
        "  free space     {}, {caged} caged",
        count(regions.len(), "connected region", "connected regions"),
    )?;
    let moving = space.moving().name();
    for (i, region) in regions.iter().enumerate().take(MOST_LISTED) {
        let example = if region.unbounded {
            beside(space, region)
        } else {
            region.sample
        };
        let what = if region.unbounded {
            format!("open: {moving} goes as far away as you like")
        } else {
            format!("caged: {moving} cannot leave it")
        };
        writeln!(
            text,
            "    region {i}     {what}{}, e.g. x {}, y {}{}, theta {}",
            orientations(space, i as u32),
            length(example.x),
            length(example.y),
            pair.unit(),
            degrees(example.theta)
        )?;
    }
    more(text, regions.len())
}

/// A configuration of the unbounded region that is near the parts, if one is easily found.
fn beside(space: &ContactSpace, region: &FreeRegion) -> Configuration {
    let far = region.sample;
    let Some(contact) = space.nearest_contact(far) else {
        return far;
    };
    let size = space.fixed().size().max(space.moving().size());
    let share = (BESIDE * size / contact.distance).min(1.0);
    let c = contact.configuration;
    let near = Configuration::new(
        c.x + share * (far.x - c.x),
        c.y + share * (far.y - c.y),
        far.theta,
    );
    match (space.region_at(near), space.region_at(far)) {
        (Some(a), Some(b)) if a == b => near,
        _ => far,
    }
}

/// In which orientations a caged region is: those of the patches on its boundary.
fn orientations(space: &ContactSpace, region: u32) -> String {
    if space.free_regions()[region as usize].unbounded {
        return String::new();
    }
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

fn more(text: &mut String, regions: usize) -> fmt::Result {
    if regions > MOST_LISTED {
        let left = regions - MOST_LISTED;
        writeln!(text, "    and {left} more: --format json has all")?;
    }
    Ok(())
}

fn planar_contact(text: &mut String, space: &ContactSpace) -> fmt::Result {
    let fixed: BTreeSet<_> = space.patches().iter().map(|p| p.fixed).collect();
    let moving: BTreeSet<_> = space.patches().iter().map(|p| p.moving).collect();
    let pairs: BTreeSet<_> = (space.patches().iter())
        .map(|p| (p.fixed, p.moving))
        .collect();
    let of = space.features();
    may_touch(
        text,
        [(fixed.len(), of.fixed), (moving.len(), of.moving)],
        [space.fixed().name(), space.moving().name()],
        pairs.len(),
    )
}

fn axes_contact(text: &mut String, space: &FixedAxesSpace) -> fmt::Result {
    let patches = space.patches();
    let fixed: BTreeSet<_> = patches.iter().map(|p| p.fixed).collect();
    let moving: BTreeSet<_> = patches.iter().map(|p| p.moving).collect();
    let pairs: BTreeSet<_> = patches.iter().map(|p| (p.fixed, p.moving)).collect();
    writeln!(
        text,
        "  may touch      {} of {}, {} of {}: {}",
        count(fixed.len(), "feature", "features"),
        space.fixed().name(),
        count(moving.len(), "feature", "features"),
        space.moving().name(),
        count(pairs.len(), "pair", "pairs")
    )
}

fn may_touch(
    text: &mut String,
    features: [(usize, u32); 2],
    names: [&str; 2],
    pairs: usize,
) -> fmt::Result {
    let [(a, of_a), (b, of_b)] = features;
    writeln!(
        text,
        "  may touch      {a} of {of_a} features of {}, {b} of {of_b} of {}: {}",
        names[0],
        names[1],
        count(pairs, "pair", "pairs")
    )
}

fn axes_regions(text: &mut String, pair: &Chosen<'_>, space: &FixedAxesSpace) -> fmt::Result {
    let regions = space.regions();
    if regions.is_empty() {
        return writeln!(
            text,
            "  free space     no free configuration: the parts always overlap"
        );
    }
    writeln!(
        text,
        "  free space     {}",
        count(regions.len(), "connected region", "connected regions")
    )?;
    let (fixed, moving) = space.axes();
    let unit = pair.unit();
    for (i, r) in regions.iter().enumerate().take(MOST_LISTED) {
        let u = Coordinate::new("u", space.fixed().name(), fixed, &unit);
        let v = Coordinate::new("v", space.moving().name(), moving, &unit);
        let ranges = if together(r) {
            format!("{} and {} turn together for ever", u.name(), v.name())
        } else {
            let [u, v] = [
                u.range(r.u, r.open_u, r.around_u),
                v.range(r.v, r.open_v, r.around_v),
            ];
            format!("{u}, {v}")
        };
        writeln!(
            text,
            "    region {i}     {ranges}, e.g. {}, {}",
            u.example(r.sample.0, r.u, r.around_u),
            v.example(r.sample.1, r.v, r.around_v)
        )?;
    }
    more(text, regions.len())
}

/// Whether both parts turn without end, but only with each other, as gears do.
fn together(r: &AxesRegion) -> bool {
    r.around_u && r.around_v
}

/// One of the two coordinates of a pair on fixed axes, in words.
struct Coordinate<'a> {
    letter: &'a str,
    part: &'a str,
    axis: Axis,
    unit: &'a str,
}

impl<'a> Coordinate<'a> {
    fn new(letter: &'a str, part: &'a str, axis: Axis, unit: &'a str) -> Self {
        Self {
            letter,
            part,
            axis,
            unit,
        }
    }

    fn turns(&self) -> bool {
        matches!(self.axis.motion, AxisMotion::Revolute { .. })
    }

    fn name(&self) -> String {
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

    /// A value of a region: within its range as that is told, or in [−π, π) where it turns for ever.
    fn example(&self, t: f64, range: (f64, f64), around: bool) -> String {
        self.value(t - self.turns_before(if around { t } else { range.0 }))
    }

    /// A value with its unit.
    fn value(&self, t: f64) -> String {
        if self.turns() {
            format!("{} {}", self.letter, degrees(t))
        } else {
            format!("{} {}{}", self.letter, length(t), self.unit)
        }
    }

    /// From where to where the part can move.
    fn range(&self, (lo, hi): (f64, f64), open: (bool, bool), around: bool) -> String {
        if self.axis.motion == AxisMotion::Fixed {
            return format!("{} does not move", self.name());
        }
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
