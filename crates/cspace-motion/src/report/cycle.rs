//! Detection of the cycle in which a motion repeats.

use core::f64::consts::TAU;

use cspace::AxisMotion;
use cspace::part::SYMMETRIC;

use super::trajectory::Trajectory;
use crate::record::{Event, EventKind, Record, What};
use crate::system::{PartCoordinates, System};

/// Tolerance to which a motion must repeat, relative to the size of the mechanism: a motion that settles approaches its
/// cycle, and hardly ever reaches it.
const REPEATS: f64 = 1e-4;
/// In a cycle something moves by at least this, relative to the size of the mechanism: far more than the error of the
/// motion.
const MOVES: f64 = 1e-2;
/// The motion must have been seen to repeat for this share of a cycle.
const SEEN: f64 = 0.5;
/// As above, if a part goes on without returning to its place.
const SEEN_ADVANCING: f64 = 1.0;
/// Times at which a period is looked at before it is at all of them.
const LOOKS: usize = 16;
/// Largest number of periods tried for each drive, and for events.
const MOST_TRIED: usize = 2000;
/// Times nearer than this are one, relative to the duration: twice the error of an event's time.
const SAME: f64 = 1e-8;

/// The cycle in which a motion repeats.
#[derive(Debug, Clone, PartialEq)]
pub struct Cycle {
    /// Period, in seconds.
    pub period: f64,
    /// The motion repeats from this time on: before, it settles.
    pub since: f64,
    /// Largest difference of two cycles, in the model's unit of length, with angles multiplied by the sizes of their
    /// parts.
    pub difference: f64,
    /// The part that is driven to turn at a constant rate, if there is one: the first. Ratios are by its advance.
    pub driver: Option<usize>,
    /// Motion of each movable part in the cycle, in the order of the mechanism.
    pub parts: Vec<PartCycle>,
}

impl Cycle {
    /// The advance of a part on its axis by that of the driver: for parts that turn the ratio of transmission, for others a
    /// length per radian.
    pub fn ratio(&self, part: usize) -> Option<f64> {
        let advance = |i: usize| match self.parts.iter().find(|p| p.part == i)?.advance[..] {
            [u] => Some(u),
            _ => None,
        };
        let by = advance(self.driver?)?;
        (by != 0.0).then_some(advance(part)? / by)
    }
}

/// Motion of a part in a cycle, for each of its coordinates: u, or x, y and θ. Lengths are in the model's unit, angles
/// in radians.
#[derive(Debug, Clone, PartialEq)]
pub struct PartCycle {
    /// The index of the part.
    pub part: usize,
    /// Advance per cycle; 0 if the coordinate returns.
    pub advance: Vec<f64>,
    /// Smallest values in the last cycle.
    pub least: Vec<f64>,
    /// Largest values in the last cycle.
    pub greatest: Vec<f64>,
}

impl PartCycle {
    /// Stroke of a coordinate: from its smallest to its largest value.
    pub fn stroke(&self, coordinate: usize) -> f64 {
        self.greatest[coordinate] - self.least[coordinate]
    }
}

/// Difference of a coordinate that is allowed between two equal states.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    /// Whole multiples.
    Whole(f64),
    /// Any difference: a round part on its axis has no marks, and a part that slides on moves evenly.
    Any,
}

/// The shortest cycle of a motion, if it repeats at its end.
pub(super) fn find(system: &System, record: &Record, trajectory: &Trajectory<'_>) -> Option<Cycle> {
    let steps = steps(system);
    candidates(system, record, &steps)
        .into_iter()
        .find_map(|period| repeats(system, record, trajectory, &steps, period))
}

fn steps(system: &System) -> Vec<Step> {
    let mut steps = vec![Step::Any; system.count()];
    for (entry, part) in system.mechanism().parts.iter().zip(system.parts()) {
        let Some(i) = part.orientation() else {
            continue;
        };
        steps[i] = Step::Whole(TAU);
        if let PartCoordinates::Axis {
            motion: AxisMotion::Revolute { center },
            ..
        } = *part
        {
            let symmetry = entry.part.symmetry();
            let near = SYMMETRIC * entry.part.size();
            let is_central = symmetry.center().distance(center) <= near;
            steps[i] = match (is_central, symmetry.is_round()) {
                (true, true) => Step::Any,
                (true, false) => Step::Whole(TAU / f64::from(symmetry.fold().max(1))),
                (false, _) => Step::Whole(TAU),
            };
        }
    }
    steps
}

