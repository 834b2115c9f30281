//! Joints of a scene.

use cspace::pair::Joint;
use cspace::{Point, Vector};
use cspace_model::JointEntry;
use serde::Serialize;

/// A permanent connection of two parts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SceneJoint {
    /// Degrees of freedom of the joint.
    #[serde(rename = "type")]
    pub kind: JointKind,
    /// Indices of the two parts.
    pub parts: (usize, usize),
    /// Position, in the assembly's frame at zero motion.
    pub at: Point,
    /// The direction of sliding.
    pub direction: Option<Vector>,
}

/// Degrees of freedom of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum JointKind {
    /// A turn.
    Revolute,
    /// Sliding.
    Prismatic,
}

impl SceneJoint {
    /// A joint as the scene has it.
    pub fn of(entry: &JointEntry) -> Self {
        let (kind, at, direction) = match entry.joint {
            Joint::Revolute { at } => (JointKind::Revolute, at, None),
            Joint::Prismatic { direction, at } => (JointKind::Prismatic, at, Some(direction)),
        };
        Self {
            kind,
            parts: entry.parts,
            at,
            direction,
        }
    }
}
