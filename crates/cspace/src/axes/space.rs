//! The configuration space of a pair with fixed axes.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::feature::tolerance::GROWTH;
use crate::feature::{FeatureName, Outline, PairFrame};
use crate::geometry::{Configuration, Point, Vector};
use crate::part::Part;

use super::arrange::{Arrangement, Cell};
use super::axis::{AxesError, Axis, AxisMotion, Role};
use super::bands::{Bands, Graphs, Sweep};
use super::body::Bodies;
use super::build::build;
use super::chain::chains;
use super::domain::{Extent, ExtentKind};
use super::judge::Judge;
use super::motion::{Motion, Motions};
use super::nodes::{Scene, Side};
use super::patch::{AxesBranch, AxesPatch};
use super::piece::{Pair, Piece};

/// The farthest pivot, in units of the parts' size: positions are then right to a hundredth of what the first part is
/// grown by.
const FARTHEST: f64 = 32.0;
/// The longest range of a turning part, in turns.
const MOST_TURNS: u32 = 1000;

/// The configuration space of two parts on fixed axes.
#[derive(Debug)]
pub struct FixedAxesSpace {
    pub(super) fixed: Part,
    pub(super) moving: Part,
    pub(super) axes: (Axis, Axis),
    pub(super) map: Map,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) names: (Vec<FeatureName>, Vec<FeatureName>),
    pub(super) pairs: Vec<Pair>,
    pub(super) pieces: Vec<Piece>,
    pub(super) cells: Vec<Cell>,
    pub(super) free: Vec<bool>,
    pub(super) bands: Bands,
    pub(super) slots: Vec<Vec<u32>>,
    pub(super) patches: Vec<AxesPatch>,
    pub(super) branches: Vec<AxesBranch>,
    pub(super) statistics: AxesStatistics,
}

/// Counts of a computation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct AxesStatistics {
    /// Pairs of features that touch somewhere.
    pub pairs: usize,
    /// Monotone pieces of their contact curves.
    pub pieces: usize,
    /// Crossings of pieces.
    pub crossings: usize,
    /// Tests of overlap.
    pub tests: usize,
    /// Places at which tests and structure told different things; 0 unless something lies closer than the resolution.
    pub conflicts: usize,
}

/// From u and v to x and y and back.
///
/// x is the coordinate along which the plane is swept: one of a part that turns, if there is one.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub(super) struct Map {
    pub(super) frame: PairFrame,
    pub(super) swapped: bool,
    /// Model units per unit of x and y.
    x_unit: f64,
    y_unit: f64,
}

impl Map {
    pub(super) fn inner(&self, u: f64, v: f64) -> (f64, f64) {
        let (x, y) = if self.swapped { (v, u) } else { (u, v) };
        (x / self.x_unit, y / self.y_unit)
    }

    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let (x, y) = (x * self.x_unit, y * self.y_unit);
        if self.swapped { (y, x) } else { (x, y) }
    }

    /// Model units per unit of u and of v.
    pub(super) fn units(&self) -> (f64, f64) {
        self.outer(1.0, 1.0)
    }
}

