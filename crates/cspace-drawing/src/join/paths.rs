//! Whole paths that are drawn twice.

use cspace::Point;

use super::pieces::{Pieces, Shape, end};

/// A path of lines and arcs: its pieces, each from its start with its bulge.
struct Whole {
    first: usize,
    starts: Vec<Point>,
    bulges: Vec<f64>,
    /// End of an open path.
    end: Option<Point>,
    middle: Point,
    /// Mean distance of the ends from the middle: concentric rings have the same middle.
    radius: f64,
}

/// Removes paths of several pieces that coincide with another path, in either direction; returns the number of pieces.
/// Pieces that two paths share otherwise, as parts side by side do, are kept.
pub(super) fn remove_repeated(pieces: &mut Pieces<'_>, round: f64) -> usize {
    let mut wholes = wholes(pieces);
    wholes.sort_by(|a, b| {
        let length = a.starts.len().cmp(&b.starts.len());
        length.then(a.middle.x.total_cmp(&b.middle.x))
    });
    let mut repeated: Vec<(usize, usize)> = Vec::new();
    let near = |a: f64, b: f64| (a - b).abs() <= 2.0 * round;
    let alike =
        |a: &Whole, b: &Whole| a.starts.len() == b.starts.len() && near(a.middle.x, b.middle.x);
    for group in wholes.chunk_by_mut(|a, b| alike(a, b)) {
        group.sort_by(|a, b| {
            let radius = a.radius.total_cmp(&b.radius);
            radius.then(a.middle.y.total_cmp(&b.middle.y))
        });
        // Ends that are moved by rounding move the middle as much, and change their distances by twice that.
        for group in group.chunk_by_mut(|a, b| near(a.radius / 2.0, b.radius / 2.0)) {
            group.sort_by(|a, b| {
                let middle = a.middle.y.total_cmp(&b.middle.y);
                middle.then(a.first.cmp(&b.first))
            });
            for group in group.chunk_by(|a, b| near(a.middle.y, b.middle.y)) {
                let mut kept: Vec<&Whole> = Vec::new();
                for whole in group {
                    if kept.iter().any(|k| k.is_same(whole, round)) {
                        repeated.push((whole.first, whole.starts.len()));
                    } else {
                        kept.push(whole);
                    }
                }
            }
        }
    }
    let mut removed = 0;
    for (first, count) in repeated {
        let entity = pieces.segments[first].entity;
        let mut left = count;
        let mut i = first;
        while left > 0 && i < pieces.segments.len() && pieces.segments[i].entity == entity {
            if !pieces.segments[i].is_removed {
                pieces.remove(i);
                left -= 1;
                removed += 1;
            }
            i += 1;
        }
    }
    removed
}

/// The paths of two or more pieces.
fn wholes(pieces: &Pieces<'_>) -> Vec<Whole> {
    let mut wholes = Vec::new();
    let all: Vec<usize> = (0..pieces.segments.len())
        .filter(|&i| !pieces.segments[i].is_removed)
        .collect();
    for path in all.chunk_by(|&a, &b| pieces.segments[a].entity == pieces.segments[b].entity) {
        let bulges: Option<Vec<f64>> = (path.iter())
            .map(|&i| match pieces.segments[i].shape {
                Shape::Edge(bulge) => Some(bulge),
                Shape::Curve(_) => None,
            })
            .collect();
        let (Some(bulges), [first, .., last]) = (bulges, path) else {
            continue;
        };
        let starts: Vec<Point> = path.iter().map(|&i| pieces.segments[i].ends[0]).collect();
        let is_closed = pieces.linked(end(*last, 1)) == Some(end(*first, 0));
        let end = (!is_closed).then_some(pieces.segments[*last].ends[1]);
        let all = starts.iter().chain(&end);
        let n = starts.len() + usize::from(!is_closed);
        let sum = (all.clone()).fold((0.0, 0.0), |s, p| (s.0 + p.x, s.1 + p.y));
        let middle = Point::new(sum.0 / n as f64, sum.1 / n as f64);
        wholes.push(Whole {
            first: *first,
            radius: all.map(|p| p.distance(middle)).sum::<f64>() / n as f64,
            middle,
            starts,
            bulges,
            end,
        });
    }
    wholes
}

impl Whole {
    /// Whether another path has equal pieces, in either direction, and from any vertex on if it is closed.
    fn is_same(&self, other: &Self, round: f64) -> bool {
        let n = self.starts.len();
        let near = |a: Point, b: Point| a.distance(b) <= 2.0 * round;
        let size = self.starts[0].distance(self.middle).max(round);
        let bends = |a: f64, b: f64| (a - b).abs() * size <= 2.0 * round;
        match (self.end, other.end) {
            (None, None) => (0..n)
                .filter(|&s| near(self.starts[0], other.starts[s]))
                .any(|s| {
                    let forward = (0..n).all(|i| {
                        let j = (s + i) % n;
                        near(self.starts[i], other.starts[j])
                            && bends(self.bulges[i], other.bulges[j])
                    });
                    let backward = (0..n).all(|i| {
                        let j = (s + n - i) % n;
                        let before = (j + n - 1) % n;
                        near(self.starts[i], other.starts[j])
                            && bends(self.bulges[i], -other.bulges[before])
                    });
                    forward || backward
                }),
            (Some(end), Some(other_end)) => {
                let forward = near(end, other_end)
                    && (0..n).all(|i| {
                        near(self.starts[i], other.starts[i])
                            && bends(self.bulges[i], other.bulges[i])
                    });
                let vertex = |i: usize| {
                    if i == 0 {
                        other_end
                    } else {
                        other.starts[n - i]
                    }
                };
                let backward = near(end, other.starts[0])
                    && (0..n).all(|i| {
                        near(self.starts[i], vertex(i))
                            && bends(self.bulges[i], -other.bulges[n - 1 - i])
                    });
                forward || backward
            }
            _ => false,
        }
    }
}
