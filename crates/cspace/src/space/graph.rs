//! The contact space as seen by a user: patches, links, bands, free regions.

use std::sync::{Arc, OnceLock};

use crate::boxes::Places;
use crate::contact::{Bodies, Fit};
use crate::feature::tolerance::{CONTACT, LEAST_CLEARANCE};
use crate::feature::tolerance::{GROWTH, MOVING_GROWTH};
use crate::geometry::Configuration;
use crate::ids::PatchId;
use crate::part::Part;
use crate::slice::{CurveGeometry, Slice};

use super::alive::Alive;
use super::band::{Band, bands};
use super::check::{DataError, check};
use super::data::{FeatureCounts, FreeRegion, SideLink, SpaceData, VerticalLink};
use super::options::Window;
use super::patch::{Patch, PatchRef};
use super::slice::Surface;
use super::stats::Statistics;
use super::symmetry::PairSymmetry;
use super::walk::Walk;

/// All relative configurations of two parts, split into free and blocked by patches of contact.
#[derive(Debug, Clone)]
pub struct ContactSpace {
    pub(crate) data: SpaceData,
    walk: Walk,
    /// Largest displacement of contacts at sharp corners that comes from growing the parts (length of the pair's frame).
    grown: f64,
    /// The parts prepared for overlap tests; built when first needed.
    bodies: Arc<OnceLock<Bodies>>,
    /// Index of the patches by orientation; built for the first slice.
    alive: Arc<OnceLock<Alive>>,
    /// Index of the patches by position; built after many queries of what is near.
    pub(crate) places: Arc<Places>,
}

impl ContactSpace {
    /// Builds the space from data; nothing is computed again.
    ///
    /// # Errors
    /// If the data are of another format or version, refer to entries that do not exist, or do not fit the parts.
    pub fn from_data(data: SpaceData) -> Result<Self, DataError> {
        check(&data)?;
        let walk = Walk::new(data.patches.len(), &data.side_links, &data.vertical_links);
        Ok(Self::of(data, walk))
    }

    /// The space of checked data and the walk of its links.
    pub(crate) fn of(data: SpaceData, walk: Walk) -> Self {
        let grown = (data.frame).grown((&data.fixed, GROWTH), (&data.moving, MOVING_GROWTH));
        Self {
            walk,
            grown,
            bodies: Arc::default(),
            alive: Arc::default(),
            places: Arc::default(),
            data,
        }
    }

    /// All computed results, as plain data.
    #[inline]
    pub fn data(&self) -> &SpaceData {
        &self.data
    }

    /// The slice at an orientation, in closed form: every patch that exists there contributes one curve.
    ///
    /// At a critical orientation the result is the slice just above it. Slices at orientations outside the window are empty. A slice at a
    /// [doubtful orientation](Self::doubtful_orientations) is marked as doubtful.
    ///
    /// It takes time in proportion to the number of its curves: 0.1 to 0.3 µs each. The first call also sorts all patches by orientation;
    /// the space keeps this index, about ten bytes a patch.
    pub fn slice(&self, theta: f64) -> Slice {
        let alive = (self.alive).get_or_init(|| Alive::new(self.data.window, &self.data.patches));
        match alive.at(theta) {
            Some(patches) => self
                .surface()
                .slice_of(theta, theta, patches.iter().copied()),
            None => self.surface().slice(theta),
        }
    }

