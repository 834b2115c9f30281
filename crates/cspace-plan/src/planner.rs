//! From a question to an answer.

use core::f64::consts::TAU;
use std::collections::BTreeSet;

use cspace::{Coordinates, FeatureName, Location, Metric, PairSpace, QueryError, RegionId};

use crate::answer::{Answer, Blocked, Enclosed, Narrow, Path, Verdict};
use crate::legs::{Coords, Scene};
use crate::off_contact::off_contact;
use crate::path::{Legs, divided};
use crate::route::{Gaps, Piece, Planar, join};

/// Why a question has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// The start cannot be asked about.
    #[error("the start: {0}")]
    From(#[source] QueryError),
    /// The goal cannot be asked about.
    #[error("the goal: {0}")]
    To(#[source] QueryError),
    /// The pair cannot be asked.
    #[error(transparent)]
    Pair(QueryError),
}

/// What is asked of a path beside being free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wishes {
    /// No leg changes a coordinate by more: x, y and θ, or u, v and nothing; infinite for no limit.
    pub steps: [f64; 3],
}

impl Default for Wishes {
    fn default() -> Self {
        Self {
            steps: [f64::INFINITY; 3],
        }
    }
}

/// A pair prepared for questions for ways.
///
/// ```
/// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
/// use cspace_plan::{Planner, Verdict, Wishes};
/// // A block in a box with an opening, which is wider than the block is high.
/// let fixed = Part::polygon("box", &[
///     (-5.0, -5.0), (5.0, -5.0), (5.0, -1.5), (4.0, -1.5), (4.0, -4.0), (-4.0, -4.0),
///     (-4.0, 4.0), (4.0, 4.0), (4.0, 1.5), (5.0, 1.5), (5.0, 5.0), (-5.0, 5.0),
/// ])?;
/// let block = Part::rectangle("block", (0.0, 0.0), 4.0, 2.0)?;
/// let space = PairSpace::compute(&fixed, &block, Relation::Planar, &Options::default())?;
/// let planner = Planner::new(&space)?;
/// let at = |x, theta| Coordinates::Planar(Configuration::new(x, 0.0, theta));
/// let answer = planner.plan(at(0.0, 1.5), at(12.0, 1.5), &Wishes::default())?;
/// let Verdict::Path(path) = answer.verdict else { return Err("it goes out".into()) };
/// assert!(path.narrowest.clearance > 0.2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Planner<'a> {
    space: &'a PairSpace,
    scene: Scene,
    ways: Ways<'a>,
}

