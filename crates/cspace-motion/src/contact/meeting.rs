//! Search for meetings of a pair's parts on the path of a step.

use cspace::pair::PairMotion;
use cspace::{Classification, Coordinates, PairSpace, QueryError};

use crate::pairs::{MovingPair, Touch};
use crate::root::root;
use crate::system::System;

use super::classes::Classes;
use super::path::Path;
use super::straight::{between, control_points, difference, middles, straight_gap};

/// Largest distance between the pair's path and its chord, relative to the size of the mechanism, at which a piece that
/// begins in contact counts as straight: a contact by less than that is missed until the parts are apart.
const STRAIGHT: f64 = 1e-6;
/// As above, for a piece that begins with the parts apart: the space between path and chord is searched as well.
const NEARLY_STRAIGHT: f64 = 1e-4;
/// A piece that is not straight is halved at most so many times.
const MOST_BENT: usize = 12;
/// Length of the first pieces of a step that begins in contact, until the parts are apart: this share of the step, and
/// the same share of that. The first piece is straight within the accuracy of contacts.
const FIRST: f64 = 1.0 / 64.0;

/// Largest ratio of the length of a path between two configurations of a step to their distance.
const LONGER: f64 = 1.1;

/// Largest number of halvings of a piece of which the chord has a contact and the path itself has none: the distance
/// between them falls by a factor of four each time, from a thousandth of the size to rounding. A contact that is left
/// then counts as met.
const MOST_HALVED: usize = 20;
/// Range of the shares at which a piece is divided at that contact; elsewhere it is divided in the middle.
const INNER: core::ops::RangeInclusive<f64> = 0.1..=0.9;

/// A share of a path, and the coordinates there.
type Place = (f64, Vec<f64>);

/// Search for a meeting of the two parts of a pair on a path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Meeting<'m> {
    pub(super) system: &'m System,
    pub(super) pair: &'m MovingPair,
    /// The pair's number.
    pub(super) index: usize,
    pub(super) path: &'m Path<'m>,
    /// Cached classifications of the pair where steps begin and end.
    pub(super) classes: &'m Classes,
    /// Largest possible distance between its parts where the path begins.
    pub(super) ceiling: f64,
}

