//! The motion while the contacts stay what they are.

use nalgebra::{DMatrix, DVector};

use super::modes::{Bearing, Mode, Problem, Solution};
use super::world::{State, Touch, World};

/// Directions change by differences over so long a way, as a share of the size: their error is its square.
const WAY: f64 = 1e-5;
/// Inequalities hold to this share.
pub(super) const ZERO: f64 = 1e-9;
/// Newton's method for gaps and joints converges in two or three steps.
const PROJECTIONS: usize = 8;

/// A contact that bears, with what it does.
pub(super) type Bearings = Vec<(usize, Mode)>;

/// A world with the contacts that bear in it.
pub(super) struct Flow<'a, W: World + ?Sized> {
    pub(super) world: &'a W,
    /// The inverse of its mass matrix.
    inverse: DMatrix<f64>,
}

impl<'a, W: World + ?Sized> Flow<'a, W> {
    /// None if the mass matrix has no inverse.
    pub(super) fn new(world: &'a W) -> Option<Self> {
        let inverse = world.mass().clone().try_inverse()?;
        Some(Self { world, inverse })
    }

    /// The problem of accelerations for some contacts; those that slide faster than `still` have their direction.
    pub(super) fn problem(&self, state: &State, contacts: &[usize], still: f64) -> Problem<'_> {
        let State { t, q, v } = state;
        let speed = v.amax();
        let ahead = if speed > 0.0 {
            WAY * self.world.size() / speed
        } else {
            0.0
        };
        let beside = [q - v * ahead, q + v * ahead];
        let change = |of: &dyn Fn(&DVector<f64>) -> DVector<f64>| -> f64 {
            if ahead == 0.0 {
                return 0.0;
            }
            (of(&beside[1]) - of(&beside[0])).dot(v) / (2.0 * ahead)
        };
        let bearings = (contacts.iter())
            .map(|&i| {
                let touch = self.world.touch(i, q);
                let rate = touch.tangent.dot(v);
                Bearing {
                    b: change(&|q| self.world.touch(i, q).normal),
                    c: change(&|q| self.world.touch(i, q).tangent),
                    normal: touch.normal,
                    tangent: touch.tangent,
                    friction: self.world.surface(i).friction,
                    slides: (rate.abs() > still).then_some(rate.signum()),
                }
            })
            .collect();
        let (_, joints) = self.world.joints(*t, q);
        let (_, mut j) = self.world.drift(*t);
        for k in 0..joints.nrows() {
            j[k] -= change(&|q| self.world.joints(*t, q).1.row(k).transpose());
        }
        Problem {
            mass: self.world.mass(),
            h: self.world.force(*t, q, v),
            joints,
            j,
            bearings,
            zero: ZERO,
        }
    }

    /// Accelerations and forces with contacts in their modes.
    pub(super) fn accelerations(&self, state: &State, bearings: &Bearings) -> Option<Solution> {
        let contacts: Vec<usize> = bearings.iter().map(|b| b.0).collect();
        let modes: Vec<Mode> = bearings.iter().map(|b| b.1).collect();
        self.problem(state, &contacts, f64::INFINITY).within(&modes)
    }

    /// The nearest state, in the metric of the masses, in which joints hold and the contacts that bear are closed.
    pub(super) fn projected(&self, mut state: State, bearings: &Bearings) -> Option<State> {
        let world = self.world;
        for round in 0..PROJECTIONS {
            let touches: Vec<Touch> = bearings
                .iter()
                .map(|b| world.touch(b.0, &state.q))
                .collect();
            let (values, joints) = world.joints(state.t, &state.q);
            let gaps = touches.iter().map(|t| t.gap);
            let off = DVector::from_iterator(
                values.len() + touches.len(),
                values.iter().copied().chain(gaps),
            );
            let rows = rows(&joints, &touches, bearings, false);
            if rows.nrows() == 0 {
                return Some(state);
            }
            let step = self.least(&rows, &-&off)?;
            state.q += step;
            if round > 0 && off.amax() <= 4.0 * f64::EPSILON * world.size() {
                break;
            }
        }
        let touches: Vec<Touch> = bearings
            .iter()
            .map(|b| world.touch(b.0, &state.q))
            .collect();
        let (_, joints) = world.joints(state.t, &state.q);
        let (rates, _) = world.drift(state.t);
        let rows = rows(&joints, &touches, bearings, true);
        let mut off = &rows * &state.v;
        for k in 0..rates.len() {
            off[k] -= rates[k];
        }
        let step = self.least(&rows, &-off)?;
        state.v += step;
        Some(state)
    }

    /// The least change, in the metric of the masses, that changes what rows measure.
    fn least(&self, rows: &DMatrix<f64>, by: &DVector<f64>) -> Option<DVector<f64>> {
        let across = &self.inverse * rows.transpose();
        let svd = (rows * &across).try_svd(true, true, 5.0 * f64::EPSILON, 500)?;
        let least = 1e-12 * svd.singular_values.max();
        Some(across * svd.solve(by, least).ok()?)
    }
}

/// The rows of joints, contacts, and of those that stick their tangents.
fn rows(
    joints: &DMatrix<f64>,
    touches: &[Touch],
    bearings: &Bearings,
    sticks: bool,
) -> DMatrix<f64> {
    let mut rows: Vec<DVector<f64>> = (0..joints.nrows())
        .map(|k| joints.row(k).transpose())
        .collect();
    rows.extend(touches.iter().map(|t| t.normal.clone()));
    if sticks {
        let stuck = touches
            .iter()
            .zip(bearings)
            .filter(|(_, b)| b.1 == Mode::Stick);
        rows.extend(stuck.map(|(t, _)| t.tangent.clone()));
    }
    DMatrix::from_fn(rows.len(), joints.ncols(), |i, k| rows[i][k])
}
