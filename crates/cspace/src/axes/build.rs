//! All pieces of contact curves, not yet cut by each other.

use core::f64::consts::TAU;

use rayon::prelude::*;

use crate::feature::Feature;
use crate::feature::tolerance::SMALLEST_CIRCLE;
use crate::geometry::{Point, Vector};

use super::condition::{Carriers, Condition, INDEPENDENT};
use super::domain::{ExtentKind, wrapped};
use super::nodes::{Key, Name, Scene, Spot};
use super::piece::{End, Pair, Piece};
use super::reach::{Apart, reaches};
use super::tidy::{contract, snap};

/// A section is tested by where its middle lies between the ends of its features. Nearer to one than this (length, or
/// radians) the test is not trusted: what lies on the other side of the node beside it tells.
const UNCLEAR: f64 = 1e-11;

/// Nor is it trusted for a section shorter than this (in x, radians or length): near a turning y moves with the square root of
/// x, and so does its rounding.
pub(super) const SHORT: f64 = 1e-13;

/// How far rounding may put a node beyond a turning (radians or length).
const BEYOND: f64 = 1e-9;

/// A place on a curve where a section may end.
#[derive(Debug, Clone, Copy)]
struct Cut {
    /// Where it is on the curve, and where its node is: rounding may put that beyond a turning.
    x: f64,
    node_x: f64,
    y: f64,
    name: Name,
    root: u8,
    /// Whether one of the features gives way to its neighbour here, so that the curve ends.
    ends: bool,
    /// Whether the node belongs to the turn in which the window ends.
    next_turn: bool,
}

/// A place at which y turns around.
#[derive(Debug, Clone, Copy)]
struct Around {
    x: f64,
    y: f64,
    index: u32,
}

pub(super) fn build(scene: &Scene) -> (Vec<Pair>, Vec<Piece>) {
    let first = reaches(&scene.first.outline.features, scene, true);
    let second = reaches(&scene.second.outline.features, scene, false);
    let apart = Apart::new(scene);
    // One share for each feature of the first part, put together in order.
    let shares: Vec<(Vec<Pair>, Vec<Piece>)> = first
        .par_iter()
        .enumerate()
        .map(|(ia, ra)| {
            let mut builder = Builder {
                scene,
                pairs: Vec::new(),
                pieces: Vec::new(),
                spots: Vec::new(),
                breaks: Vec::new(),
            };
            for (ib, rb) in (0u32..).zip(&second) {
                if apart.may_meet(ra, rb) {
                    builder.add(ia as u32, ib);
                }
            }
            (builder.pairs, builder.pieces)
        })
        .collect();
    let (mut pairs, mut pieces) = (Vec::new(), Vec::new());
    for (some_pairs, some_pieces) in shares {
        let shift = pairs.len() as u32;
        pairs.extend(some_pairs);
        pieces.extend(some_pieces.into_iter().map(|p| p.renumbered(shift)));
    }
    contract(&pairs, &mut pieces);
    snap(&pairs, &mut pieces);
    (pairs, pieces)
}

