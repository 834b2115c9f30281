//! Forces on the coordinates: loads, weights and springs; and springs, whose dampers resist rates.

use cspace::{Placement, Point, Real, Vector};
use cspace_mechanism::{Load, LoadKind, Spring, SpringKind};

use super::coordinates::System;
use super::layout::{PartCoordinates, Placed, rows_of};
use super::row::Row;

/// x and y of a point of the first part in the assembly's frame.
struct At(Point);

impl Placed<2> for At {
    fn values<T: Real>(&self, a: &Placement<T>, _: &Placement<T>) -> [T; 2] {
        a.point([T::constant(self.0.x), T::constant(self.0.y)])
    }
}

/// x and y of a point of a part in the assembly's frame.
fn place(part: &PartCoordinates, p: Point, q: &[f64]) -> [Row; 2] {
    rows_of([part, &PartCoordinates::Fixed], q, &At(p))
}

/// Adds what a force along a function of the coordinates does to them.
fn push(forces: &mut [f64], row: &Row, force: f64) {
    for &(i, d) in row.entries() {
        forces[i] += force * d;
    }
}

impl System {
    /// Adds the forces on all coordinates. `spring` is called for each spring with its length or angle, its stiffness
    /// and its damping; and, for the direction across its length, with the stiffness by which its pull resists there.
    pub(crate) fn add_forces(
        &self,
        q: &[f64],
        forces: &mut [f64],
        mut spring: impl FnMut(&Row, f64, f64),
    ) {
        for load in &self.mechanism().dynamics.loads {
            self.add_load(load, q, forces);
        }
        let gravity = self.mechanism().dynamics.gravity;
        let weigh = gravity != Vector::ZERO;
        for (i, part) in self.parts().iter().enumerate().filter(|_| weigh) {
            if let Some(mass) = self.mass(i) {
                let [x, y] = place(part, mass.center, q);
                push(forces, &x, mass.mass * gravity.x);
                push(forces, &y, mass.mass * gravity.y);
            }
        }
        for one in &self.mechanism().dynamics.springs {
            for (row, force, stiffness, damping) in self.pull(one, q).into_iter().flatten() {
                push(forces, &row, force);
                spring(&row, stiffness, damping);
            }
        }
    }

    fn add_load(&self, load: &Load, q: &[f64], forces: &mut [f64]) {
        let part = &self.parts()[load.part];
        match load.kind {
            LoadKind::Force { force, at } => {
                let [x, y] = place(part, at.unwrap_or(self.center(load.part)), q);
                push(forces, &x, force.x);
                push(forces, &y, force.y);
            }
            LoadKind::Torque(torque) => {
                if let Some(i) = part.orientation() {
                    forces[i] += torque;
                }
            }
        }
    }

    /// Length or angle of a spring, the force along it, its stiffness and its damping; and the stiffness across its
    /// length: K (1 − L/l) at length l, where that is positive, with K of the spring and L without force.
    fn pull(&self, spring: &Spring, q: &[f64]) -> [Option<(Row, f64, f64, f64)>; 2] {
        let ground = PartCoordinates::Fixed;
        let first = &self.parts()[spring.part];
        let second = spring.other.map_or(&ground, |i| &self.parts()[i]);
        match spring.kind {
            SpringKind::Linear {
                at: (p, r),
                stiffness,
                length,
                damping,
            } => {
                let ([px, py], [rx, ry]) = (place(first, p, q), place(second, r, q));
                let (x, y) = (px.plus(-1.0, &rx), py.plus(-1.0, &ry));
                let distance = x.value.hypot(y.value);
                if distance == 0.0 {
                    // It has no direction there, and pulls nowhere; without a length it resists in all directions.
                    let to_a_point = length == 0.0 && stiffness > 0.0;
                    let each = |row| to_a_point.then_some((row, 0.0, stiffness, damping));
                    return [x, y].map(each);
                }
                let (c, s) = (x.value / distance, y.value / distance);
                let along = Row::new(0.0).plus(c, &x).plus(s, &y);
                let across = Row::new(0.0).plus(-s, &x).plus(c, &y);
                let sideways = stiffness * (1.0 - length / distance);
                [
                    Some((along, -stiffness * (distance - length), stiffness, damping)),
                    (sideways > 0.0).then_some((
                        across,
                        0.0,
                        sideways,
                        if length == 0.0 { damping } else { 0.0 },
                    )),
                ]
            }
            SpringKind::Torsion {
                stiffness,
                angle,
                damping,
            } => {
                let turned = |part: &PartCoordinates| {
                    let mut row = Row::default();
                    if let Some(i) = part.orientation() {
                        row = Row::new(q[i]);
                        row.push(i, 1.0);
                    }
                    row
                };
                let between = turned(first).plus(-1.0, &turned(second));
                let torque = -stiffness * (between.value - angle);
                [Some((between, torque, stiffness, damping)), None]
            }
        }
    }
}
