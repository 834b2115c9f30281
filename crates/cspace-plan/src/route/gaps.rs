//! Ways in the plane of a pair with fixed axes: from gap to gap.

use core::cmp::Reverse;
use core::f64::consts::TAU;
use std::collections::BinaryHeap;

use cspace::fixed_axes::FreeGap;
use cspace::{AxisMotion, FixedAxesSpace};

use crate::legs::{Coords, Scene};

use super::piece::{Lifted, Piece, Straight};

/// Free space as gaps between contact curves: over an interval of one coordinate, x here, each is an interval of the other, y.
#[derive(Debug)]
pub(crate) struct Gaps<'a> {
    gaps: Vec<FreeGap<'a>>,
    /// The gaps of each interval of x, with the interval.
    bands: Vec<(core::ops::Range<usize>, (f64, f64))>,
    /// Which of u and v is x.
    x: usize,
    /// Whether x and y come back after a turn.
    circles: (bool, bool),
    extent: [(f64, f64); 2],
    levers: Coords,
    size: f64,
}

/// Bands between which critical values are told apart no more are this near, as a share of the parts' size.
const CRACK: f64 = 1e-8;

/// A way through a gap.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Through<'a> {
    gap: FreeGap<'a>,
    x: usize,
    /// Fractions of the interval of x, and shares of that of y, at the entry and at the exit.
    fractions: (f64, f64),
    shares: (f64, f64),
    /// Whole turns that are added to both coordinates.
    shift: [f64; 2],
}

impl Piece for Through<'_> {
    fn at(&self, s: f64) -> Lifted {
        let at = self.place(s);
        Lifted { low: at, high: at }
    }
}

impl Through<'_> {
    fn place(&self, s: f64) -> Coords {
        let fraction = self.fractions.0 + (self.fractions.1 - self.fractions.0) * s;
        let (a, b) = self.shares;
        // By the middle of the gap.
        let share = if s <= 0.5 {
            a + (0.5 - a) * 2.0 * s
        } else {
            0.5 + (b - 0.5) * (2.0 * s - 1.0)
        };
        let [p, q] = self.gap.ends(fraction);
        let (p, q) = ([p.0, p.1], [q.0, q.1]);
        let mut at = [0.0; 3];
        for k in 0..2 {
            at[k] = p[k] + self.shift[k];
        }
        let y = 1 - self.x;
        at[y] += (q[y] - p[y]) * share;
        at
    }
}

/// A gap that is reached, with turns of x and y, where it is entered, and from which it was come to.
#[derive(Debug, Clone, Copy)]
struct Reached {
    length: f64,
    turns: (i32, i32),
    entry: (f64, f64),
    /// The gap before, and where it was left: fraction and share.
    before: Option<(usize, (f64, f64))>,
    done: bool,
}

impl<'a> Gaps<'a> {
    pub(crate) fn new(space: &'a FixedAxesSpace, scene: &Scene) -> Self {
        let gaps: Vec<FreeGap<'a>> = space.free_gaps().collect();
        let pair = |c: (f64, f64)| [c.0, c.1];
        // Both ends of a gap have the same x.
        let x = usize::from(gaps.first().is_some_and(|g| {
            let [p, q] = g.ends(0.5).map(pair);
            p[0] != q[0]
        }));
        let ends = |g: &FreeGap<'a>| (pair(g.ends(0.0)[0])[x], pair(g.ends(1.0)[0])[x]);
        let mut bands: Vec<(core::ops::Range<usize>, (f64, f64))> = Vec::new();
        for (i, gap) in gaps.iter().enumerate() {
            let over = ends(gap);
            match bands.last_mut() {
                Some((range, known)) if *known == over => range.end = i + 1,
                _ => bands.push((i..i + 1, over)),
            }
        }
        let (a, b) = space.axes();
        let circle = |axis: cspace::Axis| {
            matches!(axis.motion, AxisMotion::Revolute { .. }) && axis.range.is_none()
        };
        let circles = [circle(a), circle(b)];
        Self {
            gaps,
            bands,
            x,
            circles: (circles[x], circles[1 - x]),
            extent: space.extent(),
            levers: scene.levers(),
            size: scene.size(),
        }
    }

