//! Few and simple legs: the way of least weight along tracks, and along the given way where tracks lead nowhere.

use core::cmp::Ordering;
use core::f64::consts::TAU;
use std::collections::{BTreeMap, BinaryHeap};

use crate::legs::{Coords, Scene};
use crate::route::along;

use super::legs::Legs;
use super::tracks::Tracks;

/// What makes a way good.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Prefer {
    /// Few legs, each straight or a turn on the spot where that is possible.
    #[default]
    Legs,
    /// Clearance: legs keep most of what the way has where it is.
    Clearance,
    /// A short way.
    Length,
}

/// A leg in the direction of a track or a turn on the spot weighs 1, a straight leg in another direction this,
const ACROSS: f64 = 1.25;
/// and a leg that turns and moves this.
const MIXED: f64 = 1.5;
/// A way as long as the given one weighs as much as this share of a leg.
const LENGTH: f64 = 0.01;
/// A leg keeps this share of the clearance that the given way has where it is.
const KEPT: f64 = 0.5;
/// So many legs are tried at most: what is found then is enough.
const MOST: usize = 20_000;
/// Clearances that are tried beside the one that is asked for, as shares of that of the given way.
const SHARES: [f64; 2] = [1.0 - 1e-6, 0.8];

/// Where a search is: at an orientation and a point of the tracks, or at a bend of the given way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum State {
    Crossing { angle: u32, point: u32 },
    Bend(u32),
}

#[derive(Debug, Clone, Copy)]
struct Reached {
    weight: f64,
    before: Option<State>,
    done: bool,
}

#[derive(Debug, PartialEq)]
struct Open {
    weight: f64,
    state: State,
}

impl Eq for Open {}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        (other.weight.total_cmp(&self.weight)).then(other.state.cmp(&self.state))
    }
}

impl<'a> Legs<'a> {
    /// The way with few and simple legs, none of which has less than a clearance.
    pub(crate) fn simple(&self, clearance: f64) -> Legs<'a> {
        let bends = self.shortened(clearance);
        let tracks = Tracks::new(self.scene, bends.places());
        let given = self.narrowest().map_or(0.0, |n| n.1.distance);
        let mut best: Option<(f64, Vec<Coords>)> = None;
        // With as much clearance as few legs have.
        let shares = SHARES.map(|share| share * given);
        for least in [clearance].into_iter().chain(shares) {
            if best.is_some() && least <= clearance {
                continue;
            }
            let mut search = Search::new(self, &bends, &tracks, least);
            if let Some((weight, places)) = search.run()
                && (best.as_ref()).is_none_or(|b| weight < b.0 + 0.5 * (ACROSS - 1.0))
            {
                let enough = best.is_some();
                best = Some((weight, places));
                if enough {
                    break;
                }
            }
        }
        match best {
            Some((_, places)) => Legs::new(self.scene, places),
            None => bends,
        }
    }
}

struct Search<'s> {
    scene: &'s Scene,
    /// The given way, with the clearance of its places, and its bends.
    given: (&'s [Coords], Vec<f64>),
    bends: &'s [Coords],
    tracks: &'s Tracks,
    least: f64,
    length: f64,
    reached: BTreeMap<State, Reached>,
    open: BinaryHeap<Open>,
    required: BTreeMap<State, f64>,
    tried: usize,
}

impl<'s> Search<'s> {
    fn new(legs: &'s Legs<'_>, bends: &'s Legs<'_>, tracks: &'s Tracks, least: f64) -> Self {
        let scene = legs.scene;
        let clearances = legs.places.iter().map(|&p| scene.clearance(p)).collect();
        let length = legs.places.windows(2).map(|l| long(scene, l[0], l[1])).sum();
        Self {
            scene,
            given: (&legs.places, clearances),
            bends: &bends.places,
            tracks,
            least,
            length,
            reached: BTreeMap::new(),
            open: BinaryHeap::new(),
            required: BTreeMap::new(),
            tried: 0,
        }
    }