impl Meeting<'_> {
    /// Largest distance by which points of the two parts move.
    pub(super) fn travel(&self) -> f64 {
        let (from, middle, to) = (self.path.from(), self.path.middle(), self.path.to());
        self.way(from, middle) + self.way(middle, to)
    }

    fn way(&self, from: &[f64], to: &[f64]) -> f64 {
        let of = |part: usize| -> f64 {
            let indices = self.system.parts()[part].indices();
            let each = indices.zip(self.system.levers()[part]);
            each.map(|(i, lever)| lever * (to[i] - from[i]).abs()).sum()
        };
        LONGER * (of(self.pair.fixed) + of(self.pair.moving))
    }

    /// Whether the parts meet anywhere on the path.
    pub(super) fn happens(&self) -> bool {
        let mut from = (0.0, self.path.at(0.0));
        for end in [FIRST * FIRST, FIRST, 1.0] {
            let is_apart = self.class(self.coordinates(&from.1)) == Ok(Classification::Free);
            let (end, straight) = if is_apart {
                (1.0, NEARLY_STRAIGHT)
            } else {
                (end, STRAIGHT)
            };
            let to = (end, self.path.at(end));
            if self.is_on([&from, &to], straight, MOST_BENT) {
                return true;
            }
            if end == 1.0 {
                break;
            }
            from = to;
        }
        false
    }

    /// Whether the parts meet between two places, searched in straight pieces.
    fn is_on(&self, [from, to]: [&Place; 2], straight: f64, bent: usize) -> bool {
        if bent == 0 || self.is_straight([from, to], straight) {
            return self.is_between([from, to], MOST_HALVED);
        }
        let way = self.way(&from.1, &to.1);
        // Motions on axes are followed in less time than distances are measured.
        let likely = match &self.pair.space {
            PairSpace::FixedAxes(_) => {
                2.0 * way <= self.ceiling + self.way(self.path.from(), &from.1)
            }
            PairSpace::Planar(_) | PairSpace::Lower(_) => true,
        };
        let clearance = || self.pair.space.clearance(self.coordinates(&from.1));
        if likely && clearance().is_ok_and(|clearance| way <= clearance) {
            return false;
        }
        let middle = self.place([from, to], 0.5);
        self.is_on([from, &middle], straight, bent - 1)
            || self.is_on([&middle, to], straight, bent - 1)
    }

    /// Whether the pair's configuration moves on a straight line between two places, as checked at two others between
    /// them: a cubic that is straight there is straight everywhere.
    fn is_straight(&self, [from, to]: [&Place; 2], straight: f64) -> bool {
        let ends = [from, to].map(|place| self.coordinates(&place.1));
        [0.25, 0.75].into_iter().all(|share| {
            let there = self.coordinates(&self.place([from, to], share).1);
            let off = between(ends, share).and_then(|straight| difference(straight, there));
            off.is_some_and(|off| self.length(off) <= straight * self.system.size())
        })
    }

    /// Upper bound of the distance by which a change of the pair's configuration moves points of the moving part, or of
    /// both parts on axes.
    fn length(&self, change: Coordinates) -> f64 {
        let [fixed, moving] =
            [self.pair.fixed, self.pair.moving].map(|part| self.system.levers()[part]);
        match change {
            Coordinates::Planar(c) => {
                c.x.hypot(c.y) + self.system.reach(self.pair.moving) * c.theta.abs()
            }
            Coordinates::Axes { u, v } => fixed[0] * u.abs() + moving[0] * v.abs(),
        }
    }

    fn class(&self, at: Coordinates) -> Result<Classification, QueryError> {
        self.classes.of(self.index, self.pair, at)
    }

    fn coordinates(&self, q: &[f64]) -> Coordinates {
        self.pair.coordinates(self.system, q)
    }

    /// Whether the parts meet on the path between two places. The first contact is computed exactly on the chord, and
    /// counts if the path itself reaches it.
    fn is_between(&self, [from, to]: [&Place; 2], halved: usize) -> bool {
        let space = &self.pair.space;
        let [a, b] = [from, to].map(|place| self.coordinates(&place.1));
        if self.class(a) != Ok(Classification::Free) {
            return self.goes_deep([from, to], halved);
        }
        let contact = difference(a, b).map(|rates| space.first_contact(a, rates, 1.0));
        let Some(Ok(PairMotion::Contact(contact))) = contact else {
            return self.is_beside([from, to], halved);
        };
        let there = self.place([from, to], contact.time);
        let Ok(touch) = self.pair.touch_of(self.index, contact.patch) else {
            return true;
        };
        if halved == 0 || self.gap(&touch, &there.1) <= 0.0 {
            return true;
        }
        if straight_gap(&touch, [a, b], contact.time) <= 0.0 {
            return self.is_in_halves([from, to], contact.time, halved);
        }
        // Spaces report contacts a little early: by the features themselves there may be none.
        self.least_gap(&touch, [&there, to]) <= 0.0 || self.goes_deep([&there, to], halved)
    }

    /// Whether they meet between two places on the path, which is beside the straight way, on which they do not.
    ///
    /// ```text
    ///            p₁ ------- p₂         A cubic is between its chord and the legs over its control points. What comes to it
    ///           /   ___·___   \        comes through one of these: there is nothing so small that it has room between them.
    ///          / ·'    ▲    '· \       Where a leg meets something, the path is halved: the room falls by four with each
    ///   from  ·-----------------· to   halving.
    /// ```
    fn is_beside(&self, [from, to]: [&Place; 2], halved: usize) -> bool {
        let ends = [from, to].map(|place| self.coordinates(&place.1));
        let on_path = |share: f64| self.coordinates(&self.place([from, to], share).1);
        let Some(legs) = control_points(ends, [1.0 / 3.0, 2.0 / 3.0].map(on_path)) else {
            return false;
        };
        let beside = |at: Coordinates, share: f64| {
            let off = between(ends, share).and_then(|straight| difference(straight, at));
            off.map_or(0.0, |off| self.length(off))
        };
        let room = beside(legs[1], 1.0 / 3.0).max(beside(legs[2], 2.0 / 3.0));
        let most = 2.0 * NEARLY_STRAIGHT * self.system.size();
        if halved == 0 || room <= self.pair.space.resolution() || room > most {
            return false;
        }
        let space = &self.pair.space;
        let is_free = |leg: &[Coordinates]| {
            let motion =
                difference(leg[0], leg[1]).map(|rates| space.first_contact(leg[0], rates, 1.0));
            matches!(motion, Some(Ok(PairMotion::Free)))
        };
        if legs.windows(2).all(is_free) {
            return false;
        }
        self.is_in_halves([from, to], 0.5, halved)
    }

    /// Whether the parts, from where they touch, penetrate each other by more than the error of contacts.
    fn goes_deep(&self, [from, to]: [&Place; 2], halved: usize) -> bool {
        let pair = self.pair;
        let [a, b] = [from, to].map(|place| self.coordinates(&place.1));
        let crossings = difference(a, b).map(|rates| pair.space.crossings(a, rates, 1.0));
        let Some(Ok(crossings)) = crossings else {
            return false;
        };
        let mut beside = None;
        let is_met = middles(&crossings).into_iter().any(|(patch, middle)| {
            let Ok(touch) = pair.touch_of(self.index, patch) else {
                return false;
            };
            if straight_gap(&touch, [a, b], middle) >= -pair.touch {
                return false;
            }
            let there = self.place([from, to], middle);
            let is_met = halved == 0 || self.gap(&touch, &there.1) < -pair.touch;
            if !is_met {
                beside = beside.or(Some(middle));
            }
            is_met
        });
        is_met || beside.is_some_and(|share| self.is_in_halves([from, to], share, halved))
    }

    /// Whether the parts meet before or after a share of the path between two places.
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
