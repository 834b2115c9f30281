//! The way of least weight along tracks, and along the bends of the given way.

use core::f64::consts::TAU;
use std::collections::{BTreeMap, BinaryHeap};

use cspace::Point;

use crate::legs::{Coords, Scene};
use crate::open::Open;
use crate::route::along;

use super::outside::Outs;
use super::shorten::KEPT;
use super::tracks::Tracks;

/// A leg in the direction of a track or a turn on the spot weighs 1, a straight leg in another direction this,
pub(super) const ACROSS: f64 = 1.25;
/// and a leg that turns and moves this.
const MIXED: f64 = 1.5;
/// A way as long as the given one weighs as much as this share of a leg.
const LENGTH: f64 = 0.01;
/// So many legs are tried at most: what is found then is enough.
const MOST: usize = 20_000;

/// Where a search is: at an orientation and a point of the tracks, or at a bend of the given way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum State {
    Crossing {
        angle: u32,
        point: u32,
    },
    Bend(u32),
    /// Out, on a track that is followed ahead or back.
    Out {
        angle: u32,
        line: u32,
        ahead: bool,
    },
}

#[derive(Debug, Clone, Copy)]
struct Reached {
    weight: f64,
    before: Option<State>,
    done: bool,
}

/// The clearance of legs: the least anywhere, and the most that is required because the given way has more.
#[derive(Debug, Clone, Copy)]
pub(super) struct Keep {
    pub(super) least: f64,
    pub(super) most: f64,
}

/// A way, with its length, the clearance of its legs, where it bends, and tracks through it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Given<'s> {
    pub(super) scene: &'s Scene,
    pub(super) places: &'s [Coords],
    pub(super) length: f64,
    pub(super) profile: &'s [f64],
    pub(super) bends: &'s [Coords],
    pub(super) tracks: &'s Tracks,
    pub(super) outs: &'s Outs,
}

/// A search along tracks and bends.
pub(super) struct Search<'s> {
    given: &'s Given<'s>,
    keep: Keep,
    /// So many orientations are used.
    angles: u32,
    /// Weight of the best path known: paths that weigh as much or more are not sought.
    most: f64,
    reached: BTreeMap<State, Reached>,
    open: BinaryHeap<Open<State>>,
    required: BTreeMap<State, f64>,
    /// Whether the legs between states that are often tried are free.
    free: BTreeMap<(State, State), bool>,
    tried: usize,
}

impl<'s> Search<'s> {
    pub(super) fn new(given: &'s Given<'s>, keep: Keep, angles: usize, most: f64) -> Self {
        Self {
            given,
            keep,
            angles: angles as u32,
            most,
            reached: BTreeMap::new(),
            open: BinaryHeap::new(),
            required: BTreeMap::new(),
            free: BTreeMap::new(),
            tried: 0,
        }
    }

    /// The way of least weight from the first to the last place, with that.
    pub(super) fn run(&mut self) -> Option<(f64, Vec<Coords>)> {
        let start = State::Bend(0);
        self.reach(start, 0.0, None);
        while let Some(Open { state, .. }) = self.open.pop() {
            let here = self.reached.get_mut(&state)?;
            if here.done {
                continue;
            }
            here.done = true;
            let weight = here.weight;
            if self.is_goal(state) {
                return Some((weight, self.unrolled(state)));
            }
            if self.tried > MOST {
                return None;
            }
            match state {
                State::Bend(k) => self.leave_bend(k, weight),
                State::Crossing { angle, point } => self.leave_crossing((angle, point), weight),
                State::Out { .. } => {}
            }
        }
        None
    }

    fn is_goal(&self, state: State) -> bool {
        let Some(goal) = self.given.bends.last() else {
            return true;
        };
        match state {
            State::Out { .. } => true,
            State::Bend(k) => k as usize + 1 == self.given.bends.len(),
            State::Crossing { .. } => {
                let at = self.place(state);
                let turns = ((at[2] - goal[2]) / TAU).round();
                let angle = if turns == 0.0 {
                    goal[2]
                } else {
                    goal[2] + TAU * turns
                };
                at == [goal[0], goal[1], angle]
            }
        }
    }

