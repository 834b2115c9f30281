//! Room that is made for others: parts on axes are moved along these, others straight, so that something leaves.
//!
//! Only what would leave if some units were not there can leave once these have moved. So this is asked first, of one unit, then of two,
//! and of three on axes (a bar before two doors), and then places of these units are tried: those just past where they are clear of the
//! straight ways of what leaves, and those at shares of where they get to.

use crate::legs::Scene;
use crate::out::Exit;

use super::answer::Step;
use super::error::AssemblyError;
use super::exact::leaves_straight;
use super::travel::Travel;
use super::units::{Set, Units, members};
use super::way_out::{along, straight};

/// So many units are moved aside at a time, at most; and so many that are on axes.
const TOGETHER: usize = 2;
const ON_AXES: usize = 3;
/// Along each way a unit is looked for in so many places.
const PLACES: u32 = 24;
/// The place just past where it is clear is known to 1/2 to the power of this of the way between two.
const HALVINGS: u32 = 40;
/// The ends of a way, and shares of it.
const SHARES: [f64; 4] = [1.0, 0.5, 0.25, 0.75];
/// So many straight ways of what leaves are kept clear, each by itself.
const EXITS: usize = 6;

/// Units elsewhere, by these steps.
#[derive(Debug, Clone)]
pub(super) struct Moved {
    pub(super) units: Units,
    pub(super) steps: Vec<Step>,
    /// The way of each step, and how far it goes.
    pub(super) went: Vec<(Travel, f64)>,
}

impl Moved {
    /// Where the units are.
    pub(super) fn none(units: &Units) -> Self {
        Self {
            units: units.clone(),
            steps: Vec::new(),
            went: Vec::new(),
        }
    }

    /// Then one more within a set.
    pub(super) fn then(&self, set: Set, travel: Travel, to: f64) -> Result<Self, AssemblyError> {
        let mut steps = self.steps.clone();
        steps.push(travel.step(&self.units, set, to));
        let units = travel.to(&self.units, to)?;
        let mut went = self.went.clone();
        went.push((travel, to));
        Ok(Self { units, steps, went })
    }
}

/// A set that leaves if others make room, with its straight paths out of those that do not.
pub(super) struct Helped {
    pub(super) moving: Set,
    exits: Vec<Exit>,
}

impl Helped {
    /// Straight ways out for a group that leaves the others.
    pub(super) fn new(units: &Units, moving: Set, others: Set) -> Result<Self, AssemblyError> {
        let (fixed, mover) = (units.together(others)?, units.together(moving)?);
        // It has to come beside what makes room, too, wherever that is then.
        let farther = |exit: Exit| Exit {
            distance: exit.distance + units.reach(),
            ..exit
        };
        Ok(Self {
            moving,
            exits: straight(&fixed, &mover).take(EXITS).map(farther).collect(),
        })
    }

    pub(super) fn is_straight(&self) -> bool {
        !self.exits.is_empty()
    }
}

/// How many units are moved aside at a time.
pub(super) fn together(units: &Units) -> usize {
    let on_axes = units.axes.iter().flatten().count();
    if on_axes < ON_AXES { TOGETHER } else { ON_AXES }
}

/// The sets of one and two units that may make room, those on axes first, and of three on axes.
pub(super) fn choices(units: &Units, set: Set) -> Vec<Vec<usize>> {
    let on_axis = |u: &usize| units.axes[*u].is_some();
    let mut able: Vec<usize> = members(set)
        .filter(|u| on_axis(u) || units.still >> u & 1 == 0)
        .collect();
    able.sort_by_key(|u| (!on_axis(u), *u));
    let mut all: Vec<Vec<usize>> = able.iter().map(|&u| vec![u]).collect();
    for &a in &able {
        all.extend(able.iter().filter(|&&b| b != a).map(|&b| vec![a, b]));
    }
    able.retain(on_axis);
    for &a in &able {
        for &b in able.iter().filter(|&&b| b != a) {
            let others = able.iter().filter(|&&c| c != a && c != b);
            all.extend(others.map(|&c| vec![a, b, c]));
        }
    }
    all
}

