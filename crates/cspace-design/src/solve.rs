//! Values of parameters at which a quantity is what it must be.
//!
//! Of one parameter the quantity is measured at values evenly over the range, with its derivatives. Between two of them it crosses the
//! value that is asked for where its sign changes, and may touch or cross it twice where it comes nearer from both sides. Crossings are
//! found by Newton's method within brackets, to rounding.
//!
//! Of several parameters the change is sought that is smallest relative to the ranges: each step goes to the nearest place at which
//! the quantity, linear by its derivatives, is as asked for.

use cspace::Progress;
use cspace_io::model::{Requirement, Setting, Template};
use cspace_io::{Host, Model};
use rayon::prelude::*;

use crate::check::Spaces;
use crate::measure::Value;
use crate::sensitivity::derivative;

/// A parameter and the values that it may take.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// The parameter.
    pub parameter: String,
    /// The smallest value.
    pub lo: f64,
    /// The largest.
    pub hi: f64,
}

/// How a quantity compares with a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// It is the value.
    Equal,
    /// It is the value or less.
    AtMost,
    /// It is the value or more.
    AtLeast,
}

/// What is asked of a requirement's quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Goal {
    /// The name of the requirement.
    pub requirement: String,
    /// How the quantity compares.
    pub relation: Relation,
    /// With what.
    pub value: Value,
}

/// Values of parameters that meet a goal.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solved {
    /// The values, in the order of the spans. For an equation in one parameter all that were found; otherwise the one nearest to the
    /// values that the model gives.
    pub solutions: Vec<Vec<f64>>,
    /// Of one parameter and a goal that is met in ranges: these.
    pub ranges: Vec<(f64, f64)>,
    /// Why there is no solution.
    pub none: Option<String>,
}

/// Values of one parameter between which nothing is resolved, relative to its range.
const RESOLUTION: f64 = 1e-12;

/// A quantity at some values of the parameters.
#[derive(Debug, Clone, PartialEq)]
enum At {
    /// How much more it is than asked for, and the derivatives for smaller and larger values of each parameter.
    Off(f64, Vec<[f64; 2]>),
    /// Whether it is as asked for.
    Is(bool),
    /// It has no value.
    None(String),
}

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

struct Problem<'a> {
    template: &'a Template,
    set: &'a [Setting],
    spans: &'a [Span],
    goal: &'a Goal,
    progress: &'a dyn Progress,
}

