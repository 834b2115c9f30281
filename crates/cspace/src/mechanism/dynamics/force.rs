//! Forces and torques that act on parts, and springs between them.

use crate::geometry::{Point, Vector};

/// A constant force or torque on a part.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Load {
    /// The index of the part.
    pub part: usize,
    /// Force or torque that acts on the part.
    pub kind: LoadKind,
}

/// Force or torque that acts on a part.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum LoadKind {
    /// A force that keeps its direction while the part turns.
    Force {
        /// In the assembly's frame, kg·unit/s².
        force: Vector,
        /// The point of the part at which it acts, in the part's frame; the centre of mass if there is none.
        at: Option<Point>,
    },
    /// A torque, kg·unit²/s², counter-clockwise.
    Torque(f64),
}

/// A spring between two parts, or a part and the ground, with a damper beside it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Spring {
    /// The index of the first part.
    pub part: usize,
    /// The index of the second part; the ground if there is none.
    pub other: Option<usize>,
    /// How it acts.
    pub kind: SpringKind,
}

/// How a spring acts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum SpringKind {
    /// It pulls two points towards each other by k (d − l) + c ḋ, d their distance.
    Linear {
        /// The two points: the first in the first part's frame, the second in the second part's, of the ground in the
        /// assembly's.
        at: (Point, Point),
        /// k, the force per length, kg/s².
        stiffness: f64,
        /// l, the distance at which it pulls and pushes nothing, in the model's unit.
        length: f64,
        /// c, the force per rate of change of the distance, kg/s.
        damping: f64,
    },
    /// It turns the first part against the second by the torque −k (θ − θ₀) − c θ̇, θ the orientation of the first part less
    /// that of the second. Whole turns count.
    Torsion {
        /// k, the torque per angle, kg·unit²/s² per radian.
        stiffness: f64,
        /// θ₀, the angle at which it gives no torque, radians.
        angle: f64,
        /// c, the torque per angular velocity, kg·unit²/s.
        damping: f64,
    },
}
