//! Forces on all coordinates, energies, and what drives have to do.

use cspace::{AxisMotion, Placement, Point, Vector};
use cspace_mechanism::{LoadKind, SpringKind};

use crate::dynamic::Acting;

use crate::system::PartCoordinates;

use super::bodies::{All, Bodies, Posed};
use super::contacts::Opening;
use super::joints::Constraint;
use super::rates::still;

/// The forces of loads, weights, springs and dampers on all coordinates; and what dampers take, per second.
pub(super) fn forces(bodies: &Bodies, posed: &Posed) -> (Vec<f64>, f64) {
    let system = &bodies.system;
    let dynamics = &system.mechanism().dynamics;
    let mut pushing = Pushing {
        bodies,
        posed,
        forces: vec![0.0; system.count()],
    };
    let mut damped = 0.0;
    if dynamics.gravity != Vector::ZERO {
        for i in 0..system.parts().len() {
            if let Some(mass) = system.mass(i) {
                pushing.push(i, mass.center, dynamics.gravity * mass.mass);
            }
        }
    }
    for load in &dynamics.loads {
        match load.kind {
            LoadKind::Force { force, at } => {
                pushing.push(load.part, at.unwrap_or(system.center(load.part)), force);
            }
            LoadKind::Torque(torque) => pushing.turn(load.part, torque),
        }
    }
    for spring in &dynamics.springs {
        match spring.kind {
            SpringKind::Linear {
                at: (p, r),
                stiffness,
                length,
                damping,
            } => {
                let (first, moves) = pushing.point(spring.part, p);
                let (second, other) = match spring.other {
                    Some(i) => pushing.point(i, r),
                    None => (r, Vector::ZERO),
                };
                let apart = first - second;
                let distance = apart.length();
                if length == 0.0 && stiffness > 0.0 {
                    // It pulls towards a point from all sides, and is damped in all directions.
                    let rate = moves - other;
                    damped += damping * rate.dot(rate);
                    let force = apart * -stiffness - rate * damping;
                    pushing.push(spring.part, p, force);
                    if let Some(i) = spring.other {
                        pushing.push(i, r, -force);
                    }
                    continue;
                }
                if distance == 0.0 {
                    // It has no direction there, and pulls nowhere.
                    continue;
                }
                let along = apart * distance.recip();
                let rate = along.dot(moves - other);
                damped += damping * rate * rate;
                let force = along * (-stiffness * (distance - length) - damping * rate);
                pushing.push(spring.part, p, force);
                if let Some(i) = spring.other {
                    pushing.push(i, r, -force);
                }
            }
            SpringKind::Torsion {
                stiffness,
                angle,
                damping,
            } => {
                let (turned, turns) = pushing.turned(spring.part);
                let (other, others) = spring.other.map_or((0.0, 0.0), |i| pushing.turned(i));
                let rate = turns - others;
                damped += damping * rate * rate;
                let torque = -stiffness * (turned - other - angle) - damping * rate;
                pushing.turn(spring.part, torque);
                if let Some(i) = spring.other {
                    pushing.turn(i, -torque);
                }
            }
        }
    }
    (pushing.forces, damped)
}

/// Forces on coordinates, as they gather.
struct Pushing<'a> {
    bodies: &'a Bodies,
    posed: &'a Posed,
    forces: Vec<f64>,
}

