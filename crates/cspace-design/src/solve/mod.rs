//! Values of parameters at which a quantity is what it must be.
//!
//! For one parameter the quantity is measured at values evenly over the range, with its derivatives. Between two of them it crosses the
//! value that is asked for where its sign changes, and may touch or cross it twice where it comes nearer from both sides. Crossings are
//! found by Newton's method within brackets, to rounding.
//!
//! For several parameters the change is sought that is smallest relative to the ranges: each step goes to the nearest place at which
//! the quantity, linear by its derivatives, is as asked for.

mod line;
mod problem;
mod several;
mod words;

use cspace::{Coordinates, Progress, parallel};
use cspace_model::PairEntry;
use cspace_model::model::{
    Coordinate, Dimension, Quantity, Requirement, Setting, Subject, Template,
};

use crate::value::Value;

use line::{Found, Line};
use problem::{At, Problem};
pub use problem::{Goal, Relation, Solved, Span};
use words::Words;

/// Values of one parameter between which nothing is resolved, relative to its range.
const RESOLUTION: f64 = 1e-12;

/// A quantity that is the value over less than this, relative to the range, is so at one place.
const PLACE: f64 = 1e-6;

/// Finds values of parameters at which a requirement's quantity is as asked for.
///
/// An equation in one parameter has every solution found, to rounding, but for those that lie between two of `samples` values with the
/// quantity on one side of them and going away from it. The requirement's limits do not matter.
pub fn solve(
    template: &Template,
    set: &[Setting],
    spans: &[Span],
    goal: &Goal,
    samples: usize,
    progress: &dyn Progress,
) -> Solved {
    let problem = Problem {
        template,
        set,
        spans,
        goal,
        own: None,
        progress,
    };
    match spans {
        [] => Solved {
            none: Some("nothing is varied".to_owned()),
            ..Solved::default()
        },
        [span] => problem.in_one(span, samples),
        _ => problem.in_several(),
    }
}

/// Where a contact is to be: what is first hit on a straight motion has this coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactGoal {
    /// The pair.
    pub pair: PairEntry,
    /// Where the motion begins: free, whatever the parameters.
    pub from: Coordinates,
    /// Its whole displacement.
    pub along: Coordinates,
    /// Which coordinate counts.
    pub of: Coordinate,
    /// Its value at the contact (the model's unit or radians).
    pub value: f64,
}

/// Finds the values of parameters that put a contact where it is wanted, and whose change is smallest relative to the ranges.
///
/// The contact is that of the first hit q(p) of a straight motion: each step solves qᵢ(p) + ∇qᵢ·Δp = value for the smallest Δp, by exact
/// derivatives.
///
/// ```
/// use cspace::{Configuration, Coordinates, Silent};
/// use cspace_design::{ContactGoal, Span, put_contact};
/// use cspace_model::Host;
/// use cspace_model::model::{Coordinate, Template};
/// // A disc of radius r touches the wall at x = 10 - r.
/// let text = r#"
/// [parameter]
/// r = 3
/// [[part]]
/// name = "wall"
/// loops = [[[10, -20], [15, -20], [15, 20], [10, 20]]]
/// [[part]]
/// name = "disc"
/// loops = [{ circle = "r", at = [0, 0] }]
/// "#;
/// let template = Template::from_text(text.to_owned(), "disc.toml")?;
/// let at = |x| Coordinates::Planar(Configuration::new(x, 0.0, 0.0));
/// let goal = ContactGoal {
///     pair: template.model(&Host::default())?.mechanism.pairs[0],
///     from: at(0.0),
///     along: at(20.0),
///     of: Coordinate::X,
///     value: 7.5,
/// };
/// let spans = [Span { parameter: "r".into(), lo: 2.0, hi: 4.0 }];
/// let solved = put_contact(&template, &[], &spans, &goal, &Silent);
/// assert!((solved.solutions[0][0] - 2.5).abs() < 1e-9);
/// # Ok::<(), cspace_model::ModelError>(())
/// ```
pub fn put_contact(
    template: &Template,
    set: &[Setting],
    spans: &[Span],
    wanted: &ContactGoal,
    progress: &dyn Progress,
) -> Solved {
    let requirement = Requirement {
        name: "contact".to_owned(),
        subject: Subject::Pair(
            wanted.pair,
            Quantity::Position {
                from: wanted.from,
                along: wanted.along,
                of: wanted.of,
            },
        ),
        dimension: Dimension::Number,
        target: None,
    };
    let goal = Goal {
        requirement: requirement.name.clone(),
        relation: Relation::Equal,
        value: Value::Number(wanted.value),
    };
    let problem = Problem {
        template,
        set,
        spans,
        goal: &goal,
        own: Some(&requirement),
        progress,
    };
    problem.near_given()
}

