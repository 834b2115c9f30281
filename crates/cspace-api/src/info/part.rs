//! A part: its outline, its size, and how it moves.

use core::f64::consts::PI;

use cspace::{Axis, AxisMotion, Edge, Part};
use cspace_model::PartEntry;
use schemars::JsonSchema;
use serde::Serialize;

use super::dynamics::Dynamics;

/// A part.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PartInfo {
    /// Its name.
    pub name: String,
    /// Closed loops of the outline.
    pub loops: usize,
    /// Lines, arcs, and vertices that are not smooth joints.
    pub features: FeatureCount,
    /// The diagonal of its box.
    pub size: f64,
    /// The area of its material.
    pub area: f64,
    /// Least x and y, greatest x and y.
    pub bounds: [f64; 4],
    /// Loops around holes.
    pub holes: usize,
    /// Arcs with material inside of their circle.
    pub convex_arcs: usize,
    /// Arcs with material outside.
    pub concave_arcs: usize,
    /// Least and greatest radius of its arcs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radii: Option<(f64, f64)>,
    /// Its layers, if it has heights.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<LayerInfo>,
    /// The parts of the file that it is made of, if they are joined rigidly.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub members: Vec<MemberInfo>,
    /// How it moves relative to the ground.
    pub motion: Motion,
    /// Mass properties and initial state.
    #[serde(flatten)]
    pub dynamics: Dynamics,
    /// The largest fold of a rotation about its own centre that maps the part to itself; 1 for none.
    pub symmetry: u32,
    /// Whether every rotation about its own centre maps it to itself.
    pub round: bool,
}

/// A part of the file that is joined rigidly to others.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct MemberInfo {
    /// Its name, which stands for all of them.
    pub name: String,
    /// The numbers of its first and its last loop.
    pub loops: [usize; 2],
}

/// A layer of a part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LayerInfo {
    /// The lowest and the highest place, in the model's unit of length; none at every height.
    pub z: Option<[f64; 2]>,
    /// Number of its loops.
    pub loops: usize,
    /// Its area, in the square of the model's unit.
    pub area: f64,
}

/// Lines, arcs, and vertices that are not smooth joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
pub struct FeatureCount {
    /// Line segments.
    pub lines: usize,
    /// Arcs.
    pub arcs: usize,
    /// Corners.
    pub vertices: usize,
    /// All of these.
    pub total: usize,
}

/// How a part moves relative to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "type", rename_all = "lowercase")]
pub enum Motion {
    /// It does not.
    Fixed,
    /// It turns about a point.
    Revolute {
        /// The point.
        center: [f64; 2],
        /// Least and greatest angle, radians, if it is limited.
        #[serde(skip_serializing_if = "Option::is_none")]
        range: Option<(f64, f64)>,
    },
    /// It slides.
    Prismatic {
        /// The direction; its length does not matter.
        direction: [f64; 2],
        /// Least and greatest way, in the model's unit of length, if it is limited.
        #[serde(skip_serializing_if = "Option::is_none")]
        range: Option<(f64, f64)>,
    },
    /// It goes and turns in the plane.
    Planar,
}

impl PartInfo {
    /// A part of a model.
    pub(super) fn of_entry(entry: &PartEntry, dynamics: Dynamics) -> Self {
        let mut before = 0;
        let member = |part: &Part| {
            let first = before;
            before += part.loops().len();
            MemberInfo {
                name: part.name().to_owned(),
                loops: [first, before - 1],
            }
        };
        let drawn = entry.drawn();
        let members = drawn.iter().filter(|_| drawn.len() > 1).map(member);
        Self {
            members: members.collect(),
            ..Self::of(&entry.part, entry.axis, dynamics)
        }
    }

    pub(super) fn of(part: &Part, axis: Option<Axis>, dynamics: Dynamics) -> Self {
        let symmetry = part.symmetry();
        let bounds = part.bounds();
        let arcs = || part.edges().filter(|e| !e.is_line());
        let convex = arcs().filter(|e| e.sweep() > 0.0).count();
        let least = arcs().map(|e| e.radius()).fold(f64::INFINITY, f64::min);
        let greatest = arcs().map(|e| e.radius()).fold(0.0, f64::max);
        Self {
            name: part.name().to_owned(),
            loops: part.loops().len(),
            features: FeatureCount::of(part),
            size: part.size(),
            area: part.area(),
            bounds: [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y],
            holes: part
                .loops()
                .iter()
                .filter(|l| l.signed_area() < 0.0)
                .count(),
            convex_arcs: convex,
            concave_arcs: arcs().count() - convex,
            radii: least.is_finite().then_some((least, greatest)),
            layers: layers(part),
            members: Vec::new(),
            motion: axis.map_or(Motion::Planar, Motion::of),
            dynamics,
            symmetry: symmetry.fold(),
            round: symmetry.is_round(),
        }
    }
}

fn layers(part: &Part) -> Vec<LayerInfo> {
    let layers = part.layers().iter().enumerate();
    let of = layers.map(|(i, layer)| LayerInfo {
        z: layer.z(),
        loops: layer.loops().len(),
        area: part.layer(i).area(),
    });
    of.filter(|_| part.has_heights()).collect()
}

impl Motion {
    fn of(axis: Axis) -> Self {
        match axis.motion {
            AxisMotion::Fixed => Self::Fixed,
            AxisMotion::Revolute { center } => Self::Revolute {
                center: [center.x, center.y],
                range: axis.range,
            },
            AxisMotion::Prismatic { direction } => Self::Prismatic {
                direction: [direction.x, direction.y],
                range: axis.range,
            },
        }
    }
}

impl FeatureCount {
    pub(super) fn of(part: &Part) -> Self {
        /// Edges that meet at a smaller angle (radians) are smoothly joined, as in the computation.
        const SMOOTH: f64 = 1.0 / (1u64 << 26) as f64;
        let corner = |before: &Edge, after: &Edge| {
            let (d, e) = (before.end_direction(), after.start_direction());
            let turn = d.cross(e).atan2(d.dot(e));
            (SMOOTH..=PI).contains(&turn.abs())
        };
        let mut count = Self::default();
        for boundary in part.loops() {
            let edges: Vec<Edge> = boundary.edges().collect();
            let lines = edges.iter().filter(|e| e.is_line()).count();
            count.lines += lines;
            count.arcs += edges.len() - lines;
            count.vertices += (edges.iter().zip(edges.iter().cycle().skip(1)))
                .filter(|(a, b)| corner(a, b))
                .count();
        }
        count.total = count.lines + count.arcs + count.vertices;
        count
    }
}