struct Builder<'a> {
    scene: &'a Scene,
    pairs: Vec<Pair>,
    pieces: Vec<Piece>,
    spots: Vec<Spot>,
    breaks: Vec<f64>,
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
        let condition = Condition::new(carriers, scene.motions);
        let pair = self.pairs.len() as u32;
        let mut spots = core::mem::take(&mut self.spots);
        spots.clear();
        scene.spots(ia, ib, |s| spots.push(s));
        self.pairs.push(Pair {
            first: ia,
            second: ib,
            condition,
        });
        let before = self.pieces.len();
        if condition.is_vertical() {
            self.add_verticals(pair, &spots);
        } else {
            self.add_graphs(pair, &spots);
        }
        if self.pieces.len() == before {
            self.pairs.pop();
        }
        self.spots = spots;
    }

    fn add_graphs(&mut self, pair: u32, spots: &[Spot]) {
        let condition = self.pairs[pair as usize].condition;
        let scene = self.scene;
        let (lo, hi) = self.first_turn();
        // Where roots come and go.
        let mut breaks = core::mem::take(&mut self.breaks);
        breaks.clear();
        condition.turnings(|x| {
            let x = scene.x.reduced(x);
            if lo < x && x < hi {
                breaks.push(x);
            }
        });
        breaks.sort_by(f64::total_cmp);
        let mut around: Option<Vec<Around>> = None;
        let ends = breaks.len() + 1;
        let interval = |k: usize| {
            let from = if k == 0 { lo } else { breaks[k - 1] };
            let to = if k + 1 == ends { hi } else { breaks[k] };
            (from, to)
        };
        let exists = |k: usize, root: u8| {
            let (from, to) = interval(k);
            condition.exists(0.5 * (from + to), root)
        };
        let mut marks: Vec<(f64, Option<&Spot>)> = Vec::new();
        for i in 0..ends {
            let (from, to) = interval(i);
            if from >= to {
                continue;
            }
            for root in [0, 1] {
                if !exists(i, root) {
                    continue;
                }
                let rises = |x: f64, y: f64| condition.gradient(x, y).1 > 0.0;
                // Nodes on this root; rounding may have put one just beyond a turning.
                let below = i > 0 && !exists(i - 1, root);
                let above = i + 1 < ends && !exists(i + 1, root);
                marks.clear();
                for s in spots {
                    let reach = (
                        if below { from - BEYOND } else { from },
                        if above { to + BEYOND } else { to },
                    );
                    if reach.0 <= s.x && s.x <= reach.1 && rises(s.x, s.y) == (root == 0) {
                        marks.push((s.x.clamp(from, to), Some(s)));
                    }
                }
                marks.sort_by(|(x, s), (y, t)| {
                    let name = |s: &Option<&Spot>| s.map(|s| (s.name, s.root));
                    x.total_cmp(y).then(name(s).cmp(&name(t)))
                });
                marks.insert(0, (from, None));
                marks.push((to, None));
                let margins = marks.windows(2).map(|m| {
                    if m[1].0 - m[0].0 < SHORT {
                        return 0.0;
                    }
                    let x = 0.5 * (m[0].0 + m[1].0);
                    self.margin(pair, x, condition.y(x, root))
                });
                let verdicts = decide(margins.collect(), |k| marks[k].1.is_some());
                if !verdicts.contains(&true) {
                    continue;
                }
                let around = around.get_or_insert_with(|| self.around(&condition));
                let cut = |k: usize| -> Cut {
                    if let (x, Some(s)) = marks[k] {
                        return Cut {
                            x,
                            node_x: s.x,
                            y: s.y,
                            name: s.name,
                            root: s.root,
                            ends: true,
                            next_turn: false,
                        };
                    }
                    let last = k > 0;
                    let breaking = if last {
                        (i + 1 < ends).then_some(i)
                    } else {
                        i.checked_sub(1)
                    };
                    self.open_end(pair, root, marks[k].0, breaking, last)
                };
                let kept: Vec<(Cut, Cut)> = (0..verdicts.len())
                    .filter(|&k| verdicts[k])
                    .map(|k| (cut(k), cut(k + 1)))
                    .collect();
                for (start, end) in kept {
                    let mut from = start;
                    for a in around.iter() {
                        let inside = start.x < a.x && a.x < end.x;
                        if inside && rises(a.x, a.y) == (root == 0) {
                            let to = Cut {
                                x: a.x,
                                node_x: a.x,
                                y: a.y,
                                name: Name::Same(pair, a.index),
                                root,
                                ends: false,
                                next_turn: false,
                            };
                            self.instances(pair, root, &from, &to);
                            from = to;
                        }
                    }
                    self.instances(pair, root, &from, &end);
                }
            }
        }
        self.breaks = breaks;
    }

    /// Where y turns around on the curves of a condition, by x.
    fn around(&self, condition: &Condition) -> Vec<Around> {
        let scene = self.scene;
        let mut around = Vec::new();
        let swapped = condition.swapped();
        if !swapped.is_vertical() {
            // The roots for x are double there: either gives it.
            swapped.turnings(|y| {
                let x = scene.x.reduced(swapped.y(y, 0));
                if x.is_finite() {
                    around.push(Around {
                        x,
                        y: scene.y.reduced(y),
                        index: 8 + around.len() as u32,
                    });
                }
            });
        }
        around.sort_by(|a, b| a.x.total_cmp(&b.x));
        around
    }

    /// An end of a root's interval at which no feature gives way: a turning, the cut of a circle, or the window's end.
    fn open_end(&self, pair: u32, root: u8, x: f64, breaking: Option<usize>, last: bool) -> Cut {
        let scene = self.scene;
        let condition = &self.pairs[pair as usize].condition;
        let circle = scene.x.repeats();
        let name = match breaking {
            Some(k) => Name::Turning(pair, k as u32),
            None if circle => Name::Same(pair, u32::from(root)),
            None => Name::Limit,
        };
        // At the cut of a circle both sides must have the very same y.
        let at = if circle && breaking.is_none() {
            scene.x.lo
        } else {
            x
        };
        let (y0, y1) = (condition.y(at, 0), condition.y(at, 1));
        let y = if breaking.is_some() && y0.is_finite() && y1.is_finite() {
            // A double root: what rounding leaves between the two is halved.
            y0 + 0.5 * scene.y.difference(y1, y0)
        } else {
            condition.y(at, root)
        };
        Cut {
            x,
            node_x: x,
            y: scene.y.reduced(y),
            name,
            root: 0,
            ends: false,
            next_turn: last && breaking.is_none(),
        }
    }

    /// Adds a section in every turn of both coordinates, cut to the limits.
    fn instances(&mut self, pair: u32, root: u8, from: &Cut, to: &Cut) {
        let (x, y) = (self.scene.x, self.scene.y);
        for turn in 0..x.turns() {
            let shift = TAU * f64::from(turn);
            let (x0, x1) = (from.x + shift, to.x + shift);
            let end = |cut: &Cut, raw: f64| -> End {
                let whole = if y.repeats() {
                    ((raw - cut.y) / TAU).round() as i32
                } else {
                    0
                };
                let next = cut.next_turn && !self.scene.x.is_circle();
                End {
                    key: Key {
                        name: cut.name,
                        root: cut.root,
                        x_turn: turn + i32::from(next),
                        y_turn: 0,
                    },
                    x: cut.node_x + shift,
                    base: cut.y,
                    turns: whole,
                }
            };
            let raw = |x: f64| self.pairs[pair as usize].condition.y(x, root);
            let piece = Piece {
                pair,
                root,
                vertical: false,
                turns: 0,
                start: end(from, raw(x0)),
                end: end(to, raw(x1)),
            };
            self.in_each_turn(piece);
        }
    }

    /// The piece in every turn of y, cut to the limits of both coordinates.
    fn in_each_turn(&mut self, piece: Piece) {
        let y = self.scene.y;
        let (lo, hi) = piece.y_range();
        let (first, last) = match y.kind {
            ExtentKind::Circle => {
                let k = -((lo - y.lo) / TAU).floor() as i32;
                (k, k)
            }
            ExtentKind::TurnLimits => (
                ((y.lo - hi) / TAU).ceil() as i32,
                ((y.hi - lo) / TAU).floor() as i32,
            ),
            _ => (0, 0),
        };
        for k in first..=last {
            let mut piece = piece;
            piece.turns += k;
            for end in [&mut piece.start, &mut piece.end] {
                end.turns += k;
                end.key.y_turn = if y.is_circle() { 0 } else { end.turns };
            }
            if let Some(piece) = self.limited(piece) {
                self.pieces.push(piece);
            }
        }
    }

    /// The piece cut to the limits of x and y.
    fn limited(&self, mut piece: Piece) -> Option<Piece> {
        let (x, y) = (self.scene.x, self.scene.y);
        let limit = |x: f64, base: f64| End {
            key: Key {
                name: Name::Limit,
                root: 0,
                x_turn: 0,
                y_turn: 0,
            },
            x,
            base,
            turns: 0,
        };
        let limited_x = matches!(x.kind, ExtentKind::TurnLimits | ExtentKind::SlideLimits);
        if limited_x {
            let (x0, x1) = piece.x_range();
            if x1 <= x.lo || x0 >= x.hi {
                return None;
            }
            if !piece.vertical {
                let (from, to) = (piece.y(&self.pairs, x.lo), piece.y(&self.pairs, x.hi));
                if x0 < x.lo {
                    piece.start = limit(x.lo, from);
                }
                if x1 > x.hi {
                    piece.end = limit(x.hi, to);
                }
            }
        }
        if matches!(y.kind, ExtentKind::TurnLimits | ExtentKind::SlideLimits) {
            let (lo, hi) = piece.y_range();
            if hi <= y.lo || lo >= y.hi {
                return None;
            }
            for (at, outside) in [(y.lo, lo < y.lo), (y.hi, hi > y.hi)] {
                if outside {
                    let x = if piece.vertical {
                        piece.start.x
                    } else {
                        crossing_of_level(&piece, &self.pairs, at)
                    };
                    let end = limit(x, at);
                    let start_outside = (piece.start.y() < at) == (at == y.lo);
                    if start_outside {
                        piece.start = end;
                    } else {
                        piece.end = end;
                    }
                }
            }
        }
        Some(piece)
    }

    fn add_verticals(&mut self, pair: u32, spots: &[Spot]) {
        let scene = self.scene;
        let swapped = self.pairs[pair as usize].condition.swapped();
        if swapped.is_vertical() {
            return;
        }
        for root in [0u8, 1] {
            if !swapped.exists(0.0, root) {
                continue;
            }
            let x = scene.x.reduced(swapped.y(0.0, root));
            if !(scene.x.lo..=scene.x.hi).contains(&x) && !scene.x.repeats() {
                continue;
            }
            let mut cuts: Vec<Cut> = spots
                .iter()
                .filter(|s| {
                    let rises = swapped.gradient(s.y, s.x).1 > 0.0;
                    rises == (root == 0)
                })
                .map(|s| Cut {
                    x,
                    node_x: x,
                    y: s.y,
                    name: s.name,
                    root: s.root,
                    ends: true,
                    next_turn: false,
                })
                .collect();
            cuts.sort_by(|a, b| a.y.total_cmp(&b.y).then(a.name.cmp(&b.name)));
            let repeats = scene.y.repeats();
            let (lo, hi) = if repeats {
                (scene.y.lo, scene.y.lo + TAU)
            } else {
                (scene.y.lo, scene.y.hi)
            };
            let end = |y: f64| Cut {
                x,
                node_x: x,
                y,
                name: if repeats {
                    Name::Same(pair, 2 + u32::from(root))
                } else {
                    Name::Limit
                },
                root: 0,
                ends: false,
                next_turn: false,
            };
            cuts.insert(0, end(lo));
            cuts.push(end(hi));
            let n = cuts.len() - 1;
            let margins = (0..n)
                .map(|i| self.margin(pair, x, 0.5 * (cuts[i].y + cuts[i + 1].y)))
                .collect();
            let verdicts = decide(margins, |i| cuts[i].ends);
            for i in 0..n {
                if !verdicts[i] {
                    continue;
                }
                for turn in 0..scene.x.turns() {
                    let at = x + TAU * f64::from(turn);
                    let end = |cut: &Cut| {
                        let closing = repeats && cut.y == hi && !cut.ends;
                        End {
                            key: Key {
                                name: cut.name,
                                root: cut.root,
                                x_turn: turn,
                                y_turn: 0,
                            },
                            x: at,
                            base: if closing { lo } else { cut.y },
                            turns: i32::from(closing),
                        }
                    };
                    let piece = Piece {
                        pair,
                        root,
                        vertical: true,
                        turns: 0,
                        start: end(&cuts[i]),
                        end: end(&cuts[i + 1]),
                    };
                    self.in_each_turn(piece);
                }
            }
        }
    }

    /// How far inside both features' extents the contact at (x, y) is: negative outside.
    fn margin(&self, pair: u32, x: f64, y: f64) -> f64 {
        let scene = self.scene;
        let pair = &self.pairs[pair as usize];
        let (a, b) = (
            scene.first_feature(pair.first),
            scene.second_feature(pair.second),
        );
        let motions = scene.motions;
        let theta = motions.theta(x, y);
        let turning = motions.first.turns() || motions.second.turns();
        let inside = |f: &Feature, angle: f64| {
            0.5 * (f.hi - f.lo) - wrapped(angle - 0.5 * (f.lo + f.hi)).abs()
        };
        let on = |(start, along, length): (Point, Vector, f64), p: Point| {
            let at = along.dot(p - start);
            at.min(length - at)
        };
        let half_turn = core::f64::consts::PI;
        match pair.condition.carriers {
            Carriers::FirstLine { point, .. } => {
                let (start, along, length) = scene.first.segment(a);
                let (start, along) = (
                    motions.first.point(x, start),
                    motions.first.vector(x, along),
                );
                let foot = on((start, along, length), motions.second.point(y, point));
                if turning {
                    foot.min(inside(b, a.lo + half_turn - theta))
                } else {
                    foot
                }
            }
            Carriers::SecondLine { point, .. } => {
                let (start, along, length) = scene.second.segment(b);
                let (start, along) = (
                    motions.second.point(y, start),
                    motions.second.vector(y, along),
                );
                let foot = on((start, along, length), motions.first.point(x, point));
                if turning {
                    foot.min(inside(a, b.lo + half_turn + theta))
                } else {
                    foot
                }
            }
            Carriers::Circles {
                first,
                second,
                radius,
            } => {
                let n = (motions.second.point(y, second) - motions.first.point(x, first))
                    * radius.signum();
                let angle = n.angle();
                inside(a, angle - motions.first.angle(x))
                    .min(inside(b, angle + half_turn - motions.second.angle(y)))
            }
        }
    }

    /// The first turn of x, or all of it.
    fn first_turn(&self) -> (f64, f64) {
        let x = self.scene.x;
        if x.repeats() {
            (x.lo, x.lo + TAU)
        } else {
            (x.lo, x.hi)
        }
    }
}