    /// Where a configuration is: gap, turns of x and y, fraction and share.
    ///
    /// Critical values of x that are told apart no more leave a crack between two bands. What is in a crack is located in the bands
    /// on both sides of it, at their ends.
    #[allow(clippy::type_complexity)]
    fn locate(&self, at: Coords) -> Option<(usize, (i32, i32), (f64, f64))> {
        let (lo, _) = self.bands.first()?.1;
        let (x, turns) = brought(at[self.x], (lo, lo), self.circles.0)?;
        let y = at[1 - self.x];
        // The first band that does not end before x; behind the last one of a circle comes the first again.
        let next = self.bands.partition_point(|b| b.1.1 < x);
        let (after, from) = match self.bands.get(next) {
            Some(&(_, (lo, _))) => (self.locate_in(next, (x, turns), y), lo),
            None if self.circles.0 => (self.locate_in(0, (x - TAU, turns + 1), y), x),
            None => (None, x),
        };
        after.or_else(|| {
            let before = next.checked_sub(1).filter(|_| x <= from)?;
            self.locate_in(before, (x, turns), y)
        })
    }

    /// Where a configuration is in a band; x beside it counts as its nearer end.
    #[allow(clippy::type_complexity)]
    fn locate_in(
        &self,
        band: usize,
        (x, x_turns): (f64, i32),
        y: f64,
    ) -> Option<(usize, (i32, i32), (f64, f64))> {
        let (range, (lo, hi)) = &self.bands[band];
        let fraction = if hi > lo {
            ((x - lo) / (hi - lo)).clamp(0.0, 1.0)
        } else {
            0.5
        };
        range.clone().find_map(|gap| {
            let (p, q) = self.interval(gap, fraction);
            let (y, y_turns) = brought(y, (p, q), self.circles.1)?;
            let share = if q > p { (y - p) / (q - p) } else { 0.5 };
            (p..=q)
                .contains(&y)
                .then_some((gap, (x_turns, y_turns), (fraction, share)))
        })
    }

    /// y at the two ends of a gap.
    fn interval(&self, gap: usize, fraction: f64) -> (f64, f64) {
        let [p, q] = self.gaps[gap].ends(fraction).map(|c| [c.0, c.1]);
        (p[1 - self.x], q[1 - self.x])
    }

