//! All coordinates of a mechanism, and which of them are free.

use cspace::{AreaMoments, AxisMotion, Configuration, Placement, Point, Real, Rotation};
use cspace_model::{JointEntry, MassProperties, Mechanism, PartPosition, PartVelocity, SpringKind};

use super::joint;
use super::layout::{PartCoordinates, Placed, reach, rows_of};
use super::metric::Metric;
use super::row::Row;
use crate::drive::DriveCurve;
use crate::error::SimulateError;

/// A mechanism as a system of coordinates.
///
/// Parts that turn or slide have one coordinate, parts that move in the plane have three, x, y and θ; they follow each other
/// in the order of the parts. Coordinates of driven parts are known functions of time, the others are free.
#[derive(Debug, Clone)]
pub struct System {
    pub(super) mechanism: Mechanism,
    pub(super) parts: Vec<PartCoordinates>,
    pub(super) moments: Vec<AreaMoments>,
    masses: Vec<Option<MassProperties>>,
    /// Centres of mass in the parts' frames.
    centers: Vec<Point>,
    count: usize,
    /// The prescribed coordinates.
    pub(super) drives: Vec<(usize, DriveCurve)>,
    pub(super) free: Vec<usize>,
    /// Parts with a brake.
    pub(super) braked: Vec<usize>,
    /// Joints that are not already what the parts' own axes say.
    joints: Vec<JointEntry>,
    size: f64,
    lengths: Vec<f64>,
    /// Largest displacement of a part's points per unit of each of its coordinates.
    pub(super) levers: Vec<[f64; 3]>,
    /// The largest distance of each part's points from its origin.
    reaches: Vec<f64>,
    pub(super) law: Law,
    /// The metric, if it is the same everywhere.
    pub(super) metric: Option<Metric>,
}

/// Springs settle in no less than this, in units of the time in which forces move parts by the mechanism's size.
const DRAG: f64 = 0.1;

/// Law by which forces act on a motion without inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Law {
    /// Forces are speeds, M v = s F, so that parts come to rest.
    Speeds {
        /// The factor s.
        scale: f64,
        /// Drag of springs per stiffness, as a multiple of s, so that stiff springs do not make the motion take long.
        drag: f64,
    },
    /// Forces balance at every instant.
    Balance,
}

impl System {
    /// The system of a mechanism that has been [checked](Mechanism::check).
    pub fn new(mechanism: &Mechanism) -> Self {
        Self::about(mechanism, |_| Point::ORIGIN)
    }

    /// As above, with the centres of mass as the points of parts that move in the plane: their part of the mass matrix
    /// then contains only masses and inertias.
    pub(crate) fn about_masses(mechanism: &Mechanism) -> Self {
        let of = |i: usize| {
            let entry = &mechanism.parts[i].part;
            mechanism.dynamics.part(i).center_of_mass(entry)
        };
        Self::about(mechanism, of)
    }

