//! Mechanisms in a hand: drives released, and one part led or pulled.

use cspace::{Point, Vector};
use cspace_model::{Mechanism, Spring, SpringKind};

use super::coordinates::System;
use super::layout::PartCoordinates;
use crate::drive::DriveCurve;
use crate::forces::has_forces;

impl System {
    /// The system of a mechanism that has been [checked](Mechanism::check), with its drives released. Where forces act, parts that were driven
    /// hold as brakes do: no load moves them.
    pub(crate) fn released(mechanism: &Mechanism) -> Self {
        let mut released = mechanism.clone();
        let drives = core::mem::take(&mut released.dynamics.drives);
        let mut system = Self::new(&released);
        if has_forces(mechanism) {
            system.braked.extend(drives.iter().map(|drive| drive.part));
            system.braked.sort_unstable();
            system.braked.dedup();
        }
        system
    }

    /// A copy for a mechanism that differs in outlines alone.
    pub(crate) fn reshaped(&self, mechanism: &Mechanism) -> Self {
        let mut system = Self::new(mechanism);
        system.braked.clone_from(&self.braked);
        system
    }

    /// Copy of the system with some coordinates of a part driven from one value to another in the first second. The
    /// position of a planar part is that of one of its points.
    pub(crate) fn led(&self, part: usize, point: Point, ways: &[(usize, [f64; 2])]) -> Self {
        let mut system = self.with_law();
        if let PartCoordinates::Planar { center, .. } = &mut system.parts[part] {
            *center = point;
        }
        system.levers[part] = system.parts[part].levers(&self.mechanism.parts[part].part);
        let drive = |&(i, [from, to]): &(usize, [f64; 2])| (i, DriveCurve::from_to(from, to));
        system.drives = ways.iter().map(drive).collect();
        system.free.retain(|i| ways.iter().all(|way| way.0 != *i));
        system.braked.retain(|other| *other != part);
        system.with_metric()
    }

    /// Copy of the system with a point of a part pulled to a place, and to an orientation if one is given, by springs
    /// of stiffness 1. No other forces act: a hand is stronger than they are.
    pub(crate) fn pulled(&self, part: usize, [point, to]: [Point; 2], angle: Option<f64>) -> Self {
        let spring = |kind| Spring {
            part,
            other: None,
            kind,
        };
        let place = spring(SpringKind::Linear {
            at: (point, to),
            stiffness: 1.0,
            length: 0.0,
            damping: 0.0,
        });
        let size = self.mechanism.parts[part].part.size();
        let turn = angle.map(|angle| {
            spring(SpringKind::Torsion {
                stiffness: size * size,
                angle,
                damping: 0.0,
            })
        });
        let mut system = self.clone();
        let dynamics = &mut system.mechanism.dynamics;
        dynamics.loads.clear();
        dynamics.gravity = Vector::ZERO;
        dynamics.springs = core::iter::once(place).chain(turn).collect();
        system.braked.clear();
        system.with_law()
    }

    /// Copy of the system with the law of its forces: balance, if there are any.
    fn with_law(&self) -> Self {
        match has_forces(&self.mechanism) {
            true => self.balanced(),
            false => self.clone(),
        }
    }
}
