//! Parts that joints carry, over one cycle of the drives that move them.

use std::collections::{BTreeMap, BTreeSet};

use cspace::{AxisMotion, ComputeError, PairError};
use cspace_model::{Mechanism, shown};
use cspace_motion::cycle::{self, Cycles, NoCycle, PairCycle};
use cspace_plan::clash::{Assembly, Passage, Question as Limits};

use crate::error::Error;
use crate::host::{Host, is_interrupted};
use crate::subject::Subject;

use super::{At, Clearance, Cycle, Halt, Over, Row, failure, row};

/// Pairs that are looked at over a cycle.
#[derive(Default)]
pub(super) struct Found {
    pub(super) rows: Vec<Row>,
    /// How many are farther apart than was asked for.
    pub(super) beyond: usize,
    pairs: BTreeSet<[usize; 2]>,
}

impl Found {
    /// Whether two parts are among them.
    pub(super) fn has(&self, [a, b]: [usize; 2]) -> bool {
        self.pairs.contains(&[a.min(b), a.max(b)])
    }

    /// Their numbers, the lower first.
    pub(super) fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.pairs.iter().copied()
    }
}

/// The pairs of linkages that are asked about, but those whose drives have no cycle, of which a note tells.
pub(super) fn rows(
    subject: &Subject,
    model: &Mechanism,
    assembly: &Assembly<'_>,
    limits: &Limits,
    host: &dyn Host,
) -> Result<Found, Error> {
    let mut found = Found::default();
    if model.dynamics.drives.is_empty() || model.joints.is_empty() {
        return Ok(found);
    }
    let mut cycles = match Cycles::of(model) {
        Ok(cycles) => cycles,
        Err(error) => {
            host.note(&format_args!(
                "no part is looked at over a cycle of the drives: {error}"
            ));
            return Ok(found);
        }
    };
    let mut notes = BTreeSet::new();
    let carried: Vec<bool> = (0..model.parts.len()).map(|i| cycles.carries(i)).collect();
    for (joint, k) in (model.joints.iter()).flat_map(|j| [(j, j.parts.0), (j, j.parts.1)]) {
        let other = joint.parts.0 + joint.parts.1 - k;
        let is_moved = carried[other] || model.dynamics.drives.iter().any(|d| d.part == other);
        let is_driven = model.dynamics.drives.iter().any(|d| d.part == k);
        let stands = (model.parts[k].axis).is_some_and(|a| a.motion == AxisMotion::Fixed);
        if is_moved && !carried[k] && !is_driven && !stands {
            notes.insert(format!(
                "joints and drives alone do not say where part {} goes, so it is not looked at over a cycle",
                shown::quoted(model.parts[k].part.name())
            ));
        }
    }
    let n = model.parts.len();
    let asked: Vec<[usize; 2]> = match limits.pair {
        Some(pair) => vec![pair],
        None => (0..n)
            .flat_map(|i| (i + 1..n).map(move |j| [i, j]))
            .collect(),
    };
    for pair in asked {
        if !cycles.has(pair) {
            continue;
        }
        let mut motion = match cycles.pair(pair) {
            Ok(motion) => motion,
            Err(why) => {
                notes.insert(told(model, &why));
                continue;
            }
        };
        let names = pair.map(|i| shown::text(model.parts[i].part.name()));
        let progress = host.begin(&names.join(","));
        if is_interrupted(&*progress) {
            let interrupted = PairError::Compute(ComputeError::Interrupted);
            return Err(failure(subject, pair, &interrupted, host));
        }
        if motion.reached <= motion.span.times[0] {
            notes.insert(format!(
                "part {}: a dead point, or the end of a range, where the cycle begins: looked at as drawn",
                names[1]
            ));
            continue;
        }
        let [a, b] = pair;
        found.pairs.insert([a.min(b), a.max(b)]);
        match assembly.over(pair, &mut motion, limits) {
            Some(passage) => found
                .rows
                .push(one(model, assembly, pair, &motion, &passage)),
            None => found.beyond += 1,
        }
    }
    for note in notes {
        host.note(&format_args!("{note}"));
    }
    Ok(found)
}

fn told(model: &Mechanism, why: &NoCycle) -> String {
    let name = |i: usize| shown::quoted(model.parts[i].part.name());
    match why {
        NoCycle::Still => {
            "the drives stand still, so that parts carried by joints are looked at as drawn".into()
        }
        NoCycle::Endless(part) => format!(
            "drive of {}: it slides on for ever, so that there is no cycle: give the part a range, or the drive a table",
            name(*part)
        ),
        NoCycle::Extreme(part) => format!(
            "drive of {}: its rate is beyond 1e-60 to 1e60 a second, so that parts carried by joints are looked at as drawn",
            name(*part)
        ),
        NoCycle::Incommensurable([a, b]) => format!(
            "drives of {} and {}: they do not come back together within {} turns, so that there is no cycle: use rates in a ratio of whole numbers, or --along",
            name(*a),
            name(*b),
            cycle::MOST_TURNS
        ),
    }
}

fn one(
    model: &Mechanism,
    assembly: &Assembly<'_>,
    pair: [usize; 2],
    motion: &PairCycle<'_>,
    passage: &Passage,
) -> Row {
    let told = row(model, Over::Cycle, &passage.clash);
    let time = passage.clash.time.unwrap_or(motion.span.times[0]);
    let name = |i: usize| model.parts[i].part.name().to_owned();
    let drives = |time: f64| -> BTreeMap<String, f64> {
        let each = motion.driven.iter();
        each.filter_map(|&i| Some((name(i), motion.drive(i, time)?)))
            .collect()
    };
    let pose = |k: usize| {
        let c = assembly.configuration(pair[k], passage.at[k]);
        [c.x, c.y, c.theta]
    };
    let turns = |i: &usize| {
        let axis = model.parts[*i].axis;
        axis.is_some_and(|a| matches!(a.motion, AxisMotion::Revolute { .. }))
    };
    let is_clear = passage.clash.state == cspace_plan::clash::State::Clear;
    let halt = motion.halt.map(|halt| match halt {
        cycle::Halt::DeadPoint => Halt::DeadPoint,
        cycle::Halt::Range(part) => Halt::Range(name(part)),
    });
    Row {
        content: Clearance {
            // At a dead point poses go with the square root of the time: where exactly it is, is not enclosed.
            least: is_clear.then_some(match motion.halt {
                Some(cycle::Halt::DeadPoint) => 0.0,
                _ => passage.least,
            }),
            at: Some(At::Time(time)),
            cycle: Some(Cycle {
                times: motion.span.times,
                turns: (motion.span.turns.iter())
                    .map(|&(part, turns)| (name(part), turns))
                    .collect(),
                reached: motion.reached,
                halted: match halt {
                    Some(_) => drives(motion.reached),
                    None => BTreeMap::new(),
                },
                halt,
                drives: drives(time),
                poses: [pose(0), pose(1)],
                angles: (motion.driven.iter().filter(|i| turns(i)))
                    .map(|&i| name(i))
                    .collect(),
            }),
            ..told.content
        },
        ..told
    }
}
