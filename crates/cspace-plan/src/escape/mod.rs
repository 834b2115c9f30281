//! How much energy lets a part out: caging and escape.
//!
//! In a field of force a part is held by less than a closed region: a ball in a bowl is out when it is lifted over the rim. The least
//! energy of a way is the lowest of all passes, the highest energy that the way has to reach. [`Escape`] finds it from both sides:
//! no way through boxes of configurations that are not shown to be blocked has less, and a way through boxes that are free has
//! no more. Between the bounds lies the pass itself, where contacts balance the energy; it is found to rounding.

mod answer;
mod boxes;
mod domain;
mod energy;
mod flood;
mod leaks;
mod pass;
mod search;
mod way;

pub use answer::{Escaped, Held, Pass};
pub use energy::{Body, Field, Spring, Weight};

use cspace::{Coordinates, PairSpace, Progress, QueryError, RegionId};

use crate::apart::{blocked, enclosed};
use crate::ends::{End, end, home};
use crate::legs::{Coords, Scene};
use crate::planner::PlanError;

use domain::Domain;
use energy::Energy;
use pass::Passes;
use search::{Bracket, Question};

/// Bounds are brought this near, as a share of what it costs to lift the parts by their size.
const WITHIN: f64 = 1e-2;
/// Where no single pass lies between bounds they are brought so much nearer, twice at most.
const NEARER: f64 = 0.25;

/// A pair in a field of force.
#[derive(Debug)]
pub struct Escape<'a> {
    space: &'a PairSpace,
    scene: Scene,
    field: &'a Field,
    within: Option<f64>,
}

impl<'a> Escape<'a> {
    /// Prepares a pair.
    ///
    /// # Errors
    /// Of a lower pair, whose parts are in contact for ever.
    pub fn new(space: &'a PairSpace, field: &'a Field) -> Result<Self, PlanError> {
        Ok(Self {
            space,
            scene: Scene::of(space).map_err(PlanError::Pair)?,
            field,
            within: None,
        })
    }

    /// Brings the bounds as near as this, in units of energy; a hundredth of what it costs to lift the parts by their size otherwise.
    #[must_use]
    pub fn with_bounds_within(mut self, within: f64) -> Self {
        self.within = Some(within);
        self
    }

