//! The whole space against stacks of slices by polygon kernels.

mod cgal;
mod clipper;
mod regions;

use std::f64::consts::{PI, TAU};
use std::time::Instant;

use cspace::{Configuration, ContactSpace, Options, Slicer, Symmetry};
use cspace_baseline::{SEPARATION, Stack, Surface, evenly};
use serde::Serialize;

use crate::models::Pair;
use crate::{Failure, median};

/// Largest distance of chords from arcs, as a share of the larger part's size.
pub(crate) const CHORD: f64 = 1e-4;

/// The coarsest stack that is tried.
const FEWEST: usize = 16;

/// Seconds in which two slices are made by whatever there is.
const PATIENCE: f64 = 600.0;

/// Result of a stack of slices.
struct Outcome {
    /// Connected regions of free space.
    regions: usize,
    /// Class of the working configuration.
    working: Found,
    seconds: f64,
    /// Time for one slice, without joining its regions to others.
    slice_seconds: f64,
}

/// Class of a configuration.
#[derive(Serialize, Clone, Copy, PartialEq, Eq, Debug)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Found {
    /// The parts overlap.
    Blocked,
    /// Free, and connected with arbitrarily far positions.
    Open,
    /// Free, and not connected with them.
    Caged,
}

impl Found {
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Blocked => "blocked",
            Self::Open => "open",
            Self::Caged => "caged",
        }
    }
}

/// Index of the slice that stands for an orientation, where slices are in the middles of equal parts of [−π, π).
fn slot(theta: f64, slices: usize) -> usize {
    let part = (theta + PI) / TAU;
    let at = (part - part.floor()) * slices as f64;
    (at as usize).min(slices - 1)
}

/// A tool that makes stacks.
trait Stacker {
    fn name(&self) -> &'static str;

    /// Computes a stack of slices over the turn, and classifies a configuration; `None` if it takes longer than the
    /// given number of seconds.
    fn run(
        &self,
        slices: usize,
        seconds: f64,
        working: Configuration,
    ) -> Result<Option<Outcome>, String>;
}

/// Measurements of a pair.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) pair: &'static str,
    /// Connected regions of free space, exactly.
    pub(crate) regions: usize,
    /// Exact class of the working configuration.
    pub(crate) working: Found,
    /// The product's, on one thread; and without using symmetry.
    pub(crate) seconds: f64,
    pub(crate) seconds_without_symmetry: f64,
    /// Time of one slice by the product's kernel.
    pub(crate) slice_seconds: f64,
    /// Slices and surface of the general algorithm, 0.005 rad apart, by slice.
    pub(crate) old_slice_seconds: f64,
    pub(crate) tools: Vec<Tool>,
}

/// Result of a tool for the same regions.
#[derive(Serialize)]
pub(crate) struct Tool {
    pub(crate) tool: &'static str,
    /// The coarsest stack from which on all that were tried, of twice as many slices each, have the right number of regions and
    /// are right about where the parts work; `None` if the finest is not.
    pub(crate) right: Option<Tried>,
    /// The finest stack within the limit; `None` if there is none.
    pub(crate) finest: Option<Tried>,
    /// Time for one slice: in the finest stack, or in one of two slices if the limit allows none.
    pub(crate) slice_seconds: Option<f64>,
    /// Whether a stack of twice as many slices as the right one was tried, and agreed.
    pub(crate) confirmed: bool,
}

#[derive(Serialize, Clone, Copy)]
pub(crate) struct Tried {
    pub(crate) slices: usize,
    pub(crate) regions: usize,
    pub(crate) working: Found,
    pub(crate) seconds: f64,
    pub(crate) slice_seconds: f64,
}

/// Available tools; missing ones are reported by `tell`.
pub(crate) struct Tools {
    cgal: Option<cgal::Program>,
}

impl Tools {
    pub(crate) fn find(tell: &mut dyn FnMut(String)) -> Self {
        let cgal = cgal::Program::build().map_err(|why| tell(format!("CGAL is left out: {why}")));
        Self { cgal: cgal.ok() }
    }
}

