//! `cspace compute`.

use std::fmt::{self, Write};
use std::time::Instant;

use cspace::axes::{AxesRegion, AxesStatistics};
use cspace::pair::{Joint, PermanentContact, PermanentKind};
use cspace::{
    Axis, AxisMotion, Decisions, FreeRegion, PairClass, PairSpace, Part, StageSeconds, Statistics,
    Window,
};
use cspace_io::shown;
use serde::Serialize;

use crate::args::{ComputeArgs, Format};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};
use crate::wording::{angle, count, length, symmetry};

/// The summary of a configuration space.
#[derive(Serialize)]
struct Summary<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<&'a str>,
    fixed: &'a str,
    moving: &'a str,
    class: &'static str,
    features: Features,
    symmetry: PerPart,
    #[serde(skip_serializing_if = "Option::is_none")]
    window: Option<Window>,
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<MotionSpace<'a>>,
    critical_orientations: &'a [f64],
    bands: usize,
    slices: usize,
    patches: usize,
    links: Links,
    free_regions: usize,
    regions: Regions<'a>,
    resolution: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    statistics: Option<Statistic>,
    seconds: Seconds,
}

/// What moves in a pair without orientations.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case", tag = "type")]
enum MotionSpace<'a> {
    Axes {
        fixed: Axis,
        moving: Axis,
    },
    Joint {
        joint: Joint,
        limits: Option<(f64, f64)>,
        permanent: &'a [PermanentContact],
    },
}

#[derive(Serialize)]
#[serde(untagged)]
enum Regions<'a> {
    Planar(&'a [FreeRegion]),
    Axes(Vec<AxesRegion>),
}

#[derive(Serialize)]
#[serde(untagged)]
enum Statistic {
    General(Counts),
    Axes(AxesStatistics),
}

#[derive(Serialize)]
#[serde(untagged)]
enum Seconds {
    Stages(StageSeconds),
    Total { total: f64 },
}

impl Seconds {
    fn total(&self) -> f64 {
        match self {
            Self::Stages(s) => s.total,
            Self::Total { total } => *total,
        }
    }
}

#[derive(Serialize)]
struct Features {
    fixed: u32,
    moving: u32,
    total: u32,
}

#[derive(Serialize)]
struct PerPart {
    fixed: u32,
    moving: u32,
}

#[derive(Serialize)]
struct Links {
    side: usize,
    vertical: usize,
}

/// The statistics without the seconds, which stand beside them.
#[derive(Serialize)]
struct Counts {
    sheets: u64,
    pairs: u64,
    pair_events: u64,
    triple_events: u64,
    clusters: u64,
    branches: u64,
    cells: u64,
    overlap_tests: u64,
    conflicts: u64,
    decisions: Decisions,
}

impl From<&Statistics> for Counts {
    fn from(s: &Statistics) -> Self {
        Self {
            sheets: s.sheets,
            pairs: s.pairs,
            pair_events: s.pair_events,
            triple_events: s.triple_events,
            clusters: s.clusters,
            branches: s.branches,
            cells: s.cells,
            overlap_tests: s.overlap_tests,
            conflicts: s.conflicts,
            decisions: s.decisions,
        }
    }
}

