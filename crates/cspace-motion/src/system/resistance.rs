//! The metric of motions without inertia: the outlines, and what springs and dampers resist.

use cspace_model::{Spring, SpringKind};

use super::coordinates::{Law, System};
use super::layout::PartCoordinates;
use super::metric::{Metric, add_outline};
use crate::linear::Cholesky;

impl System {
    /// Stores the system's metric if it does not depend on the configuration: if all parts have axes, and no resisting
    /// spring is linear.
    pub(super) fn with_metric(mut self) -> Self {
        let (drag, still) = (self.drag(), vec![0.0; self.count()]);
        let is_planar = |p: &PartCoordinates| matches!(p, PartCoordinates::Planar { .. });
        let turns = |spring: &Spring| match spring.kind {
            SpringKind::Torsion { .. } => true,
            SpringKind::Linear {
                stiffness, damping, ..
            } => damping + drag * stiffness == 0.0,
        };
        let springs = &self.mechanism().dynamics.springs;
        let is_constant = !self.parts().iter().any(is_planar) && springs.iter().all(turns);
        self.metric = is_constant
            .then(|| {
                let (matrix, _) = self.metric_and_forces(&still);
                let factor = self.factor(&matrix)?;
                Some(Metric { matrix, factor })
            })
            .flatten();
        self
    }

    /// The metric, if it is the same everywhere.
    pub(crate) fn metric(&self) -> Option<&Metric> {
        self.metric.as_ref()
    }

    /// The factor of the free coordinates' part of a matrix of all, n × n by rows; `None` if that is not positive definite.
    pub(crate) fn factor(&self, matrix: &[f64]) -> Option<Cholesky> {
        let (n, free) = (self.count(), self.free());
        let of_free: Vec<f64> = (free.iter())
            .flat_map(|&i| free.iter().map(move |&j| matrix[i * n + j]))
            .collect();
        Cholesky::of(&of_free, free.len())
    }

    /// Resistance of springs per stiffness.
    fn drag(&self) -> f64 {
        match self.law() {
            Law::Speeds { drag, .. } => drag,
            Law::Balance => 0.0,
        }
    }

    /// The mass matrix of the outlines at unit density with the resistance of dampers, n × n by rows, and the forces of
    /// loads, weights and springs on the coordinates.
    pub(crate) fn metric_and_forces(&self, q: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = self.count();
        let (mut matrix, mut forces) = (vec![0.0; n * n], vec![0.0; n]);
        for (part, moments) in self.parts().iter().zip(&self.moments) {
            add_outline(&mut matrix, n, part, moments, q);
        }
        let drag = self.drag();
        for pull in self.pulls(q) {
            pull.along.push_on(&mut forces, pull.force());
            let resistance = pull.damping + drag * pull.stiffness;
            for &(i, a) in pull.along.entries() {
                for &(j, b) in pull.along.entries() {
                    matrix[i * n + j] += resistance * a * b;
                }
            }
        }
        (matrix, forces)
    }
}