/// Periods that come into question, the shortest first: whole steps of parts that are driven evenly, and times between
/// events that are alike.
fn candidates(system: &System, record: &Record, steps: &[Step]) -> Vec<f64> {
    let longest = record.until / (1.0 + SEEN);
    let mut all = Vec::new();
    for (i, curve) in system.drives() {
        if let (Some(rate), Step::Whole(step)) = (curve.even_rate(), steps[*i])
            && rate != 0.0
        {
            let one = step / rate.abs();
            let multiples = (1..=MOST_TRIED).map(|k| k as f64 * one);
            all.extend(multiples.take_while(|t| *t <= longest * (1.0 + SAME)));
        }
    }
    let driven = all.clone();
    // The period of a drive is exact.
    let is_driven = |t: f64| driven.iter().any(|d| (d - t).abs() <= SAME * record.until);
    let mut tried = 0;
    let mut told: Vec<&Event> = Vec::new();
    for (k, last) in record.events.iter().enumerate().rev() {
        if tried > MOST_TRIED || told.iter().any(|e| alike(e, last)) {
            continue;
        }
        told.push(last);
        let before = record.events[..k].iter().rev().filter(|e| alike(e, last));
        for event in before.take(MOST_TRIED) {
            tried += 1;
            let period = last.t - event.t;
            if !is_driven(period) {
                all.push(period);
            }
        }
    }
    all.retain(|t| *t > SAME * record.until && *t <= longest * (1.0 + SAME));
    all.sort_by(f64::total_cmp);
    all.dedup_by(|b, a| *b - *a <= 1e-12 * record.until);
    all
}

/// Events of one kind and of the same parts. Features are not compared: the next tooth is as good.
fn alike(a: &Event, b: &Event) -> bool {
    let parts = match (&a.what, &b.what) {
        (
            What::Contact { fixed, moving, .. },
            What::Contact {
                fixed: f,
                moving: m,
                ..
            },
        ) => fixed == f && moving == m,
        (a, b) => a == b,
    };
    a.kind == b.kind && parts
}

