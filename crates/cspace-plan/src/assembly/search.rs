//! What is taken away, in which order.

use cspace::Progress;

use super::answer::{Enclosure, Locked, Outcome, Step, TakenApart};
use super::blocking::Blocking;
use super::error::AssemblyError;
use super::exact::{Leaves, leaves};
use super::units::{Set, Units, members};

/// All groups are tried in sets of at most so many units.
const ALL: u32 = 12;

/// What is known of an assembly.
pub(super) struct Search<'a> {
    units: &'a Units,
    progress: &'a dyn Progress,
    blocking: Option<Blocking>,
    /// Sets that cannot be taken out of each other. Then neither can larger ones.
    enclosed: Vec<(Set, Set, Enclosure)>,
    /// Sets of which this is not known.
    unsure: Vec<(Set, Set)>,
    /// Whether all that was not found is excluded.
    is_certain: bool,
    steps: Vec<Step>,
    spaces: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(units: &'a Units, progress: &'a dyn Progress) -> Self {
        Self {
            units,
            progress,
            blocking: None,
            enclosed: Vec::new(),
            unsure: Vec::new(),
            is_certain: true,
            steps: Vec::new(),
            spaces: 0,
        }
    }

    /// Takes apart as much as can be.
    ///
    /// What is taken away is never in the way later, so it is right to take away the first that leaves.
    pub(super) fn run(mut self) -> Result<TakenApart, AssemblyError> {
        let mut left = vec![self.units.all()];
        let mut locked: Option<Set> = None;
        let mut is_stuck = false;
        while let Some(set) = left.pop() {
            if set.count_ones() < 2 {
                continue;
            }
            if let Some((moving, step)) = self.first(set)? {
                self.steps.push(step);
                left.push(moving);
                left.push(set & !moving);
                continue;
            }
            is_stuck = true;
            if set.count_ones() <= ALL {
                let smallest = self.smallest(set)?;
                if locked.is_none_or(|l| smallest.count_ones() < l.count_ones()) {
                    locked = Some(smallest);
                }
            } else {
                self.is_certain = false;
            }
        }
        let is_certain = self.is_certain && self.unsure.is_empty() && !self.units.is_simplified;
        let outcome = match (is_stuck, is_certain) {
            (false, _) => Outcome::Apart,
            (true, true) => Outcome::Locked,
            (true, false) => Outcome::Unknown,
        };
        let locked = locked.map(|set| Locked {
            parts: self.units.parts_of(set),
            why: (self.enclosed.iter())
                .filter(|(a, b, _)| (a | b) & !set == 0)
                .map(|(_, _, why)| why.clone())
                .collect(),
        });
        Ok(TakenApart {
            outcome,
            steps: self.steps,
            locked,
            spaces: self.spaces,
        })
    }

    /// The first that leaves a set: single units, then groups that the contacts let go, then all others.
    fn first(&mut self, set: Set) -> Result<Option<(Set, Step)>, AssemblyError> {
        let still = self.units.still() & set;
        // What is listed first stays as long as it can: it is what others are put into.
        let singles: Vec<Set> = members(set & !still).map(|u| 1 << u).collect();
        for moving in singles.into_iter().rev() {
            if let Some(step) = self.step(moving, set & !moving)? {
                return Ok(Some((moving, step)));
            }
        }
        if set.count_ones() > 2 {
            let units = self.units;
            let blocking = self.blocking.get_or_insert_with(|| Blocking::new(units));
            for moving in blocking.groups(set, still) {
                if let Some(step) = self.step(moving, set & !moving)? {
                    return Ok(Some((moving, step)));
                }
            }
            if set.count_ones() <= ALL {
                self.pairs(set)?;
                for moving in divisions(set, still) {
                    if let Some(step) = self.step(moving, set & !moving)? {
                        return Ok(Some((moving, step)));
                    }
                }
            }
        }
        Ok(None)
    }

    /// Asks of every two units of a set: two that hold each other answer for many groups.
    fn pairs(&mut self, set: Set) -> Result<(), AssemblyError> {
        for a in members(set) {
            for b in members(set).filter(|&b| b > a) {
                self.step(1 << b, 1 << a)?;
            }
        }
        Ok(())
    }

    /// The smallest set within one that does not come apart of which no part leaves the others.
    fn smallest(&mut self, set: Set) -> Result<Set, AssemblyError> {
        let mut within = subsets(set);
        within.sort_by_key(|s| (s.count_ones(), *s));
        'next: for part in within {
            if part.count_ones() < 2 {
                continue;
            }
            for moving in divisions(part, self.units.still() & part) {
                if self.step(moving, part & !moving)?.is_some() {
                    continue 'next;
                }
            }
            return Ok(part);
        }
        Ok(set)
    }

    /// The step that takes one set out of another, if there is one.
    fn step(&mut self, moving: Set, staying: Set) -> Result<Option<Step>, AssemblyError> {
        let holds = |a: Set, b: Set| a & !moving == 0 && b & !staying == 0;
        let known = |&(a, b): &(Set, Set)| holds(a, b) || holds(b, a);
        if self.enclosed.iter().any(|(a, b, _)| known(&(*a, *b)))
            || self.unsure.contains(&(moving, staying))
        {
            return Ok(None);
        }
        self.spaces += 1;
        match leaves(self.units, (moving, staying), self.progress)? {
            Leaves::By(step) => return Ok(Some(*step)),
            Leaves::Not(why) => {
                if !why.doubtful.is_empty() {
                    self.is_certain = false;
                }
                self.enclosed.push((moving, staying, *why));
            }
            Leaves::Unsure => self.unsure.push((moving, staying)),
        }
        Ok(None)
    }
}

/// All sets within one, but for the empty one.
fn subsets(set: Set) -> Vec<Set> {
    let mut all = Vec::new();
    let mut part = set;
    while part != 0 {
        all.push(part);
        part = (part - 1) & set;
    }
    all
}

/// One side of every division of a set into two: the one that may move, or the smaller; the smallest first.
fn divisions(set: Set, still: Set) -> Vec<Set> {
    let first = set & set.wrapping_neg();
    let is_one = |&moving: &Set| {
        let (here, there) = (moving.count_ones(), (set & !moving).count_ones());
        moving != set
            && moving & still == 0
            && (still != 0 || here < there || here == there && moving & first == 0)
    };
    let mut sides: Vec<Set> = subsets(set).into_iter().filter(is_one).collect();
    sides.sort_by_key(|s| (s.count_ones(), *s));
    sides
}
