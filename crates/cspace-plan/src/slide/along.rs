//! Steps along the surface. Every step is the way to the goal projected to what the contacts leave open, to first order: those that
//! touch, and those that earlier attempts have run into.

use cspace::{PatchId, QueryError};

use super::ground::{Ground, Stop};
use super::step::{Contact, Step, contacts_at};
use super::tolerance::{LEAST_BEND, LONGEST_STEP, MOST_BEND, PRESSED, REACHED, TOUCHES};
use super::vector::{Vec3, dot, minus, size, times};
use super::ways::{HalfSpace, ways_along};

/// So many steps along the surface are one motion of the pointer.
const MOST_STEPS: usize = 16;
/// A step that leads nowhere is tried again, shorter, so often.
const TRIES: usize = 5;
/// Contacts that a step runs into are taken into account one after another, so many for one step.
const MOST_LEARNT: usize = 6;
/// Number of contacts that do not touch and are remembered: those run into last.
const MOST_KNOWN: usize = 4;
/// Past an edge of an obstacle so many ways are tried.
const MOST_EDGES: usize = 4;

/// Contacts by their patches; of the end of a range there is none.
type Key = Vec<Option<PatchId>>;

/// A step that was taken: from where, by which way, along which contacts, and to where.
struct Taken {
    from: Vec3,
    way: Vec3,
    along: Key,
    next: Vec3,
}

/// Slides from a position in contact towards a goal, and gives where that ends and which patch stops it there (none at the goal). `patch`
/// is the one that stopped the straight motion to `from`. Each step is no farther from the goal than the one before, and not blocked.
pub(super) fn slide_on(
    ground: &impl Ground,
    from: Vec3,
    to: Vec3,
    patch: PatchId,
) -> Result<Stop, QueryError> {
    let mut at = Stop {
        at: from,
        stopped: Some(patch),
    };
    let least = (REACHED * size(minus(to, from))).max(TOUCHES * ground.contact());
    let mut known: Vec<PatchId> = Vec::new();
    let mut last: Option<Taken> = None;
    for _ in 0..MOST_STEPS {
        let Some(stopped) = at.stopped.filter(|_| size(minus(to, at.at)) > least) else {
            break;
        };
        remember(&mut known, stopped);
        let remembers = known.len() > 1;
        let mut step = step_towards(ground, at.at, to, &mut known, least, last.as_ref())?;
        if step.is_none() && remembers {
            // What is remembered may be left behind, and bars ways that lead on.
            known = vec![stopped];
            step = step_towards(ground, at.at, to, &mut known, least, last.as_ref())?;
        }
        let Some(taken) = step else {
            break;
        };
        let next = taken.next;
        last = Some(taken);
        let on = ground.advance(next, to)?;
        // What is but pressed on is in contact as before.
        let is_far = size(minus(on.at, next)) > PRESSED * ground.contact() || on.stopped.is_none();
        if is_far && ground.is_blocked(on.at) {
            return Ok(Stop { at: next, ..at });
        }
        at = on;
    }
    match last {
        Some(last) if ground.is_blocked(at.at) => Ok(Stop {
            at: last.next,
            ..at
        }),
        _ => Ok(at),
    }
}

/// Puts a patch last among those that are remembered.
fn remember(known: &mut Vec<PatchId>, patch: PatchId) {
    known.retain(|&p| p != patch);
    known.push(patch);
    let forgotten = known.len().saturating_sub(MOST_KNOWN);
    known.drain(..forgotten);
}

/// One step along the surface that comes nearer to the goal; none if none does. The ways that contacts leave are tried, nearest first. A
/// patch that a step runs into, and that was not among the contacts, joins them, and the ways are found again.
fn step_towards(
    ground: &impl Ground,
    at: Vec3,
    to: Vec3,
    known: &mut Vec<PatchId>,
    least: f64,
    last: Option<&Taken>,
) -> Result<Option<Taken>, QueryError> {
    let left = minus(to, at);
    let near = ground.touching(at)?;
    let mut failed: Vec<Key> = Vec::new();
    for _ in 0..MOST_LEARNT {
        let mut patches = near.clone();
        patches.extend(known.iter().filter(|p| !near.contains(p)));
        let contacts = contacts_at(ground, at, &patches)?;
        let spaces: Vec<HalfSpace> = contacts.iter().map(|c| c.space).collect();
        let mut learnt = None;
        for way in ways_along(left, &spaces) {
            let length = size(way.by);
            if length <= least || dot(way.by, left) <= 0.0 {
                continue;
            }
            let held: Vec<&Contact> = way.held.iter().map(|&i| &contacts[i]).collect();
            let key: Key = held.iter().map(|c| c.patch).collect();
            let is_edge = !way.allowed;
            if is_edge && (failed.contains(&key) || failed.len() >= MOST_EDGES) {
                continue;
            }
            let touch = (held.iter()).all(|c| c.space.room <= TOUCHES * ground.contact());
            let bend = match last {
                Some(last) if last.along == key => bend_of(last, at, way.by),
                _ => 1.0,
            };
            let longer = if touch { bend } else { bend.min(1.0) };
            let step = Step {
                ground,
                at,
                to,
                contacts: &contacts,
                held: &held,
            };
            let by = times(way.by, longer.min(LONGEST_STEP / length));
            let tried = step.along(by, if is_edge { 1 } else { TRIES })?;
            if let Some(next) = tried.next {
                return Ok(Some(Taken {
                    from: at,
                    way: way.by,
                    along: key,
                    next,
                }));
            }
            let is_new = |met: &PatchId| contacts.iter().all(|c| c.patch != Some(*met));
            if is_edge {
                failed.push(key);
            } else if let Some(met) = tried.met.filter(is_new) {
                learnt = Some(met);
                break;
            }
        }
        let Some(learnt) = learnt else {
            break;
        };
        remember(known, learnt);
    }
    Ok(None)
}

/// By how much a step is to be longer than the way that is left along the surface: that is to first order, and surfaces are curved. From
/// how that changed with the last step along the same contacts.
fn bend_of(last: &Taken, at: Vec3, way: Vec3) -> f64 {
    let moved = minus(at, last.from);
    let less = dot(moved, minus(last.way, way));
    if less > 0.0 {
        (dot(moved, moved) / less).clamp(LEAST_BEND, MOST_BEND)
    } else {
        1.0
    }
}