impl Problem<'_> {
    fn in_one(&self, span: &Span, samples: usize) -> Solved {
        let n = samples.max(2);
        let step = (span.hi - span.lo) / (n - 1) as f64;
        let values: Vec<f64> = (0..n)
            .map(|i| {
                if i == n - 1 {
                    span.hi
                } else {
                    span.lo + step * i as f64
                }
            })
            .collect();
        let measured: Vec<At> = parallel::map(&values, 1, |p| self.at(&[*p]));
        let known: Vec<(f64, At)> = values.into_iter().zip(measured).collect();
        let line = Line {
            problem: self,
            least: RESOLUTION * (span.hi - span.lo),
            place: PLACE * (span.hi - span.lo),
            zero: self.zero(known.iter().map(|k| &k.1)),
        };
        let neighbours: Vec<_> = known.windows(2).collect();
        let parts = parallel::map(&neighbours, 1, |w| {
            let mut found = Found::default();
            line.search(&w[0], &w[1], &mut found);
            found
        });
        let mut all = Found::default();
        for part in parts {
            all.stretches.extend(part.stretches);
            all.breaks.extend(part.breaks);
            all.jumps.extend(part.jumps);
            all.left.extend(part.left);
        }
        all.join(line.place);
        let given = self.given()[0];
        let is_number = matches!(self.goal.value, Value::Number(_));
        if is_number && self.goal.relation == Relation::Equal {
            // Where it is so over a range, the value in it that is nearest to the model's own.
            let solutions = all
                .stretches
                .iter()
                .map(|&(lo, hi)| vec![given.clamp(lo, hi)]);
            let wide = all.stretches.iter().copied().filter(|(lo, hi)| lo < hi);
            return Solved {
                solutions: solutions.collect(),
                ranges: wide.collect(),
                undecided: self.undecided(span, &all, &known),
                none: all.stretches.is_empty().then(|| self.nothing(&known, &all)),
            };
        }
        let ranges = self.ranges(span, &all, &known, line.zero);
        let nearest = (ranges.iter())
            .map(|&(lo, hi)| given.clamp(lo, hi))
            .min_by(|a, b| (a - given).abs().total_cmp(&(b - given).abs()));
        Solved {
            none: nearest.is_none().then(|| self.nothing(&known, &all)),
            solutions: nearest.into_iter().map(|p| vec![p]).collect(),
            undecided: self.undecided(span, &all, &known),
            ranges,
        }
    }

    /// The ranges in which a goal is met: between two places at which that may change it is everywhere as in the middle.
    fn ranges(
        &self,
        span: &Span,
        found: &Found,
        known: &[(f64, At)],
        zero: f64,
    ) -> Vec<(f64, f64)> {
        let ends = found.stretches.iter().flat_map(|&(lo, hi)| [lo, hi]);
        let mut ranges: Vec<(f64, f64)> = Vec::new();
        for (lo, hi) in between(span, ends.chain(found.breaks.iter().copied())) {
            // At the value itself the goal is met, also where it is so at one place alone.
            if found.stretches.iter().any(|s| s.0 <= lo && lo <= s.1) {
                add(&mut ranges, (lo, lo));
            }
            if hi > lo && self.is_met(&self.inside((lo, hi), known), zero) {
                add(&mut ranges, (lo, hi));
            }
        }
        ranges
    }

    /// The ranges in which the quantity may have a value, which could not be found.
    fn undecided(&self, span: &Span, found: &Found, known: &[(f64, At)]) -> Vec<(f64, f64)> {
        let mut ranges = found.left.clone();
        if !found.breaks.is_empty() || matches!(known.first(), Some((_, At::Undecided(_)))) {
            ranges.extend(
                (between(span, found.breaks.iter().copied()).into_iter())
                    .filter(|&(lo, hi)| hi > lo)
                    .filter(|&range| matches!(self.inside(range, known), At::Undecided(_))),
            );
        }
        ranges.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut joined = Vec::new();
        for range in ranges {
            add(&mut joined, range);
        }
        joined
    }

    /// The quantity in a range in which it does not change its kind.
    fn inside(&self, (lo, hi): (f64, f64), known: &[(f64, At)]) -> At {
        let middle = 0.5 * (lo + hi);
        let inner = known.iter().filter(|(p, _)| lo < *p && *p < hi);
        match inner.min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs())) {
            Some((_, at)) => at.clone(),
            None => self.at(&[middle]),
        }
    }

    /// Why nothing was found.
    fn nothing(&self, known: &[(f64, At)], found: &Found) -> String {
        let numbers = known.iter().filter_map(|(_, at)| match at {
            At::Off(off, _) => Some(*off),
            _ => None,
        });
        let words = Words::of(self);
        let (lo, hi) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
            (lo.min(x), hi.max(x))
        });
        if let Some((p, before, after)) = found.jumps.first() {
            let (before, after) = (words.quantity(*before), words.quantity(*after));
            let p = words.parameter(*p);
            return format!(
                "the quantity jumps over the value, from {before} off it to {after}, where the parameter is {p}"
            );
        }
        let open = known
            .iter()
            .filter(|k| matches!(k.1, At::Undecided(_)))
            .count();
        if open > 0 {
            return format!(
                "it is so nowhere that could be decided; {open} of {} values could not",
                known.len()
            );
        }
        if lo > hi {
            let reason = known.iter().find_map(|(_, at)| match at {
                At::None(reason) => Some(reason.clone()),
                _ => None,
            });
            return reason.unwrap_or_else(|| "it is so nowhere in the range".to_owned());
        }
        let (lo, hi) = (words.quantity(lo), words.quantity(hi));
        format!("in the range the quantity is between {lo} and {hi} off the value")
    }
}

/// The ranges between places of a span, and its ends.
fn between(span: &Span, places: impl Iterator<Item = f64>) -> Vec<(f64, f64)> {
    let mut places: Vec<f64> = places.chain([span.lo, span.hi]).collect();
    places.sort_by(f64::total_cmp);
    places.windows(2).map(|w| (w[0], w[1])).collect()
}

/// Adds a range to others, with which it is one where they meet.
fn add(ranges: &mut Vec<(f64, f64)>, (lo, hi): (f64, f64)) {
    match ranges.last_mut() {
        Some(last) if last.1 >= lo => last.1 = last.1.max(hi),
        _ => ranges.push((lo, hi)),
    }
}
