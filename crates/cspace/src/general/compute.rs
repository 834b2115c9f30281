//! From two parts to their contact space.

use core::f64::consts::TAU;
use std::time::Instant;

use crate::number::Dd;
use crate::parallel;
use crate::part::{Corresponding, Part};
use crate::space::{
    ComputeError, ContactSpace, Decisions, LONGEST_WINDOW, Options, Progress, Stage, StageSeconds,
    Statistics, WINDOW_SLACK, Window,
};

use crate::general::broad::candidates::Candidates;
use crate::general::broad::discs::Cores;
use crate::general::cells::sweep::Sweep;
use crate::general::events::clusters::{Clusters, Moment};
use crate::general::events::trace::{Traced, branches, pair_events};
use crate::general::events::triple::{OnSheet, triple_events};
use crate::general::limits::{
    MOST_CROSSING, MOST_EDGE_PAIRS, MOST_EDGES, MOST_PATCHES, MOST_SHEETS,
};
use crate::general::links::assemble::Assembler;
use crate::general::links::chains::Linker;
use crate::general::symmetry::{Method, Plan};
use crate::general::verdict::contract::contract;
use crate::general::verdict::doubt::doubtful;
use crate::general::verdict::shells::ShellFinder;

/// Error of the orientation at which two normals oppose each other (radians).
const ALIGNMENT_ERROR: f64 = 64.0 * Dd::EPSILON;

/// Does not care.
struct Silent;

impl Progress for Silent {
    fn stage(&self, _: Stage) -> Result<(), ComputeError> {
        Ok(())
    }
}

