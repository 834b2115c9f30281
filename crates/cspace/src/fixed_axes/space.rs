//! The configuration space of a pair with fixed axes: its data, and quantities that follow from them.

use std::sync::OnceLock;

use crate::feature::PairFrame;
use crate::geometry::{Configuration, Rotation};
use crate::part::Part;

use super::axis::Axis;
use super::build::pair;
use super::data::{AxesData, AxesDataError, AxesStatistics};
use super::piece::Pair;
use super::ranges::Ranges;
use super::setup::{Setting, set_up};
use super::sweep::{Gaps, Graphs};

/// The configuration space of two parts on fixed axes.
#[derive(Debug)]
pub struct FixedAxesSpace {
    pub(super) data: AxesData,
    pub(super) setting: Setting,
    /// The pairs of the data with their conditions.
    pub(super) pairs: Vec<Pair>,
    /// Branches, indexed by the x of their cells.
    pub(super) by_x: Ranges,
    /// Branches, indexed by y; built when first needed.
    by_y: OnceLock<Ranges>,
}

impl FixedAxesSpace {
    /// The space of checked data, and the setting and pairs that follow from them.
    pub(super) fn new(data: AxesData, setting: Setting, pairs: Vec<Pair>) -> Self {
        let graphs = Graphs {
            pairs: &pairs,
            pieces: &data.pieces,
            cells: &data.cells,
            y: setting.y,
        };
        let boxes = data.branches.iter().map(|b| graphs.cell_box(b.cell).0);
        Self {
            by_x: Ranges::new(setting.x, boxes),
            by_y: OnceLock::new(),
            data,
            setting,
            pairs,
        }
    }

    /// All computed results, as plain data.
    pub fn data(&self) -> &AxesData {
        &self.data
    }

    /// Builds the space from plain data. The partition is not computed again; quantities that follow directly from the parts and their axes
    /// (motions, names of features, contact conditions) are recomputed, not read.
    ///
    /// # Errors
    /// If the data are of another format or version, describe invalid parts or axes, refer to entries that do not exist, or have numbers
    /// out of order.
    pub fn from_data(data: AxesData) -> Result<Self, AxesDataError> {
        data.check()?;
        let axes = (data.fixed_axis, data.moving_axis);
        let (setting, scene) = set_up((&data.fixed, &data.moving), axes, data.displacement, None)?;
        let first = scene.first.outline.features.len() as u32;
        let second = scene.second.outline.features.len() as u32;
        let there = |a: u32, b: u32| a < first && b < second;
        let pairs: Option<Vec<Pair>> = (data.pairs.iter())
            .map(|&(a, b, _)| there(a, b).then(|| pair(&scene, a, b)).flatten())
            .collect();
        let pairs = pairs.ok_or(AxesDataError::Damaged { what: "pairs" })?;
        Ok(Self::new(data, setting, pairs))
    }

    pub(super) fn graphs(&self) -> Graphs<'_> {
        Graphs {
            pairs: &self.pairs,
            pieces: &self.data.pieces,
            cells: &self.data.cells,
            y: self.setting.y,
        }
    }

    /// Branches, indexed by the y of their cells.
    pub(super) fn by_y(&self) -> &Ranges {
        self.by_y.get_or_init(|| {
            let graphs = self.graphs();
            let boxes = self.data.branches.iter().map(|b| graphs.cell_box(b.cell).1);
            Ranges::new(self.setting.y, boxes)
        })
    }

    pub(super) fn gaps(&self) -> Gaps<'_> {
        Gaps {
            graphs: self.graphs(),
            bands: &self.data.bands,
            gaps: &self.data.gaps,
            x: self.setting.x,
        }
    }

    /// The part called fixed.
    pub fn fixed(&self) -> &Part {
        &self.data.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.data.moving
    }

    /// The axes of the fixed and of the moving part.
    pub fn axes(&self) -> (Axis, Axis) {
        (self.data.fixed_axis, self.data.moving_axis)
    }

    /// Counts of the computation.
    pub fn statistics(&self) -> AxesStatistics {
        self.data.statistics
    }

    /// The resolution in the model's unit of length: a smaller clearance counts as none.
    ///
    /// It includes the deviation of the part as drawn from a symmetric one, where a part's symmetry about its pivot is used; and the
    /// displacement of parts that were moved to break a tie: 10⁻¹⁰ to 10⁻⁸ of the parts' size. It is larger if a part has a corner of less
    /// than some 30°: parts are grown, and such a corner by more than its sides.
    pub fn resolution(&self) -> f64 {
        self.setting.contact_distance() + self.setting.grown
    }

    /// Value of a contact function of the boundary below which a configuration is in contact, in the model's unit of length: the
    /// [`resolution`](Self::resolution) without the growth of sharp corners.
    pub fn contact_distance(&self) -> f64 {
        self.setting.contact_distance()
    }

    /// The frame in which the pair is computed: its scale defines the length that is 1 there, which counts as much as a radian of a part
    /// that turns.
    pub fn frame(&self) -> PairFrame {
        self.setting.map.frame
    }

    /// Configuration of the moving part in the fixed part's frame at (u, v).
    pub fn configuration(&self, u: f64, v: f64) -> Configuration {
        let Setting { map, motions, .. } = &self.setting;
        let (x, y) = map.inner(u, v);
        let (p, theta) = if map.swapped {
            motions.swapped().relative(y, x)
        } else {
            motions.relative(x, y)
        };
        // Both parts are drawn about the fixed part's centre c: c + p + R (q − c) places a point q.
        let c = map.frame.fixed_center.to_vector();
        let turned = Rotation::by(theta) * c;
        let at = p.to_vector() * (1.0 / map.frame.scale) + c - turned;
        Configuration::new(at.x, at.y, theta)
    }
}
