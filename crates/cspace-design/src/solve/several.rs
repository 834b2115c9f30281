//! Several parameters: the smallest change relative to the ranges. Each step goes to the nearest place at which the quantity, linear by its
//! derivatives, is as asked for.

use cspace::parallel;

use super::problem::{At, Problem, Solved, Span};

impl Problem<'_> {
    /// The smallest change of several parameters that meets the goal.
    pub(super) fn in_several(&self) -> Solved {
        let given = self.given();
        let wide: Vec<f64> = self.spans.iter().map(|s| s.hi - s.lo).collect();
        let first = self.least_change(&given, &given);
        let mut solutions: Vec<Vec<f64>> = first.iter().cloned().collect();
        // Where derivatives lead nowhere from the model's own values, from others.
        if solutions.is_empty() {
            let starts = starts(self.spans);
            let found = parallel::map(&starts, 1, |start| self.least_change(&given, start));
            solutions = found.into_iter().filter_map(Result::ok).collect();
        }
        let change = |values: &[f64]| -> f64 {
            let parts = values.iter().zip(&given).zip(&wide);
            parts.map(|((v, p), w)| ((v - p) / w).powi(2)).sum()
        };
        solutions.sort_by(|a, b| change(a).total_cmp(&change(b)));
        solutions.truncate(1);
        Solved {
            undecided: Vec::new(),
            none: first.err().filter(|_| solutions.is_empty()),
            solutions,
            ranges: Vec::new(),
        }
    }

    /// As [`in_several`](Self::in_several), from the model's own values alone.
    pub(super) fn near_given(&self) -> Solved {
        let given = self.given();
        let found = self.least_change(&given, &given);
        Solved {
            undecided: Vec::new(),
            none: found.as_ref().err().cloned(),
            solutions: found.into_iter().collect(),
            ranges: Vec::new(),
        }
    }

    /// The values that meet the goal and are nearest to those given, as far as steps from a start lead to them.
    fn least_change(&self, given: &[f64], start: &[f64]) -> Result<Vec<f64>, String> {
        /// Steps to a solution, at most.
        const STEPS: usize = 60;
        /// A step that changes every parameter by less of its range is none.
        const NONE: f64 = 1e-13;
        let wide: Vec<f64> = self.spans.iter().map(|s| s.hi - s.lo).collect();
        let place = |x: &[f64]| -> Vec<f64> {
            (x.iter().zip(given).zip(&wide).zip(self.spans))
                .map(|(((x, p), w), span)| (p + x * w).clamp(span.lo, span.hi))
                .collect()
        };
        // Changes relative to the ranges, and their bounds.
        let mut x: Vec<f64> = (start.iter().zip(given).zip(&wide))
            .map(|((s, p), w)| (s - p) / w)
            .collect();
        let bounds: Vec<(f64, f64)> = (self.spans.iter().zip(given).zip(&wide))
            .map(|((s, p), w)| ((s.lo - p) / w, (s.hi - p) / w))
            .collect();
        for step in 0..STEPS {
            let at = self.at(&place(&x));
            let (off, slopes) = match &at {
                At::Off(off, slopes) => (*off, slopes),
                At::Is(_) => {
                    return Err(
                        "a quantity that is yes or no has no derivatives: vary one parameter"
                            .to_owned(),
                    );
                }
                At::None(reason) | At::Undecided(reason) => return Err(reason.clone()),
            };
            if step == 0 && start == given && self.is_met(&at, self.zero([&at].into_iter())) {
                return Ok(place(&x));
            }
            if slopes.iter().flatten().any(|s| s.is_nan()) {
                return Err(
                    "the quantity has no derivatives on the way: vary one parameter, or others"
                        .to_owned(),
                );
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
                return Err(
                    "the quantity does not change with the parameters there, or not enough within their ranges"
                        .to_owned(),
                );
            };
            let moved = (next.iter().zip(&x)).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            x = next;
            if moved <= NONE {
                return Ok(place(&x));
            }
        }
        Err(
            "no solution was found: the quantity jumps, or another contact takes over on the way"
                .to_owned(),
        )
    }
}

/// Places all over the ranges, in an order without a pattern: those of Halton (1960), in a base for each parameter.
fn starts(spans: &[Span]) -> Vec<Vec<f64>> {
    const COUNT: u32 = 32;
    const BASES: [u32; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
    let share = |mut i: u32, base: u32| {
        let (mut share, mut part) = (0.0, 1.0);
        while i > 0 {
            part /= f64::from(base);
            share += part * f64::from(i % base);
            i /= base;
        }
        share
    };
    let at = |i: u32| {
        let bases = BASES.into_iter().cycle();
        let values = spans.iter().zip(bases);
        values
            .map(|(s, base)| s.lo + (s.hi - s.lo) * share(i, base))
            .collect()
    };
    (1..=COUNT).map(at).collect()
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