    fn about(mechanism: &Mechanism, center: impl Fn(usize) -> Point) -> Self {
        let mut count = 0;
        let parts: Vec<PartCoordinates> = (mechanism.parts.iter().enumerate())
            .map(|(i, entry)| {
                let first = count;
                let (coordinates, more) = match entry.axis {
                    None => {
                        let center = center(i);
                        (PartCoordinates::Planar { first, center }, 3)
                    }
                    Some(axis) if axis.motion == AxisMotion::Fixed => (PartCoordinates::Fixed, 0),
                    Some(axis) => {
                        let (motion, range) = (axis.motion, axis.range);
                        let on = PartCoordinates::Axis {
                            first,
                            motion,
                            range,
                        };
                        (on, 1)
                    }
                };
                count += more;
                coordinates
            })
            .collect();
        let drives: Vec<(usize, DriveCurve)> = (mechanism.dynamics.drives.iter())
            .filter_map(|drive| {
                let start = match mechanism.dynamics.part(drive.part).start {
                    Some(PartPosition::Axis(u)) => u,
                    _ => 0.0,
                };
                let curve = DriveCurve::new(drive, start);
                Some((parts[drive.part].indices().next()?, curve))
            })
            .collect();
        let free = (0..count)
            .filter(|i| drives.iter().all(|d| d.0 != *i))
            .collect();
        // A brake is a damper without stiffness between the ground and a part on an axis that is not driven.
        let brakes = (mechanism.dynamics.springs.iter()).filter(|spring| {
            let (SpringKind::Linear {
                stiffness, damping, ..
            }
            | SpringKind::Torsion {
                stiffness, damping, ..
            }) = spring.kind;
            spring.other.is_none() && stiffness == 0.0 && damping > 0.0
        });
        let is_free = |part: &usize| match parts[*part] {
            PartCoordinates::Axis { first, .. } => drives.iter().all(|d| d.0 != first),
            _ => false,
        };
        let mut braked: Vec<usize> = brakes.map(|spring| spring.part).filter(is_free).collect();
        braked.sort_unstable();
        braked.dedup();
        // A joint with the ground of a part that has an axis is that axis.
        let tells = |j: &&JointEntry| {
            let is = |i: usize| parts[i];
            let (a, b) = (is(j.parts.0), is(j.parts.1));
            let planar = |p| matches!(p, PartCoordinates::Planar { .. });
            let fixed = |p| p == PartCoordinates::Fixed;
            planar(a) || planar(b) || !(fixed(a) || fixed(b))
        };
        let sizes = mechanism.parts.iter().map(|p| p.part.size());
        let mut lengths = vec![1.0; count];
        for (part, entry) in parts.iter().zip(&mechanism.parts) {
            if let Some(i) = part.orientation() {
                lengths[i] = entry.part.size();
            }
        }
        let entries = &mechanism.parts;
        let system = Self {
            lengths,
            metric: None,
            levers: (parts.iter().zip(entries))
                .map(|(c, entry)| c.levers(&entry.part))
                .collect(),
            reaches: (entries.iter())
                .map(|entry| reach(&entry.part, Point::ORIGIN))
                .collect(),
            law: Law::Speeds {
                scale: 1.0,
                drag: 0.0,
            },
            joints: mechanism.joints.iter().filter(tells).copied().collect(),
            moments: (mechanism.parts.iter()).map(|p| p.part.moments()).collect(),
            masses: (0..mechanism.parts.len())
                .map(|i| mechanism.mass_properties(i))
                .collect(),
            centers: (mechanism.parts.iter().enumerate())
                .map(|(i, p)| mechanism.dynamics.part(i).center_of_mass(&p.part))
                .collect(),
            size: sizes.fold(0.0, f64::max),
            mechanism: mechanism.clone(),
            parts,
            count,
            drives,
            free,
            braked,
        };
        system.with_metric()
    }

    /// Copy of the system with forces that balance at every instant, as under slow drives.
    pub(crate) fn balanced(&self) -> Self {
        let system = Self {
            law: Law::Balance,
            ..self.clone()
        };
        system.with_metric()
    }

    /// Copy of the system with drives that stand where they are at a time, and forces that are speeds by a factor.
    pub(crate) fn settling(&self, time: f64, scale: f64) -> Self {
        let still = |(i, curve): &(usize, DriveCurve)| (*i, curve.still(time));
        let system = Self {
            law: Law::Speeds {
                scale,
                drag: DRAG * scale,
            },
            drives: self.drives.iter().map(still).collect(),
            ..self.clone()
        };
        system.with_metric()
    }

    pub(crate) fn law(&self) -> Law {
        self.law
    }

    /// The parts with a brake: a damper without stiffness between the ground and a part on an axis that is not driven.
    pub(crate) fn braked(&self) -> &[usize] {
        &self.braked
    }

