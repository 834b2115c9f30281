//! Checks of the dynamic data of a mechanism.

use std::collections::HashSet;

use super::at::{At, Checked, stands_still};
use super::data::{Dynamics, PairSurface, PartDynamics};
use super::fault::{DynamicsError, DynamicsFault, DynamicsItem};
use super::force::{Load, LoadKind, Spring, SpringKind};
use super::mass::Mass;
use super::motion::{Drive, DriveMotion, PartPosition, PartVelocity};
use crate::mechanism::entries::{Mechanism, PartEntry};

impl Dynamics {
    /// Checks the data for a mechanism of these parts and pairs.
    ///
    /// # Errors
    /// The first fault, in the order of the fields.
    pub fn check(&self, mechanism: &Mechanism) -> Checked {
        let parts = &mechanism.parts;
        let whole = At(DynamicsItem::Mechanism);
        whole.finite("gravity", &[self.gravity.x, self.gravity.y])?;
        whole.not_negative("friction", self.friction)?;
        whole.up_to_one("restitution", self.restitution)?;
        for (i, part) in self.parts.iter().enumerate() {
            part.check(i, entry(parts, i)?)?;
        }
        if !self.pairs.is_empty() {
            let listed: HashSet<_> = (mechanism.pairs.iter())
                .map(|p| ordered((p.fixed, p.moving)))
                .collect();
            let mut known = HashSet::new();
            for surface in &self.pairs {
                surface.check(&listed, &mut known)?;
            }
        }
        for (i, drive) in self.drives.iter().enumerate() {
            drive.check(i, &self.drives[..i], parts)?;
            self.not_said_twice(i, drive)?;
        }
        for (i, load) in self.loads.iter().enumerate() {
            load.check(At(DynamicsItem::Load(i)), parts)?;
        }
        for (i, spring) in self.springs.iter().enumerate() {
            spring.check(At(DynamicsItem::Spring(i)), parts)?;
        }
        Ok(())
    }

    /// Checks that the rate of a driven part, and with a table its start, are given only by the drive.
    fn not_said_twice(&self, index: usize, drive: &Drive) -> Checked {
        let part = self.part(drive.part);
        let at = At(DynamicsItem::Part(drive.part));
        let fault = DynamicsFault::Driven { drive: index };
        let by_table = matches!(drive.motion, DriveMotion::Table(_));
        if by_table && part.start.is_some() {
            return at.fails("start", fault);
        }
        if part.rate.is_some() {
            return at.fails("rate", fault);
        }
        Ok(())
    }
}

/// The part that an index in [`Dynamics::parts`] refers to.
fn entry(parts: &[PartEntry], part: usize) -> Result<&PartEntry, DynamicsError> {
    parts.get(part).ok_or(DynamicsError {
        item: DynamicsItem::Part(part),
        key: "part",
        fault: DynamicsFault::NoSuchPart {
            part,
            parts: parts.len(),
        },
    })
}

impl PartDynamics {
    /// Checks what is given of part number `part`.
    ///
    /// # Errors
    /// The first fault, in the order of the fields.
    pub fn check(&self, part: usize, entry: &PartEntry) -> Checked {
        let at = At(DynamicsItem::Part(part));
        match self.mass {
            Some(Mass::Total(mass)) => at.positive("mass", mass)?,
            Some(Mass::Density(density)) => at.positive("density", density)?,
            None => {}
        }
        if let Some(inertia) = self.inertia {
            at.positive("inertia", inertia)?;
            if self.mass.is_none() {
                return at.fails("inertia", DynamicsFault::NoMass);
            }
        }
        if let Some(c) = self.center_of_mass {
            at.finite("center_of_mass", &[c.x, c.y])?;
        }
        match self.start {
            None => {}
            Some(PartPosition::Planar(c)) => {
                at.finite("start", &[c.x, c.y, c.theta])?;
                at.moves_as("start", entry.axis, true)?;
            }
            Some(PartPosition::Axis(u)) => {
                at.finite("start", &[u])?;
                at.moves_as("start", entry.axis, false)?;
                at.in_range("start", u, entry.axis)?;
            }
        }
        match self.rate {
            None => Ok(()),
            Some(PartVelocity::Planar { linear, angular }) => {
                at.finite("rate", &[linear.x, linear.y, angular])?;
                at.moves_as("rate", entry.axis, true)
            }
            Some(PartVelocity::Axis(u)) => {
                at.finite("rate", &[u])?;
                at.moves_as("rate", entry.axis, false)
            }
        }
    }
}