/// Places of units, moved in this order within a set, at which something may leave: each is told, until one is taken.
pub(super) fn each_place<T>(
    units: &Units,
    set: Set,
    order: &[usize],
    helped: &[Helped],
    taken: &mut dyn FnMut(&Moved) -> Result<Option<T>, AssemblyError>,
) -> Result<Option<(Moved, T)>, AssemblyError> {
    further(Moved::none(units), set, order, helped, taken)
}

fn further<T>(
    so_far: Moved,
    set: Set,
    order: &[usize],
    helped: &[Helped],
    taken: &mut dyn FnMut(&Moved) -> Result<Option<T>, AssemblyError>,
) -> Result<Option<(Moved, T)>, AssemblyError> {
    let Some((&unit, later)) = order.split_first() else {
        return Ok(taken(&so_far)?.map(|found| (so_far, found)));
    };
    for travel in Travel::all(&so_far.units, set, unit)? {
        for to in places(&so_far.units, &travel, helped)? {
            let next = so_far.then(set, travel.clone(), to)?;
            if let Some(found) = further(next, set, later, helped, taken)? {
                return Ok(Some(found));
            }
        }
    }
    Ok(None)
}

/// Where a unit is tried along its way.
fn places(units: &Units, travel: &Travel, helped: &[Helped]) -> Result<Vec<f64>, AssemblyError> {
    let mut found: Vec<f64> = Vec::new();
    for group in helped.iter().filter(|h| h.moving >> travel.unit & 1 == 0) {
        let mover = units.together(group.moving)?;
        for &exit in &group.exits {
            found.extend(just_clear(travel, &mover, exit)?);
        }
    }
    // What moves least is tried first.
    found.sort_by(|a, b| (a - travel.from).abs().total_cmp(&(b - travel.from).abs()));
    for share in SHARES {
        for end in [travel.free.1, travel.free.0] {
            found.push(travel.from + share * (end - travel.from));
        }
    }
    let mut places: Vec<f64> = Vec::new();
    for to in found {
        let is_new = places.iter().all(|&p| travel.differ(p, to));
        if travel.moves(to) && is_new {
            places.push(to);
        }
    }
    Ok(places)
}

/// Just past where a unit is clear of a straight way of others, to either side.
fn just_clear(
    travel: &Travel,
    mover: &cspace::Part,
    exit: Exit,
) -> Result<Vec<f64>, AssemblyError> {
    let is_clear = |to: f64| -> Result<bool, AssemblyError> {
        let there = travel.part_at(to)?;
        Ok(Scene::new(&there, mover, None).is_apart([0.0; 3], along(exit), 0.0))
    };
    let mut found = Vec::new();
    for end in [travel.free.1, travel.free.0] {
        let at = |k: f64| travel.from + (end - travel.from) * k;
        if !travel.moves(end) {
            continue;
        }
        for k in 1..=PLACES {
            let (before, here) = (f64::from(k - 1), f64::from(k));
            let [mut before, mut here] = [before, here].map(|k| at(k / f64::from(PLACES)));
            if !is_clear(here)? {
                continue;
            }
            if k > 1 || !is_clear(before)? {
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (before + here);
                    if is_clear(middle)? {
                        here = middle;
                    } else {
                        before = middle;
                    }
                }
                let past = travel.beyond(here);
                found.push(if is_clear(past)? { past } else { here });
            }
            break;
        }
    }
    Ok(found)
}

/// First step by which a set leaves on a straight path after others have made room.
pub(super) fn straight_step(
    moved: &Moved,
    set: Set,
    helped: &[Helped],
) -> Result<Option<(Set, Step)>, AssemblyError> {
    for group in helped.iter().filter(|h| h.is_straight()) {
        let staying = set & !group.moving;
        if let Some(step) = leaves_straight(&moved.units, (group.moving, staying))? {
            return Ok(Some((group.moving, step)));
        }
    }
    Ok(None)
}
