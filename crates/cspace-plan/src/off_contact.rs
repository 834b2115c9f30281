//! Off a contact, into free space.
//!
//! A path that starts in contact has no clearance there. On its first leg the clearance rises to what the path has from then on:
//!
//! ```text
//!   clearance                      at a share s of the leg it is at least s/2 of that at the end
//!      ^      ____ the rest of the path
//!      |    /
//!      |  /    the leg off the contact
//!      +/-------> along the path
//! ```
//!
//! So a leg that rises a little, passes a narrow place and rises again is none that leaves a contact. Off features that touch from opposite
//! sides, as pegs beside a disc, the clearance grows with the square of the distance: s²/2 will do where that gives far more.

use cspace::{Coordinates, PairSpace, QueryError};

use crate::legs::{Coords, Near, Scene};
use crate::push::{Climb, rise};
use crate::route::along;

/// Legs are at most this share of the parts' size.
const LONGEST: f64 = 0.25;
/// And down to this share of it: below lies what rounding does to contacts.
const SHORTEST: f64 = 1e-13;
/// The length of the best leg is found to (2/3)⁶⁴ of it.
const REFINED: u32 = 64;
/// Contacts within so many resolutions are left together.
const TOUCHING: f64 = 8.0;
/// The leg is tested from this share of it on; before, it goes where all contact functions grow.
const FIRST: f64 = 1e-3;
/// There the clearance is at least this share of what an even rise would give; up to the end half of that.
const BEGINS: f64 = 0.1;
const RISES: f64 = 0.5;
/// Contacts are off by this share of the parts' size where only the parts are known, and a clearance is the same within this share.
const TOUCHED: f64 = 1e-9;
const SAME: f64 = 0.02;
/// How a clearance grows off a contact.
#[derive(Debug, Clone, Copy)]
enum Rise {
    /// With the distance.
    Even,
    /// With its square.
    Square,
}

/// Clearance of so many times another is far more: a narrow place on a leg that rises as the square has an eighth.
const FAR_MORE: f64 = 16.0;
/// A leg that leaves a contact for good, and does not go along it, has at least this sine with it.
const STEEP: f64 = 0.5;
/// The end of a leg is moved to more clearance at most so often, each time by this share or more.
const MOVES: usize = 64;
const GAIN: f64 = 1e-4;

/// The contacts of a configuration, and the legs that leave them.
#[derive(Debug, Clone)]
pub(crate) struct Contacts<'a> {
    scene: &'a Scene,
    at: Coords,
    /// All begin at no distance: their gradients determine where they lead.
    touching: Vec<Near>,
    resolution: f64,
}

impl<'a> Contacts<'a> {
    /// The contacts of a configuration.
    pub(crate) fn of(
        space: &PairSpace,
        scene: &'a Scene,
        at: Coordinates,
    ) -> Result<Self, QueryError> {
        let resolution = space.resolution();
        let numbers = scene.numbers(at)?;
        let mut touching = Vec::new();
        for (patch, _) in space.contacts(at, TOUCHING * resolution)? {
            let patch = space.patch(patch)?;
            let value = patch.contact()?.evaluate(at)?;
            let (fixed, moving) = patch.features()?;
            let gradient = scene.by_numbers(value.gradient, numbers);
            touching.push(Near::growing(gradient, (fixed.name, moving.name)));
        }
        Ok(Self {
            scene,
            at: numbers,
            touching,
            resolution,
        })
    }

    /// A free configuration, with the leg to it free but for its start: of those tried the nearest with enough clearance, or the one with
    /// the most. `None` if there is none nearby: the contacts leave no room, to the resolution.
    pub(crate) fn off(&self, enough: f64) -> Option<Coords> {
        let even = self.off_as(enough, Rise::Even);
        let found = |at: Option<Coords>| at.map_or(0.0, |at| self.scene.clearance(at));
        if found(even) >= enough {
            return even;
        }
        let square = self.off_as(enough, Rise::Square);
        match found(square) > FAR_MORE * found(even) {
            true => square,
            false => even,
        }
    }