pub(crate) fn run(args: &ComputeArgs) -> Result<(), Failure> {
    let subject = Subject::open(&args.common)?;
    let pairs = subject.pairs(&args.common, args.window.theta)?;
    let spaces = pairs
        .iter()
        .map(|pair| {
            let begin = Instant::now();
            let space = pair.space()?;
            Ok((space, begin.elapsed().as_secs_f64()))
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    let summaries: Vec<Summary<'_>> = pairs
        .iter()
        .zip(&spaces)
        .map(|(pair, (space, seconds))| summary(pair, space, *seconds))
        .collect();
    let bytes = match args.common.result.format {
        Format::Json => super::json(&summaries)?,
        Format::Text => {
            let mut text = String::new();
            for (i, (pair, summary)) in pairs.iter().zip(&summaries).enumerate() {
                if i > 0 {
                    text.push('\n');
                }
                describe(&mut text, pair, summary).map_err(Failure::work)?;
            }
            text.into_bytes()
        }
    };
    output::write(args.common.result.output.as_deref(), &bytes)
}

fn summary<'a>(pair: &'a Chosen<'_>, space: &'a PairSpace, seconds: f64) -> Summary<'a> {
    let features = space.features();
    let mut summary = Summary {
        model: pair.model_name(),
        unit: pair.unit_label(),
        fixed: pair.fixed().name(),
        moving: pair.moving().name(),
        class: space.class().name(),
        features: Features {
            fixed: features.fixed,
            moving: features.moving,
            total: features.fixed + features.moving,
        },
        symmetry: PerPart {
            fixed: pair.fixed().symmetry().fold(),
            moving: pair.moving().symmetry().fold(),
        },
        window: None,
        motion: None,
        critical_orientations: &[],
        bands: space.bands(),
        slices: space.bands(),
        patches: space.patches(),
        links: Links {
            side: 0,
            vertical: 0,
        },
        free_regions: space.free_regions(),
        regions: Regions::Planar(&[]),
        resolution: space.resolution(),
        statistics: None,
        seconds: Seconds::Total { total: seconds },
    };
    match space {
        PairSpace::Lower(lower) => {
            summary.slices = 0;
            summary.motion = Some(MotionSpace::Joint {
                joint: lower.joint(),
                limits: lower.limits(),
                permanent: lower.contacts(),
            });
        }
        PairSpace::FixedAxes(space) => {
            let (fixed, moving) = space.axes();
            summary.motion = Some(MotionSpace::Axes { fixed, moving });
            summary.links.side = space.patches().iter().filter(|p| p.next.is_some()).count();
            summary.regions = Regions::Axes(space.regions());
            summary.statistics = Some(Statistic::Axes(space.statistics()));
        }
        PairSpace::Planar(space) => {
            let symmetry = space.symmetry();
            summary.symmetry = PerPart {
                fixed: symmetry.fixed,
                moving: symmetry.moving,
            };
            summary.window = Some(space.window());
            summary.critical_orientations = space.critical_orientations();
            summary.slices = space.computed_bands();
            summary.links = Links {
                side: space.side_links().len(),
                vertical: space.vertical_links().len(),
            };
            summary.regions = Regions::Planar(space.free_regions());
            summary.statistics = Some(Statistic::General(space.statistics().into()));
            summary.seconds = Seconds::Stages(space.statistics().seconds);
        }
    }
    summary
}

fn describe(text: &mut String, pair: &Chosen<'_>, s: &Summary<'_>) -> fmt::Result {
    let unit = pair.unit();
    writeln!(text, "{} (fixed), {} (moving)", s.fixed, s.moving)?;
    if let Some(model) = s.model {
        writeln!(text, "  model          {model}")?;
    }
    let class = pair.class();
    if pair.is_general() && class != PairClass::General {
        writeln!(
            text,
            "  method         {}: all of (x, y, theta), though the pair's class is {class}",
            s.class
        )?;
    } else {
        writeln!(text, "  method         {}", s.class)?;
    }
    writeln!(
        text,
        "  features       {} + {} = {}",
        s.features.fixed, s.features.moving, s.features.total
    )?;
    if (s.symmetry.fixed, s.symmetry.moving) != (1, 1) {
        writeln!(
            text,
            "  symmetry       {}, {}",
            used_symmetry(pair.fixed(), s.symmetry.fixed),
            used_symmetry(pair.moving(), s.symmetry.moving)
        )?;
    }
    match &s.motion {
        Some(MotionSpace::Joint {
            joint,
            limits,
            permanent,
        }) => describe_joint(text, joint, *limits, permanent, &unit)?,
        Some(MotionSpace::Axes { fixed, moving }) => describe_axes(text, s, (fixed, moving))?,
        None => describe_planar(text, s)?,
    }
    writeln!(
        text,
        "  resolution     {:.1e}{unit}: a clearance below it counts as none",
        s.resolution
    )?;
    let computed = match (pair.is_saved(), &s.seconds) {
        (true, Seconds::Stages(_)) => " when it was computed",
        (true, Seconds::Total { .. }) => " to look at it",
        _ => "",
    };
    writeln!(
        text,
        "  time           {:.6} s{computed}",
        s.seconds.total()
    )
}

/// The symmetry of a part, of which a fold of 1 says that none was found or none looked for.
fn used_symmetry(part: &Part, fold: u32) -> String {
    symmetry(fold, fold > 1 && part.symmetry().is_round())
}

