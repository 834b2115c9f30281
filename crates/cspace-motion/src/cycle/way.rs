//! The motion of a linkage from the start of a cycle to its end, or to where joints determine it no longer.

use std::collections::BTreeMap;

use cspace::Ball;

use super::enclosure::{Enclosed, Equations};
use super::linkage::Linkage;
use crate::system::{PartCoordinates, System};

/// A cycle is cut into so many pieces, and where bounds need it into shorter ones, down to this share of it.
const PIECES: u32 = 64;
const SHORTEST: f64 = 1e-12;
/// A range is left by more than this share of it.
const SLACK: f64 = 1e-9;

/// Why a linkage does not go through the whole cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Halt {
    /// The joints do not determine where its parts go from there, or let them go nowhere.
    DeadPoint,
    /// A part, by its number, comes to the end of its range.
    Range(usize),
}

/// A linkage over a cycle: pieces of time in each of which there is one solution, and one alone, in a box, so that all pieces together are one
/// motion.
#[derive(Debug)]
pub(super) struct Way {
    linkage: Linkage,
    pieces: Vec<Piece>,
    /// The last time.
    pub(super) end: f64,
    pub(super) halt: Option<Halt>,
    known: BTreeMap<[u64; 2], Option<Bent>>,
}

/// The coordinates at the two ends of an interval of time, and bounds of their accelerations in between.
#[derive(Debug, Clone)]
pub(super) struct Bent {
    pub(super) from: Vec<f64>,
    pub(super) to: Vec<f64>,
    pub(super) bend: Vec<f64>,
}

#[derive(Debug)]
struct Piece {
    times: [f64; 2],
    ends: [Vec<f64>; 2],
    within: Vec<Ball>,
}

impl Way {
    /// Follows a linkage from where all joints hold at the first time.
    pub(super) fn new(
        system: &System,
        linkage: &Linkage,
        start: &[f64],
        [from, to]: [f64; 2],
    ) -> Self {
        let mut way = Self {
            linkage: linkage.clone(),
            pieces: Vec::new(),
            end: from,
            halt: None,
            known: BTreeMap::new(),
        };
        way.follow(system, start, [from, to]);
        way
    }

    fn follow(&mut self, system: &System, start: &[f64], [from, to]: [f64; 2]) {
        let x: Vec<f64> = self.linkage.unknown.iter().map(|&i| start[i]).collect();
        let Some(mut x) = self.equations(system).solve(from, &x) else {
            self.halt = Some(Halt::DeadPoint);
            return;
        };
        let span = to - from;
        // Numbers of pieces of the shortest kind in use, so that linkages are cut alike.
        let mut marks: Vec<f64> = (0..=PIECES)
            .map(|i| from + span * f64::from(i) / f64::from(PIECES))
            .collect();
        let corners = system
            .drives()
            .iter()
            .flat_map(|(_, curve)| curve.corners());
        marks.extend(corners.filter(|t| *t > from && *t < to));
        marks.sort_by(f64::total_cmp);
        marks.dedup();
        if let Some(last) = marks.last_mut() {
            *last = to;
        }
        let mut stack: Vec<[f64; 2]> = marks.windows(2).map(|w| [w[0], w[1]]).collect();
        stack.reverse();
        while let Some([lo, hi]) = stack.pop() {
            match self.piece(system, [lo, hi], &x) {
                Some(piece) => {
                    if let Some(halt) = self.leaves(system, &piece) {
                        self.halt = Some(halt);
                        return;
                    }
                    x.clone_from(&piece.ends[1]);
                    self.end = hi;
                    self.pieces.push(piece);
                }
                None if hi - lo <= SHORTEST * span => {
                    self.halt = Some(Halt::DeadPoint);
                    return;
                }
                None => {
                    let middle = 0.5 * (lo + hi);
                    stack.extend([[middle, hi], [lo, middle]]);
                }
            }
        }
    }

    fn equations<'a>(&'a self, system: &'a System) -> Equations<'a> {
        Equations {
            system,
            linkage: &self.linkage,
        }
    }

