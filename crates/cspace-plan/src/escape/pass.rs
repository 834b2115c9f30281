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

use cspace::{FeatureKind, FeatureName, Location, PairSpace, Point, QueryError, SecondOrder};

use crate::legs::{Coords, Scene};

use super::energy::{Body, Energy};

/// Newton's method takes so many steps at most; it converges in some ten, or not.
const STEPS: usize = 60;
/// It has converged when a step is less than this share of the size, and the contacts are as near.
const CONVERGED: f64 = 1e-13;
/// What is added to the diagonal of its equations, relative to the largest: passes that are the same all along a coordinate leave
/// that coordinate open.
const DAMPING: f64 = 1e-12;
/// So many contacts are looked at, the nearest.
const CONTACTS: usize = 8;

/// A place where the contacts balance the energy.
#[derive(Debug, Clone)]
pub(super) struct Balance {
    pub(super) at: Coords,
    pub(super) energy: f64,
    pub(super) touching: Vec<(FeatureName, FeatureName)>,
}

/// What is 0 at a pass.
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
    pub(super) space: &'a PairSpace,
    pub(super) scene: &'a Scene,
    /// In the coordinates of configurations.
    pub(super) energy: Energy<'a>,
}

impl Passes<'_> {
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
            let patch = self.space.patches().find(|p| {
                p.features()
                    .is_ok_and(|(a, b)| (a.name, b.name) == features)
            })?;
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
            let mut matrix = vec![vec![0.0; count]; count];
            let mut right = vec![0.0; count];
            for j in 0..coordinates {
                right[j] = -energy.gradient[j];
                for k in 0..coordinates {
                    matrix[j][k] = energy.hessian[j][k];
                }
                for (i, f) in values.iter().enumerate() {
                    right[j] += multipliers[i] * f.gradient[j];
                    matrix[j][coordinates + i] = -f.gradient[j];
                    matrix[coordinates + i][j] = f.gradient[j];
                    for k in 0..coordinates {
                        matrix[j][k] -= multipliers[i] * f.hessian[j][k];
                    }
                }
            }
            for (i, f) in values.iter().enumerate() {
                right[coordinates + i] = -f.value;
            }
            let Some(step) = solved(&matrix, &right) else {
                return Ok(None);
            };
            let length = step[..coordinates]
                .iter()
                .fold(0.0, |most: f64, s| most.max(s.abs()));
            if !length.is_finite() || length > size {
                return Ok(None);
            }
            for k in 0..coordinates {
                at[k] += step[k] / self.lever(k);
            }
            let next: Vec<f64> = (0..equations.len())
                .map(|i| multipliers[i] + step[coordinates + i])
                .collect();
            let off = values.iter().map(|f| f.value.abs()).fold(0.0, f64::max);
            let done = length <= CONVERGED * size && off <= CONVERGED * size;
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
    let dot = |a: &[f64; 3], b: &[f64; 3]| (0..coordinates).map(|k| a[k] * b[k]).sum::<f64>();
    let matrix: Vec<Vec<f64>> = (values.iter())
        .map(|a| {
            values
                .iter()
                .map(|b| dot(&a.gradient, &b.gradient))
                .collect()
        })
        .collect();
    let right: Vec<f64> = (values.iter())
        .map(|a| dot(&a.gradient, &energy.gradient))
        .collect();
    solved(&matrix, &right).unwrap_or_else(|| vec![0.0; values.len()])
}

/// The least solution of linear equations in the sense of least squares, by damped normal equations: coordinates that make no
/// difference stay.
fn solved(matrix: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let n = right.len();
    if n == 0 {
        return Some(Vec::new());
    }
    let mut a = vec![vec![0.0; n + 1]; n];
    for i in 0..n {
        for j in 0..n {
            a[i][j] = (0..n).map(|k| matrix[k][i] * matrix[k][j]).sum();
        }
        a[i][n] = (0..n).map(|k| matrix[k][i] * right[k]).sum();
    }
    let largest = (0..n).map(|i| a[i][i]).fold(0.0, f64::max);
    for (i, row) in a.iter_mut().enumerate() {
        row[i] += DAMPING * largest;
    }
    // Gauss with row exchange.
    for c in 0..n {
        let pivot = (c..n).max_by(|&i, &j| a[i][c].abs().total_cmp(&a[j][c].abs()))?;
        a.swap(c, pivot);
        let head = a[c].clone();
        if head[c] == 0.0 || !head[c].is_finite() {
            return None;
        }
        for row in a.iter_mut().skip(c + 1) {
            let share = row[c] / head[c];
            for (x, h) in row.iter_mut().zip(&head) {
                *x -= share * h;
            }
        }
    }
    let mut solution = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| a[i][j] * solution[j]).sum();
        solution[i] = (a[i][n] - known) / a[i][i];
    }
    Some(solution)
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