/// Which sections are contact: by their margins, and where those are unclear by the section beside.
fn decide(margins: Vec<f64>, ends: impl Fn(usize) -> bool) -> Vec<bool> {
    let n = margins.len();
    let mut verdicts: Vec<Option<bool>> = margins
        .iter()
        .map(|&m| (m.abs() > UNCLEAR).then_some(m > 0.0))
        .collect();
    for i in 1..n {
        if verdicts[i].is_none() {
            verdicts[i] = verdicts[i - 1].map(|before| before != ends(i));
        }
    }
    for i in (0..n.saturating_sub(1)).rev() {
        if verdicts[i].is_none() {
            verdicts[i] = verdicts[i + 1].map(|after| after != ends(i + 1));
        }
    }
    // A curve without nodes that runs along a joint of both parts for good (discs that slide along their line of centres)
    // belongs to the features on either side of it; one is enough, more do no harm.
    verdicts
        .iter()
        .zip(&margins)
        .map(|(v, m)| v.unwrap_or(n == 1 && *m > -INDEPENDENT))
        .collect()
}

/// The x at which a monotone piece has a given y.
pub(super) fn crossing_of_level(piece: &Piece, pairs: &[Pair], level: f64) -> f64 {
    let (mut lo, mut hi) = piece.x_range();
    let rising = piece.start.y() < piece.end.y();
    loop {
        let middle = 0.5 * (lo + hi);
        if middle <= lo || middle >= hi {
            return middle;
        }
        if (piece.y(pairs, middle) < level) == rising {
            lo = middle;
        } else {
            hi = middle;
        }
    }
}

