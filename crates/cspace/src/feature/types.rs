//! Features and joints of one part in the pair's frame.

use crate::geometry::{Point, Vector};
use crate::number::Dd;
use crate::part::LoopHeights;

/// Kind of a feature.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum FeatureKind {
    /// A line segment.
    Line,
    /// A circular arc with material on the side of its centre.
    ConvexArc,
    /// A circular arc with material on the side away from its centre.
    ConcaveArc,
    /// A corner with less than half a turn of material.
    Vertex,
}

/// A feature of a part, identified by its place in the part as given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct FeatureName {
    /// Kind of the feature.
    pub kind: FeatureKind,
    /// The loop, counted from 0 in the order given.
    pub loop_index: u32,
    /// For a vertex its index in the loop as given, for a line or arc the index of the vertex at which it starts.
    pub index: u32,
}

impl FeatureKind {
    /// The kind of an edge that is traversed with material on the left, by its bulge.
    pub fn of_edge(bulge: f64) -> Self {
        match bulge {
            b if b > 0.0 => Self::ConvexArc,
            b if b < 0.0 => Self::ConcaveArc,
            _ => Self::Line,
        }
    }
}

impl core::fmt::Display for FeatureKind {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.pad(match self {
            Self::Line => "line",
            Self::ConvexArc => "convex arc",
            Self::ConcaveArc => "concave arc",
            Self::Vertex => "vertex",
        })
    }
}

/// Text such as `line 3 of loop 0`.
impl core::fmt::Display for FeatureName {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(
            f,
            "{} {} of loop {}",
            self.kind, self.index, self.loop_index
        )
    }
}

/// The carrier of a feature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// A line with its outward unit normal.
    Line { normal: Vector },
    /// An arc about a centre: signed radius > 0 if convex, < 0 if concave, 0 for a vertex.
    Round { center: Point, radius: f64 },
}

/// A point of a large arc, half way between its ends, and the outward normal there. It represents the arc where the centre is too far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Near {
    pub(crate) point: Point,
    pub(crate) normal: Vector,
}

/// Joint of two features: one point and one outward normal, shared by both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Joint {
    pub(crate) point: Point,
    pub(crate) normal: Vector,
    /// Angle of the normal, in (−π, π].
    pub(crate) angle: f64,
}

/// A joint in double-double.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExactJoint {
    pub(crate) point: Point<Dd>,
    pub(crate) normal: Vector<Dd>,
    pub(crate) angle: Dd,
}

/// A round feature in double-double; placeholder values for a line, which its joints determine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ExactRound {
    pub(crate) center: Point<Dd>,
    /// Signed radius, as in [`Shape`].
    pub(crate) radius: Dd,
}

/// A line, arc or convex vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Feature {
    pub(crate) shape: Shape,
    /// Reference point; only for arcs larger than `LARGEST_CIRCLE`.
    pub(crate) near: Option<Near>,
    /// Outward normals: angles from `lo` to `hi`, unwrapped; equal for a line.
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Joint at which travel along the feature starts, and ends.
    pub(crate) start: u32,
    pub(crate) end: u32,
    pub(crate) name: FeatureName,
}

/// A part as the kernel uses it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Outline {
    pub(crate) features: Vec<Feature>,
    pub(crate) joints: Vec<Joint>,
    /// Features and joints in double-double; those above are the nearest f64 numbers.
    pub(crate) exact_features: Vec<ExactRound>,
    pub(crate) exact_joints: Vec<ExactJoint>,
    /// The heights of the loops to which features belong.
    pub(crate) heights: LoopHeights,
    /// Number of lines, arcs and vertices that are not smooth joints.
    pub(crate) feature_count: usize,
}

impl Feature {
    pub(crate) fn is_vertex(&self) -> bool {
        self.name.kind == FeatureKind::Vertex
    }

    pub(crate) fn is_line(&self) -> bool {
        self.name.kind == FeatureKind::Line
    }

    /// The centre of a round feature; not finite for a line.
    pub(crate) fn center(&self) -> Point {
        match self.shape {
            Shape::Line { .. } => Point::new(f64::NAN, f64::NAN),
            Shape::Round { center, .. } => center,
        }
    }

    /// The joints at the lower and at the upper end of the normals.
    pub(crate) fn joints_by_angle(&self) -> (u32, u32) {
        if self.name.kind == FeatureKind::ConcaveArc {
            (self.end, self.start)
        } else {
            (self.start, self.end)
        }
    }

    /// The signed radius; 0 for a line.
    pub(crate) fn radius(&self) -> f64 {
        match self.shape {
            Shape::Line { .. } => 0.0,
            Shape::Round { radius, .. } => radius,
        }
    }
}

impl Outline {
    pub(crate) fn start(&self, feature: &Feature) -> &Joint {
        &self.joints[feature.start as usize]
    }

    /// For every joint, the vertex to which it belongs, if any.
    pub(crate) fn vertex_of_joint(&self) -> Vec<Option<u32>> {
        let mut owner = vec![None; self.joints.len()];
        for (i, f) in self
            .features
            .iter()
            .enumerate()
            .filter(|(_, f)| f.is_vertex())
        {
            owner[f.start as usize] = Some(i as u32);
            owner[f.end as usize] = Some(i as u32);
        }
        owner
    }

    /// For every joint, a line that starts or ends there, if any.
    pub(crate) fn line_of_joint(&self) -> Vec<Option<u32>> {
        let mut line = vec![None; self.joints.len()];
        for (i, f) in self
            .features
            .iter()
            .enumerate()
            .filter(|(_, f)| f.is_line())
        {
            line[f.start as usize] = Some(i as u32);
            line[f.end as usize] = Some(i as u32);
        }
        line
    }

    pub(crate) fn end(&self, feature: &Feature) -> &Joint {
        &self.joints[feature.end as usize]
    }
}
