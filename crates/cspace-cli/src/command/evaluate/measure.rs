//! One pair, by the general algorithm and by this one.

use std::hint::black_box;

use cspace::{ContactSpace, Options, Part, Slicer, Symmetry};
use cspace_baseline::compare::{errors, missed_bands};
use cspace_baseline::critical::Known;
use cspace_baseline::paper::{Group, PaperPair};
use cspace_baseline::{Stack, Surface, evenly, with_bands};
use serde::Serialize;

use crate::args::EvaluateArgs;
use crate::failure::Failure;

use super::critical::{Kinds, Searched, searched};
use super::embedded::embedded;
use super::timing::{median, timed};

/// How far the surface's straight pieces may be from arcs, as a share of both parts' size: the paper's 1 % accuracy.
const ACCURACY: f64 = 0.01;

/// The measurements of a pair.
#[derive(Serialize)]
pub(super) struct Measured {
    /// Figure 5's name.
    pub(super) pair: &'static str,
    #[serde(skip)]
    pub(super) group: Group,
    pub(super) unit: Option<String>,
    pub(super) features: u32,
    /// Slabs of a turn that are images of each other.
    pub(super) symmetry: u32,
    pub(super) old_slices: usize,
    pub(super) new_slices: usize,
    pub(super) new_slices_without_symmetry: usize,
    /// Old slices by new ones.
    pub(super) slice_ratio: f64,
    /// Slices and surface; critical orientations are given.
    pub(super) old_seconds: f64,
    pub(super) old_stages: OldStages,
    pub(super) new_seconds: f64,
    pub(super) new_seconds_without_symmetry: f64,
    /// Seconds for one slice: by the old algorithm on all threads, and by the product's kernel on one.
    pub(super) seconds_per_slice: PerSlice,
    /// Old seconds by new ones.
    pub(super) ratio: f64,
    /// The general algorithm's search of critical orientations over all combinations of features, those known skipped; `None`
    /// if it did not end within the limit.
    pub(super) criticality_seconds: Option<f64>,
    /// The time of that search with every criticality examined, as the general algorithm does.
    pub(super) criticality_seconds_without_skipping: Option<f64>,
    /// The work of both searches: with known criticalities skipped, and with all examined.
    pub(super) criticality_search: [Option<Searched>; 2],
    /// Old seconds with that search, every criticality examined, by new ones; where the search did not end, with the limit in its
    /// place, and so less than it is.
    pub(super) ratio_with_criticalities: f64,
    /// The kinds of events at the critical orientations of the computed slices.
    pub(super) critical: Kinds,
    pub(super) patches: usize,
    pub(super) links: Links,
    /// Triangles of the old surface.
    pub(super) triangles: usize,
    pub(super) largest_gap: f64,
    /// The largest gap as a share of the larger part's size.
    pub(super) largest_gap_share: f64,
    /// Bands that no slice falls in, if the stack is made without critical orientations;
    pub(super) missed_bands: usize,
    /// in that stack, spaces between slices in which free and blocked configurations are joined;
    pub(super) wrongly_joined: usize,
    /// curves in that stack that nothing continues;
    pub(super) curves_left_open: usize,
    /// and curves in it that are continued by another piece of contact.
    pub(super) curves_joined_across: usize,
    /// Figure 5's numbers.
    pub(super) paper: Paper,
}

#[derive(Serialize)]
pub(super) struct OldStages {
    slices: f64,
    surface: f64,
}

#[derive(Serialize)]
pub(super) struct PerSlice {
    pub(super) old: f64,
    pub(super) product: f64,
}

#[derive(Serialize)]
pub(super) struct Links {
    pub(super) side: usize,
    pub(super) vertical: usize,
}

#[derive(Serialize)]
pub(super) struct Paper {
    pub(super) features: u32,
    pub(super) old_slices: u32,
    pub(super) new_slices: u32,
    pub(super) new_slices_without_symmetry: u32,
}

fn space(fixed: &Part, moving: &Part, symmetry: Symmetry) -> Result<ContactSpace, Failure> {
    let options = Options {
        symmetry,
        ..Options::default()
    };
    ContactSpace::compute(fixed, moving, &options).map_err(Failure::new)
}

