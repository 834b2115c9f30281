//! Sets of many contacts with friction that can hold, from one short step against a slight resistance.
//!
//! Of more contacts than a few not all combinations can be tried. With a resistance r against every displacement Δ, Coulomb's law for the
//! end of a step is a problem of complementarity that has a solution wherever drives do not jam:
//!
//! ```text
//! (r + K) Δ = F + Σ μ ∇joints + Σ λ_N n + Σ λ_T τ
//! ```
//!
//! in the coordinates y of [`Local`], with the forces F and the stiffness K of springs. r is so small that it takes no share in what bears:
//! forces that nothing withstands would move parts by the size of the mechanism, while drives go on by a millionth of it. Where forces are
//! speeds there is a resistance already, and the step is a velocity. What is found is only tried: the exact balance judges it.

use nalgebra::{DMatrix, DVector};

use crate::complementarity::{Bearing, Mode, Problem};
use crate::contact::Bound;
use crate::linear::add_scaled;
use crate::pairs::{Grip, Pairs};
use crate::system::{Law, Row, System};

use super::holding::friction;
use super::velocity::Local;

/// Displacement of drives in the step, relative to the size of the mechanism.
const STEP: f64 = 1e-6;
/// Inequalities hold to this share.
const ZERO: f64 = 1e-9;

/// A step with joints, springs and drives, to which contacts are added.
struct Step<'a> {
    local: &'a Local<'a>,
    /// Its time, by which rates are multiplied.
    time: f64,
    /// r + K.
    resistance: DMatrix<f64>,
    /// F, with what drives do to springs.
    forces: DVector<f64>,
    /// The equations of joints and brakes.
    joints: DMatrix<f64>,
    changes: DVector<f64>,
}

impl<'a> Step<'a> {
    fn of(
        system: &System,
        pairs: &Pairs,
        local: &'a Local<'a>,
        brakes: &[Bound],
        q: &[f64],
    ) -> Self {
        let n = local.forces.len();
        let mut resistance = DMatrix::identity(n, n);
        let (mut forces, mut time) = (local.free.clone(), 1.0);
        if system.law() == Law::Balance {
            forces.clone_from(&local.forces);
            let size = system.size();
            let [drives, loads] = [&local.driven, &local.displaced(&local.forces)]
                .map(|rates| system.speed(rates) / size);
            time = if drives > 0.0 { STEP / drives } else { 0.0 };
            if loads > 0.0 {
                resistance *= loads;
            }
            for pull in system.pulls(q).iter().filter(|p| p.stiffness > 0.0) {
                let (along, rate) = local.reduced(&pull.along);
                add_scaled(&mut forces, pull.stiffness * rate * time, &along);
                let along = DVector::from_vec(along);
                resistance.ger(pull.stiffness, &along, &along, 1.0);
            }
        }
        let brakes = brakes
            .iter()
            .map(|b| local.reduced(&b.function(system, pairs, q)));
        let joints: Vec<(Vec<f64>, f64)> = local.joints.iter().cloned().chain(brakes).collect();
        Self {
            local,
            time,
            resistance,
            forces: DVector::from_vec(forces),
            joints: DMatrix::from_fn(joints.len(), n, |i, k| joints[i].0[k]),
            changes: DVector::from_fn(joints.len(), |i, _| time * joints[i].1),
        }
    }

    /// Sets of some bounds that hold at its end, those of few first.
    fn sets(&self, bearings: &[Bearing], bounds: &[Bound]) -> Vec<Vec<Bound>> {
        let problem = Problem {
            mass: &self.resistance,
            h: self.forces.clone(),
            joints: self.joints.clone(),
            j: self.changes.clone(),
            bearings: bearings.to_vec(),
            zero: ZERO,
        };
        let mut sets = problem.solutions();
        let count =
            |modes: &[Mode], is: &dyn Fn(Mode) -> bool| modes.iter().filter(|m| is(**m)).count();
        sets.sort_by_key(|s| {
            let holding = count(&s.modes, &|m| m != Mode::Open);
            (holding, count(&s.modes, &|m| m == Mode::Stick))
        });
        let held = |((bound, bearing), mode): ((&Bound, &Bearing), &Mode)| match (bound, mode) {
            (_, Mode::Open) => None,
            (Bound::Contact(touch), mode) if bearing.friction > 0.0 => {
                Some(Bound::Contact(touch.with(match mode {
                    Mode::Forward => Grip::Slides { forward: true },
                    Mode::Backward => Grip::Slides { forward: false },
                    Mode::Open | Mode::Stick => Grip::Sticks,
                })))
            }
            (bound, _) => Some(*bound),
        };
        let each = || bounds.iter().zip(bearings);
        let set = |modes: &[Mode]| each().zip(modes).filter_map(held).collect();
        sets.iter().map(|s| set(&s.modes)).collect()
    }

    fn bearing(&self, row: &Row, along: &Row, friction: f64) -> Bearing {
        let [(normal, b), (tangent, c)] = [row, along].map(|row| self.local.reduced(row));
        Bearing {
            normal: DVector::from_vec(normal),
            tangent: DVector::from_vec(tangent),
            b: -self.time * b,
            c: -self.time * c,
            friction,
            slides: None,
            lets_go: false,
        }
    }
}

/// Most choices of one bound from each group that are tried.
const MOST_CHOICES: usize = 64;

/// Sets of bounds that hold as the motion goes on, with brakes that hold, one at most of each group: first of all groups, then of all but one,
/// since of features that touch at one corner not all need to be constraints.
pub(super) fn sets(
    system: &System,
    pairs: &Pairs,
    local: &Local<'_>,
    (groups, brakes): (Vec<Vec<Bound>>, &[Bound]),
    q: &[f64],
) -> impl Iterator<Item = Vec<Bound>> {
    let step = Step::of(system, pairs, local, brakes, q);
    let groups: Vec<Vec<(Bound, Bearing)>> = (groups.into_iter())
        .map(|group| {
            let bearing = |bound: Bound| {
                let along = match &bound {
                    Bound::Contact(touch) => pairs.list()[touch.pair].sliding(touch, system, q),
                    Bound::Limit { .. } | Bound::Brake { .. } => Row::default(),
                };
                let row = bound.function(system, pairs, q);
                (bound, step.bearing(&row, &along, friction(pairs, &bound)))
            };
            group.into_iter().map(bearing).collect()
        })
        .collect();
    let choices = groups
        .iter()
        .fold(1_usize, |n, g| n.saturating_mul(g.len()));
    let chosen = (0..choices.min(MOST_CHOICES)).map(|choice| (choice, None));
    let without = (0..groups.len()).map(|out| (0, Some(out)));
    chosen.chain(without).flat_map(move |(mut choice, out)| {
        let (mut bounds, mut bearings) = (Vec::new(), Vec::new());
        for (i, group) in groups.iter().enumerate() {
            let (bound, bearing) = &group[choice % group.len()];
            choice /= group.len();
            if Some(i) != out {
                bounds.push(*bound);
                bearings.push(bearing.clone());
            }
        }
        step.sets(&bearings, &bounds)
    })
}
