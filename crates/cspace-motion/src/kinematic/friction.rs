//! Coulomb's friction where forces balance: |λ_t| ≤ μ λ_n at a contact that sticks, λ_t = ∓μ λ_n against the sliding at one that slides.
//!
//! A contact that sticks is one equation more, of its rate of sliding; one that slides pushes along n ∓ μ t instead of its normal n. What
//! contacts do is found by trying: first what a problem of complementarity tells (`resisted.rs`), then all that few of them may do.

use crate::contact::Bound;
use crate::pairs::{Grip, Pairs};
use crate::system::{Row, System};

use super::holding::{friction, grip, sliding};
use super::velocity::Held;

/// Distance of a force outside its cone of friction, as a share of all forces, that still counts as rounding.
const OUTSIDE: f64 = 1e-10;
/// Rate of sliding in the wrong direction, as a share of the largest rate, that still counts as rounding.
const BACKWARDS: f64 = 1e-10;
/// Largest number of combinations that are tried: those of eight contacts with friction.
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
                onward >= -BACKWARDS * velocity.fastest
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

/// Combinations of bounds and their grips: each group has one that holds, or none; those of few first, and among them those in which few
/// stick. None if they are too many.
pub(super) fn combinations(pairs: &Pairs, groups: &[Vec<Bound>]) -> Vec<Vec<Bound>> {
    let choices = |bound: &Bound| -> Vec<Option<Bound>> {
        match bound {
            Bound::Contact(touch) if friction(pairs, bound) > 0.0 => {
                let grips = [
                    Grip::Sticks,
                    Grip::Slides { forward: true },
                    Grip::Slides { forward: false },
                ];
                grips
                    .map(|grip| Some(Bound::Contact(touch.with(grip))))
                    .to_vec()
            }
            _ => vec![Some(*bound)],
        }
    };
    let mut states: Vec<Vec<Bound>> = vec![Vec::new()];
    for group in groups {
        let choices: Vec<Option<Bound>> = core::iter::once(None)
            .chain(group.iter().flat_map(choices))
            .collect();
        if states.len() * choices.len() > MOST_TRIED {
            return Vec::new();
        }
        let extended = states.iter().flat_map(|state| {
            (choices.iter()).map(move |choice| state.iter().copied().chain(*choice).collect())
        });
        states = extended.collect();
    }
    let sticking = |state: &[Bound]| state.iter().filter(|b| grip(b) == Grip::Sticks).count();
    states.sort_by_key(|state| (state.len(), sticking(state)));
    states
}

/// Most contacts that stick of which all are let go in every direction.
const MOST_LET_GO: u32 = 4;

/// A set in which some of the contacts that stick slide instead, in either direction: where others keep them from sliding, what they carry
/// is not told by their sticking, and may be all that friction allows. Few at first; empty if too many stick.
pub(super) fn let_go(set: &[Bound]) -> Vec<Vec<Bound>> {
    let sticking: Vec<usize> = (0..set.len())
        .filter(|&i| grip(&set[i]) == Grip::Sticks)
        .collect();
    let count = u32::try_from(sticking.len()).unwrap_or(u32::MAX);
    if count > MOST_LET_GO {
        return Vec::new();
    }
    let changed = |code: usize| {
        let mut changed = set.to_vec();
        let mut code = code;
        for &i in &sticking {
            if let (Bound::Contact(touch), 1..) = (set[i], code % 3) {
                let forward = code % 3 == 1;
                changed[i] = Bound::Contact(touch.with(Grip::Slides { forward }));
            }
            code /= 3;
        }
        changed
    };
    let mut all: Vec<Vec<Bound>> = (1..3_usize.pow(count)).map(changed).collect();
    all.sort_by_key(|set| {
        core::cmp::Reverse(set.iter().filter(|b| grip(b) == Grip::Sticks).count())
    });
    all
}
