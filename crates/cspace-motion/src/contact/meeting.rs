//! Whether the parts of a pair meet on the path of a step.

use cspace::pair::{PairCrossing, PairMotion};
use cspace::{Classification, Configuration, Coordinates, PatchId};

use crate::pairs::{MovingPair, Touch};
use crate::root::root;
use crate::system::System;

use super::path::Path;

/// A contact on a straight piece of a path that is none on the path itself asks for shorter pieces, by halves so many times: a piece's
/// distance from the path falls by four each time, from a thousandth of the size to rounding. What is left then counts as met.
const MOST_HALVED: usize = 20;
/// In these shares of a piece it is halved where that contact is, elsewhere in the middle.
const INNER: core::ops::RangeInclusive<f64> = 0.1..=0.9;

/// A share of a path, and the coordinates there.
type Place = (f64, Vec<f64>);

/// What two parts do on a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting<'m> {
    pub(super) system: &'m System,
    pub(super) pair: &'m MovingPair,
    /// The pair's number.
    pub(super) index: usize,
    pub(super) path: &'m Path<'m>,
}

impl Meeting<'_> {
    /// Whether they meet between some places, from each to the next.
    pub(super) fn happens(&self, places: &[Place]) -> bool {
        (places.windows(2)).any(|w| self.is_between([&w[0], &w[1]], MOST_HALVED))
    }

    /// The first contact is sought exactly on the straight way between two places, and counts if the path itself comes to it.
    fn is_between(&self, [from, to]: [&Place; 2], halved: usize) -> bool {
        let space = &self.pair.space;
        let [a, b] = [from, to].map(|place| self.pair.coordinates(self.system, &place.1));
        if space.classify(a) != Ok(Classification::Free) {
            return self.goes_deep([from, to], halved);
        }
        let contact = difference(a, b).map(|rates| space.first_contact(a, rates, 1.0));
        let Some(Ok(PairMotion::Contact(contact))) = contact else {
            return false;
        };
        let there = self.place([from, to], contact.time);
        let Ok(touch) = self.pair.touch_of(self.index, contact.patch) else {
            return true;
        };
        if halved == 0 || self.gap(&touch, &there.1) <= 0.0 {
            return true;
        }
        if self.gap(&touch, &straight([from, to], contact.time)) <= 0.0 {
            return self.is_in_halves([from, to], contact.time, halved);
        }
        // Spaces tell contacts a little early: by the features themselves there may be none.
        self.least_gap(&touch, [&there, to]) <= 0.0 || self.goes_deep([&there, to], halved)
    }

    /// Whether they come to be deeper in each other than contacts are known to, from where they touch.
    fn goes_deep(&self, [from, to]: [&Place; 2], halved: usize) -> bool {
        let pair = self.pair;
        let [a, b] = [from, to].map(|place| pair.coordinates(self.system, &place.1));
        let crossings = difference(a, b).map(|rates| pair.space.crossings(a, rates, 1.0));
        let Some(Ok(crossings)) = crossings else {
            return false;
        };
        let mut beside = None;
        let is_met = middles(&crossings).into_iter().any(|(patch, middle)| {
            let Ok(touch) = pair.touch_of(self.index, patch) else {
                return false;
            };
            let is_deep = |q: &[f64]| self.gap(&touch, q) < -pair.touch;
            if !is_deep(&straight([from, to], middle)) {
                return false;
            }
            let is_met = halved == 0 || is_deep(&self.place([from, to], middle).1);
            if !is_met {
                beside = beside.or(Some(middle));
            }
            is_met
        });
        is_met || beside.is_some_and(|share| self.is_in_halves([from, to], share, halved))
    }

    /// Whether they meet before or after a share of the way between two places.
    fn is_in_halves(&self, [from, to]: [&Place; 2], share: f64, halved: usize) -> bool {
        let share = if INNER.contains(&share) { share } else { 0.5 };
        let middle = self.place([from, to], share);
        self.is_between([from, &middle], halved - 1) || self.is_between([&middle, to], halved - 1)
    }

    /// The place at a share of the path between two others.
    fn place(&self, [from, to]: [&Place; 2], share: f64) -> Place {
        let share = from.0 + share * (to.0 - from.0);
        (share, self.path.at(share))
    }

    fn gap(&self, touch: &Touch, q: &[f64]) -> f64 {
        self.pair.function(touch, self.system, q).value
    }

    /// The least gap of a contact between two places, between which it has at most one least.
    fn least_gap(&self, touch: &Touch, ends: [&Place; 2]) -> f64 {
        let closing = |share: f64, q: &[f64]| {
            let row = self.pair.function(touch, self.system, q);
            -row.rate(&self.path.rates(share))
        };
        let [from, to] = ends;
        let (begins, goes_on) = (closing(from.0, &from.1), closing(to.0, &to.1));
        let least = (begins > 0.0 && goes_on < 0.0)
            .then(|| {
                root((from.0, begins), (to.0, goes_on), |share| {
                    Some(closing(share, &self.path.at(share)))
                })
            })
            .flatten();
        let inside = least.map_or(f64::INFINITY, |share| self.gap(touch, &self.path.at(share)));
        inside.min(self.gap(touch, &to.1))
    }
}

/// The coordinates at a share of the straight way between two places.
fn straight([from, to]: [&Place; 2], share: f64) -> Vec<f64> {
    let ends = from.1.iter().zip(&to.1);
    ends.map(|(a, b)| a + share * (b - a)).collect()
}

/// Half way between where a way goes into blocked space, through which patch, and where it comes out again or ends.
fn middles(crossings: &[PairCrossing]) -> Vec<(PatchId, f64)> {
    let enters = crossings.iter().enumerate().filter(|(_, c)| c.enters);
    enters
        .map(|(k, crossing)| {
            let out = crossings[k..].iter().find(|c| !c.enters);
            let end = out.map_or(1.0, |c| c.time);
            (crossing.patch, 0.5 * (crossing.time + end))
        })
        .collect()
}

/// The rates of a straight way that takes a second.
fn difference(a: Coordinates, b: Coordinates) -> Option<Coordinates> {
    match (a, b) {
        (Coordinates::Planar(a), Coordinates::Planar(b)) => Some(Coordinates::Planar(
            Configuration::new(b.x - a.x, b.y - a.y, b.theta - a.theta),
        )),
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: s, v: t }) => {
            Some(Coordinates::Axes { u: s - u, v: t - v })
        }
        _ => None,
    }
}