pub(super) fn measure(pair: &PaperPair, args: &EvaluateArgs) -> Result<Measured, Failure> {
    let (separation, repeat) = (args.separation, args.repeat);
    let model = embedded(pair.model, pair.name)?;
    let part = |index: usize| &model.parts[index].part;
    let (fixed, moving) = (part(model.pairs[0].fixed), part(model.pairs[0].moving));
    let exact = space(fixed, moving, Symmetry::Detect)?;
    let general = space(fixed, moving, Symmetry::Ignore)?;
    let orientations = with_bands(separation, &general.bands()).map_err(Failure::new)?;
    let size = fixed.size().max(moving.size());
    let accuracy = ACCURACY * size;

    // The methods take turns, so that what else the machine does meets all of them.
    let [
        mut slices,
        mut surfaces,
        mut old,
        mut new,
        mut without,
        mut alone,
    ] = [const { Vec::new() }; 6];
    for _ in 0..repeat {
        let (of_slices, stack) = timed(|| Stack::new(fixed, moving, &orientations));
        let (of_surface, surface) = timed(|| Surface::new(&stack, accuracy));
        drop((stack, surface));
        let (of_product, curves) = timed(|| {
            let slicer = Slicer::new(fixed, moving);
            let slices = orientations.iter().map(|&theta| slicer.slice(theta));
            slices.map(|s| s.curves.len()).sum::<usize>()
        });
        // Nothing of it may be left out as unused.
        black_box(curves);
        alone.push(of_product);
        slices.push(of_slices);
        surfaces.push(of_surface);
        old.push(of_slices + of_surface);
        for (symmetry, seconds) in [
            (Symmetry::Detect, &mut new),
            (Symmetry::Ignore, &mut without),
        ] {
            let (of_space, made) = timed(|| space(fixed, moving, symmetry));
            made?;
            seconds.push(of_space);
        }
    }
    let (old_seconds, new_seconds, slices) = (median(old), median(new), median(slices));
    let count = orientations.len() as f64;

    let stack = Stack::new(fixed, moving, &orientations);
    let surface = Surface::new(&stack, accuracy);
    let gaps = errors(&stack, &surface, &general);
    let plain = evenly(separation).map_err(Failure::new)?;
    let plain_stack = Stack::new(fixed, moving, &plain);
    let topology = errors(
        &plain_stack,
        &Surface::new(&plain_stack, accuracy),
        &general,
    );
    let features = exact.features();
    let criticality_search = [Known::Skipped, Known::Examined]
        .map(|known| searched(fixed, moving, known, (args.criticality_limit, repeat)));
    let [skipped, examined] = criticality_search.map(|s| s.map(|s| s.seconds));
    let criticalities = examined.unwrap_or(args.criticality_limit);
    Ok(Measured {
        pair: pair.name,
        group: pair.group,
        unit: model.unit.clone(),
        features: features.fixed + features.moving,
        symmetry: exact.symmetry().slabs,
        old_slices: orientations.len(),
        new_slices: exact.computed_bands(),
        new_slices_without_symmetry: general.bands().len(),
        slice_ratio: orientations.len() as f64 / exact.computed_bands().max(1) as f64,
        old_seconds,
        old_stages: OldStages {
            slices,
            surface: median(surfaces),
        },
        new_seconds,
        new_seconds_without_symmetry: median(without),
        seconds_per_slice: PerSlice {
            old: slices / count,
            product: median(alone) / count,
        },
        ratio: old_seconds / new_seconds,
        criticality_seconds: skipped,
        criticality_seconds_without_skipping: examined,
        criticality_search,
        ratio_with_criticalities: (old_seconds + criticalities) / new_seconds,
        critical: Kinds::new(&general, exact.symmetry().slabs),
        patches: exact.patches().len(),
        links: Links {
            side: exact.side_links().len(),
            vertical: exact.vertical_links().len(),
        },
        triangles: surface.triangles(),
        largest_gap: gaps.largest_gap,
        largest_gap_share: gaps.largest_gap / size,
        missed_bands: missed_bands(&general, &plain),
        wrongly_joined: topology.open_layers,
        curves_left_open: topology.left_open,
        curves_joined_across: topology.joined_across,
        paper: Paper {
            features: pair.features,
            old_slices: pair.old_slices,
            new_slices: pair.new_slices,
            new_slices_without_symmetry: pair.new_slices_without_symmetry,
        },
    })
}
