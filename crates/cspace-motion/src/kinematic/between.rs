//! A part of a step, between two times at which the motion is known.

use crate::contact::Path;

use super::flow::{Arrived, Flow};

/// A part of a step between two times, at which the motion is known.
#[derive(Debug, Clone)]
pub(super) struct Between<'f, 'a> {
    pub(super) flow: &'f Flow<'a>,
    pub(super) from: (f64, Arrived),
    pub(super) to: Option<(f64, Arrived)>,
}

impl Between<'_, '_> {
    /// The motion after a time: within, by the cubic through the ends, where contacts hold.
    pub(super) fn at(&self, h: f64) -> Option<Arrived> {
        match self.near(h) {
            Some(q) => self.flow.brought(h, q),
            None => self.flow.after(h),
        }
    }

    /// The configuration there.
    pub(super) fn placed(&self, h: f64) -> Option<Vec<f64>> {
        match self.near(h) {
            Some(q) => self.flow.placed(h, q),
            None => Some(self.flow.after(h)?.q),
        }
    }

    /// The configuration on the cubic through the ends; none outside of them.
    pub(super) fn near(&self, h: f64) -> Option<Vec<f64>> {
        let (begin, from) = (self.from.0, &self.from.1);
        let (end, to) = self.to.as_ref()?;
        if !(begin..=*end).contains(&h) {
            return None;
        }
        let ends = [from, to].map(|at| (&at.q[..], &at.velocity.rates[..]));
        let duration = end - begin;
        let path = Path::new(ends[0], ends[1], duration);
        Some(path.at((h - begin) / duration))
    }

    /// Whether contacts and joints leave no freedom at either end: then they alone determine the motion between, from
    /// any approximation.
    pub(super) fn is_led(&self) -> bool {
        let ends = core::iter::once(&self.from).chain(&self.to);
        self.to.is_some() && ends.into_iter().all(|end| end.1.velocity.determined)
    }

    /// Two times, no farther from each other than that, between which it stops going on.
    pub(super) fn halved(
        &self,
        [mut before, mut after]: [f64; 2],
        until: f64,
        goes_on: &mut dyn FnMut(f64, &Arrived) -> bool,
    ) -> [f64; 2] {
        while after - before > until {
            let middle = 0.5 * (before + after);
            if middle <= before || middle >= after {
                break;
            }
            match self.at(middle) {
                Some(to) if goes_on(middle, &to) => before = middle,
                _ => after = middle,
            }
        }
        [before, after]
    }
}
