//! Computes the contact space of two parts.

use core::f64::consts::TAU;

use crate::contact::{Exact, Geometry};
use crate::parallel;
use crate::part::{Corresponding, Part};
use crate::space::{
    ComputeError, ContactSpace, Decisions, FORMAT, FeatureCounts, LONGEST_WINDOW, Options,
    Progress, SAVED_VERSION, Silent, SpaceData, Stage, StageSeconds, Statistics, Symmetry,
    WINDOW_SLACK, Window,
};

use crate::general::broad::candidates::Candidates;
use crate::general::broad::discs::Cores;
use crate::general::cells::sweep::Sweep;
use crate::general::events::branch::on_sheets;
use crate::general::events::buried::drop_buried;
use crate::general::events::clusters::{Clusters, Moment};
use crate::general::events::coming::{PairEvents, pair_events};
use crate::general::events::gathered::Gathered;
use crate::general::events::trace::branches;
use crate::general::events::triple::triple_events;
use crate::general::limits::{
    MOST_CROSSING, MOST_EDGE_PAIRS, MOST_EDGES, MOST_PATCHES, MOST_SHEETS,
};
use crate::general::links::assemble::{Assembler, Judged};
use crate::general::links::chains::Chains;
use crate::general::plan::{Method, Names, Plan};
use crate::general::verdict::contract::contract;
use crate::general::verdict::doubt::doubtful;
use crate::general::verdict::shells::ShellFinder;

/// Error of the orientation at which two normals oppose each other (radians).
const ALIGNMENT_ERROR: f64 = 64.0 * Exact::EPSILON;

/// Number of perturbations that are tried while there is a conflict.
const ATTEMPTS: u64 = 4;

impl ContactSpace {
    /// Computes the contact space of two parts: by the general method; if a part is symmetric, over one period only.
    ///
    /// # Errors
    /// If the window is not an interval of at most one turn, or the parts have too many features.
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

    /// As [`compute`](Self::compute), with a report of every stage to `progress`.
    ///
    /// # Errors
    /// As [`compute`](Self::compute); and errors returned by `progress`.
    pub fn compute_with(
        fixed: &Part,
        moving: &Part,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Self, ComputeError> {
        Self::check_size(fixed, moving)?;
        let computation = Computation {
            fixed,
            moving,
            window: checked_window(options.window)?,
            progress,
            begin: progress.seconds(),
        };
        parallel::within(|| computation.run(options.symmetry))
    }

    /// Checks that the parts do not have too many edges, as [`compute`](Self::compute) does first; a slice may be as much work.
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
}

/// A computation: the parts, the window, and the progress.
struct Computation<'a> {
    fixed: &'a Part,
    moving: &'a Part,
    window: Option<(f64, f64)>,
    progress: &'a dyn Progress,
    /// Reading of the clock at the start.
    begin: f64,
}

