//! The parts, joints and pairs of a model or a saved space, and what moves them.

mod dynamics;
mod part;

use cspace::pair::Joint;
use cspace::{PairClass, PairSpace, Part};
use cspace_model::model;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use dynamics::{
    DriveInfo, Dynamics, Forces, LoadInfo, OneOrThree, SpringInfo, SpringType, Surface,
};
pub use part::{FeatureCount, Motion, PartInfo};

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::host::Host;
use crate::outcome::Done;
use crate::subject::{Chosen, Subject, Which};

/// Which pairs are told of.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; all of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub which: Which,
}

/// A model, or a saved space, and what it consists of.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Info {
    /// The name of the model.
    pub name: String,
    /// The model's label of the unit of length, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The model's parameters, by name; left out if it has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parameters: Vec<Parameter>,
    /// The parts.
    pub parts: Vec<PartInfo>,
    /// Permanent connections.
    pub joints: Vec<JointInfo>,
    /// The pairs that are studied.
    pub pairs: Vec<PairInfo>,
    /// Forces, drives and surface constants.
    #[serde(flatten)]
    pub forces: Forces,
}

impl Content for Info {
    const COMMAND: &'static str = "info";
    type Outcome = Done;
}

/// A parameter of a model.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Parameter {
    /// Its name, as expressions write it.
    pub name: String,
    /// Its value; of an angle in radians.
    pub value: f64,
    /// How the value is written, if it is an expression of other parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expression: Option<String>,
    /// Whether the value is not that of the model, but was given.
    pub set: bool,
    /// How far below and above the value it may be, if the model says so; one is negative where the value is outside its limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviations: Option<[f64; 2]>,
    /// The parts and other entries in which numbers depend on it.
    pub used_by: Vec<String>,
}

/// A permanent connection of two parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct JointInfo {
    /// The kind.
    #[serde(rename = "type")]
    pub kind: JointKind,
    /// The names of the parts.
    pub parts: [String; 2],
    /// The point that both parts turn about, or a point of the line of sliding.
    pub at: [f64; 2],
    /// The direction of a slide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<[f64; 2]>,
}

/// The kind of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum JointKind {
    /// The parts turn about a common point.
    Revolute,
    /// The parts slide along each other.
    Prismatic,
}

impl JointKind {
    /// As in the answer.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Revolute => "revolute",
            Self::Prismatic => "prismatic",
        }
    }
}

/// A pair of parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PairInfo {
    /// Name of the fixed part.
    pub fixed: String,
    /// Name of the moving part.
    pub moving: String,
    /// How the pair is computed.
    pub class: PairClass,
    /// Lines, arcs, and vertices that are not smooth joints, of both parts.
    pub features: usize,
    /// The first and the last orientation of its window, radians; left out without a window.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theta: Option<(f64, f64)>,
    /// Friction and restitution, where the pair has some of its own.
    #[serde(flatten)]
    pub surface: Surface,
}

impl Question {
    /// Describes a model or a saved space.
    ///
    /// # Errors
    /// If there is no such pair, or it has no orientations and a window of them is asked for.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Info>, Error> {
        let pairs = subject.pairs_if_any(&self.which, host)?;
        for pair in &pairs {
            pair.check_window()?;
        }
        let info = Info::of(subject, &pairs);
        Ok(Answer::new(subject.unit(), Done::Done, info))
    }
}

impl Info {
    fn of(subject: &Subject, pairs: &[Chosen<'_>]) -> Self {
        let pairs = pairs.iter().map(|p| PairInfo::of(subject, p)).collect();
        match subject {
            Subject::Model(file) => {
                let (model, parameters) = (&file.model.mechanism, &file.model.parameters);
                let part = |i: usize| &model.parts[i].part;
                Self {
                    name: model.name.clone(),
                    unit: model.unit.clone(),
                    parameters: parameters.iter().map(Parameter::of).collect(),
                    parts: (model.parts.iter().enumerate())
                        .map(|(i, p)| PartInfo::of_entry(p, Dynamics::of(model, i)))
                        .collect(),
                    joints: (model.joints.iter())
                        .map(|j| JointInfo::of(j.joint, [part(j.parts.0), part(j.parts.1)]))
                        .collect(),
                    pairs,
                    forces: Forces::of(model),
                }
            }
            Subject::Saved { file, .. } => {
                let space = &file.space;
                let parts = || format!("{} and {}", space.fixed().name(), space.moving().name());
                Self {
                    name: file.name.clone().unwrap_or_else(parts),
                    unit: file.unit.clone(),
                    parameters: Vec::new(),
                    parts: parts_of(space),
                    joints: match space {
                        PairSpace::Lower(pair) => {
                            vec![JointInfo::of(pair.joint(), [pair.fixed(), pair.moving()])]
                        }
                        _ => Vec::new(),
                    },
                    pairs,
                    forces: Forces::default(),
                }
            }
        }
    }
}

/// The parts of a saved space; how they move relative to the ground is known of those on axes only.
fn parts_of(space: &PairSpace) -> Vec<PartInfo> {
    let axes = match space {
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            [fixed, moving].map(Some)
        }
        _ => [None; 2],
    };
    ([space.fixed(), space.moving()].into_iter().zip(axes))
        .map(|(part, axis)| PartInfo::of(part, axis, Dynamics::default()))
        .collect()
}

impl Parameter {
    fn of(p: &model::Parameter) -> Self {
        Self {
            name: p.name.clone(),
            value: p.value,
            expression: p.expression.clone(),
            set: p.is_set,
            deviations: p.deviations.map(|(below, above)| [below, above]),
            used_by: p.used_by.clone(),
        }
    }
}

impl PairInfo {
    fn of(subject: &Subject, pair: &Chosen<'_>) -> Self {
        let (fixed, moving) = (pair.fixed(), pair.moving());
        Self {
            fixed: fixed.name().to_owned(),
            moving: moving.name().to_owned(),
            class: pair.class_in_full(),
            features: FeatureCount::of(fixed).total + FeatureCount::of(moving).total,
            theta: pair.window(),
            surface: match subject {
                Subject::Model(file) => {
                    Surface::of(&file.model.mechanism, fixed.name(), moving.name())
                }
                Subject::Saved { .. } => Surface::default(),
            },
        }
    }
}

impl JointInfo {
    fn of(joint: Joint, parts: [&Part; 2]) -> Self {
        let (kind, at, direction) = match joint {
            Joint::Revolute { at } => (JointKind::Revolute, at, None),
            Joint::Prismatic { direction, at } => (JointKind::Prismatic, at, Some(direction)),
        };
        Self {
            kind,
            parts: parts.map(|p| p.name().to_owned()),
            at: [at.x, at.y],
            direction: direction.map(|d| [d.x, d.y]),
        }
    }
}
