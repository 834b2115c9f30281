//! The answer about two parts on axes over their ranges.

use cspace::{Options, PairError, Relation};
use cspace_model::Compute;

use crate::legs::Scene;

use super::answer::{Held, Verdict};
use super::descent::coords;
use super::free::Free;
use super::pair::Pair;
use super::reach::touching;
use super::region::bounding;

impl Pair<'_> {
    /// Finds what the parts, which do not overlap where they are, are to each other over all motions that their ranges allow; spaces come
    /// from `compute`. A smallest gap of `within` or more is not looked for.
    ///
    /// # Errors
    /// Errors of `compute`.
    pub fn over_ranges(&self, within: f64, compute: &Compute<'_>) -> Result<Verdict, PairError> {
        let [fixed, moving] = self.axes;
        let relation = Relation::Axes { fixed, moving };
        let [a, b] = self.parts;
        let drawn = compute(a, b, relation, &Options::default())?;
        let free = match Free::of(&drawn, self.place, compute)? {
            Ok(free) => free,
            Err(why) => return Ok(Verdict::Undecided(why)),
        };
        match free.is_bounded() {
            false => free.smallest(within, compute),
            true => self.held(&free, compute).map(Verdict::Touches),
        }
    }

    fn held(&self, free: &Free<'_>, compute: &Compute<'_>) -> Result<Held, PairError> {
        let (space, regions) = (&*free.space, &free.regions[..]);
        let stopped = free.stops();
        let mesh = free.mesh(compute)?;
        let backlash = match &mesh {
            Some(mesh) => mesh.backlash()?,
            None => None,
        };
        let place = (self.place[0], self.place[1]);
        let nearest = || space.nearest_contact(place.0, place.1).map(|n| n.at);
        let at = match stopped.first() {
            Some(stop) => Some(stop.at),
            None if free.room.is_some() => Some(place),
            None => nearest().or_else(|| Some(bounding(space, regions).next()?.start)),
        };
        let scene = || Scene::new(self.parts[0], self.parts[1], Some(space.axes()));
        let points = at.and_then(|(u, v)| Some(scene().nearest_places(coords([u, v]))?.1));
        Ok(Held {
            room: free.room,
            points: points.map(|(p, q)| [p, q]),
            reach: free.reach(),
            ratio: mesh.map(|m| m.ratio()),
            backlash,
            features: at.map_or(Vec::new(), |at| touching(space, at, regions)),
            at,
            stopped,
        })
    }
}