fn describe_joint(
    text: &mut String,
    joint: &Joint,
    limits: Option<(f64, f64)>,
    permanent: &[PermanentContact],
    unit: &str,
) -> fmt::Result {
    let (what, turns) = match joint {
        Joint::Revolute { at } => (format!("revolute about {}", place((at.x, at.y))), true),
        Joint::Prismatic { direction, .. } => (
            format!("prismatic along {}", place((direction.x, direction.y))),
            false,
        ),
        Joint::Rigid => ("rigid".to_owned(), false),
    };
    write!(text, "  joint          {what}")?;
    match limits {
        Some((lo, hi)) if turns => write!(text, ", from {} to {}", angle(lo), angle(hi))?,
        Some((lo, hi)) => write!(text, ", from {} to {}{unit}", length(lo), length(hi))?,
        None => {}
    }
    writeln!(text)?;
    let kinds: Vec<&str> = permanent
        .iter()
        .map(|p| match p.kind {
            PermanentKind::PointLine => "point/line",
            PermanentKind::PointArc => "point/arc",
        })
        .collect();
    writeln!(text, "  contact        permanent: {}", kinds.join(", "))
}

fn place((x, y): (f64, f64)) -> String {
    format!("({}, {})", length(x), length(y))
}

fn describe_axes(text: &mut String, s: &Summary<'_>, axes: (&Axis, &Axis)) -> fmt::Result {
    for (name, axis) in [("u", axes.0), ("v", axes.1)] {
        let what = match axis.motion {
            AxisMotion::Fixed => "does not move".to_owned(),
            AxisMotion::Revolute { center } => {
                format!("turns about {}", place((center.x, center.y)))
            }
            AxisMotion::Prismatic { direction } => {
                format!("slides along {}", place((direction.x, direction.y)))
            }
        };
        write!(text, "  {name}              {what}")?;
        match (axis.range, axis.motion) {
            (Some((lo, hi)), AxisMotion::Revolute { .. }) => {
                write!(text, ", from {} to {}", angle(lo), angle(hi))?;
            }
            (Some((lo, hi)), _) => write!(text, ", from {} to {}", length(lo), length(hi))?,
            _ => {}
        }
        writeln!(text)?;
    }
    writeln!(
        text,
        "  contact        {}, {}",
        count(s.patches, "contact curve", "contact curves"),
        count(s.links.side, "link", "links")
    )?;
    writeln!(
        text,
        "  free space     {}",
        count(s.free_regions, "connected region", "connected regions")
    )?;
    let Regions::Axes(regions) = &s.regions else {
        return Ok(());
    };
    for (i, r) in regions.iter().enumerate() {
        let around = match (r.around_u, r.around_v) {
            (true, true) => ", around u and v",
            (true, false) => ", around u",
            (false, true) => ", around v",
            _ => "",
        };
        let range = |(lo, hi): (f64, f64), open: (bool, bool)| {
            let end = |t: f64, open: bool| {
                if open {
                    "no limit".to_owned()
                } else {
                    length(t)
                }
            };
            format!("from {} to {}", end(lo, open.0), end(hi, open.1))
        };
        writeln!(
            text,
            "    region {i}     u {}, v {}{around}, e.g. {}",
            range(r.u, r.open_u),
            range(r.v, r.open_v),
            place(r.sample)
        )?;
    }
    Ok(())
}

fn describe_planar(text: &mut String, s: &Summary<'_>) -> fmt::Result {
    match s.window {
        Some(w) if !w.full_turn => writeln!(
            text,
            "  orientations   from {} to {}",
            angle(w.lo),
            angle(w.hi)
        )?,
        _ => writeln!(text, "  orientations   all")?,
    }
    writeln!(
        text,
        "  structure      {}, {}{}",
        count(
            s.critical_orientations.len(),
            "critical orientation",
            "critical orientations"
        ),
        count(s.bands, "band", "bands"),
        if s.slices < s.bands {
            format!(" of which {} were computed", s.slices)
        } else {
            String::new()
        }
    )?;
    writeln!(
        text,
        "  contact        {}, {}, {}",
        count(s.patches, "patch", "patches"),
        count(s.links.side, "side link", "side links"),
        count(s.links.vertical, "vertical link", "vertical links")
    )?;
    let Regions::Planar(regions) = s.regions else {
        return Ok(());
    };
    let caged = regions.iter().filter(|r| !r.unbounded).count();
    writeln!(
        text,
        "  free space     {}, {} caged",
        count(s.free_regions, "connected region", "connected regions"),
        caged
    )?;
    for (i, r) in regions.iter().enumerate() {
        writeln!(
            text,
            "    region {i}     {}, {} on its boundary, e.g. ({}, {}, {:.6} rad)",
            if r.unbounded { "open" } else { "caged" },
            count(r.patches as usize, "patch", "patches"),
            length(r.sample.x),
            length(r.sample.y),
            shown::number(r.sample.theta)
        )?;
    }
    Ok(())
}