impl Computation<'_> {
    /// The contact space of the first attempt without a conflict, otherwise of the first with the fewest.
    ///
    /// Where contacts meet in one point as drawn, the perturbation moves them apart, sometimes by less than the arithmetic can tell. Another
    /// perturbation moves the same contacts apart elsewhere.
    fn run(&self, symmetry: Symmetry) -> Result<ContactSpace, ComputeError> {
        let mut method = symmetry.into();
        let mut best = self.attempt(&mut method, 0)?;
        for attempt in 1..ATTEMPTS {
            let conflicts = best.counts.conflicts;
            if conflicts == 0 {
                break;
            }
            match self.attempt(&mut method, attempt) {
                Ok(other) if other.counts.conflicts < conflicts => best = other,
                Err(ComputeError::Interrupted) => return Err(ComputeError::Interrupted),
                // No better, or beyond a limit that the first attempt kept.
                Ok(_) | Err(_) => {}
            }
        }
        let mut space = self.assembled(best);
        space.data.statistics.seconds.total = self.progress.seconds() - self.begin;
        Ok(space)
    }

    /// The cells by the first applicable method from the given one on, which becomes that method. Circles may be divided so that a
    /// part becomes symmetric; if one of them is touched, its patches would be cut finer than the drawing, and only the symmetry of the
    /// vertices is used.
    fn attempt(&self, method: &mut Method, attempt: u64) -> Result<Attempt, ComputeError> {
        loop {
            if let Some(made) = self.by(*method, attempt)? {
                return Ok(made);
            }
            *method = Method::Slab(Corresponding::Vertices);
        }
    }

    /// The cells by a given method; `None` if it divides circles that are touched.
    fn by(&self, method: Method, attempt: u64) -> Result<Option<Attempt>, ComputeError> {
        let mut clock = Clock::new(self.progress);
        self.progress.stage(Stage::Sheets)?;
        let plan = Plan::new(self.fixed, self.moving, self.window, method, attempt);
        let mut seconds = StageSeconds {
            sheets: clock.lap(),
            ..StageSeconds::default()
        };
        self.progress.stage(Stage::Candidates)?;
        let cores = Cores::new(&plan.geometry);
        let made = (self.stages(&plan)).run(&cores, &mut seconds, &mut clock)?;
        Ok(made.map(|(judged, chains, counts)| Attempt {
            plan,
            judged,
            chains,
            counts: Statistics { seconds, ..counts },
        }))
    }

    /// The stages of a plan.
    fn stages<'a>(&'a self, plan: &'a Plan) -> Stages<'a> {
        let span = plan.geometry.contacts.span;
        let (lo, hi) = self.window.unwrap_or((span.lo, span.lo + TAU));
        Stages {
            geometry: &plan.geometry,
            names: &plan.names,
            window: Window {
                lo,
                hi,
                full_turn: self.window.is_none(),
            },
            edges: (self.fixed.edges().count(), self.moving.edges().count()),
            progress: self.progress,
        }
    }

    /// The contact space of an attempt.
    fn assembled(&self, attempt: Attempt) -> ContactSpace {
        let Attempt {
            mut plan,
            judged,
            chains,
            counts,
        } = attempt;
        let mut clock = Clock::new(self.progress);
        let mut seconds = counts.seconds;
        let stages = self.stages(&plan);
        let window = stages.window;
        let linked = stages.assembler(judged).link(chains);
        plan.geometry.contacts.sheets = Vec::new();
        let Plan {
            geometry,
            symmetry,
            names,
        } = plan;
        let graph = linked.graph(&geometry.frame);
        seconds.graph += clock.lap();
        let (more_fixed, more_moving) = names.added();
        let data = SpaceData {
            format: FORMAT.to_owned(),
            version: SAVED_VERSION,
            fixed: self.fixed.clone(),
            moving: self.moving.clone(),
            window,
            frame: geometry.frame,
            features: FeatureCounts {
                fixed: (geometry.fixed.feature_count - more_fixed) as u32,
                moving: (geometry.moving.feature_count - more_moving) as u32,
            },
            critical_orientations: graph.critical_orientations,
            patches: graph.patches,
            side_links: graph.side_links,
            vertical_links: graph.vertical_links,
            free_regions: graph.free_regions,
            symmetry,
            computed_bands: graph.computed_bands,
            doubtful_orientations: graph.doubtful_orientations,
            statistics: Statistics { seconds, ..counts },
        };
        ContactSpace::of(data, graph.walk)
    }
}

/// Free cells of one perturbation of the parts.
struct Attempt {
    plan: Plan,
    judged: Judged,
    chains: Chains,
    counts: Statistics,
}

/// Stopwatch for the seconds of each stage.
pub(crate) struct Clock<'a> {
    progress: &'a dyn Progress,
    /// Reading at the last lap.
    last: f64,
}

impl<'a> Clock<'a> {
    pub(crate) fn new(progress: &'a dyn Progress) -> Self {
        Self {
            progress,
            last: progress.seconds(),
        }
    }

    /// Seconds since the last lap.
    fn lap(&mut self) -> f64 {
        let now = self.progress.seconds();
        now - core::mem::replace(&mut self.last, now)
    }
}

/// The stages from sheets to patches and links: for a contact space, or for the small interval of orientations of a slice.
pub(crate) struct Stages<'a> {
    pub(crate) geometry: &'a Geometry,
    pub(crate) names: &'a Names,
    pub(crate) window: Window,
    /// Edges of the fixed and of the moving part.
    pub(crate) edges: (usize, usize),
    pub(crate) progress: &'a dyn Progress,
}