impl Problem<'_> {
    /// The model with values for what is varied.
    fn model(&self, values: &[f64]) -> Result<(Model, Vec<Setting>), String> {
        let mut set = self.set.to_vec();
        set.extend(self.spans.iter().zip(values).map(|(span, value)| Setting {
            name: span.parameter.clone(),
            value: format!("{value:?}"),
        }));
        let host = Host {
            set: &set,
            ..Host::default()
        };
        match self.template.model(&host) {
            Ok(model) => Ok((model, set)),
            Err(error) => Err(error.message().to_owned()),
        }
    }

    fn at(&self, values: &[f64]) -> At {
        self.measured(values).unwrap_or_else(At::None)
    }

    fn measured(&self, values: &[f64]) -> Result<At, String> {
        let (mut model, set) = self.model(values)?;
        model
            .requirements
            .retain(|r| r.name == self.goal.requirement);
        let spaces = Spaces::compute(&model, self.progress).map_err(|e| e.to_string())?;
        let requirement: &Requirement =
            (model.requirements.first()).ok_or("the model has no such requirement")?;
        let measured = spaces
            .check(requirement)
            .measured
            .map_err(|e| e.to_string())?;
        let off = match (measured.value, self.goal.value) {
            (Value::Truth(is), Value::Truth(wanted)) => return Ok(At::Is(is == wanted)),
            (Value::Number(is), Value::Number(wanted)) => is - wanted,
            _ => return Err("the requirement is of another kind than the value".to_owned()),
        };
        let space = spaces.of(requirement).map_err(|e| e.to_string())?;
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let slopes = self.spans.iter().map(|span| {
            let slopes = self.template.slopes(&host, &model, &span.parameter);
            let slopes = slopes.map_err(|e| e.message().to_owned());
            // Without derivatives crossings are bracketed alone.
            slopes
                .and_then(|s| derivative(space, requirement, &measured, &s))
                .unwrap_or([f64::NAN; 2])
        });
        Ok(At::Off(off, slopes.collect()))
    }

    /// The values that the model gives to what is varied, brought into their ranges.
    fn given(&self) -> Vec<f64> {
        let host = Host {
            set: self.set,
            ..Host::default()
        };
        let model = self.template.model(&host).ok();
        let of = |span: &Span| {
            let parameters = model.iter().flat_map(|m| &m.parameters);
            let mut given = parameters.filter(|p| p.name == span.parameter);
            let value = given.next().map_or(span.lo, |p| p.value);
            value.clamp(span.lo, span.hi)
        };
        self.spans.iter().map(of).collect()
    }

    /// Whether the goal is met where the quantity is off by so much.
    fn is_met(&self, at: &At) -> bool {
        match *at {
            At::Is(is) => is,
            At::Off(off, _) => match self.goal.relation {
                Relation::Equal => off == 0.0,
                Relation::AtMost => off <= 0.0,
                Relation::AtLeast => off >= 0.0,
            },
            At::None(_) => false,
        }
    }

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
        let measured: Vec<At> = values.par_iter().map(|p| self.at(&[*p])).collect();
        let known: Vec<(f64, At)> = values.into_iter().zip(measured).collect();
        let line = Line {
            problem: self,
            least: RESOLUTION * (span.hi - span.lo),
        };
        let parts: Vec<Found> = known
            .par_windows(2)
            .map(|w| {
                let mut found = Found::default();
                line.search(&w[0], &w[1], &mut found);
                found
            })
            .collect();
        let mut all = Found::default();
        for part in parts {
            all.roots.extend(part.roots);
            all.breaks.extend(part.breaks);
            all.jumps.extend(part.jumps);
        }
        all.roots.sort_by(f64::total_cmp);
        all.roots.dedup_by(|b, a| *b - *a <= 4.0 * line.least);
        let is_number = matches!(self.goal.value, Value::Number(_));
        if is_number && self.goal.relation == Relation::Equal {
            let none = all.roots.is_empty().then(|| nothing(&known, &all));
            return Solved {
                solutions: all.roots.into_iter().map(|p| vec![p]).collect(),
                ranges: Vec::new(),
                none,
            };
        }
        let ranges = self.ranges(span, &all, &known);
        let given = self.given()[0];
        let nearest = (ranges.iter())
            .map(|&(lo, hi)| given.clamp(lo, hi))
            .min_by(|a, b| (a - given).abs().total_cmp(&(b - given).abs()));
        Solved {
            none: nearest.is_none().then(|| nothing(&known, &all)),
            solutions: nearest.into_iter().map(|p| vec![p]).collect(),
            ranges,
        }
    }

    /// The ranges in which a goal is met: between two places at which that may change it is everywhere as in the middle.
    fn ranges(&self, span: &Span, found: &Found, known: &[(f64, At)]) -> Vec<(f64, f64)> {
        let mut places: Vec<f64> = (found.roots.iter().chain(&found.breaks).copied())
            .chain([span.lo, span.hi])
            .collect();
        places.sort_by(f64::total_cmp);
        let mut ranges: Vec<(f64, f64)> = Vec::new();
        for w in places.windows(2) {
            let (lo, hi) = (w[0], w[1]);
            if hi <= lo {
                continue;
            }
            let middle = 0.5 * (lo + hi);
            let inner = known.iter().filter(|(p, _)| lo < *p && *p < hi);
            let sample = inner.min_by(|a, b| (a.0 - middle).abs().total_cmp(&(b.0 - middle).abs()));
            let is_met = match sample {
                Some((_, at)) => self.is_met(at),
                None => self.is_met(&self.at(&[middle])),
            };
            if !is_met {
                continue;
            }
            match ranges.last_mut() {
                Some(last) if last.1 == lo => last.1 = hi,
                _ => ranges.push((lo, hi)),
            }
        }
        ranges
    }

    fn in_several(&self) -> Solved {
        /// Steps to a solution, at most.
        const STEPS: usize = 60;
        /// A step that changes every parameter by less of its range is none.
        const NONE: f64 = 1e-13;
        let given = self.given();
        let wide: Vec<f64> = self.spans.iter().map(|s| s.hi - s.lo).collect();
        let none = |reason: String| Solved {
            none: Some(reason),
            ..Solved::default()
        };
        let place = |x: &[f64]| -> Vec<f64> {
            (x.iter().zip(&given).zip(&wide).zip(self.spans))
                .map(|(((x, p), w), span)| (p + x * w).clamp(span.lo, span.hi))
                .collect()
        };
        // Changes relative to the ranges, and their bounds.
        let mut x = vec![0.0; given.len()];
        let bounds: Vec<(f64, f64)> = (self.spans.iter().zip(&given).zip(&wide))
            .map(|((s, p), w)| ((s.lo - p) / w, (s.hi - p) / w))
            .collect();
        for step in 0..STEPS {
            let at = self.at(&place(&x));
            let (off, slopes) = match &at {
                At::Off(off, slopes) => (*off, slopes),
                At::Is(_) => {
                    return none(
                        "a quantity that is yes or no has no derivatives: vary one parameter"
                            .to_owned(),
                    );
                }
                At::None(reason) => return none(reason.clone()),
            };
            if step == 0 && self.is_met(&at) {
                return Solved {
                    solutions: vec![place(&x)],
                    ..Solved::default()
                };
            }
            // The quantity falls where it is too large: of two derivatives that for the direction of the step counts.
            let gradient: Vec<f64> = (slopes.iter().zip(&wide))
                .map(|(&[below, above], w)| {
                    let rises = off < 0.0;
                    let up = if above > 0.0 { rises } else { !rises };
                    w * if up { above } else { below }
                })
                .collect();
            let Some(next) = nearest(&gradient, off, &x, &bounds) else {
                return none(
                    "the quantity does not change with the parameters, or not enough within their ranges"
                        .to_owned(),
                );
            };
            let moved = (next.iter().zip(&x)).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            x = next;
            if moved <= NONE {
                return Solved {
                    solutions: vec![place(&x)],
                    ..Solved::default()
                };
            }
        }
        none(
            "no solution was found: the quantity jumps, or another contact takes over on the way"
                .to_owned(),
        )
    }
}

