//! The whole space against stacks of slices by polygon kernels.

mod cgal;
mod clipper;
mod regions;

use std::time::Instant;

use cspace::{ContactSpace, Options, Slicer, Symmetry};
use cspace_baseline::{SEPARATION, Stack, Surface, evenly};
use serde::Serialize;

use crate::models::Pair;
use crate::{Failure, median};

/// How far chords may be from arcs, as a share of the larger part's size.
pub(crate) const CHORD: f64 = 1e-4;

/// The coarsest stack that is tried.
const FEWEST: usize = 16;

/// What a stack of so many slices says.
pub(crate) struct Outcome {
    /// Connected regions of free space.
    regions: usize,
    seconds: f64,
    /// Of one slice, without joining its regions to others.
    slice_seconds: f64,
}

/// A tool that makes stacks.
trait Stacker {
    fn name(&self) -> &'static str;

    /// A stack of so many slices over the turn; `None` if it takes longer than so many seconds.
    fn run(&self, slices: usize, seconds: f64) -> Result<Option<Outcome>, String>;
}

/// What was measured of a pair.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) pair: &'static str,
    /// Connected regions of free space, exactly.
    pub(crate) regions: usize,
    /// The product's, on one thread; and without using symmetry.
    pub(crate) seconds: f64,
    pub(crate) seconds_without_symmetry: f64,
    /// One slice by the product's kernel.
    pub(crate) slice_seconds: f64,
    /// Slices and surface of the general algorithm, 0.005 rad apart, by slice.
    pub(crate) old_slice_seconds: f64,
    pub(crate) tools: Vec<Tool>,
}

/// A tool's way to the same regions.
#[derive(Serialize)]
pub(crate) struct Tool {
    pub(crate) tool: &'static str,
    /// The coarsest stack from which on all that were tried, of twice as many slices each, have the right number of regions;
    /// `None` if the finest has not.
    pub(crate) right: Option<Tried>,
    /// The finest stack within the limit; `None` if there is none.
    pub(crate) finest: Option<Tried>,
    /// Whether a stack of twice as many slices as the right one was tried, and agreed.
    pub(crate) confirmed: bool,
}

#[derive(Serialize, Clone, Copy)]
pub(crate) struct Tried {
    pub(crate) slices: usize,
    pub(crate) regions: usize,
    pub(crate) seconds: f64,
    pub(crate) slice_seconds: f64,
}

/// The tools that are there; what is not is told to `tell`.
pub(crate) struct Tools {
    cgal: Option<cgal::Program>,
}

impl Tools {
    pub(crate) fn find(tell: &mut dyn FnMut(String)) -> Self {
        let cgal = cgal::Program::build().map_err(|why| tell(format!("CGAL is left out: {why}")));
        Self { cgal: cgal.ok() }
    }
}

/// Measures a pair; each tool may take so many seconds altogether.
pub(crate) fn measure(pair: &Pair, tools: &Tools, limit: f64) -> Result<Row, Failure> {
    let (fixed, moving) = (&pair.fixed, &pair.moving);
    let space = |symmetry| {
        let options = Options {
            symmetry,
            ..Options::default()
        };
        ContactSpace::compute(fixed, moving, &options)
    };
    let regions = space(Symmetry::Detect)?.free_regions().len();
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
    let mut found = Vec::new();
    if let Some(cgal) = &cgal {
        found.push(refine(cgal, regions, limit)?);
    }
    found.push(refine(&clipper, regions, limit)?);
    Ok(Row {
        pair: pair.name,
        regions,
        seconds,
        seconds_without_symmetry,
        slice_seconds,
        old_slice_seconds,
        tools: found,
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
fn refine(stacker: &dyn Stacker, regions: usize, limit: f64) -> Result<Tool, Failure> {
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
        let Some(outcome) = stacker.run(slices, left)? else {
            break;
        };
        tried.push(Tried {
            slices,
            regions: outcome.regions,
            seconds: outcome.seconds,
            slice_seconds: outcome.slice_seconds,
        });
        slices *= 2;
    }
    let wrong = tried.iter().rposition(|t| t.regions != regions);
    let right = tried.get(wrong.map_or(0, |i| i + 1)).copied();
    Ok(Tool {
        tool: stacker.name(),
        confirmed: right.is_some_and(|r| tried.iter().any(|t| t.slices > r.slices)),
        right,
        finest: tried.last().copied(),
    })
}