impl ContactSpace {
    /// Computes the contact space of two parts: by the general method, or one slab of it if a part is symmetric.
    ///
    /// # Errors
    /// If the window is no interval of at most one turn, or the parts have too many features.
    ///
    /// ```
    /// use cspace::{Configuration, ContactSpace, Options, Part, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
    /// assert_eq!(space.free_regions().len(), 1);
    /// assert_eq!(space.critical_orientations().len(), 4);
    /// assert!(space.slice(0.1).is_free(cspace::Point::new(3.5, 0.0)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn compute(fixed: &Part, moving: &Part, options: &Options) -> Result<Self, ComputeError> {
        Self::compute_with(fixed, moving, options, &Silent)
    }

    /// As [`compute`](Self::compute), telling `progress` of every stage.
    ///
    /// # Errors
    /// As [`compute`](Self::compute); and what `progress` returns.
    pub fn compute_with(
        fixed: &Part,
        moving: &Part,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Self, ComputeError> {
        let window = checked_window(options.window)?;
        let method = options.symmetry.into();
        parallel::within(|| Self::compute_by(fixed, moving, window, method, progress))
    }

    /// Whether the parts have few enough edges, which [`compute`](Self::compute) asks first; a slice may be as much work.
    ///
    /// # Errors
    /// If a part, or the pair, has too many edges.
    pub fn check_size(fixed: &Part, moving: &Part) -> Result<(), ComputeError> {
        let (n, m) = (fixed.edges().count(), moving.edges().count());
        if let Some((part, edges)) = [(fixed, n), (moving, m)]
            .into_iter()
            .find(|(_, edges)| *edges > MOST_EDGES)
        {
            return Err(ComputeError::TooManyEdges {
                part: part.name().to_owned(),
                edges,
                limit: MOST_EDGES,
            });
        }
        if n.saturating_mul(m) > MOST_EDGE_PAIRS {
            return Err(ComputeError::TooLarge {
                fixed: n,
                moving: m,
                limit: MOST_EDGE_PAIRS,
            });
        }
        Ok(())
    }

    fn compute_by(
        fixed: &Part,
        moving: &Part,
        window: Option<(f64, f64)>,
        method: Method,
        progress: &dyn Progress,
    ) -> Result<Self, ComputeError> {
        Self::check_size(fixed, moving)?;
        let (n, m) = (fixed.edges().count(), moving.edges().count());
        let mut seconds = StageSeconds::default();
        let begin = Instant::now();
        let mut clock = Instant::now();
        let mut lap = |to: &mut f64| {
            *to = clock.elapsed().as_secs_f64();
            clock = Instant::now();
        };

        progress.stage(Stage::Sheets)?;
        let Plan {
            geometry,
            symmetry,
            names,
        } = Plan::new(fixed, moving, window, method);
        if geometry.contacts.sheets.len() > MOST_SHEETS {
            return Err(ComputeError::TooManyContacts {
                fixed: n,
                moving: m,
                limit: MOST_SHEETS,
            });
        }
        let span = geometry.contacts.span;
        let sheets = &geometry.contacts.sheets;
        lap(&mut seconds.sheets);

        progress.stage(Stage::Candidates)?;
        let cores = Cores::new(&geometry);
        let Some(mut candidates) = Candidates::find(&geometry, &cores) else {
            return Err(ComputeError::TooManyCrossings {
                fixed: n,
                moving: m,
                limit: MOST_CROSSING,
            });
        };
        lap(&mut seconds.candidates);

        progress.stage(Stage::PairEvents)?;
        // What is not needed any more is dropped: a large pair takes as much memory as its largest stage.
        let pairs = core::mem::take(&mut candidates.pairs);
        let pair_count = pairs.len() as u64;
        let pair_events = pair_events(&geometry, &pairs);
        let of_sheets = sheets.iter().flat_map(|s| [s.from, s.to]);
        let of_slots = (candidates.slots.iter()).map(|&s| Dd::from(s));
        let known: Vec<Moment> = of_sheets
            .chain(of_slots)
            .map(|theta| Moment {
                theta,
                error: ALIGNMENT_ERROR,
            })
            .collect();
        let pair_event_count = pair_events.events.len() as u64;
        let clusters = Clusters::new(pair_events.events.iter().copied().chain(known));
        lap(&mut seconds.pair_events);

        progress.stage(Stage::Branches)?;
        let Traced {
            mut branches,
            mut coincidences,
            mut swallowed,
            mut pinches,
            encounters,
        } = branches(&geometry, &pairs, &pair_events, &clusters);
        drop((pairs, pair_events));
        lap(&mut seconds.branches);

        progress.stage(Stage::TripleEvents)?;
        let on_sheet = OnSheet::new(sheets.len(), &branches);
        let triples = triple_events(&geometry, &branches, &encounters, &on_sheet, &clusters);
        drop(encounters);
        let (clusters, moved) = clusters.with(triples.events.iter().map(|m| m.event).collect());
        for b in &mut branches {
            b.from = moved[b.from as usize];
            b.to = moved[b.to as usize];
        }
        for c in &mut coincidences {
            c.at = moved[c.at as usize];
        }
        for (_, at) in &mut swallowed {
            *at = moved[*at as usize];
        }
        for p in &mut pinches {
            p.at = moved[p.at as usize];
        }
        pinches.sort_unstable();
        let mut splits: Vec<(u32, u32)> = coincidences
            .iter()
            .flat_map(|c| [(c.first, c.at), (c.second, c.at)])
            .chain(swallowed)
            .collect();
        splits.sort_unstable();
        splits.dedup();
        let mut passings: Vec<(u32, u32)> = triples
            .events
            .iter()
            .map(|m| (m.sheet, clusters.index(m.event.theta)))
            .collect();
        passings.sort_unstable();
        passings.dedup();
        lap(&mut seconds.triple_events);

        progress.stage(Stage::Cells)?;
        let sweep = Sweep {
            geometry: &geometry,
            clusters: &clusters,
            branches: &branches,
            on_sheet: &on_sheet,
            passings: &passings,
            splits: &splits,
            pinches: &pinches,
        };
        let mut cells = sweep.run(&candidates.sheets);
        drop((on_sheet, passings, splits));
        lap(&mut seconds.cells);

        progress.stage(Stage::Shells)?;
        let finder = ShellFinder {
            geometry: &geometry,
            clusters: &clusters,
            branches: &branches,
            candidates: &candidates,
            coincidences: &coincidences,
        };
        let mut shells = finder.find(&mut cells);
        drop((candidates, coincidences));
        lap(&mut seconds.shells);

        progress.stage(Stage::Graph)?;
        let statistics = Statistics {
            sheets: sheets.len() as u64,
            pairs: pair_count,
            pair_events: pair_event_count,
            triple_events: triples.events.len() as u64,
            clusters: clusters.len() as u64,
            branches: branches.len() as u64,
            cells: cells.cells.len() as u64,
            overlap_tests: shells.tests as u64,
            conflicts: shells.conflicts as u64,
            decisions: Decisions {
                passings: triples.isolated,
                passings_by_places: triples.by_places,
                orientations: clusters.len() as u64,
                orientations_rough: clusters.rough().count() as u64,
                overlaps: shells.overlaps.0,
                overlaps_uncertain: shells.overlaps.1,
                shells: shells.judged as u64,
            },
            seconds: StageSeconds::default(),
        };
        let (lo, hi) = window.unwrap_or((span.lo, span.lo + TAU));
        let doubtful = doubtful(&clusters, &cells.cells, &shells);
        let contracted = contract(
            &geometry,
            &branches,
            &clusters,
            &mut cells.cells,
            &mut shells,
        );
        let clusters = contracted.unwrap_or(clusters);
        let assembler = Assembler {
            linker: Linker {
                geometry: &geometry,
                clusters: &clusters,
                branches: &branches,
                cells: &cells.cells,
            },
            shells: &shells,
            doubtful: &doubtful,
            window: Window {
                lo,
                hi,
                full_turn: window.is_none(),
            },
            symmetry,
            names: &names,
        };
        if assembler.divides_contacts() {
            // Circles divided for the sake of symmetry are touched after all: rather not divide them.
            let method = Method::Slab(Corresponding::Vertices);
            let mut space = Self::compute_by(fixed, moving, window, method, progress)?;
            space.statistics.seconds.total = begin.elapsed().as_secs_f64();
            return Ok(space);
        }
        let Some(mut space) = assembler.assemble(fixed, moving) else {
            return Err(ComputeError::TooManyPatches {
                fixed: n,
                moving: m,
                limit: MOST_PATCHES,
            });
        };
        lap(&mut seconds.graph);
        seconds.total = begin.elapsed().as_secs_f64();
        space.statistics = Statistics {
            seconds,
            ..statistics
        };
        Ok(space)
    }
}

/// The window, checked; a window of a whole turn is the full turn.
fn checked_window(window: Option<(f64, f64)>) -> Result<Option<(f64, f64)>, ComputeError> {
    let Some((lo, hi)) = window else {
        return Ok(None);
    };
    let length = hi - lo;
    if !(length > 0.0 && length <= LONGEST_WINDOW && lo.abs() < 1e6) {
        return Err(ComputeError::Window { lo, hi });
    }
    Ok((length < TAU - WINDOW_SLACK).then_some((lo, hi)))
}
