//! Elements of a pair's space: patches, the links between them, bands and free regions.

use crate::fixed_axes::AxesRegion;
use crate::ids::{LinkId, PatchId, RegionId};
use crate::space::Band;

use super::{Coordinates, Neighbours, PairPatch, PairSpace, QueryError};

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

/// Neighbours, bands and free regions.
impl PairSpace {
    /// The neighbours of a patch. Permanent contacts have none.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn neighbours(&self, patch: PatchId) -> Result<Neighbours, QueryError> {
        self.patch(patch).map(|p| p.neighbours())
    }

    /// The links between patches, in the order of their numbers. Permanent contacts have none.
    pub fn links(&self) -> Vec<PairLink> {
        let mut links = Vec::new();
        let mut add = |first, second, kind| {
            let id = LinkId(links.len() as u32);
            links.push(PairLink {
                id,
                first,
                second,
                kind,
            });
        };
        match self {
            Self::Lower(_) => {}
            Self::FixedAxes(space) => {
                for (first, patch) in (0..).map(PatchId).zip(space.patches()) {
                    (patch.next.iter()).for_each(|&second| add(first, second, LinkKind::Side));
                }
            }
            Self::Planar(space) => {
                for l in space.side_links() {
                    let (lo, hi) = (l.lo, l.hi);
                    add(l.before, l.after, LinkKind::SideOver { lo, hi });
                }
                for l in space.vertical_links() {
                    let theta = l.theta;
                    add(l.lower, l.upper, LinkKind::Vertical { theta });
                }
            }
        }
        links
    }

    /// The bands: intervals between critical orientations, in which only lengths change.
    ///
    /// # Errors
    /// If the pair has no orientation as a coordinate: lower pairs and pairs with fixed axes.
    pub fn bands(&self) -> Result<Vec<Band>, QueryError> {
        Ok(self.oriented()?.bands())
    }

    /// The connected components of free space, in the order of their numbers. A lower pair has none.
    pub fn regions(&self) -> Vec<PairRegion> {
        let regions: Vec<(Coordinates, bool)> = match self {
            Self::Lower(_) => Vec::new(),
            Self::FixedAxes(space) => {
                let region = |r: AxesRegion| {
                    let (u, v) = r.sample;
                    let open = [r.open_u, r.open_v].iter().any(|o| o.0 || o.1);
                    (Coordinates::Axes { u, v }, open || r.around_u || r.around_v)
                };
                space.regions().into_iter().map(region).collect()
            }
            Self::Planar(space) => (space.free_regions().iter())
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
}

impl PairPatch<'_> {
    /// The neighbours along the boundary of free space, found in time proportional to their number.
    pub fn neighbours(&self) -> Neighbours {
        let sorted = |list: &mut dyn Iterator<Item = PatchId>| {
            let mut list: Vec<PatchId> = list.collect();
            list.sort_unstable();
            list.dedup();
            list
        };
        match self.space {
            PairSpace::Lower(_) => Neighbours::default(),
            PairSpace::FixedAxes(space) => {
                let p = &space.patches()[self.id.index()];
                Neighbours {
                    before: p.previous.into_iter().collect(),
                    after: p.next.into_iter().collect(),
                    ..Neighbours::default()
                }
            }
            PairSpace::Planar(space) => Neighbours {
                before: sorted(&mut space.links_before(self.id).map(|l| l.before)),
                after: sorted(&mut space.links_after(self.id).map(|l| l.after)),
                below: sorted(&mut space.links_below(self.id).map(|l| l.lower)),
                above: sorted(&mut space.links_above(self.id).map(|l| l.upper)),
            },
        }
    }
}
