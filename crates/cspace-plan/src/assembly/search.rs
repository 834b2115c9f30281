//! Search for which parts to take away, and in which order.

use cspace::Progress;

use super::answer::{Branch, Enclosure, Locked, Outcome, Step, TakenApart, Tree, Tried};
use super::aside::{Helped, choices, each_place, straight_step, together};
use super::blocking::Blocking;
use super::error::AssemblyError;
use super::exact::{Leaves, Way, leaves, leaves_straight, leaves_straight_like};
use super::onward::Played;
use super::units::{Set, Units, members};
use super::wider::wider;

/// All groups are tried in sets of at most so many units that may leave.
const ALL: u32 = 12;
/// So many places of units that make room are tried for each step by straight ways,
const STRAIGHT: usize = 2000;
/// and so many by contact spaces, of one unit alone or of several on axes.
const EXACT: usize = 100;

/// Which set makes room for which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Room {
    /// Parts on axes alone, for a straight way.
    OnAxes,
    /// Others, for a straight way.
    Straight,
    /// One part, or several on axes, for a way of any kind.
    Any,
}

/// A set that leaves, and the steps by which it does: what makes room for it, then it.
type Leaving = (Set, Vec<Step>);

/// State of the search for the steps of an assembly.
pub(super) struct Search<'a> {
    units: Units,
    progress: &'a dyn Progress,
    blocking: Option<Blocking>,
    /// Sets that cannot be taken out of each other. Then neither can larger ones.
    enclosed: Vec<(Set, Set, Enclosure)>,
    /// Sets of which this is not known.
    unsure: Vec<(Set, Set)>,
    steps: Vec<Step>,
    /// Places of units that made room.
    places: usize,
    /// Sets that do not come apart.
    stuck: Vec<Set>,
    spaces: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(units: &Units, progress: &'a dyn Progress) -> Self {
        Self {
            units: units.clone(),
            progress,
            blocking: None,
            enclosed: Vec::new(),
            unsure: Vec::new(),
            steps: Vec::new(),
            places: 0,
            stuck: Vec::new(),
            spaces: 0,
        }
    }

    /// Takes apart as much as can be.
    ///
    /// Parts taken away are never in the way later, so it is right to take away the first set that leaves.
    pub(super) fn run(mut self) -> Result<TakenApart, AssemblyError> {
        let tree = self.apart(self.units.all())?;
        let mut locked: Option<Set> = None;
        for set in self.stuck.clone() {
            let found = match self.held(set) {
                Some(two) => Some(two),
                None if self.may_leave(set) <= ALL => Some(self.smallest(set)?),
                None => None,
            };
            let size = |set: Set| (self.held(set).is_none(), set.count_ones());
            if let Some(found) = found
                && locked.is_none_or(|l| size(found) < size(l))
            {
                locked = Some(found);
            }
        }
        let outcome = match locked {
            _ if self.stuck.is_empty() => Outcome::Apart,
            Some(set) if self.held(set) == Some(set) => Outcome::Locked,
            _ => Outcome::Unknown,
        };
        let locked = locked.map(|set| Locked {
            parts: self.units.parts_of(set),
            why: (self.enclosed.iter())
                .filter(|(a, b, _)| (a | b) & !set == 0)
                .map(|(_, _, why)| why.clone())
                .collect(),
        });
        let units = &self.units;
        Played::new(&units.drawn, units.part_axes()).tell(&tree, &mut self.steps)?;
        Ok(TakenApart {
            outcome,
            steps: self.steps,
            tree,
            locked,
            tried: (self.places > 0 || outcome == Outcome::Unknown).then_some(Tried {
                aside: together(&self.units),
                places: self.places,
            }),
            spaces: self.spaces,
        })
    }

    /// Takes a set apart, then what came out of it.
    fn apart(&mut self, set: Set) -> Result<Tree, AssemblyError> {
        let (mut left, mut out) = (set, Vec::new());
        while left & !self.units.still != 0 && left.count_ones() > 1 {
            let Some((moving, steps)) = self.next(left)? else {
                self.stuck.push(left);
                break;
            };
            let first = self.steps.len();
            self.steps.extend(steps);
            let step = self.steps.len() - 1;
            out.push((first..step, step, moving));
            left &= !moving;
        }
        let mut branches = Vec::with_capacity(out.len());
        for (room, step, moving) in out {
            branches.push(Branch {
                room: room.collect(),
                step,
                tree: self.apart(moving)?,
            });
        }
        Ok(Tree {
            parts: self.units.parts_of(set),
            out: branches,
            left: self.units.parts_of(left),
        })
    }

    /// How many units of a set may leave it.
    fn may_leave(&self, set: Set) -> u32 {
        (set & !self.units.still).count_ones()
    }

    /// The next that leaves a set, after others have made room if they must.
    fn next(&mut self, set: Set) -> Result<Option<Leaving>, AssemblyError> {
        let mut groups = Vec::new();
        if let Some((moving, step)) = self.first_straight(set, &mut groups)? {
            return Ok(Some((moving, vec![step])));
        }
        // Straight ways are found far quicker than that there is none of any kind.
        if let Some(leaving) = self.after_room(set, Room::OnAxes)? {
            return Ok(Some(leaving));
        }
        for moving in groups {
            if let Some(step) = self.step(moving, set & !moving)? {
                return Ok(Some((moving, vec![step])));
            }
        }
        if let Some(leaving) = self.after_room(set, Room::Straight)? {
            return Ok(Some(leaving));
        }
        if let Some((moving, step)) = self.any_group(set)? {
            return Ok(Some((moving, vec![step])));
        }
        self.after_room(set, Room::Any)
    }

    /// The first of all groups that leaves a set.
    fn any_group(&mut self, set: Set) -> Result<Option<(Set, Step)>, AssemblyError> {
        if set.count_ones() <= 2 || self.may_leave(set) > ALL {
            return Ok(None);
        }
        self.pairs(set)?;
        for moving in divisions(set, self.units.still & set) {
            if let Some(step) = self.step(moving, set & !moving)? {
                return Ok(Some((moving, step)));
            }
        }
        Ok(None)
    }

    /// Two rigid units of a set of which the one encloses the other, however all others move.
    fn held(&self, set: Set) -> Option<Set> {
        (self.enclosed.iter())
            .filter(|(a, b, _)| a.count_ones() == 1 && b.count_ones() == 1)
            .filter(|(_, _, why)| why.doubtful.is_empty())
            .map(|(a, b, _)| a | b)
            .find(|two| two & !set == 0 && two & !self.units.rigid == 0)
    }

    /// The first that leaves a set on a straight way: single units, then groups that the contacts let go. All that were asked about
    /// are told.
    fn first_straight(
        &mut self,
        set: Set,
        asked: &mut Vec<Set>,
    ) -> Result<Option<(Set, Step)>, AssemblyError> {
        let still = self.units.still & set;
        // What is listed first stays as long as it can: it is what others are put into.
        let mut singles: Vec<Set> = members(set & !still).map(|u| 1 << u).collect();
        singles.reverse();
        let found = self.straight_of(set, &singles)?;
        asked.extend(singles);
        if found.is_some() || set.count_ones() <= 2 {
            return Ok(found);
        }
        let units = &self.units;
        let blocking = (self.blocking).get_or_insert_with(|| Blocking::new(units));
        let mut groups = blocking.groups(set, still);
        groups.retain(|g| !asked.contains(g));
        let found = self.straight_of(set, &groups)?;
        asked.extend(groups);
        Ok(found)
    }

    /// The first of some groups that leaves a set on a straight way.
    fn straight_of(&self, set: Set, groups: &[Set]) -> Result<Option<(Set, Step)>, AssemblyError> {
        for &moving in groups {
            if let Some(step) = leaves_straight(&self.units, (moving, set & !moving))? {
                return Ok(Some((moving, step)));
            }
        }
        Ok(None)
    }

    /// The first that leaves a set after one unit or two have made room; these stay where they have come to.
    fn after_room(&mut self, set: Set, room: Room) -> Result<Option<Leaving>, AssemblyError> {
        let exact = room == Room::Any;
        let mut left = if exact { EXACT } else { STRAIGHT };
        for order in choices(&self.units, set) {
            let on_axes = order.iter().all(|&u| self.units.axes[u].is_some());
            let is_asked = match room {
                Room::OnAxes => on_axes,
                Room::Straight => !on_axes,
                Room::Any => order.len() == 1 || on_axes,
            };
            if left == 0 || !is_asked {
                continue;
            }
            let helped = self.helped(set, &order, exact)?;
            if helped.is_empty() {
                continue;
            }
            let units = self.units.clone();
            let mut tried = 0;
            let mut spaces = 0;
            let progress = self.progress;
            let found = each_place(&units, set, &order, &helped, &mut |moved| {
                if tried >= left {
                    return Ok(None);
                }
                tried += 1;
                if !exact {
                    return straight_step(moved, set, &helped);
                }
                for group in &helped {
                    spaces += 1;
                    let sets = (group.moving, set & !group.moving);
                    if let Leaves::By(way) = leaves(&moved.units, sets, progress)?
                        && let Some(step) = way.step(&moved.units, progress)?
                    {
                        return Ok(Some((group.moving, step)));
                    }
                }
                Ok(None)
            })?;
            self.spaces += spaces;
            self.places += tried;
            left -= tried;
            if let Some((moved, (moving, step))) = found {
                let sets = (moving, set & !moving);
                let mut spaces = 0;
                let (moved, step) =
                    wider(&units, set, moving, (moved, step), &mut |moved, like| {
                        let step = leaves_straight_like(&moved.units, sets, like)?;
                        if step.is_some() || !exact {
                            return Ok(step);
                        }
                        spaces += 1;
                        match leaves(&moved.units, sets, progress)? {
                            Leaves::By(way) => way.step(&moved.units, progress),
                            _ => Ok(None),
                        }
                    })?;
                self.spaces += spaces;
                let mut steps = moved.steps;
                steps.push(step);
                self.go_on_with(moved.units, &order);
                return Ok(Some((moving, steps)));
            }
        }
        Ok(None)
    }

    /// Sets that would leave a set if some units were absent: on straight paths, or by contact spaces.
    fn helped(
        &mut self,
        set: Set,
        order: &[usize],
        exact: bool,
    ) -> Result<Vec<Helped>, AssemblyError> {
        let makes_room = order.iter().fold(0, |all: Set, u| all | 1 << u);
        let rest = set & !makes_room;
        let still = self.units.still & rest;
        let mut helped = Vec::new();
        for u in members(rest & !still) {
            let (moving, others): (Set, Set) = (1 << u, rest & !(1 << u));
            if others == 0 || self.is_held_in(moving, set) {
                continue;
            }
            let group = Helped::new(&self.units, moving, others)?;
            if group.is_straight() && !exact
                || exact && (group.is_straight() || self.way(moving, others)?.is_some())
            {
                helped.push(group);
            }
        }
        if !exact && let Some(blocking) = &self.blocking {
            for moving in blocking.groups(rest, still) {
                let others = rest & !moving;
                if moving.count_ones() > 1 && others != 0 {
                    let group = Helped::new(&self.units, moving, others)?;
                    if group.is_straight() {
                        helped.push(group);
                    }
                }
            }
        }
        Ok(helped)
    }

    /// Whether a unit is held by another of a set, however all others move.
    fn is_held_in(&self, unit: Set, set: Set) -> bool {
        (self.enclosed.iter()).any(|(a, b, _)| {
            let two = a | b;
            a.count_ones() == 1 && b.count_ones() == 1 && two & unit != 0 && two & !set == 0
        })
    }

    /// Goes on with some units elsewhere. What one of two encloses it still does, for it has moved without contact.
    fn go_on_with(&mut self, units: Units, moved: &[usize]) {
        self.units = units;
        self.blocking = None;
        let moved = moved.iter().fold(0, |all: Set, u| all | 1 << u);
        let stays = |a: Set, b: Set| (a | b) & moved == 0;
        (self.enclosed)
            .retain(|(a, b, _)| stays(*a, *b) || a.count_ones() == 1 && b.count_ones() == 1);
        self.unsure.retain(|&(a, b)| stays(a, b));
    }

    /// Asks of every two units of a set: two that hold each other answer for many groups.
    fn pairs(&mut self, set: Set) -> Result<(), AssemblyError> {
        for a in members(set) {
            for b in members(set).filter(|&b| b > a) {
                let (a, b): (Set, Set) = (1 << a, 1 << b);
                // What never goes out is what the other would leave.
                match (a & self.units.still != 0, b & self.units.still != 0) {
                    (true, true) => continue,
                    (false, true) => self.step(a, b)?,
                    _ => self.step(b, a)?,
                };
            }
        }
        Ok(())
    }

    /// The smallest set within one that does not come apart of which no part leaves the others as they are.
    fn smallest(&mut self, set: Set) -> Result<Set, AssemblyError> {
        let mut within = subsets(set);
        within.sort_by_key(|s| (s.count_ones(), *s));
        'next: for part in within {
            if part.count_ones() < 2 || part & !self.units.still == 0 {
                continue;
            }
            for moving in divisions(part, self.units.still & part) {
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
        if self.is_known(moving, staying) {
            return Ok(None);
        }
        if let Some(step) = leaves_straight(&self.units, (moving, staying))? {
            return Ok(Some(step));
        }
        let Some(way) = self.way(moving, staying)? else {
            return Ok(None);
        };
        let step = way.step(&self.units, self.progress)?;
        if step.is_none() {
            self.unsure.push((moving, staying));
        }
        Ok(step)
    }

    /// Whether it is known that one set cannot be taken out of another, or that this cannot be known.
    fn is_known(&self, moving: Set, staying: Set) -> bool {
        let holds = |a: Set, b: Set| a & !moving == 0 && b & !staying == 0;
        (self.enclosed.iter()).any(|&(a, b, _)| holds(a, b) || holds(b, a))
            || self.unsure.contains(&(moving, staying))
    }

    /// Whether one set can be taken out of another, by their contact space.
    fn way(&mut self, moving: Set, staying: Set) -> Result<Option<Box<Way>>, AssemblyError> {
        if self.is_known(moving, staying) {
            return Ok(None);
        }
        self.spaces += 1;
        match leaves(&self.units, (moving, staying), self.progress)? {
            Leaves::By(way) => return Ok(Some(way)),
            Leaves::Not(why) => self.enclosed.push((moving, staying, *why)),
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