    fn off_as(&self, enough: f64, kind: Rise) -> Option<Coords> {
        let [x, y, turn] = self.scene.levers();
        let off = |levers: Coords| {
            let direction = rise(&self.touching, levers, None, 1.0)?;
            // Lengths are those by which the part moves, if it does.
            let moved = direction[0].hypot(direction[1]);
            let long = match self.scene.motions().is_none() && moved > 0.0 {
                true => moved,
                false => self.scene.long([0.0; 3], direction),
            };
            let ahead = |length: f64| self.ahead(direction, length / long);
            let passes = |to: Coords, clearance: f64| self.is_left(to, clearance, 0.0, kind);
            let longest = LONGEST * self.scene.size();
            let (clearance, at) = widest(self.scene, longest, enough, ahead, passes)?;
            let mut climb = Climb {
                at,
                clearance,
                reach: longest,
            };
            let steeper = |to: Coords, clearance: f64| {
                self.is_left(to, clearance, STEEP, kind) && !self.scene.overlaps(to)
            };
            for _ in 0..MOVES {
                if climb.clearance >= enough || !climb.step(self.scene, levers, None, GAIN, steeper)
                {
                    break;
                }
                climb.reach = climb.reach.min(longest);
            }
            Some(climb.at)
        };
        // Without a turn where that leaves all contacts.
        off([x, y, 0.0]).or_else(|| off([x, y, turn]))
    }

    /// Whether a leg goes away from the contacts, its clearance rises to a given one as fast as they let it, and is no less from then on.
    pub(crate) fn leaves_with(&self, to: Coords, clearance: f64) -> bool {
        let there = self.scene.clearance(to);
        let by = core::array::from_fn(|k| to[k] - self.at[k]);
        let share = clearance / (STEEP * self.scene.long(self.at, to));
        there > clearance
            && share < 1.0
            && self.grows(by, STEEP)
            && self.scene.is_apart(self.ahead(by, share), to, clearance)
            && self.rises(by, share, clearance, Rise::Even)
            && !self.scene.overlaps(to)
    }

    /// Whether a leg to a configuration with a clearance goes away from all contacts with at least a sine, and its clearance rises.
    fn is_left(&self, to: Coords, clearance: f64, sine: f64, kind: Rise) -> bool {
        let by: Coords = core::array::from_fn(|k| to[k] - self.at[k]);
        clearance > 2.0 * TOUCHING * self.resolution
            && self.grows(by, sine)
            && self.rises(by, 1.0, clearance, kind)
    }

    /// Whether all contact functions grow in a direction, by more than a share of its length.
    fn grows(&self, by: Coords, sine: f64) -> bool {
        let long = self.scene.long([0.0; 3], by);
        self.touching.iter().all(|near| {
            let rate: f64 = (0..3).map(|k| near.gradient[k] * by[k]).sum();
            rate > sine * long
        })
    }

    /// Whether the clearance rises to a given one up to a share of a leg.
    fn rises(&self, by: Coords, share: f64, clearance: f64, kind: Rise) -> bool {
        let ahead = |part: f64| self.ahead(by, share * part);
        rises(
            self.scene,
            ahead,
            (clearance, kind),
            TOUCHING * self.resolution,
        )
    }

    pub(crate) fn scene(&self) -> &'a Scene {
        self.scene
    }

    fn ahead(&self, direction: Coords, step: f64) -> Coords {
        let ahead = core::array::from_fn(|k| self.at[k] + direction[k] * step);
        self.scene.within_limits(ahead)
    }
}

/// Whether the clearance rises from nothing to a given one along a leg, but for what contacts are off.
fn rises(
    scene: &Scene,
    ahead: impl Fn(f64) -> Coords,
    (clearance, kind): (f64, Rise),
    off: f64,
) -> bool {
    let mut hi = 1.0;
    while hi > FIRST {
        let lo = 0.5 * hi;
        let share = match kind {
            Rise::Even => lo,
            Rise::Square => lo * lo,
        };
        let risen = RISES * share * clearance - off;
        let least = risen.max(BEGINS * FIRST * clearance);
        if !scene.is_apart(ahead(lo), ahead(hi), least) {
            return false;
        }
        hi = lo;
    }
    true
}

/// A path without the part of its first leg on which the clearance rises off a contact, and of its last on which it falls to one: the
/// places between which its clearance counts.
///
/// On a rise the clearance at a share s of it is at least s/2 of that at its end, and no place after it has less than that end.
///
/// ```
/// use cspace::Part;
/// use cspace_plan::{legs::Scene, off_contacts};
/// // A peg that stands at the bottom of a hole 10 deep, with a play of 0.1 at both sides, is lifted by 20.
/// let hole = Part::polygon("hole", &[
///     (-5.0, -1.0), (5.0, -1.0), (5.0, 10.0), (1.1, 10.0), (1.1, 0.0), (-1.1, 0.0), (-1.1, 10.0), (-5.0, 10.0),
/// ])?;
/// let peg = Part::rectangle("peg", (0.0, 8.0), 2.0, 16.0)?;
/// let scene = Scene::new(&hole, &peg, None);
/// let rest = off_contacts(&scene, &[[0.0, 0.0, 0.0], [0.0, 20.0, 0.0]], (true, false));
/// assert!((scene.least(rest[0], rest[1]).distance - 0.1).abs() < 1e-9);
/// # Ok::<(), cspace::PartError>(())
/// ```
pub fn off_contacts(scene: &Scene, path: &[Coords], (from, to): (bool, bool)) -> Vec<Coords> {
    let mut places = path.to_vec();
    if let (&[a, b], true, true) = (path, from, to) {
        places.insert(1, along(a, b, 0.5));
    }
    if let (true, &[a, b, ..]) = (from, &places[..]) {
        places[0] = rise_ends(scene, a, b);
    }
    if let (true, &[.., b, a]) = (to, &places[..]) {
        let last = places.len() - 1;
        places[last] = rise_ends(scene, a, b);
    }
    places.dedup();
    places
}

