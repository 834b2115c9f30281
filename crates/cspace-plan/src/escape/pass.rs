//! The pass itself: where the energy is balanced by contacts.
//!
//! At the highest place of the lowest way the energy has no way down that the contacts leave open, to first order:
//!
//! ```text
//! ∇U = Σ λᵢ ∇fᵢ,   fᵢ = 0,   λᵢ ≥ 0
//! ```
//!
//! with the contact functions f of at most as many contacts as there are coordinates. Newton's method finds it to rounding from a
//! place nearby.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use cspace::{
    FeatureKind, FeatureName, Location, PairSpace, PatchId, Point, QueryError, SecondOrder,
};

use crate::legs::{Coords, Scene};

use super::energy::{Body, Energy};

/// Newton's method takes so many steps at most; it converges in some ten, or not.
const STEPS: usize = 60;
/// It has converged when a step is less than this share of the size, and the contacts are as near.
const CONVERGED: f64 = 1e-13;
/// And when the forces balance but for this share of the largest.
const BALANCED: f64 = 1e-9;
/// Singular values below this share of the largest are none: passes that are the same all along a coordinate leave that coordinate
/// open.
const RANK: f64 = 1e-10;
/// Singular values are found in some ten sweeps.
const SWEEPS: usize = 200;
/// So many contacts are looked at, the nearest.
const CONTACTS: usize = 8;

/// A place where the contacts balance the energy.
#[derive(Debug, Clone)]
pub(super) struct Balance {
    pub(super) at: Coords,
    pub(super) energy: f64,
    pub(super) touching: Vec<(FeatureName, FeatureName)>,
}

/// A function that is 0 at a pass.
enum Constraint {
    /// A contact function.
    Contact(cspace::FeatureContact),
    /// How far two vertices are apart along x, or along y.
    Vertices {
        fixed: Point,
        moving: Point,
        along: usize,
    },
}

/// A contact: one equation, or two of vertices that meet.
struct Contact {
    features: (FeatureName, FeatureName),
    equations: Vec<Constraint>,
}

/// Where passes are looked for.
pub(super) struct Passes<'a> {
    space: &'a PairSpace,
    scene: &'a Scene,
    energy: Energy<'a>,
    /// A patch of each two features that touch.
    patches: BTreeMap<(FeatureName, FeatureName), PatchId>,
}

impl<'a> Passes<'a> {
    /// Prepares a pair, with its energy in the coordinates of configurations.
    pub(super) fn new(
        space: &'a PairSpace,
        scene: &'a Scene,
        energy: Energy<'a>,
    ) -> Result<Self, QueryError> {
        let mut patches = BTreeMap::new();
        for patch in space.patches() {
            let (fixed, moving) = patch.features()?;
            patches
                .entry((fixed.name, moving.name))
                .or_insert(patch.id());
        }
        Ok(Self {
            space,
            scene,
            energy,
            patches,
        })
    }

    fn contact(&self, features: (FeatureName, FeatureName)) -> Option<Contact> {
        let both = features.0.kind == FeatureKind::Vertex && features.1.kind == FeatureKind::Vertex;
        let equations = if both {
            let corner = |part: &cspace::Part, name: FeatureName| {
                let outline = part.loops().get(name.loop_index as usize)?;
                outline
                    .vertices()
                    .get(name.index as usize)
                    .map(|v| v.point())
            };
            let (fixed, moving) = (
                corner(self.space.fixed(), features.0)?,
                corner(self.space.moving(), features.1)?,
            );
            (0..2)
                .map(|along| Constraint::Vertices {
                    fixed,
                    moving,
                    along,
                })
                .collect()
        } else {
            let patch = self.space.patch(*self.patches.get(&features)?).ok()?;
            vec![Constraint::Contact(patch.contact().ok()?)]
        };
        Some(Contact {
            features,
            equations,
        })
    }

    /// The balances that are found from a place, no farther off than `reach`.
    pub(super) fn near(&self, at: Coords, reach: f64) -> Result<Vec<Balance>, QueryError> {
        let mut near = self.scene.near(at, reach);
        near.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let mut contacts: Vec<Contact> = Vec::new();
        for n in near {
            if contacts.len() < CONTACTS
                && contacts.iter().all(|c| c.features != n.features)
                && let Some(contact) = self.contact(n.features)
            {
                contacts.push(contact);
            }
        }
        let coordinates = if self.scene.motions().is_some() { 2 } else { 3 };
        let mut found: Vec<Balance> = Vec::new();
        for set in subsets(contacts.len(), coordinates) {
            let chosen: Vec<&Contact> = set.iter().map(|&i| &contacts[i]).collect();
            let equations: Vec<&Constraint> = chosen.iter().flat_map(|c| &c.equations).collect();
            if equations.len() > coordinates {
                continue;
            }
            if let Some(to) = self.balanced(at, &equations, coordinates)?
                && self.is_near(at, to, reach)
                && self.is_open(to)?
            {
                found.push(Balance {
                    at: to,
                    energy: self.energy.value(to),
                    touching: chosen.iter().map(|c| c.features).collect(),
                });
            }
        }
        Ok(found)
    }

    fn is_near(&self, at: Coords, to: Coords, reach: f64) -> bool {
        let levers = self.scene.levers();
        (0..3).all(|k| (to[k] - at[k]).abs() * levers[k] <= reach)
    }

    /// Whether the parts are not in each other.
    fn is_open(&self, at: Coords) -> Result<bool, QueryError> {
        let at = self.scene.coordinates(at);
        Ok(!matches!(self.space.locate(at)?, Location::Blocked))
    }

