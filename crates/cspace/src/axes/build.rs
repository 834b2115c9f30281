//! All pieces of contact curves, not yet cut by each other.
//!
//! Of every orbit of features of the swept part one is looked at, over its full turn; what it touches in the k-th copy of
//! the window its k-th image touches in the window itself (`repeats`).

use crate::parallel::prelude::*;

use super::carriers::carriers;
use super::condition::Condition;
use super::names::{Key, Name, Spot};
use super::piece::{Pair, Piece};
use super::reach::{Apart, reaches};
use super::scene::Scene;
use super::tidy::{contract, snap};

/// A section shorter than this (in x, radians or length) is not tested: near a turning y moves with the square root of x, and
/// so does its rounding.
pub(super) const SHORT: f64 = 1e-13;

/// A place on a curve where a section may end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cut {
    /// Where it is on the curve of the feature that stands for its orbit.
    pub(super) x: f64,
    /// Where its node is in the window, and in which copy of it x is: rounding may put it beyond a turning.
    pub(super) at: f64,
    pub(super) copy: u32,
    pub(super) y: f64,
    pub(super) name: Name,
    pub(super) root: u8,
    /// Whether one of the features gives way to its neighbour here, so that the curve ends.
    pub(super) ends: bool,
    /// Which seam it is, and at the end of a turn the next one.
    pub(super) x_turn: i32,
}

impl Cut {
    /// Its key where it belongs to a pair, so many turns of x on.
    pub(super) fn key(&self, pair: u32, turn: i32) -> Key {
        Key {
            name: match self.name {
                Name::Turning(_, i) => Name::Turning(pair, i),
                Name::Same(_, i) => Name::Same(pair, i),
                other => other,
            },
            root: self.root,
            x_turn: turn + self.x_turn,
            y_turn: 0,
        }
    }
}

pub(super) fn build(scene: &Scene) -> (Vec<Pair>, Vec<Piece>) {
    let first = reaches(&scene.first.outline.features, scene, true);
    let second = reaches(&scene.second.outline.features, scene, false);
    let apart = Apart::new(scene);
    // One share for each feature of the first part that stands for its orbit, put together in order.
    let standing: Vec<u32> = (0..first.len() as u32)
        .filter(|&i| scene.repeats.feature(i).steps == 0)
        .collect();
    let shares: Vec<(Vec<Pair>, Vec<Piece>)> = standing
        .par_iter()
        .map(|&ia| {
            let mut builder = Builder {
                scene,
                pairs: Vec::new(),
                pieces: Vec::new(),
                spots: Vec::new(),
                breaks: Vec::new(),
                instances: Vec::new(),
            };
            for (ib, rb) in (0u32..).zip(&second) {
                if apart.may_meet(&first[ia as usize], rb) {
                    builder.add(ia, ib);
                }
            }
            (builder.pairs, builder.pieces)
        })
        .collect();
    let (mut pairs, mut pieces) = (Vec::new(), Vec::new());
    for (some_pairs, some_pieces) in shares {
        let shift = pairs.len() as u32;
        pairs.extend(some_pairs);
        pieces.extend(some_pieces.into_iter().map(|p| p.renumbered(|i| i + shift)));
    }
    contract(&pairs, &mut pieces);
    snap(&pairs, &mut pieces);
    (pairs, pieces)
}

pub(super) struct Builder<'a> {
    pub(super) scene: &'a Scene,
    pub(super) pairs: Vec<Pair>,
    pub(super) pieces: Vec<Piece>,
    pub(super) spots: Vec<Spot>,
    pub(super) breaks: Vec<f64>,
    /// Of the pair that is looked at, its images by copies of the window, and whether pieces came of them.
    instances: Vec<Option<(u32, bool)>>,
}

impl Builder<'_> {
    fn add(&mut self, ia: u32, ib: u32) {
        let scene = self.scene;
        let Some(carriers) = carriers(scene, ia, ib) else {
            return;
        };
        let turning = scene.motions.first.turns() || scene.motions.second.turns();
        if !turning && !scene.normals_meet(ia, ib) {
            return;
        }
        let rep = Pair {
            first: ia,
            second: ib,
            condition: Condition::new(carriers, scene.motions),
        };
        self.instances.clear();
        self.instances.resize(scene.repeats.fold as usize, None);
        let mut spots = core::mem::take(&mut self.spots);
        spots.clear();
        scene.spots(ia, ib, |s| spots.push(s));
        if rep.condition.is_vertical() {
            self.add_verticals(&rep, &spots);
        } else {
            self.add_graphs(&rep, &spots);
        }
        self.spots = spots;
    }

    /// The image of a pair that touches in the window where it touches in a copy of the window, and how many pieces there
    /// are before any are added to it.
    pub(super) fn instance(&mut self, rep: &Pair, copy: u32) -> (usize, u32) {
        let before = self.pieces.len();
        if let Some((known, _)) = self.instances[copy as usize] {
            return (before, known);
        }
        let first = self.scene.repeats.image(rep.first, copy);
        let condition = carriers(self.scene, first, rep.second)
            .map_or(rep.condition, |c| Condition::new(c, self.scene.motions));
        self.pairs.push(Pair {
            first,
            second: rep.second,
            condition,
        });
        let pair = self.pairs.len() as u32 - 1;
        self.instances[copy as usize] = Some((pair, false));
        (before, pair)
    }

    /// Drops the last image again if no piece came of it, now or before.
    pub(super) fn keep_instance(&mut self, before: usize, copy: u32) {
        let slot = &mut self.instances[copy as usize];
        let Some((pair, used)) = slot else {
            return;
        };
        *used |= self.pieces.len() > before;
        if !*used && *pair as usize + 1 == self.pairs.len() {
            self.pairs.pop();
            *slot = None;
        }
    }
}
