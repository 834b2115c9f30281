//! The contact space as a user walks it: patches, links, bands, free regions.

use std::sync::{Arc, OnceLock};

use crate::boxes::Places;
use crate::contact::Bodies;
use crate::feature::tolerance::{CONTACT, LEAST_CLEARANCE};
use crate::feature::{Outline, PairFrame};
use crate::geometry::Configuration;
use crate::part::Part;
use crate::slice::CurveGeometry;

use super::doubts::Doubts;
use super::options::Window;
use super::patch::{Patch, PatchRef};
use super::stats::Statistics;
use super::symmetry::PairSymmetry;

/// Two patches that follow each other along the boundary of free space, within bands.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SideLink {
    /// The patch that ends there in the direction of travel; its right boundary is the curve of the link.
    pub before: u32,
    /// The patch that begins there; its left boundary is the same curve.
    pub after: u32,
    /// First orientation at which they are neighbours.
    pub lo: f64,
    /// Last orientation.
    pub hi: f64,
}

/// Two patches that continue each other in orientation.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct VerticalLink {
    /// The patch that ends at the orientation.
    pub lower: u32,
    /// The patch that begins there.
    pub upper: u32,
    /// The critical orientation, radians.
    pub theta: f64,
    /// The curve that their top and bottom share.
    pub overlap: CurveGeometry,
}

/// A connected component of free space over all orientations of the window.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FreeRegion {
    /// Whether it reaches arbitrarily far positions. Exactly one region does.
    pub unbounded: bool,
    /// A configuration inside, away from contact.
    pub sample: Configuration,
    /// Number of patches on its boundary.
    pub patches: u32,
}

/// All relative configurations of two parts, split into free and blocked by patches of contact.
#[derive(Debug, Clone)]
pub struct ContactSpace {
    pub(crate) fixed: Part,
    pub(crate) moving: Part,
    pub(crate) window: Window,
    pub(crate) frame: PairFrame,
    pub(crate) critical_orientations: Vec<f64>,
    pub(crate) patches: Vec<Patch>,
    pub(crate) side_links: Vec<SideLink>,
    pub(crate) vertical_links: Vec<VerticalLink>,
    pub(crate) regions: Vec<FreeRegion>,
    pub(crate) features: FeatureCounts,
    pub(crate) symmetry: PairSymmetry,
    pub(crate) computed_bands: u32,
    pub(crate) statistics: Statistics,
    pub(crate) walk: Walk,
    pub(crate) doubts: Doubts,
    /// How far off their places contacts of sharp corners may be (length of the pair's frame).
    pub(crate) grown: f64,
    /// The parts as they are tested for overlap, once a question needs them.
    pub(crate) bodies: Arc<OnceLock<Bodies>>,
    /// Where the patches are, once it is asked often what is near.
    pub(crate) places: Arc<Places>,
}

/// Lines, arcs and vertices that are not smooth joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FeatureCounts {
    /// Of the fixed part.
    pub fixed: u32,
    /// Of the moving part.
    pub moving: u32,
}

impl FeatureCounts {
    /// Of two parts.
    pub(crate) fn of(fixed: &Part, moving: &Part) -> Self {
        let frame = PairFrame::new(fixed, moving);
        let count =
            |part, center| Outline::new(part, center, frame.scale, 0.0).feature_count as u32;
        Self {
            fixed: count(fixed, frame.fixed_center),
            moving: count(moving, frame.moving_center),
        }
    }
}

/// For every patch its links, by the end at which they lie.
#[derive(Debug, Clone, Default)]
pub(crate) struct Walk {
    after: LinksOf,
    before: LinksOf,
    above: LinksOf,
    below: LinksOf,
}

/// Numbers of links for every patch: those of patch i are `links[first[i]..first[i + 1]]`.
#[derive(Debug, Clone, Default)]
struct LinksOf {
    first: Vec<u32>,
    links: Vec<u32>,
}

