//! A mechanism with masses set in motion.

use crate::contact::named;
use crate::dynamic::{self, Ended, Options, State};
use crate::error::SimulateError;
use crate::pairs::Pairs;
use crate::record::{Energy, Event, EventKind, Record, Status};
use crate::system::System;

use super::bodies::Bodies;
use super::forces::{kinetic, potential};
use super::observer::Gathering;
use super::world::Mechanical;

/// Method by which the motion is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scheme {
    /// From event to event.
    Events,
    /// In so many steps of one length.
    Steps(usize),
}

/// Follows the motion of a mechanism from coordinates and rates of its parts' frames for some time, with samples at even times.
pub(crate) fn run(
    system: System,
    pairs: &Pairs,
    (mut q, mut v): (Vec<f64>, Vec<f64>),
    ([from, duration], every): ([f64; 2], f64),
    (scheme, strict): (Scheme, bool),
    progress: &dyn Fn(f64) -> bool,
) -> Result<Record, SimulateError> {
    system.shift(&mut q, &mut v, false);
    let bodies = Bodies::new(system)?;
    let world = Mechanical::new(&bodies, pairs);
    let start = State {
        t: from,
        q: bodies.free(&q),
        v: bodies.free(&v),
    };
    let energy = |state: &State| {
        let all = bodies.all(state);
        kinetic(&bodies, &all) + potential(&bodies.system, &all.q)
    };
    let mut gathering = Gathering {
        world: &world,
        every,
        first: (from / every).ceil() as usize,
        duration,
        samples: Vec::new(),
        events: Vec::new(),
        trace: Vec::new(),
        progress,
    };
    let motion = match scheme {
        Scheme::Events => {
            let options = Options {
                until: duration,
                longest: f64::INFINITY,
                strict,
            };
            let drives = bodies.system.drives().iter();
            let mut corners: Vec<f64> = drives.flat_map(|(_, curve)| curve.corners()).collect();
            corners.sort_by(f64::total_cmp);
            corners.dedup();
            dynamic::run_through(&world, start, &options, &corners, &mut gathering)
        }
        Scheme::Steps(steps) => {
            dynamic::step_through(&world, start, duration, steps, &mut gathering)
        }
    };
    let list = |contacts: &[usize]| {
        let names: Vec<String> = (contacts.iter())
            .map(|&i| named(&bodies.system, pairs, &world.bound(i)).to_string())
            .collect();
        names.join("; ")
    };
    let (status, reason) = match &motion.ended {
        Ended::Done => (Status::Done, None),
        Ended::Jammed { contacts } => (
            Status::Jammed,
            Some(match scheme {
                Scheme::Events if !bodies.system.drives().is_empty() => {
                    format!("what is driven cannot go on: {}", list(contacts))
                }
                _ => format!(
                    "no impulses let what moves go on at these contacts: {}",
                    list(contacts)
                ),
            }),
        ),
        Ended::Inconsistent { contacts } => (
            Status::Inconsistent,
            Some(format!(
                "no forces and accelerations agree with friction at these contacts: {}",
                list(contacts)
            )),
        ),
        Ended::Undetermined { contacts } => (
            Status::Undetermined,
            Some(format!(
                "several motions agree with friction at these contacts: {}",
                list(contacts)
            )),
        ),
        Ended::Stuck { .. } if scheme != Scheme::Events => (
            Status::Undetermined,
            Some(match &motion.ended {
                Ended::Stuck { contacts } if !contacts.is_empty() => format!(
                    "contacts do not keep parts apart, which overlap by {:.1e}; take shorter steps: {}",
                    motion.open,
                    list(contacts)
                ),
                _ => "a pair left its space, or joints cannot hold; take shorter steps".to_owned(),
            }),
        ),
        Ended::Stuck { contacts } => {
            let names = list(contacts);
            let why = if names.is_empty() {
                "a pair left the orientations of its space, or joints cannot hold".to_owned()
            } else {
                format!("it cannot be told how it goes on with these contacts: {names}")
            };
            (Status::Undetermined, Some(why))
        }
        Ended::Folded { dead } => {
            let at = bodies.system.dead_point(&bodies.all(&motion.last).q, *dead);
            match dead {
                true => (Status::Jammed, Some(at)),
                false => (Status::Undetermined, Some(at)),
            }
        }
        Ended::Coarse { displacement } => (
            Status::Undetermined,
            Some(format!(
                "parts move by {displacement:.1e} in a step, and may come through each other unseen; take shorter steps"
            )),
        ),
        Ended::TooMany => (
            Status::Undetermined,
            Some(
                "springs or dampers are too stiff, or parts too fast, to be followed; make them softer or slower, or ask for a shorter time"
                    .to_owned(),
            ),
        ),
        Ended::Interrupted => (Status::Interrupted, None),
    };
    let until = motion.last.t;
    if let Ended::Jammed { contacts } = &motion.ended {
        let q = bodies.all(&motion.last).q;
        let jams = contacts.iter().map(|&i| {
            let at = world.place(i, &q).map(|p| [p.x, p.y]);
            let what = named(&bodies.system, pairs, &world.bound(i));
            Event::new(until, EventKind::Jam, what, at)
        });
        gathering.events.extend(jams);
    }
    let end = gathering.told(&motion.last, None);
    let mut samples = gathering.samples;
    // The end is a sample, also where it is none of the even times, or misses one by rounding.
    let rounding = 1e-12 * duration;
    // Numbers too large to be computed with have none.
    let is_finite = end.coordinates.iter().all(|c| c.is_finite());
    if is_finite && samples.last().is_none_or(|s| s.t < until - rounding) {
        samples.push(end);
    }
    let (at_start, at_end) = (energy(&motion.first), energy(&motion.last));
    let work = motion.work;
    let energy = Energy {
        start: at_start,
        end: at_end,
        drives: work.drives,
        friction: work.friction,
        impacts: work.impacts,
        drift: at_end - (at_start + work.drives - work.friction - work.impacts),
    };
    Ok(Record {
        status,
        until,
        reason,
        obstacles: Vec::new(),
        samples,
        trace: gathering.trace,
        events: gathering.events,
        energy: Some(energy),
        open: motion.open,
    })
}