/// The smallest x within bounds with off + gradient · (x − at) = 0: those at a bound stay there, the others are along the gradient.
fn nearest(gradient: &[f64], off: f64, at: &[f64], bounds: &[(f64, f64)]) -> Option<Vec<f64>> {
    let target: f64 = gradient.iter().zip(at).map(|(g, x)| g * x).sum::<f64>() - off;
    let mut held: Vec<Option<f64>> = vec![None; at.len()];
    for _ in 0..=at.len() {
        let mut rest = target;
        let mut square = 0.0;
        for (g, held) in gradient.iter().zip(&held) {
            match held {
                Some(x) => rest -= g * x,
                None => square += g * g,
            }
        }
        if square == 0.0 || !square.is_finite() {
            return None;
        }
        let x: Vec<f64> = (gradient.iter().zip(&held))
            .map(|(g, held)| held.unwrap_or(g * rest / square))
            .collect();
        let beyond = (0..x.len())
            .find(|&i| held[i].is_none() && !(bounds[i].0..=bounds[i].1).contains(&x[i]));
        match beyond {
            None => return Some(x),
            Some(i) => held[i] = Some(x[i].clamp(bounds[i].0, bounds[i].1)),
        }
    }
    None
}

/// Why nothing was found.
fn nothing(known: &[(f64, At)], found: &Found) -> String {
    let numbers = known.iter().filter_map(|(_, at)| match at {
        At::Off(off, _) => Some(*off),
        _ => None,
    });
    let (lo, hi) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
        (lo.min(x), hi.max(x))
    });
    if let Some((p, before, after)) = found.jumps.first() {
        return format!(
            "the quantity jumps over the value, from {before:+e} off it to {after:+e}, where the parameter is {p}"
        );
    }
    if lo > hi {
        let reason = known.iter().find_map(|(_, at)| match at {
            At::None(reason) => Some(reason.clone()),
            _ => None,
        });
        return reason.unwrap_or_else(|| "it is so nowhere in the range".to_owned());
    }
    format!("in the range the quantity is between {lo:+e} and {hi:+e} off the value")
}