/// Where on a leg from a contact the clearance has risen to what it has from there on.
fn rise_ends(scene: &Scene, from: Coords, to: Coords) -> Coords {
    const HALVINGS: i32 = 44;
    let off = TOUCHED * scene.size() + scene.rounding(from, to);
    let ends = |kind: Rise| {
        (0..HALVINGS).find_map(|k| {
            let share = 0.5f64.powi(k);
            let ahead = |part: f64| along(from, to, share * part);
            let clearance = scene.least_roughly(ahead(1.0), to).distance;
            let rises = rises(scene, ahead, (clearance * (1.0 - SAME), kind), off);
            (clearance > 0.0 && rises).then(|| (clearance, ahead(1.0)))
        })
    };
    let (even, square) = (ends(Rise::Even), ends(Rise::Square));
    let clearance = |end: Option<(f64, Coords)>| end.map_or(0.0, |e| e.0);
    let chosen = match clearance(square) > FAR_MORE * clearance(even) {
        true => square,
        false => even,
    };
    chosen.map_or(from, |e| e.1)
}

/// The end of a leg of a round length, with its clearance: of the shortest that passes with enough of it. If none has enough, the end with
/// the most clearance of these and of others about as long.
fn widest(
    scene: &Scene,
    longest: f64,
    enough: f64,
    ahead: impl Fn(f64) -> Coords,
    passes: impl Fn(Coords, f64) -> bool,
) -> Option<(f64, Coords)> {
    type Best = Option<(f64, Coords, f64)>;
    let look = |best: &mut Best, length: f64| {
        let to = ahead(length);
        let clearance = scene.clearance(to);
        if best.is_none_or(|b| clearance > b.0) && passes(to, clearance) && !scene.overlaps(to) {
            *best = Some((clearance, to, length));
        }
        clearance
    };
    let mut best = None;
    for length in round_lengths(SHORTEST * longest, longest) {
        look(&mut best, length);
        if best.is_some_and(|b| b.0 >= enough) {
            return best.map(|b| (b.0, b.1));
        }
    }
    // Between the best and its neighbours, by trisection.
    let (_, _, length) = best?;
    let (mut lo, mut hi) = (0.5 * length, (2.0 * length).min(longest));
    for _ in 0..REFINED {
        let third = (hi - lo) / 3.0;
        if look(&mut best, lo + third) < look(&mut best, hi - third) {
            lo += third;
        } else {
            hi -= third;
        }
    }
    best.map(|b| (b.0, b.1))
}

/// Lengths of one digit, 1, 2 and 5, between two.
fn round_lengths(shortest: f64, longest: f64) -> impl Iterator<Item = f64> {
    let decades = [shortest, longest].map(|l| l.log10().floor());
    let decades = if decades.iter().all(|d| d.is_finite()) {
        decades.map(|d| d as i32)
    } else {
        [0, -1]
    };
    (decades[0]..=decades[1])
        .flat_map(|k| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(k)))
        .filter(move |l| (shortest..=longest).contains(l))
}

/// Clearance of less than this share of the parts' size is little.
const LITTLE: f64 = 1e-3;

/// From a free configuration with little clearance the end of a free leg to one with more, if there is one nearby; else itself.
pub(crate) fn off_near(scene: &Scene, at: Coords) -> Coords {
    let clearance = scene.clearance(at);
    let little = LITTLE * scene.size();
    if clearance > little {
        return at;
    }
    let near = scene.near(at, clearance + little);
    let Some(direction) = rise(&near, scene.levers(), None, 1.0) else {
        return at;
    };
    let length = scene.long([0.0; 3], direction);
    let ahead = |step: f64| -> Coords {
        scene.within_limits(core::array::from_fn(|k| {
            at[k] + direction[k] * step / length
        }))
    };
    let longest = LONGEST * scene.size();
    let best = widest(scene, longest, f64::INFINITY, ahead, |to, there| {
        // Rounding leaves nothing of the clearance at the start.
        let ahead = |part: f64| along(at, to, part);
        there > clearance && rises(scene, ahead, (there, Rise::Even), 0.0)
    });
    best.map_or(at, |b| b.1)
}
