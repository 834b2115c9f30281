//! Forces of joints and drives for recordings, and whether any forces act.

use cspace::Vector;
use cspace::pair::Joint;
use cspace_model::Mechanism;

use crate::record::{DriveForce, JointForce};
use crate::system::System;

/// Whether loads, springs or weights act on any part of a mechanism.
///
/// ```
/// use cspace_model::{Load, LoadKind, Mechanism};
/// let mut mechanism = Mechanism::new("wheel");
/// assert!(!cspace_motion::has_forces(&mechanism));
/// mechanism.dynamics.loads.push(Load { part: 0, kind: LoadKind::Torque(2.0) });
/// assert!(cspace_motion::has_forces(&mechanism));
/// ```
pub fn has_forces(mechanism: &Mechanism) -> bool {
    let dynamics = &mechanism.dynamics;
    let weighs = mechanism.has_masses() && dynamics.gravity != Vector::ZERO;
    weighs || !dynamics.loads.is_empty() || !dynamics.springs.is_empty()
}

/// Forces of the joints from their multipliers, in the order of the joints.
pub(crate) fn joint_forces(system: &System, q: &[f64], multipliers: &[f64]) -> Vec<JointForce> {
    let name = |part: usize| system.mechanism().parts[part].part.name().to_owned();
    let mut mu = multipliers.iter().copied();
    let mut next = || mu.next().unwrap_or(0.0);
    (system.joint_entries().iter())
        .map(|entry| {
            let (a, b) = entry.parts;
            // The first part's constraint force is the multiplier along the direction, the second's its opposite.
            let (force, torque) = match entry.joint {
                Joint::Revolute { .. } => ([-next(), -next()], 0.0),
                Joint::Prismatic { direction, .. } => {
                    let n = direction.unit().left();
                    let [x, y] = system.placement(a, q).vector([n.x, n.y]);
                    let across = next();
                    ([-across * x, -across * y], next() * system.size())
                }
            };
            JointForce {
                parts: [name(a), name(b)],
                force,
                torque,
            }
        })
        .collect()
}

/// The force of the drive of a coordinate, which moves at a rate.
pub(crate) fn drive_force(system: &System, coordinate: usize, force: f64, rate: f64) -> DriveForce {
    let mut parts = system.parts().iter();
    let part = parts.position(|p| p.indices().contains(&coordinate));
    DriveForce {
        part: system.mechanism().parts[part.unwrap_or(0)]
            .part
            .name()
            .to_owned(),
        force,
        power: force * rate,
    }
}
