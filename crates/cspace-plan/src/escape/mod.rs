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
mod model;
mod pass;
mod search;
mod way;

pub use answer::{Escaped, Held, Pass};
pub use energy::{Body, Field, Spring, Weight};
pub use model::FieldError;

use cspace::{Coordinates, PairSpace, Progress, QueryError, RegionId, Silent, Vector};

use crate::answer::Verdict;
use crate::apart::{blocked, enclosed};
use crate::ends::{ENOUGH, End, end, home};
use crate::legs::{Coords, Scene};
use crate::off_contact::off_near;
use crate::planner::{Clearance, PlanError, Planner, Wishes};

use domain::Domain;
use energy::Energy;
use pass::Passes;
use search::{Bracket, Question};

/// Bounds are brought this near, as a share of what the field does on a way as long as the parts.
const WITHIN: f64 = 2e-3;
/// Or this near, as a share of the energy itself.
const SHARE: f64 = 0.03;
/// A way is no higher than at its ends within this share of how near bounds are.
const LEVEL: f64 = 1e-6;
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
    /// For a lower pair, whose parts are in permanent contact.
    pub fn new(space: &'a PairSpace, field: &'a Field) -> Result<Self, PlanError> {
        Ok(Self {
            space,
            scene: Scene::of(space).map_err(PlanError::Pair)?,
            field,
            within: None,
        })
    }

    /// Brings the bounds as near as this, in units of energy; if it is not asked for, some hundredths of the energy
    /// itself.
    #[must_use]
    pub fn with_bounds_within(mut self, within: f64) -> Self {
        self.within = Some(within);
        self
    }

    fn energy(&self, domain: Option<&Domain>) -> Energy<'a> {
        Energy {
            field: self.field,
            motions: self.scene.motions(),
            pivot: domain.map_or(Vector::ZERO, |d| d.pivot),
        }
    }

    /// The least energy of a way from a configuration to another, or out: to where circles around the parts are apart.
    ///
    /// # Errors
    /// If a configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion; if
    /// the pair has fixed axes, where nothing is out, and no goal is given; if the field has no force.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Point, Relation, Vector, Vertex};
    /// use cspace_plan::escape::{Body, Escape, Escaped, Field, Weight};
    /// // A disc of radius 3 on two pegs of radius 1, 3 apart, under its weight of 2.
    /// let circle = |x: f64, r: f64| vec![Vertex::new(x - r, 0.0, 1.0), Vertex::new(x + r, 0.0, 1.0)];
    /// let pegs = Part::new("pegs", vec![circle(-1.5, 1.0), circle(1.5, 1.0)])?;
    /// let disc = Part::new("disc", vec![circle(0.0, 3.0)])?;
    /// let space = PairSpace::compute(&pegs, &disc, Relation::Planar, &Options::default())?;
    /// let weight = Weight { on: Body::Moving, at: Point::ORIGIN, force: Vector::new(0.0, -2.0) };
    /// let field = Field { weights: vec![weight], springs: Vec::new() };
    /// let rest = f64::sqrt(16.0 - 1.5 * 1.5);
    /// let start = Coordinates::Planar(Configuration::new(0.0, rest, 0.0));
    /// let Escaped::Held(held) = Escape::new(&space, &field)?.from(start, None)? else {
    ///     return Err("it is held".into());
    /// };
    /// let energy = held.energy.ok_or("there is one pass")?;
    /// assert!((energy - 2.0 * (4.0 - rest)).abs() < 1e-9);
    /// assert!(held.least <= energy && energy <= held.most);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from(&self, from: Coordinates, to: Option<Coordinates>) -> Result<Escaped, PlanError> {
        self.from_with(from, to, &Silent)
    }

    /// As [`from`](Self::from), telling `progress` that it goes on.
    ///
    /// # Errors
    /// As [`from`](Self::from); and what `progress` returns.
    pub fn from_with(
        &self,
        from: Coordinates,
        to: Option<Coordinates>,
        progress: &dyn Progress,
    ) -> Result<Escaped, PlanError> {
        if strength(&self.energy(None), [0.0; 3], self.scene.size()) == 0.0 {
            return Err(PlanError::NoForce);
        }
        let (_, from) = home(self.space, &self.scene, from);
        let to = to.map(|to| home(self.space, &self.scene, to).1);
        let enough = ENOUGH * self.scene.size();
        let start = match end(self.space, &self.scene, from, enough).map_err(PlanError::From)? {
            End::Blocked => {
                let how = blocked(self.space, &self.scene, from).map_err(PlanError::From)?;
                return Ok(Escaped::FromBlocked(how));
            }
            End::Free { region, leg, .. } => {
                (region, self.end(from, leg).map_err(PlanError::From)?)
            }
        };
        let goal = match to {
            None if self.scene.motions().is_some() => return Err(PlanError::NoGoal),
            None => None,
            Some(to) => match end(self.space, &self.scene, to, enough).map_err(PlanError::To)? {
                End::Blocked => {
                    let how = blocked(self.space, &self.scene, to).map_err(PlanError::To)?;
                    return Ok(Escaped::ToBlocked(how));
                }
                End::Free { region, leg, .. } => {
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
            let size = self.scene.size();
            WITHIN * size * strength(&energy, at, size)
        });
        let known = self.known(&start.1, goal.as_ref().map(|g| g.1.0), &domain, progress)?;
        let least_within = within * NEARER * NEARER;
        let mut question = Question {
            scene: &self.scene,
            within,
            share: if self.within.is_some() { 0.0 } else { SHARE },
            energy,
            plain: self.energy(None),
            known,
            from: start.1.0,
            off: start.1.1,
            to: goal.map(|g| g.1),
            domain,
        };
        loop {
            let bracket = question.bracket(progress).map_err(PlanError::Stopped)?;
            let is_last = !bracket.is_closed || question.within <= least_within;
            let held = self.told(&question, bracket)?;
            if held.energy.is_some() || is_last {
                return Ok(Escaped::Held(held));
            }
            question.within *= NEARER;
            question.share *= NEARER;
        }
    }

    /// A free path that a planner finds, whatever its energy; empty if it finds none.
    fn known(
        &self,
        &(from, _): &(Coords, Coords),
        to: Option<Coords>,
        domain: &Domain,
        progress: &dyn Progress,
    ) -> Result<Vec<Coords>, PlanError> {
        let to = to.unwrap_or_else(|| {
            let slope = self.energy(None).second_order(from).gradient;
            let down = Vector::new(-slope[0], -slope[1]);
            let direction = if down.length() > 0.0 {
                down.unit()
            } else {
                Vector::new(0.0, -1.0)
            };
            domain.outside(direction, from[2])
        });
        let wishes = Wishes {
            clearance: Clearance::Quick,
            ..Wishes::default()
        };
        let [from, to] = [from, to].map(|c| self.scene.coordinates(c));
        let answer = Planner::with_about(self.space, self.scene.about())?
            .plan_with(from, to, &wishes, progress)?;
        let Verdict::Path(path) = answer.verdict else {
            return Ok(Vec::new());
        };
        (path.configurations.into_iter())
            .map(|at| self.scene.numbers(at).map_err(PlanError::Pair))
            .collect()
    }

    /// A configuration, and the free end of a leg that leaves its contacts.
    fn end(&self, at: Coordinates, leg: Option<Coords>) -> Result<(Coords, Coords), QueryError> {
        let at = self.scene.numbers(at)?;
        Ok((at, leg.unwrap_or_else(|| off_near(&self.scene, at))))
    }

    /// Finds the enclosure that keeps a start and a goal apart at any energy.
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
        let start = question.plain.value(question.from);
        let passes = Passes::new(self.space, &self.scene, self.energy(None));
        let passes = passes.map_err(PlanError::Pair)?;
        let way = way::way(question, &bracket);
        let most = way.as_ref().map_or(f64::INFINITY, |w| w.energy);
        let slack = 1e-9 * question.within;
        // Each place at which the least energy can be: the ends, and the passes between the bounds.
        let mut at: Vec<Pass> = Vec::new();
        let ends = [Some(question.from), question.to.map(|t| t.0)];
        let is_end = |at: Coordinates| {
            ends.iter()
                .flatten()
                .any(|&end| self.scene.coordinates(end) == at)
        };
        for end in ends.into_iter().flatten() {
            at.push(Pass {
                at: self.scene.coordinates(end),
                energy: question.plain.value(end) - start,
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
        let energy = match at.as_slice() {
            // That a way is nowhere higher than at its ends is known of a way alone, and not of passes.
            [pass] if is_end(pass.at) && most - pass.energy > LEVEL * question.within => None,
            [pass] if bracket.is_closed => Some(pass.energy),
            _ => None,
        };
        // A pass is as exact as rounding, and bounds are no better.
        let (least, most) = match energy {
            Some(e) => (least.max(0.0).min(e), most.max(e)),
            None => (least.max(0.0), most),
        };
        Ok(Held {
            energy,
            least,
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

/// How strong a field is: a force that the parts meet when they move by their size.
fn strength(energy: &Energy<'_>, at: Coords, size: f64) -> f64 {
    let weights = energy.field.weights.iter().map(|w| w.force.length());
    let springs = (energy.field.springs.iter()).map(|s| {
        let [p, q] = s.ends.map(|end| energy.place(end, at));
        let stretch = (p[0] - q[0]).hypot(p[1] - q[1]) - s.length;
        s.stiffness * (stretch.abs() + size)
    });
    weights.chain(springs).sum()
}
