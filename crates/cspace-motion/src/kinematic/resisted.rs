//! Sets of contacts with friction that can hold, from one short step against a slight resistance.
//!
//! Each contact is open, sticks or slides one way or the other: too many combinations to try them all. With a resistance r against every
//! displacement Δ, Coulomb's law for the end of a step is a problem of complementarity that has a solution wherever drives do not jam:
//!
//! ```text
//! r Δ = F + Σ μ ∇joints + Σ λ_N n + Σ λ_T τ
//! ```
//!
//! in the coordinates y of [`Local`], with the forces, normals and tangents at the end: springs by their stiffness, and all as it is where
//! the same step leads without. r is so small that it takes no share in what bears: forces that nothing withstands would move parts by the
//! size of the mechanism, while drives go on by a millionth of it. Where forces are speeds there is a resistance already, and the step is a
//! velocity. What is found is only tried: the exact balance judges it.

use nalgebra::{DMatrix, DVector};

use crate::complementarity::{Bearing, Mode, Problem, Solution};
use crate::contact::Bound;
use crate::linear::add_scaled;
use crate::pairs::{Grip, Pairs};
use crate::system::{Law, Row, System};

use super::holding::friction;
use super::velocity::Local;

/// Displacement of drives in the step, relative to the size of the mechanism.
const STEP: f64 = 1e-6;
/// Parts that go farther than this, relative to the size of the mechanism, are not in balance at the end of the step.
const FALLS: f64 = 1e-3;
/// Inequalities hold to this share.
const ZERO: f64 = 1e-9;
/// A force is on the edge of what its mode allows within this share of the largest: what the step changes.
const EDGE: f64 = STEP;

/// Most choices of one bound from each group that are tried.
const MOST_CHOICES: usize = 64;

/// Bounds that are closed at a configuration and a time, and brakes that hold there.
#[derive(Clone, Copy)]
pub(super) struct Closing<'a> {
    pub(super) system: &'a System,
    pub(super) pairs: &'a Pairs,
    /// Bounds that push alike at one place, of which one holds at most.
    pub(super) groups: &'a [Vec<Bound>],
    pub(super) brakes: &'a [Bound],
    pub(super) q: &'a [f64],
    pub(super) time: f64,
}

/// Where a step leads, with the modes of the bounds in it.
struct Step {
    modes: Vec<Mode>,
    /// Displacement of all coordinates.
    by: Vec<f64>,
}

