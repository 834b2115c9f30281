//! Parts of a scene.

use std::collections::BTreeMap;

use cspace::part::PartFeature;
use cspace::{Axis, AxisMotion, FeatureKind, FeatureName, Part, Point, Vector, Vertex};
use cspace_model::PartEntry;
use serde::{Deserialize, Serialize};

/// A part and how it moves.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ScenePart {
    /// Name of the part.
    pub name: String,
    /// Loops, as in the model; a loop is closed.
    pub loops: Vec<Vec<Vertex>>,
    /// The layers, the lowest first, with the numbers of their loops.
    pub layers: Vec<SceneLayer>,
    /// Names given by the model to features, by their default names: `line 3 of loop 0`.
    pub feature_names: BTreeMap<String, String>,
    /// Motion relative to the ground.
    pub motion: SceneMotion,
}

/// A layer of a part.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SceneLayer {
    /// The lowest and the highest place; none at every height.
    pub z: Option<[f64; 2]>,
    /// Numbers of its loops.
    pub loops: Vec<usize>,
}

/// Motion of a part relative to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", tag = "type")]
pub enum SceneMotion {
    /// Freely in the plane.
    Planar,
    /// The part does not move.
    Fixed,
    /// The part turns.
    Revolute {
        /// The point about which it turns.
        center: Point,
        /// Least and largest angle; none if it goes round.
        range: Option<(f64, f64)>,
    },
    /// The part slides.
    Prismatic {
        /// The direction; its length does not matter.
        direction: Vector,
        /// Least and largest motion.
        range: Option<(f64, f64)>,
    },
}

impl ScenePart {
    /// A part as the scene has it.
    pub fn of(entry: &PartEntry) -> Self {
        let part = &entry.part;
        Self {
            name: part.name().to_owned(),
            loops: part.loops().iter().map(|l| l.vertices().to_vec()).collect(),
            layers: layers(part),
            feature_names: (part.feature_names())
                .filter_map(|(feature, name)| Some((plain_name(part, feature)?, name.to_owned())))
                .collect(),
            motion: SceneMotion::of(entry.axis),
        }
    }
}

fn layers(part: &Part) -> Vec<SceneLayer> {
    let layer = |l: &cspace::Layer| SceneLayer {
        z: l.z(),
        loops: l.loops().collect(),
    };
    let mut layers: Vec<SceneLayer> = part.layers().iter().map(layer).collect();
    let low = |l: &SceneLayer| l.z.map_or(f64::NEG_INFINITY, |z| z[0]);
    layers.sort_by(|a, b| low(a).total_cmp(&low(b)));
    layers
}

/// Name of a feature to which the model gives none.
fn plain_name(part: &Part, feature: PartFeature) -> Option<String> {
    let (loop_index, index, kind) = match feature {
        PartFeature::Vertex { loop_index, index } => (loop_index, index, FeatureKind::Vertex),
        PartFeature::Edge { loop_index, index } => {
            let edge = (part.loops().get(loop_index as usize)?.edges())
                .find(|e| e.index == index as usize)?;
            // Edges are travelled with material on the left.
            (loop_index, index, FeatureKind::of_bulge(edge.bulge))
        }
    };
    let name = FeatureName {
        kind,
        loop_index,
        index,
    };
    Some(name.to_string())
}

impl SceneMotion {
    /// Motion of a part on an axis, or without one.
    pub fn of(axis: Option<Axis>) -> Self {
        let Some(Axis { motion, range }) = axis else {
            return Self::Planar;
        };
        match motion {
            AxisMotion::Fixed => Self::Fixed,
            AxisMotion::Revolute { center } => Self::Revolute { center, range },
            AxisMotion::Prismatic { direction } => Self::Prismatic { direction, range },
        }
    }

    /// The axis; none of a part that moves freely.
    pub fn axis(self) -> Option<Axis> {
        let (axis, range) = match self {
            Self::Planar => return None,
            Self::Fixed => (Axis::FIXED, None),
            Self::Revolute { center, range } => (Axis::revolute(center), range),
            Self::Prismatic { direction, range } => (Axis::prismatic(direction), range),
        };
        Some(Axis { range, ..axis })
    }
}