impl LinksOf {
    /// The links by the patch at one of their ends.
    fn new(patches: usize, ends: impl Iterator<Item = u32> + Clone) -> Self {
        let mut first = vec![0u32; patches + 1];
        for end in ends.clone() {
            first[end as usize + 1] += 1;
        }
        for i in 0..patches {
            first[i + 1] += first[i];
        }
        let mut at = first.clone();
        let mut links = vec![0; first[patches] as usize];
        for (i, end) in (0u32..).zip(ends) {
            let slot = &mut at[end as usize];
            links[*slot as usize] = i;
            *slot += 1;
        }
        Self { first, links }
    }

    fn of(&self, patch: u32) -> &[u32] {
        let i = patch as usize;
        &self.links[self.first[i] as usize..self.first[i + 1] as usize]
    }
}

impl Walk {
    pub(crate) fn new(patches: usize, side: &[SideLink], vertical: &[VerticalLink]) -> Self {
        Self {
            after: LinksOf::new(patches, side.iter().map(|l| l.before)),
            before: LinksOf::new(patches, side.iter().map(|l| l.after)),
            above: LinksOf::new(patches, vertical.iter().map(|l| l.lower)),
            below: LinksOf::new(patches, vertical.iter().map(|l| l.upper)),
        }
    }
}

/// An interval between consecutive critical orientations: within it nothing but lengths changes.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Band {
    /// The critical orientation it begins at.
    pub lo: f64,
    /// The one it ends at, beyond π for the band that passes it.
    pub hi: f64,
}

impl ContactSpace {
    /// The fixed part.
    pub fn fixed(&self) -> &Part {
        &self.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.moving
    }

    /// The orientations covered.
    pub fn window(&self) -> Window {
        self.window
    }

    /// The numbers of features of the two parts.
    pub fn features(&self) -> FeatureCounts {
        self.features
    }

    /// The symmetry of the parts, and how many slabs it made of the computation.
    pub fn symmetry(&self) -> PairSymmetry {
        self.symmetry
    }

    /// How many bands were computed; the others are copies of these by symmetry.
    pub fn computed_bands(&self) -> usize {
        self.computed_bands as usize
    }

    /// Orientations at which the structure of the slice changes: sorted, in [−π, π) for a full turn.
    pub fn critical_orientations(&self) -> &[f64] {
        &self.critical_orientations
    }

    /// Intervals of orientation in which the patches are not relied upon alone: in ascending order, in [−π, π] for a full turn.
    ///
    /// Bands of less than 2.4·10⁻¹⁰ rad are among them, critical orientations that are known less well than to 1.2·10⁻¹⁰ rad, and
    /// contacts beside a conflict: linked, and yet judged differently by what bounds them and by a test of overlap. There,
    /// [`classify`](Self::classify) asks the parts themselves; a slice, a link or a motion may be wrong.
    pub fn doubtful_orientations(&self) -> &[(f64, f64)] {
        self.doubts.intervals()
    }

    /// Whether the parts, as they are computed, overlap at a configuration: boundaries intersected, containment tested,
    /// without patches.
    pub(crate) fn overlaps(&self, c: Configuration) -> bool {
        self.bodies
            .get_or_init(|| Bodies::new(&self.fixed, &self.moving))
            .overlap(c)
    }

    /// The patches.
    pub fn patches(&self) -> &[Patch] {
        &self.patches
    }

