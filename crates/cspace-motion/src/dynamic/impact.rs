//! Impacts: of contacts that are closed at one time, and those that accumulate.

use super::flow::ZERO;
use super::motion::Ended;
use super::run::Run;
use super::step::Span;
use super::world::{Acting, Surface, World};
use crate::complementarity::{Bearing, Mode, Problem, Solution};

/// Number of impacts within [`CROWD`] of the simulated time after which impacts no longer bounce.
const MOST_IMPACTS: usize = 300;
/// A share of the time that is simulated.
const CROWD: f64 = 1e-6;

impl<W: World + ?Sized> Run<'_, W> {
    /// Applies Newton's law of impact along normals and Coulomb's for impulses across them, to all closed contacts at
    /// once. Returns whether any contact transmits an impulse.
    pub(super) fn impact(&mut self, closed: &[usize]) -> Result<bool, Ended> {
        let crowded = self.impacts.is_crowded(CROWD * self.span, MOST_IMPACTS);
        let surface = |i: usize| {
            let surface = self.flow.world.surface(i);
            let restitution = if crowded { 0.0 } else { surface.restitution };
            Surface {
                restitution,
                ..surface
            }
        };
        let problem = self.impulses(closed, &surface);
        let solutions = problem.solutions();
        if solutions.is_empty() {
            // Impacts of what is free to move have solutions.
            let contacts = closed.to_vec();
            return Err(Ended::Jammed { contacts });
        }
        let (solution, choice) = self.one(&problem, solutions, closed)?;
        self.choose(choice);
        self.pass(&solution, closed);
        Ok(solution.modes.iter().any(|mode| *mode != Mode::Open))
    }

    /// The closed contacts, if forces within their cones of friction withstand the drives, however large they have to be: there is no velocity
    /// at which neither side of any cone, n ± μ t, closes.
    pub(super) fn wedged(&self) -> Option<Vec<usize>> {
        let world = self.flow.world;
        let closed = world.closed(self.state.t, &self.state.q);
        let withstands = |set: &Vec<usize>| {
            let mut problem = self.impulses(set, &|_| Surface::DEAD);
            let sides = |(&i, bearing): (&usize, &Bearing)| {
                let friction = world.surface(i).friction;
                [friction, -friction].map(|share| Bearing {
                    normal: &bearing.normal + &bearing.tangent * share,
                    b: bearing.b + share * bearing.c,
                    ..bearing.clone()
                })
            };
            problem.bearings = set.iter().zip(&problem.bearings).flat_map(sides).collect();
            problem.solutions().is_empty()
        };
        let sets = world.alternatives(&closed, self.state.t, &self.state.q);
        (!closed.is_empty() && sets.iter().all(withstands)).then_some(closed)
    }

    /// Complementarity problem of velocities and impulses, with the friction and the restitution of each contact.
    pub(super) fn impulses(
        &self,
        closed: &[usize],
        surface: &dyn Fn(usize) -> Surface,
    ) -> Problem<'_> {
        let world = self.flow.world;
        let joints = world.joints(self.state.t, &self.state.q);
        let bearings = (closed.iter())
            .map(|&i| {
                let touch = self.touch(i);
                let rate = touch.opening(&self.state.v);
                touch.struck(rate, surface(i))
            })
            .collect();
        Problem {
            mass: world.mass(),
            h: world.mass() * &self.state.v,
            joints: joints.rows,
            j: joints.rates,
            bearings,
            zero: ZERO,
        }
    }

    /// Velocities after impulses, and what becomes of the energy.
    pub(super) fn pass(&mut self, solution: &Solution, closed: &[usize]) {
        let world = self.flow.world;
        let before = world.kinetic(&self.state);
        let forces = solution.normal.iter().zip(&solution.tangential);
        let acting = Acting {
            accelerations: None,
            contacts: (closed.iter().zip(forces))
                .map(|(&i, (&n, &t))| (i, n, t))
                .collect(),
            joints: &solution.joints,
        };
        let drives = world.powers(&self.state, &acting)[0];
        self.state.v.clone_from(&solution.x);
        self.work.drives += drives;
        self.work.impacts += before + drives - world.kinetic(&self.state);
    }

    /// The short time that accumulating impacts have left, with their contacts closed; and those whose sliding turned back in it.
    pub(super) fn rest_for(&mut self, left: f64, closed: &[usize]) -> Vec<usize> {
        let mut halted = Vec::new();
        let solutions = self.problem(closed).solutions();
        let taken = match &solutions[..] {
            [solution] => {
                let modes = closed.iter().copied().zip(solution.modes.iter().copied());
                let bearings = modes.filter(|(_, mode)| *mode != Mode::Open).collect();
                let span = Span {
                    bearings: &bearings,
                    ..self.span_from(&self.state)
                };
                let step = self.flow.take(span, left);
                if let Some(taken) = &step {
                    let world = self.flow.world;
                    let turned = |&&(i, mode): &&(usize, Mode)| {
                        let touch = world.touch(i, taken.state.t, &taken.state.q);
                        let rate = touch.sliding(&taken.state.v) * mode.direction();
                        world.surface(i).friction > 0.0 && rate < 0.0
                    };
                    halted.extend(bearings.iter().filter(turned).map(|b| b.0));
                }
                step.map(|taken| (taken.state, taken.work))
            }
            // What it does is told at its end.
            _ => None,
        };
        match taken {
            Some((state, work)) => {
                self.state = state;
                self.work.drives += work[0];
                self.work.friction += work[1];
            }
            None => {
                let v = self.state.v.clone();
                self.state.q += v * left;
                self.state.t += left;
            }
        }
        halted
    }
}