    /// The way of least weight from the first to the last place, with that.
    fn run(&mut self) -> Option<(f64, Vec<Coords>)> {
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
                State::Bend(k) => self.from_bend(k, weight),
                State::Crossing { angle, point } => self.from_crossing((angle, point), weight),
            }
        }
        None
    }

    fn is_goal(&self, state: State) -> bool {
        let Some(goal) = self.bends.last() else {
            return true;
        };
        match state {
            State::Bend(k) => k as usize + 1 == self.bends.len(),
            State::Crossing { angle, point } => {
                // The points of a way's ends are the first and, if it is another, the second.
                let turned = self.tracks.angles[angle as usize] - goal[2];
                let at = self.tracks.points[point as usize];
                point <= 1
                    && at.x == goal[0]
                    && at.y == goal[1]
                    && (turned == 0.0 || (turned / TAU).round() * TAU + goal[2] == self.tracks.angles[angle as usize])
            }
        }
    }

    fn place(&self, state: State) -> Coords {
        match state {
            State::Bend(k) => self.bends[k as usize],
            State::Crossing { angle, point } => {
                let at = self.tracks.points[point as usize];
                [at.x, at.y, self.tracks.angles[angle as usize]]
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
        self.open.push(Open { weight, state });
    }

    /// The clearance that a leg keeps near a state.
    fn required(&mut self, state: State) -> f64 {
        if let Some(&known) = self.required.get(&state) {
            return known;
        }
        let at = self.place(state);
        let (places, clearances) = &self.given;
        let mut nearest = (f64::INFINITY, 0.0);
        for (leg, c) in places.windows(2).zip(clearances.windows(2)) {
            let s = share(self.scene, at, (leg[0], leg[1]));
            let apart = long(self.scene, at, along(leg[0], leg[1], s));
            if apart < nearest.0 {
                nearest = (apart, c[0] + (c[1] - c[0]) * s);
            }
        }
        let required = (KEPT * nearest.1).max(self.least);
        self.required.insert(state, required);
        required
    }

    fn is_free(&mut self, from: State, to: State) -> bool {
        self.tried += 1;
        let required = self.required(from).min(self.required(to));
        let (from, to) = (self.place(from), self.place(to));
        self.scene.is_apart(from, to, required)
    }

    fn weighed(&self, weight: f64, leg: f64, from: State, to: State) -> f64 {
        let long = long(self.scene, self.place(from), self.place(to));
        weight + leg + LENGTH * long / self.length
    }

    /// From a bend along the given way, across to its later bends, and onto the tracks.
    fn from_bend(&mut self, k: u32, weight: f64) {
        let from = State::Bend(k);
        for to in (k + 1)..self.bends.len() as u32 {
            let next = State::Bend(to);
            let (a, b) = (self.place(from), self.place(next));
            let straight = a[2] == b[2];
            // Not all of many: those beside it, and every second one doubling.
            let ahead = to - k;
            if ahead > 4 && !ahead.is_power_of_two() && to as usize + 1 != self.bends.len() {
                continue;
            }
            if ahead == 1 || self.is_free(from, next) {
                let leg = if straight { ACROSS } else { MIXED };
                let weight = self.weighed(weight, leg, from, next);
                self.reach(next, weight, Some(from));
            }
        }
        let at = self.place(from);
        let own = (0u32..).zip(&self.tracks.points).find(|(_, p)| p.x == at[0] && p.y == at[1]);
        if let Some((point, _)) = own {
            if let Some(angle) = self.tracks.angles.iter().position(|&a| a == at[2]) {
                let angle = angle as u32;
                self.reach(State::Crossing { angle, point }, weight, Some(from));
            }
        }
        // Straight across onto a crossing near by, or by a turn alone.
        let nearest = self.nearest_crossing(at);
        for state in nearest {
            if self.is_free(from, state) {
                let leg = if self.place(state)[2] == at[2] { ACROSS } else { MIXED };
                let weight = self.weighed(weight, leg, from, state);
                self.reach(state, weight, Some(from));
            }
        }
    }

    /// The crossings nearest to a place, one at each orientation.
    fn nearest_crossing(&self, at: Coords) -> Vec<State> {
        let near = (0u32..)
            .zip(&self.tracks.points)
            .min_by(|a, b| {
                let d = |p: &cspace::Point| (p.x - at[0]).hypot(p.y - at[1]);
                d(a.1).total_cmp(&d(b.1))
            })
            .map(|p| p.0);
        let Some(point) = near else {
            return Vec::new();
        };
        (0..self.tracks.angles.len() as u32)
            .map(|angle| State::Crossing { angle, point })
            .collect()
    }

    fn from_crossing(&mut self, (angle, point): (u32, u32), weight: f64) {
        let from = State::Crossing { angle, point };
        let tracks = self.tracks;
        for &(line, own) in &tracks.through[point as usize] {
            let line = &tracks.lines[line as usize];
            for ahead in [true, false] {
                let mut here = own;
                loop {
                    let next = if ahead { Some(here + 1) } else { here.checked_sub(1) };
                    let Some(&to) = next.and_then(|n| line.get(n as usize)) else {
                        break;
                    };
                    let at = |i: u32| State::Crossing { angle, point: line[i as usize] };
                    let (a, b) = (at(here), State::Crossing { angle, point: to });
                    if !self.is_free(a, b) {
                        break;
                    }
                    let weight = self.weighed(weight, 1.0, from, b);
                    self.reach(b, weight, Some(from));
                    here = if ahead { here + 1 } else { here - 1 };
                }
            }
        }
        for other in 0..tracks.angles.len() as u32 {
            let to = State::Crossing { angle: other, point };
            if other != angle && !self.is_done(to) && self.is_free(from, to) {
                let weight = self.weighed(weight, 1.0, from, to);
                self.reach(to, weight, Some(from));
            }
        }
        // Straight to the goal.
        let goal = State::Bend(self.bends.len() as u32 - 1);
        let (a, b) = (self.place(from), self.place(goal));
        if !self.is_done(goal) && self.is_free(from, goal) {
            let leg = if a[2] == b[2] { ACROSS } else { MIXED };
            let weight = self.weighed(weight, leg, from, goal);
            self.reach(goal, weight, Some(from));
        }
        // Back to the given way where it is at this place.
        for k in 0..self.bends.len() as u32 {
            if self.bends[k as usize] == self.place(from) {
                self.reach(State::Bend(k), weight, Some(from));
            }
        }
    }

    fn is_done(&self, state: State) -> bool {
        self.reached.get(&state).is_some_and(|r| r.done)
    }
}

/// How far the parts move on a leg at most.
fn long(scene: &Scene, from: Coords, to: Coords) -> f64 {
    let levers = scene.levers();
    (0..3)
        .map(|k| ((to[k] - from[k]) * levers[k]).powi(2))
        .sum::<f64>()
        .sqrt()
}

/// The share of a leg at which it is nearest to a place.
fn share(scene: &Scene, at: Coords, (from, to): (Coords, Coords)) -> f64 {
    let levers = scene.levers();
    let dot = |a: Coords, b: Coords| -> f64 {
        (0..3).map(|k| a[k] * b[k] * levers[k] * levers[k]).sum()
    };
    let way = core::array::from_fn(|k| to[k] - from[k]);
    let here = core::array::from_fn(|k| at[k] - from[k]);
    let whole = dot(way, way);
    if whole > 0.0 {
        (dot(here, way) / whole).clamp(0.0, 1.0)
    } else {
        0.0
    }
}
