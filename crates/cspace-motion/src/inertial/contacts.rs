//! Contacts and ends of ranges by number, and how they open and slide.

use std::cell::RefCell;
use std::collections::HashMap;

use cspace::{FeatureId, Real, TouchingPlace, touching_place};

use crate::contact::{Bound, limits};
use crate::pairs::Pairs;
use crate::system::{Row, System};

use super::bodies::Posed;
use super::rates::{InTime, still};

/// The features of a pair that touch.
type Key = (usize, (FeatureId, FeatureId));

/// Ends of ranges first, then contacts as they are met.
#[derive(Debug)]
pub(super) struct Numbers {
    limits: usize,
    list: RefCell<Vec<Bound>>,
    known: RefCell<HashMap<Key, usize>>,
}

/// Rates at which a bound opens and slides.
#[derive(Debug, Clone, Copy)]
pub(super) struct Opening {
    pub(super) gap: f64,
    pub(super) normal: Row<InTime>,
    pub(super) tangent: Row<InTime>,
}

impl Numbers {
    pub(super) fn new(system: &System) -> Self {
        let start = vec![0.0; system.count()];
        let list: Vec<Bound> = limits(system, &start).into_iter().map(|l| l.0).collect();
        Self {
            limits: list.len(),
            list: RefCell::new(list),
            known: RefCell::default(),
        }
    }

    /// Number of ends of ranges; they have the first numbers.
    pub(super) fn limits(&self) -> usize {
        self.limits
    }

    pub(super) fn bound(&self, number: usize) -> Bound {
        self.list.borrow()[number]
    }

    pub(super) fn number(&self, bound: &Bound) -> usize {
        let mut list = self.list.borrow_mut();
        match bound {
            Bound::Limit { .. } | Bound::Brake { .. } => list[..self.limits]
                .iter()
                .position(|b| b == bound)
                .unwrap_or(0),
            Bound::Contact(touch) => {
                let mut known = self.known.borrow_mut();
                *known
                    .entry((touch.pair, touch.features))
                    .or_insert_with(|| {
                        list.push(*bound);
                        list.len() - 1
                    })
            }
        }
    }
}

/// The gap of a bound and the rates at which it opens and slides.
pub(super) fn opening(system: &System, pairs: &Pairs, bound: &Bound, posed: &Posed) -> Opening {
    let all = &posed.all;
    match bound {
        Bound::Limit { .. } | Bound::Brake { .. } => {
            let row = bound.function(system, pairs, &all.q);
            let mut normal = Row::new(still(0.0));
            for &(i, d) in row.entries() {
                normal.push(i, still(d));
            }
            Opening {
                gap: row.value,
                normal,
                tangent: Row::new(still(0.0)),
            }
        }
        Bound::Contact(touch) => {
            let pair = &pairs.list()[touch.pair];
            let parts = [pair.fixed, pair.moving].map(|i| system.parts()[i]);
            let [a, b] = [pair.fixed, pair.moving].map(|i| &posed.parts[i]);
            let real = |_, x| InTime::constant(x);
            let contact = touch.contact();
            let TouchingPlace {
                gap,
                on_fixed,
                on_moving,
                normal: n,
            } = touching_place(
                &contact.fixed.map(real),
                &contact.moving.map(real),
                &a.inverse().compose(b),
            );
            let (p, r, n) = (a.point(on_fixed), a.point(on_moving), a.vector(n));
            let t = [-n[1], n[0]];
            let (mut normal, mut tangent) = (Row::new(still(0.0)), Row::new(still(0.0)));
            for (rates, d) in [(&mut normal, n), (&mut tangent, t)] {
                rates.add_point(&parts[1], &posed.at, r, d);
                rates.add_point(&parts[0], &posed.at, p, [-d[0], -d[1]]);
            }
            Opening {
                gap: gap.value,
                normal,
                tangent,
            }
        }
    }
}
