//! `cspace info`.

mod dynamics;
mod dynamics_text;
mod text;

use core::f64::consts::PI;

use crate::ask;
use crate::legacy::{Answer as Framed, Outcome};
use cspace::pair::Joint;
use cspace::{Axis, AxisMotion, Edge, PairSpace, Part};
use cspace_io::model::Parameter;
use serde::Serialize;

use self::dynamics::{Forces, PartMotion, SurfaceInfo, forces, part_motion, surface};
use super::several::{self, Answer};
use crate::args::{Common, Format, InfoArgs};
use crate::failure::Failure;
use crate::subject::InWords;
use cspace_api::{Chosen, Subject};

#[derive(Serialize)]
struct Info {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    parameters: Vec<ParameterInfo>,
    parts: Vec<PartInfo>,
    joints: Vec<JointInfo>,
    pairs: Vec<PairInfo>,
    #[serde(flatten)]
    forces: Forces,
}

#[derive(Serialize)]
struct ParameterInfo {
    name: String,
    value: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    expression: Option<String>,
    /// Whether the value was given with `--set`.
    set: bool,
    /// How far below and above the value it may be.
    #[serde(skip_serializing_if = "Option::is_none")]
    deviations: Option<[f64; 2]>,
    used_by: Vec<String>,
}

#[derive(Serialize)]
struct PartInfo {
    name: String,
    loops: usize,
    features: FeatureCount,
    size: f64,
    area: f64,
    /// x and y of the lower left corner, then of the upper right one.
    bounds: [f64; 4],
    /// Loops that bound material from inside.
    holes: usize,
    convex_arcs: usize,
    concave_arcs: usize,
    /// Least and greatest radius of its arcs.
    #[serde(skip_serializing_if = "Option::is_none")]
    radii: Option<(f64, f64)>,
    motion: MotionInfo,
    #[serde(flatten)]
    dynamics: PartMotion,
    /// The largest fold about its own centre.
    symmetry: u32,
    /// Whether every rotation about its own centre maps the part to itself.
    round: bool,
}

/// Lines, arcs, and vertices that are not smooth joints.
#[derive(Serialize, Clone, Copy, Default)]
struct FeatureCount {
    lines: usize,
    arcs: usize,
    vertices: usize,
    total: usize,
}

#[derive(Serialize)]
#[serde(tag = "type", rename_all = "lowercase")]
enum MotionInfo {
    Fixed,
    Revolute {
        center: [f64; 2],
        #[serde(skip_serializing_if = "Option::is_none")]
        range: Option<(f64, f64)>,
    },
    Prismatic {
        direction: [f64; 2],
        #[serde(skip_serializing_if = "Option::is_none")]
        range: Option<(f64, f64)>,
    },
    Planar,
}

