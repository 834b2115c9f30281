//! Elements of a pair's space: patches, the links between them, bands and free regions.

use crate::fixed_axes::{AxesPatch, AxesRegion};
use crate::ids::{LinkId, PatchId, RegionId};
use crate::space::{SideLink, VerticalLink};

use super::{Coordinates, Neighbours, PairSpace};

/// Two patches that are neighbours on the boundary of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairLink {
    /// Number of the link.
    pub id: LinkId,
    /// Patch that ends where they meet: in the direction of travel, or at an orientation.
    pub first: PatchId,
    /// Patch that begins there.
    pub second: PatchId,
    /// Kind of link.
    pub kind: LinkKind,
}

/// Where two patches meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LinkKind {
    /// The patches follow each other in the direction of travel, on fixed axes.
    Side,
    /// The patches follow each other in the direction of travel, at the orientations from `lo` to `hi` (radians).
    SideOver {
        /// First orientation at which they are neighbours.
        lo: f64,
        /// Last orientation.
        hi: f64,
    },
    /// The patches continue each other across a critical orientation (radians).
    Vertical {
        /// The orientation.
        theta: f64,
    },
}

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairRegion {
    /// Number of the region.
    pub id: RegionId,
    /// A configuration in the region.
    pub sample: Coordinates,
    /// Whether the region is unbounded: the parts can be moved arbitrarily far apart, or one of them without end.
    pub unbounded: bool,
}

pub(super) fn links(space: &PairSpace) -> Vec<PairLink> {
    let mut links: Vec<(PatchId, PatchId, LinkKind)> = Vec::new();
    match space {
        PairSpace::Lower(_) => {}
        PairSpace::FixedAxes(space) => {
            let next = |(i, p): (PatchId, &AxesPatch)| Some((i, p.next?, LinkKind::Side));
            links.extend((0..).map(PatchId).zip(space.patches()).filter_map(next));
        }
        PairSpace::Planar(space) => {
            let side = |l: &SideLink| {
                let (lo, hi) = (l.lo, l.hi);
                (l.before, l.after, LinkKind::SideOver { lo, hi })
            };
            let vertical = |l: &VerticalLink| {
                let theta = l.theta;
                (l.lower, l.upper, LinkKind::Vertical { theta })
            };
            links.extend(space.side_links().iter().map(side));
            links.extend(space.vertical_links().iter().map(vertical));
        }
    }
    (0..)
        .zip(links)
        .map(|(i, (first, second, kind))| PairLink {
            id: LinkId(i),
            first,
            second,
            kind,
        })
        .collect()
}

pub(super) fn neighbours(space: &PairSpace, patch: PatchId) -> Neighbours {
    let sorted = |list: &mut dyn Iterator<Item = PatchId>| {
        let mut list: Vec<PatchId> = list.collect();
        list.sort_unstable();
        list.dedup();
        list
    };
    match space {
        PairSpace::Lower(_) => Neighbours::default(),
        PairSpace::FixedAxes(space) => {
            let p = &space.patches()[patch.index()];
            Neighbours {
                before: p.previous.into_iter().collect(),
                after: p.next.into_iter().collect(),
                ..Neighbours::default()
            }
        }
        PairSpace::Planar(space) => Neighbours {
            before: sorted(&mut space.links_before(patch).map(|l| l.before)),
            after: sorted(&mut space.links_after(patch).map(|l| l.after)),
            below: sorted(&mut space.links_below(patch).map(|l| l.lower)),
            above: sorted(&mut space.links_above(patch).map(|l| l.upper)),
        },
    }
}

pub(super) fn regions(space: &PairSpace) -> Vec<PairRegion> {
    let regions: Vec<(Coordinates, bool)> = match space {
        PairSpace::Lower(_) => Vec::new(),
        PairSpace::FixedAxes(space) => {
            let region = |r: AxesRegion| {
                let (u, v) = r.sample;
                let open = [r.open_u, r.open_v].iter().any(|o| o.0 || o.1);
                (Coordinates::Axes { u, v }, open || r.around_u || r.around_v)
            };
            space.regions().into_iter().map(region).collect()
        }
        PairSpace::Planar(space) => (space.free_regions().iter())
            .map(|r| (Coordinates::Planar(r.sample), r.unbounded))
            .collect(),
    };
    (0..)
        .zip(regions)
        .map(|(i, (sample, unbounded))| PairRegion {
            id: RegionId(i),
            sample,
            unbounded,
        })
        .collect()
}
