//! One step with constant bearing contacts.

use nalgebra::DVector;

use crate::dormand_prince::{DIFFERENCE, STAGES};

use super::super::flow::{Bearings, Flow};
use super::super::world::{Acting, State, World};

/// Allowed error of a step, as a share of the size, and of the largest rate so far.
const TOLERANCE: f64 = 1e-11;
/// Start of a step: the state, and the contacts that bear.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Span<'s> {
    pub(in super::super) from: &'s State,
    pub(in super::super) bearings: &'s Bearings,
    /// Largest rate so far.
    pub(in super::super) fastest: f64,
}

/// The end of a step.
#[derive(Debug, Clone)]
pub(in super::super) struct Taken {
    pub(in super::super) state: State,
    /// Error, as a share of the allowed one.
    pub(super) error: f64,
    pub(super) open: f64,
    pub(in super::super) work: [f64; 2],
    /// The rates and accelerations of all stages.
    pub(super) slopes: Vec<(DVector<f64>, DVector<f64>)>,
    /// The time since the start of all stages, and the forces λ_N and λ_T of the bearing contacts.
    pub(super) forces: Vec<(f64, Vec<f64>, Vec<f64>)>,
}

impl<W: World + ?Sized> Flow<'_, W> {
    /// Takes one step of a length.
    pub(in super::super) fn take(&self, span: Span<'_>, h: f64) -> Option<Taken> {
        let Span { from, bearings, .. } = span;
        let mut slopes: Vec<(DVector<f64>, DVector<f64>)> = Vec::with_capacity(7);
        let mut forces = Vec::with_capacity(7);
        let mut work = [0.0; 2];
        let mut at = from.clone();
        // The weights of the last stage are those of the step.
        let shares = STAGES.last().map_or(&[][..], |s| s.1);
        let mut slope = |at: &State, k: usize| {
            let solution = self.accelerations(at, bearings)?;
            if let Some(share) = shares.get(k).filter(|s| **s != 0.0) {
                let acting = Acting::of(&solution, bearings);
                let powers = self.world.powers(at, &acting);
                work[0] += share * h * powers[0];
                work[1] += share * h * powers[1];
            }
            forces.push((at.t - from.t, solution.normal, solution.tangential));
            Some((at.v.clone(), solution.x))
        };
        slopes.push(slope(&at, 0)?);
        for (k, (time, weights)) in STAGES.iter().enumerate() {
            at.t = from.t + time * h;
            at.q.copy_from(&from.q);
            at.v.copy_from(&from.v);
            for (&weight, slope) in weights.iter().zip(&slopes) {
                at.q.axpy(h * weight, &slope.0, 1.0);
                at.v.axpy(h * weight, &slope.1, 1.0);
            }
            slopes.push(slope(&at, k + 1)?);
        }
        let (mut q, mut v) = (DVector::zeros(at.q.len()), DVector::zeros(at.q.len()));
        for (weight, slope) in DIFFERENCE.iter().zip(&slopes) {
            q.axpy(h * weight, &slope.0, 1.0);
            v.axpy(h * weight, &slope.1, 1.0);
        }
        let error = (self.world.reach(&q) / self.world.size())
            .max(self.world.reach(&v) / span.fastest)
            / TOLERANCE;
        if error.is_nan() {
            return None;
        }
        // The last stage is the end of the step.
        let (state, open) = self.projected(at, bearings)?;
        Some(Taken {
            state,
            error,
            open,
            work,
            slopes,
            forces,
        })
    }
}
