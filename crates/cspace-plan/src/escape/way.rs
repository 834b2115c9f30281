//! The way through free boxes as legs, each tested by itself.

use crate::legs::Coords;
use crate::route::along;

use super::boxes::is_free;
use super::search::{Bracket, Question};

/// A leg is halved so often at most.
const HALVINGS: u32 = 20;

/// A way as configurations joined by motions of constant rates.
pub(super) struct Legs {
    pub(super) places: Vec<Coords>,
    /// Its highest energy, right to a share of what the bounds are apart.
    pub(super) energy: f64,
}

/// The way of a bracket as legs, `None` if there is none or some leg does not pass.
pub(super) fn way(question: &Question<'_>, bracket: &Bracket) -> Option<Legs> {
    let energy = &question.plain;
    let scene = question.scene;
    let tolerance = 1e-3 * question.within;
    let mut places = bracket.begin.clone();
    if let Some(&first) = bracket.way.first() {
        // As often around as what it begins with.
        let domain = &question.domain;
        let first = domain.configuration(first);
        let turns: Coords = match places.last() {
            Some(&last) => {
                let like = like_turn(question, first, last);
                core::array::from_fn(|k| like[k] - first[k])
            }
            None => [0.0; 3],
        };
        let lifted = |z: Coords| core::array::from_fn(|k| z[k] + turns[k]);
        for pair in bracket.way.windows(2) {
            let (a, b) = (lifted(pair[0]), lifted(pair[1]));
            places.push(domain.configuration(a));
            between(question, (a, b), HALVINGS, &mut places)?;
        }
        places.push(domain.configuration(lifted(*bracket.way.last()?)));
        if let Some((to, _)) = question.to {
            let last = *places.last()?;
            places.push(like_turn(question, to, last));
        }
    }
    places.dedup();
    if places.is_empty() {
        return None;
    }
    let highest = |a: Coords, b: Coords| energy.highest(a, b, tolerance);
    let most = (places.windows(2))
        .map(|leg| highest(leg[0], leg[1]))
        .fold(energy.value(places[0]), f64::max);
    // As few legs as pass with no more energy.
    let passes = |a: Coords, b: Coords| highest(a, b) <= most && is_free(scene, a, b);
    let mut kept = vec![places[0]];
    let mut here = 0;
    while here + 1 < places.len() {
        let mut next = here + 1;
        let mut step = places.len() - 1 - here;
        while step > 0 {
            if here + step > next && passes(places[here], places[here + step]) {
                next = here + step;
                break;
            }
            step /= 2;
        }
        kept.push(places[next]);
        here = next;
    }
    let energy = (kept.windows(2))
        .map(|leg| highest(leg[0], leg[1]))
        .fold(most, f64::max);
    Some(Legs {
        places: kept,
        energy,
    })
}

/// A configuration as often around as another one beside it.
fn like_turn(question: &Question<'_>, at: Coords, like: Coords) -> Coords {
    use core::f64::consts::TAU;
    core::array::from_fn(|k| {
        if question.domain.around[k] {
            at[k] + TAU * ((like[k] - at[k]) / TAU).round()
        } else {
            at[k]
        }
    })
}

/// Places between two ends of a line in the domain, such that the legs between them are free.
fn between(
    question: &Question<'_>,
    (from, to): (Coords, Coords),
    halvings: u32,
    places: &mut Vec<Coords>,
) -> Option<()> {
    let at = |z: Coords| question.domain.configuration(z);
    if is_free(question.scene, at(from), at(to)) {
        return Some(());
    }
    if halvings == 0 {
        return None;
    }
    let half = along(from, to, 0.5);
    between(question, (from, half), halvings - 1, places)?;
    places.push(at(half));
    between(question, (half, to), halvings - 1, places)
}
