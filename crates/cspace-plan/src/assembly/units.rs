//! What moves as one.

use cspace::{AxisMotion, Mechanism, Part, pair::Joint};

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
const GAP: f64 = 1e-6;
/// The least gap and the largest, as shares of the size.
const GAPS: (f64, f64) = (1e-8, 1e-2);
/// What must be left of the gap between two parts: parts that overlap by nearly all of it are refused.
const LEFT: f64 = 1.0 / 64.0;

/// Parts with the gap opened, as they move.
#[derive(Debug, Clone)]
pub(super) struct Units {
    pub(super) parts: Vec<Part>,
    /// The parts of each unit.
    pub(super) of: Vec<Vec<usize>>,
    /// The unit that does not move, if there is one.
    pub(super) ground: Option<usize>,
    /// Whether parts could move that are not moved: those on axes, and joints that are not rigid.
    pub(super) is_simplified: bool,
    pub(super) gap: f64,
}

impl Units {
    pub(super) fn new(mechanism: &Mechanism, gap: Option<f64>) -> Result<Self, AssemblyError> {
        mechanism.check()?;
        let n = mechanism.parts.len();
        let is_held = |i: usize| mechanism.parts[i].axis.is_some();
        let mut root: Vec<usize> = (0..n).collect();
        let mut join = |a: usize, b: usize| {
            let (a, b) = (root[a].min(root[b]), root[a].max(root[b]));
            for r in &mut root {
                if *r == b {
                    *r = a;
                }
            }
        };
        let first = (0..n).find(|&i| is_held(i));
        for i in (0..n).filter(|&i| is_held(i)) {
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
        if of.len() < 2 {
            return Err(AssemblyError::Nothing);
        }
        if of.len() > MOST {
            return Err(AssemblyError::TooMany {
                units: of.len(),
                most: MOST,
            });
        }
        let on_axis = |i: usize| {
            mechanism.parts[i]
                .axis
                .is_some_and(|a| a.motion != AxisMotion::Fixed)
        };
        let flexible = |j: &cspace::JointEntry| !matches!(j.joint, Joint::Rigid);
        let mut units = Self {
            parts: Vec::new(),
            ground: first.map(|f| roots.partition_point(|&r| r < root[f])),
            of,
            is_simplified: (0..n).any(on_axis) || mechanism.joints.iter().any(flexible),
            gap: 0.0,
        };
        let drawn: Vec<&Part> = mechanism.parts.iter().map(|p| &p.part).collect();
        units.open(&drawn, gap)?;
        Ok(units)
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
            self.parts
                .push(smaller.ok_or_else(|| AssemblyError::TooSmall {
                    part: part.name().to_owned(),
                    gap,
                })?);
        }
        for (i, a) in self.parts.iter().enumerate() {
            for (j, b) in self.parts.iter().enumerate().skip(i + 1) {
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
        let parts = self.parts_of(set);
        let names: Vec<&str> = parts.iter().map(|&i| self.parts[i].name()).collect();
        let loops = (parts.iter())
            .flat_map(|&i| self.parts[i].loops())
            .map(|l| l.vertices().to_vec())
            .collect();
        Ok(Part::new(names.join("+"), loops)?)
    }

    /// Which part's feature one of the parts together is.
    pub(super) fn drawn(&self, set: Set, mut feature: cspace::FeatureName) -> PartFeature {
        let mut part = 0;
        for i in self.parts_of(set) {
            let loops = self.parts[i].loops().len() as u32;
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

    /// The unit that does not move.
    pub(super) fn still(&self) -> Set {
        self.ground.map_or(0, |g| 1 << g)
    }
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
