//! The summary for a designer: whether the parts fit as drawn, the free regions, and the features that can touch.

use std::collections::BTreeSet;
use std::fmt::{self, Write};

use cspace::{
    Configuration, ContactSpace, FixedAxesSpace, FreeRegion, Location, PairSpace, RegionId,
};
use cspace_api::Chosen;
use cspace_api::compute::{AsDrawn, Drawn};

use crate::command::regions;
use crate::subject::InWords;
use crate::wording::{EXACT_FIT, count, degrees, length};

/// Regions that are listed; of more the first are.
const MOST_LISTED: usize = 12;

/// How far from contact an example of the unbounded region is taken, as a share of the larger part.
const BESIDE: f64 = 0.05;

pub(super) fn describe(
    text: &mut String,
    pair: &Chosen<'_>,
    space: &PairSpace,
    drawn: Option<&Drawn>,
) -> fmt::Result {
    let Some(drawn) = drawn else {
        return Ok(());
    };
    let is = match (drawn.outcome, drawn.region) {
        (_, Some(region)) => pair.is_free_by(region, drawn.clearance),
        (AsDrawn::Contact, _) => "in contact".to_owned(),
        (AsDrawn::ExactFit, _) => EXACT_FIT.to_owned(),
        (AsDrawn::Blocked, _) => "blocked: the parts overlap".to_owned(),
        _ => "outside of what was computed".to_owned(),
    };
    writeln!(text, "  as drawn       {is}")?;
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

fn planar_regions(text: &mut String, pair: &Chosen<'_>, space: &ContactSpace) -> fmt::Result {
    let regions = space.free_regions();
    let caged = regions.iter().filter(|r| !r.unbounded).count();
    writeln!(
        text,
        "  free space     {}, {caged} caged",
        count(regions.len(), "connected region", "connected regions"),
    )?;
    for (id, region) in (0..).map(RegionId).zip(regions).take(MOST_LISTED) {
        let example = if region.unbounded {
            beside(space, region)
        } else {
            region.sample
        };
        writeln!(
            text,
            "    {:12} {}, e.g. x {}, y {}{}, theta {}",
            pair.region(id),
            regions::planar(space, id),
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
    match (space.locate(near), space.locate(far)) {
        (Location::Free(a), Location::Free(b)) if a == b => near,
        _ => far,
    }
}

fn more(text: &mut String, regions: usize) -> fmt::Result {
    if regions > MOST_LISTED {
        let left = regions - MOST_LISTED;
        writeln!(text, "    and {left} more: --json has all")?;
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
            "  free space     no free configuration: the parts overlap or fit exactly in each"
        );
    }
    writeln!(
        text,
        "  free space     {}",
        count(regions.len(), "connected region", "connected regions")
    )?;
    let unit = pair.unit();
    for (id, r) in (0..).map(RegionId).zip(&regions).take(MOST_LISTED) {
        let [u, v] = regions::coordinates(space, &unit);
        let ranges = regions::on_axes(space, r, &unit);
        writeln!(
            text,
            "    {:12} {ranges}, e.g. {}, {}",
            pair.region(id),
            u.example(r.sample.0, r.u, r.around_u),
            v.example(r.sample.1, r.v, r.around_v)
        )?;
    }
    more(text, regions.len())
}
