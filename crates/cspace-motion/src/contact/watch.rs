//! Check of a step for contacts that came or went, ends of ranges, and windows.

use cspace::{Classification, PairSpace, PatchId, QueryError};

use crate::pairs::{MovingPair, Pairs, Touch};
use crate::system::System;

use super::bound::{Bound, SAME_PLACE, limits};
use super::classes::Classes;
use super::cleared::Cleared;
use super::ends::{PAST_END, ends};
use super::meeting::Meeting;
use super::path::Path;
use super::pinch::pinching;

/// A step moves no part by more than this, relative to the size of the mechanism; angles count by their parts' sizes.
pub(crate) const LONGEST: f64 = 0.02;

/// Share of a pair's clearance that each of the six coordinates of its parts may use up, twice over.
const SHARE: f64 = 1.0 / 14.0;

/// Upper bound of `likely`: a clearance is computed wherever it may be so many times the required one.
const MOST_LIKELY: f64 = 64.0;

/// Reason for which a step cannot be taken as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Met {
    /// A contact is no longer where two features touch, or the parts of a pair met.
    Contact,
    /// A pair left the orientations of its space.
    Window,
}

/// State of each pair's check for collisions while the same contacts are closed.
#[derive(Debug)]
pub(crate) struct Watch<'a> {
    system: &'a System,
    pairs: &'a Pairs,
    /// Distance that each pair's parts may move before they can meet; 0 if unknown.
    room: Vec<f64>,
    /// Upper bound of each pair's clearance: the last known one plus the distance moved since.
    ceiling: Vec<f64>,
    /// Factor for each pair: a clearance is computed where it may be this multiple of the required one. It doubles each
    /// time that it turns out to be smaller.
    likely: Vec<f64>,
    /// Last contact patches of each pair's features, which may touch on several at once.
    patches: Vec<Vec<Touch>>,
    /// Cached classifications of pairs where steps begin and end.
    classes: Classes,
    /// Cache of the steps in which pairs meet nothing.
    cleared: Cleared,
    /// The pair that met something in the step that was looked at last.
    met: Option<usize>,
}

impl<'a> Watch<'a> {
    pub(crate) fn new(system: &'a System, pairs: &'a Pairs) -> Self {
        Self {
            system,
            pairs,
            room: vec![0.0; pairs.list().len()],
            ceiling: vec![f64::INFINITY; pairs.list().len()],
            likely: vec![1.0; pairs.list().len()],
            patches: vec![Vec::new(); pairs.list().len()],
            classes: Classes::new(pairs.list().len()),
            cleared: Cleared::new(pairs.list().len()),
            met: None,
        }
    }

