//! The boxes through which a low way may leak: between what is reached from the start and what is reached from the goal, the fewest
//! boxes that are not known to be free.

use std::collections::VecDeque;

use super::boxes::{Boxes, State};
use super::flood::Goal;
use crate::legs::Coords;

/// Share of the largest leak's box below which a leak is not reported.
const SMALL: f64 = 0.3;

/// The larger boxes, not known to be free, of all ways from a start to a goal that stay below an energy and use the fewest such boxes.
pub(super) fn leaks(boxes: &Boxes<'_>, from: Coords, goal: Goal, energy: f64) -> Vec<u32> {
    let whole = 0..boxes.cells.len() as u32;
    let undivided = || whole.clone().filter(|&i| !boxes.is_divided(i));
    let goals: Vec<u32> = match goal {
        Goal::At(to) => vec![boxes.holding(to)],
        Goal::Out => undivided()
            .filter(|&i| {
                let c = boxes.cell(i);
                boxes.domain.out(c.lo, c.hi).next().is_some()
            })
            .collect(),
    };
    let there = count(boxes, &[boxes.holding(from)], energy);
    let back = count(boxes, &goals, energy);
    let both = |i: u32| {
        let (a, b) = (there[i as usize]?, back[i as usize]?);
        Some(a + b - u32::from(is_open(boxes, i)))
    };
    let Some(least) = undivided().filter_map(both).min() else {
        return Vec::new();
    };
    let mut found: Vec<u32> = undivided()
        .filter(|&i| is_open(boxes, i) && both(i) == Some(least))
        .collect();
    let largest = (found.iter()).map(|&i| boxes.extent(i)).fold(0.0, f64::max);
    found.retain(|&i| boxes.extent(i) >= SMALL * largest);
    found
}

fn is_open(boxes: &Boxes<'_>, i: u32) -> bool {
    boxes.cell(i).state == State::Open
}

/// For each box how many of those that lead there below an energy, itself with them, are not known to be free; `None` where none
/// lead.
fn count(boxes: &Boxes<'_>, from: &[u32], energy: f64) -> Vec<Option<u32>> {
    let mut counts: Vec<Option<u32>> = vec![None; boxes.cells.len()];
    let mut settled = vec![false; boxes.cells.len()];
    let mut next = VecDeque::new();
    for &i in from {
        let c = boxes.cell(i);
        if c.state != State::Blocked && boxes.energy(c.lo, c.hi).0 <= energy {
            let open = is_open(boxes, i);
            counts[i as usize] = Some(u32::from(open));
            if open {
                next.push_back(i);
            } else {
                next.push_front(i);
            }
        }
    }
    let mut faces = Vec::new();
    while let Some(i) = next.pop_front() {
        if core::mem::replace(&mut settled[i as usize], true) {
            continue;
        }
        let Some(here) = counts[i as usize] else {
            continue;
        };
        boxes.beside(i, &mut faces);
        for face in &faces {
            let j = face.other as usize;
            if settled[j] || boxes.cell(face.other).state == State::Blocked {
                continue;
            }
            let open = is_open(boxes, face.other);
            let there = here + u32::from(open);
            if counts[j].is_none_or(|n| there < n) && boxes.energy(face.lo, face.hi).0 <= energy {
                counts[j] = Some(there);
                if open {
                    next.push_back(face.other);
                } else {
                    next.push_front(face.other);
                }
            }
        }
    }
    counts
}
