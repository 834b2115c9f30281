//! Joints between parts that move as constraints on rates.

use cspace::pair::Joint;
use cspace::{Placement, Point, Real};

use crate::system::{PartCoordinates, System};

use super::bodies::{All, Posed};
use super::rates::{InTime, Rates, still};

/// A constraint: its value, which is 0 where it holds, and how that changes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constraint {
    pub(super) value: f64,
    pub(super) rates: Rates,
}

/// Constraints of all joints, in their order: the distances of a point of the first part from that of the second,
/// across the directions in which they are free, and last the difference of the parts' orientations, times the size.
pub(super) fn constraints(system: &System, posed: &Posed) -> Vec<Constraint> {
    let mut found = Vec::new();
    for entry in system.joint_entries() {
        let (a, b) = entry.parts;
        let joined = Joined {
            parts: [system.parts()[a], system.parts()[b]],
            placed: [posed.parts[a], posed.parts[b]],
            all: &posed.all,
        };
        let (x, y) = ([still(1.0), still(0.0)], [still(0.0), still(1.0)]);
        match entry.joint {
            Joint::Revolute { at } => found.extend([x, y].map(|d| joined.together(at, d, false))),
            Joint::Rigid => {
                found.extend([x, y].map(|d| joined.together(Point::ORIGIN, d, false)));
                found.push(joined.parallel(system.size()));
            }
            Joint::Prismatic { direction, at } => {
                let n = direction.unit().left();
                let normal = joined.placed[0].vector([still(n.x), still(n.y)]);
                found.push(joined.together(at, normal, true));
                found.push(joined.parallel(system.size()));
            }
        }
    }
    found
}

struct Joined<'a> {
    parts: [PartCoordinates; 2],
    placed: [Placement<InTime>; 2],
    all: &'a All,
}

impl Joined<'_> {
    /// Distance of the first part's point beyond the second's along a direction d, which turns with the first part or
    /// stands still.
    ///
    /// With d fixed to the first part, (d · (p₁ − p₂))˙ is the velocity of the first part's point at p₂ less the second's.
    fn together(&self, at: Point, d: [InTime; 2], turns: bool) -> Constraint {
        let [p, r] = [0, 1].map(|k| self.placed[k].point([still(at.x), still(at.y)]));
        let mut rates = Rates::none();
        let All { q, v, .. } = self.all;
        let on_first = if turns { r } else { p };
        rates.add_point(&self.parts[0], q, v, on_first, d);
        rates.add_point(&self.parts[1], q, v, r, [-d[0], -d[1]]);
        Constraint {
            value: (d[0] * (p[0] - r[0]) + d[1] * (p[1] - r[1])).value(),
            rates,
        }
    }

    /// size · sin(θ₂ − θ₁).
    fn parallel(&self, size: f64) -> Constraint {
        let [a, b] = &self.placed;
        let by = still(size) * (a.cos * b.cos + a.sin * b.sin);
        let mut rates = Rates::none();
        if let Some(i) = self.parts[1].orientation() {
            rates.add(i, by);
        }
        if let Some(i) = self.parts[0].orientation() {
            rates.add(i, -by);
        }
        Constraint {
            value: size * (a.cos * b.sin - a.sin * b.cos).value(),
            rates,
        }
    }
}