impl Closing<'_> {
    /// Sets of bounds that hold as the motion goes on: first of all groups, then of all but one, since of features that touch at one
    /// corner not all need to be constraints.
    pub(super) fn sets(&self) -> impl Iterator<Item = Vec<Bound>> {
        let lengths = self.groups.iter().map(Vec::len);
        let choices = lengths
            .fold(1_usize, usize::saturating_mul)
            .min(MOST_CHOICES);
        let without = (0..self.groups.len()).map(|out| (0, Some(out)));
        let chosen = (0..choices).map(|choice| (choice, None)).chain(without);
        chosen.flat_map(|(mut choice, out)| {
            let mut bounds = Vec::new();
            for (i, group) in self.groups.iter().enumerate() {
                if Some(i) != out {
                    bounds.push(group[choice % group.len()]);
                }
                choice /= group.len();
            }
            self.sets_of(&bounds)
        })
    }

    /// Sets of some bounds.
    fn sets_of(&self, bounds: &[Bound]) -> Vec<Vec<Bound>> {
        let still = vec![0.0; self.q.len()];
        let mut steps = self.steps(bounds, &still);
        let far = FALLS * self.system.size();
        let near = steps.iter().filter(|s| self.system.speed(&s.by) <= far);
        let again: Vec<Step> = near.flat_map(|s| self.steps(bounds, &s.by)).collect();
        steps.splice(0..0, again);
        let held = |(bound, mode): (&Bound, &Mode)| match (bound, mode) {
            (_, Mode::Open) => None,
            (Bound::Contact(touch), mode) if friction(self.pairs, bound) > 0.0 => {
                Some(Bound::Contact(touch.with(match mode {
                    Mode::Forward => Grip::Slides { forward: true },
                    Mode::Backward => Grip::Slides { forward: false },
                    Mode::Open | Mode::Stick => Grip::Sticks,
                })))
            }
            (bound, _) => Some(*bound),
        };
        let set = |step: &Step| bounds.iter().zip(&step.modes).filter_map(held).collect();
        steps.iter().map(set).collect()
    }

    /// Steps with some bounds, as forces and gradients are after a displacement; those in which few bounds hold first.
    fn steps(&self, bounds: &[Bound], about: &[f64]) -> Vec<Step> {
        let (system, pairs) = (self.system, self.pairs);
        let mut q = self.q.to_vec();
        add_scaled(&mut q, 1.0, about);
        let Some(local) = Local::at(system, &q, self.time) else {
            return Vec::new();
        };
        let n = local.forces.len();
        let (mut forces, mut time) = (local.free.clone(), 1.0);
        let mut resistance = DMatrix::identity(n, n);
        if system.law() == Law::Balance {
            let size = system.size();
            let speed = |rates: &[f64]| system.speed(rates) / size;
            let driven = speed(&local.driven);
            time = if driven > 0.0 { STEP / driven } else { 0.0 };
            let mut all = system.forces(&q);
            let mut stiffness = DMatrix::zeros(n, n);
            let mut from_drives = vec![0.0; n];
            for pull in system.pulls(&q).iter().filter(|p| p.stiffness > 0.0) {
                pull.along
                    .push_on(&mut all, pull.stiffness * pull.along.rate(about));
                let (along, rate) = local.reduced(&pull.along);
                add_scaled(&mut from_drives, pull.stiffness * rate * time, &along);
                let along = DVector::from_vec(along);
                stiffness.ger(pull.stiffness, &along, &along, 1.0);
            }
            let loads = speed(&local.displaced(&local.forces));
            // Springs that are not tensioned yet bear all the same.
            let least = STEP * stiffness.amax();
            match loads.max(least) {
                0.0 => {}
                slight => resistance *= slight,
            }
            resistance += stiffness;
            forces = local.reduced_force(&all);
            add_scaled(&mut forces, 1.0, &from_drives);
        }
        let brakes = self.brakes.iter();
        let brakes = brakes.map(|b| local.reduced(&b.function(system, pairs, &q)));
        let joints: Vec<(Vec<f64>, f64)> = local.joints.iter().cloned().chain(brakes).collect();
        let bearing = |bound: &Bound| {
            let along = match bound {
                Bound::Contact(touch) => pairs.list()[touch.pair].sliding(touch, system, &q),
                Bound::Limit { .. } | Bound::Brake { .. } => Row::default(),
            };
            let rows = [bound.function(system, pairs, &q), along];
            let [(normal, b), (tangent, c)] = rows.map(|row| local.reduced(&row));
            Bearing {
                normal: DVector::from_vec(normal),
                tangent: DVector::from_vec(tangent),
                b: -time * b,
                c: -time * c,
                friction: friction(pairs, bound),
                slides: None,
                lets_go: false,
            }
        };
        let problem = Problem {
            mass: &resistance,
            h: DVector::from_vec(forces),
            joints: DMatrix::from_fn(joints.len(), n, |i, k| joints[i].0[k]),
            j: DVector::from_fn(joints.len(), |i, _| time * joints[i].1),
            bearings: bounds.iter().map(bearing).collect(),
            zero: ZERO,
        };
        let step = |solution: &Solution| {
            let mut by = local.displaced(solution.x.as_slice());
            add_scaled(&mut by, time, &local.driven);
            [loose(&problem, solution), solution.modes.clone()].map(|modes| Step {
                modes,
                by: by.clone(),
            })
        };
        let mut steps: Vec<Step> = problem.solutions().iter().flat_map(step).collect();
        let count =
            |step: &Step, is: fn(&Mode) -> bool| step.modes.iter().filter(|m| is(m)).count();
        steps.sort_by_key(|step| {
            let holding = count(step, |mode| *mode != Mode::Open);
            (holding, count(step, |mode| *mode == Mode::Stick))
        });
        steps
    }
}

/// Modes on the edge of those of a solution: what bears nothing opens, and what has used up its friction slides.
fn loose(problem: &Problem<'_>, solution: &Solution) -> Vec<Mode> {
    let forces = solution.normal.iter().zip(&solution.tangential);
    let none = EDGE * solution.normal.iter().fold(0.0, |m, n| n.max(m));
    let each = solution.modes.iter().zip(&problem.bearings).zip(forces);
    each.map(|((&mode, bearing), (&normal, &tangential))| match mode {
        _ if normal <= none => Mode::Open,
        Mode::Stick if bearing.friction * normal - tangential.abs() <= none => {
            if tangential < 0.0 {
                Mode::Forward
            } else {
                Mode::Backward
            }
        }
        mode => mode,
    })
    .collect()
}