/// The condition of a pair of features, if they can touch.
pub(super) fn carriers(scene: &Scene, ia: u32, ib: u32) -> Option<Carriers> {
    let (a, b) = (scene.first_feature(ia), scene.second_feature(ib));
    match (a.is_line(), b.is_line()) {
        (true, false) if b.radius() >= 0.0 => {
            let joint = scene.first.outline.start(a);
            Some(Carriers::FirstLine {
                normal: joint.normal,
                through: joint.point,
                point: b.center(),
                radius: b.radius(),
            })
        }
        (false, true) if a.radius() >= 0.0 => {
            let joint = scene.second.outline.start(b);
            Some(Carriers::SecondLine {
                normal: joint.normal,
                through: joint.point,
                point: a.center(),
                radius: a.radius(),
            })
        }
        (false, false) => {
            let radius = a.radius() + b.radius();
            let convex = a.radius() >= 0.0 && b.radius() >= 0.0;
            let concave = a.radius() < 0.0 && b.radius() < 0.0;
            let touch = !concave
                && if convex {
                    radius >= SMALLEST_CIRCLE
                } else {
                    radius <= -SMALLEST_CIRCLE
                };
            touch.then_some(Carriers::Circles {
                first: a.center(),
                second: b.center(),
                radius,
            })
        }
        _ => None,
    }
}