#[derive(Debug)]
enum Ways<'a> {
    Planar(Box<Planar<'a>>),
    Axes(Gaps<'a>),
}

/// Where a path begins or ends.
enum End {
    /// In a region; a configuration in contact is left by a leg.
    Free {
        region: RegionId,
        leg: Option<Coords>,
    },
    Blocked,
}

impl<'a> Planner<'a> {
    /// Prepares a pair.
    ///
    /// # Errors
    /// Of a lower pair, whose parts are in contact for ever.
    pub fn new(space: &'a PairSpace) -> Result<Self, PlanError> {
        let scene = Scene::of(space).map_err(PlanError::Pair)?;
        let ways = match space {
            PairSpace::Planar(space) => Ways::Planar(Box::new(Planar::new(space, scene.clone()))),
            PairSpace::FixedAxes(space) => Ways::Axes(Gaps::new(space, &scene)),
            PairSpace::Lower(_) => return Err(PlanError::Pair(QueryError::Permanent)),
        };
        Ok(Self { space, scene, ways })
    }

    /// The two parts with their motions.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The space.
    pub fn space(&self) -> &'a PairSpace {
        self.space
    }

    /// A path from one configuration to another, or that there is none.
    ///
    /// # Errors
    /// If a configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn plan(
        &self,
        from: Coordinates,
        to: Coordinates,
        wishes: &Wishes,
    ) -> Result<Answer, PlanError> {
        let start = self.end(from).map_err(PlanError::From)?;
        let goal = self.end(to).map_err(PlanError::To)?;
        let region = |end: &End| match end {
            End::Free { region, .. } => Some(*region),
            End::Blocked => None,
        };
        let regions = (region(&start), region(&goal));
        let verdict = match (start, goal) {
            (End::Blocked, _) => Verdict::FromBlocked(self.blocked(from).map_err(PlanError::From)?),
            (_, End::Blocked) => Verdict::ToBlocked(self.blocked(to).map_err(PlanError::To)?),
            (
                End::Free {
                    region: a,
                    leg: leave,
                },
                End::Free {
                    region: b,
                    leg: arrive,
                },
            ) => {
                if a == b {
                    let from = self.scene.numbers(from).map_err(PlanError::From)?;
                    let to = self.scene.numbers(to).map_err(PlanError::To)?;
                    match self.path((from, leave), (to, arrive)) {
                        Some(legs) => Verdict::Path(self.told(&legs, wishes)),
                        None => Verdict::Unknown(self.doubtful()),
                    }
                } else {
                    Verdict::NoPath(self.enclosed(a, b).map_err(PlanError::Pair)?)
                }
            }
        };
        Ok(Answer { verdict, regions })
    }

    fn end(&self, at: Coordinates) -> Result<End, QueryError> {
        Ok(match self.space.locate(at)? {
            Location::Outside => return Err(QueryError::Outside),
            Location::Free(region) => End::Free { region, leg: None },
            Location::Blocked => End::Blocked,
            Location::Contact => {
                let Some(off) = off_contact(self.space, &self.scene, at)? else {
                    return Ok(End::Blocked);
                };
                match self.space.locate(self.scene.coordinates(off))? {
                    Location::Free(region) => End::Free {
                        region,
                        leg: Some(off),
                    },
                    _ => End::Blocked,
                }
            }
        })
    }

    /// A path, with the legs that leave and come to contacts.
    fn path(
        &self,
        (from, leave): (Coords, Option<Coords>),
        (to, arrive): (Coords, Option<Coords>),
    ) -> Option<Legs<'_>> {
        /// Places are moved so often for more clearance, by a share that is worth a move.
        const ROUNDS: usize = 10;
        const GAIN: f64 = 0.05;
        let (first, last) = (leave.unwrap_or(from), arrive.unwrap_or(to));
        let between = self.between(first, last)?;
        let end = *between.last()?;
        let mut legs = Legs::new(&self.scene, between);
        legs.raise(ROUNDS, GAIN);
        let mut places = legs.shortened().places().to_vec();
        if leave.is_some() {
            places.insert(0, from);
        }
        if arrive.is_some() {
            // The goal as often around as the place before it.
            places.push(core::array::from_fn(|k| to[k] + (end[k] - last[k])));
        }
        Some(Legs::new(&self.scene, places))
    }

    /// The configurations of a path from one free configuration to another in the same region.
    fn between(&self, from: Coords, to: Coords) -> Option<Vec<Coords>> {
        match &self.ways {
            Ways::Axes(gaps) => self.joined(&gaps.way(from, to)?, to),
            Ways::Planar(planar) => {
                let (lo, hi) = self.scene.limits()[2];
                let turned = |theta: f64, by: f64| if by == 0.0 { theta } else { theta + TAU * by };
                // In a window by its own numbers, else the nearer way around.
                let (shift, ahead) = if lo.is_finite() {
                    let into = |theta: f64| ((lo - theta) / TAU).ceil();
                    let inside = |theta: f64| {
                        if theta >= lo && theta <= hi {
                            0.0
                        } else {
                            into(theta)
                        }
                    };
                    (inside(from[2]), inside(to[2]))
                } else {
                    (0.0, ((from[2] - to[2]) / TAU).round())
                };
                let from = [from[0], from[1], turned(from[2], shift)];
                let to = [to[0], to[1], turned(to[2], ahead)];
                let mut path = self.joined(&planar.way(from, to)?, to)?;
                for place in &mut path {
                    place[2] = turned(place[2], -shift);
                }
                Some(path)
            }
        }
    }

    /// Legs along a way, which end at the goal itself, up to whole turns.
    fn joined(&self, way: &[Box<dyn Piece + '_>], to: Coords) -> Option<Vec<Coords>> {
        let mut path = join(&self.scene, way)?;
        if let Some(last) = path.last_mut() {
            *last = core::array::from_fn(|k| to[k] + TAU * ((last[k] - to[k]) / TAU).round());
        }
        Some(path)
    }

    fn told(&self, legs: &Legs<'_>, wishes: &Wishes) -> Path {
        let at = |c: Coords| self.scene.coordinates(c);
        let places = divided(legs.places(), wishes.steps);
        let narrowest = match legs.narrowest() {
            Some((c, found)) => Narrow {
                clearance: found.distance,
                at: at(c),
                features: found.features,
            },
            None => Narrow {
                clearance: f64::INFINITY,
                at: at([0.0; 3]),
                features: None,
            },
        };
        Path {
            configurations: places.into_iter().map(at).collect(),
            narrowest,
        }
    }

    fn doubtful(&self) -> Vec<(f64, f64)> {
        match self.space {
            PairSpace::Planar(space) => space.doubtful_orientations().to_vec(),
            _ => Vec::new(),
        }
    }

    fn enclosed(&self, a: RegionId, b: RegionId) -> Result<Enclosed, QueryError> {
        let regions = self.space.regions();
        let unbounded = |r: RegionId| regions.get(r.index()).is_some_and(|r| r.unbounded);
        let patches_of = |r: RegionId| {
            (self.space.patches())
                .filter(|p| p.region().is_ok_and(|of| of == Some(r)))
                .collect::<Vec<_>>()
        };
        let (of_a, of_b) = (patches_of(a), patches_of(b));
        let first = (unbounded(a), of_a.len()) <= (unbounded(b), of_b.len());
        let (region, patches) = if first { (a, of_a) } else { (b, of_b) };
        let mut features: BTreeSet<(FeatureName, FeatureName)> = BTreeSet::new();
        for patch in &patches {
            let (fixed, moving) = patch.features()?;
            features.insert((fixed.name, moving.name));
        }
        Ok(Enclosed {
            region,
            patches: patches.len(),
            features: features.into_iter().collect(),
        })
    }

    /// What overlaps at a configuration, and the nearest that is free.
    fn blocked(&self, at: Coordinates) -> Result<Blocked, QueryError> {
        let levers = self.scene.levers();
        let turning = match self.space {
            PairSpace::Planar(_) => levers[2],
            _ => levers[0].max(levers[1]),
        };
        let metric = Metric {
            length_per_radian: if turning > 0.0 { turning } else { 1.0 },
        };
        let mut nearest: Option<(cspace::Projection, cspace::PatchId)> = None;
        for patch in self.space.patches() {
            let found = self.space.project(at, patch.id(), metric)?;
            if nearest.is_none_or(|(n, _)| found.distance < n.distance) {
                nearest = Some((found, patch.id()));
            }
        }
        Ok(match nearest {
            None => Blocked {
                depth: f64::INFINITY,
                nearest: None,
                features: None,
            },
            Some((found, patch)) => {
                let (fixed, moving) = self.space.patch(patch)?.features()?;
                Blocked {
                    depth: found.distance,
                    nearest: Some(found.at),
                    features: Some((fixed.name, moving.name)),
                }
            }
        })
    }
}
