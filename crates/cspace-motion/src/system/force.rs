//! Forces on the coordinates: loads, weights and springs; and springs, whose dampers resist rates.

use cspace::{Point, Vector};
use cspace_model::{LoadKind, SpringKind};

use super::coordinates::System;
use super::joint::Apart;
use super::layout::{PartCoordinates, rows_of};
use super::row::Row;

/// A force f − k s − c ṡ along a function s of the coordinates.
#[derive(Debug, Default)]
pub(crate) struct Pull {
    /// The function s.
    pub(crate) along: Row,
    /// The force f.
    constant: f64,
    /// The stiffness k.
    pub(crate) stiffness: f64,
    /// The damping c.
    pub(crate) damping: f64,
}

impl Pull {
    /// The force without damping, f − k s.
    pub(crate) fn force(&self) -> f64 {
        self.constant - self.stiffness * self.along.value
    }

    /// The energy k s² / 2 − f s.
    pub(crate) fn energy(&self) -> f64 {
        (0.5 * self.stiffness * self.along.value - self.constant) * self.along.value
    }
}

/// The orientation of the first part minus that of the second, and minus an angle.
fn turned(parts: [&PartCoordinates; 2], angle: f64, q: &[f64]) -> Row {
    let mut row = Row::new(-angle);
    for (part, sign) in parts.into_iter().zip([1.0, -1.0]) {
        if let Some(i) = part.orientation() {
            row.value += sign * q[i];
            row.push(i, sign);
        }
    }
    row
}

impl System {
    /// The forces of loads, weights, springs and dampers. Displacements are counted from where parts are drawn.
    pub(crate) fn pulls(&self, q: &[f64]) -> Vec<Pull> {
        let dynamics = &self.mechanism().dynamics;
        let ground = PartCoordinates::Fixed;
        let mut pulls = Vec::new();
        let push = |part: usize, at: Point, force: Vector| {
            let rows = rows_of([&self.parts()[part], &ground], q, &Apart([at, at]));
            [(rows[0], force.x), (rows[1], force.y)].map(|(along, constant)| Pull {
                along,
                constant,
                ..Pull::default()
            })
        };
        for load in &dynamics.loads {
            match load.kind {
                LoadKind::Force { force, at } => {
                    let at = at.unwrap_or(self.center(load.part));
                    pulls.extend(push(load.part, at, force));
                }
                LoadKind::Torque(constant) => pulls.push(Pull {
                    along: turned([&self.parts()[load.part], &ground], 0.0, q),
                    constant,
                    ..Pull::default()
                }),
            }
        }
        let weigh = dynamics.gravity != Vector::ZERO;
        for i in (0..self.parts().len()).filter(|_| weigh) {
            if let Some(mass) = self.mass(i) {
                pulls.extend(push(i, mass.center, dynamics.gravity * mass.mass));
            }
        }
        for spring in &dynamics.springs {
            let other = spring.other.map_or(&ground, |i| &self.parts()[i]);
            let parts = [&self.parts()[spring.part], other];
            let pull = |along: Row, stiffness: f64, damping: f64| Pull {
                along,
                constant: 0.0,
                stiffness,
                damping,
            };
            match spring.kind {
                SpringKind::Linear {
                    at: (p, r),
                    stiffness,
                    length,
                    damping,
                } => {
                    let [x, y] = rows_of(parts, q, &Apart([p, r]));
                    if length == 0.0 && stiffness > 0.0 {
                        // It pulls towards a point from all sides, and is damped in all directions.
                        pulls.extend([x, y].map(|row| pull(row, stiffness, damping)));
                        continue;
                    }
                    let distance = x.value.hypot(y.value);
                    // Without a distance it has no direction, and pulls nowhere.
                    let [c, s] = [x, y].map(|d| d.value / distance.max(f64::MIN_POSITIVE));
                    let mut along = Row::default().plus(c, &x).plus(s, &y);
                    along.value = distance - length;
                    pulls.push(pull(along, stiffness, damping));
                    // Across its length it resists by K (1 − L/l) at length l, where that is positive.
                    let sideways = stiffness * (1.0 - length / distance);
                    if sideways > 0.0 {
                        let mut across = Row::default().plus(-s, &x).plus(c, &y);
                        across.value = 0.0;
                        pulls.push(pull(across, sideways, 0.0));
                    }
                }
                SpringKind::Torsion {
                    stiffness,
                    angle,
                    damping,
                } => pulls.push(pull(turned(parts, angle, q), stiffness, damping)),
            }
        }
        pulls
    }

    /// The forces of loads, weights and springs on the coordinates.
    pub(crate) fn forces(&self, q: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; self.count()];
        for pull in self.pulls(q) {
            pull.along.push_on(&mut forces, pull.force());
        }
        forces
    }
}
