//! Drops: a part that is pushed loses contact with another, and falls on to the next place.

use cspace::AxisMotion;

use super::contacts::{ContactInterval, together};
use super::cycle::Cycle;
use super::trajectory::Trajectory;
use crate::record::{Event, EventKind, Record, What};
use crate::system::{PartCoordinates, System};

/// Longest loss of contact that counts as a drop, as a fraction of the cycle.
const QUICK: f64 = 0.25;
/// A part that swings does so by more than this, relative to the size of the mechanism; less is play.
const SWINGS: f64 = 1e-2;
/// Distance by which a part must come back to have turned back, relative to the size of the mechanism: more than the
/// error of the motion.
const BACK: f64 = 1e-8;
/// Shortest gap in a contact, relative to the duration: the error of an event's time.
const NEAR: f64 = 1e-9;

/// A part that loads, springs or its weight push leaves another and lands on it again.
#[derive(Debug, Clone, PartialEq)]
pub struct Drop {
    /// The index of the part that drops.
    pub part: usize,
    /// The index of the part that it drops off and lands on.
    pub off: usize,
    /// Time of the loss of contact, in seconds.
    pub leaves: f64,
    /// Time of the next contact.
    pub lands: f64,
    /// The part that carries it, or that it drops off, if that swings.
    pub swing: Option<Swing>,
}

/// A part that swings, and off which another drops. Lengths are in the model's unit, angles in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Index of the part.
    pub part: usize,
    /// Displacement after the other part has left, before it turns back.
    pub goes_on: f64,
    /// Excess of its stroke over the step of a wheel or rack, if it swings about the same axis, or along the same
    /// direction, and moves it on.
    pub spare: Option<f64>,
}

/// The drops of the last cycle.
pub(super) fn find(
    system: &System,
    trajectory: &Trajectory<'_>,
    contacts: &[ContactInterval],
    cycle: &Cycle,
    record: &Record,
) -> Vec<Drop> {
    let until = record.until;
    let mechanism = system.mechanism();
    let mut drops = Vec::new();
    for pair in &mechanism.pairs {
        let parts = [pair.fixed, pair.moving];
        let Some((part, off)) = pushed(system, parts) else {
            continue;
        };
        let names = parts.map(|i| mechanism.parts[i].part.name());
        let touching = together(contacts, names, until, NEAR * until);
        let gaps = touching.windows(2).map(|gap| (gap[0].1, gap[1].0));
        for (leaves, lands) in gaps.chain(snaps(record, mechanism.parts[part].part.name(), names)) {
            let is_last = lands > until - cycle.period * (1.0 - 1e-9);
            if is_last && lands - leaves < QUICK * cycle.period {
                drops.push(Drop {
                    part,
                    off,
                    leaves,
                    lands,
                    swing: swing(system, trajectory, cycle, [part, off], leaves),
                });
            }
        }
    }
    drops.sort_by(|a, b| a.leaves.total_cmp(&b.leaves));
    drops
}

/// Times at which a part of a pair jumps to another place on the other part.
fn snaps<'r>(
    record: &'r Record,
    part: &'r str,
    names: [&'r str; 2],
) -> impl Iterator<Item = (f64, f64)> + 'r {
    let events = record.events.iter();
    let of_part = move |e: &&Event| matches!(&e.what, What::Part { part: p } if p == part);
    let snaps = events.filter(|e| e.kind == EventKind::Snap).filter(of_part);
    let happens = move |kind: EventKind, t: f64| {
        record.events.iter().any(|e| {
            let of_pair = matches!(&e.what, What::Contact { fixed, moving, .. } if [fixed.as_str(), moving.as_str()] == names);
            e.t == t && e.kind == kind && of_pair
        })
    };
    let drops =
        move |e: &&Event| happens(EventKind::Release, e.t) && happens(EventKind::Touch, e.t);
    snaps.filter(drops).map(|e| (e.t, e.t))
}

