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
/// No more boxes than these are gone through, in all rounds together: some twenty seconds.
const MOST_WORK: usize = 4_000_000;
/// Free lines are looked for again when there are this many times as many boxes.
const MANY: f64 = 1.5;
/// Highest energies of lines are right to this share of what the bounds may be apart.
const RIGHT: f64 = 0.01;
/// A leg that leaves contacts is gone until the energy has changed by this share of what the bounds may be apart.
const LEFT: f64 = 0.25;
/// No box is smaller than this share of the domain.
const LEAST_BOX: f64 = 1e-9;

/// Bounds of the lowest energy at which a path exists.
#[derive(Debug, Clone)]
pub(super) struct Bracket {
    /// No way has a highest energy below it; infinite if there is no way.
    pub(super) least: f64,
    /// Whether the bounds are as near to each other as was asked for.
    pub(super) is_closed: bool,
    /// Middles of boxes where the lowest way may be highest, and how far these extend.
    pub(super) high: Vec<(Coords, f64)>,
    /// A free way, with its highest energy; infinite without one. It begins with configurations, and goes on with places of the
    /// domain.
    pub(super) most: f64,
    pub(super) begin: Vec<Coords>,
    pub(super) way: Vec<Coords>,
}

/// Question for the search.
pub(super) struct Question<'a> {
    pub(super) scene: &'a Scene,
    pub(super) energy: Energy<'a>,
    /// The energy in coordinates of configurations.
    pub(super) plain: Energy<'a>,
    /// A free path from the start to the goal or out, if one is known. Ways go on from each of its places: through narrow passages
    /// it is the better guide.
    pub(super) known: Vec<Coords>,
    /// Where it begins, in coordinates of configurations, and the free end of a leg that leaves the contacts there.
    pub(super) from: Coords,
    pub(super) off: Coords,
    /// As above, for the goal; none for the way out.
    pub(super) to: Option<(Coords, Coords)>,
    pub(super) domain: Domain,
    /// Bounds no farther apart than this are near enough, or than this share of the upper one above the start.
    pub(super) within: f64,
    pub(super) share: f64,
}

impl Question<'_> {
    pub(super) fn bracket(&self, progress: &dyn Progress) -> Result<Bracket, ComputeError> {
        let domain = &self.domain;
        let mut boxes = Boxes::new(self.scene, domain.clone(), self.energy.clone());
        let from = domain.within(self.from);
        let start = [(from, boxes.energy.value(from))];
        let goal = match self.to {
            Some((to, _)) => Goal::At(domain.within(to)),
            None => Goal::Out,
        };
        let mut largest = 0.25 * boxes.extent(0);
        let mut found = Bracket {
            least: f64::NEG_INFINITY,
            is_closed: false,
            high: Vec::new(),
            most: f64::INFINITY,
            begin: Vec::new(),
            way: Vec::new(),
        };
        let along = self.along_known();
        if let Some(&most) = along.last() {
            found.most = most;
            found.begin.clone_from(&self.known);
        }
        let (mut asked, mut work) = (0, 0);
        loop {
            progress.stage(Stage::Cells)?;
            work += boxes.cells.len();
            let everywhere = boxes.cells.len() < FIRST && largest > SMALLEST * boxes.extent(0);
            if everywhere {
                largest *= 0.5;
            }
            let through = Through::Lowest {
                largest: if everywhere { largest } else { f64::INFINITY },
            };
            let Some(low) = flood(&mut boxes, &start, goal, through, RIGHT * self.within) else {
                found.least = f64::INFINITY;
                break;
            };
            found.least = found.least.max(low.energy);
            if boxes.cells.len() as f64 >= MANY * asked as f64 {
                if let Some(way) = self.lines(&mut boxes, &along)
                    && way.energy < found.most
                {
                    found.most = way.energy;
                    found.begin = match way.source {
                        0 => vec![self.from],
                        _ => (self.known.iter().copied())
                            .take_while(|&at| domain.within(at) != way.places[0])
                            .collect(),
                    };
                    found.way = way.places;
                }
                asked = boxes.cells.len();
            }
            found.high = self.high(&boxes, &low, found.most);
            let near = self.within.max(self.share * (found.most - start[0].1));
            if found.most - found.least <= near {
                found.is_closed = true;
            }
            if found.is_closed || work > MOST_WORK {
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

    /// The highest energy on the known path up to each of its places.
    fn along_known(&self) -> Vec<f64> {
        let mut highest = f64::NEG_INFINITY;
        let mut all = Vec::with_capacity(self.known.len());
        for (i, &place) in self.known.iter().enumerate() {
            let before = self.known[i.saturating_sub(1)];
            let leg = (self.plain).highest(before, place, RIGHT * self.within);
            highest = highest.max(leg);
            all.push(highest);
        }
        all
    }

    /// The way of least highest energy along free lines, from near the start or from a place of the known path to near the goal.
    fn lines(&self, boxes: &mut Boxes<'_>, along: &[f64]) -> Option<Way> {
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
        let start = boxes.energy.value(self.domain.within(self.from));
        let mut sources = vec![(first, boxes.energy.value(first).max(start))];
        // Its ends may be in contact.
        let last = self.known.len().saturating_sub(1);
        for (&at, &energy) in self.known.iter().zip(along).take(last).skip(1) {
            if self.domain.holds(at) {
                sources.push((self.domain.within(at), energy));
            }
        }
        let goal = match self.to {
            None => Goal::Out,
            Some(to) => Goal::At(place(boxes, to)?),
        };
        flood(boxes, &sources, goal, Through::Lines, RIGHT * self.within)
    }
}