    /// The mechanism.
    pub fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// The coordinates of each part.
    pub fn parts(&self) -> &[PartCoordinates] {
        &self.parts
    }

    /// Number of coordinates.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The indices of the coordinates that are not prescribed.
    pub fn free(&self) -> &[usize] {
        &self.free
    }

    /// The prescribed coordinates, each with its motion.
    pub fn drives(&self) -> &[(usize, DriveCurve)] {
        &self.drives
    }

    /// The size of the largest part, in the model's unit of length.
    pub fn size(&self) -> f64 {
        self.size
    }

    /// The length that a unit of each coordinate counts: the size of the part for an angle, 1 for a length.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Largest displacement of each part's points per unit of each of its coordinates.
    pub(crate) fn levers(&self) -> &[[f64; 3]] {
        &self.levers
    }

    /// The largest distance of a part's points from its origin.
    pub(crate) fn reach(&self, part: usize) -> f64 {
        self.reaches[part]
    }

    /// Coordinates at the start, as given. Joints may not hold there.
    pub fn start(&self) -> Vec<f64> {
        let mut q = vec![0.0; self.count];
        for (i, part) in self.parts.iter().enumerate() {
            let indices = part.indices();
            match self.mechanism.dynamics.part(i).start {
                Some(PartPosition::Axis(u)) if indices.len() == 1 => q[indices.start] = u,
                Some(PartPosition::Planar(c)) if indices.len() == 3 => {
                    q[indices].copy_from_slice(&[c.x, c.y, c.theta]);
                }
                _ => {}
            }
        }
        self.drive(0.0, &mut q);
        q
    }

    /// Flags of the coordinates that are given at the start, by the model or by drives.
    pub(crate) fn given(&self) -> Vec<bool> {
        let mut given = vec![false; self.count];
        for (i, part) in self.parts.iter().enumerate() {
            if self.mechanism.dynamics.part(i).start.is_some() {
                given[part.indices()].fill(true);
            }
        }
        for (i, _) in &self.drives {
            given[*i] = true;
        }
        given
    }

    /// The rates at the start, as they are given: of the coordinates of [`start`](Self::start).
    pub(crate) fn start_rates(&self) -> Vec<f64> {
        let mut v = vec![0.0; self.count];
        for (i, part) in self.parts.iter().enumerate() {
            let indices = part.indices();
            match self.mechanism.dynamics.part(i).rate {
                Some(PartVelocity::Axis(u)) if indices.len() == 1 => v[indices.start] = u,
                Some(PartVelocity::Planar { linear, angular }) if indices.len() == 3 => {
                    v[indices].copy_from_slice(&[linear.x, linear.y, angular]);
                }
                _ => {}
            }
        }
        v
    }

    /// Converts coordinates and rates between the origins of the parts' frames and the parts' reference points; `back`
    /// chooses the direction.
    pub(crate) fn shift(&self, q: &mut [f64], v: &mut [f64], back: bool) {
        for part in &self.parts {
            if let PartCoordinates::Planar { first, center } = *part {
                let sign = if back { -1.0 } else { 1.0 };
                let arm = Rotation::by(q[first + 2]) * center.to_vector() * sign;
                q[first] += arm.x;
                q[first + 1] += arm.y;
                let turning = arm.left() * v[first + 2];
                v[first] += turning.x;
                v[first + 1] += turning.y;
            }
        }
    }

    /// The joints between parts that move.
    pub(crate) fn joint_entries(&self) -> &[JointEntry] {
        &self.joints
    }

    /// The moments of the outline of a part.
    pub(crate) fn moments(&self, part: usize) -> &AreaMoments {
        &self.moments[part]
    }

    /// The mass of a part, where it is and how it is spread.
    pub(crate) fn mass(&self, part: usize) -> Option<&MassProperties> {
        self.masses[part].as_ref()
    }

    /// The centre of mass of a part in its frame, or of its outline.
    pub(crate) fn center(&self, part: usize) -> Point {
        self.centers[part]
    }

