//! All pairs of a model: linkages over a cycle, two parts on axes over all motions that their ranges allow, others as drawn.

use std::collections::BTreeMap;

use cspace::{Axis, AxisMotion, ComputeError, Coordinates, FeatureName, PairError, Part};
use cspace_model::{Mechanism, PartPosition, shown};
use cspace_plan::clash::{Assembly, Question as Limits, State};
use cspace_plan::ranges::{self, Held, Pair, Pairs, Stop, Tightest, Verdict};

use crate::error::Error;
use crate::frame::PairAnswer;
use crate::host::{Host, is_interrupted, spaces};
use crate::subject::Subject;

use super::{
    At, Backlash, Clearance, End, Outcome, Over, Row, Stopped, cycle, failure, numbers, order, row,
};

/// All pairs that are asked about, those of linkages over a cycle, those on axes over their ranges and others as drawn, and how many are
/// farther apart than was asked for.
pub(super) fn rows(
    subject: &Subject,
    model: &Mechanism,
    assembly: &Assembly<'_>,
    limits: &Limits,
    host: &dyn Host,
) -> Result<(Vec<Row>, usize), Error> {
    let pairs = Pairs::of(model);
    let linkages = cycle::rows(subject, model, assembly, limits, host)?;
    let on_axes = |pair: [usize; 2]| pairs.has(pair) && !linkages.has(pair);
    let drawn = assembly.drawn_but(limits, |pair| on_axes(pair) || linkages.has(pair));
    let (mut found, mut beyond) = super::rows(model, Over::Drawn, &drawn);
    beyond += linkages.beyond;
    let (asked, count) = match limits.pair {
        Some(pair) => {
            let asked: Vec<_> = Some(pair).into_iter().filter(|&p| on_axes(p)).collect();
            let count = asked.len();
            (asked, count)
        }
        None => {
            let mut near = pairs.near(limits.within);
            near.retain(|&pair| on_axes(pair));
            let both = linkages.pairs().filter(|&pair| pairs.has(pair)).count();
            (near, pairs.count() - both)
        }
    };
    beyond += count - asked.len();
    for pair in asked {
        match over_ranges(subject, model, assembly, limits, pair, host)? {
            Some(row) => found.push(row),
            None => beyond += 1,
        }
    }
    found.extend(linkages.rows);
    order::sort(&mut found);
    Ok((found, beyond))
}

/// One pair; none if it is farther apart than was asked for.
fn over_ranges(
    subject: &Subject,
    model: &Mechanism,
    assembly: &Assembly<'_>,
    limits: &Limits,
    pair: [usize; 2],
    host: &dyn Host,
) -> Result<Option<Row>, Error> {
    // As the model lists them, so that u and v are those of other questions.
    let [a, b] = pair;
    let is_listed = |fixed, moving| {
        let mut pairs = model.pairs.iter();
        pairs.any(|p| p.fixed == fixed && p.moving == moving)
    };
    let pair = match limits.pair.is_none() && !is_listed(a, b) && is_listed(b, a) {
        true => [b, a],
        false => pair,
    };
    let entries = pair.map(|i| &model.parts[i]);
    let start = |i: usize| match model.dynamics.parts.get(i).and_then(|p| p.start) {
        Some(PartPosition::Axis(t)) => t,
        _ => 0.0,
    };
    let Some(moved) = Pair::new(entries, pair.map(start)) else {
        return Ok(None);
    };
    let parts = entries.map(|entry| &entry.part);
    let names = parts.map(|part| part.name().to_owned());
    let everywhere = Limits {
        within: f64::INFINITY,
        ..*limits
    };
    let there = assembly.on_axes(pair, moved.place(), &everywhere);
    if let Some(there) = there.as_ref().filter(|t| t.state == State::Overlap) {
        return Ok(Some(row(model, Over::Ranges, there)));
    }
    let title = format!("{},{}", names[0], names[1]);
    let progress = host.begin(&title);
    let interrupted = PairError::Compute(ComputeError::Interrupted);
    // Spaces of two coordinates are computed without a pause in which to ask.
    let found = match is_interrupted(&*progress) {
        true => Err(interrupted.clone()),
        false => moved.over_ranges(limits.within, &spaces(host, &*progress)),
    };
    let verdict = match found {
        Ok(verdict) => verdict,
        Err(error) => {
            let failure = failure(subject, pair, &error, host);
            if error == interrupted {
                return Err(failure);
            }
            host.warn(&failure);
            Verdict::Undecided("its space cannot be computed")
        }
    };
    let (outcome, content) = match verdict {
        Verdict::Beyond => return Ok(None),
        Verdict::Clear(tightest) => (Outcome::Clear, clear(parts, &tightest)),
        Verdict::Touches(held) => {
            let outcome = match held.ratio {
                Some(_) => Outcome::Meshes,
                None => Outcome::Touches,
            };
            let mut content = touching(entries.map(|entry| entry.axis), parts, &held);
            if let (None, Some(there)) = (&content.touching, &there) {
                content.touching = row(model, Over::Ranges, there).content.touching;
            }
            (outcome, content)
        }
        Verdict::Undecided(why) => {
            host.note(&format_args!(
                "pair {}: undecided: {why}",
                shown::text(&title)
            ));
            (Outcome::Undecided, Clearance::nothing(Over::Ranges))
        }
    };
    let [fixed, moving] = names;
    Ok(Some(PairAnswer {
        fixed,
        moving,
        outcome,
        content,
    }))
}

