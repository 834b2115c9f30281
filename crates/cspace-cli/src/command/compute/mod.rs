//! `cspace compute`.

mod answer;
mod text;

use std::time::Instant;

use crate::ask;
use crate::legacy::{Answer as Framed, Outcome, PairAnswer};
use cspace::fixed_axes::{AxesRegion, AxesStatistics};
use cspace::pair::{Joint, PermanentContact};
use cspace::{Axis, Decisions, FreeRegion, PairSpace, StageSeconds, Statistics, Window};
use serde::Serialize;

use super::several::{self, Answer};
use crate::args::{Common, ComputeArgs, Format};
use crate::failure::{Failure, note};
use crate::subject::InWords;
use cspace_api::subject::{Source, Space};
use cspace_api::{Chosen, Subject};

/// The summary of a configuration space.
#[derive(Serialize)]
struct Summary<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<&'a str>,
    class: &'static str,
    /// How the parts are at zero motion; absent of a pair that never parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    drawn: Option<Drawn>,
    features: Features,
    symmetry: PerPart,
    /// Slabs of orientations of which one was computed.
    #[serde(skip)]
    slabs: u32,
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
    least_clearance: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    doubtful_orientations: Option<&'a [(f64, f64)]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    statistics: Option<Statistic>,
    /// How long this run took for it.
    seconds: Seconds,
    /// Whether the space was computed before, and read.
    #[serde(skip_serializing_if = "core::ops::Not::not")]
    cached: bool,
}

/// The degrees of freedom of a pair without orientations: two axes, or a joint.
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

use answer::Drawn;

pub(crate) fn run(args: &ComputeArgs) -> Result<(), Failure> {
    several::run("compute", &args.common, &args.more, |common| {
        answer(common, args)
    })
}

fn answer(common: &Common, args: &ComputeArgs) -> Result<Answer, Failure> {
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    ask::tell_traces(&subject);
    let pairs = subject.pairs(&ask::which(common, args.window.window), &host)?;
    let spaces = pairs
        .iter()
        .map(|pair| {
            let begin = Instant::now();
            let space = match args.clearance {
                Some(clearance) => pair.space_with_clearance(clearance)?,
                None => pair.space()?,
            };
            if args.verbose && space.source == Source::Kept {
                note(format_args!(
                    "pair {}: its space was computed before and kept; --no-cache computes it",
                    pair.names()
                ));
            }
            Ok((space, begin.elapsed().as_secs_f64()))
        })
        .collect::<Result<Vec<_>, Failure>>()?;
    let summaries: Vec<Summary<'_>> = pairs
        .iter()
        .zip(&spaces)
        .map(|(pair, (space, seconds))| {
            let mut summary = summary(pair, space, *seconds);
            // The stages that are read with a space are those of an earlier run.
            if space.source != Source::Computed {
                summary.cached = true;
                summary.seconds = Seconds::Total { total: *seconds };
            }
            summary
        })
        .collect();
    Ok(match common.result.format() {
        Format::Json => {
            let framed = pairs.iter().zip(&summaries);
            let framed = framed.map(|(pair, summary)| PairAnswer::of(pair, Outcome::DONE, summary));
            let framed = Framed::of_pairs("compute", subject.unit(), framed.collect());
            Answer::Json(super::json(&framed)?)
        }
        Format::Text => {
            let mut text = String::new();
            for (i, ((pair, (space, _)), summary)) in
                pairs.iter().zip(&spaces).zip(&summaries).enumerate()
            {
                if i > 0 {
                    text.push('\n');
                }
                text::describe(&mut text, pair, space, summary, args.verbose)
                    .map_err(Failure::new)?;
            }
            Answer::Text(text)
        }
    })
}

fn summary<'a>(pair: &'a Chosen<'_>, space: &'a PairSpace, seconds: f64) -> Summary<'a> {
    let features = space.features();
    let mut summary = Summary {
        model: pair.model_name(),
        class: space.class().name(),
        drawn: Drawn::of(space),
        features: Features {
            fixed: features.fixed,
            moving: features.moving,
            total: features.fixed + features.moving,
        },
        symmetry: PerPart {
            fixed: pair.fixed().symmetry().fold(),
            moving: pair.moving().symmetry().fold(),
        },
        slabs: 1,
        window: None,
        motion: None,
        critical_orientations: &[],
        bands: space.band_count(),
        slices: space.band_count(),
        patches: space.patch_count(),
        links: Links {
            side: 0,
            vertical: 0,
        },
        free_regions: space.region_count(),
        regions: Regions::Planar(&[]),
        resolution: space.resolution(),
        least_clearance: space.least_clearance(),
        doubtful_orientations: None,
        statistics: None,
        seconds: Seconds::Total { total: seconds },
        cached: false,
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
            summary.slabs = space.symmetry().slabs;
            summary.window = Some(space.window());
            summary.critical_orientations = space.critical_orientations();
            summary.slices = space.computed_bands();
            summary.links = Links {
                side: space.side_links().len(),
                vertical: space.vertical_links().len(),
            };
            summary.regions = Regions::Planar(space.free_regions());
            summary.doubtful_orientations = Some(space.doubtful_orientations());
            summary.statistics = Some(Statistic::General(space.statistics().into()));
            summary.seconds = Seconds::Stages(space.statistics().seconds);
        }
    }
    summary
}
