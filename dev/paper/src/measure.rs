//! One pair, by the general algorithm and by this one.

use std::error::Error;
use std::hint::black_box;

use cspace::{ComputeError, ContactSpace, Options, Part, Slicer, Symmetry};
use cspace_baseline::compare::{errors, missed_bands};
use cspace_baseline::critical::Known;
use cspace_baseline::paper::{Group, PaperPair};
use cspace_baseline::{SEPARATION, Stack, Surface, evenly, with_bands};
use cspace_model::model;
use serde::Serialize;

use crate::critical::{Kinds, Searched, searched};
use crate::timing::{median, timed};

/// How far the surface's straight pieces may be from arcs, as a share of both parts' size: the paper's 1 % accuracy.
const ACCURACY: f64 = 0.01;

/// The measurements of a pair.
#[derive(Serialize)]
pub(crate) struct Measured {
    /// Figure 5's name.
    pub(crate) pair: &'static str,
    #[serde(skip)]
    pub(crate) group: Group,
    pub(crate) unit: Option<String>,
    pub(crate) features: u32,
    /// Slabs of a turn that are images of each other.
    pub(crate) symmetry: u32,
    pub(crate) old_slices: usize,
    pub(crate) new_slices: usize,
    pub(crate) new_slices_without_symmetry: usize,
    /// Old slices by new ones.
    pub(crate) slice_ratio: f64,
    /// Slices and surface; critical orientations are given.
    pub(crate) old_seconds: f64,
    pub(crate) old_stages: OldStages,
    pub(crate) new_seconds: f64,
    pub(crate) new_seconds_without_symmetry: f64,
    /// Seconds for one slice: by the old algorithm on all threads, and by the product's kernel on one.
    pub(crate) seconds_per_slice: PerSlice,
    /// Old seconds by new ones.
    pub(crate) ratio: f64,
    /// The general algorithm's search of critical orientations over all combinations of features, those known skipped; `None`
    /// if it did not end within the limit.
    pub(crate) criticality_seconds: Option<f64>,
    /// The time of that search with every criticality examined, as the general algorithm does.
    pub(crate) criticality_seconds_without_skipping: Option<f64>,
    /// The work of both searches: with known criticalities skipped, and with all examined.
    pub(crate) criticality_search: [Option<Searched>; 2],
    /// Old seconds with that search, every criticality examined, by new ones; where the search did not end, with the limit in its
    /// place, and so less than it is.
    pub(crate) ratio_with_criticalities: f64,
    /// The kinds of events at the critical orientations of the computed slices.
    pub(crate) critical: Kinds,
    pub(crate) patches: usize,
    pub(crate) links: Links,
    /// Triangles of the old surface.
    pub(crate) triangles: usize,
    pub(crate) largest_gap: f64,
    /// The largest gap as a share of the larger part's size.
    pub(crate) largest_gap_share: f64,
    /// Bands that no slice falls in, if the stack is made without critical orientations;
    pub(crate) missed_bands: usize,
    /// in that stack, spaces between slices in which free and blocked configurations are joined;
    pub(crate) wrongly_joined: usize,
    /// curves in that stack that nothing continues;
    pub(crate) curves_left_open: usize,
    /// and curves in it that are continued by another piece of contact.
    pub(crate) curves_joined_across: usize,
    /// Figure 5's numbers.
    pub(crate) paper: Paper,
}

#[derive(Serialize)]
pub(crate) struct OldStages {
    slices: f64,
    surface: f64,
}

#[derive(Serialize)]
pub(crate) struct PerSlice {
    pub(crate) old: f64,
    pub(crate) product: f64,
}

#[derive(Serialize)]
pub(crate) struct Links {
    pub(crate) side: usize,
    pub(crate) vertical: usize,
}

#[derive(Serialize)]
pub(crate) struct Paper {
    pub(crate) features: u32,
    pub(crate) old_slices: u32,
    pub(crate) new_slices: u32,
    pub(crate) new_slices_without_symmetry: u32,
}

fn space(fixed: &Part, moving: &Part, symmetry: Symmetry) -> Result<ContactSpace, ComputeError> {
    let options = Options {
        symmetry,
        ..Options::default()
    };
    ContactSpace::compute(fixed, moving, &options)
}

/// Number of runs, and limit of searches.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    /// Number of runs of which times are medians.
    pub(crate) repeat: u16,
    /// Limit of each search of critical orientations, seconds.
    pub(crate) criticality: f64,
}

pub(crate) fn measure(pair: &PaperPair, limits: Limits) -> Result<Measured, Box<dyn Error>> {
    let model = model::from_toml(pair.model, pair.name)?;
    let part = |index: usize| &model.parts[index].part;
    let (fixed, moving) = (part(model.pairs[0].fixed), part(model.pairs[0].moving));
    let exact = space(fixed, moving, Symmetry::Detect)?;
    let general = space(fixed, moving, Symmetry::Ignore)?;
    let orientations = with_bands(SEPARATION, &general.bands())?;
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
    for _ in 0..limits.repeat {
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
    let plain = evenly(SEPARATION)?;
    let plain_stack = Stack::new(fixed, moving, &plain);
    let topology = errors(
        &plain_stack,
        &Surface::new(&plain_stack, accuracy),
        &general,
    );
    let features = exact.features();
    let criticality_search = [Known::Skipped, Known::Examined]
        .map(|known| searched(fixed, moving, known, (limits.criticality, limits.repeat)));
    let [skipped, examined] = criticality_search.map(|s| s.map(|s| s.seconds));
    let criticalities = examined.unwrap_or(limits.criticality);
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