    /// Newton's method for the equations of a balance.
    fn balanced(
        &self,
        from: Coords,
        equations: &[&Constraint],
        coordinates: usize,
    ) -> Result<Option<Coords>, QueryError> {
        let count = coordinates + equations.len();
        let size = self.scene.size();
        // The energy in units in which forces are about 1, angles as the ways that they move the parts.
        let first = self.scaled(self.energy.second_order(from), 1.0);
        let force = first
            .gradient
            .iter()
            .fold(0.0, |most: f64, g| most.max(g.abs()));
        let force = if force > 0.0 { force } else { 1.0 };
        let mut at = from;
        let mut forces: Option<Vec<f64>> = None;
        for _ in 0..STEPS {
            let energy = self.scaled(self.energy.second_order(at), force);
            let mut values = Vec::with_capacity(equations.len());
            for e in equations {
                values.push(self.scaled(self.value(e, at)?, 1.0));
            }
            let multipliers = match &forces {
                Some(f) => f.clone(),
                None => least_squares(&values, &energy, coordinates),
            };
            // The Hessian of U − Σ λ f bordered by the gradients.
            let mut matrix = DMatrix::zeros(count, count);
            let mut right = DVector::zeros(count);
            for j in 0..coordinates {
                right[j] = -energy.gradient[j];
                for k in 0..coordinates {
                    matrix[(j, k)] = energy.hessian[j][k];
                }
                for (i, f) in values.iter().enumerate() {
                    right[j] += multipliers[i] * f.gradient[j];
                    matrix[(j, coordinates + i)] = -f.gradient[j];
                    matrix[(coordinates + i, j)] = f.gradient[j];
                    for k in 0..coordinates {
                        matrix[(j, k)] -= multipliers[i] * f.hessian[j][k];
                    }
                }
            }
            for (i, f) in values.iter().enumerate() {
                right[coordinates + i] = -f.value;
            }
            let Some(step) = solved(matrix, &right) else {
                return Ok(None);
            };
            let length = step.rows(0, coordinates).amax();
            if !length.is_finite() || length > size {
                return Ok(None);
            }
            for (k, x) in at.iter_mut().enumerate().take(coordinates) {
                *x += step[k] / self.lever(k);
            }
            let next: Vec<f64> = (0..equations.len())
                .map(|i| multipliers[i] + step[coordinates + i])
                .collect();
            let off = values.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
            let unbalanced = right.rows(0, coordinates).amax();
            let done =
                length <= CONVERGED * size && off <= CONVERGED * size && unbalanced <= BALANCED;
            if done {
                // Two vertices that meet push in any direction between their edges; which, the way found tells.
                let pushes = equations
                    .iter()
                    .zip(&next)
                    .all(|(e, &force)| matches!(e, Constraint::Vertices { .. }) || force >= 0.0);
                return Ok(pushes.then_some(at));
            }
            forces = Some(next);
        }
        Ok(None)
    }

    fn lever(&self, k: usize) -> f64 {
        let lever = self.scene.levers()[k];
        if lever > 0.0 { lever } else { 1.0 }
    }

    /// Derivatives by lengths, of a function in a unit.
    fn scaled(&self, f: SecondOrder<3>, unit: f64) -> SecondOrder<3> {
        let lever: Coords = core::array::from_fn(|k| self.lever(k));
        SecondOrder {
            value: f.value / unit,
            gradient: core::array::from_fn(|k| f.gradient[k] / (unit * lever[k])),
            hessian: core::array::from_fn(|j| {
                core::array::from_fn(|k| f.hessian[j][k] / (unit * lever[j] * lever[k]))
            }),
        }
    }

    fn value(&self, constraint: &Constraint, at: Coords) -> Result<SecondOrder<3>, QueryError> {
        match constraint {
            Constraint::Contact(contact) => {
                let found = contact.evaluate(self.scene.coordinates(at))?;
                Ok(SecondOrder {
                    value: found.value,
                    gradient: found.gradient,
                    hessian: found.hessian,
                })
            }
            Constraint::Vertices {
                fixed,
                moving,
                along,
            } => {
                let variables = core::array::from_fn(|k| SecondOrder::variable(at[k], k));
                let p = self.energy.place((Body::Fixed, *fixed), variables);
                let q = self.energy.place((Body::Moving, *moving), variables);
                Ok(q[*along] - p[*along])
            }
        }
    }
}

/// The multipliers that balance the energy best.
fn least_squares(
    values: &[SecondOrder<3>],
    energy: &SecondOrder<3>,
    coordinates: usize,
) -> Vec<f64> {
    let matrix = DMatrix::from_fn(coordinates, values.len(), |k, i| values[i].gradient[k]);
    let right = DVector::from_column_slice(&energy.gradient[..coordinates]);
    match solved(matrix, &right) {
        Some(found) => found.as_slice().to_vec(),
        None => vec![0.0; values.len()],
    }
}

/// The shortest solution of linear equations in the sense of least squares: coordinates that make no difference stay.
fn solved(matrix: DMatrix<f64>, right: &DVector<f64>) -> Option<DVector<f64>> {
    if matrix.ncols() == 0 {
        return Some(DVector::zeros(0));
    }
    if matrix.iter().chain(right.iter()).any(|x| !x.is_finite()) {
        return None;
    }
    let svd = matrix.try_svd(true, true, 5.0 * f64::EPSILON, SWEEPS)?;
    let least = RANK * svd.singular_values.max();
    svd.solve(right, least).ok()
}

/// All sets of at most so many numbers below a count.
fn subsets(count: usize, most: usize) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = vec![Vec::new()];
    let mut last = 0;
    for _ in 0..most {
        let end = all.len();
        for i in last..end {
            let next = all[i].last().map_or(0, |&l| l + 1);
            for j in next..count {
                let mut set = all[i].clone();
                set.push(j);
                all.push(set);
            }
        }
        last = end;
    }
    all
}
