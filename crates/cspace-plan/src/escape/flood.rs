//! The lowest passage from box to box: Dijkstra's search for the way whose highest energy is least.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use core::f64::consts::TAU;

use crate::legs::Coords;

use super::boxes::{Boxes, Face, State, middle};

/// Where a way is to lead.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal {
    /// To where the parts are apart for good.
    Out,
    /// To coordinates of the domain.
    At(Coords),
}

/// A box that is reached.
#[derive(Debug, Clone, Copy)]
struct Reached {
    /// The highest energy on the way there.
    energy: f64,
    /// How long the way is, where each box that is not known to be free counts as much as the domain is wide: of ways of the same
    /// energy the one through the fewest of them is taken.
    length: f64,
    /// Where it enters the box.
    entry: Coords,
    from: Option<(u32, [i32; 3])>,
    settled: bool,
}

/// The way found.
#[derive(Debug, Clone)]
pub(super) struct Way {
    /// Its highest energy: of a way through boxes that may be free, no other has less; of one through free boxes, it has no more.
    pub(super) energy: f64,
    /// The number of the place at which it begins.
    pub(super) source: usize,
    /// The boxes.
    pub(super) boxes: Vec<u32>,
    /// Where it enters each box, and the goal; angles run on.
    pub(super) places: Vec<Coords>,
}

struct Next {
    energy: f64,
    length: f64,
    cell: u32,
}

impl PartialEq for Next {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Next {}
impl PartialOrd for Next {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Next {
    /// The heap gives the greatest: that of the least energy, then of the shortest way.
    fn cmp(&self, other: &Self) -> Ordering {
        (other.energy.total_cmp(&self.energy))
            .then(other.length.total_cmp(&self.length))
            .then(other.cell.cmp(&self.cell))
    }
}

/// Which boxes a way may use.
#[derive(Debug, Clone, Copy)]
pub(super) enum Through {
    /// All that are not blocked, each at its least energy. Larger ones that are not known to be free are halved first.
    Lowest { largest: f64 },
    /// All that are not blocked, along straight lines that are free.
    Lines,
}

/// Stands for the goal in place of a box.
const GOAL: u32 = u32::MAX;

/// The way of least highest energy to a goal from one of some places, which are reached with an energy; `None` if no boxes lead
/// there.
pub(super) fn flood(
    boxes: &mut Boxes<'_>,
    from: &[(Coords, f64)],
    goal: Goal,
    through: Through,
    tolerance: f64,
) -> Option<Way> {
    let mut search = Search {
        boxes,
        reached: Vec::new(),
        heap: BinaryHeap::new(),
        through,
        tolerance,
        from,
        end: None,
        faces: Vec::new(),
    };
    for &source in from {
        search.start(source);
    }
    while let Some(next) = search.heap.pop() {
        if next.cell == GOAL {
            return search.way();
        }
        let Some(here) = search.reached[next.cell as usize]
            .filter(|r| !r.settled && r.energy == next.energy && r.length == next.length)
        else {
            continue;
        };
        if search.is_too_large(next.cell) {
            search.divide(next.cell);
            continue;
        }
        if let Some(r) = &mut search.reached[next.cell as usize] {
            r.settled = true;
        }
        search.arrive(next.cell, &here, goal);
        search.go_on(next.cell, &here);
    }
    None
}

struct Search<'a, 'b> {
    boxes: &'a mut Boxes<'b>,
    from: &'a [(Coords, f64)],
    reached: Vec<Option<Reached>>,
    heap: BinaryHeap<Next>,
    through: Through,
    /// Highest energies of lines are right to this.
    tolerance: f64,
    /// The last box of the way, its highest energy, and where it ends.
    end: Option<(u32, f64, Coords)>,
    faces: Vec<Face>,
}

impl Search<'_, '_> {
    fn may_use(&self, cell: u32) -> bool {
        self.boxes.cell(cell).state != State::Blocked
    }

    fn start(&mut self, (entry, energy): (Coords, f64)) {
        let cell = self.boxes.holding(entry);
        if self.may_use(cell) {
            self.reach(
                cell,
                Reached {
                    energy,
                    length: 0.0,
                    entry,
                    from: None,
                    settled: false,
                },
            );
        }
    }

    fn reach(&mut self, cell: u32, by: Reached) {
        self.reached.resize(self.boxes.cells.len(), None);
        let place = &mut self.reached[cell as usize];
        let better =
            place.is_none_or(|r| !r.settled && (by.energy, by.length) < (r.energy, r.length));
        if better {
            *place = Some(by);
            self.heap.push(Next {
                energy: by.energy,
                length: by.length,
                cell,
            });
        }
    }

    /// Whether a box is to be halved before it is used.
    fn is_too_large(&self, cell: u32) -> bool {
        let Through::Lowest { largest } = self.through else {
            return false;
        };
        self.boxes.cell(cell).state == State::Open && self.boxes.extent(cell) > largest
    }

