//! How far one unit goes along an axis while all others stay.

use core::f64::consts::TAU;
use cspace::pair::PairMotion;
use cspace::{Axis, AxisMotion, Coordinates, PairSpace, Part, Relation, Vector};

use crate::legs::{Coords, Scene};
use crate::out::exits;

use super::answer::{Kind, Step};
use super::error::AssemblyError;
use super::units::{Set, Units, placed};
use super::way_out::{told, until_beside};

/// Straight ways to make room are tried in so many directions, those in which it is nearest to the outside first.
const DIRECTIONS: usize = 12;
/// A unit that comes nearer to a contact than so many gaps, at its farthest point, stops there.
const STOP: f64 = 1.0;
/// It has moved if its farthest point has gone by so many gaps.
const MOVED: f64 = 4.0;

/// A unit on an axis of its own or on a straight way, with where it gets to.
#[derive(Debug, Clone)]
pub(super) struct Travel {
    pub(super) unit: usize,
    /// Its parts where the coordinate of the axis is 0.
    part: Part,
    scene: Scene,
    axis: Axis,
    /// Whether it is a straight way of a unit that moves in the plane.
    is_planar: bool,
    pub(super) from: f64,
    /// The least and the largest coordinate without contact.
    pub(super) free: (f64, f64),
    /// The coordinate by which its farthest point moves by a gap.
    gap: f64,
}

impl Travel {
    /// All ways of a unit within a set.
    pub(super) fn all(units: &Units, set: Set, unit: usize) -> Result<Vec<Self>, AssemblyError> {
        let rest = units.together(set & !(1 << unit))?;
        if let Some(axis) = units.axes[unit] {
            let travel = Self::new(units, &rest, unit, axis, false)?;
            return Ok(travel.into_iter().collect());
        }
        if units.still >> unit & 1 == 1 {
            return Ok(Vec::new());
        }
        let part = units.together(1 << unit)?;
        let mut directions: Vec<Vector> = exits(&rest, &part, cspace::Configuration::default())
            .iter()
            .take(DIRECTIONS)
            .map(|e| e.direction)
            .collect();
        // Back to where it is drawn.
        let at = units.at[unit];
        if at.x != 0.0 || at.y != 0.0 {
            directions.push(Vector::new(-at.x, -at.y).unit());
        }
        let mut all = Vec::new();
        for direction in directions {
            let far = until_beside(&rest, &part, direction).max(0.0);
            let axis = Axis::prismatic(direction).within(0.0, far);
            all.extend(Self::new(units, &rest, unit, axis, true)?);
        }
        Ok(all)
    }

    /// One way; none if there is hardly any room.
    fn new(
        units: &Units,
        rest: &Part,
        unit: usize,
        axis: Axis,
        is_planar: bool,
    ) -> Result<Option<Self>, AssemblyError> {
        let (part, from) = match is_planar {
            true => (units.together(1 << unit)?, 0.0),
            false => (units.as_drawn(unit)?, units.coordinates[unit]),
        };
        // A part that turns or slides for ever has gone everywhere after a turn, or beside the others.
        let whole = match axis.motion {
            AxisMotion::Prismatic { direction } => {
                let there = units.together(1 << unit)?;
                (
                    until_beside(rest, &there, -direction).max(0.0),
                    until_beside(rest, &there, direction).max(0.0),
                )
            }
            _ => (TAU, TAU),
        };
        let (lo, hi) = axis.range.unwrap_or((from - whole.0, from + whole.1));
        if !(lo..=hi).contains(&from) {
            return Ok(None);
        }
        let axis = axis.within(lo, hi);
        let scene = Scene::new(rest, &part, Some((Axis::FIXED, axis)));
        let gap = units.gap / scene.levers()[1].max(f64::MIN_POSITIVE);
        let relation = Relation::Axes {
            fixed: Axis::FIXED,
            moving: axis,
        };
        let space = PairSpace::compute(rest, &part, relation, &cspace::Options::default())?;
        let at = |v: f64| Coordinates::Axes { u: 0.0, v };
        let reach = |rate: f64, end: f64| -> Result<f64, AssemblyError> {
            let duration = (end - from).abs();
            let far = match space.first_contact(at(from), at(rate), duration)? {
                PairMotion::Free | PairMotion::Leaves { .. } => end,
                PairMotion::Contact(contact) => from + rate * (contact.time - STOP * gap).max(0.0),
            };
            let is_free = scene.is_apart([0.0, from, 0.0], [0.0, far, 0.0], 0.0);
            Ok(if is_free { far } else { from })
        };
        let free = (reach(-1.0, lo)?, reach(1.0, hi)?);
        let travel = Self {
            unit,
            part,
            scene,
            axis,
            is_planar,
            from,
            free,
            gap,
        };
        let has_room = [free.0, free.1].iter().any(|&to| travel.moves(to));
        Ok(has_room.then_some(travel))
    }

    /// Recomputes this travel after other units have moved.
    pub(super) fn again(&self, units: &Units, set: Set) -> Result<Option<Self>, AssemblyError> {
        let rest = units.together(set & !(1 << self.unit))?;
        Self::new(units, &rest, self.unit, self.axis, self.is_planar)
    }

    /// Whether it is elsewhere at a coordinate.
    pub(super) fn moves(&self, to: f64) -> bool {
        self.differ(to, self.from)
    }

    /// A little on.
    pub(super) fn beyond(&self, to: f64) -> f64 {
        let by = STOP * self.gap;
        (to + if to < self.from { -by } else { by }).clamp(self.free.0, self.free.1)
    }

    /// Whether two coordinates are different places.
    pub(super) fn differ(&self, a: f64, b: f64) -> bool {
        (a - b).abs() > MOVED * self.gap
    }

    /// The unit's parts at a coordinate.
    pub(super) fn part_at(&self, to: f64) -> Result<Part, AssemblyError> {
        placed(&self.part, self.axis.configuration(to))
    }

    /// The units with this one at a coordinate.
    pub(super) fn to(&self, units: &Units, to: f64) -> Result<Units, AssemblyError> {
        if self.is_planar {
            let by = self.axis.configuration(to);
            return units.moved(self.unit, by.compose(units.at[self.unit]));
        }
        units.moved_on(self.unit, self.axis, to)
    }

    /// The step to a coordinate.
    pub(super) fn step(&self, units: &Units, set: Set, to: f64) -> Step {
        let places: [Coords; 2] = [[0.0, self.from, 0.0], [0.0, to, 0.0]];
        let mut path = told(&self.scene, places.to_vec());
        if self.is_planar {
            let planar = |at: &mut Coordinates| {
                if let Coordinates::Axes { v, .. } = *at {
                    *at = Coordinates::Planar(self.axis.configuration(v));
                }
            };
            path.configurations.iter_mut().for_each(planar);
            planar(&mut path.narrowest.at);
        }
        Step {
            kind: Kind::Moves,
            moving: units.parts_of(1 << self.unit),
            staying: units.parts_of(set & !(1 << self.unit)),
            path,
            onward: Vector::ZERO,
        }
    }
}