    /// View of the data from which slices are computed.
    #[inline]
    pub(crate) fn surface(&self) -> Surface<'_> {
        Surface {
            window: self.data.window,
            frame: &self.data.frame,
            critical_orientations: &self.data.critical_orientations,
            patches: &self.data.patches,
            side_links: &self.data.side_links,
            walk: &self.walk,
            doubtful: &self.data.doubtful_orientations,
        }
    }

    /// The fixed part.
    pub fn fixed(&self) -> &Part {
        &self.data.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.data.moving
    }

    /// The orientations covered.
    #[inline]
    pub fn window(&self) -> Window {
        self.data.window
    }

    /// The numbers of features of the two parts.
    pub fn features(&self) -> FeatureCounts {
        self.data.features
    }

    /// The symmetry of the parts, and the number of periods in a turn.
    #[inline]
    pub fn symmetry(&self) -> PairSymmetry {
        self.data.symmetry
    }

    /// Number of bands computed; the others are copies of these by symmetry.
    pub fn computed_bands(&self) -> usize {
        self.data.computed_bands as usize
    }

    /// Orientations at which the structure of the slice changes: sorted, in [−π, π) for a full turn.
    #[inline]
    pub fn critical_orientations(&self) -> &[f64] {
        &self.data.critical_orientations
    }

    /// Doubtful intervals of orientation, in which the patches alone do not decide: in ascending order, in [−π, π] for a full turn.
    ///
    /// They contain bands of less than 2.4·10⁻¹⁰ rad, critical orientations with an error above 1.2·10⁻¹⁰ rad, and contacts next to a
    /// conflict: cells that are linked, but classified differently by their bounds and by an overlap test. There,
    /// [`classify`](Self::classify) tests the parts themselves; a slice, a link or a motion may be wrong.
    #[inline]
    pub fn doubtful_orientations(&self) -> &[(f64, f64)] {
        &self.data.doubtful_orientations
    }

    /// Whether the parts, as they are computed, overlap at a configuration: boundaries intersected, containment tested,
    /// without patches.
    pub(crate) fn overlaps(&self, c: Configuration) -> bool {
        self.bodies
            .get_or_init(|| Bodies::new(&self.data.fixed, &self.data.moving, Fit::Overlaps))
            .overlap(c)
    }

    /// The patches.
    #[inline]
    pub fn patches(&self) -> &[Patch] {
        &self.data.patches
    }

    /// The contact curve of a patch at an orientation from its first to its last: the positions of the moving part, with free
    /// space on the right. `None` at other orientations, and if there is no such patch.
    ///
    /// ```
    /// use cspace::{ContactSpace, Options, Part, PatchId};
    /// let coin = |r| Part::circle("coin", (0.0, 0.0), r);
    /// let space = ContactSpace::compute(&coin(2.0)?, &coin(1.0)?, &Options::default())?;
    /// let theta = 0.5 * (space.patches()[0].lo + space.patches()[0].hi);
    /// let middle = space.curve_at(PatchId(0), theta).ok_or("coins touch")?.point(0.5);
    /// assert!((middle.to_vector().length() - 3.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn curve_at(&self, patch: PatchId, theta: f64) -> Option<CurveGeometry> {
        let patch = self.data.patches.get(patch.index())?;
        (patch.lo..=patch.hi)
            .contains(&theta)
            .then(|| self.surface().curve(patch, theta))
    }

    /// A patch together with its frame. `None` if there is no such patch.
    pub fn patch(&self, id: PatchId) -> Option<PatchRef<'_>> {
        let patch = self.data.patches.get(id.index())?;
        Some(PatchRef {
            patch,
            frame: &self.data.frame,
        })
    }

    /// Neighbours within bands.
    pub fn side_links(&self) -> &[SideLink] {
        &self.data.side_links
    }

    /// Neighbours across critical orientations.
    pub fn vertical_links(&self) -> &[VerticalLink] {
        &self.data.vertical_links
    }

    /// The side links at the right boundary of a patch, in order of orientation; empty if there is no such patch.
    pub fn links_after(&self, patch: PatchId) -> impl Iterator<Item = &SideLink> {
        let links = self.walk.after(patch).iter();
        links.map(|&l| &self.data.side_links[l as usize])
    }

    /// The side links at the left boundary of a patch, in order of orientation; empty if there is no such patch.
    pub fn links_before(&self, patch: PatchId) -> impl Iterator<Item = &SideLink> {
        let links = self.walk.before(patch).iter();
        links.map(|&l| &self.data.side_links[l as usize])
    }

    /// The vertical links at the last orientation of a patch; empty if there is no such patch.
    pub fn links_above(&self, patch: PatchId) -> impl Iterator<Item = &VerticalLink> {
        let links = self.walk.above(patch).iter();
        links.map(|&l| &self.data.vertical_links[l as usize])
    }

    /// The vertical links at the first orientation of a patch; empty if there is no such patch.
    pub fn links_below(&self, patch: PatchId) -> impl Iterator<Item = &VerticalLink> {
        let links = self.walk.below(patch).iter();
        links.map(|&l| &self.data.vertical_links[l as usize])
    }

    /// The connected components of free space; the unbounded one first.
    pub fn free_regions(&self) -> &[FreeRegion] {
        &self.data.free_regions
    }

    /// Counts and times of the computation.
    pub fn statistics(&self) -> &Statistics {
        &self.data.statistics
    }

    /// The resolution in the model's unit of length: the accuracy of contacts.
    ///
    /// It is 2⁻³⁷ of the pair's size, and more if a part has a corner of less than some 30°: parts are grown, and such a corner by more
    /// than its sides. With symmetry, it includes the deviation of the parts as drawn from symmetric ones.
    pub fn resolution(&self) -> f64 {
        self.data.frame.outer_length(CONTACT + self.grown) + self.data.symmetry.deviation
    }

    /// The minimum clearance, in the model's unit of length: 2⁻³¹ ≈ 4.7·10⁻¹⁰ of the pair's frame, plus the [resolution](Self::resolution).
    /// A smaller clearance counts as none.
    ///
    /// Parts that fit into each other with so little play can turn against each other by about the play divided by their size; a pocket of
    /// free space that lasts less than the narrowest band is left out.
    pub fn least_clearance(&self) -> f64 {
        self.data.frame.outer_length(LEAST_CLEARANCE) + self.resolution()
    }

    /// Distance from a contact curve below which a position is in contact (model length): the resolution without the errors of the curve
    /// itself, which come from growing and symmetry.
    #[inline]
    pub fn contact_distance(&self) -> f64 {
        self.data.frame.outer_length(CONTACT)
    }

    /// The bands, in order. A space without critical orientations has one.
    pub fn bands(&self) -> Vec<Band> {
        bands(self.data.window, &self.data.critical_orientations)
    }

    /// The boundary of free space in a band, as closed loops of patches in order of travel.
    pub fn loops(&self, band: Band) -> Vec<Vec<PatchId>> {
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
