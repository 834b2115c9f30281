//! Forces and torques that act on parts, and springs between them.

use cspace::geometry::{Point, Vector};
use serde::{Deserialize, Serialize};

/// A constant force or torque on a part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Load {
    /// The index of the part.
    pub part: usize,
    /// Force or torque that acts on the part.
    pub kind: LoadKind,
}

/// Force or torque that acts on a part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LoadKind {
    /// A force that keeps its direction while the part turns.
    Force {
        /// The force in the assembly's frame, kg·unit/s².
        force: Vector,
        /// The point of the part at which it acts, in the part's frame; `None` for the centre of mass.
        at: Option<Point>,
    },
    /// A torque, kg·unit²/s², counter-clockwise.
    Torque(f64),
}

/// A spring with a parallel damper between two parts, or between a part and the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spring {
    /// The index of the first part.
    pub part: usize,
    /// The index of the second part; `None` for the ground.
    pub other: Option<usize>,
    /// Kind of spring.
    pub kind: SpringKind,
}

/// Kinds of springs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SpringKind {
    /// A spring that pulls two points towards each other by k (d − l) + c ḋ, where d is their distance.
    Linear {
        /// The two points: the first in the first part's frame, the second in the second part's frame, or in the assembly's if it is the
        /// ground.
        at: (Point, Point),
        /// k, the force per length, kg/s².
        stiffness: f64,
        /// l, the distance at which there is no force, in the model's unit.
        length: f64,
        /// c, the force per rate of change of the distance, kg/s.
        damping: f64,
    },
    /// A spring that turns the first part relative to the second by the torque −k (θ − θ₀) − c θ̇, where θ is the orientation of the first
    /// part minus that of the second. Whole turns count.
    Torsion {
        /// k, the torque per angle, kg·unit²/s² per radian.
        stiffness: f64,
        /// θ₀, the angle at which there is no torque, radians.
        angle: f64,
        /// c, the torque per angular velocity, kg·unit²/s.
        damping: f64,
    },
}