    fn piece(&self, system: &System, [lo, hi]: [f64; 2], x: &[f64]) -> Option<Piece> {
        let equations = self.equations(system);
        let rates = equations.rates(lo, x)?;
        let ahead =
            |by: f64| -> Vec<f64> { x.iter().zip(&rates).map(|(x, v)| x + v * by).collect() };
        let middle = equations.solve(0.5 * (lo + hi), &ahead(0.5 * (hi - lo)))?;
        let Enclosed { within, .. } = equations.enclosed([lo, hi], &middle)?;
        if !holds(&within, x) {
            return None;
        }
        let guess: Vec<f64> = middle.iter().zip(x).map(|(m, x)| 2.0 * m - x).collect();
        let end = equations.solve(hi, &guess)?;
        holds(&within, &end).then(|| Piece {
            times: [lo, hi],
            ends: [x.to_vec(), end],
            within,
        })
    }

    /// Whether a part leaves its range over a piece, which then is cut off there.
    fn leaves(&mut self, system: &System, piece: &Piece) -> Option<Halt> {
        let outside = |x: &[f64]| {
            self.linkage
                .parts
                .iter()
                .copied()
                .find(|&i| match system.parts()[i] {
                    PartCoordinates::Axis {
                        first,
                        range: Some((lo, hi)),
                        ..
                    } => {
                        let slack = SLACK * (hi - lo);
                        let k = self.linkage.unknown.binary_search(&first);
                        k.is_ok_and(|k| x[k] < lo - slack || x[k] > hi + slack)
                    }
                    _ => false,
                })
        };
        let part = outside(&piece.ends[1])?;
        let [mut lo, mut hi] = piece.times;
        let equations = self.equations(system);
        let mut at = piece.ends[0].clone();
        for _ in 0..60 {
            let middle = 0.5 * (lo + hi);
            match equations.solve(middle, &at) {
                Some(x) if holds(&piece.within, &x) && outside(&x).is_none() => {
                    (lo, at) = (middle, x);
                }
                _ => hi = middle,
            }
        }
        if lo > piece.times[0] {
            let cut = Piece {
                times: [piece.times[0], lo],
                ends: [piece.ends[0].clone(), at],
                within: piece.within.clone(),
            };
            self.end = lo;
            self.pieces.push(cut);
        }
        Some(Halt::Range(part))
    }

    /// The coordinates of its parts, by their numbers in order.
    pub(super) fn unknown(&self) -> &[usize] {
        &self.linkage.unknown
    }

    /// The times at which its pieces begin and end.
    pub(super) fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces.iter().flat_map(|p| p.times)
    }

    fn around(&self, time: f64) -> Option<&Piece> {
        let k = self.pieces.partition_point(|p| p.times[1] < time);
        self.pieces.get(k).or(self.pieces.last())
    }

    /// The coordinates of its parts at a time.
    pub(super) fn at(&self, system: &System, time: f64) -> Option<Vec<f64>> {
        let piece = self.around(time)?;
        let [lo, hi] = piece.times;
        for (end, of) in piece.times.into_iter().zip(&piece.ends) {
            if end == time {
                return Some(of.clone());
            }
        }
        let t = (time - lo) / (hi - lo);
        let guess: Vec<f64> = (piece.ends[0].iter().zip(&piece.ends[1]))
            .map(|(a, b)| a + (b - a) * t)
            .collect();
        let found = self.equations(system).solve(time, &guess)?;
        holds(&piece.within, &found).then_some(found)
    }

    /// The coordinates at the ends of an interval within a piece, and how they bend in between.
    pub(super) fn over(&mut self, system: &System, [lo, hi]: [f64; 2]) -> Option<Bent> {
        let key = [lo.to_bits(), hi.to_bits()];
        if let Some(known) = self.known.get(&key) {
            return known.clone();
        }
        let found = self.bent(system, [lo, hi]);
        self.known.insert(key, found.clone());
        found
    }

    fn bent(&self, system: &System, [lo, hi]: [f64; 2]) -> Option<Bent> {
        let middle = self.at(system, 0.5 * (lo + hi))?;
        let enclosed = self.equations(system).enclosed([lo, hi], &middle)?;
        Some(Bent {
            from: self.at(system, lo)?,
            to: self.at(system, hi)?,
            bend: enclosed.bend,
        })
    }
}

fn holds(within: &[Ball], x: &[f64]) -> bool {
    let each = within.iter().zip(x);
    each.into_iter()
        .all(|(ball, x)| (x - ball.mid).abs() <= ball.radius)
}