    fn energy(&self, domain: Option<&Domain>) -> Energy<'a> {
        Energy {
            field: self.field,
            motions: self.scene.motions(),
            pivot: domain.map_or(cspace::Vector::ZERO, |d| d.pivot),
        }
    }

    /// The least energy of a way from a configuration to another, or out: to where circles around the parts are apart.
    ///
    /// # Errors
    /// If a configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion; if
    /// the pair has fixed axes, where nothing is out, and no goal is given; and what `progress` returns.
    pub fn from(
        &self,
        from: Coordinates,
        to: Option<Coordinates>,
        progress: &dyn Progress,
    ) -> Result<Escaped, PlanError> {
        let (_, from) = home(self.space, &self.scene, from);
        let to = to.map(|to| home(self.space, &self.scene, to).1);
        let start = match end(self.space, &self.scene, from).map_err(PlanError::From)? {
            End::Blocked => {
                let how = blocked(self.space, &self.scene, from).map_err(PlanError::From)?;
                return Ok(Escaped::FromBlocked(how));
            }
            End::Free { region, leg } => (region, self.end(from, leg).map_err(PlanError::From)?),
        };
        let goal = match to {
            None if self.scene.motions().is_some() => return Err(PlanError::NoGoal),
            None => None,
            Some(to) => match end(self.space, &self.scene, to).map_err(PlanError::To)? {
                End::Blocked => {
                    let how = blocked(self.space, &self.scene, to).map_err(PlanError::To)?;
                    return Ok(Escaped::ToBlocked(how));
                }
                End::Free { region, leg } => {
                    Some((region, self.end(to, leg).map_err(PlanError::To)?))
                }
            },
        };
        if let Some(caged) = self
            .caged(start.0, goal.map(|g| g.0))
            .map_err(PlanError::Pair)?
        {
            return Ok(Escaped::Caged(caged));
        }
        let domain = Domain::new(
            &self.scene,
            self.field,
            start.1.0,
            goal.map(|(_, (to, _))| to),
        );
        let energy = self.energy(Some(&domain));
        let within = self.within.unwrap_or_else(|| {
            let at = domain.within(start.1.0);
            WITHIN * self.scene.size() * steepest(&energy, at)
        });
        let least_within = within * NEARER * NEARER;
        let mut question = Question {
            scene: &self.scene,
            within,
            energy,
            from: start.1.0,
            off: start.1.1,
            to: goal.map(|g| g.1),
            domain,
        };
        loop {
            let bracket = question.bracket(progress).map_err(PlanError::Stopped)?;
            let apart = bracket.most - bracket.least;
            let held = self.told(&question, bracket)?;
            let is_last = apart > question.within || question.within <= least_within;
            if held.energy().is_some() || is_last {
                return Ok(Escaped::Held(held));
            }
            question.within *= NEARER;
        }
    }

    /// A configuration, and the free end of a leg that leaves its contacts.
    fn end(&self, at: Coordinates, leg: Option<Coords>) -> Result<(Coords, Coords), QueryError> {
        let at = self.scene.numbers(at)?;
        Ok((at, leg.unwrap_or(at)))
    }

    /// What keeps a start and a goal apart whatever the energy.
    fn caged(
        &self,
        from: RegionId,
        to: Option<RegionId>,
    ) -> Result<Option<crate::Enclosed>, QueryError> {
        let regions = self.space.regions();
        let out = |r: &RegionId| regions.get(r.index()).is_some_and(|r| r.unbounded);
        let to = match to {
            Some(to) => Some(to),
            None if out(&from) => None,
            None => regions.iter().map(|r| r.id).find(out),
        };
        match to {
            Some(to) if to != from => enclosed(self.space, from, to).map(Some),
            _ => Ok(None),
        }
    }

    fn told(&self, question: &Question<'_>, bracket: Bracket) -> Result<Held, PlanError> {
        let start = self.energy(None).value(question.from);
        let passes = Passes {
            space: self.space,
            scene: &self.scene,
            energy: self.energy(None),
        };
        let way = way::way(question, &self.energy(None), &bracket);
        let most = way.as_ref().map_or(f64::INFINITY, |w| w.energy);
        let slack = 1e-9 * question.within;
        // Each place at which the least energy can be: the ends, and the passes between the bounds.
        let mut at: Vec<Pass> = Vec::new();
        let ends = [Some(question.from), question.to.map(|t| t.0)];
        for end in ends.into_iter().flatten() {
            at.push(Pass {
                at: self.scene.coordinates(end),
                energy: passes.energy.value(end) - start,
                touching: Vec::new(),
            });
        }
        for &(place, extent) in &bracket.high {
            let place = question.domain.configuration(place);
            let reach = 4.0 * extent;
            for b in passes.near(place, reach).map_err(PlanError::Pair)? {
                at.push(Pass {
                    at: self.scene.coordinates(b.at),
                    energy: b.energy - start,
                    touching: b.touching,
                });
            }
        }
        let (least, most) = (bracket.least - start, most - start);
        at.retain(|p| p.energy >= least - slack && p.energy <= most + slack);
        at.sort_by(|a, b| a.energy.total_cmp(&b.energy));
        at.dedup_by(|a, b| (a.energy - b.energy).abs() <= slack);
        Ok(Held {
            least: least.max(0.0),
            most,
            passes: at,
            path: way.map_or_else(Vec::new, |w| {
                w.places
                    .into_iter()
                    .map(|c| self.scene.coordinates(c))
                    .collect()
            }),
        })
    }
}

/// The largest force on a coordinate, per length that it moves the parts.
fn steepest(energy: &Energy<'_>, at: Coords) -> f64 {
    let gradient = energy.second_order(at).gradient;
    gradient[0].hypot(gradient[1])
}
