//! Masses, forces and drives of a mechanism.

use cspace::{AxisMotion, Point, Vector};
use cspace_model::{
    Drive, DriveMotion, Load, LoadKind, Mechanism, PartPosition, PartVelocity, Spring, SpringKind,
};
use schemars::JsonSchema;
use serde::Serialize;

/// Mass properties and initial state of a part, as far as the model determines them.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Dynamics {
    /// Its mass in kg, where the model gives it a mass or a density.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// In the part's frame: as given, or of a part with a mass the centroid of its outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub center_of_mass: Option<[f64; 2]>,
    /// The moment of inertia about the centre of mass, kg·unit², as given or from the outline.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<f64>,
    /// Where it is at the start, where that is given: x, y and theta, or how far along its axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<OneOrThree>,
    /// How fast it moves at the start, where that is given, per second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<OneOrThree>,
    /// Whether its coordinate is an angle.
    #[serde(skip)]
    pub turns: bool,
}

/// Numbers of a part on an axis, or in the plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OneOrThree {
    /// Along an axis.
    One(f64),
    /// x, y and theta.
    Three([f64; 3]),
}

/// Friction and restitution of a pair, if the model gives them for the pair itself.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Surface {
    /// The coefficient of friction, where the pair has one of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// The coefficient of restitution, where the pair has one of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restitution: Option<f64>,
}

/// Forces, drives and surface constants of the whole mechanism.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct Forces {
    /// The acceleration of what falls, unit/s², where there is any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gravity: Option<[f64; 2]>,
    /// The coefficient of friction of pairs without one of their own, where it is not 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub friction: Option<f64>,
    /// The coefficient of restitution of pairs without one of their own, where it is not 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restitution: Option<f64>,
    /// Prescribed motions, where there are any.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub drives: Vec<DriveInfo>,
    /// Constant forces and torques, where there are any.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<LoadInfo>,
    /// Springs and dampers, where there are any.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub springs: Vec<SpringInfo>,
}

/// A prescribed motion.
#[derive(Debug, Serialize, JsonSchema)]
pub struct DriveInfo {
    /// The part's name.
    pub part: String,
    /// Its rate, radians or lengths per second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
    /// Times and where the part is then: radians or lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table: Option<Vec<(f64, f64)>>,
    /// Whether the part's coordinate is an angle.
    #[serde(skip)]
    pub turns: bool,
}

/// A constant force or torque.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LoadInfo {
    /// The part's name.
    pub part: String,
    /// In the assembly's frame, kg·unit/s².
    #[serde(skip_serializing_if = "Option::is_none")]
    pub force: Option<[f64; 2]>,
    /// Where it acts, in the part's frame; at the centre of mass if this is missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 2]>,
    /// kg·unit²/s², counter-clockwise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub torque: Option<f64>,
}

/// A spring, or a damper.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SpringInfo {
    /// The kind.
    #[serde(rename = "type")]
    pub kind: SpringType,
    /// The names of two parts, or of one if the spring is against the ground.
    #[schemars(length(min = 1, max = 2))]
    pub parts: Vec<String>,
    /// The points of a linear spring, each in its part's frame, of the ground in the assembly's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<[[f64; 2]; 2]>,
    /// Force per length, kg/s², or torque per radian, kg·unit²/s².
    pub stiffness: f64,
    /// The length of a linear spring at which it gives no force.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// The angle of a torsion spring at which it gives no torque, radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// Force per rate of length, kg/s, or torque per angular velocity, kg·unit²/s.
    pub damping: f64,
}

/// The kind of a spring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SpringType {
    /// Between two points.
    Linear,
    /// Between two directions.
    Torsion,
}

