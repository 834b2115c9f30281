//! A mechanism with masses followed in steps of one length.

use crate::contact::named;
use crate::dynamic::{Ended, State, step_through};
use crate::error::SimulateError;
use crate::pairs::Pairs;
use crate::record::{Energy, Record, Status};
use crate::system::System;

use super::bodies::Bodies;
use super::forces::{kinetic, potential};
use super::observer::Gathering;
use super::world::Mechanical;

/// Follows the motion of a mechanism from coordinates and rates of its parts' frames for some time, in so many steps.
pub(crate) fn step(
    system: System,
    pairs: &Pairs,
    (mut q, mut v): (Vec<f64>, Vec<f64>),
    (duration, every, steps): (f64, f64, usize),
    progress: &dyn Fn(f64) -> bool,
) -> Result<Record, SimulateError> {
    system.shift(&mut q, &mut v, false);
    let bodies = Bodies::new(system)?;
    let world = Mechanical::new(&bodies, pairs);
    let start = State {
        t: 0.0,
        q: bodies.free(&q),
        v: bodies.free(&v),
    };
    let energy = |state: &State| {
        let all = bodies.all(state);
        kinetic(&bodies, &all) + potential(&bodies, &all.q)
    };
    let mut gathering = Gathering {
        world: &world,
        every,
        duration,
        samples: Vec::new(),
        events: Vec::new(),
        trace: Vec::new(),
        progress,
    };
    let at_start = energy(&start);
    let motion = step_through(&world, start, duration, steps, &mut gathering);
    let list = |contacts: &[usize]| {
        let names: Vec<String> = (contacts.iter())
            .map(|&i| named(&bodies.system, pairs, &world.bound(i)).to_string())
            .collect();
        names.join("; ")
    };
    let (status, reason) = match &motion.ended {
        Ended::Done => (Status::Done, None),
        Ended::Interrupted => return Err(SimulateError::Interrupted),
        Ended::Jammed { contacts } => (
            Status::Jammed,
            Some(format!(
                "no impulses let what moves go on at these contacts: {}",
                list(contacts)
            )),
        ),
        _ => (
            Status::Undetermined,
            Some("a pair left its space, or joints cannot hold; take shorter steps".to_owned()),
        ),
    };
    let until = motion.last.t;
    let end = gathering.told(&motion.last, None);
    let mut samples = gathering.samples;
    // The end is a sample, also where it is none of the even times, or misses one by rounding.
    let rounding = 1e-12 * duration;
    if samples.last().is_none_or(|s| s.t < until - rounding) {
        samples.push(end);
    }
    let at_end = energy(&motion.last);
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
