//! Coulomb's friction where forces balance: |λ_t| ≤ μ λ_n at a contact that sticks, λ_t = ∓μ λ_n against the sliding at one that slides.
//!
//! A contact that sticks is one equation more, of its rate of sliding; one that slides pushes along n ∓ μ t instead of its normal n. What
//! contacts do is found by trying: few contacts first, and of each what friction can do; of many what a problem of complementarity tells.

use crate::contact::Bound;
use crate::pairs::{Grip, Pairs};
use crate::system::{Row, System};

use super::holding::{friction, grip, sliding};
use super::resisted;
use super::velocity::{Held, Local};

/// Distance of a force outside its cone of friction, as a share of all forces, that still counts as rounding.
const OUTSIDE: f64 = 1e-10;
/// Rate of sliding in the wrong direction, as a share of the largest rate, that still counts as rounding.
const BACKWARDS: f64 = 1e-10;
/// Largest number of combinations of states that are all tried: six contacts with friction.
const MOST_STATES: usize = 4096;
/// Largest number of combinations that are tried where the solver finds none: eight contacts with friction.
const MOST_TRIED: usize = 65_536;

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

/// Sets of bounds that may hold as the motion goes on, with brakes that hold. Each bound is left out, or holds by one of its grips, and of
/// those that push alike at one place only one holds: all combinations of a few, those first in which few hold, and of more those of a
/// [step](super::resisted).
pub(super) fn states<'a>(
    system: &'a System,
    pairs: &'a Pairs,
    local: &'a Local<'a>,
    [bounds, brakes]: [&'a [Bound]; 2],
    q: &'a [f64],
    alike: &dyn Fn(&Bound, &Bound) -> bool,
) -> Box<dyn Iterator<Item = Vec<Bound>> + 'a> {
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
        .fold(1_usize, |n, c| n.saturating_mul(c.len() + 1));
    if count <= MOST_STATES {
        return Box::new(combinations(&all).into_iter());
    }
    let sets = resisted::sets(system, pairs, local, (groups, brakes), q);
    // The solver does not find all.
    let rest = core::iter::once_with(move || match count <= MOST_TRIED {
        true => combinations(&all),
        false => Vec::new(),
    });
    Box::new(sets.chain(rest.flatten()))
}

/// Combinations of which each has one or none of every list, those of few first, and among them those in which few stick.
fn combinations(all: &[Vec<Bound>]) -> Vec<Vec<Bound>> {
    let mut states: Vec<Vec<Bound>> = vec![Vec::new()];
    for choices in all {
        let extended = states.iter().flat_map(|state| {
            let each = core::iter::once(None).chain(choices.iter().copied().map(Some));
            each.map(move |choice| state.iter().copied().chain(choice).collect())
        });
        states = extended.collect();
    }
    let sticking = |state: &[Bound]| state.iter().filter(|b| grip(b) == Grip::Sticks).count();
    states.sort_by_key(|state| (state.len(), sticking(state)));
    states
}
