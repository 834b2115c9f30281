//! Branch and bound over pairs of discs and over time.

use cspace::{FeatureKind, FeatureName, Point};

use super::apart::Apart;
use super::meet::meet;
use super::near::Near;
use super::normals::normals;
use super::pieces::{discs, pieces};
use super::pose::{Placed, Pose};
use super::tree::{Holds, Node, Tree};

/// A least distance is right to this share of it; after so many pairs of discs and pieces to a share that is larger by this factor, up
/// to the coarsest. Where arcs turn about arcs at little distance the first would take minutes.
pub(super) const RELATIVE: f64 = 1e-6;
const EFFORT: u32 = 100_000;
const COARSER: f64 = 10.0;
const COARSEST: f64 = 0.1;
/// Distances are rounded by this share of the parts' size.
const ROUNDING: f64 = 1e-15;
/// Boundaries nearer than so many roundings touch.
const LEAST: f64 = 64.0;
/// Intervals of time are halved down to this share of a leg.
const NARROWEST: f64 = 1e-12;

/// Where the boundaries are nearest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Their distance, in the model's unit of length.
    pub distance: f64,
    /// When, as a share of the leg.
    pub time: f64,
    /// The features of the fixed and of the moving part that are nearest; none where there are none.
    pub features: Option<(FeatureName, FeatureName)>,
}

/// A search along one leg.
pub(super) struct Search<'a> {
    fixed: &'a Tree,
    moving: &'a Tree,
    poses: (Pose, Pose),
    rounding: f64,
}

/// An interval of time with the poses in its middle.
struct Over {
    middle: f64,
    half: f64,
    fixed: Placed,
    moving: Placed,
}

/// Best distance found, and the limit below which a search goes on.
struct Best {
    found: Nearest,
    /// Distances that are not less are passed over.
    limit: f64,
    /// Whether anything less than the limit ends the search.
    decides: bool,
    ended: bool,
    /// After so many pairs of discs and pieces a search that decides ends as one that has found something, and another goes on with
    /// less precision.
    effort: u32,
    /// Relative accuracy of the distance that is found.
    relative: f64,
    /// Features that are passed over.
    passed: Option<(FeatureName, FeatureName)>,
}

impl<'a> Search<'a> {
    pub(super) fn new(fixed: &'a Tree, moving: &'a Tree, poses: (Pose, Pose), size: f64) -> Self {
        Self {
            fixed,
            moving,
            poses,
            rounding: ROUNDING * size,
        }
    }

    fn over(&self, lo: f64, hi: f64) -> Over {
        let middle = 0.5 * (lo + hi);
        Over {
            middle,
            half: 0.5 * (hi - lo),
            fixed: self.poses.0.at(middle),
            moving: self.poses.1.at(middle),
        }
    }

    fn node(&self, pair: (u32, u32)) -> (&'a Node, &'a Node) {
        (
            &self.fixed.nodes[pair.0 as usize],
            &self.moving.nodes[pair.1 as usize],
        )
    }

    fn bound(&self, over: &Over, pair: (u32, u32)) -> f64 {
        let (a, b) = self.node(pair);
        discs(
            (&over.fixed, a.middle, a.reach),
            (&over.moving, b.middle, b.reach),
            over.half,
        )
    }

    /// Goes through all layers that meet.
    fn visit_all(&self, (lo, hi): (f64, f64), best: &mut Best) {
        let over = self.over(lo, hi);
        for roots in self.fixed.roots(self.moving) {
            self.visit(&over, roots, best);
        }
    }

    /// The distance at one time.
    pub(super) fn at(&self, time: f64) -> Nearest {
        self.at_but(time, None)
    }

    /// The distance at one time if it is less than a limit; else infinite.
    pub(super) fn at_below(&self, time: f64, limit: f64) -> Nearest {
        let mut best = Best {
            relative: 0.0,
            ..Best::least(limit)
        };
        self.visit_all((time, time), &mut best);
        best.found
    }

    /// The distance at one time, but for two features that are passed over.
    pub(super) fn at_but(&self, time: f64, passed: Option<(FeatureName, FeatureName)>) -> Nearest {
        let mut best = Best {
            passed,
            relative: 0.0,
            ..Best::least(f64::INFINITY)
        };
        self.visit_all((time, time), &mut best);
        best.found
    }

