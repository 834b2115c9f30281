//! Pieces put in order where rounding leaves slivers.

use core::f64::consts::TAU;

use crate::union_find::UnionFind;

use super::build::SHORT;
use super::condition::INDEPENDENT;
use super::names::{Key, Name};
use super::piece::{End, Pair, Piece};

/// Takes out pieces too short to have a place, and makes their two ends one.
///
/// They are what rounding leaves between a turning and a node that is exactly there: a follower's joint where its arc
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
        // The first of a set stands for it: nodes come before turnings.
        if let Some(place) = places[sets.find(k as u32) as usize] {
            end.turns += ((end.base - place.base) / TAU).round() as i32;
            (end.key, end.x, end.base) = (place.key, place.x, place.base);
        }
    }
}

/// Gives all ends that rounding alone keeps from the x of a vertical piece that x, so that they agree on what is left of
/// it.
pub(super) fn snap(pairs: &[Pair], pieces: &mut [Piece]) {
    let mut xs: Vec<f64> = pieces
        .iter()
        .filter(|p| p.vertical)
        .flat_map(|p| [p.start.x, p.end.x])
        .collect();
    xs.sort_by(f64::total_cmp);
    // One value for each cluster.
    let mut clusters: Vec<(f64, f64)> = Vec::new();
    for x in xs {
        match clusters.last_mut() {
            Some(last) if x - last.1 < INDEPENDENT => last.1 = x,
            _ => clusters.push((x, x)),
        }
    }
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
