//! Continuation of the curves of a slice in the one above.

use cspace::{FeatureName, Slice};

/// The features that touch.
type Contact = (FeatureName, FeatureName);

/// Key that distinguishes curves: their features, and at first also those of the curves before and after them.
type Key = (Contact, Option<(Contact, Contact)>);

/// Pairs of curves, of the lower and of the upper slice, in order of the lower: each is in one pair at most.
///
/// Curves of the same features between neighbours of the same features are joined first, then any of the same features; where
/// there are several, those whose middles are nearest to each other.
pub(crate) fn join(lower: &Slice, upper: &Slice) -> Vec<(u32, u32)> {
    let mut partner = vec![None; lower.curves.len()];
    let mut taken = vec![false; upper.curves.len()];
    for with_neighbours in [true, false] {
        let left = (0u32..).zip(keys(lower, with_neighbours));
        let mut left: Vec<(Key, u32)> = left
            .filter(|&(i, _)| partner[i as usize].is_none())
            .map(|(i, k)| (k, i))
            .collect();
        let right = (0u32..).zip(keys(upper, with_neighbours));
        let mut right: Vec<(Key, u32)> = right
            .filter(|&(j, _)| !taken[j as usize])
            .map(|(j, k)| (k, j))
            .collect();
        left.sort_unstable();
        right.sort_unstable();
        let mut rest = right.as_slice();
        for group in left.chunk_by(|a, b| a.0 == b.0) {
            let key = group[0].0;
            rest = &rest[rest.partition_point(|r| r.0 < key)..];
            let (same, after) = rest.split_at(rest.partition_point(|r| r.0 == key));
            rest = after;
            for (i, j) in nearest(lower, upper, group, same) {
                partner[i as usize] = Some(j);
                taken[j as usize] = true;
            }
        }
    }
    (0u32..)
        .zip(partner)
        .filter_map(|(i, j)| Some((i, j?)))
        .collect()
}

fn keys(slice: &Slice, with_neighbours: bool) -> Vec<Key> {
    let contact = |i: u32| {
        let curve = &slice.curves[i as usize];
        (curve.fixed, curve.moving)
    };
    let mut keys: Vec<Key> = (0..slice.curves.len() as u32)
        .map(|i| (contact(i), None))
        .collect();
    if with_neighbours {
        for l in &slice.loops {
            let n = l.len();
            for (k, &i) in l.iter().enumerate() {
                let neighbours = (contact(l[(k + n - 1) % n]), contact(l[(k + 1) % n]));
                keys[i as usize].1 = Some(neighbours);
            }
        }
    }
    keys
}

/// Joins two groups of curves, the nearest first.
fn nearest(
    lower: &Slice,
    upper: &Slice,
    left: &[(Key, u32)],
    right: &[(Key, u32)],
) -> Vec<(u32, u32)> {
    if let ([(_, i)], [(_, j)]) = (left, right) {
        return vec![(*i, *j)];
    }
    let middle = |slice: &Slice, i: u32| slice.curves[i as usize].geometry.point(0.5);
    let mut ways: Vec<(f64, u32, u32)> = Vec::new();
    for &(_, i) in left {
        for &(_, j) in right {
            ways.push((middle(lower, i).distance(middle(upper, j)), i, j));
        }
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut joined: Vec<(u32, u32)> = Vec::new();
    for (_, i, j) in ways {
        if joined.iter().all(|&(a, b)| a != i && b != j) {
            joined.push((i, j));
        }
    }
    joined
}