impl Pushing<'_> {
    /// Position and velocity of a point of a part in the assembly's frame.
    fn point(&self, part: usize, p: Point) -> (Point, Vector) {
        let [x, y] = self.posed.parts[part].point([still(p.x), still(p.y)]);
        (
            Point::new(x.value, y.value),
            Vector::new(x.slope[0], y.slope[0]),
        )
    }

    /// The orientation of a part and its rate.
    fn turned(&self, part: usize) -> (f64, f64) {
        let all = &self.posed.all;
        let of = |i: usize| (all.q[i], all.v[i]);
        let parts = self.bodies.system.parts();
        parts[part].orientation().map_or((0.0, 0.0), of)
    }

    fn turn(&mut self, part: usize, torque: f64) {
        if let Some(i) = self.bodies.system.parts()[part].orientation() {
            self.forces[i] += torque;
        }
    }

    /// A force on a point of a part, in the assembly's frame.
    fn push(&mut self, part: usize, p: Point, force: Vector) {
        let q = &self.posed.all.q;
        match self.bodies.system.parts()[part] {
            PartCoordinates::Fixed => {}
            PartCoordinates::Axis { first, motion, .. } => match motion {
                AxisMotion::Fixed => {}
                AxisMotion::Revolute { center } => {
                    let arm = self.point(part, p).0 - center;
                    self.forces[first] += arm.cross(force);
                }
                AxisMotion::Prismatic { direction } => {
                    self.forces[first] += direction.unit().dot(force);
                }
            },
            PartCoordinates::Planar { first, center } => {
                self.forces[first] += force.x;
                self.forces[first + 1] += force.y;
                if p != center {
                    let arm = self.point(part, p).0 - Point::new(q[first], q[first + 1]);
                    self.forces[first + 2] += arm.cross(force);
                }
            }
        }
    }
}

/// The kinetic energy of all parts.
pub(super) fn kinetic(bodies: &Bodies, all: &All) -> f64 {
    let each = bodies.masses.iter().zip(&all.v);
    each.map(|(m, v)| 0.5 * m * v * v).sum()
}

/// The potential energy of weights, loads and springs: 0 with all parts where they are drawn, but for springs, which have theirs.
pub(super) fn potential(bodies: &Bodies, q: &[f64]) -> f64 {
    let system = &bodies.system;
    let dynamics = &system.mechanism().dynamics;
    let placed = |i: usize| system.placement(i, q);
    let at = |p: &Placement<f64>, c: Point| {
        let [x, y] = p.point([c.x, c.y]);
        Point::new(x, y)
    };
    let turned = |i: usize| system.parts()[i].orientation().map_or(0.0, |k| q[k]);
    let mut energy = 0.0;
    for i in 0..system.parts().len() {
        if let Some(mass) = system.mass(i) {
            energy -= mass.mass
                * dynamics
                    .gravity
                    .dot(at(&placed(i), mass.center) - mass.center);
        }
    }
    for load in &dynamics.loads {
        energy -= match load.kind {
            LoadKind::Force { force, at: point } => {
                let point = point.unwrap_or(system.center(load.part));
                force.dot(at(&placed(load.part), point) - point)
            }
            LoadKind::Torque(torque) => torque * turned(load.part),
        };
    }
    for spring in &dynamics.springs {
        let (stiffness, stretch) = match spring.kind {
            SpringKind::Linear {
                at: (p, r),
                stiffness,
                length,
                ..
            } => {
                let first = at(&placed(spring.part), p);
                let second = spring.other.map_or(r, |i| at(&placed(i), r));
                (stiffness, first.distance(second) - length)
            }
            SpringKind::Torsion {
                stiffness, angle, ..
            } => (
                stiffness,
                turned(spring.part) - spring.other.map_or(0.0, turned) - angle,
            ),
        };
        energy += 0.5 * stiffness * stretch * stretch;
    }
    energy
}

/// Force of each drive on its coordinate, less all other forces on it; the drive's impulse if no accelerations are
/// given.
pub(super) fn drives(
    bodies: &Bodies,
    all: &All,
    acting: &Acting<'_>,
    pushes: Option<&[f64]>,
    contacts: &[Opening],
    joints: &[Constraint],
) -> Vec<(usize, f64)> {
    let system = &bodies.system;
    if system.drives().is_empty() {
        return Vec::new();
    }
    let of = |rates: &super::rates::Rates, i: usize| -> f64 {
        (rates.entries().iter())
            .filter(|e| e.0 == i)
            .map(|e| e.1.value)
            .sum()
    };
    (system.drives().iter())
        .map(|&(i, _)| {
            let own = pushes.map_or(0.0, |h| bodies.masses[i] * all.a[i] - h[i]);
            let pressed: f64 = (acting.contacts.iter().zip(contacts))
                .map(|((_, n, t), c)| n * of(&c.normal, i) + t * of(&c.tangent, i))
                .sum();
            let held: f64 = (acting.joints.iter().zip(joints))
                .map(|(mu, c)| mu * of(&c.rates, i))
                .sum();
            (i, own - pressed - held)
        })
        .collect()
}