impl Stages<'_> {
    /// Runs the stages up to the chains of free cells: returns both, and counts; `None` if circles that were divided are touched. `cores`:
    /// the discs of both parts.
    pub(crate) fn run(
        &self,
        cores: &Cores,
        seconds: &mut StageSeconds,
        clock: &mut Clock<'_>,
    ) -> Result<Option<(Judged, Chains, Statistics)>, ComputeError> {
        let (geometry, sheets) = (self.geometry, &self.geometry.contacts.sheets);
        let (n, m) = self.edges;
        if sheets.len() > MOST_SHEETS {
            return Err(ComputeError::TooManyContacts {
                fixed: n,
                moving: m,
                limit: MOST_SHEETS,
            });
        }
        let Some(mut candidates) = Candidates::find(geometry, cores) else {
            return Err(ComputeError::TooManyCrossings {
                fixed: n,
                moving: m,
                limit: MOST_CROSSING,
            });
        };
        seconds.candidates = clock.lap();

        self.progress.stage(Stage::PairEvents)?;
        // Data that are no longer needed are dropped: a large pair takes as much memory as its largest stage.
        let pairs = core::mem::take(&mut candidates.pairs);
        let pair_count = pairs.len() as u64;
        let pair_events = pair_events(geometry, &pairs);
        let pair_event_count = pair_events.events.len() as u64;
        let clusters = first_clusters(geometry, &candidates, &pair_events);
        seconds.pair_events = clock.lap();

        self.progress.stage(Stage::Branches)?;
        let mut traced = branches(geometry, &pairs, &pair_events, &clusters);
        drop((pairs, pair_events));
        if let Some(tables) = &cores.tables {
            drop_buried(geometry, &clusters, tables, &mut traced);
        }
        seconds.branches = clock.lap();

        self.progress.stage(Stage::TripleEvents)?;
        let on_sheet = on_sheets(sheets.len(), &traced.branches);
        let triples = triple_events(geometry, &traced, &on_sheet, &clusters);
        let Gathered {
            clusters,
            branches,
            on_sheet,
            coincidences,
            passings,
            splits,
        } = Gathered::new(traced, on_sheet, &triples, &clusters);
        seconds.triple_events = clock.lap();

        self.progress.stage(Stage::Cells)?;
        let sweep = Sweep {
            geometry,
            clusters: &clusters,
            branches: &branches,
            on_sheet: &on_sheet,
            passings: &passings,
            splits: &splits,
        };
        let mut cells = sweep.run(&candidates.sheets);
        drop((on_sheet, passings, splits));
        seconds.cells = clock.lap();

        self.progress.stage(Stage::Shells)?;
        let finder = ShellFinder {
            geometry,
            clusters: &clusters,
            branches: &branches,
            candidates: &candidates,
            coincidences: &coincidences,
        };
        let mut shells = finder.find(&mut cells);
        drop((candidates, coincidences));
        seconds.shells = clock.lap();

        self.progress.stage(Stage::Graph)?;
        let counts = Statistics {
            sheets: sheets.len() as u64,
            pairs: pair_count,
            pair_events: pair_event_count,
            triple_events: triples.events.len() as u64,
            clusters: clusters.len() as u64,
            branches: branches.len() as u64,
            cells: cells.cells.len() as u64 + cells.dropped,
            overlap_tests: shells.tests as u64,
            conflicts: shells.conflicts as u64,
            decisions: Decisions {
                passings: triples.isolated,
                passings_by_places: triples.by_places,
                orientations: clusters.len() as u64,
                overlaps: shells.overlaps.0,
                overlaps_uncertain: shells.overlaps.1,
                shells: shells.judged as u64,
            },
            seconds: StageSeconds::default(),
        };
        let doubtful = doubtful(&clusters, &cells.cells, &shells);
        let contracted = contract(
            geometry,
            &branches,
            &clusters,
            &mut cells.cells,
            &mut shells,
        );
        let mut assembler = self.assembler(Judged {
            clusters: contracted.unwrap_or(clusters),
            branches,
            cells: cells.cells,
            shells,
            doubtful,
        });
        if assembler.divides_contacts() {
            return Ok(None);
        }
        let Some(chains) = assembler.chains() else {
            return Err(ComputeError::TooManyPatches {
                fixed: n,
                moving: m,
                limit: MOST_PATCHES,
            });
        };
        seconds.graph = clock.lap();
        Ok(Some((assembler.judged, chains, counts)))
    }

    /// Assembler of patches and links from judged cells.
    pub(crate) fn assembler(&self, judged: Judged) -> Assembler<'_> {
        Assembler {
            geometry: self.geometry,
            window: self.window,
            names: self.names,
            judged,
        }
    }
}

/// Clusters of the events of pairs, and of the orientations known before: where sheets begin and end.
fn first_clusters(geometry: &Geometry, candidates: &Candidates, events: &PairEvents) -> Clusters {
    let of_sheets = (geometry.contacts.sheets.iter()).flat_map(|s| [s.from, s.to]);
    let of_slots = (candidates.slots.iter()).map(|&s| Exact::from(s));
    let known = of_sheets.chain(of_slots).map(|theta| Moment {
        theta,
        error: ALIGNMENT_ERROR,
    });
    Clusters::new(events.events.iter().copied().chain(known))
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
