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
        let known: Vec<(&Vec<f64>, Vec<State>)> = line.iter().zip(states).collect();
        let neighbours: Vec<_> = known.windows(2).collect();
        let found = parallel::map(&neighbours, 1, |w| {
            let mut steps = Vec::new();
            let below = (end(w[0].0), &w[0].1[..]);
            let above = (end(w[1].0), &w[1].1[..]);
            self.locate(first, below, above, tolerance, &mut steps);
            steps
        });
        let steps: Vec<Step> = found.into_iter().flatten().collect();
        let mut changes = Vec::new();
        for (i, measure) in self.measures().iter().enumerate() {
            let mine = steps.iter().filter(|s| s.below[i] != s.above[i]);
            let mut merged: Vec<Step> = Vec::new();
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

    fn locate(
        &self,
        line: &[f64],
        below: (f64, &[State]),
        above: (f64, &[State]),
        tolerance: f64,
        found: &mut Vec<Step>,
    ) {
        if below.1 == above.1 {
            return;
        }
        let at = 0.5 * (below.0 + above.0);
        if above.0 - below.0 <= tolerance || at <= below.0 || at >= above.0 {
            found.push(Step {
                at,
                below: below.1.to_vec(),
                above: above.1.to_vec(),
            });
            return;
        }
        let mut values = line.to_vec();
        if let Some(last) = values.last_mut() {
            *last = at;
        }
        let states = self.states(&values);
        self.locate(line, below, (at, &states), tolerance, found);
        self.locate(line, (at, &states), above, tolerance, found);
    }
}

/// Two neighbouring places at which something differs.
#[derive(Debug, Clone)]
struct Step {
    at: f64,
    below: Vec<State>,
    above: Vec<State>,
}