    fn place(&self, state: State) -> Coords {
        let tracks = self.given.tracks;
        match state {
            State::Bend(k) => self.given.bends[k as usize],
            State::Crossing { angle, point } => {
                let at = tracks.points[point as usize];
                [at.x, at.y, tracks.angles[angle as usize]]
            }
            State::Out { angle, line, ahead } => {
                let out = self.given.outs.at(angle, line, ahead).unwrap_or(0.0);
                let at = tracks.tracks[line as usize].point(out);
                [at.x, at.y, tracks.angles[angle as usize]]
            }
        }
    }

    fn unrolled(&self, last: State) -> Vec<Coords> {
        let mut places = vec![self.place(last)];
        let mut state = last;
        while let Some(before) = self.reached.get(&state).and_then(|r| r.before) {
            places.push(self.place(before));
            state = before;
        }
        places.reverse();
        places.dedup();
        places
    }

    fn reach(&mut self, state: State, weight: f64, before: Option<State>) {
        if weight >= self.most {
            return;
        }
        if self.is_goal(state) {
            self.most = weight.next_up();
        }
        let known = self.reached.get(&state);
        if known.is_some_and(|k| k.done || k.weight <= weight) {
            return;
        }
        let reached = Reached {
            weight,
            before,
            done: false,
        };
        self.reached.insert(state, reached);
        self.open.push(Open {
            cost: weight,
            state,
        });
    }

    /// The clearance that a leg keeps near a state.
    fn required(&mut self, state: State) -> f64 {
        if let Some(&known) = self.required.get(&state) {
            return known;
        }
        let at = self.place(state);
        let Given {
            scene,
            places,
            profile,
            ..
        } = *self.given;
        let mut nearest = (f64::INFINITY, 0.0);
        for (leg, &clearance) in places.windows(2).zip(profile) {
            let s = share(scene, at, (leg[0], leg[1]));
            let apart = scene.long(at, along(leg[0], leg[1], s));
            if apart < nearest.0 {
                nearest = (apart, clearance);
            }
        }
        let required = (KEPT * nearest.1.min(self.keep.most)).max(self.keep.least);
        self.required.insert(state, required);
        required
    }

    fn is_free(&mut self, from: State, to: State) -> bool {
        self.tried += 1;
        let required = self.required(from).min(self.required(to));
        let (from, to) = (self.place(from), self.place(to));
        self.given.scene.is_clearly_apart(from, to, required)
    }

    /// As [`is_free`](Self::is_free), remembered.
    fn is_free_track(&mut self, from: State, to: State) -> bool {
        let key = (from.min(to), from.max(to));
        if let Some(&known) = self.free.get(&key) {
            return known;
        }
        let found = self.is_free(from, to);
        self.free.insert(key, found);
        found
    }

    fn weighed(&self, weight: f64, leg: f64, from: State, to: State) -> f64 {
        let long = (self.given.scene).long(self.place(from), self.place(to));
        weight + leg + LENGTH * long / self.given.length
    }

    /// From a bend along the given way, across to its later bends, and onto the tracks.
    fn leave_bend(&mut self, k: u32, weight: f64) {
        let from = State::Bend(k);
        let Given { bends, tracks, .. } = *self.given;
        let last = bends.len() as u32 - 1;
        for to in (k + 1)..=last {
            let ahead = to - k;
            // Of many those beside it, and then ever fewer.
            if to == last || ahead <= 4 || ahead.is_power_of_two() {
                self.across(from, State::Bend(to), weight, ahead == 1);
            }
        }
        let at = self.place(from);
        let far = |p: &Point| (p.x - at[0]).hypot(p.y - at[1]);
        let nearest = (0u32..)
            .zip(&tracks.points)
            .min_by(|a, b| far(a.1).total_cmp(&far(b.1)));
        let Some((point, _)) = nearest else {
            return;
        };
        for angle in 0..self.angles {
            let to = State::Crossing { angle, point };
            if self.place(to) == at {
                self.reach(to, weight, Some(from));
            } else {
                self.across(from, to, weight, false);
            }
        }
    }

