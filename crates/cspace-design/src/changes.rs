//! Structural changes along a sweep: other features that touch, regions that open or close, values that begin or end to exist.

use cspace::parallel;

use crate::sweep::{State, Sweep};

/// A change between two values of what is varied last.
#[derive(Debug, Clone, PartialEq)]
pub struct Change {
    /// The values of what is varied, the last being where it happens.
    pub values: Vec<f64>,
    /// The requirement whose measure it is about.
    pub measure: String,
    /// State below the change, as far as it differs.
    pub before: String,
    /// State above it.
    pub after: String,
}

/// Places nearer to each other than this, relative to the range, are one.
const RESOLUTION: f64 = 1e-9;

/// Changes nearer to each other than this, relative to the range, are one: where a contact takes over from another, both count as touching
/// for a while, as long as they tie within what counts as touching.
const TAKEOVER: f64 = 1e-6;

impl Sweep<'_> {
    /// Changes along lines of rows, in which the quantity varied last goes from its smallest to its largest value: between neighbours that
    /// differ, by bisection, to 10⁻⁹ of the range; a contact that takes over from another to 10⁻⁶ at worst. What changes and changes back between two
    /// neighbours is missed.
    pub fn changes(&self, line: &[Vec<f64>]) -> Vec<Change> {
        let (Some(first), Some(last)) = (line.first(), line.last()) else {
            return Vec::new();
        };
        let end = |row: &[f64]| row.last().copied().unwrap_or_default();
        let range = (end(last) - end(first)).abs();
        let (tolerance, takeover) = (RESOLUTION * range, TAKEOVER * range);
        let states: Vec<Vec<State>> = parallel::map(line, 1, |row| self.states(row));
        let known: Vec<(f64, Vec<State>)> = line.iter().map(|row| end(row)).zip(states).collect();
        let steps = steps(&known, tolerance, &|at| {
            let mut values = first.clone();
            if let Some(last) = values.last_mut() {
                *last = at;
            }
            self.states(&values)
        });
        let mut changes = Vec::new();
        for (i, measure) in self.measures().iter().enumerate() {
            let mine = steps.iter().filter(|s| s.below[i] != s.above[i]);
            let mut merged: Vec<Step<Vec<State>>> = Vec::new();
            for step in mine {
                match merged.last_mut() {
                    Some(last) if step.at - last.at <= takeover => {
                        last.above.clone_from(&step.above);
                        last.at = 0.5 * (last.at + step.at);
                    }
                    _ => merged.push(step.clone()),
                }
            }
            for step in merged {
                let (below, above) = (&step.below[i], &step.above[i]);
                if below != above {
                    let mut values = first.clone();
                    if let Some(last) = values.last_mut() {
                        *last = step.at;
                    }
                    let (before, after) = below.unlike(above);
                    changes.push(Change {
                        values,
                        measure: measure.clone(),
                        before,
                        after,
                    });
                }
            }
        }
        let at = |c: &Change| end(&c.values);
        changes.sort_by(|a, b| at(a).total_cmp(&at(b)));
        changes
    }
}

/// A place at which a state changes, and the states on both sides of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Step<S> {
    /// The place.
    pub at: f64,
    /// The state below it.
    pub below: S,
    /// The state above it.
    pub above: S,
}

/// Places at which a state changes within a range: between neighbours of `samples` values that differ, by bisection, to 10⁻⁹ of the range,
/// but for what changes and changes back between two neighbours.
pub fn steps_in<S: Clone + PartialEq + Send + Sync>(
    (lo, hi): (f64, f64),
    samples: usize,
    state: &(dyn Fn(f64) -> S + Sync),
) -> Vec<Step<S>> {
    let most = samples.max(2) - 1;
    let values: Vec<f64> = (0..=most)
        .map(|i| lo + (hi - lo) * (i as f64 / most as f64))
        .collect();
    let states = parallel::map(&values, 1, |at| state(*at));
    let known: Vec<(f64, S)> = values.into_iter().zip(states).collect();
    steps(&known, RESOLUTION * (hi - lo).abs(), state)
}

/// Places at which a state changes between neighbours at which it is known, to within a tolerance.
fn steps<S: Clone + PartialEq + Send + Sync>(
    known: &[(f64, S)],
    tolerance: f64,
    state: &(dyn Fn(f64) -> S + Sync),
) -> Vec<Step<S>> {
    let neighbours: Vec<&[(f64, S)]> = known.windows(2).collect();
    let found = parallel::map(&neighbours, 1, |w| {
        let mut steps = Vec::new();
        locate(&w[0], &w[1], tolerance, state, &mut steps);
        steps
    });
    found.into_iter().flatten().collect()
}

fn locate<S: Clone + PartialEq>(
    below: &(f64, S),
    above: &(f64, S),
    tolerance: f64,
    state: &dyn Fn(f64) -> S,
    found: &mut Vec<Step<S>>,
) {
    if below.1 == above.1 {
        return;
    }
    let at = 0.5 * (below.0 + above.0);
    if above.0 - below.0 <= tolerance || at <= below.0 || at >= above.0 {
        found.push(Step {
            at,
            below: below.1.clone(),
            above: above.1.clone(),
        });
        return;
    }
    let middle = (at, state(at));
    locate(below, &middle, tolerance, state, found);
    locate(&middle, above, tolerance, state, found);
}