    fn meeting<'m>(&'m self, index: usize, path: &'m Path<'m>) -> Meeting<'m> {
        let pair = &self.pairs.list()[index];
        Meeting {
            system: self.system,
            pair,
            index,
            path,
            classes: &self.classes,
            ceiling: self.ceiling[index],
        }
    }

    /// Largest change of each coordinate, in the lengths of [`System::lengths`], before parts can meet or reach the end
    /// of a range.
    pub(crate) fn freedom(&self, q: &[f64]) -> Vec<f64> {
        let parts = self.system.parts();
        let mut rooms = vec![f64::INFINITY; parts.len()];
        for pair in self.pairs.list() {
            let at = pair.coordinates(self.system, q);
            let clearance = pair.space.clearance(at).unwrap_or(0.0);
            for part in [pair.fixed, pair.moving] {
                rooms[part] = f64::min(rooms[part], SHARE * clearance);
            }
        }
        for (bound, room) in limits(self.system, q) {
            if let Bound::Limit { part, .. } = bound {
                let lever = self.system.levers()[part][0];
                rooms[part] = rooms[part].min(SHARE * lever * room.max(0.0));
            }
        }
        let mut all = vec![f64::INFINITY; q.len()];
        for (part, room) in rooms.into_iter().enumerate() {
            for (i, lever) in parts[part].indices().zip(self.system.levers()[part]) {
                all[i] = room / lever * self.system.lengths()[i];
            }
        }
        all
    }

    /// Checks a step along a path on which some bounds are held; returns the first obstacle found.
    pub(crate) fn check(&mut self, held: &[Bound], path: &Path<'_>) -> Option<Met> {
        let all = 0..self.pairs.list().len();
        self.cleared.begin(held, path);
        let mut each = all.map(|pair| (pair, self.check_pair(pair, held, path)));
        let found = each.find_map(|(pair, met)| Some((pair, met?)));
        self.met = found.map(|(pair, _)| pair);
        found.map(|(_, met)| met)
    }

    /// The pair that met something in the step that was looked at last, if one did.
    pub(crate) fn met(&self) -> Option<usize> {
        self.met
    }

    fn check_pair(&mut self, index: usize, held: &[Bound], path: &Path<'_>) -> Option<Met> {
        let pair = &self.pairs.list()[index];
        let (from, to) = (path.from(), path.to());
        let outside = |error: QueryError| match error {
            QueryError::Outside => Met::Window,
            _ => Met::Contact,
        };
        let held = held.iter().filter_map(|b| match b {
            Bound::Contact(touch) if touch.pair == index => Some(touch),
            _ => None,
        });
        let mut closed = held.clone().peekable();
        if closed.peek().is_some() {
            (self.room[index], self.ceiling[index]) = (0.0, pair.touch);
            // Nearly always the patch is followed.
            if held
                .clone()
                .all(|touch| self.follows(pair, touch, [from, to]))
            {
                return None;
            }
            let touches = match pair.touches(index, self.system, to, pair.touch) {
                Ok(touches) => touches,
                Err(error) => return Some(outside(error)),
            };
            let gap = |touch: &Touch| pair.function(touch, self.system, to).value;
            let deep = held.clone().map(gap).fold(0.0, f64::min).abs() + pair.space.resolution();
            let has =
                |all: &[Touch], touch: &Touch| all.iter().any(|t| t.features == touch.features);
            let stays = |touch: &Touch| {
                if has(&touches, touch) {
                    self.stays(pair, touch, [from, to], pair.touch)
                } else if self.is_level(pair, touch, to, deep) {
                    true
                } else {
                    let near = SAME_PLACE * self.system.size();
                    has(&pinching(self.system, (index, pair), to), touch)
                        && self.stays(pair, touch, [from, to], near)
                }
            };
            if !closed.all(stays) {
                return Some(Met::Contact);
            }
            self.patches[index] = touches;
            return None;
        }
        let travel = self.meeting(index, path).travel();
        if travel <= self.room[index] {
            return None;
        }
        if travel == 0.0 || self.cleared.covers(index, path) {
            return None;
        }
        // Nothing is asked of which the answer is known to be no, or is likely to be.
        if self.likely[index] * travel <= self.ceiling[index] {
            let at = pair.coordinates(self.system, from);
            match pair.space.clearance(at) {
                Ok(clearance) => {
                    let class = if clearance > 0.0 {
                        Classification::Free
                    } else {
                        Classification::Contact
                    };
                    self.classes.tell(index, at, class);
                    (self.room[index], self.ceiling[index]) = (clearance, clearance);
                    if travel <= clearance {
                        self.likely[index] = 1.0;
                        return None;
                    }
                    self.likely[index] = MOST_LIKELY.min(2.0 * self.likely[index]);
                }
                // It may be as deep as a contact's tolerance.
                Err(QueryError::Blocked) => self.ceiling[index] = pair.touch,
                Err(error) => return Some(outside(error)),
            }
        }
        match self
            .classes
            .of(index, pair, pair.coordinates(self.system, to))
        {
            // Overlap no deeper than a contact's tolerance does not count: where a coordinate turns around on a
            // contact, rounding looks deep.
            Ok(Classification::Blocked) => match pair.touches(index, self.system, to, pair.touch) {
                Ok(touches) if !touches.is_empty() => {}
                _ => return Some(Met::Contact),
            },
            Err(error) => return Some(outside(error)),
            Ok(_) => {}
        }
        if self.meeting(index, path).happens() {
            return Some(Met::Contact);
        }
        self.cleared.tell(index, path);
        None
    }

    /// Whether both ends of a step are on the patch on which two features touched last.
    fn follows(&self, pair: &MovingPair, touch: &Touch, ends: [&[f64]; 2]) -> bool {
        let last = self.patches[touch.pair].iter();
        let last = last.into_iter().find(|t| t.features == touch.features);
        let patch = last.unwrap_or(touch).patch;
        ends.into_iter().all(|q| {
            let at = pair.coordinates(self.system, q);
            pair.space.is_on(patch, at, pair.touch) == Ok(true)
        })
    }

    /// Whether two features still touch within the error of contacts, although others keep the parts apart there by
    /// less than that: as on the lower of two tiles. The parts do not overlap by more than a depth.
    fn is_level(&self, pair: &MovingPair, touch: &Touch, q: &[f64], deep: f64) -> bool {
        let PairSpace::Planar(_) = &pair.space else {
            return false;
        };
        let gap = pair.function(touch, self.system, q).value;
        let turn = (pair.touch / pair.space.moving().size()).max(PAST_END);
        let all = ends(pair, touch, self.system, q);
        if gap.abs() > pair.touch || all.is_empty() || all.iter().any(|end| *end < -turn) {
            return false;
        }
        let at = pair.coordinates(self.system, q);
        match pair.space.classify(at) {
            Ok(Classification::Blocked) => {
                let nearest = pair.space.nearest_contact(at).ok().flatten();
                nearest.is_some_and(|nearest| nearest.distance <= deep)
            }
            class => class.is_ok(),
        }
    }

    /// Whether a contact that is closed at both ends of a step was closed during the whole step.
    ///
    /// On fixed axes patches are curves, and a step that begins and ends on one of them stayed on it. The same features
    /// may touch on another patch as well, with other features holding the parts between the two. `reach` is the
    /// largest distance at which patches count as touching.
    fn stays(&self, pair: &MovingPair, touch: &Touch, [from, to]: [&[f64]; 2], reach: f64) -> bool {
        let PairSpace::FixedAxes(_) = &pair.space else {
            return true;
        };
        let of_features = |patch: &PatchId| {
            let found = pair.space.patch(*patch).and_then(|p| p.features());
            found == Ok(touch.features)
        };
        let patches = |q: &[f64]| -> Vec<PatchId> {
            let at = pair.coordinates(self.system, q);
            let near = pair.space.contacts(at, reach).unwrap_or_default();
            near.into_iter().map(|n| n.0).filter(of_features).collect()
        };
        let (begun, ended) = (patches(from), patches(to));
        let goes_on = |patch: &PatchId| {
            let beside = pair.space.neighbours(*patch).unwrap_or_default();
            let mut same = beside.before.iter().chain(&beside.after).chain([patch]);
            same.any(|p| ended.contains(p))
        };
        begun.iter().chain([&touch.patch]).any(goes_on)
    }

    /// Updates the rooms and ceilings of all pairs after a step along a path was taken.
    pub(crate) fn taken(&mut self, path: &Path<'_>) {
        for index in 0..self.pairs.list().len() {
            let travel = self.meeting(index, path).travel();
            self.room[index] -= travel;
            self.ceiling[index] += travel;
        }
    }
}
