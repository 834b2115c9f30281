//! Elements of a pair's space: patches, the links between them, bands and free regions.

use crate::space::Band;

use super::answers::QueryError;
use super::ids::{LinkId, PatchId, RegionId};
use super::patch::PairPatch;
use super::relation::Coordinates;
use super::space::PairSpace;

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

impl PairSpace {
    /// The contact patches, in the order of their numbers; for a lower pair, its permanent contacts.
    pub fn patches(&self) -> impl Iterator<Item = PairPatch<'_>> {
        (0..self.patch_count() as u32).map(|i| PairPatch::new(self, PatchId(i)))
    }

    /// The links between patches, in the order of their numbers. Permanent contacts have none.
    pub fn links(&self) -> Vec<PairLink> {
        let mut links: Vec<(u32, u32, LinkKind)> = Vec::new();
        match self {
            Self::Lower(_) => {}
            Self::FixedAxes(space) => {
                let next = |(i, p): (u32, &crate::fixed_axes::AxesPatch)| {
                    Some((i, p.next?, LinkKind::Side))
                };
                links.extend((0..).zip(space.patches()).filter_map(next));
            }
            Self::Planar(space) => {
                let side = |l: &crate::SideLink| {
                    let (lo, hi) = (l.lo, l.hi);
                    (l.before, l.after, LinkKind::SideOver { lo, hi })
                };
                let vertical = |l: &crate::VerticalLink| {
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
                first: PatchId(first),
                second: PatchId(second),
                kind,
            })
            .collect()
    }

    /// The bands: intervals between critical orientations, in which only lengths change.
    ///
    /// # Errors
    /// If the pair has no orientation as a coordinate: lower pairs and pairs with fixed axes.
    pub fn bands(&self) -> Result<Vec<Band>, QueryError> {
        match self {
            Self::Planar(space) => Ok(space.bands()),
            _ => Err(QueryError::NoOrientation {
                class: self.class(),
            }),
        }
    }

    /// The connected components of free space, in the order of their numbers. A lower pair has none.
    pub fn regions(&self) -> Vec<PairRegion> {
        let regions: Vec<(Coordinates, bool)> = match self {
            Self::Lower(_) => Vec::new(),
            Self::FixedAxes(space) => {
                let region = |r: crate::fixed_axes::AxesRegion| {
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
