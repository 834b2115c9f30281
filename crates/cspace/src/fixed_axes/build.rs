//! All pieces of contact curves, not yet cut by each other.
//!
//! From every orbit of features of the swept part, one feature is examined over its full turn; its contacts in the k-th copy of the window
//! are those of its k-th image in the window itself (`repeats`).

use super::condition::Condition;
use super::motion::clusters;
use super::piece::{End, Key, Name, Node, Pair, Piece};
use super::reach::reaches;
use super::scene::Scene;
use super::tolerance::{INDEPENDENT, SHORT};
use crate::contact::Cycle;
use crate::feature::Feature;
use crate::feature::tolerance::SMALLEST_CIRCLE;
use crate::parallel::prelude::*;
use crate::part::MeetingLoops;
use crate::union_find::UnionFind;
use core::f64::consts::TAU;

/// A place on a curve where a section may end.
#[derive(Debug, Clone, Copy)]
pub(super) struct SectionEnd {
    /// Place on the curve of the representative of the feature's orbit.
    pub(super) x: f64,
    /// Place of its node in the window, and the copy of the window that contains x: rounding may put it beyond a turning.
    pub(super) at: f64,
    pub(super) copy: u32,
    pub(super) y: f64,
    pub(super) name: Name,
    pub(super) root: u8,
    /// Whether one of the features ends here, so that the curve ends.
    pub(super) ends: bool,
    /// Number of the seam, and at the end of a turn that of the next one.
    pub(super) x_turn: i32,
}

impl SectionEnd {
    /// An end at a node where one of the features ends, on a curve that exists at x.
    pub(super) fn at_node(node: &Node, x: f64, (at, copy): (f64, u32)) -> Self {
        Self {
            root: node.root,
            ends: true,
            ..Self::between(x, (at, copy), node.y, node.name)
        }
    }

    /// An end at which both features continue.
    pub(super) fn between(x: f64, (at, copy): (f64, u32), y: f64, name: Name) -> Self {
        Self {
            x,
            at,
            copy,
            y,
            name,
            root: 0,
            ends: false,
            x_turn: 0,
        }
    }

