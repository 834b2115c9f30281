//! The order of branches along a curve, decided with certainty: in f64 where the errors admit only one order, otherwise in double-double.

use crate::contact::{Cycle, Exact, Geometry, Orientation};
use crate::geometry::{Rotation, Vector};
use crate::number::Real;

use crate::general::events::branch::Branch;
use crate::general::events::placing::{Placing, Rank, rounding};

/// Errors of places are estimates; this is the factor by which they may be too small.
const MARGIN: f64 = 8.0;

/// Sorts branches along curves; its buffers are reused.
#[derive(Debug, Default)]
pub(crate) struct Order {
    /// Ranks in f64.
    rough: Vec<(Rank, u32)>,
    exact: Vec<(Exact, u32)>,
}

impl Order {
    /// Fills a list with branches of a sheet, by their numbers, in order of travel along its curve at an orientation.
    pub(crate) fn sort(
        &mut self,
        geometry: &Geometry,
        (sheet, theta): (u32, Exact),
        all: &[Branch],
        active: &[u32],
        sorted: &mut Vec<u32>,
    ) {
        sorted.clear();
        if active.len() < 2 {
            sorted.extend(active);
            return;
        }
        let others = active.iter().map(|&b| all[b as usize].other(sheet));
        if !is_small(geometry, others.chain([sheet])) {
            let placing = Placing::new(geometry, sheet, Orientation::by(theta.to_f64()));
            let rank = |&b: &u32| (placing.ranking(&all[b as usize]), b);
            self.rough.clear();
            self.rough.extend(active.iter().map(rank));
            self.rough
                .sort_unstable_by(|a, b| a.0.rank.total_cmp(&b.0.rank).then(a.1.cmp(&b.1)));
            let cycle = &placing.curve().cycle;
            let apart = |w: &[(Rank, u32)]| {
                certainly_apart(cycle, w[0].0.known(), w[1].0.known()).is_some()
            };
            if self.rough.windows(2).all(apart) {
                sorted.extend(self.rough.iter().map(|r| r.1));
                return;
            }
        }
        let placing = Placing::new(geometry, sheet, Orientation::by(theta));
        let rank = |&b: &u32| (placing.rank(&all[b as usize]), b);
        self.exact.clear();
        self.exact.extend(active.iter().map(rank));
        self.exact
            .sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        sorted.extend(self.exact.iter().map(|r| r.1));
    }
}

/// Distance along a sheet's curve from the first of two branches to the second (length), with a certain sign.
pub(crate) fn apart(geometry: &Geometry, sheet: u32, pair: [&Branch; 2], theta: Exact) -> Exact {
    if !is_small(
        geometry,
        pair.map(|b| b.other(sheet)).into_iter().chain([sheet]),
    ) {
        let placing = Placing::new(geometry, sheet, Orientation::by(theta.to_f64()));
        let [p, q] = pair.map(|b| placing.place_and_error(b));
        if let Some(rough) = certainly_apart(&placing.curve().cycle, p, q) {
            return Exact::from(rough);
        }
    }
    exactly_apart(geometry, sheet, pair, theta).0
}

/// As [`apart`], in double-double, with the rounding error of the two places (length).
pub(crate) fn exactly_apart(
    geometry: &Geometry,
    sheet: u32,
    pair: [&Branch; 2],
    theta: Exact,
) -> (Exact, f64) {
    let turn = Rotation::by(theta);
    let cycle = geometry.cycle(sheet, turn);
    let [(p, e), (q, f)] = pair.map(|b| {
        let sheets = [sheet, b.other(sheet)];
        let other = geometry.cycle(sheets[1], turn);
        let place = cycle.root(&other, b.root, b.second == sheet);
        let rounding = rounding(geometry, sheets, [&cycle, &other], place);
        (place, rounding)
    });
    (between(&cycle, p, q), e + f)
}

/// Whether f64 cannot resolve places on one of the sheets.
fn is_small(geometry: &Geometry, mut sheets: impl Iterator<Item = u32>) -> bool {
    sheets.any(|s| geometry.contacts.sheets[s as usize].is_small())
}

/// Distance from one place to another in f64; `None` if it is not larger than the errors.
fn certainly_apart(cycle: &Cycle, (p, e): (Vector, f64), (q, f): (Vector, f64)) -> Option<f64> {
    let apart = between(cycle, p, q);
    (apart.abs() > MARGIN * (e + f)).then_some(apart)
}

/// Distance from one place on a cycle to another: on a line a difference of lengths; on a circle given by its centre the sine of the angle
/// between them times the radius, continued monotonously beyond a quarter turn.
fn between<T: Real>(cycle: &Cycle<T>, p: Vector<T>, q: Vector<T>) -> T {
    if !cycle.is_centred() {
        return p.x - q.x;
    }
    let radius = cycle.radius();
    let sine = p.cross(q) / radius;
    if p.dot(q).value() >= 0.0 {
        return sine;
    }
    let twice = T::constant(2.0) * radius;
    if (sine.value() < 0.0) == (radius.value() < 0.0) {
        twice - sine
    } else {
        -twice - sine
    }
}