impl FixedAxesSpace {
    /// Computes the configuration space of a pair.
    ///
    /// Both parts are drawn in the assembly's frame at zero motion.
    ///
    /// # Errors
    /// If an axis has no direction, an empty range, numbers that are not finite, or a pivot far away.
    pub fn compute(
        fixed: &Part,
        fixed_axis: Axis,
        moving: &Part,
        moving_axis: Axis,
    ) -> Result<Self, AxesError> {
        let frame = PairFrame::new(fixed, moving);
        let center = frame.fixed_center;
        let fixed_motion = motion(&fixed_axis, Role::Fixed, &frame)?;
        let moving_motion = motion(&moving_axis, Role::Moving, &frame)?;
        let rank = |m: &Motion| match m {
            Motion::Turn { .. } => 2,
            Motion::Slide { .. } => 1,
            Motion::Still => 0,
        };
        let swapped = rank(&moving_motion) > rank(&fixed_motion);
        let outline = |part: &Part, grown| Outline::new(part, center, frame.scale, grown);
        let (a, b) = (outline(fixed, true), outline(moving, false));
        let body =
            |o: &Outline, part: &Part| crate::contact::Body::new(o, part, center, frame.scale);
        let (body_a, body_b) = (body(&a, fixed), body(&b, moving));
        let names = |o: &Outline| o.features.iter().map(|f| f.name).collect();
        let mut names = (names(&a), names(&b));
        let mut sides = (Side::new(a), Side::new(b));
        let mut bodies = (body_a, body_b);
        let mut motions = Motions {
            first: fixed_motion,
            second: moving_motion,
        };
        let mut axes = (fixed_axis, moving_axis);
        if swapped {
            names = (names.1, names.0);
            sides = (sides.1, sides.0);
            bodies = (bodies.1, bodies.0);
            axes = (axes.1, axes.0);
            motions = motions.swapped();
        }
        let unit = |m: &Motion| if m.turns() { 1.0 } else { 1.0 / frame.scale };
        let map = Map {
            frame,
            swapped,
            x_unit: unit(&motions.first),
            y_unit: unit(&motions.second),
        };
        let reach = reach(&sides.0.outline, &sides.1.outline, &motions);
        let scene = Scene {
            x: extent(&axes.0, &motions.first, map.x_unit, reach),
            y: extent(&axes.1, &motions.second, map.y_unit, reach),
            first: sides.0,
            second: sides.1,
            motions,
        };
        let bodies = Bodies {
            first: bodies.0,
            second: bodies.1,
            motions,
        };
        let (pairs, pieces) = build(&scene);
        let arrangement = Arrangement::new(&pairs, &pieces, &scene.y);
        let judge = Judge::new(&pairs, &pieces, &bodies, scene.x, scene.y);
        let verdicts = judge.verdicts(&arrangement);
        let bands = Sweep {
            graphs: Graphs {
                pairs: &pairs,
                pieces: &pieces,
                cells: &arrangement.cells,
                y: scene.y,
            },
            free: &verdicts.free,
            bodies: &bodies,
            x: scene.x,
        }
        .run();
        let statistics = AxesStatistics {
            pairs: pairs.len(),
            pieces: pieces.len(),
            crossings: arrangement.crossings,
            tests: verdicts.tests + bands.tests,
            conflicts: verdicts.conflicts + bands.conflicts,
        };
        let mut space = Self {
            fixed: fixed.clone(),
            moving: moving.clone(),
            axes: (fixed_axis, moving_axis),
            map,
            motions,
            x: scene.x,
            y: scene.y,
            names,
            pairs,
            pieces,
            cells: arrangement.cells,
            free: verdicts.free,
            bands,
            slots: Vec::new(),
            patches: Vec::new(),
            branches: Vec::new(),
            statistics,
        };
        space.slots = space.near_slots();
        let chains = chains(
            &space.pairs,
            &space.pieces,
            &space.cells,
            &space.free,
            &arrangement.joints,
            (space.x, space.y),
        );
        space.set_patches(chains);
        Ok(space)
    }

    /// The part called fixed.
    pub fn fixed(&self) -> &Part {
        &self.fixed
    }

    /// The moving part.
    pub fn moving(&self) -> &Part {
        &self.moving
    }

    /// The axes of the fixed and of the moving part.
    pub fn axes(&self) -> (Axis, Axis) {
        self.axes
    }

    /// Counts of the computation.
    pub fn statistics(&self) -> AxesStatistics {
        self.statistics
    }

    /// The resolution in the model's unit of length: clearances below it count as none.
    pub fn resolution(&self) -> f64 {
        self.map.frame.outer_length(8.0 * GROWTH)
    }

    /// Where the moving part is in the fixed part's frame at (u, v).
    pub fn configuration(&self, u: f64, v: f64) -> Configuration {
        let (x, y) = self.map.inner(u, v);
        let (p, theta) = if self.map.swapped {
            self.motions.swapped().relative(y, x)
        } else {
            self.motions.relative(x, y)
        };
        // Both parts are drawn about the fixed part's centre c: c + p + R (q − c) places a point q.
        let c = self.map.frame.fixed_center.to_vector();
        let turned = crate::geometry::Rotation::by(theta) * c;
        let at = p.to_vector() * (1.0 / self.map.frame.scale) + c - turned;
        Configuration::new(at.x, at.y, theta)
    }
}

fn motion(axis: &Axis, part: Role, frame: &PairFrame) -> Result<Motion, AxesError> {
    if let Some((lo, hi)) = axis.range {
        if !(lo.is_finite() && hi.is_finite()) {
            return Err(AxesError::NotFinite { part });
        }
        if lo >= hi {
            return Err(AxesError::EmptyRange { part, lo, hi });
        }
    }
    match axis.motion {
        AxisMotion::Fixed => Ok(Motion::Still),
        AxisMotion::Revolute { center } => {
            if !center.is_finite() {
                return Err(AxesError::NotFinite { part });
            }
            let center = Point::ORIGIN + (center - frame.fixed_center) * frame.scale;
            let times = center.to_vector().length();
            if times > FARTHEST {
                return Err(AxesError::TooFar {
                    part,
                    times,
                    limit: FARTHEST,
                });
            }
            if let Some((lo, hi)) = axis.range {
                let turns = (hi - lo) / TAU;
                if turns > f64::from(MOST_TURNS) {
                    return Err(AxesError::TooManyTurns {
                        part,
                        turns,
                        limit: MOST_TURNS,
                    });
                }
            }
            Ok(Motion::Turn { center })
        }
        AxisMotion::Prismatic { direction } => {
            if !(direction.x.is_finite() && direction.y.is_finite()) {
                return Err(AxesError::NotFinite { part });
            }
            let unit = direction.unit();
            if !unit.length().is_finite() || unit == Vector::ZERO {
                return Err(AxesError::NoDirection { part });
            }
            Ok(Motion::Slide { direction: unit })
        }
    }
}

