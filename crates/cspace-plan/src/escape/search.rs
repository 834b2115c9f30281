//! Bounds on the least energy, brought together by smaller boxes.

use cspace::{ComputeError, Progress, Stage};

use crate::legs::{Coords, Scene};

use super::boxes::{Boxes, State, middle};
use super::domain::Domain;
use super::energy::Energy;
use super::flood::{Goal, Through, Way, flood};
use super::leaks::leaks;

/// Boxes are made smaller everywhere while they are fewer than this, and not smaller than this share of the domain; then where a low
/// way may leak.
const FIRST: usize = 4_000;
const SMALLEST: f64 = 1.0 / 128.0;
/// No more boxes than these, of some hundred bytes.
const MOST_BOXES: usize = 300_000;
/// No more rounds along the lowest way.
const MOST_ROUNDS: usize = 400;
/// Free lines are looked for again when there are this many times as many boxes.
const MANY: f64 = 1.5;
/// Highest energies of lines are right to this share of what the bounds may be apart.
const RIGHT: f64 = 0.01;
/// A leg that leaves contacts is gone until the energy has changed by this share of what the bounds may be apart.
const LEFT: f64 = 0.25;
/// No box is smaller than this share of the domain.
const LEAST_BOX: f64 = 1e-9;

/// What is known of the least energy of a way.
#[derive(Debug, Clone)]
pub(super) struct Bracket {
    /// No way has a highest energy below it; infinite if there is no way.
    pub(super) least: f64,
    /// Middles of boxes where the lowest way may be highest, and how far these extend.
    pub(super) high: Vec<(Coords, f64)>,
    /// A way through free boxes, with its highest energy; infinite without one.
    pub(super) most: f64,
    pub(super) way: Vec<Coords>,
}

/// What is asked.
pub(super) struct Question<'a> {
    pub(super) scene: &'a Scene,
    pub(super) energy: Energy<'a>,
    /// Where it begins, in coordinates of configurations, and the free end of a leg that leaves the contacts there.
    pub(super) from: Coords,
    pub(super) off: Coords,
    /// The same of the goal; none for the way out.
    pub(super) to: Option<(Coords, Coords)>,
    pub(super) domain: Domain,
    /// Bounds no farther apart than this are near enough.
    pub(super) within: f64,
}

impl Question<'_> {
    pub(super) fn bracket(&self, progress: &dyn Progress) -> Result<Bracket, ComputeError> {
        let domain = &self.domain;
        let mut boxes = Boxes::new(self.scene, domain.clone(), self.energy.clone());
        let from = domain.within(self.from);
        let goal = match self.to {
            Some((to, _)) => Goal::At(domain.within(to)),
            None => Goal::Out,
        };
        let mut largest = 0.25 * boxes.extent(0);
        let mut found = Bracket {
            least: f64::NEG_INFINITY,
            high: Vec::new(),
            most: f64::INFINITY,
            way: Vec::new(),
        };
        let mut asked = 0;
        for _ in 0..MOST_ROUNDS {
            progress.stage(Stage::Cells)?;
            let everywhere = boxes.cells.len() < FIRST && largest > SMALLEST * boxes.extent(0);
            if everywhere {
                largest *= 0.5;
            }
            let through = Through::Lowest {
                largest: if everywhere { largest } else { f64::INFINITY },
            };
            let Some(low) = flood(&mut boxes, from, goal, through, RIGHT * self.within) else {
                found.least = f64::INFINITY;
                break;
            };
            found.least = found.least.max(low.energy);
            if boxes.cells.len() as f64 >= MANY * asked as f64 {
                if let Some(way) = self.lines(&mut boxes)
                    && way.energy < found.most
                {
                    found.most = way.energy;
                    found.way = way.places;
                }
                asked = boxes.cells.len();
            }
            found.high = self.high(&boxes, &low, found.most);
            if found.most - found.least <= self.within || boxes.cells.len() > MOST_BOXES {
                break;
            }
            if !everywhere {
                let least = LEAST_BOX * boxes.extent(0);
                let mut leaks = leaks(&boxes, from, goal, low.energy);
                if leaks.is_empty() {
                    leaks = self.wide(&boxes, &low);
                }
                leaks.retain(|&i| boxes.extent(i) > least);
                if leaks.is_empty() {
                    break;
                }
                for i in leaks {
                    for half in boxes.divide(i) {
                        boxes.divide(half);
                    }
                }
            }
        }
        Ok(found)
    }

    /// Where the lowest way may be highest: its boxes that reach the least energy.
    fn high(&self, boxes: &Boxes<'_>, low: &Way, most: f64) -> Vec<(Coords, f64)> {
        let mut high = Vec::new();
        for &i in &low.boxes {
            let cell = boxes.cell(i);
            let (lo, hi) = boxes.energy(cell.lo, cell.hi);
            let about = cell.state == State::Free || lo >= low.energy - 0.5 * (most - low.energy);
            if hi >= low.energy && lo <= most && about {
                let (middle, half) = middle(cell.lo, cell.hi);
                high.push((middle, self.domain.moved(half)));
            }
        }
        high
    }

    /// The boxes of a way of free boxes in which its energy may be higher than between them.
    fn wide(&self, boxes: &Boxes<'_>, way: &Way) -> Vec<u32> {
        let is_wide = |&i: &u32| {
            let cell = boxes.cell(i);
            let (lo, hi) = boxes.energy(cell.lo, cell.hi);
            hi > way.energy && hi - lo > 0.25 * self.within
        };
        way.boxes.iter().copied().filter(is_wide).collect()
    }

    /// The way of least highest energy along free lines, from near the start to near the goal.
    fn lines(&self, boxes: &mut Boxes<'_>) -> Option<Way> {
        let place = |boxes: &mut Boxes<'_>, (from, off): (Coords, Coords)| {
            let change = boxes.energy.value(self.domain.within(off))
                - boxes.energy.value(self.domain.within(from));
            let step = (LEFT * self.within / change.abs()).min(1.0);
            let at = core::array::from_fn(|k| from[k] + (off[k] - from[k]) * step);
            let at = self.domain.within(at);
            let least = LEAST_BOX * boxes.extent(0);
            loop {
                let i = boxes.holding(at);
                match boxes.cell(i).state {
                    State::Free => return Some(at),
                    State::Open if boxes.extent(i) > least => boxes.divide(i),
                    _ => return None,
                };
            }
        };
        let first = place(boxes, (self.from, self.off))?;
        let goal = match self.to {
            None => Goal::Out,
            Some(to) => Goal::At(place(boxes, to)?),
        };
        let mut way = flood(boxes, first, goal, Through::Lines, RIGHT * self.within)?;
        way.energy = way
            .energy
            .max(boxes.energy.value(self.domain.within(self.from)));
        Some(way)
    }
}
