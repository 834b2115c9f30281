//! The motion while the contacts stay what they are.

use std::collections::HashMap;

use nalgebra::{DMatrix, DVector};

use crate::linear::{Cholesky, Rows, length};

use super::direct::Lightness;
use super::world::{Joints, State, Touch, World};
use crate::complementarity::{Bearing, Mode, Problem, Solution};

/// Inequalities hold to this share.
pub(super) const ZERO: f64 = 1e-9;
/// A contact whose tangent is but for this share what bears cannot slide.
const IDLE: f64 = 1e-9;
/// Newton's method for gaps and joints converges in two or three steps.
const PROJECTIONS: usize = 8;

/// Rounding of a rate, as a share of the sizes of its terms.
const SUMMED: f64 = 16.0 * f64::EPSILON;

/// Bearing contacts with their modes.
pub(super) type Bearings = Vec<(usize, Mode)>;

/// A world with the contacts that bear in it.
pub(super) struct Flow<'a, W: World + ?Sized> {
    pub(super) world: &'a W,
    /// The inverse of its mass matrix.
    inverse: DMatrix<f64>,
    /// The factor L of its mass matrix.
    factor: Cholesky,
    /// Inverse of a diagonal mass matrix.
    lightness: Option<Lightness>,
    /// The gaps at which contacts that bear are held, where these are not 0.
    pub(super) seats: HashMap<usize, f64>,
}

impl<'a, W: World + ?Sized> Flow<'a, W> {
    /// Creates the flow; `None` if the mass matrix has no inverse.
    pub(super) fn new(world: &'a W) -> Option<Self> {
        let inverse = world.mass().clone().try_inverse()?;
        let factor = Cholesky::of(world.mass().as_slice(), world.mass().nrows())?;
        Some(Self {
            world,
            inverse,
            factor,
            lightness: Lightness::of(world.mass()),
            seats: HashMap::new(),
        })
    }

    /// The accelerations by forces alone, without joints and contacts.
    pub(super) fn pushed(&self, force: &DVector<f64>) -> DVector<f64> {
        &self.inverse * force
    }

