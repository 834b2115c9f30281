//! Forces on all coordinates, energies, and what drives have to do.

use cspace::mechanism::{LoadKind, SpringKind};
use cspace::{Placement, Point};

use crate::dynamic::Acting;

use super::bodies::{All, Bodies};
use super::contacts::Opening;
use super::joints::Constraint;

/// The forces of loads, weights, springs and dampers on all coordinates.
pub(super) fn forces(bodies: &Bodies, all: &All) -> Vec<f64> {
    let n = bodies.system.count();
    let (mut forces, mut damping) = (vec![0.0; n], vec![0.0; n * n]);
    bodies.system.add_forces(&all.q, &mut forces, &mut damping);
    for i in 0..n {
        for k in 0..n {
            forces[i] -= damping[i * n + k] * all.v[k];
        }
    }
    forces
}

/// What dampers take, per second.
pub(super) fn damped(bodies: &Bodies, all: &All) -> f64 {
    let n = bodies.system.count();
    let (mut forces, mut damping) = (vec![0.0; n], vec![0.0; n * n]);
    bodies.system.add_forces(&all.q, &mut forces, &mut damping);
    let row = |i: usize| -> f64 { (0..n).map(|k| damping[i * n + k] * all.v[k]).sum() };
    (0..n).map(|i| all.v[i] * row(i)).sum()
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

/// The force of each drive on its coordinate, or its impulse if there are no accelerations.
pub(super) fn drives(
    bodies: &Bodies,
    all: &All,
    acting: &Acting<'_>,
    contacts: &[Opening],
    joints: &[Constraint],
) -> Vec<(usize, f64)> {
    let system = &bodies.system;
    if system.drives().is_empty() {
        return Vec::new();
    }
    let pushes = acting.accelerations.map(|_| forces(bodies, all));
    let of = |rates: &super::rates::Rates, i: usize| -> f64 {
        (rates.entries().iter())
            .filter(|e| e.0 == i)
            .map(|e| e.1.value)
            .sum()
    };
    (system.drives().iter())
        .map(|&(i, _)| {
            let own = pushes
                .as_ref()
                .map_or(0.0, |h| bodies.masses[i] * all.a[i] - h[i]);
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