fn place((u, v): (f64, f64)) -> Coordinates {
    Coordinates::Axes { u, v }
}

fn clear([a, b]: [&Part; 2], tightest: &Tightest) -> Clearance {
    Clearance {
        gap: Some(tightest.gap),
        least: Some(tightest.least),
        points: tightest.points.map(numbers),
        touching: (tightest.features).map(|[f, g]| [a.feature_text(f), b.feature_text(g)]),
        at: Some(At::Place(place(tightest.at))),
        ..Clearance::nothing(Over::Ranges)
    }
}

fn touching(axes: [Option<Axis>; 2], parts: [&Part; 2], held: &Held) -> Clearance {
    let texts = |&[f, g]: &[FeatureName; 2]| [parts[0].feature_text(f), parts[1].feature_text(g)];
    let finite = |x: f64| Some(x).filter(|x| x.is_finite());
    let moves = |k: usize| axes[k].is_some_and(|a| a.motion != AxisMotion::Fixed);
    let reach: BTreeMap<_, _> = (0..2)
        .filter(|&k| moves(k))
        .map(|k| {
            let limits = held.reach[k];
            let name = parts[k].name().to_owned();
            (name, [finite(limits.lo), finite(limits.hi)])
        })
        .collect();
    let stopped = |stop: &Stop| {
        let axis = axes[stop.part];
        let range = axis.and_then(|a| a.range);
        Stopped {
            part: parts[stop.part].name().to_owned(),
            end: match stop.end {
                ranges::End::Lo => End::Lo,
                ranges::End::Hi => End::Hi,
            },
            of: range.map(|(lo, hi)| match stop.end {
                ranges::End::Lo => lo,
                ranges::End::Hi => hi,
            }),
            at: place(stop.at),
            touching: stop.features.iter().map(texts).collect(),
            turns: axis.is_some_and(|a| matches!(a.motion, AxisMotion::Revolute { .. })),
        }
    };
    Clearance {
        gap: Some(0.0),
        points: held.points.map(numbers),
        touching: held.features.first().map(texts),
        at: held.at.map(|at| At::Place(place(at))),
        reach,
        room: held.room,
        stopped: held.stopped.iter().map(stopped).collect(),
        ratio: held.ratio.map(|(v, u)| v as f64 / u as f64),
        backlash: held.backlash.map(|b| Backlash {
            least: b.least,
            most: b.most,
            at: place(b.at),
        }),
        ..Clearance::nothing(Over::Ranges)
    }
}
