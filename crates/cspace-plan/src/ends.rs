//! Where a path begins or ends.

use core::f64::consts::TAU;

use cspace::{Configuration, Coordinates, Location, PairSpace, QueryError, RegionId};

use crate::legs::{Coords, Scene};
use crate::off_contact::Contacts;

/// Ways begin no farther than so many sizes from the fixed part, to be rounded as little as the parts are. From farther away a leg
/// comes straight there: nothing is in the way.
const FAR: f64 = 16.0;

/// Beyond so many sizes nothing is planned: a coordinate is rounded by more than 10⁻⁷ of the size there.
pub(crate) const FARTHEST: f64 = 1e9;

/// Whether a coordinate that is a length is so large that it is not known where the parts are to each other.
pub(crate) fn is_far(scene: &Scene, at: Coords) -> bool {
    (0..3).any(|k| scene.is_length(k) && at[k].abs() > FARTHEST * scene.size())
}

/// Off a contact, clearance of this share of the parts' size is enough to begin with.
pub(crate) const ENOUGH: f64 = 0.1;

/// Where a path begins or ends.
pub(crate) enum End<'a> {
    /// In a region; a configuration in contact, or far away, is left by a leg.
    Free {
        region: RegionId,
        leg: Option<Coords>,
        contacts: Option<Contacts<'a>>,
    },
    Blocked,
}

/// The start or the goal of a path, and the place near it from which the path is sought.
pub(crate) struct Tip<'a> {
    pub(crate) at: Coords,
    pub(crate) near: Coords,
    region: Option<RegionId>,
    pub(crate) contacts: Option<Contacts<'a>>,
}

impl<'a> Tip<'a> {
    pub(crate) fn of(end: End<'a>, at: Coords) -> Self {
        let (leg, contacts, region) = match end {
            End::Free {
                leg,
                contacts,
                region,
            } => (leg, contacts, Some(region)),
            End::Blocked => (None, None, None),
        };
        Self {
            region,
            at,
            near: leg.unwrap_or(at),
            contacts,
        }
    }

    /// The end of another leg off the contacts, in the same region, with enough clearance or as much as is found.
    fn off(&self, space: &PairSpace, enough: f64) -> Option<Coords> {
        let contacts = self.contacts.as_ref()?;
        let near = contacts.off(enough)?;
        match space.locate(contacts.scene().coordinates(near)) {
            Ok(Location::Free(region)) if Some(region) == self.region => Some(near),
            _ => None,
        }
    }

    /// Goes off the contacts as far as there is enough clearance; whether there is more than before.
    pub(crate) fn go_on(&mut self, space: &PairSpace, enough: f64) -> bool {
        /// By less it is no more.
        const MORE: f64 = 1.01;
        let Some((near, contacts)) = self.off(space, enough).zip(self.contacts.as_ref()) else {
            return false;
        };
        let clearance = |at: Coords| contacts.scene().clearance(at);
        let is_more = clearance(near) > MORE * clearance(self.near);
        if is_more {
            self.near = near;
        }
        is_more
    }

    /// Comes back to where the clearance is just a given one: the place from which the path to the former end of the leg goes on.
    pub(crate) fn come_back(&mut self, space: &PairSpace, clearance: f64) -> bool {
        /// More clearance than asked for, for the path to begin in.
        const MORE: f64 = 1.05;
        let Some((near, contacts)) =
            (self.off(space, MORE * clearance)).zip(self.contacts.as_ref())
        else {
            return false;
        };
        let scene = contacts.scene();
        let is_nearer = near != self.near
            && scene.clearance(near) > clearance
            && scene.is_clearly_apart(near, self.near, clearance);
        if is_nearer {
            self.near = near;
        }
        is_nearer
    }