    /// The least distance for times from 0 to 1, right to a share of it.
    pub(super) fn least(&self, relative: f64) -> Nearest {
        let first = [0.0, 1.0, 0.5]
            .into_iter()
            .map(|t| self.at(t))
            .min_by(|a, b| a.distance.total_cmp(&b.distance));
        let mut best = Best {
            relative,
            effort: EFFORT,
            ..Best::least(f64::INFINITY)
        };
        if let Some(first) = first {
            best.take(first, self.rounding);
        }
        self.visit_all((0.0, 1.0), &mut best);
        best.found
    }

    /// The least distance for times from 0 to 1 if it is less than a limit by more than it is known to; else infinite. So a distance
    /// that stays the same from leg to leg is not told apart from itself.
    pub(super) fn least_below(&self, limit: f64) -> Nearest {
        let mut best = Best {
            effort: EFFORT,
            ..Best::least(limit * (1.0 - RELATIVE))
        };
        self.visit_all((0.0, 1.0), &mut best);
        best.found
    }

    /// The features that are nearest at the start, of the fixed and of the moving part, and their nearest points in the frame of the
    /// assembly; of boundaries that cross those that are nearest to a touch.
    pub(super) fn nearest(&self) -> Option<((FeatureName, FeatureName), (Point, Point))> {
        /// More than rounding.
        const SLACK: f64 = 1e-6;
        let distance = self.at(0.0).distance;
        let limit = distance * (1.0 + SLACK) + LEAST * self.rounding;
        // An end of an arc that goes on smoothly is a vertex, too: where a line or arc is as near, it is told.
        let vertices = |(a, b): (FeatureName, FeatureName)| {
            [a, b]
                .map(|f| usize::from(f.kind == FeatureKind::Vertex))
                .iter()
                .sum::<usize>()
        };
        let mut nearest: Option<((FeatureName, FeatureName), (Point, Point))> = None;
        self.normals_within(limit, |features, (p, q)| {
            let is_better = nearest.is_none_or(|(others, (a, b))| {
                let nearer = a.distance(b) - p.distance(q);
                nearer > self.rounding
                    || nearer > -self.rounding && vertices(features) < vertices(others)
            });
            if is_better {
                nearest = Some((features, (p, q)));
            }
        });
        nearest
    }

    /// Whether the distance is more than a limit for times from 0 to 1, as far as that is found by looking at so many pairs of discs and
    /// pieces.
    pub(super) fn is_apart(&self, limit: f64, effort: u32) -> bool {
        let mut best = Best {
            decides: true,
            effort,
            ..Best::least(limit.max(LEAST * self.rounding))
        };
        self.visit_all((0.0, 1.0), &mut best);
        !best.ended
    }

    /// Goes through what may be nearer than the best.
    fn visit(&self, over: &Over, pair: (u32, u32), best: &mut Best) {
        best.spend();
        if best.ended || self.bound(over, pair) >= best.limit {
            return;
        }
        let (a, b) = self.node(pair);
        let moved = {
            let (p, q) = (over.fixed.point(a.middle), over.moving.point(b.middle));
            ((q.velocity - p.velocity).length() + (p.bend + q.bend) * over.half) * over.half
        };
        match (a.holds, b.holds) {
            (Holds::Piece(i), Holds::Piece(j)) => self.look(over, (i, j), best),
            _ if moved > a.reach + b.reach && over.half > NARROWEST => {
                for part in self.halves(over) {
                    self.visit(&part, pair, best);
                }
            }
            (Holds::Nodes(c, d), _) if a.reach >= b.reach || matches!(b.holds, Holds::Piece(_)) => {
                self.both(over, [(c, pair.1), (d, pair.1)], best);
            }
            (_, Holds::Nodes(c, d)) => {
                self.both(over, [(pair.0, c), (pair.0, d)], best);
            }
            // The one that is left: a piece against nodes that are smaller.
            (Holds::Nodes(c, d), Holds::Piece(_)) => {
                self.both(over, [(c, pair.1), (d, pair.1)], best);
            }
        }
    }

    /// The nearer pair first.
    fn both(&self, over: &Over, pairs: [(u32, u32); 2], best: &mut Best) {
        let [first, second] = pairs;
        let (p, q) = (self.bound(over, first), self.bound(over, second));
        let order = if p <= q { pairs } else { [second, first] };
        for pair in order {
            self.visit(over, pair, best);
        }
    }

    fn halves(&self, over: &Over) -> [Over; 2] {
        let (lo, hi) = (over.middle - over.half, over.middle + over.half);
        [self.over(lo, over.middle), self.over(over.middle, hi)]
    }

