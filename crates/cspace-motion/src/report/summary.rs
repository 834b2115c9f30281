//! A motion in sentences.

use core::f64::consts::TAU;

use cspace::AxisMotion;

use super::contacts::{ContactInterval, together};
use super::cycle::{Cycle, PartCycle};
use super::drops::Drop;
use super::number::{bare_length, brief, degrees, length, percent, plain, with_unit};
use super::peaks::{Peaks, sentences as forces};
use super::phase::Clock;
use super::trajectory::Trajectory;
use crate::record::Record;
use crate::system::{PartCoordinates, System};

/// A part that moves by less than this in a cycle, relative to the size of the mechanism, has play and does not swing.
const SWINGS: f64 = 1e-3;
/// Share of the largest rate below which a part stands still.
const STILL: f64 = 1e-6;
/// Rests shorter than this share of a cycle are not reported.
const RESTS: f64 = 0.05;
/// Shortest gap in a contact, relative to the duration.
const NEAR: f64 = 1e-9;
/// Largest number of time spans that are listed; of more, only the number is given.
const MOST_SPANS: usize = 2;

/// Findings on a motion.
pub(super) struct Found<'a> {
    pub(super) contacts: &'a [ContactInterval],
    pub(super) cycle: Option<&'a Cycle>,
    pub(super) drops: &'a [Drop],
    pub(super) peaks: Option<&'a Peaks>,
}

/// Sentences of the report: the cycle, the motion of each part in it, drops, contacts, forces.
pub(super) fn sentences(
    system: &System,
    record: &Record,
    trajectory: &Trajectory<'_>,
    report: &Found<'_>,
) -> Vec<String> {
    let teller = Teller {
        system,
        record,
        trajectory,
        clock: Clock::of(system),
    };
    let mut all = Vec::new();
    if let Some(cycle) = &report.cycle {
        all.push(teller.cycle(cycle));
        all.extend(cycle.parts.iter().filter_map(|p| teller.part(cycle, p)));
        all.extend(cycle.parts.iter().filter_map(|p| teller.rests(cycle, p)));
    }
    all.extend(teller.drops(report));
    all.extend(teller.spares(report));
    all.extend(teller.contacts(report));
    let peaks = report
        .peaks
        .map(|p| forces(system, record, p, &teller.clock));
    all.extend(peaks.into_iter().flatten());
    all
}

struct Teller<'a> {
    system: &'a System,
    record: &'a Record,
    trajectory: &'a Trajectory<'a>,
    clock: Clock<'a>,
}