fn numbers(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

fn components(v: Vector) -> [f64; 2] {
    [v.x, v.y]
}

/// Whether a part's coordinate is an angle.
fn turns(model: &Mechanism, part: usize) -> bool {
    let axis = model.parts.get(part).and_then(|p| p.axis);
    axis.is_some_and(|x| matches!(x.motion, AxisMotion::Revolute { .. }))
}

fn name(model: &Mechanism, part: usize) -> String {
    (model.parts.get(part)).map_or_else(String::new, |p| p.part.name().to_owned())
}

impl Dynamics {
    /// Mass and state of the part with this index.
    pub(super) fn of(model: &Mechanism, part: usize) -> Self {
        let given = model.dynamics.part(part);
        let mass = model.mass_properties(part);
        let center = mass.map(|m| m.center).or(given.center_of_mass);
        Self {
            mass: mass.map(|m| m.mass),
            center_of_mass: center.map(numbers),
            inertia: mass.map(|m| m.inertia),
            start: given.start.map(|s| match s {
                PartPosition::Axis(u) => OneOrThree::One(u),
                PartPosition::Planar(c) => OneOrThree::Three([c.x, c.y, c.theta]),
            }),
            rate: given.rate.map(|r| match r {
                PartVelocity::Axis(u) => OneOrThree::One(u),
                PartVelocity::Planar { linear, angular } => {
                    OneOrThree::Three([linear.x, linear.y, angular])
                }
            }),
            turns: turns(model, part),
        }
    }
}

impl Surface {
    /// The friction and restitution given for the pair of these parts.
    pub(super) fn of(model: &Mechanism, fixed: &str, moving: &str) -> Self {
        let parts = model.part_index(fixed).zip(model.part_index(moving));
        let own = parts.and_then(|(a, b)| model.dynamics.surface(a, b));
        Self {
            friction: own.and_then(|s| s.friction),
            restitution: own.and_then(|s| s.restitution),
        }
    }
}

impl Forces {
    /// All that acts on the parts of a mechanism.
    pub(super) fn of(model: &Mechanism) -> Self {
        let all = &model.dynamics;
        let other_than_0 = |x: f64| (x != 0.0).then_some(x);
        Self {
            gravity: (all.gravity != Vector::ZERO).then(|| components(all.gravity)),
            friction: other_than_0(all.friction),
            restitution: other_than_0(all.restitution),
            drives: all.drives.iter().map(|d| drive(model, d)).collect(),
            loads: all.loads.iter().map(|l| load(model, l)).collect(),
            springs: all.springs.iter().map(|s| spring(model, s)).collect(),
        }
    }
}

fn drive(model: &Mechanism, drive: &Drive) -> DriveInfo {
    let (rate, table) = match &drive.motion {
        DriveMotion::Rate(rate) => (Some(*rate), None),
        DriveMotion::Table(points) => (None, Some(points.clone())),
    };
    DriveInfo {
        part: name(model, drive.part),
        rate,
        table,
        turns: turns(model, drive.part),
    }
}

fn load(model: &Mechanism, load: &Load) -> LoadInfo {
    let (force, at, torque) = match load.kind {
        LoadKind::Force { force, at } => (Some(components(force)), at.map(numbers), None),
        LoadKind::Torque(torque) => (None, None, Some(torque)),
    };
    LoadInfo {
        part: name(model, load.part),
        force,
        at,
        torque,
    }
}

fn spring(model: &Mechanism, spring: &Spring) -> SpringInfo {
    let parts = [Some(spring.part), spring.other];
    let parts = parts
        .into_iter()
        .flatten()
        .map(|i| name(model, i))
        .collect();
    match spring.kind {
        SpringKind::Linear {
            at: (p, q),
            stiffness,
            length,
            damping,
        } => SpringInfo {
            kind: SpringType::Linear,
            parts,
            at: Some([p, q].map(numbers)),
            stiffness,
            length: Some(length),
            angle: None,
            damping,
        },
        SpringKind::Torsion {
            stiffness,
            angle,
            damping,
        } => SpringInfo {
            kind: SpringType::Torsion,
            parts,
            at: None,
            stiffness,
            length: None,
            angle: Some(angle),
            damping,
        },
    }
}