    /// The problem of accelerations for some contacts; those that slide faster than `still` have their direction.
    pub(super) fn problem(&self, state: &State, contacts: &[usize], still: f64) -> Problem<'_> {
        let equations = self.world.equations(state, contacts);
        let bearings = (contacts.iter().zip(equations.contacts))
            .map(|(&i, (touch, [b, c]))| {
                let rate = touch.sliding(&state.v);
                Bearing {
                    b,
                    c,
                    normal: touch.normal,
                    tangent: touch.tangent,
                    friction: self.world.surface(i).friction,
                    slides: (rate.abs() > still).then_some(rate.signum()),
                    lets_go: false,
                }
            })
            .collect();
        Problem {
            mass: self.world.mass(),
            h: equations.force,
            joints: equations.joints,
            j: equations.joint_bends,
            bearings,
            zero: ZERO,
        }
    }

    /// Accelerations and forces with contacts in their modes.
    pub(super) fn accelerations(&self, state: &State, bearings: &Bearings) -> Option<Solution> {
        let contacts: Vec<usize> = bearings.iter().map(|b| b.0).collect();
        if let Some(lightness) = &self.lightness {
            let equations = self.world.equations(state, &contacts);
            let friction = |i: usize| self.world.surface(i).friction;
            if let Some(found) = lightness.accelerations(&equations, bearings, friction) {
                return Some(found);
            }
        }
        let modes: Vec<Mode> = bearings.iter().map(|b| b.1).collect();
        self.problem(state, &contacts, f64::INFINITY).within(&modes)
    }

    fn touches(&self, state: &State, bearings: &Bearings) -> Vec<Touch> {
        let contacts: Vec<usize> = bearings.iter().map(|b| b.0).collect();
        self.world.touches(&contacts, state.t, &state.q)
    }

    /// Contacts with the force of sliding that cannot slide, because the sticking contacts and the joints leave them no
    /// freedom.
    pub(super) fn idle(&self, state: &State, bearings: &Bearings) -> Vec<usize> {
        let touches = self.touches(state, bearings);
        let joints = self.world.joints(state.t, &state.q).rows;
        let stuck = stuck(&touches, bearings);
        let held = rows(&joints, &touches, &stuck);
        let scaled = |row: DVector<f64>| -> Vec<f64> {
            let mut row = row.as_slice().to_vec();
            self.factor.forward(&mut row);
            row
        };
        let mut all = Rows::default();
        for row in held.row_iter() {
            all.push(&scaled(row.transpose()));
        }
        let is_idle = |touch: &Touch| {
            let mut tangent = scaled(touch.tangent.clone());
            let before = length(&tangent);
            all.take_out(&mut tangent);
            length(&tangent) <= IDLE * before
        };
        (touches.iter().zip(bearings))
            .filter(|(touch, b)| b.1 != Mode::Stick && touch.drift[1] == 0.0 && is_idle(touch))
            .map(|(_, b)| b.0)
            .collect()
    }

    /// Determinant of the joints' equations, each scaled to length 1 in the metric of the masses, where joints leave no
    /// freedom beside drives. It is 0 where parts can go on in more than one direction, or in none.
    pub(super) fn fold(&self, state: &State) -> f64 {
        let mut rows = self.world.joints(state.t, &state.q).rows;
        for mut row in rows.row_iter_mut() {
            let mut scaled: Vec<f64> = row.iter().copied().collect();
            self.factor.forward(&mut scaled);
            let long = length(&scaled);
            for (entry, value) in row.iter_mut().zip(scaled) {
                *entry = value / long;
            }
        }
        rows.determinant()
    }

    /// Projects a state to the nearest one, in the metric of the masses, at which joints hold and bearing contacts have
    /// their seated gaps; also returns the largest violation before.
    pub(super) fn projected(&self, mut state: State, bearings: &Bearings) -> Option<(State, f64)> {
        let world = self.world;
        let mut open = 0.0;
        let at = |state: &State| -> (Joints, Vec<Touch>) {
            let joints = world.joints(state.t, &state.q);
            (joints, self.touches(state, bearings))
        };
        let (mut joints, mut touches) = at(&state);
        if joints.values.is_empty() && touches.is_empty() {
            return Some((state, open));
        }
        let closed = 4.0 * f64::EPSILON * world.size();
        for round in 0..PROJECTIONS {
            let seat = |contact: usize| self.seats.get(&contact).copied().unwrap_or(0.0);
            let gaps = (touches.iter().zip(bearings)).map(|(t, b)| t.gap - seat(b.0));
            let off = DVector::from_iterator(
                joints.values.len() + touches.len(),
                joints.values.iter().copied().chain(gaps),
            );
            if round == 0 {
                open = off.amax();
            }
            if off.amax() <= closed {
                break;
            }
            state.q += self.least(&joints.rows, &touches, &[], &-&off, closed)?;
            (joints, touches) = at(&state);
        }
        let stuck = stuck(&touches, bearings);
        let jointed = &joints.rows * &state.v - &joints.rates;
        let opening = touches.iter().map(|t| t.opening(&state.v));
        let sliding = stuck.iter().map(|t| t.sliding(&state.v));
        let off = DVector::from_iterator(
            jointed.len() + touches.len() + stuck.len(),
            jointed.iter().copied().chain(opening).chain(sliding),
        );
        let rows = (touches.iter().map(|t| (&t.normal, t.drift[0])))
            .chain(stuck.iter().map(|t| (&t.tangent, t.drift[1])));
        let sizes = rows.map(|(row, drift)| {
            let terms = row.iter().zip(&state.v);
            terms.map(|(r, v)| (r * v).abs()).sum::<f64>() + drift.abs()
        });
        let slack = SUMMED * sizes.fold(0.0, f64::max);
        let step = self.least(&joints.rows, &touches, &stuck, &-off, slack)?;
        state.v += step;
        Some((state, open))
    }

    /// The least change, in the metric of the masses, that changes what joints, gaps and what sticks measure; to a slack, where more hold
    /// than there are freedoms.
    fn least(
        &self,
        joints: &DMatrix<f64>,
        touches: &[Touch],
        stuck: &[&Touch],
        by: &DVector<f64>,
        slack: f64,
    ) -> Option<DVector<f64>> {
        if let Some(lightness) = &self.lightness
            && let Some(found) = lightness.least(joints, touches, stuck, by, slack)
        {
            return Some(found);
        }
        let rows = rows(joints, touches, stuck);
        let across = &self.inverse * rows.transpose();
        let svd = (rows * &across).try_svd(true, true, 5.0 * f64::EPSILON, 500)?;
        let least = 1e-12 * svd.singular_values.max();
        Some(across * svd.solve(by, least).ok()?)
    }
}

/// Sticking contacts among those that bear.
fn stuck<'t>(touches: &'t [Touch], bearings: &Bearings) -> Vec<&'t Touch> {
    let all = touches.iter().zip(bearings);
    all.filter(|(_, b)| b.1 == Mode::Stick)
        .map(|(touch, _)| touch)
        .collect()
}

/// The rows of joints, contacts, and of those that stick their tangents.
fn rows(joints: &DMatrix<f64>, touches: &[Touch], stuck: &[&Touch]) -> DMatrix<f64> {
    let mut rows: Vec<DVector<f64>> = (0..joints.nrows())
        .map(|k| joints.row(k).transpose())
        .collect();
    rows.extend(touches.iter().map(|t| t.normal.clone()));
    rows.extend(stuck.iter().map(|t| t.tangent.clone()));
    DMatrix::from_fn(rows.len(), joints.ncols(), |i, k| rows[i][k])
}