/// Measures a pair; each tool may take `limit` seconds altogether.
pub(crate) fn measure(pair: &Pair, tools: &Tools, limit: f64) -> Result<Row, Failure> {
    let (fixed, moving) = (&pair.fixed, &pair.moving);
    let space = |symmetry| {
        let options = Options {
            symmetry,
            ..Options::default()
        };
        ContactSpace::compute(fixed, moving, &options)
    };
    let exact = space(Symmetry::Detect)?;
    let right = (exact.free_regions().len(), found(&exact, pair.working)?);
    drop(exact);
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..5 {
        for (symmetry, times) in [Symmetry::Detect, Symmetry::Ignore]
            .into_iter()
            .zip(&mut times)
        {
            let begin = Instant::now();
            let made = space(symmetry)?;
            times.push(begin.elapsed().as_secs_f64());
            drop(made);
        }
    }
    let [seconds, seconds_without_symmetry] = times.map(median);
    let (slice_seconds, old_slice_seconds) = slices(pair)?;

    let chord = CHORD * fixed.size().max(moving.size());
    let clipper = clipper::Clipped::new(fixed, moving, chord);
    let cgal = (tools.cgal.as_ref()).map(|program| program.with(fixed, moving, chord));
    let mut tried = Vec::new();
    if let Some(cgal) = &cgal {
        tried.push(refine(cgal, pair.working, right, limit)?);
    }
    tried.push(refine(&clipper, pair.working, right, limit)?);
    Ok(Row {
        pair: pair.name,
        regions: right.0,
        working: right.1,
        seconds,
        seconds_without_symmetry,
        slice_seconds,
        old_slice_seconds,
        tools: tried,
    })
}

/// Class of a configuration by the exact space: the region of a free one is that of the patch next to it in its slice.
fn found(space: &ContactSpace, c: Configuration) -> Result<Found, Failure> {
    let slice = space.slice(c.theta);
    if !slice.is_free(c.position()) {
        return Ok(Found::Blocked);
    }
    let distance = |curve: &cspace::SliceCurve| {
        let p = c.position();
        curve.geometry.nearest(p).distance(p)
    };
    let nearest = (slice.curves.iter()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let patch = nearest
        .and_then(|c| c.patch)
        .ok_or("a slice without curves")?;
    let region = space.patches()[patch.index()].region;
    Ok(if space.free_regions()[region.index()].unbounded {
        Found::Open
    } else {
        Found::Caged
    })
}

/// Seconds of one slice at the separation of the general algorithm: by the product's kernel alone, and with the surface.
fn slices(pair: &Pair) -> Result<(f64, f64), Failure> {
    let (fixed, moving) = (&pair.fixed, &pair.moving);
    let orientations = evenly(SEPARATION)?;
    let count = orientations.len() as f64;
    let accuracy = CHORD * fixed.size().max(moving.size());
    let (mut product, mut old) = (Vec::new(), Vec::new());
    for _ in 0..3 {
        let begin = Instant::now();
        let slicer = Slicer::new(fixed, moving);
        let curves: usize = (orientations.iter())
            .map(|&theta| slicer.slice(theta).curves.len())
            .sum();
        product.push(begin.elapsed().as_secs_f64() / count);
        std::hint::black_box(curves);
        let begin = Instant::now();
        let stack = Stack::new(fixed, moving, &orientations);
        let surface = Surface::new(&stack, accuracy);
        old.push(begin.elapsed().as_secs_f64() / count);
        std::hint::black_box(surface.triangles());
    }
    Ok((median(product), median(old)))
}

/// Twice as many slices each time, until the next would take too long.
fn refine(
    stacker: &dyn Stacker,
    working: Configuration,
    right: (usize, Found),
    limit: f64,
) -> Result<Tool, Failure> {
    let begin = Instant::now();
    let mut tried: Vec<Tried> = Vec::new();
    let mut slices = FEWEST;
    loop {
        let left = limit - begin.elapsed().as_secs_f64();
        // Twice as many slices take about twice as long.
        let next = tried.last().map_or(0.0, |t| 2.0 * t.seconds);
        if left <= next {
            break;
        }
        let Some(outcome) = stacker.run(slices, left, working)? else {
            break;
        };
        tried.push(Tried {
            slices,
            regions: outcome.regions,
            working: outcome.working,
            seconds: outcome.seconds,
            slice_seconds: outcome.slice_seconds,
        });
        slices *= 2;
    }
    let wrong = tried.iter().rposition(|t| (t.regions, t.working) != right);
    let right = tried.get(wrong.map_or(0, |i| i + 1)).copied();
    let slice_seconds = match tried.last() {
        Some(t) => Some(t.slice_seconds),
        None => (stacker.run(2, PATIENCE, working)?).map(|o| o.slice_seconds),
    };
    Ok(Tool {
        tool: stacker.name(),
        slice_seconds,
        confirmed: right.is_some_and(|r| tried.iter().any(|t| t.slices > r.slices)),
        right,
        finest: tried.last().copied(),
    })
}
