//! Units: parts that move as one.

use cspace::part::{Heights, tolerance::MAX_LAYERS};
use cspace::{Axis, AxisMotion, Configuration, Part, Vertex};
use cspace_model::Mechanism;

use crate::clash::depth;
use crate::legs::Scene;

use super::answer::PartFeature;
use super::error::AssemblyError;
use super::inset::inset;

/// A set of units, by bits.
pub(super) type Set = u64;
/// So many units fit into a set.
pub(super) const MOST: usize = 63;

/// The gap that is opened unless another is given, as a share of the assembly's size: far above the least clearance of contact
/// spaces (5·10⁻¹⁰), far below what matters in a drawing.
pub(crate) const GAP: f64 = 1e-6;
/// The least gap and the largest, as shares of the size.
const GAPS: (f64, f64) = (1e-8, 1e-2);
/// Share of the gap between two parts that must be left: parts that overlap by nearly all of it are refused.
const LEFT: f64 = 1.0 / 64.0;

/// Parts with the gap opened, as they move and where they are.
#[derive(Debug, Clone)]
pub(super) struct Units {
    /// The parts as drawn.
    pub(super) drawn: Vec<Part>,
    /// The parts where they have come to.
    pub(super) here: Vec<Part>,
    /// The parts of each unit.
    pub(super) of: Vec<Vec<usize>>,
    /// The axes of the units that move on one.
    pub(super) axes: Vec<Option<Axis>>,
    /// Where each unit is to where it is drawn.
    pub(super) at: Vec<Configuration>,
    /// The coordinate of each unit on an axis.
    pub(super) coordinates: Vec<f64>,
    /// The units that never go out: what does not move, and parts on axes.
    pub(super) still: Set,
    /// The units that are rigid bodies: none of their joints could move, and no part of them on an axis that is held.
    pub(super) rigid: Set,
    pub(super) gap: f64,
}

impl Units {
    pub(super) fn new(mechanism: &Mechanism, gap: Option<f64>) -> Result<Self, AssemblyError> {
        mechanism.check()?;
        let n = mechanism.parts.len();
        let axis = |i: usize| mechanism.parts[i].axis;
        let is_joined =
            |i: usize| (mechanism.joints.iter()).any(|j| [j.parts.0, j.parts.1].contains(&i));
        // A part on an axis that is joined to others is held where it is drawn.
        let moves = |i: usize| axis(i).filter(|a| a.motion != AxisMotion::Fixed && !is_joined(i));
        let is_ground = |i: usize| axis(i).is_some() && moves(i).is_none();
        let mut root: Vec<usize> = (0..n).collect();
        let mut join = |a: usize, b: usize| {
            let (a, b) = (root[a].min(root[b]), root[a].max(root[b]));
            for r in &mut root {
                if *r == b {
                    *r = a;
                }
            }
        };
        let first = (0..n).find(|&i| is_ground(i));
        for i in (0..n).filter(|&i| is_ground(i)) {
            join(first.unwrap_or(i), i);
        }
        for joint in &mechanism.joints {
            join(joint.parts.0, joint.parts.1);
        }
        let mut roots = root.clone();
        roots.sort_unstable();
        roots.dedup();
        let of: Vec<Vec<usize>> = (roots.iter())
            .map(|&r| (0..n).filter(|&i| root[i] == r).collect())
            .collect();
        if of.len() > MOST {
            return Err(AssemblyError::TooMany {
                units: of.len(),
                most: MOST,
            });
        }
        let set = |is_in: &dyn Fn(&[usize]) -> bool| -> Set {
            (of.iter().enumerate())
                .filter(|(_, parts)| is_in(parts))
                .fold(0, |all, (u, _)| all | 1 << u)
        };
        let still = set(&|parts| parts.iter().any(|&i| axis(i).is_some()));
        if of.len() < 2 || still.count_ones() as usize == of.len() {
            return Err(AssemblyError::Nothing);
        }
        let rigid = set(&|parts| {
            let is_held = |&i: &usize| {
                axis(i).is_some_and(|a| a.motion != AxisMotion::Fixed) && moves(i).is_none()
            };
            !parts.iter().any(|&i| is_joined(i) || is_held(&i))
        });
        let count = of.len();
        let mut units = Self {
            drawn: Vec::new(),
            here: Vec::new(),
            axes: of
                .iter()
                .map(|parts| parts.first().and_then(|&i| moves(i)))
                .collect(),
            of,
            at: vec![Configuration::default(); count],
            coordinates: vec![0.0; count],
            still,
            rigid,
            gap: 0.0,
        };
        let drawn: Vec<&Part> = mechanism.parts.iter().map(|p| &p.part).collect();
        units.open(&drawn, gap)?;
        Ok(units)
    }

    /// A copy with one unit moved to another configuration, relative to where it is drawn.
    pub(super) fn moved(&self, unit: usize, at: Configuration) -> Result<Self, AssemblyError> {
        let mut moved = self.clone();
        moved.at[unit] = at;
        for &i in &self.of[unit] {
            moved.here[i] = placed(&self.drawn[i], at)?;
        }
        Ok(moved)
    }

