//! Masses, forces and drives of a mechanism, as `cspace info` prints them.

use cspace::{AxisMotion, Point, Vector};
use cspace_model::{
    Drive, DriveMotion, Load, LoadKind, Mechanism, PartPosition, PartVelocity, Spring, SpringKind,
};
use serde::Serialize;

/// Mass properties and initial state of a part, as far as the model determines them.
#[derive(Serialize, Default)]
pub(super) struct PartMotion {
    /// kg, also where a density is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) mass: Option<f64>,
    /// In the part's frame; the outline's centroid of a part with a mass and no centre of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) center_of_mass: Option<[f64; 2]>,
    /// About the centre of mass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) inertia: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) start: Option<OneOrThree>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) rate: Option<OneOrThree>,
    /// Whether its coordinate is an angle.
    #[serde(skip)]
    pub(super) turns: bool,
}

/// Along an axis, or in the plane.
#[derive(Serialize, Clone, Copy)]
#[serde(untagged)]
pub(super) enum OneOrThree {
    One(f64),
    Three([f64; 3]),
}

/// Friction and restitution of a pair, if the model gives them for the pair itself.
#[derive(Serialize, Default)]
pub(super) struct SurfaceInfo {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) friction: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) restitution: Option<f64>,
}

/// Forces, drives and surface constants of the whole mechanism.
#[derive(Serialize, Default)]
pub(super) struct Forces {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) gravity: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) friction: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) restitution: Option<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) drives: Vec<DriveInfo>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) loads: Vec<LoadInfo>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) springs: Vec<SpringInfo>,
}

#[derive(Serialize)]
pub(super) struct DriveInfo {
    pub(super) part: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) rate: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) table: Option<Vec<(f64, f64)>>,
    /// Whether the part's coordinate is an angle.
    #[serde(skip)]
    pub(super) turns: bool,
}

#[derive(Serialize)]
pub(super) struct LoadInfo {
    pub(super) part: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) force: Option<[f64; 2]>,
    /// Where the force acts, in the part's frame; at the centre of mass if it does not say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) at: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) torque: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct SpringInfo {
    #[serde(rename = "type")]
    pub(super) kind: &'static str,
    /// One part if the spring is against the ground.
    pub(super) parts: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) at: Option<[[f64; 2]; 2]>,
    pub(super) stiffness: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) length: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) angle: Option<f64>,
    pub(super) damping: f64,
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

pub(super) fn part_motion(model: &Mechanism, part: usize) -> PartMotion {
    let given = model.dynamics.part(part);
    let mass = model.mass_properties(part);
    let center = mass.map(|m| m.center).or(given.center_of_mass);
    PartMotion {
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

/// The friction and restitution given for the pair of these parts.
pub(super) fn surface(model: &Mechanism, fixed: &str, moving: &str) -> SurfaceInfo {
    let parts = model.part_index(fixed).zip(model.part_index(moving));
    let own = parts.and_then(|(a, b)| model.dynamics.surface(a, b));
    SurfaceInfo {
        friction: own.and_then(|s| s.friction),
        restitution: own.and_then(|s| s.restitution),
    }
}

pub(super) fn forces(model: &Mechanism) -> Forces {
    let all = &model.dynamics;
    let other_than_0 = |x: f64| (x != 0.0).then_some(x);
    Forces {
        gravity: (all.gravity != Vector::ZERO).then(|| components(all.gravity)),
        friction: other_than_0(all.friction),
        restitution: other_than_0(all.restitution),
        drives: all.drives.iter().map(|d| drive(model, d)).collect(),
        loads: all.loads.iter().map(|l| load(model, l)).collect(),
        springs: all.springs.iter().map(|s| spring(model, s)).collect(),
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
            kind: "linear",
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
            kind: "torsion",
            parts,
            at: None,
            stiffness,
            length: None,
            angle: Some(angle),
            damping,
        },
    }
}