fn repeats(
    system: &System,
    record: &Record,
    trajectory: &Trajectory<'_>,
    steps: &[Step],
    period: f64,
) -> Option<Cycle> {
    let until = trajectory.span().1;
    let start = (until - period).max(0.0);
    let (size, lengths) = (system.size(), system.lengths());
    let most = REPEATS * size;
    let n = system.count();
    let mut advance = Vec::new();
    for i in 0..n {
        let found = trajectory.at(until, i) - trajectory.at(start, i);
        let whole = match steps[i] {
            Step::Whole(step) => (found / step).round() * step + 0.0,
            // A coordinate that returns does so exactly.
            Step::Any if found.abs() * lengths[i] <= most => 0.0,
            Step::Any => found,
        };
        if (found - whole).abs() * lengths[i] > most {
            return None;
        }
        advance.push(whole);
    }
    let off = |advance: &[f64], t: f64| {
        let each = (0..n).map(|i| {
            let gone = trajectory.at(t + period, i) - trajectory.at(t, i);
            (gone - advance[i]).abs() * lengths[i]
        });
        each.fold(0.0, f64::max)
    };
    // Most periods do not pass a look at a few times.
    let slides = (0..n).any(|i| steps[i] == Step::Any && advance[i] != 0.0);
    let seen = if slides { SEEN_ADVANCING } else { SEEN };
    let looks = (1..=LOOKS).map(|k| k as f64 / LOOKS as f64);
    if looks.into_iter().any(|share| {
        let t = start - share * seen * period;
        t < -SAME * record.until || off(&advance, t.max(0.0)) > most
    }) {
        return None;
    }
    let ranges: Vec<(f64, f64)> = (0..n).map(|i| trajectory.extent(i, start, until)).collect();
    // What goes on evenly repeats in any time.
    let is_even = |i: usize| {
        let half = trajectory.at(start + 0.5 * period, i) - trajectory.at(start, i);
        let is_half = (half - 0.5 * advance[i]).abs() * lengths[i] <= most;
        steps[i] == Step::Any && advance[i] != 0.0 && is_half
    };
    let moves = |i: usize| (ranges[i].1 - ranges[i].0) * lengths[i] >= MOVES * size;
    if !(0..n).any(|i| moves(i) && !is_even(i)) {
        return None;
    }
    for (i, gone) in advance.iter_mut().enumerate() {
        if steps[i] == Step::Any && *gone != 0.0 {
            *gone = exact_advance(trajectory, i, period, until).unwrap_or(*gone);
        }
    }
    // Every moment that is known, of this cycle and the next, back from the end.
    let (mut since, mut difference) = (start, 0.0_f64);
    let here = trajectory.back_from(start, 0.0);
    let next = trajectory.back_from(start, period);
    // Where parts go to another place at once, they are at both.
    let near = SAME * record.until;
    let snaps = record.events.iter().filter(|e| e.kind == EventKind::Snap);
    let snaps: Vec<f64> = snaps.map(|e| e.t).collect();
    let is_torn = |t: f64| {
        let at = |time: f64| snaps.iter().any(|s| (s - time).abs() <= near);
        at(t) || at(t + period)
    };
    let moments = merged(here, next).take_while(|t| *t >= 0.0);
    for t in moments.filter(|t| !is_torn(*t)) {
        let here = off(&advance, t);
        if here > most {
            break;
        }
        difference = difference.max(here);
        since = t;
    }
    if start - since < seen * period * (1.0 - SAME) {
        return None;
    }
    let since = since.max(last_change(record, start, period));
    if start - since < seen * period * (1.0 - SAME) {
        return None;
    }
    let parts = (system.parts().iter().enumerate())
        .filter(|(_, p)| !p.indices().is_empty())
        .map(|(part, p)| PartCycle {
            part,
            advance: p.indices().map(|i| advance[i]).collect(),
            least: p.indices().map(|i| ranges[i].0).collect(),
            greatest: p.indices().map(|i| ranges[i].1).collect(),
        })
        .collect();
    Some(Cycle {
        period,
        since,
        difference,
        driver: super::phase::Clock::of(system).driver(),
        parts,
    })
}

/// Two falling sequences as one.
fn merged(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
    let (mut a, mut b) = (a.peekable(), b.peekable());
    core::iter::from_fn(move || match (a.peek(), b.peek()) {
        (Some(s), Some(t)) if s < t => b.next(),
        (None, _) => b.next(),
        _ => a.next(),
    })
}

/// The advance between two moments that are both known, if there are such.
fn exact_advance(trajectory: &Trajectory<'_>, i: usize, period: f64, until: f64) -> Option<f64> {
    let near = 1e-12 * until;
    trajectory.knots().iter().rev().find_map(|k| {
        let before = trajectory.nearest(k.t - period)?;
        let fits = (k.t - before.t - period).abs() <= near;
        fits.then(|| k.coordinates[i] - before.coordinates[i])
    })
}

/// The last time before `to` at which something happens that does not happen again a period later, or happens anew then.
fn last_change(record: &Record, to: f64, period: f64) -> f64 {
    let near = REPEATS * period;
    let has = |event: &Event, at: f64| {
        let first = record.events.partition_point(|e| e.t < at - near);
        let mut near_by = record.events[first..]
            .iter()
            .take_while(|e| e.t <= at + near);
        near_by.any(|e| alike(e, event))
    };
    // A settling motion may have events of sticking or not; an event at the end may come a little later.
    let counts = |e: &&Event| !matches!(e.kind, EventKind::Stick | EventKind::Slip);
    let events = || record.events.iter().filter(counts);
    let gone = (events().filter(|e| e.t < to - near && !has(e, e.t + period))).map(|e| e.t);
    let new = events()
        .filter(|e| e.t >= period && e.t < to + period - near && !has(e, e.t - period))
        .map(|e| e.t - period);
    gone.chain(new).fold(0.0, f64::max)
}
