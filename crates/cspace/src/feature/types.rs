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

impl FeatureKind {
    /// The kind of an edge with a bulge, with material on the left.
    pub fn of_bulge(bulge: f64) -> Self {
        match bulge {
            b if b > 0.0 => Self::ConvexArc,
            b if b < 0.0 => Self::ConcaveArc,
            _ => Self::Line,
        }
    }
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

/// A point of a large arc, half way between its ends, and the outward normal there. It represents the arc where the centre is too far away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Near {
    pub(crate) point: Point,
    pub(crate) normal: Vector,
}

/// Joint of two features: one point and one outward normal, shared by both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Joint<T = f64> {
    pub(crate) point: Point<T>,
    pub(crate) normal: Vector<T>,
    /// Angle of the normal, in (−π, π].
    pub(crate) angle: T,
}

/// A line, arc or convex vertex.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Feature<T = f64> {
    /// The centre of an arc or a vertex; of a line, which its joints determine, the origin.
    pub(crate) center: Point<T>,
    /// Signed radius: > 0 of a convex arc, < 0 of a concave one, 0 of a vertex or a line.
    pub(crate) radius: T,
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
    pub(crate) exact_features: Vec<Feature<Dd>>,
    pub(crate) exact_joints: Vec<Joint<Dd>>,
    /// The heights of the loops to which features belong.
    pub(crate) heights: LoopHeights,
    /// Number of lines, arcs and vertices that are not smooth joints.
    pub(crate) feature_count: usize,
}

impl Joint<Dd> {
    pub(super) fn rounded(&self) -> Joint {
        Joint {
            point: self.point.map(Dd::to_f64),
            normal: self.normal.map(Dd::to_f64),
            angle: self.angle.to_f64(),
        }
    }
}

impl Feature<Dd> {
    pub(super) fn rounded(&self) -> Feature {
        Feature {
            center: self.center.map(Dd::to_f64),
            radius: self.radius.to_f64(),
            near: self.near,
            lo: self.lo,
            hi: self.hi,
            start: self.start,
            end: self.end,
            name: self.name,
        }
    }
}

impl Feature {
    pub(crate) fn is_vertex(&self) -> bool {
        self.name.kind == FeatureKind::Vertex
    }

    pub(crate) fn is_line(&self) -> bool {
        self.name.kind == FeatureKind::Line
    }

    /// The joints at the lower and at the upper end of the normals.
    pub(crate) fn joints_by_angle(&self) -> [u32; 2] {
        if self.name.kind == FeatureKind::ConcaveArc {
            [self.end, self.start]
        } else {
            [self.start, self.end]
        }
    }
}

impl Outline {
    pub(crate) fn start(&self, feature: &Feature) -> &Joint {
        &self.joints[feature.start as usize]
    }

    /// For every joint, the last feature of a kind that starts or ends there, if any.
    pub(crate) fn of_joints(&self, kind: FeatureKind) -> Vec<Option<u32>> {
        let mut owner = vec![None; self.joints.len()];
        for (i, f) in (0..).zip(&self.features) {
            if f.name.kind == kind {
                owner[f.start as usize] = Some(i);
                owner[f.end as usize] = Some(i);
            }
        }
        owner
    }

    pub(crate) fn end(&self, feature: &Feature) -> &Joint {
        &self.joints[feature.end as usize]
    }
}