    /// Key of the end for a pair, `turn` turns of x further.
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
    let meeting = {
        let [first, second] = [&scene.first, &scene.second].map(|s| &s.outline.heights);
        MeetingLoops::of(first, second)
    };
    let loop_of = |f: &Feature| f.name.loop_index;
    let first = reaches(&scene.first.outline.features, scene, true);
    let second = reaches(&scene.second.outline.features, scene, false);
    // One share of the work for each representative of the features of the first part, put together in order.
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
                nodes: Vec::new(),
                breaks: Vec::new(),
                instances: Vec::new(),
            };
            for (ib, rb) in (0u32..).zip(&second) {
                let loops = [scene.first_feature(ia), scene.second_feature(ib)].map(loop_of);
                if meeting.hold(loops[0], loops[1])
                    && scene.motions.may_meet(&first[ia as usize], rb)
                {
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
    pub(super) nodes: Vec<Node>,
    pub(super) breaks: Vec<f64>,
    /// For the current pair, its images by copies of the window, and whether pieces resulted.
    instances: Vec<Option<(u32, bool)>>,
}

impl Builder<'_> {
    fn add(&mut self, ia: u32, ib: u32) {
        let scene = self.scene;
        let Some(rep) = pair(scene, ia, ib) else {
            return;
        };
        let turning = scene.motions.first.turns() || scene.motions.second.turns();
        if !turning && !scene.normals_meet(ia, ib) {
            return;
        }
        self.instances.clear();
        self.instances.resize(scene.repeats.fold as usize, None);
        let mut nodes = core::mem::take(&mut self.nodes);
        nodes.clear();
        scene.nodes(ia, ib, |s| nodes.push(s));
        if rep.condition.is_vertical() {
            self.add_verticals(&rep, &nodes);
        } else {
            self.add_graphs(&rep, &nodes);
        }
        self.nodes = nodes;
    }

    /// The image of a pair that touches in the window where the pair touches in a copy of the window, and the number of pieces before any
    /// are added to it.
    pub(super) fn instance(&mut self, rep: &Pair, copy: u32) -> (usize, u32) {
        let before = self.pieces.len();
        if let Some((known, _)) = self.instances[copy as usize] {
            return (before, known);
        }
        let first = self.scene.repeats.image(rep.first, copy);
        let image = pair(self.scene, first, rep.second);
        self.pairs.push(image.unwrap_or(Pair { first, ..*rep }));
        let pair = self.pairs.len() as u32 - 1;
        self.instances[copy as usize] = Some((pair, false));
        (before, pair)
    }

    /// Drops the last image again if it has no pieces, neither new nor old ones.
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

// Repair of slivers that rounding leaves.

/// Removes pieces too short to have a place, and unites their two ends.
///
/// Rounding leaves them between a turning and a node at the same place: for example where a follower's joint is at the place where its arc
/// touches a line at the largest distance from the pivot.
pub(super) fn contract(pairs: &[Pair], pieces: &mut Vec<Piece>) {
    let short = |p: &Piece| {
        !p.vertical
            && !pairs[p.pair as usize].condition.is_vertical()
            && (p.end.x - p.start.x).abs() < SHORT
            && p.start.key.name != Name::Limit
            && p.end.key.name != Name::Limit
    };
    let mut same: Vec<(End, End)> = pieces
        .iter()
        .filter(|p| short(p))
        .map(|p| (p.start, p.end))
        .collect();
    if same.is_empty() {
        return;
    }
    pieces.retain(|p| !short(p));
    let mut keys: Vec<Key> = same.iter().flat_map(|s| [s.0.key, s.1.key]).collect();
    keys.sort_unstable();
    keys.dedup();
    let index = |key: Key| keys.binary_search(&key).ok();
    let mut sets = UnionFind::new(keys.len());
    let mut places: Vec<Option<End>> = vec![None; keys.len()];
    for (a, b) in &same {
        if let (Some(i), Some(j)) = (index(a.key), index(b.key)) {
            sets.union(i as u32, j as u32);
            places[i] = Some(*a);
            places[j] = Some(*b);
        }
    }
    same.clear();
    for end in pieces.iter_mut().flat_map(|p| [&mut p.start, &mut p.end]) {
        let Some(k) = index(end.key) else { continue };
        // The first end of a set represents it: nodes come before turnings.
        if let Some(place) = places[sets.find(k as u32) as usize] {
            end.turns += ((end.base - place.base) / TAU).round() as i32;
            (end.key, end.x, end.base) = (place.key, place.x, place.base);
        }
    }
}

/// Moves all ends that differ from the x of a vertical piece only by rounding to that x, so that they agree on their order.
pub(super) fn snap(pairs: &[Pair], pieces: &mut [Piece]) {
    let verticals = pieces.iter().filter(|p| p.vertical);
    let xs = verticals.flat_map(|p| [p.start.x, p.end.x]).collect();
    // One value for each cluster.
    let clusters = clusters(xs, INDEPENDENT);
    if clusters.is_empty() {
        return;
    }
    for p in pieces {
        for end in [&mut p.start, &mut p.end] {
            let k = clusters.partition_point(|c| c.1 + INDEPENDENT < end.x);
            if let Some(c) = clusters.get(k).filter(|c| c.0 - INDEPENDENT < end.x) {
                end.x = c.0;
            }
        }
        if !p.vertical && p.start.x == p.end.x {
            p.stand_up(pairs);
        }
    }
}

/// The pair of two features with its condition, if they can touch: if the sum of their radii is that of a circle.
pub(super) fn pair(scene: &Scene, first: u32, second: u32) -> Option<Pair> {
    let a = Cycle::of(&scene.first.outline, scene.first_feature(first));
    let b = Cycle::of(&scene.second.outline, scene.second_feature(second));
    let total = a.total(&b);
    let touch = total > 0.0 && total >= SMALLEST_CIRCLE * (a.weight * b.weight).abs();
    touch.then(|| Pair {
        first,
        second,
        condition: Condition::new(a, b, scene.motions),
    })
}
