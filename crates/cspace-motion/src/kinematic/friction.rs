//! Coulomb's friction where forces balance: |λ_t| ≤ μ λ_n at a contact that sticks, λ_t = ∓μ λ_n against the sliding at one that slides.
//!
//! A contact that sticks is one equation more, of its rate of sliding; one that slides pushes along n ∓ μ t instead of its normal n. What
//! contacts do is found by trying: few contacts first, and of each what friction can do.

use crate::contact::Bound;
use crate::pairs::{Grip, Pairs};
use crate::system::{Row, System};

use super::holding::{friction, grip, sliding};
use super::velocity::Held;

/// Distance of a force outside its cone of friction, as a share of all forces, that still counts as rounding.
const OUTSIDE: f64 = 1e-10;
/// Rate of sliding in the wrong direction, as a share of the largest rate, that still counts as rounding.
const BACKWARDS: f64 = 1e-10;
/// Largest number of combinations of states that are all tried: six contacts with friction.
const MOST_STATES: usize = 4096;
/// With more than [`MOST_STATES`] combinations, at most so many bounds may change their state at once.
const MOST_CHANGES: usize = 2;

/// Whether forces are within their cones of friction, and contacts that slide go on to slide in the same direction.
pub(super) fn agrees(
    system: &System,
    pairs: &Pairs,
    held: &[Bound],
    q: &[f64],
    velocity: &Held,
) -> bool {
    let mut sticks = held.len()..;
    let force = |row: usize| velocity.pushes[row] / velocity.lengths[row];
    let fastest = system.speed(&velocity.rates);
    held.iter()
        .enumerate()
        .all(|(i, bound)| match sliding(system, pairs, bound, q) {
            Some((Grip::Sticks, friction, _)) => {
                let row = sticks.next().unwrap_or(i);
                let outside = force(row).abs() - friction * force(i);
                outside * velocity.lengths[i] <= OUTSIDE * velocity.speed
            }
            Some((Grip::Slides { forward }, _, rate)) => {
                let rate = rate.rate(&velocity.rates);
                let onward = if forward { rate } else { -rate };
                onward >= -BACKWARDS * fastest
            }
            _ => true,
        })
}

/// The sides of the cones of friction of bounds that touch, as functions whose gradients they are.
pub(super) fn cones(
    system: &System,
    pairs: &Pairs,
    bounds: &[Bound],
    q: &[f64],
) -> Vec<(Bound, Row)> {
    let sides = |bound: &Bound| {
        let row = bound.function(system, pairs, q);
        match bound {
            Bound::Contact(touch) if friction(pairs, bound) > 0.0 => {
                let pair = &pairs.list()[touch.pair];
                let along = pair.sliding(touch, system, q);
                let side = |sign: f64| (*bound, row.plus(sign * pair.friction, &along));
                vec![side(1.0), side(-1.0)]
            }
            _ => vec![(*bound, row)],
        }
    };
    bounds.iter().flat_map(sides).collect()
}

/// The tangential force of each bound, of the multipliers of all rows.
pub(super) fn tangential(pairs: &Pairs, held: &[Bound], multipliers: &[f64]) -> Vec<f64> {
    let mut sticks = multipliers.get(held.len()..).unwrap_or_default().iter();
    held.iter()
        .zip(multipliers)
        .map(|(bound, normal)| match grip(bound) {
            Grip::Smooth => 0.0,
            Grip::Sticks => sticks.next().copied().unwrap_or(0.0),
            Grip::Slides { forward } => {
                friction(pairs, bound) * if forward { -normal } else { *normal }
            }
        })
        .collect()
}

/// Combinations of the bounds' states, those first in which few of them hold: each bound is left out, or holds by one
/// of its grips; of those that push alike at one place only one holds. `before` is the set that held last.
pub(super) fn states(
    pairs: &Pairs,
    bounds: &[Bound],
    before: &[Bound],
    alike: &dyn Fn(&Bound, &Bound) -> bool,
) -> Vec<Vec<Bound>> {
    let choices = |bound: &Bound| -> Vec<Bound> {
        match bound {
            Bound::Contact(touch) if friction(pairs, bound) > 0.0 => {
                let grips = [
                    Grip::Sticks,
                    Grip::Slides { forward: true },
                    Grip::Slides { forward: false },
                ];
                grips.map(|grip| Bound::Contact(touch.with(grip))).to_vec()
            }
            _ => vec![*bound],
        }
    };
    // Bounds of which one holds at most.
    let mut groups: Vec<Vec<Bound>> = Vec::new();
    for bound in bounds {
        match groups.iter_mut().find(|group| alike(&group[0], bound)) {
            Some(group) => group.push(*bound),
            None => groups.push(vec![*bound]),
        }
    }
    let all: Vec<Vec<Bound>> = (groups.iter())
        .map(|group| group.iter().flat_map(choices).collect())
        .collect();
    let count = all
        .iter()
        .try_fold(1_usize, |n, c| n.checked_mul(c.len() + 1));
    let few = count.is_some_and(|n| n <= MOST_STATES);
    // Each with how many differ from what held last.
    let mut states: Vec<(Vec<Bound>, usize)> = vec![(Vec::new(), 0)];
    for (group, choices) in groups.iter().zip(&all) {
        let last = before
            .iter()
            .find(|b| group.iter().any(|other| b.is_same(other)));
        let extended = states.iter().flat_map(|(state, changes)| {
            let each = choices.iter().copied().map(Some);
            core::iter::once(None)
                .chain(each)
                .filter_map(move |choice| {
                    let same = choice.as_ref().map(grip) == last.map(grip);
                    let changes = changes + usize::from(!same);
                    let state = state.iter().copied().chain(choice).collect();
                    (few || changes <= MOST_CHANGES).then_some((state, changes))
                })
        });
        states = extended.collect();
    }
    let sticking = |state: &[Bound]| state.iter().filter(|b| grip(b) == Grip::Sticks).count();
    states.sort_by_key(|(state, changes)| match few {
        true => (state.len(), sticking(state)),
        false => (*changes, 0),
    });
    states.into_iter().map(|s| s.0).collect()
}