/// How far sliding parts can be from where they are drawn and still touch, in the frame of the pair.
fn reach(first: &Outline, second: &Outline, motions: &Motions) -> f64 {
    let radius = |o: &Outline| {
        o.features
            .iter()
            .map(|f| {
                let far = |j: u32| o.joints[j as usize].point.to_vector().length();
                let round = if f.is_line() {
                    0.0
                } else {
                    f.center().to_vector().length() + f.radius().abs()
                };
                far(f.start).max(far(f.end)).max(round)
            })
            .fold(0.0, f64::max)
    };
    let arm = |m: &Motion| match m {
        Motion::Turn { center } => 2.0 * center.to_vector().length(),
        _ => 0.0,
    };
    let apart = radius(first) + radius(second) + arm(&motions.first) + arm(&motions.second) + 1.0;
    match (motions.first, motions.second) {
        (Motion::Slide { direction: d }, Motion::Slide { direction: e }) => {
            let cross = d.cross(e).abs();
            if cross < super::condition::INDEPENDENT {
                apart
            } else {
                apart / cross
            }
        }
        _ => apart,
    }
}

fn extent(axis: &Axis, motion: &Motion, unit: f64, reach: f64) -> Extent {
    let limits = |kind| {
        axis.range.map(|(lo, hi)| Extent {
            lo: lo / unit,
            hi: hi / unit,
            kind,
        })
    };
    match motion {
        Motion::Turn { .. } => limits(ExtentKind::TurnLimits).unwrap_or_else(Extent::circle),
        Motion::Slide { .. } => limits(ExtentKind::SlideLimits).unwrap_or(Extent {
            lo: -reach,
            hi: reach,
            kind: ExtentKind::Open,
        }),
        // The coordinate is 0; any interval about it does.
        Motion::Still => Extent {
            lo: -FRAC_PI_2,
            hi: FRAC_PI_2,
            kind: ExtentKind::Open,
        },
    }
}

/// A connected component of free space.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct AxesRegion {
    /// A configuration (u, v) within it.
    pub sample: (f64, f64),
    /// Least and largest u, in radians or the model's unit of length; unrolled where it goes on past a turn.
    pub u: (f64, f64),
    /// Least and largest v.
    pub v: (f64, f64),
    /// Whether u goes on without limit below its least and beyond its greatest value: nothing touches there.
    pub open_u: (bool, bool),
    /// Whether v does.
    pub open_v: (bool, bool),
    /// Whether the part called fixed can turn for ever within it.
    pub around_u: bool,
    /// Whether the moving part can.
    pub around_v: bool,
}

impl FixedAxesSpace {
    /// The connected components of free space.
    pub fn regions(&self) -> Vec<AxesRegion> {
        self.bands
            .regions
            .iter()
            .map(|r| {
                let (x, open_x) = reached(r.x, &self.x, self.motions.first);
                let (y, open_y) = reached(r.y, &self.y, self.motions.second);
                let (lo, hi) = (self.map.outer(x.0, y.0), self.map.outer(x.1, y.1));
                let open = if self.map.swapped {
                    (open_y, open_x)
                } else {
                    (open_x, open_y)
                };
                let around = if self.map.swapped {
                    (r.around_y, r.around_x)
                } else {
                    (r.around_x, r.around_y)
                };
                AxesRegion {
                    sample: self.map.outer(r.sample.0, r.sample.1),
                    u: (lo.0, hi.0),
                    v: (lo.1, hi.1),
                    open_u: open.0,
                    open_v: open.1,
                    around_u: around.0,
                    around_v: around.1,
                }
            })
            .collect()
    }
}

/// The values of a coordinate that a region reaches, and whether it goes on without limit at either end.
fn reached(range: (f64, f64), extent: &Extent, motion: Motion) -> ((f64, f64), (bool, bool)) {
    if motion == Motion::Still {
        return ((0.0, 0.0), (false, false));
    }
    let open = extent.kind == ExtentKind::Open;
    let ends = (range.0 <= extent.lo, range.1 >= extent.hi);
    (range, (open && ends.0, open && ends.1))
}