    /// A copy with one unit moved to another coordinate on its axis.
    pub(super) fn moved_on(&self, unit: usize, axis: Axis, to: f64) -> Result<Self, AssemblyError> {
        let mut moved = self.moved(unit, axis.configuration(to))?;
        moved.coordinates[unit] = to;
        Ok(moved)
    }

    /// The axes of the parts that move on one.
    pub(super) fn part_axes(&self) -> Vec<Option<Axis>> {
        let mut axes = vec![None; self.drawn.len()];
        for (parts, &axis) in self.of.iter().zip(&self.axes) {
            for &i in parts {
                axes[i] = axis;
            }
        }
        axes
    }

    /// The size of all parts as they are drawn together.
    pub(super) fn reach(&self) -> f64 {
        extent(self.drawn.iter())
    }

    /// A unit's parts as drawn, as one.
    pub(super) fn as_drawn(&self, unit: usize) -> Result<Part, AssemblyError> {
        together(&self.drawn, &self.of[unit])
    }

    /// Opens the gap between all parts.
    fn open(&mut self, drawn: &[&Part], gap: Option<f64>) -> Result<(), AssemblyError> {
        let size = extent(drawn.iter().copied());
        let gap = gap.unwrap_or(GAP * size);
        let (least, most) = (GAPS.0 * size, GAPS.1 * size);
        if !(least..=most).contains(&gap) {
            return Err(AssemblyError::Gap { gap, least, most });
        }
        self.gap = gap;
        for part in drawn {
            let smaller = inset(part, 0.5 * gap).ok().flatten();
            self.drawn
                .push(smaller.ok_or_else(|| AssemblyError::TooSmall {
                    part: part.name().to_owned(),
                    gap,
                })?);
        }
        self.here.clone_from(&self.drawn);
        for (i, a) in self.here.iter().enumerate() {
            for (j, b) in self.here.iter().enumerate().skip(i + 1) {
                let scene = Scene::new(a, b, None);
                if scene.overlaps([0.0; 3]) || scene.clearance([0.0; 3]) < LEFT * gap {
                    return Err(AssemblyError::Overlap {
                        first: a.name().to_owned(),
                        second: b.name().to_owned(),
                        depth: depth(drawn[i], drawn[j]),
                        gap,
                    });
                }
            }
        }
        Ok(())
    }

    /// The parts of a set of units, in order.
    pub(super) fn parts_of(&self, set: Set) -> Vec<usize> {
        let mut parts: Vec<usize> = members(set).flat_map(|u| self.of[u].clone()).collect();
        parts.sort_unstable();
        parts
    }

    /// All parts of a set as one.
    pub(super) fn together(&self, set: Set) -> Result<Part, AssemblyError> {
        together(&self.here, &self.parts_of(set))
    }

    /// Which part's feature one of the parts together is.
    pub(super) fn drawn(&self, set: Set, mut feature: cspace::FeatureName) -> PartFeature {
        let mut part = 0;
        for i in self.parts_of(set) {
            let loops = self.here[i].loops().len() as u32;
            part = i;
            if feature.loop_index < loops {
                break;
            }
            feature.loop_index -= loops;
        }
        PartFeature { part, feature }
    }

    /// All units.
    pub(super) fn all(&self) -> Set {
        (1 << self.of.len()) - 1
    }
}

/// Some parts as one.
pub(super) fn together(parts: &[Part], these: &[usize]) -> Result<Part, AssemblyError> {
    let names: Vec<&str> = these.iter().map(|&i| parts[i].name()).collect();
    let mut layers: Vec<(Heights, Vec<Vec<Vertex>>)> = Vec::new();
    for part in these.iter().map(|&i| &parts[i]) {
        for (i, layer) in part.layers().iter().enumerate() {
            let loops = part.outline(layer);
            match layers.last_mut() {
                // Layers of one part may cross, and stay apart.
                Some((z, of)) if i == 0 && *z == layer.z() => of.extend(loops),
                _ => layers.push((layer.z(), loops)),
            }
        }
    }
    if layers.len() > MAX_LAYERS {
        return Err(AssemblyError::TooManyLayers {
            parts: names.join(", "),
            count: layers.len(),
            most: MAX_LAYERS,
        });
    }
    Ok(Part::layered(names.join("+"), layers)?)
}

/// A part elsewhere, its loops and vertices numbered as before.
pub(super) fn placed(part: &Part, at: Configuration) -> Result<Part, AssemblyError> {
    let moved = |v: &Vertex| {
        let p = at.fixed_from_moving(v.point());
        Vertex::new(p.x, p.y, v.bulge)
    };
    let loops = (part.loops().iter())
        .map(|l| l.vertices().iter().map(moved).collect())
        .collect();
    Ok(part.redrawn(loops)?)
}

/// The units of a set.
pub(super) fn members(set: Set) -> impl Iterator<Item = usize> {
    (0..MOST).filter(move |u| set >> u & 1 == 1)
}

/// The diagonal of the box around parts.
fn extent<'a>(parts: impl Iterator<Item = &'a Part>) -> f64 {
    let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for part in parts {
        let b = part.bounds();
        min = [min[0].min(b.min.x), min[1].min(b.min.y)];
        max = [max[0].max(b.max.x), max[1].max(b.max.y)];
    }
    (max[0] - min[0]).hypot(max[1] - min[1])
}