    /// Puts the leg from here before the places of a path from the end of that leg. The leg goes to the farthest of them to which it
    /// leaves the contacts with a clearance, if one is given.
    pub(crate) fn join(&self, places: &mut Vec<Coords>, at: Coords, clearance: Option<f64>) {
        if self.near == self.at {
            return;
        }
        // Numbers of places are by the turn that they are in.
        let by: Coords = core::array::from_fn(|k| self.at[k] - at[k]);
        let leaves = |to: &Coords| {
            (self.contacts.as_ref().zip(clearance)).is_some_and(|(contacts, clearance)| {
                contacts.leaves_with(core::array::from_fn(|k| to[k] + by[k]), clearance)
            })
        };
        let skipped = (1..places.len()).rev().find(|&k| leaves(&places[k]));
        if let Some(k) = skipped {
            places.drain(..k);
        } else if let [first, second, ..] = places[..]
            && are_one([at, first, second])
        {
            places.remove(0);
        }
        places.insert(0, at);
    }
}

/// Whether two legs change the same coordinate alone: they are one leg without rounding, and if the second goes back it passes no place
/// that the two do not pass.
fn are_one([a, b, c]: [Coords; 3]) -> bool {
    let changes = |k: &usize| a[*k] != b[*k] || b[*k] != c[*k];
    (0..3).filter(changes).count() == 1
}

/// Locates a start or a goal in the space. The leg that leaves a contact goes to where there is enough clearance, or as much as is found.
pub(crate) fn end<'a>(
    space: &PairSpace,
    scene: &'a Scene,
    at: Coordinates,
    enough: f64,
) -> Result<End<'a>, QueryError> {
    Ok(match space.locate(at)? {
        Location::Outside => return Err(QueryError::Outside),
        Location::Free(region) => End::Free {
            region,
            leg: nearer(space, scene, scene.numbers(at)?),
            contacts: None,
        },
        Location::Blocked => End::Blocked,
        Location::Contact => {
            let contacts = Contacts::of(space, scene, at)?;
            let Some(off) = contacts.off(enough) else {
                return Ok(End::Blocked);
            };
            match space.locate(scene.coordinates(off))? {
                Location::Free(region) => End::Free {
                    region,
                    leg: Some(off),
                    contacts: Some(contacts),
                },
                _ => End::Blocked,
            }
        }
    })
}

/// A configuration of a window by the window's own numbers, and the turns that are added.
pub(crate) fn home(space: &PairSpace, scene: &Scene, at: Coordinates) -> (f64, Coordinates) {
    let (lo, hi) = scene.limits()[2];
    match (space, at) {
        (PairSpace::Planar(_), Coordinates::Planar(c))
            if lo.is_finite() && !(lo..=hi).contains(&c.theta) =>
        {
            let turns = ((lo - c.theta) / TAU).ceil();
            (turns, turned(at, turns))
        }
        _ => (0.0, at),
    }
}

/// Where a planar part comes to from far away on a straight leg, with its orientation.
fn nearer(space: &PairSpace, scene: &Scene, at: Coords) -> Option<Coords> {
    if !matches!(space, PairSpace::Planar(_)) {
        return None;
    }
    // What is far from its own origin turns about it: the parts are where their middles are.
    let (fixed, moving) = (space.fixed().bounds(), space.moving().bounds());
    let Coordinates::Planar(here) = scene.coordinates(at) else {
        return None;
    };
    let way = here.fixed_from_moving(moving.center()) - fixed.center();
    let near = FAR * scene.size();
    (way.length() > 2.0 * near).then(|| {
        let by = way * (near / way.length() - 1.0);
        [at[0] + by.x, at[1] + by.y, at[2]]
    })
}

/// A configuration with whole turns added to its orientation.
pub(crate) fn turned(at: Coordinates, turns: f64) -> Coordinates {
    match at {
        Coordinates::Planar(c) if turns != 0.0 => {
            Coordinates::Planar(Configuration::new(c.x, c.y, c.theta + TAU * turns))
        }
        _ => at,
    }
}