impl Teller<'_> {
    fn name(&self, part: usize) -> &str {
        self.system.mechanism().parts[part].part.name()
    }

    fn turns(&self, part: usize) -> bool {
        matches!(
            self.system.parts()[part],
            PartCoordinates::Axis {
                motion: AxisMotion::Revolute { .. },
                ..
            }
        )
    }

    /// A motion of a part on its axis.
    fn amount(&self, part: usize, x: f64) -> String {
        let mechanism = self.system.mechanism();
        match self.turns(part) {
            true => degrees(x),
            false => length(mechanism, x, mechanism.parts[part].part.size()),
        }
    }

    /// Advance of the driver per cycle.
    fn driven(&self, cycle: &Cycle) -> Option<f64> {
        let driver = self.clock.driver()?;
        let of = cycle.parts.iter().find(|p| p.part == driver)?;
        Some(of.advance[0]).filter(|a| *a != 0.0)
    }

    fn cycle(&self, cycle: &Cycle) -> String {
        let mut text = format!("a cycle takes {} s", brief(cycle.period, 6));
        if let (Some(driven), Some(name)) = (self.driven(cycle), self.clock.name()) {
            let turns = driven.abs() / TAU;
            text += &match turns {
                t if (t - 1.0).abs() < 1e-9 => format!(", a turn of the {name}"),
                t if (t - t.round()).abs() < 1e-9 => format!(", {t:.0} turns of the {name}"),
                _ => format!(", {} of the {name}", degrees(driven.abs())),
            };
        }
        /// Share of the time within which a motion counts as periodic from the start.
        const AT_ONCE: f64 = 0.01;
        let late = cycle.since > AT_ONCE * self.record.until;
        if late {
            text += &format!("; the motion repeats from {} s on", plain(cycle.since, 3));
        }
        text
    }

    /// Motion of a part in a cycle; `None` for the driver that serves as the clock.
    fn part(&self, cycle: &Cycle, p: &PartCycle) -> Option<String> {
        if self.clock.driver() == Some(p.part) {
            return None;
        }
        let name = self.name(p.part);
        let mechanism = self.system.mechanism();
        let size = mechanism.parts[p.part].part.size();
        if let [x, y, _] = p.advance[..] {
            let far = x.hypot(y) > SWINGS * self.system.size();
            let [x, y] = [x, y].map(|c| bare_length(c, size));
            let by = with_unit(mechanism, &format!("({x}, {y})"));
            return far.then(|| format!("the {name} moves on by {by} per cycle"));
        }
        let advance = p.advance[0];
        if advance != 0.0 {
            return Some(self.advances(cycle, p.part, advance));
        }
        let coordinate = self.system.parts()[p.part].indices().start;
        let stroke = p.stroke(0) * self.system.lengths()[coordinate];
        (stroke > SWINGS * self.system.size()).then(|| {
            let does = match self.turns(p.part) {
                true => "swings through",
                false => "slides to and fro by",
            };
            let [stroke, to] = [p.stroke(0), p.greatest[0]].map(|x| self.amount(p.part, x));
            let from = match self.turns(p.part) {
                true => plain(p.least[0].to_degrees(), 3),
                false => bare_length(p.least[0], size),
            };
            format!("the {name} {does} {stroke}, from {from} to {to}")
        })
    }

    fn advances(&self, cycle: &Cycle, part: usize, advance: f64) -> String {
        let name = self.name(part);
        let does = if self.turns(part) {
            "turns"
        } else {
            "moves on by"
        };
        let Some((driven, driver)) = self.driven(cycle).zip(self.clock.name()) else {
            let way = match (self.turns(part), advance > 0.0) {
                (true, true) => " counter-clockwise",
                (true, false) => " clockwise",
                (false, _) => "",
            };
            let shown = if self.turns(part) {
                advance.abs()
            } else {
                advance
            };
            return format!(
                "the {name} {does} {}{way} per cycle",
                self.amount(part, shown)
            );
        };
        let ratio = advance / driven;
        if !self.turns(part) {
            let by = self.amount(part, ratio * TAU * driven.signum());
            return format!("the {name} {does} {by} per turn of the {driver}");
        }
        let way = if ratio < 0.0 { ", the other way" } else { "" };
        let text = format!(
            "the {name} turns {} per turn of the {driver}{way}",
            degrees(ratio.abs() * TAU)
        );
        match self.is_even(part, cycle) {
            true => format!("{text}; the ratio is {}", brief(ratio, 7)),
            false => text,
        }
    }

    /// Whether a part that advances does so at about a constant rate, as gears do: wheels that advance in steps have no
    /// ratio at any time.
    fn is_even(&self, part: usize, cycle: &Cycle) -> bool {
        /// Range of the rates, as multiples of the mean rate.
        const ABOUT: core::ops::Range<f64> = 0.5..2.0;
        let i = self.system.parts()[part].indices().start;
        let until = self.trajectory.span().1;
        let mut advance = cycle.parts.iter().filter(|p| p.part == part);
        let mean = advance.next().map_or(0.0, |p| p.advance[0] / cycle.period);
        let knots = self.trajectory.knots().iter();
        let mut recent = knots.filter(|k| k.t >= until - cycle.period);
        recent.all(|k| ABOUT.contains(&(k.rates.get(i).map_or(0.0, |r| r / mean))))
    }

    /// The spans of the last cycle in which a part on its axis does not move.
    fn still(&self, part: usize, cycle: &Cycle) -> Vec<(f64, f64)> {
        let i = self.system.parts()[part].indices().start;
        let until = self.trajectory.span().1;
        let begin = until - cycle.period;
        let rate = |k: &crate::record::Sample| k.rates.get(i).map_or(0.0, |r| r.abs());
        let knots = self.trajectory.knots();
        let recent = knots.iter().filter(|k| k.t >= begin);
        let greatest = recent.map(|k| rate(k)).fold(0.0, f64::max);
        let mut spans: Vec<(f64, f64)> = Vec::new();
        for pair in knots.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let (from, to) = (a.t.max(begin), b.t);
            if to <= from || rate(a).max(rate(b)) > STILL * greatest {
                continue;
            }
            match spans.last_mut() {
                Some(last) if from - last.1 <= NEAR * until => last.1 = to,
                _ => spans.push((from, to)),
            }
        }
        // A span that continues over the end of the cycle is one span.
        let ends = (spans.first().copied()).zip(spans.last().copied());
        if let Some((first, last)) = ends
            && spans.len() > 1
            && first.0 - begin <= NEAR * until
            && until - last.1 <= NEAR * until
        {
            spans.pop();
            spans[0].0 = last.0 - cycle.period;
        }
        spans.retain(|(a, b)| b - a > RESTS * cycle.period);
        spans
    }

    fn rests(&self, cycle: &Cycle, p: &PartCycle) -> Option<String> {
        if p.advance.len() != 1 || self.clock.driver() == Some(p.part) {
            return None;
        }
        let coordinate = self.system.parts()[p.part].indices().start;
        let moved = (p.stroke(0)) * self.system.lengths()[coordinate];
        let spans = self.still(p.part, cycle);
        if spans.is_empty() || moved <= SWINGS * self.system.size() {
            return None;
        }
        let share: f64 = spans.iter().map(|(a, b)| b - a).sum::<f64>() / cycle.period;
        let when = self.when(&spans, share);
        Some(format!("the {} stands still {when}", self.name(p.part)))
    }

    /// `from 10.0 to 20.0 deg of the driver (3 % of the cycle)`.
    fn when(&self, spans: &[(f64, f64)], share: f64) -> String {
        let share = percent(share);
        match spans.len() {
            n if n > MOST_SPANS => format!("{n} times in a cycle, for {share} of it"),
            _ => format!("{} ({share} of the cycle)", self.clock.spans(spans)),
        }
    }

    /// Sentences on the excess of strokes over the steps for which they are there, once for each part that swings.
    fn spares(&self, report: &Found<'_>) -> Vec<String> {
        let mut told: Vec<usize> = Vec::new();
        let mut all = Vec::new();
        for swing in report.drops.iter().filter_map(|d| d.swing) {
            if let Some(spare) = swing.spare.filter(|_| !told.contains(&swing.part)) {
                told.push(swing.part);
                let spare = self.amount(swing.part, spare);
                let name = self.name(swing.part);
                all.push(format!("{spare} of the stroke of the {name} are to spare"));
            }
        }
        all
    }

    fn drops(&self, report: &Found<'_>) -> Vec<String> {
        (report.drops.iter())
            .map(|d| {
                let mut text = format!(
                    "the {} drops off the {} at {}",
                    self.name(d.part),
                    self.name(d.off),
                    self.clock.at(d.leaves),
                );
                if d.lands > d.leaves {
                    text += &format!(" and lands at {}", self.clock.again(d.lands));
                }
                if let Some(swing) = d.swing {
                    let carrier = self.name(swing.part);
                    let more = self.amount(swing.part, swing.goes_on);
                    text += &format!("; the {carrier} goes on by {more} before it turns back");
                }
                text
            })
            .collect()
    }

    fn contacts(&self, report: &Found<'_>) -> Vec<String> {
        let until = self.record.until;
        let near = NEAR * until;
        let mechanism = self.system.mechanism();
        let mut all = Vec::new();
        for pair in &mechanism.pairs {
            let [a, b] = [pair.fixed, pair.moving].map(|i| self.name(i));
            let spans = together(report.contacts, [a, b], until, near);
            let Some(last) = spans.iter().rev().find(|s| s.1 < until - near) else {
                // It is open to the end, or not at all.
                if let Some((from, _)) = spans.first() {
                    let since = match *from > NEAR.max(RESTS * 0.2) * until {
                        true => format!(" from {} s on", plain(*from, 3)),
                        false => " all the time".to_owned(),
                    };
                    all.push(format!("{a} and {b} touch{since}"));
                }
                continue;
            };
            let Some(cycle) = &report.cycle else {
                let sum: f64 = spans.iter().map(|(a, b)| b - a).sum();
                let share = percent(sum / until);
                all.push(format!("{a} and {b} touch for {share} of the time"));
                continue;
            };
            let begin = last.1 - cycle.period + near;
            let in_cycle = spans.iter().filter(|s| s.1 > begin && s.1 <= last.1);
            let in_cycle: Vec<(f64, f64)> = in_cycle.copied().collect();
            let share: f64 = in_cycle.iter().map(|(a, b)| b - a).sum::<f64>() / cycle.period;
            all.push(match in_cycle.len() {
                n if n > MOST_SPANS => format!(
                    "{a} and {b} touch {n} times in a cycle, for {} of it",
                    percent(share)
                ),
                _ => format!(
                    "contact between {a} and {b} lasts {}",
                    self.when(&in_cycle, share)
                ),
            });
        }
        all
    }
}