    /// A leg that is not along a track.
    fn across(&mut self, from: State, to: State, weight: f64, is_known: bool) {
        let (a, b) = (self.place(from), self.place(to));
        let leg = match (a[2] == b[2], a[..2] == b[..2]) {
            (true, _) => ACROSS,
            (_, true) => 1.0,
            _ => MIXED,
        };
        let weight = self.weighed(weight, leg, from, to);
        if weight < self.most && !self.is_done(to) && (is_known || self.is_free(from, to)) {
            self.reach(to, weight, Some(from));
        }
    }

    fn leave_crossing(&mut self, (angle, point): (u32, u32), weight: f64) {
        let from = State::Crossing { angle, point };
        let Given { tracks, bends, .. } = *self.given;
        if weight + 1.0 >= self.most {
            return;
        }
        for &on in &tracks.through[point as usize] {
            for ahead in [true, false] {
                self.along_track((from, angle), on, ahead, weight);
            }
        }
        for other in (0..self.angles).filter(|&o| o != angle) {
            let to = State::Crossing {
                angle: other,
                point,
            };
            let weight = self.weighed(weight, 1.0, from, to);
            if weight < self.most && !self.is_done(to) && self.is_free_track(from, to) {
                self.reach(to, weight, Some(from));
            }
        }
        self.across(from, State::Bend(bends.len() as u32 - 1), weight, false);
        // Back to the given way where it is at this place.
        for k in 0..bends.len() as u32 {
            if bends[k as usize] == self.place(from) {
                self.reach(State::Bend(k), weight, Some(from));
            }
        }
    }

    /// From a crossing along a track, as far as it is free, up to where it comes out.
    fn along_track(
        &mut self,
        (from, angle): (State, u32),
        (line, own): (u32, u32),
        ahead: bool,
        weight: f64,
    ) {
        let tracks = self.given.tracks;
        let points = &tracks.lines[line as usize];
        let track = &tracks.tracks[line as usize];
        let out = self.given.outs.at(angle, line, ahead);
        let is_beyond = |s: f64, out: f64| if ahead { s >= out } else { s <= out };
        let (mut here, mut at) = (own, from);
        loop {
            let next = if ahead {
                here.checked_add(1)
            } else {
                here.checked_sub(1)
            };
            let next = next.and_then(|n| Some((n, *points.get(n as usize)?)));
            let place = next.map(|(_, point)| track.along(tracks.points[point as usize]));
            if let Some(out) = out
                && place.is_none_or(|s| is_beyond(s, out))
            {
                let to = State::Out { angle, line, ahead };
                let place = track.along(tracks.points[points[here as usize] as usize]);
                // Beyond where it comes out it is out already.
                if !is_beyond(place, out) && self.is_free_track(at, to) {
                    let weight = self.weighed(weight, 1.0, from, to);
                    self.reach(to, weight, Some(from));
                }
                return;
            }
            let Some((next, point)) = next else {
                return;
            };
            let to = State::Crossing { angle, point };
            if !self.is_free_track(at, to) {
                return;
            }
            let weight = self.weighed(weight, 1.0, from, to);
            self.reach(to, weight, Some(from));
            (here, at) = (next, to);
        }
    }

    fn is_done(&self, state: State) -> bool {
        self.reached.get(&state).is_some_and(|r| r.done)
    }
}

/// The share of a leg at which it is nearest to a place.
fn share(scene: &Scene, at: Coords, (from, to): (Coords, Coords)) -> f64 {
    let levers = scene.levers();
    let dot =
        |a: Coords, b: Coords| -> f64 { (0..3).map(|k| a[k] * b[k] * levers[k] * levers[k]).sum() };
    let way = core::array::from_fn(|k| to[k] - from[k]);
    let here = core::array::from_fn(|k| at[k] - from[k]);
    let whole = dot(way, way);
    if whole > 0.0 {
        (dot(here, way) / whole).clamp(0.0, 1.0)
    } else {
        0.0
    }
}