#[derive(Serialize)]
struct JointInfo {
    #[serde(rename = "type")]
    kind: &'static str,
    parts: [String; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<[f64; 2]>,
}

#[derive(Serialize)]
struct PairInfo {
    fixed: String,
    moving: String,
    class: &'static str,
    features: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta: Option<(f64, f64)>,
    #[serde(flatten)]
    surface: SurfaceInfo,
}

pub(crate) fn run(args: &InfoArgs) -> Result<(), Failure> {
    several::run("info", &args.common, &args.more, |common| {
        answer(common, args)
    })
}

fn answer(common: &Common, args: &InfoArgs) -> Result<Answer, Failure> {
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    ask::tell_traces(&subject);
    let pairs = subject.pairs_if_any(&ask::which(common, args.window.window), &host)?;
    for pair in &pairs {
        pair.check_window()?;
    }
    let info = gather(&subject, &pairs);
    Ok(match common.result.format() {
        Format::Json => {
            let framed = Framed::new("info", subject.unit(), Outcome::DONE, &info);
            Answer::Json(super::json(&framed)?)
        }
        Format::Text => {
            let mut text = String::new();
            text::describe(&mut text, &info).map_err(Failure::new)?;
            Answer::Text(text)
        }
    })
}

fn gather(subject: &Subject, pairs: &[Chosen<'_>]) -> Info {
    let pairs = pairs.iter().map(|p| pair_info(subject, p)).collect();
    match subject {
        Subject::Model(file) => {
            let (model, parameters) = (&file.model.mechanism, &file.model.parameters);
            Info {
                name: model.name.clone(),
                unit: model.unit.clone(),
                parameters: parameters.iter().map(parameter_info).collect(),
                parts: (model.parts.iter().enumerate())
                    .map(|(i, p)| part_info(&p.part, p.axis, part_motion(model, i)))
                    .collect(),
                joints: (model.joints.iter())
                    .map(|j| {
                        let (a, b) = j.parts;
                        joint_info(j.joint, [a, b].map(|i| &model.parts[i].part))
                    })
                    .collect(),
                pairs,
                forces: forces(model),
            }
        }
        Subject::Saved { file, .. } => {
            let space = &file.space;
            let parts = || format!("{} and {}", space.fixed().name(), space.moving().name());
            Info {
                name: file.name.clone().unwrap_or_else(parts),
                unit: file.unit.clone(),
                parameters: Vec::new(),
                parts: saved_parts(space),
                joints: match space {
                    PairSpace::Lower(pair) => {
                        vec![joint_info(pair.joint(), [pair.fixed(), pair.moving()])]
                    }
                    _ => Vec::new(),
                },
                pairs,
                forces: Forces::default(),
            }
        }
    }
}

fn parameter_info(p: &Parameter) -> ParameterInfo {
    ParameterInfo {
        name: p.name.clone(),
        value: p.value,
        expression: p.expression.clone(),
        set: p.is_set,
        deviations: p.deviations.map(|(below, above)| [below, above]),
        used_by: p.used_by.clone(),
    }
}

/// The parts of a saved space; how they move relative to the ground is known of those on axes only.
fn saved_parts(space: &PairSpace) -> Vec<PartInfo> {
    let axes = match space {
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            [fixed, moving].map(Some)
        }
        _ => [None; 2],
    };
    ([space.fixed(), space.moving()].into_iter().zip(axes))
        .map(|(part, axis)| part_info(part, axis, PartMotion::default()))
        .collect()
}

fn pair_info(subject: &Subject, pair: &Chosen<'_>) -> PairInfo {
    PairInfo {
        fixed: pair.fixed().name().to_owned(),
        moving: pair.moving().name().to_owned(),
        class: pair.class_in_full().name(),
        features: features(pair.fixed()).total + features(pair.moving()).total,
        theta: pair.window(),
        surface: match subject {
            Subject::Model(file) => surface(
                &file.model.mechanism,
                pair.fixed().name(),
                pair.moving().name(),
            ),
            Subject::Saved { .. } => SurfaceInfo::default(),
        },
    }
}

fn part_info(part: &Part, axis: Option<Axis>, dynamics: PartMotion) -> PartInfo {
    let symmetry = part.symmetry();
    let bounds = part.bounds();
    let arcs = || part.edges().filter(|e| !e.is_line());
    let convex = arcs().filter(|e| e.sweep() > 0.0).count();
    let least = arcs().map(|e| e.radius()).fold(f64::INFINITY, f64::min);
    let greatest = arcs().map(|e| e.radius()).fold(0.0, f64::max);
    PartInfo {
        name: part.name().to_owned(),
        loops: part.loops().len(),
        features: features(part),
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
        motion: axis.map_or(MotionInfo::Planar, |axis| match axis.motion {
            AxisMotion::Fixed => MotionInfo::Fixed,
            AxisMotion::Revolute { center } => MotionInfo::Revolute {
                center: [center.x, center.y],
                range: axis.range,
            },
            AxisMotion::Prismatic { direction } => MotionInfo::Prismatic {
                direction: [direction.x, direction.y],
                range: axis.range,
            },
        }),
        dynamics,
        symmetry: symmetry.fold(),
        round: symmetry.is_round(),
    }
}

fn joint_info(joint: Joint, parts: [&Part; 2]) -> JointInfo {
    let (kind, at, direction) = match joint {
        Joint::Revolute { at } => ("revolute", Some(at), None),
        Joint::Prismatic { direction, at } => ("prismatic", Some(at), Some(direction)),
        Joint::Rigid => ("rigid", None, None),
    };
    JointInfo {
        kind,
        parts: parts.map(|p| p.name().to_owned()),
        at: at.map(|p| [p.x, p.y]),
        direction: direction.map(|d| [d.x, d.y]),
    }
}

fn features(part: &Part) -> FeatureCount {
    /// Edges that meet at a smaller angle (radians) are smoothly joined, as in the computation.
    const SMOOTH: f64 = 1.0 / (1u64 << 26) as f64;
    let corner = |before: &Edge, after: &Edge| {
        let (d, e) = (before.end_direction(), after.start_direction());
        let turn = d.cross(e).atan2(d.dot(e));
        (SMOOTH..=PI).contains(&turn.abs())
    };
    let mut count = FeatureCount::default();
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