/// Part on which loads, springs or weight act, and the other part; if they act on both, the second.
fn pushed(system: &System, [a, b]: [usize; 2]) -> Option<(usize, usize)> {
    let mechanism = system.mechanism();
    let dynamics = &mechanism.dynamics;
    let is_pushed = |i: usize| {
        let moves = system.parts()[i].indices();
        let driven = system.drives().iter().any(|d| moves.contains(&d.0));
        let loads = dynamics.loads.iter().any(|l| l.part == i);
        let springs = (dynamics.springs.iter()).any(|s| s.part == i || s.other == Some(i));
        let falls = dynamics.gravity.length() > 0.0 && dynamics.part(i).mass.is_some();
        !moves.is_empty() && !driven && (loads || springs || falls)
    };
    match (is_pushed(a), is_pushed(b)) {
        (_, true) => Some((b, a)),
        (true, false) => Some((a, b)),
        (false, false) => None,
    }
}

/// Swing of a part at the time at which it drops off another.
fn swing(
    system: &System,
    trajectory: &Trajectory<'_>,
    cycle: &Cycle,
    [part, off]: [usize; 2],
    from: f64,
) -> Option<Swing> {
    let joined = system
        .mechanism()
        .joints
        .iter()
        .filter_map(|j| match j.parts {
            (a, b) if a == part => Some(b),
            (a, b) if b == part => Some(a),
            _ => None,
        });
    let of = |i: usize| cycle.parts.iter().find(|p| p.part == i);
    let swings = |i: &usize| {
        let coordinate = system.parts()[*i].indices().start;
        motion(system, *i).is_some()
            && of(*i).is_some_and(|p| {
                let stroke = p.stroke(0) * system.lengths()[coordinate];
                p.advance[0] == 0.0 && stroke > SWINGS * system.size()
            })
    };
    let carrier = joined.chain([off]).find(swings)?;
    let step = of(off).filter(|_| is_coaxial(system, carrier, off));
    let step = step.map_or(0.0, |p| p.advance[0].abs());
    let stroke = of(carrier)?.stroke(0);
    Some(Swing {
        part: carrier,
        goes_on: goes_on(system, trajectory, carrier, from)?,
        spare: (step > 0.0 && step < stroke).then_some(stroke - step),
    })
}

fn motion(system: &System, part: usize) -> Option<AxisMotion> {
    match system.parts()[part] {
        PartCoordinates::Axis { motion, .. } => Some(motion),
        _ => None,
    }
}

/// Whether two parts turn about the same axis, or slide in the same direction.
fn is_coaxial(system: &System, a: usize, b: usize) -> bool {
    /// Tolerance relative to the size of the mechanism, or to a unit vector.
    const SAME_AXIS: f64 = 1e-9;
    match (motion(system, a), motion(system, b)) {
        (Some(AxisMotion::Revolute { center: a }), Some(AxisMotion::Revolute { center: b })) => {
            a.distance(b) <= SAME_AXIS * system.size()
        }
        (
            Some(AxisMotion::Prismatic { direction: a }),
            Some(AxisMotion::Prismatic { direction: b }),
        ) => (a.x * b.y - a.y * b.x).abs() <= SAME_AXIS,
        _ => false,
    }
}

/// Displacement of a part on its axis from a time until it turns back.
fn goes_on(system: &System, trajectory: &Trajectory<'_>, part: usize, from: f64) -> Option<f64> {
    let i = system.parts()[part].indices().start;
    let back = BACK * system.size() / system.lengths()[i];
    let begin = trajectory.at(from, i);
    let (mut sense, mut farthest) = (0.0, 0.0_f64);
    for (_, value) in trajectory.curve(i).into_iter().filter(|(t, _)| *t > from) {
        let gone = value - begin;
        if sense == 0.0 && gone.abs() > back {
            sense = gone.signum();
        }
        if sense * gone < farthest - back {
            return Some(farthest);
        }
        farthest = farthest.max(sense * gone);
    }
    None
}
