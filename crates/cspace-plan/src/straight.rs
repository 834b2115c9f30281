//! A path about a point of the moving part as configurations whose coordinates change straight.

use cspace::{Coordinates, Vector};

use crate::answer::Path;
use crate::check::{Checked, check, touches};
use crate::legs::{Coords, Scene, configuration_about, numbers_about};
use crate::planner::PlanError;
use crate::route::along;

/// By this share of its clearance a path is off the one that it stands for.
const OFF: f64 = 0.1;
/// A leg is halved at most so often.
const HALVINGS: u32 = 50;
/// More configurations than these are no path that anyone reads.
const MOST: usize = 1 << 20;

/// Configurations so dense that motions of constant rates of x, y and θ between them are as free as the legs of a path, which move the
/// point b = [`Scene::about`] straight.
///
/// At the same orientation the two differ by a displacement of at most |b| Δ² / 8, where Δ is the turn between two configurations. It is
/// kept below a tenth of the clearance there, and what begins or ends in contact is judged by itself ([`check`]). Of a path about the
/// origin, and on fixed axes, the configurations are those of the path.
///
/// # Errors
/// If a configuration is one of another class; if there would be more than a million.
///
/// ```
/// use cspace::{Configuration, Coordinates, Part, Vector};
/// use cspace_plan::{Checked, check, legs::Scene, straight};
/// // A bar that is drawn beside its origin turns on the spot, in a slot.
/// let bar = Part::rectangle("bar", (20.0, 0.0), 3.0, 1.0)?;
/// let slot = Part::polygon("slot", &[
///     (-5.0, -3.0), (5.0, -3.0), (5.0, 3.0), (2.0, 3.0), (2.0, -2.0), (-2.0, -2.0), (-2.0, 3.0), (-5.0, 3.0),
/// ])?;
/// let middle = Scene::new(&slot, &bar, None).with_about(Vector::new(20.0, 0.0));
/// let turn = [[-20.0, 0.0, 0.0], [0.0, -20.0, 0.5 * core::f64::consts::PI]]
///     .map(|[x, y, theta]| Coordinates::Planar(Configuration::new(x, y, theta)));
/// let origin = middle.clone().with_about(Vector::ZERO);
/// assert!(matches!(check(&middle, &turn)?, Checked::Free(_)));
/// assert!(matches!(check(&origin, &turn)?, Checked::Meets(_)));
/// assert!(matches!(check(&origin, &straight(&middle, &turn)?)?, Checked::Free(_)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn straight(scene: &Scene, path: &[Coordinates]) -> Result<Vec<Coordinates>, PlanError> {
    if scene.motions().is_some() {
        return Ok(path.to_vec());
    }
    let origin = scene.clone().with_about(Vector::ZERO);
    let touch = |at: &Coordinates| origin.numbers(*at).is_ok_and(|at| touches(&origin, at));
    dense(path, scene.about(), |[from, to], off| {
        let ends = [from, to].map(|at| scene.coordinates(at));
        off <= scene.rounding(from, to)
            || scene.is_clearly_apart(from, to, off / OFF)
            || ends.iter().any(touch) && matches!(check(&origin, &ends), Ok(Checked::Free(_)))
    })
}

impl Path {
    /// As [`straight`](crate::straight()), without the parts: configurations so dense that the path between them is off by less than a tenth
    /// of its least clearance, which is not 0.
    ///
    /// # Errors
    /// As there.
    pub fn straight(&self) -> Result<Vec<Coordinates>, PlanError> {
        dense(&self.configurations, self.about, |_, off| {
            off <= OFF * self.narrowest.clearance
        })
    }
}

/// Configurations of a path about a point, so dense that a motion of x, y and θ between two of them is accepted: it is given the place of
/// the point and the orientation at both, and how far it is off at most.
fn dense(
    path: &[Coordinates],
    about: Vector,
    accepts: impl Fn([Coords; 2], f64) -> bool,
) -> Result<Vec<Coordinates>, PlanError> {
    let distance = about.length();
    let mut rows = Vec::from_iter(path.first().copied());
    for leg in path.windows(2) {
        let (Coordinates::Planar(from), Coordinates::Planar(to)) = (leg[0], leg[1]) else {
            rows.push(leg[1]);
            continue;
        };
        let [from, to] = [from, to].map(|at| numbers_about(at, about));
        // Shares of the leg that are still to go, the next last.
        let mut ahead = vec![(0.0, 1.0, HALVINGS)];
        while let Some((lo, hi, halvings)) = ahead.pop() {
            let ends = [lo, hi].map(|share| along(from, to, share));
            let off = distance * (ends[1][2] - ends[0][2]).powi(2) / 8.0;
            if off > 0.0 && halvings > 0 && !accepts(ends, off) {
                let middle = 0.5 * (lo + hi);
                ahead.extend([(middle, hi, halvings - 1), (lo, middle, halvings - 1)]);
                continue;
            }
            if rows.len() >= MOST {
                return Err(PlanError::TooManyLegs(MOST as f64));
            }
            // The ends of legs as they stand, to the last digit.
            rows.push(match ahead.is_empty() {
                true => leg[1],
                false => Coordinates::Planar(configuration_about(ends[1], about)),
            });
        }
    }
    Ok(rows)
}
