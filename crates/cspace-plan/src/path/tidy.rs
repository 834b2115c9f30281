//! Legs with few digits: "right 35 mm, turn 90°" where "right 34.84 mm, turn 89.55°" would do.
//!
//! A leg is made longer or shorter, or turns by more or less, until its number is round. Places after it are moved by as much, up to a
//! later leg in the same direction, which takes up the difference; what is out may end elsewhere.

use cspace::Vector;

use crate::legs::{Coords, Scene};

use super::legs::Legs;
use super::outside::{Outside, is_out};
use super::tracks::{aligned_near, alignments};

/// A leg keeps this share of its clearance.
const KEPT: f64 = 0.9;
/// A number changes by this share of it at most.
const CHANGED: f64 = 0.05;
/// Lengths have so many digits at most.
const DIGITS: i32 = 6;
/// Turns are by multiples of these, in degrees.
const TURNS: [f64; 11] = [90.0, 45.0, 30.0, 15.0, 10.0, 5.0, 1.0, 0.5, 0.1, 0.05, 0.01];
/// A turn of less than so many degrees goes if a later one can take it up.
const SMALL: f64 = 2.0;
/// Legs whose directions differ by less are parallel: a sine.
const PARALLEL: f64 = 1e-9;
/// A way of more legs has no numbers that anybody reads.
const MOST: usize = 32;

/// A way whose places are moved.
struct Tidy<'t, 'o> {
    scene: &'t Scene,
    places: Vec<Coords>,
    /// The clearance that each leg keeps.
    kept: Vec<f64>,
    outside: Option<&'t Outside<'o>>,
}

impl Legs<'_> {
    /// The way with numbers of few digits, and without places that it does not need. Each leg keeps most of its clearance, and at least
    /// a given one.
    pub(crate) fn tidy(self, clearance: f64, outside: Option<&Outside<'_>>) -> Self {
        if self.places.len() > MOST || self.scene.motions().is_some() {
            return self;
        }
        let mut tidy = Tidy {
            scene: self.scene,
            kept: (self.narrowest.iter())
                .map(|n| (KEPT * n.distance).max(clearance))
                .collect(),
            places: self.places,
            outside,
        };
        tidy.merge();
        tidy.round();
        Self::new(self.scene, tidy.places)
    }
}

impl Tidy<'_, '_> {
    /// Leaves out places that are not needed: where one leg does for two, and turns while it moves only if one of the two does.
    fn merge(&mut self) {
        let mut k = 1;
        while k + 1 < self.places.len() {
            let [a, b, c] = [k - 1, k, k + 1].map(|i| self.places[i]);
            let kept = self.kept[k - 1].min(self.kept[k]);
            let is_simple = !is_mixed(a, c) || is_mixed(a, b) || is_mixed(b, c);
            if is_simple && self.scene.is_clearly_apart(a, c, kept) {
                self.places.remove(k);
                self.kept[k - 1] = kept;
                self.kept.remove(k);
            } else {
                k += 1;
            }
        }
    }

    /// Rounds the numbers of all legs, one after the other.
    fn round(&mut self) {
        let aligned = alignments(self.scene);
        for leg in 0..self.kept.len() {
            let (from, to) = (self.places[leg], self.places[leg + 1]);
            if from[2] != to[2] {
                let found = turns(from[2], to[2], &aligned)
                    .into_iter()
                    .find_map(|by| self.shifted(leg, [0.0, 0.0, by]));
                if let Some(places) = found {
                    self.places = places;
                }
            }
            let (from, to) = (self.places[leg], self.places[leg + 1]);
            if from[2] == to[2] {
                let way = Vector::new(to[0] - from[0], to[1] - from[1]);
                let unit = way.unit();
                let found = lengths(way.length())
                    .find_map(|by| self.shifted(leg, [unit.x * by, unit.y * by, 0.0]));
                if let Some(places) = found {
                    self.places = places;
                }
            }
        }
    }

    /// The places with the end of a leg moved, and those after it up to a leg that takes up the difference; `None` if no leg does or
    /// one comes too near.
    fn shifted(&self, leg: usize, by: Coords) -> Option<Vec<Coords>> {
        let legs = self.kept.len();
        let takes_up = |&l: &usize| takes_up(self.places[l], self.places[l + 1], by);
        let until = match (leg + 1..legs).find(takes_up) {
            Some(until) => until,
            None if self.outside.is_some() => legs,
            None => return None,
        };
        let mut places = self.places.clone();
        for place in &mut places[leg + 1..=until] {
            *place = core::array::from_fn(|k| place[k] + by[k]);
        }
        let is_out = match (self.outside, places.last()) {
            (Some(outside), Some(&last)) if until == legs => {
                is_out(outside, last, self.scene.size())
            }
            _ => true,
        };
        let is_free =
            |l: usize| (self.scene).is_clearly_apart(places[l], places[l + 1], self.kept[l]);
        (is_out && (leg..legs.min(until + 1)).all(is_free)).then_some(places)
    }
}

fn is_mixed(a: Coords, b: Coords) -> bool {
    a[2] != b[2] && a[..2] != b[..2]
}

/// Whether a leg stays one of its kind, in its direction, if its start is moved.
fn takes_up(from: Coords, to: Coords, by: Coords) -> bool {
    let way = Vector::new(to[0] - from[0], to[1] - from[1]);
    let turn = to[2] - from[2];
    if by[2] != 0.0 {
        return turn * (turn - by[2]) > 0.0;
    }
    let by = Vector::new(by[0], by[1]);
    let left = way - by;
    let is_parallel = way.cross(by).abs() <= PARALLEL * way.length() * by.length();
    way.dot(left) > 0.0 && (turn != 0.0 || is_parallel)
}

/// By how much more to turn so that there is no turn, where that is a small one, the parts are aligned or the turn is a round one, the
/// roundest first, radians.
fn turns(from: f64, to: f64, aligned: &[f64]) -> Vec<f64> {
    let mut near = aligned_near(aligned, to);
    near.iter_mut().for_each(|angle| *angle -= to);
    let turn = to - from;
    let round = TURNS.iter().map(|step| step.to_radians()).map(|step| {
        let turns = (turn / step).round();
        turns * step - turn
    });
    near.extend(round.filter(|by| by.abs() <= CHANGED * turn.abs()));
    near.retain(|by| *by != 0.0 && turn * (turn + by) > 0.0);
    if turn.abs() < SMALL.to_radians() {
        near.insert(0, -turn);
    }
    near
}

/// By how much longer to be so that a length has few digits, the fewest first: to the nearest and to the next longer.
fn lengths(length: f64) -> impl Iterator<Item = f64> {
    let first = length.log10().floor();
    let decades = if first.is_finite() { DIGITS } else { 0 };
    (0..decades)
        .map(move |k| 10f64.powf(first - f64::from(k)))
        .flat_map(|tens| [5.0 * tens, tens])
        .flat_map(move |step| [(length / step).round(), (length / step).ceil()].map(|n| n * step))
        .filter(move |&l| l > 0.0 && l != length && (l - length).abs() <= CHANGED * length)
        .map(move |l| l - length)
}
