//! Elements of a mechanism: parts, joints and pairs.

use cspace::fixed_axes::Axis;
use cspace::geometry::{Point, Vector};
use cspace::pair::Joint;
use cspace::part::Part;
use serde::{Deserialize, Serialize};

use super::dynamics::Dynamics;

/// A mechanism: parts, their motions, joints, and the pairs to study.
///
/// Lengths are in one unit, angles in radians. All parts are drawn in the assembly's frame, as they are at zero motion.
///
/// ```
/// use cspace::{Options, PairClass, Part};
/// use cspace_model::{Mechanism, PartEntry};
/// let mut mechanism = Mechanism::new("pin in a slot");
/// mechanism.parts.push(PartEntry::fixed(Part::rectangle("plate", (0.0, 0.0), 8.0, 8.0)?));
/// mechanism.parts.push(PartEntry::revolute(Part::circle("wheel", (7.0, 0.0), 2.0)?, (7.5, 0.0)));
/// mechanism.pairs = mechanism.every_two();
/// mechanism.check()?;
/// let pair = mechanism.pairs[0];
/// assert_eq!(mechanism.pair_class(&pair), PairClass::FixedAxes);
/// let space = mechanism.compute(&pair, &Options::default())?;
/// assert_eq!(space.moving().name(), "wheel");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Mechanism {
    /// Name of the mechanism.
    pub name: String,
    /// A label for the unit of length.
    pub unit: Option<String>,
    /// The parts. Joints and pairs refer to them by index.
    pub parts: Vec<PartEntry>,
    /// The permanent connections.
    pub joints: Vec<JointEntry>,
    /// The pairs to study.
    pub pairs: Vec<PairEntry>,
    /// First view.
    #[serde(default, skip_serializing_if = "Show::is_none")]
    pub show: Show,
    /// Masses, gravity, drives and other dynamic data. Configuration spaces do not depend on them.
    #[serde(default, skip_serializing_if = "Dynamics::is_none")]
    pub dynamics: Dynamics,
}

/// A part and its motion.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PartEntry {
    /// The outline, in the part's own frame, which is the assembly's frame at zero motion.
    pub part: Part,
    /// The axis of its motion relative to the ground; `None` if it moves freely in the plane.
    pub axis: Option<Axis>,
    /// The declared fold of a rotational symmetry about the part's own centre, if any; symmetry is detected in any case.
    pub symmetry: Option<u32>,
    /// The parts that it is made of, if it is a [body](Self::body); else none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<Member>,
}

/// One of the parts that a body is made of.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Member {
    /// Its name, which stands for the body.
    pub name: String,
    /// Number of its layers: those of the body are its members', in their order.
    pub layers: usize,
}

/// A permanent connection of two different parts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct JointEntry {
    /// Type of joint.
    pub joint: Joint,
    /// The two parts' indices.
    pub parts: (usize, usize),
}

/// Two different parts whose configuration space is requested.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PairEntry {
    /// Index of the part in whose frame configurations are expressed.
    pub fixed: usize,
    /// Index of the part that moves in that frame.
    pub moving: usize,
    /// The orientations of interest (lo, hi) in radians: lo < hi, at most a turn apart; `None` for all.
    pub window: Option<(f64, f64)>,
}

/// First view of a mechanism, and the question that it answers.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Show {
    /// The fixed and the moving part of one of its pairs, by index; `None` for one that has something to tell.
    pub pair: Option<(usize, usize)>,
    /// The question that the pair answers, in one line.
    pub question: Option<String>,
    /// Part of the view that is large; `None` for the parts.
    pub view: Option<View>,
}

/// Part of the view of a pair that is large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The parts.
    Parts,
    /// The slice of the space, or its plane.
    Slice,
    /// The surface of the space.
    Space,
}

impl Show {
    /// Whether it says nothing.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }
}

impl PartEntry {
    /// A part that moves freely in the plane.
    pub const fn planar(part: Part) -> Self {
        Self {
            part,
            axis: None,
            symmetry: None,
            members: Vec::new(),
        }
    }

    /// A part that does not move.
    pub const fn fixed(part: Part) -> Self {
        Self::on(part, Axis::FIXED)
    }

    /// A part that turns about a point, in assembly coordinates.
    pub fn revolute(part: Part, center: impl Into<Point>) -> Self {
        Self::on(part, Axis::revolute(center.into()))
    }

    /// A part that slides along a direction.
    pub fn prismatic(part: Part, direction: impl Into<Vector>) -> Self {
        Self::on(part, Axis::prismatic(direction.into()))
    }

    /// A part on an axis.
    pub const fn on(part: Part, axis: Axis) -> Self {
        Self {
            part,
            axis: Some(axis),
            symmetry: None,
            members: Vec::new(),
        }
    }

    /// Whether a name is that of the part, or of one that it is made of.
    pub fn is_called(&self, name: &str) -> bool {
        self.part.name() == name || self.members.iter().any(|m| m.name == name)
    }
}

impl Mechanism {
    /// A mechanism without parts.
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            ..Self::default()
        }
    }

    /// The index of the part called `name`, or of the body of which that is a part.
    pub fn part_index(&self, name: &str) -> Option<usize> {
        self.parts.iter().position(|p| p.is_called(name))
    }

    /// Whether a part has a mass, so that its motion is dynamic.
    pub fn has_masses(&self) -> bool {
        (0..self.parts.len()).any(|i| self.dynamics.part(i).mass.is_some())
    }

    /// All pairs of parts, the earlier part fixed: the default for a model file without pairs.
    pub fn every_two(&self) -> Vec<PairEntry> {
        let n = self.parts.len();
        let all = (0..n).flat_map(|fixed| (fixed + 1..n).map(move |moving| (fixed, moving)));
        all.map(|(fixed, moving)| PairEntry {
            fixed,
            moving,
            window: None,
        })
        .collect()
    }
}