    /// Two pieces over an interval, which is halved until it is known whether they are nearer than the best.
    fn look(&self, over: &Over, pair: (u32, u32), best: &mut Best) {
        let (a, b) = (
            &self.fixed.pieces[pair.0 as usize],
            &self.moving.pieces[pair.1 as usize],
        );
        if best.passed == Some((a.name, b.name)) {
            return;
        }
        best.spend();
        let Apart { least, here } =
            pieces((&over.fixed, &a.shape), (&over.moving, &b.shape), over.half);
        if here < best.limit {
            let found = Nearest {
                distance: here,
                time: over.middle,
                features: Some((a.name, b.name)),
            };
            best.take(found, self.rounding);
        }
        if best.ended || least >= best.limit {
            return;
        }
        if over.half <= NARROWEST {
            // What is not known here is as good as found.
            if best.decides && over.half > 0.0 {
                best.ended = true;
            }
            return;
        }
        for part in self.halves(over) {
            self.look(&part, pair, best);
        }
    }

    /// Whether the boundaries cross at the start.
    pub(super) fn crosses(&self) -> bool {
        let over = self.over(0.0, 0.0);
        let mut stack: Vec<(u32, u32)> = self.fixed.roots(self.moving).collect();
        while let Some(pair) = stack.pop() {
            if self.bound(&over, pair) > 0.0 {
                continue;
            }
            let (a, b) = self.node(pair);
            match (a.holds, b.holds) {
                (Holds::Piece(i), Holds::Piece(j)) => {
                    let a = &self.fixed.pieces[i as usize];
                    let b = &self.moving.pieces[j as usize];
                    if meet((&over.fixed, &a.shape), (&over.moving, &b.shape)) {
                        return true;
                    }
                }
                (Holds::Nodes(c, d), _) => stack.extend([(c, pair.1), (d, pair.1)]),
                (_, Holds::Nodes(c, d)) => stack.extend([(pair.0, c), (pair.0, d)]),
            }
        }
        false
    }

    /// Calls `with` for every two pieces nearer than a distance at the start.
    pub(super) fn within(&self, distance: f64, mut with: impl FnMut(Near)) {
        let over = self.over(0.0, 0.0);
        self.normals_within(distance, |features, (p, q)| {
            let way = q - p;
            let length = way.length();
            if length == 0.0 {
                return;
            }
            with(Near {
                distance: length,
                gradient: [0.0; 3],
                features,
                points: (over.fixed.back(p), over.moving.back(q)),
                direction: way * (1.0 / length),
            });
        });
    }

    /// Calls `with` for every common normal of two pieces that is shorter than a distance at the start: with the features, and
    /// its ends in the frame of the assembly.
    fn normals_within(
        &self,
        distance: f64,
        mut with: impl FnMut((FeatureName, FeatureName), (Point, Point)),
    ) {
        let over = self.over(0.0, 0.0);
        let mut stack: Vec<(u32, u32)> = self.fixed.roots(self.moving).collect();
        while let Some(pair) = stack.pop() {
            if self.bound(&over, pair) >= distance {
                continue;
            }
            let (a, b) = self.node(pair);
            match (a.holds, b.holds) {
                (Holds::Piece(i), Holds::Piece(j)) => {
                    let a = &self.fixed.pieces[i as usize];
                    let b = &self.moving.pieces[j as usize];
                    for (p, q) in normals((&over.fixed, &a.shape), (&over.moving, &b.shape)) {
                        if p.distance(q) < distance {
                            with((a.name, b.name), (p, q));
                        }
                    }
                }
                (Holds::Nodes(c, d), _) => stack.extend([(c, pair.1), (d, pair.1)]),
                (_, Holds::Nodes(c, d)) => stack.extend([(pair.0, c), (pair.0, d)]),
            }
        }
    }
}

impl Best {
    fn least(limit: f64) -> Self {
        Self {
            found: Nearest {
                distance: f64::INFINITY,
                time: 0.0,
                features: None,
            },
            limit,
            decides: false,
            effort: u32::MAX,
            ended: false,
            relative: RELATIVE,
            passed: None,
        }
    }

    /// Counts a pair that is looked at.
    fn spend(&mut self) {
        if self.effort == u32::MAX {
            return;
        }
        self.effort = self.effort.saturating_sub(1);
        if self.effort > 0 {
            return;
        }
        if self.decides {
            self.ended = true;
        } else {
            self.effort = EFFORT;
            self.relative = (self.relative * COARSER).min(COARSEST);
            self.limit = self.limit.min(self.found.distance * (1.0 - self.relative));
        }
    }

    fn take(&mut self, found: Nearest, rounding: f64) {
        self.found = found;
        if self.decides {
            self.ended = true;
        } else {
            self.limit = (found.distance * (1.0 - self.relative)).min(found.distance - rounding);
        }
    }
}