/// What happens along one parameter.
#[derive(Debug, Clone, Default)]
struct Found {
    /// Where the quantity is the value.
    roots: Vec<f64>,
    /// Where it begins or ends to be measurable, jumps over the value, or changes from yes to no.
    breaks: Vec<f64>,
    /// Jumps over the value: where, and how far off it is before and after.
    jumps: Vec<(f64, f64, f64)>,
}

struct Line<'a> {
    problem: &'a Problem<'a>,
    /// Intervals as wide as this are places.
    least: f64,
}

impl Line<'_> {
    fn at(&self, p: f64) -> At {
        self.problem.at(&[p])
    }

    /// What happens between two values of which the quantity is known.
    fn search(&self, a: &(f64, At), b: &(f64, At), found: &mut Found) {
        match (&a.1, &b.1) {
            (At::Off(f, s), At::Off(g, t)) => {
                if *f == 0.0 {
                    found.roots.push(a.0);
                }
                if *g == 0.0 {
                    found.roots.push(b.0);
                }
                if f * g < 0.0 {
                    self.crossing(a, b, found);
                } else if comes_nearer(*f, s[0][1], *g, t[0][0]) {
                    self.dip(a.clone(), b.clone(), found);
                }
            }
            (At::Is(f), At::Is(g)) if f == g => {}
            (At::None(_), At::None(_)) => {}
            (At::Is(_), At::Is(_)) => {
                let (a, b) = self.change(a.clone(), b.clone());
                found.breaks.push(0.5 * (a.0 + b.0));
            }
            _ => {
                let (near_a, near_b) = self.change(a.clone(), b.clone());
                found.breaks.push(0.5 * (near_a.0 + near_b.0));
                if matches!(a.1, At::None(_)) {
                    self.search(&near_b, b, found);
                } else {
                    self.search(a, &near_a, found);
                }
            }
        }
    }

    /// Two places next to each other between which what is known changes its kind.
    fn change(&self, mut a: (f64, At), mut b: (f64, At)) -> ((f64, At), (f64, At)) {
        while b.0 - a.0 > self.least {
            let p = 0.5 * (a.0 + b.0);
            if p <= a.0 || p >= b.0 {
                break;
            }
            let at = self.at(p);
            if is_alike(&at, &a.1) {
                a = (p, at);
            } else {
                b = (p, at);
            }
        }
        (a, b)
    }

    /// Where a quantity crosses the value between two places on both sides of it: by Newton's method within a bracket, halving
    /// where a step leaves it or does not shorten it.
    fn crossing(&self, a: &(f64, At), b: &(f64, At), found: &mut Found) {
        /// The error of a quantity, relative to how far off it is at the ends.
        const ROUNDING: f64 = 1e-12;
        /// A quantity that is not so many times as steep as an even one has no jump.
        const STEEPER: f64 = 1e3;
        let (mut lo, mut hi) = (a.clone(), b.clone());
        let off = |at: &At| match at {
            At::Off(off, _) => *off,
            _ => f64::NAN,
        };
        let scale = off(&a.1).abs().max(off(&b.1).abs());
        let mut from = lo.clone();
        let mut width = hi.0 - lo.0;
        while hi.0 - lo.0 > self.least {
            let newton = match &from.1 {
                At::Off(off, slopes) => {
                    let is_lower = from.0 == lo.0;
                    from.0 - off / slopes[0][usize::from(is_lower)]
                }
                _ => f64::NAN,
            };
            let middle = 0.5 * (lo.0 + hi.0);
            // A little beyond the root, so that the bracket closes from both sides.
            let beyond = newton + 0.25 * self.least * (middle - newton).signum();
            let good = lo.0 < beyond && beyond < hi.0 && (beyond - from.0).abs() <= 0.5 * width;
            let p = if good { beyond } else { middle };
            width = if good {
                (p - from.0).abs()
            } else {
                hi.0 - lo.0
            };
            if p <= lo.0 || p >= hi.0 {
                break;
            }
            let at = self.at(p);
            match &at {
                At::Off(0.0, _) => {
                    found.roots.push(p);
                    return;
                }
                At::Off(..) => {}
                // What has no value on the way is a break.
                _ => {
                    let here = (p, at);
                    self.search(a, &here, found);
                    self.search(&here, b, found);
                    return;
                }
            }
            from = (p, at.clone());
            if (off(&at) < 0.0) == (off(&lo.1) < 0.0) {
                lo = (p, at);
            } else {
                hi = (p, at);
            }
        }
        let (f, g) = (off(&lo.1), off(&hi.1));
        let slope = [&lo.1, &hi.1].map(|at| match at {
            At::Off(_, s) => s[0]
                .into_iter()
                .map(f64::abs)
                .filter(|s| s.is_finite())
                .fold(0.0, f64::max),
            _ => 0.0,
        });
        let steep = slope[0].max(slope[1]) * (hi.0 - lo.0);
        // Of a quantity without derivatives what it changes from end to end says how steep it is.
        let even = scale * (hi.0 - lo.0) / (b.0 - a.0);
        if (g - f).abs() <= 16.0 * steep + STEEPER * even + ROUNDING * scale.max(1.0) {
            let p = lo.0 - f * (hi.0 - lo.0) / (g - f);
            found.roots.push(p.clamp(lo.0, hi.0));
        } else {
            found.breaks.push(0.5 * (lo.0 + hi.0));
            found.jumps.push((0.5 * (lo.0 + hi.0), f, g));
        }
    }

    /// Where a quantity comes nearest to the value between two places on one side of it: by the sign of its derivative. Where it
    /// crosses the value there, both crossings are found.
    fn dip(&self, mut a: (f64, At), mut b: (f64, At), found: &mut Found) {
        /// Where the quantity is nearer than this to the value, relative to how far off it is at the ends, it touches it.
        const TOUCHES: f64 = 1e-12;
        let (from, to) = (a.clone(), b.clone());
        let mut scale = 0.0_f64;
        while b.0 - a.0 > self.least {
            let (At::Off(f, _), At::Off(g, _)) = (&a.1, &b.1) else {
                return;
            };
            scale = scale.max(f.abs()).max(g.abs());
            let p = 0.5 * (a.0 + b.0);
            if p <= a.0 || p >= b.0 {
                break;
            }
            let at = self.at(p);
            let At::Off(off, slopes) = &at else {
                let here = (p, at);
                self.search(&from, &here, found);
                self.search(&here, &to, found);
                return;
            };
            let (off, [below, above]) = (*off, slopes[0]);
            if off * f <= 0.0 {
                let here = (p, at);
                self.search(&from, &here, found);
                self.search(&here, &to, found);
                return;
            }
            if below * off < 0.0 && above * off > 0.0 {
                // A kink is the nearest place.
                (a, b) = ((p, at.clone()), (p, at));
                break;
            }
            if above * off < 0.0 {
                a = (p, at);
            } else {
                b = (p, at);
            }
        }
        if let At::Off(off, _) = a.1
            && off.abs() <= TOUCHES * scale
        {
            found.roots.push(0.5 * (a.0 + b.0));
        }
    }
}

/// Whether a quantity on one side of a value comes nearer to it from both of two places.
fn comes_nearer(f: f64, slope_f: f64, g: f64, slope_g: f64) -> bool {
    f * slope_f < 0.0 && g * slope_g > 0.0
}

/// Whether two are of one kind.
fn is_alike(a: &At, b: &At) -> bool {
    match (a, b) {
        (At::Is(a), At::Is(b)) => a == b,
        _ => core::mem::discriminant(a) == core::mem::discriminant(b),
    }
}