/// Two indices in ascending order.
fn ordered((a, b): (usize, usize)) -> (usize, usize) {
    (a.min(b), a.max(b))
}

impl PairSurface {
    /// Checks the entry; `listed` are the pairs of the mechanism, `known` those of previous entries.
    fn check(
        &self,
        listed: &HashSet<(usize, usize)>,
        known: &mut HashSet<(usize, usize)>,
    ) -> Checked {
        let at = At(DynamicsItem::Pair(self.parts.0, self.parts.1));
        let pair = ordered(self.parts);
        if !listed.contains(&pair) {
            return at.fails("pair", DynamicsFault::NoPair);
        }
        if !known.insert(pair) {
            return at.fails("pair", DynamicsFault::PairTwice);
        }
        if let Some(friction) = self.friction {
            at.not_negative("friction", friction)?;
        }
        match self.restitution {
            Some(restitution) => at.up_to_one("restitution", restitution),
            None => Ok(()),
        }
    }
}

impl Drive {
    fn check(&self, index: usize, before: &[Self], parts: &[PartEntry]) -> Checked {
        let at = At(DynamicsItem::Drive(index));
        at.known("part", self.part, parts.len())?;
        let axis = parts[self.part].axis;
        if axis.is_none() {
            return at.fails("part", DynamicsFault::MovesFreely);
        }
        at.moves_as("part", axis, false)?;
        if let Some(first) = before.iter().position(|d| d.part == self.part) {
            return at.fails("part", DynamicsFault::DrivenTwice { first });
        }
        let points = match &self.motion {
            DriveMotion::Rate(rate) => return at.finite("rate", &[*rate]),
            DriveMotion::Table(points) => points,
        };
        if points.len() < 2 {
            let points = points.len();
            return at.fails("table", DynamicsFault::ShortTable { points });
        }
        for &(time, u) in points {
            at.finite("table", &[time, u])?;
            at.in_range("table", u, axis)?;
        }
        for (i, pair) in points.windows(2).enumerate() {
            let (before, time) = (pair[0].0, pair[1].0);
            if time <= before {
                let fault = DynamicsFault::TimeOrder {
                    point: i + 1,
                    time,
                    before,
                };
                return at.fails("table", fault);
            }
        }
        Ok(())
    }
}

impl Load {
    fn check(&self, at: At, parts: &[PartEntry]) -> Checked {
        at.known("part", self.part, parts.len())?;
        match self.kind {
            LoadKind::Force { force, at: point } => {
                at.finite("force", &[force.x, force.y])?;
                if let Some(p) = point {
                    at.finite("at", &[p.x, p.y])?;
                }
            }
            LoadKind::Torque(torque) => at.finite("torque", &[torque])?,
        }
        if stands_still(parts[self.part].axis) {
            return at.fails("part", DynamicsFault::StandsStill);
        }
        Ok(())
    }
}

impl Spring {
    fn check(&self, at: At, parts: &[PartEntry]) -> Checked {
        at.known("parts", self.part, parts.len())?;
        if let Some(other) = self.other {
            at.known("parts", other, parts.len())?;
            if other == self.part {
                return at.fails("parts", DynamicsFault::OnePart);
            }
        }
        let stands = |part: usize| stands_still(parts[part].axis);
        if stands(self.part) && self.other.is_none_or(stands) {
            return at.fails("parts", DynamicsFault::StandsStill);
        }
        let (stiffness, damping) = match self.kind {
            SpringKind::Linear {
                at: (p, q),
                stiffness,
                length,
                damping,
            } => {
                at.finite("at", &[p.x, p.y, q.x, q.y])?;
                at.not_negative("length", length)?;
                (stiffness, damping)
            }
            SpringKind::Torsion {
                stiffness,
                angle,
                damping,
            } => {
                at.finite("angle", &[angle])?;
                (stiffness, damping)
            }
        };
        at.not_negative("stiffness", stiffness)?;
        at.not_negative("damping", damping)?;
        if stiffness == 0.0 && damping == 0.0 {
            return at.fails("stiffness", DynamicsFault::Idle);
        }
        Ok(())
    }
}