    /// Halves a box, and reaches the halves from the boxes beside them.
    fn divide(&mut self, cell: u32) {
        self.reached[cell as usize] = None;
        for half in self.boxes.divide(cell) {
            self.reached.resize(self.boxes.cells.len(), None);
            if !self.may_use(half) {
                continue;
            }
            for &source in self.from {
                if self.boxes.holding(source.0) == half {
                    self.start(source);
                }
            }
            let mut faces = Vec::new();
            self.boxes.beside(half, &mut faces);
            for face in &faces {
                let settled = self.reached[face.other as usize].filter(|r| r.settled);
                if let Some(beside) = settled {
                    let back = Face {
                        other: half,
                        turns: face.turns.map(|t| -t),
                        ..self.seen_from(face)
                    };
                    if let Some(by) = self.through_face(face.other, &beside, &back) {
                        self.reach(half, by);
                    }
                }
            }
        }
    }

    /// A face in the numbers of the box on the other side.
    fn seen_from(&self, face: &Face) -> Face {
        let shifted = |c: Coords| core::array::from_fn(|k| c[k] + TAU * f64::from(face.turns[k]));
        Face {
            lo: shifted(face.lo),
            hi: shifted(face.hi),
            ..*face
        }
    }

    /// How a box is reached through a face of one that is reached; `None` if no line tried is free.
    fn through_face(&self, cell: u32, here: &Reached, face: &Face) -> Option<Reached> {
        let nearest: Coords = core::array::from_fn(|k| here.entry[k].clamp(face.lo[k], face.hi[k]));
        let state = |i: u32| self.boxes.cell(i).state;
        let (place, energy) = match self.through {
            Through::Lowest { .. } => (nearest, self.boxes.energy(face.lo, face.hi).0),
            Through::Lines => {
                let tried = [nearest, middle(face.lo, face.hi).0];
                let known = state(cell) == State::Free;
                let place = (tried.into_iter())
                    .find(|&place| known || self.boxes.is_free(here.entry, place))?;
                (place, self.highest(here.entry, place))
            }
        };
        let (_, half) = middle(here.entry, place);
        let dear = match state(face.other) {
            State::Open => self.boxes.extent(0),
            _ => 0.0,
        };
        Some(Reached {
            energy: here.energy.max(energy),
            length: here.length + 2.0 * self.boxes.domain.moved(half.map(f64::abs)) + dear,
            entry: core::array::from_fn(|k| place[k] + TAU * f64::from(face.turns[k])),
            from: Some((cell, face.turns)),
            settled: false,
        })
    }

    /// The highest energy along a line.
    fn highest(&self, from: Coords, to: Coords) -> f64 {
        self.boxes.energy.highest(from, to, self.tolerance)
    }

    fn go_on(&mut self, cell: u32, here: &Reached) {
        let mut faces = core::mem::take(&mut self.faces);
        self.boxes.beside(cell, &mut faces);
        for face in &faces {
            if self.may_use(face.other)
                && let Some(by) = self.through_face(cell, here, face)
            {
                self.reach(face.other, by);
            }
        }
        self.faces = faces;
    }

    /// The goal from a box, if it is there.
    fn arrive(&mut self, cell: u32, here: &Reached, goal: Goal) {
        let c = *self.boxes.cell(cell);
        let free = matches!(self.through, Through::Lines);
        let found = match goal {
            Goal::At(to) => {
                let within = (0..3).all(|k| c.lo[k] <= to[k] && to[k] <= c.hi[k]);
                let energy = if free {
                    self.highest(here.entry, to)
                } else {
                    self.boxes.energy.value(to)
                };
                within.then_some((energy, to))
            }
            Goal::Out => {
                let corners = self.boxes.domain.out(c.lo, c.hi);
                let ends = corners.map(|[x, y]| {
                    let end = [x, y, here.entry[2]];
                    let energy = if free {
                        self.highest(here.entry, end)
                    } else {
                        self.boxes.energy(c.lo, c.hi).0
                    };
                    (energy, end)
                });
                ends.min_by(|a, b| a.0.total_cmp(&b.0))
            }
        };
        let Some((energy, end)) = found else {
            return;
        };
        if free && c.state == State::Open && !self.boxes.is_free(here.entry, end) {
            return;
        }
        let energy = energy.max(here.energy);
        if self.end.is_none_or(|(_, best, _)| energy < best) {
            self.end = Some((cell, energy, end));
            self.heap.push(Next {
                energy,
                length: here.length,
                cell: GOAL,
            });
        }
    }

    /// The way to the goal, back from its end.
    fn way(&self) -> Option<Way> {
        let (last, energy, end) = self.end?;
        let (mut boxes, mut entries) = (vec![last], Vec::new());
        let mut here = self.reached[last as usize]?;
        entries.push((here.entry, [0; 3]));
        while let Some((before, turns)) = here.from {
            boxes.push(before);
            here = self.reached[before as usize]?;
            entries.push((here.entry, turns));
        }
        let source = self
            .from
            .iter()
            .position(|&(place, _)| place == here.entry)?;
        boxes.reverse();
        entries.reverse();
        // Turns add up along the way: a box across the end of a coordinate counts from there.
        let mut sum = [0; 3];
        let mut places = Vec::with_capacity(entries.len() + 1);
        let lifted = |c: Coords, sum: [i32; 3]| -> Coords {
            core::array::from_fn(|k| c[k] - TAU * f64::from(sum[k]))
        };
        for (entry, turns) in entries {
            places.push(lifted(entry, sum));
            for k in 0..3 {
                sum[k] += turns[k];
            }
        }
        places.push(lifted(end, sum));
        Some(Way {
            energy,
            source,
            boxes,
            places,
        })
    }
}
