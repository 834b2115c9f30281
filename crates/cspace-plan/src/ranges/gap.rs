//! The smallest gap of two parts that never touch: found by descent, proved by the space of a part that is grown.

use core::f64::consts::TAU;

use cspace::fixed_axes::BranchForm;
use cspace::{Axis, AxisMotion, FixedAxesSpace, PairError, PairSpace, Part};

use crate::legs::Scene;
use crate::widest::grown;

use super::answer::{Tightest, Verdict};
use super::descent::{Descent, Low, coords};

/// A gap is proved to be the smallest but for this share of it,
const EXACT: f64 = 1e-9;
/// or this share of the size of the parts if that is more: a grown outline is right to less than a tenth of it.
const EXACT_OF_SIZE: f64 = 1e-10;
/// The part is grown so often at most. Every time a local minimum is found that is lower than those before, of which there are no more than
/// pairs of features; from so many places as are tried each time, a third time is rare.
const MOST_TURNS: usize = 24;
/// An outline that cannot be grown by a distance can be grown by one that is this share of it less, times 1, 2, 3.
const SMALLER: f64 = 1e-7;
/// Configurations in each coordinate from which the first descent starts, of which the best are used.
const STARTS: usize = 12;
const BEST: usize = 4;
/// Places of contact with the grown part from which a descent starts, at most.
const CONTACTS: usize = 64;

/// The space of the pair with another moving part.
pub(super) type Spaces<'a> = dyn Fn(&Part) -> Result<PairSpace, PairError> + 'a;

/// The smallest gap below `within`, of parts of which no contact bounds the free region of `place`.
pub(super) fn smallest(
    space: &FixedAxesSpace,
    place: [f64; 2],
    within: f64,
    spaces: &Spaces<'_>,
) -> Result<Verdict, PairError> {
    let scene = Scene::new(space.fixed(), space.moving(), Some(space.axes()));
    let descent = Descent::new(&scene);
    let mut low = (starts(space, place).into_iter())
        .map(|at| descent.there(at))
        .collect::<Vec<_>>();
    low.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let firsts = low.into_iter().take(BEST).map(|low| low.at);
    let mut best = (firsts.chain([place]))
        .map(|at| descent.from(at))
        .reduce(lower)
        .unwrap_or_else(|| descent.there(place));
    let mut least = 0.0;
    for _ in 0..MOST_TURNS {
        let asked = best.distance.min(within);
        let Some((radius, about)) = with_radius(space.moving(), asked, scene.size(), spaces)?
        else {
            break;
        };
        if about.statistics().conflicts > 0 {
            break;
        }
        if about.patches().is_empty() && about.locate(place[0], place[1]).region().is_some() {
            if best.distance >= within {
                return Ok(Verdict::Beyond);
            }
            least = (radius - about.resolution()).max(0.0);
            break;
        }
        let below = |every| {
            let lows = contacts(&about, every).map(|at| descent.from(at));
            (lows.reduce(lower)).filter(|next| next.distance < best.distance)
        };
        // Around a place at which the parts are nearer there may be one curve among many.
        let Some(next) = below(about.branches().len() / CONTACTS).or_else(|| below(1)) else {
            break;
        };
        best = next;
    }
    let best = descent.there(in_one_turn(space, best.at));
    let at = coords(best.at);
    let (features, points) = scene.nearest_places(at).unzip();
    Ok(Verdict::Clear(Tightest {
        gap: best.distance,
        least,
        at: (best.at[0], best.at[1]),
        features: features.map(|(f, g)| [f, g]),
        points: points.map(|(p, q)| [p, q]),
    }))
}

/// The configuration with the motions of parts that turn without limits within half a turn.
fn in_one_turn(space: &FixedAxesSpace, at: [f64; 2]) -> [f64; 2] {
    let (fixed, moving) = space.axes();
    [0, 1].map(|k| match [fixed, moving][k] {
        Axis {
            motion: AxisMotion::Revolute { .. },
            range: None,
        } => at[k] - (at[k] / TAU).round() * TAU,
        _ => at[k],
    })
}

fn lower(a: Low, b: Low) -> Low {
    if b.distance < a.distance { b } else { a }
}

/// The space with the moving part grown by a little less than a distance, and by how much; none if it cannot be grown.
fn with_radius(
    part: &Part,
    asked: f64,
    size: f64,
    spaces: &Spaces<'_>,
) -> Result<Option<(f64, FixedAxesSpace)>, PairError> {
    for smaller in 0..4 {
        let exact = (EXACT * asked).max(EXACT_OF_SIZE * size);
        let radius = asked * (1.0 - SMALLER * f64::from(smaller)) - exact;
        if radius <= EXACT_OF_SIZE * size {
            return Ok(None);
        }
        let Ok(grown) = grown(part, radius) else {
            continue;
        };
        if let PairSpace::FixedAxes(space) = spaces(&grown)? {
            return Ok(Some((radius, *space)));
        }
    }
    Ok(None)
}

/// Configurations spread over the ranges, from which to look for a small gap.
fn starts(space: &FixedAxesSpace, place: [f64; 2]) -> Vec<[f64; 2]> {
    let (fixed, moving) = space.axes();
    let extent = space.extent();
    let values = [0, 1].map(|k| {
        if [fixed, moving][k].motion == AxisMotion::Fixed {
            return vec![place[k]];
        }
        let [lo, hi] = extent[k].into();
        (0..=STARTS)
            .map(|i| lo + (hi - lo) * i as f64 / STARTS as f64)
            .collect()
    });
    let [us, vs] = &values;
    let all = us.iter().flat_map(|&u| vs.iter().map(move |&v| [u, v]));
    all.collect()
}

/// Middles of contact curves: at every one the parts are as far apart as the moving part was grown, and beside it nearer. Of every so many
/// curves there is one.
fn contacts(space: &FixedAxesSpace, every: usize) -> impl Iterator<Item = [f64; 2]> + '_ {
    let branches = space.branches().iter().enumerate().step_by(every.max(1));
    branches.filter_map(|(i, branch)| {
        let of = match branch.form {
            BranchForm::VOfU => (branch.start.0, branch.end.0),
            BranchForm::UOfV => (branch.start.1, branch.end.1),
        };
        let ((u, v), _) = space.branch_at(i, 0.5 * (of.0 + of.1))?;
        Some([u, v])
    })
}
