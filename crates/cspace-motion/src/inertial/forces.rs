//! Forces on all coordinates, energies, and what drives have to do.

use crate::dynamic::Acting;
use crate::system::{Pull, Row, System};

use super::bodies::{All, Bodies};
use super::contacts::Opening;
use super::rates::InTime;

/// The forces of loads, weights, springs and dampers on all coordinates; and what dampers take, per second.
pub(super) fn forces(system: &System, all: &All) -> (Vec<f64>, f64) {
    let (mut forces, mut damped) = (vec![0.0; system.count()], 0.0);
    for pull in system.pulls(&all.q) {
        let rate = pull.along.rate(&all.v);
        damped += pull.damping * rate * rate;
        (pull.along).push_on(&mut forces, pull.force() - pull.damping * rate);
    }
    (forces, damped)
}

/// The kinetic energy of all parts.
pub(super) fn kinetic(bodies: &Bodies, all: &All) -> f64 {
    let each = bodies.masses.iter().zip(&all.v);
    each.map(|(m, v)| 0.5 * m * v * v).sum()
}

/// The potential energy of weights, loads and springs: 0 with all parts where they are drawn, but for springs, which have theirs.
pub(super) fn potential(system: &System, q: &[f64]) -> f64 {
    system.pulls(q).iter().map(Pull::energy).sum()
}

/// Force of each drive on its coordinate, less all other forces on it; the drive's impulse if no accelerations are
/// given.
pub(super) fn drives(
    bodies: &Bodies,
    all: &All,
    acting: &Acting<'_>,
    pushes: Option<&[f64]>,
    contacts: &[Opening],
    joints: &[Row<InTime>],
) -> Vec<(usize, f64)> {
    let system = &bodies.system;
    if system.drives().is_empty() {
        return Vec::new();
    }
    let of = |rates: &Row<InTime>, i: usize| -> f64 {
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
                .map(|(mu, c)| mu * of(c, i))
                .sum();
            (i, own - pressed - held)
        })
        .collect()
}