    /// A way from one free configuration to another of the same region, whose end differs from `to` by whole turns.
    pub(crate) fn way(&self, from: Coords, to: Coords) -> Option<Vec<Box<dyn Piece + 'a>>> {
        // What is beyond the extent is free all the way there.
        let inside = |c: Coords| -> Coords {
            core::array::from_fn(|k| {
                let open = k < 2
                    && !if k == self.x {
                        self.circles.0
                    } else {
                        self.circles.1
                    };
                if open {
                    c[k].clamp(self.extent[k].0, self.extent[k].1)
                } else {
                    c[k]
                }
            })
        };
        let (first, last) = (inside(from), inside(to));
        let (start, turns, entry) = self.locate(first)?;
        let (goal, goal_turns, exit) = self.locate(last)?;
        let (walk, turned) = self.walk((start, turns, entry), (goal, exit))?;
        let mut shift = [0.0; 3];
        shift[self.x] = TAU * f64::from(turned.0 - goal_turns.0);
        shift[1 - self.x] = TAU * f64::from(turned.1 - goal_turns.1);
        let moved = |c: Coords| -> Coords { core::array::from_fn(|k| c[k] + shift[k]) };
        let mut pieces: Vec<Box<dyn Piece + 'a>> = vec![Box::new(Straight { from, to: first })];
        for through in walk {
            pieces.push(Box::new(through));
        }
        pieces.push(Box::new(Straight {
            from: moved(last),
            to: moved(to),
        }));
        Some(pieces)
    }

    fn walk(
        &self,
        (start, turns, entry): (usize, (i32, i32), (f64, f64)),
        (goal, exit): (usize, (f64, f64)),
    ) -> Option<(Vec<Through<'a>>, (i32, i32))> {
        let mut reached: Vec<Option<Reached>> = vec![None; self.gaps.len()];
        reached[start] = Some(Reached {
            length: 0.0,
            turns,
            entry,
            before: None,
            done: false,
        });
        // Lengths that are not negative are ordered as their bits.
        let mut open = BinaryHeap::from([Reverse((0_u64, start))]);
        while let Some(Reverse((_, gap))) = open.pop() {
            let here = reached[gap]?;
            if here.done {
                continue;
            }
            reached[gap] = Some(Reached { done: true, ..here });
            if gap == goal {
                return Some((self.unrolled(&reached, goal, exit), here.turns));
            }
            for (next, leave, enter, turned) in self.beside(gap) {
                let length = here.length + self.length(gap, here.entry, leave);
                if reached[next].is_some_and(|r| r.done || r.length <= length) {
                    continue;
                }
                reached[next] = Some(Reached {
                    length,
                    turns: (here.turns.0 + turned.0, here.turns.1 + turned.1),
                    entry: enter,
                    before: Some((gap, leave)),
                    done: false,
                });
                open.push(Reverse((length.to_bits(), next)));
            }
        }
        None
    }

    fn length(&self, gap: usize, a: (f64, f64), b: (f64, f64)) -> f64 {
        let through = |s: f64| {
            Through {
                gap: self.gaps[gap],
                x: self.x,
                fractions: (a.0, b.0),
                shares: (a.1, b.1),
                shift: [0.0; 2],
            }
            .place(s)
        };
        let places = [0.0, 0.5, 1.0].map(through);
        (places.windows(2))
            .map(|w| {
                (0..2)
                    .map(|k| self.levers[k] * (w[1][k] - w[0][k]).abs())
                    .sum::<f64>()
            })
            .sum()
    }

    /// The gaps that go on from one where its interval of x begins and ends: where this one is left, where that one is entered, and
    /// the turns that its coordinates count more.
    #[allow(clippy::type_complexity)]
    fn beside(&self, gap: usize) -> Vec<(usize, (f64, f64), (f64, f64), (i32, i32))> {
        let band = self.bands.partition_point(|b| b.0.end <= gap);
        let n = self.bands.len();
        let (lo, hi) = (self.bands[0].1.0, self.bands[n - 1].1.1);
        // All bands together are a turn, if x is a circle.
        let closes = self.circles.0 && hi - lo > 0.999 * TAU;
        let mut found = Vec::new();
        for forward in [true, false] {
            let (other, x_turns) = match (forward, band) {
                (true, b) if b + 1 < n => (b + 1, 0),
                (true, _) if closes => (0, 1),
                (false, b) if b > 0 => (b - 1, 0),
                (false, _) if closes => (n - 1, -1),
                _ => continue,
            };
            // Between bands that are farther apart all is blocked.
            let turn = TAU * f64::from(x_turns);
            let ((lo, hi), (other_lo, other_hi)) = (self.bands[band].1, self.bands[other].1);
            let apart = if forward {
                other_lo + turn - hi
            } else {
                lo - (other_hi + turn)
            };
            if apart * self.levers[self.x] > CRACK * self.size {
                continue;
            }
            let (leave, enter) = if forward { (1.0, 0.0) } else { (0.0, 1.0) };
            let (p, q) = self.interval(gap, leave);
            for next in self.bands[other].0.clone() {
                let (r, s) = self.interval(next, enter);
                let turns = if self.circles.1 { -2..=2 } else { 0..=0 };
                for k in turns {
                    let by = TAU * f64::from(k);
                    let (from, to) = (p.max(r + by), q.min(s + by));
                    if from < to {
                        let y = 0.5 * (from + to);
                        let share = |(a, b): (f64, f64), y: f64| (y - a) / (b - a);
                        found.push((
                            next,
                            (leave, share((p, q), y)),
                            (enter, share((r, s), y - by)),
                            (x_turns, k),
                        ));
                    }
                }
            }
        }
        found
    }

    fn unrolled(
        &self,
        reached: &[Option<Reached>],
        goal: usize,
        exit: (f64, f64),
    ) -> Vec<Through<'a>> {
        let mut walk = Vec::new();
        let (mut gap, mut leave) = (goal, exit);
        while let Some(here) = reached[gap] {
            let mut shift = [0.0; 2];
            shift[self.x] = TAU * f64::from(here.turns.0);
            shift[1 - self.x] = TAU * f64::from(here.turns.1);
            walk.push(Through {
                gap: self.gaps[gap],
                x: self.x,
                fractions: (here.entry.0, leave.0),
                shares: (here.entry.1, leave.1),
                shift,
            });
            match here.before {
                Some((before, left)) => (gap, leave) = (before, left),
                None => break,
            }
        }
        walk.reverse();
        walk
    }
}

/// A number brought to an interval by whole turns, if it can be, and the turns that it has more.
fn brought(t: f64, (lo, hi): (f64, f64), circle: bool) -> Option<(f64, i32)> {
    if !circle || (lo..=hi).contains(&t) {
        return Some((t, 0));
    }
    let turns = ((t - lo) / TAU).floor();
    turns.is_finite().then_some((t - TAU * turns, turns as i32))
}
