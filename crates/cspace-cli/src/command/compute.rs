//! `cspace compute`.

use std::fmt::{self, Write};

use cspace::{ContactSpace, FreeRegion, StageSeconds, Statistics, Window};
use serde::Serialize;

use crate::args::{ComputeArgs, Format};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, Subject};
use crate::wording::{angle, count};

/// The method by which a space was computed.
fn method(space: &ContactSpace) -> &'static str {
    if space.symmetry().slabs > 1 {
        SYMMETRIC
    } else {
        GENERAL
    }
}

const GENERAL: &str = "general";
const SYMMETRIC: &str = "symmetric";

/// The summary of a contact space.
#[derive(Serialize)]
struct Summary<'a> {
    fixed: &'a str,
    moving: &'a str,
    class: &'static str,
    features: Features,
    symmetry: PerPart,
    window: Window,
    critical_orientations: &'a [f64],
    bands: usize,
    slices: usize,
    patches: usize,
    links: Links,
    free_regions: usize,
    regions: &'a [FreeRegion],
    resolution: f64,
    statistics: Counts,
    seconds: StageSeconds,
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
        }
    }
}

pub(crate) fn run(args: &ComputeArgs) -> Result<(), Failure> {
    let subject = Subject::open(&args.common)?;
    let pairs = subject.pairs(&args.common, args.window.theta)?;
    let spaces = pairs
        .iter()
        .map(Chosen::space)
        .collect::<Result<Vec<_>, _>>()?;
    let summaries: Vec<Summary<'_>> = pairs
        .iter()
        .zip(&spaces)
        .map(|(pair, space)| summary(pair, space))
        .collect();
    let bytes = match args.common.format {
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
    output::write(args.common.output.as_deref(), &bytes)
}

fn summary<'a>(pair: &'a Chosen<'_>, space: &'a ContactSpace) -> Summary<'a> {
    let features = space.features();
    let symmetry = space.symmetry();
    let bands = space.bands().len();
    Summary {
        fixed: pair.fixed().name(),
        moving: pair.moving().name(),
        class: method(space),
        features: Features {
            fixed: features.fixed,
            moving: features.moving,
            total: features.fixed + features.moving,
        },
        symmetry: PerPart {
            fixed: symmetry.fixed,
            moving: symmetry.moving,
        },
        window: space.window(),
        critical_orientations: space.critical_orientations(),
        bands,
        slices: space.computed_bands(),
        patches: space.patches().len(),
        links: Links {
            side: space.side_links().len(),
            vertical: space.vertical_links().len(),
        },
        free_regions: space.free_regions().len(),
        regions: space.free_regions(),
        resolution: space.resolution(),
        statistics: space.statistics().into(),
        seconds: space.statistics().seconds,
    }
}

fn describe(text: &mut String, pair: &Chosen<'_>, s: &Summary<'_>) -> fmt::Result {
    let unit = pair.unit();
    writeln!(text, "{} (fixed), {} (moving)", s.fixed, s.moving)?;
    match pair.class().map(cspace_io::PairClass::name) {
        Some(class) if class != GENERAL => writeln!(
            text,
            "  method         {}: all of (x, y, theta), though the pair's class is {class}",
            s.class
        )?,
        _ => writeln!(text, "  method         {}", s.class)?,
    }
    writeln!(
        text,
        "  features       {} + {} = {}",
        s.features.fixed, s.features.moving, s.features.total
    )?;
    if (s.symmetry.fixed, s.symmetry.moving) != (1, 1) {
        writeln!(
            text,
            "  symmetry       {}-fold, {}-fold",
            s.symmetry.fixed, s.symmetry.moving
        )?;
    }
    if s.window.full_turn {
        writeln!(text, "  orientations   all")?;
    } else {
        writeln!(
            text,
            "  orientations   from {} to {}",
            angle(s.window.lo),
            angle(s.window.hi)
        )?;
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
    let caged = s.regions.iter().filter(|r| !r.unbounded).count();
    writeln!(
        text,
        "  free space     {}, {} caged",
        count(s.free_regions, "connected region", "connected regions"),
        caged
    )?;
    for (i, r) in s.regions.iter().enumerate() {
        writeln!(
            text,
            "    region {i}     {}, {} on its boundary, e.g. ({:.6}, {:.6}, {:.6} rad)",
            if r.unbounded { "open" } else { "caged" },
            count(r.patches as usize, "patch", "patches"),
            r.sample.x,
            r.sample.y,
            r.sample.theta
        )?;
    }
    writeln!(
        text,
        "  resolution     {:.1e}{unit}: a clearance below it counts as none",
        s.resolution
    )?;
    let computed = if pair.is_saved() {
        " when it was computed"
    } else {
        ""
    };
    writeln!(text, "  time           {:.3} s{computed}", s.seconds.total)
}
