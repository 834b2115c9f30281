//! Constraints that hold parts: functions that must not change, and the directions in which their forces push where
//! friction acts.

use crate::contact::Bound;
use crate::pairs::{Grip, Pairs};
use crate::system::{Row, System};

/// Constraints: functions that must not change, and the direction in which the force of each pushes.
#[derive(Debug, Clone)]
pub(crate) struct Holding {
    /// Gradients of the bounds, then the rates of sliding of those that stick.
    pub(super) rows: Vec<Row>,
    /// Directions in which they push; `None` stands for their own gradients.
    pub(super) along: Option<Vec<Row>>,
    /// The bounds that stick.
    sticks: Vec<usize>,
}

impl Holding {
    pub(super) fn of(system: &System, pairs: &Pairs, held: &[Bound], q: &[f64]) -> Self {
        let rows = held.iter().map(|b| b.function(system, pairs, q));
        let mut rows: Vec<Row> = rows.collect();
        let (mut along, mut sticks) = (rows.clone(), Vec::new());
        for (i, bound) in held.iter().enumerate() {
            match sliding(system, pairs, bound, q) {
                Some((Grip::Sticks, _, rate)) => {
                    sticks.push(i);
                    rows.push(rate);
                    along.push(rate);
                }
                Some((Grip::Slides { forward }, friction, rate)) => {
                    along[i] = rows[i].plus(if forward { -friction } else { friction }, &rate);
                }
                _ => {}
            }
        }
        let rubs = held.iter().any(|b| grip(b) != Grip::Smooth);
        Self {
            rows,
            along: rubs.then_some(along),
            sticks,
        }
    }

    /// Whether all constraints are functions of the configuration: for sticking contacts only the rate is known.
    pub(super) fn is_of_places(&self) -> bool {
        self.sticks.is_empty()
    }

    /// Directions in which all constraints push.
    pub(super) fn pushes(&self) -> &[Row] {
        self.along.as_ref().unwrap_or(&self.rows)
    }

    /// The bound of a row.
    pub(super) fn bound(&self, row: usize) -> usize {
        let bounds = self.rows.len() - self.sticks.len();
        match row.checked_sub(bounds) {
            Some(k) => self.sticks[k],
            None => row,
        }
    }
}

/// State of friction at a bound.
pub(super) fn grip(bound: &Bound) -> Grip {
    match bound {
        Bound::Contact(touch) => touch.grip,
        Bound::Limit { .. } | Bound::Brake { .. } => Grip::Smooth,
    }
}

/// The coefficient of friction of a bound.
pub(super) fn friction(pairs: &Pairs, bound: &Bound) -> f64 {
    match bound {
        Bound::Contact(touch) => pairs.list()[touch.pair].friction,
        Bound::Limit { .. } | Bound::Brake { .. } => 0.0,
    }
}

pub(super) fn sliding(
    system: &System,
    pairs: &Pairs,
    bound: &Bound,
    q: &[f64],
) -> Option<(Grip, f64, Row)> {
    match bound {
        Bound::Contact(touch) if touch.grip != Grip::Smooth => {
            let pair = &pairs.list()[touch.pair];
            Some((touch.grip, pair.friction, pair.sliding(touch, system, q)))
        }
        _ => None,
    }
}
