//! Answer of the assembly planner: steps, tree of parts, and what was tried.

use cspace::{Axis, Configuration, Coordinates, FeatureName, Part, Vector};
use cspace_model::Mechanism;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answer::Path;
use crate::legs::Scene;

/// Whether an assembly comes apart, and how. Parts are indices into the mechanism's.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TakenApart {
    /// Whether it does.
    pub outcome: Outcome,
    /// Steps in the order in which they are carried out; also if not all parts come apart.
    pub steps: Vec<Step>,
    /// Tree of sets of parts: each branch leaves the set above it.
    pub tree: Tree,
    /// The smallest set of parts that lock each other as they are, if there is one.
    pub locked: Option<Locked>,
    /// Search effort where nothing leaves parts that stay; none if that was not needed.
    pub tried: Option<Tried>,
    /// Contact spaces that were computed.
    pub spaces: usize,
}

/// Whether an assembly comes apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// All parts that may leave do, in this order.
    Apart,
    /// Some do not, however the others move: of two rigid bodies one encloses the other.
    Locked,
    /// No way was found, and none is excluded.
    Unknown,
}

/// Kind of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Parts go out of the others.
    Leaves,
    /// A part moves aside, or along its axis, and stays among the others.
    Moves,
}

/// A motion of some parts while the others stay.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// Kind of the step.
    pub kind: Kind,
    /// Parts that move together as one.
    pub moving: Vec<usize>,
    /// Parts that stay where they are.
    pub staying: Vec<usize>,
    /// Motion. For a part on an axis its coordinate, as v, with u = 0; for others their motion in the frame of those that stay, from where
    /// they are before the step, which is (0, 0, 0); of parts that leave up to where a line lies between the convex hulls of both.
    pub path: Path,
    /// Distance that parts that leave go straight on, to be out of the way of all that comes later and to have room to be taken
    /// apart; in the frame of the path. Nothing where that is no way.
    pub onward: Vector,
}

impl Step {
    /// The part that moves with the motion that it has, the first of several: of the mechanism's parts, or of others in their place. There is
    /// none of a step that moves nothing.
    pub fn scene(&self, parts: &[Part], mechanism: &Mechanism) -> Option<Scene> {
        let &first = self.moving.first()?;
        let part = &parts[first];
        let is_on_axis = matches!(
            self.path.configurations.first(),
            Some(Coordinates::Axes { .. })
        );
        let axis = mechanism.parts[first].axis.filter(|_| is_on_axis);
        let axes = axis.map(|axis| (Axis::FIXED, axis));
        Some(Scene::new(part, part, axes).with_about(self.path.about))
    }

    /// Where one of the moving parts is when the step has come to some coordinates, by where it was before the step: of a part on an
    /// axis to where it is drawn.
    pub fn placed(
        &self,
        coordinates: Coordinates,
        axis: Option<Axis>,
        before: Configuration,
    ) -> Configuration {
        match (coordinates, axis) {
            (Coordinates::Planar(c), _) => c.compose(before),
            (Coordinates::Axes { v, .. }, Some(axis)) => axis.configuration(v),
            (Coordinates::Axes { .. }, None) => before,
        }
    }
}

/// Tree of the subsets that come out of a set of parts.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Tree {
    /// The parts.
    pub parts: Vec<usize>,
    /// Subsets that leave the set, one after the other.
    pub out: Vec<Branch>,
    /// Parts left in the set.
    pub left: Vec<usize>,
}

/// Subset that leaves in a step.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Branch {
    /// The indices of the steps by which others make room for it, just before.
    pub room: Vec<usize>,
    /// The index of the step.
    pub step: usize,
    /// Subsets that come out of this one in turn.
    pub tree: Tree,
}

/// Effort spent where nothing leaves the set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Tried {
    /// So many parts were moved aside at a time, at most.
    pub aside: usize,
    /// To so many places, of one part or of two.
    pub places: usize,
}

/// Parts of which no proper subset can be taken out of the rest.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Locked {
    /// The parts.
    pub parts: Vec<usize>,
    /// Why: every division of the parts into two divides the two sides of one of these.
    pub why: Vec<Enclosure>,
}

/// Parts that cannot be taken out of others: their configuration as drawn is in a bounded region of their contact space.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Enclosure {
    /// Parts that are enclosed.
    pub moving: Vec<usize>,
    /// By what.
    pub staying: Vec<usize>,
    /// How many contact patches bound the region.
    pub patches: usize,
    /// The features of these patches: part and feature of what stays, and of what moves.
    pub features: Vec<(PartFeature, PartFeature)>,
    /// Orientations at which the space is in doubt, radians.
    pub doubtful: Vec<(f64, f64)>,
}

/// A feature of a part, as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct PartFeature {
    /// The part.
    pub part: usize,
    /// The feature.
    pub feature: FeatureName,
}
