//! Coordinates, rates and masses of all parts, from the free ones and the time.

use cspace::Placement;
use nalgebra::{DMatrix, DVector};

use crate::dynamic::State;
use crate::error::SimulateError;
use crate::system::{PartCoordinates, System};

use super::rates::InTime;

/// All coordinates at a time, with their rates and the accelerations of those that are driven.
#[derive(Debug, Clone)]
pub(super) struct All {
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    /// 0 for free coordinates.
    pub(super) a: Vec<f64>,
}

/// All coordinates at a time with the placements of all parts.
#[derive(Debug, Clone)]
pub(super) struct Posed {
    pub(super) all: All,
    /// The coordinates as they change.
    pub(super) at: Vec<InTime>,
    pub(super) parts: Vec<Placement<InTime>>,
}

/// A system with its masses.
#[derive(Debug)]
pub(super) struct Bodies {
    pub(super) system: System,
    /// Diagonal of the mass matrix of all coordinates; 0 for driven parts without mass.
    pub(super) masses: Vec<f64>,
    /// Mass matrix of the free coordinates.
    pub(super) mass: DMatrix<f64>,
    /// The place of each coordinate among the free ones.
    pub(super) place: Vec<Option<usize>>,
}

impl Bodies {
    pub(super) fn new(system: System) -> Result<Self, SimulateError> {
        let mut masses = vec![0.0; system.count()];
        for (i, part) in system.parts().iter().enumerate() {
            let Some(mass) = system.mass(i) else {
                let is_free = |k: usize| system.free().binary_search(&k).is_ok();
                if part.indices().any(is_free) {
                    let part = system.mechanism().parts[i].part.name().to_owned();
                    return Err(SimulateError::NoMass { part });
                }
                continue;
            };
            match *part {
                PartCoordinates::Fixed => {}
                PartCoordinates::Axis { first, motion, .. } => {
                    masses[first] = match motion {
                        cspace::AxisMotion::Revolute { center } => mass.inertia_about(center),
                        _ => mass.mass,
                    };
                }
                PartCoordinates::Planar { first, .. } => {
                    masses[first] = mass.mass;
                    masses[first + 1] = mass.mass;
                    masses[first + 2] = mass.inertia;
                }
            }
        }
        let mut place = vec![None; system.count()];
        for (k, &i) in system.free().iter().enumerate() {
            place[i] = Some(k);
        }
        let diagonal = DVector::from_iterator(
            system.free().len(),
            system.free().iter().map(|&i| masses[i]),
        );
        Ok(Self {
            mass: DMatrix::from_diagonal(&diagonal),
            masses,
            place,
            system,
        })
    }

    /// Values of all coordinates at a time.
    pub(super) fn coordinates(&self, t: f64, free: &DVector<f64>) -> Vec<f64> {
        let mut q = vec![0.0; self.system.count()];
        for (k, &i) in self.system.free().iter().enumerate() {
            q[i] = free[k];
        }
        self.system.drive(t, &mut q);
        q
    }

    /// Values, rates and accelerations of all coordinates in a state.
    pub(super) fn all(&self, state: &State) -> All {
        let count = self.system.count();
        let (mut q, mut v, mut a) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
        for (k, &i) in self.system.free().iter().enumerate() {
            q[i] = state.q[k];
            v[i] = state.v[k];
        }
        for (i, curve) in self.system.drives() {
            let at = curve.at(state.t);
            (q[*i], v[*i], a[*i]) = (at.value, at.rate, at.acceleration);
        }
        All { q, v, a }
    }

    /// Coordinates and placements of all parts in a state.
    pub(super) fn posed(&self, state: &State) -> Posed {
        let all = self.all(state);
        let changing = all.q.iter().zip(&all.v);
        let changing = changing.map(|(&value, &v)| InTime { value, slope: [v] });
        let at: Vec<InTime> = changing.collect();
        let parts = self.system.parts().iter();
        Posed {
            parts: parts.map(|p| p.placement(|i| at[i])).collect(),
            at,
            all,
        }
    }

    /// The free ones of some numbers of all coordinates.
    pub(super) fn free(&self, all: &[f64]) -> DVector<f64> {
        let free = self.system.free();
        DVector::from_iterator(free.len(), free.iter().map(|&i| all[i]))
    }
}