    /// A patch with what it can be asked. `None` if there is no such patch.
    pub fn patch(&self, index: u32) -> Option<PatchRef<'_>> {
        let patch = self.patches.get(index as usize)?;
        Some(PatchRef {
            patch,
            frame: &self.frame,
        })
    }

    /// Neighbours within bands.
    pub fn side_links(&self) -> &[SideLink] {
        &self.side_links
    }

    /// Neighbours across critical orientations.
    pub fn vertical_links(&self) -> &[VerticalLink] {
        &self.vertical_links
    }

    /// The side links at the right boundary of a patch, in order of orientation.
    pub fn links_after(&self, patch: u32) -> impl Iterator<Item = &SideLink> {
        let links = self.walk.after.of(patch).iter();
        links.map(|&l| &self.side_links[l as usize])
    }

    /// The side links at the left boundary of a patch, in order of orientation.
    pub fn links_before(&self, patch: u32) -> impl Iterator<Item = &SideLink> {
        let links = self.walk.before.of(patch).iter();
        links.map(|&l| &self.side_links[l as usize])
    }

    /// The vertical links at the last orientation of a patch.
    pub fn links_above(&self, patch: u32) -> impl Iterator<Item = &VerticalLink> {
        let links = self.walk.above.of(patch).iter();
        links.map(|&l| &self.vertical_links[l as usize])
    }

    /// The vertical links at the first orientation of a patch.
    pub fn links_below(&self, patch: u32) -> impl Iterator<Item = &VerticalLink> {
        let links = self.walk.below.of(patch).iter();
        links.map(|&l| &self.vertical_links[l as usize])
    }

    /// The connected components of free space; the unbounded one first.
    pub fn free_regions(&self) -> &[FreeRegion] {
        &self.regions
    }

    /// Counts and times of the computation.
    pub fn statistics(&self) -> &Statistics {
        &self.statistics
    }

    /// The resolution in the model's unit of length: contacts are known to this.
    ///
    /// With symmetry, how far the parts as drawn are from being symmetric is part of it. It is 2⁻³⁷ of the pair's size, and
    /// more if a part has a corner of less than some 30°: parts are grown, and such a corner by more than its sides.
    pub fn resolution(&self) -> f64 {
        self.frame.outer_length(CONTACT + self.grown) + self.symmetry.deviation
    }

    /// Clearances below this count as none, in the model's unit of length: 2⁻³¹ ≈ 4.7·10⁻¹⁰ of the pair's frame, and the
    /// [resolution](Self::resolution).
    ///
    /// Parts that fit into each other with so little play can turn against each other by about the play, divided by their
    /// size; a pocket of free space that lasts less than the narrowest band is left out.
    pub fn least_clearance(&self) -> f64 {
        self.frame.outer_length(LEAST_CLEARANCE) + self.resolution()
    }

    /// Positions nearer than this to a contact curve are in contact (model length): the resolution, but for what may be
    /// wrong with the curve.
    pub(crate) fn contact_distance(&self) -> f64 {
        self.frame.outer_length(CONTACT)
    }

    /// The bands, in order. A space without critical orientations has one.
    pub fn bands(&self) -> Vec<Band> {
        let c = &self.critical_orientations;
        let turn = core::f64::consts::TAU;
        if self.window.full_turn {
            match (c.first(), c.last()) {
                (Some(&first), Some(&last)) => {
                    let mut bands: Vec<Band> =
                        c.windows(2).map(|w| Band { lo: w[0], hi: w[1] }).collect();
                    bands.push(Band {
                        lo: last,
                        hi: first + turn,
                    });
                    bands
                }
                _ => vec![Band {
                    lo: self.window.lo,
                    hi: self.window.hi,
                }],
            }
        } else {
            let mut bounds = vec![self.window.lo];
            bounds.extend(c);
            bounds.push(self.window.hi);
            bounds
                .windows(2)
                .filter(|w| w[0] < w[1])
                .map(|w| Band { lo: w[0], hi: w[1] })
                .collect()
        }
    }

    /// The boundary of free space in a band, as closed loops of patches in order of travel.
    pub fn loops(&self, band: Band) -> Vec<Vec<u32>> {
        let slice = self.slice(0.5 * (band.lo + band.hi));
        slice
            .loops
            .iter()
            .map(|l| {
                l.iter()
                    .filter_map(|&c| slice.curves[c as usize].patch)
                    .collect()
            })
            .collect()
    }
}