    /// Brings the prescribed coordinates to where they are at a time.
    pub fn drive(&self, time: f64, q: &mut [f64]) {
        for (i, curve) in &self.drives {
            q[*i] = curve.at(time).value;
        }
    }

    /// Placement of a part in the assembly's frame.
    pub fn placement(&self, part: usize, q: &[f64]) -> Placement<f64> {
        self.parts[part].placement(|i| q[i])
    }

    /// Configuration of a part in another's frame, with its orientation not reduced by full turns.
    pub fn relative(&self, fixed: usize, moving: usize, q: &[f64]) -> Configuration {
        let [a, b] = [fixed, moving].map(|i| self.placement(i, q));
        let [x, y] = a.inverse().compose(&b).position;
        let turned = |i: usize| self.parts[i].orientation().map_or(0.0, |k| q[k]);
        Configuration::new(x, y, turned(moving) - turned(fixed))
    }

    /// A function of where two parts are, with its derivatives by their coordinates.
    pub(crate) fn row(&self, [a, b]: [usize; 2], q: &[f64], function: &impl Placed<1>) -> Row {
        let [row] = rows_of([&self.parts[a], &self.parts[b]], q, function);
        row
    }

    /// A joint between two parts that move.
    pub(super) fn joint(&self, k: usize) -> &JointEntry {
        &self.joints[k]
    }

    pub(super) fn joint_count(&self) -> usize {
        self.joints.len()
    }

    /// The equations of all joints: 0 where they hold, in the model's unit of length.
    pub fn joints<T: Real>(&self, q: &[T]) -> Vec<Row<T>> {
        (self.joints.iter())
            .flat_map(|entry| self.equations_of(entry, q))
            .collect()
    }

    /// The equations of some joints, by their numbers.
    pub(crate) fn joints_of<T: Real>(&self, joints: &[usize], q: &[T]) -> Vec<Row<T>> {
        let entries = joints.iter().filter_map(|&k| self.joints.get(k));
        entries
            .flat_map(|entry| self.equations_of(entry, q))
            .collect()
    }

    fn equations_of<T: Real>(&self, entry: &JointEntry, q: &[T]) -> Vec<Row<T>> {
        let (a, b) = entry.parts;
        let parts = [&self.parts[a], &self.parts[b]];
        joint::equations(&entry.joint, parts, q, self.size)
    }

    /// Error that reports the joint with the largest gap at a configuration.
    pub(crate) fn open_joint(&self, q: &[f64]) -> SimulateError {
        let name = |i: usize| self.mechanism.parts[i].part.name().to_owned();
        let gaps = self.joints.iter().map(|entry| {
            let (a, b) = entry.parts;
            let parts = [&self.parts[a], &self.parts[b]];
            let rows = joint::equations(&entry.joint, parts, q, self.size);
            let gap = rows.iter().fold(0.0_f64, |m, r| m.max(r.value.abs()));
            (gap, a, b)
        });
        let worst = gaps.max_by(|a, b| a.0.total_cmp(&b.0));
        let (gap, a, b) = worst.unwrap_or((0.0, 0, 0));
        SimulateError::Joints {
            part: name(a),
            other: name(b),
            gap,
        }
    }

    /// The largest rate, angles counted by the sizes of their parts.
    pub(crate) fn speed(&self, rates: &[f64]) -> f64 {
        let each = rates.iter().zip(&self.lengths);
        each.map(|(r, l)| (r * l).abs()).fold(0.0, f64::max)
    }

    /// The largest change of a coordinate, angles counted by the sizes of their parts.
    pub(crate) fn moved(&self, from: &[f64], to: &[f64]) -> f64 {
        let each = from.iter().zip(to).zip(&self.lengths);
        each.map(|((a, b), l)| ((a - b) * l).abs())
            .fold(0.0, f64::max)
    }
}
