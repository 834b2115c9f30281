//! One step along the surface: across above it, and down to it again.

use cspace::{PatchId, QueryError};

use super::ground::{Ground, Stop};
use super::landing::{Landing, land_on, on_surface, value_off};
use super::tolerance::{
    CLEAR, FOLLOWED, FOLLOWED_HELD, LEAST_STEP, LIFT_ROOM, LONGEST_STEP, NEARER, RISE,
    SHORT_OF_CORNER, STEEPEST, TOUCHES,
};
use super::vector::{Vec3, dot, minus, plus, size, times};
use super::ways::{HalfSpace, ways_along};

/// A step that leads nowhere is tried again, shorter by this factor.
const SHORTER: f64 = 0.25;

/// Half-space that a patch, or the end of a coordinate's range, leaves open at a position, to first order.
#[derive(Debug, Clone, Copy)]
pub(super) struct Contact {
    /// `None` for the end of a range.
    pub(super) patch: Option<PatchId>,
    pub(super) space: HalfSpace,
}

/// Half-spaces that some patches and the ends of ranges leave open at a position.
pub(super) fn contacts_at(
    ground: &impl Ground,
    at: Vec3,
    patches: &[PatchId],
) -> Result<Vec<Contact>, QueryError> {
    let mut found = Vec::new();
    for &patch in patches {
        let f = ground.constraint(patch, at)?;
        let steep = size(f.gradient);
        let normal = times(f.gradient, 1.0 / steep);
        if normal.iter().all(|x| x.is_finite()) {
            let room = (f.value / steep).max(0.0);
            let space = HalfSpace { normal, room };
            let patch = Some(patch);
            found.push(Contact { patch, space });
        }
    }
    for (i, limit) in ground.limits().into_iter().enumerate() {
        let Some((lo, hi)) = limit else {
            continue;
        };
        for (room, sign) in [(at[i] - lo, 1.0), (hi - at[i], -1.0)] {
            if room < LONGEST_STEP {
                let normal = core::array::from_fn(|k| if k == i { sign } else { 0.0 });
                let room = room.max(0.0);
                let space = HalfSpace { normal, room };
                found.push(Contact { patch: None, space });
            }
        }
    }
    Ok(found)
}

/// Where a step comes to, if it comes nearer to the goal; otherwise a patch that it runs into, if it does.
pub(super) struct Tried {
    pub(super) next: Option<Vec3>,
    pub(super) met: Option<PatchId>,
}

/// A step that is tried: from where, towards which goal, among which contacts, and which of them hold it.
pub(super) struct Step<'a, G> {
    pub(super) ground: &'a G,
    pub(super) at: Vec3,
    pub(super) to: Vec3,
    pub(super) contacts: &'a [Contact],
    pub(super) held: &'a [&'a Contact],
}

impl<G: Ground> Step<'_, G> {
    /// A step along the surface, or a part of it, that comes nearer to the goal.
    pub(super) fn along(&self, whole: Vec3, tries: usize) -> Result<Tried, QueryError> {
        let most = size(minus(self.to, self.at)) - NEARER * self.ground.contact();
        let is_known = |patch: PatchId| self.contacts.iter().any(|c| c.patch == Some(patch));
        let mut met = None;
        let mut step = whole;
        for _ in 0..tries {
            let length = size(step);
            let mut landed = self.landing(step)?;
            for _ in 0..2 {
                let Some(landing) = landed else {
                    break;
                };
                let next = self.over(&landing)?;
                let by = minus(next.at, self.at);
                let is_step = size(by) >= LEAST_STEP * length && dot(by, step) > 0.0;
                if is_step && size(minus(self.to, next.at)) < most {
                    // Where contacts meet at a small angle, what presses on both is too far into the corner: less far it is not.
                    for share in [1.0, SHORT_OF_CORNER] {
                        let found = plus(self.at, times(by, share));
                        if size(minus(self.to, found)) < most && !self.ground.is_blocked(found) {
                            let next = Some(found);
                            return Ok(Tried { next, met: None });
                        }
                    }
                }
                if let Some(other) = next.stopped.filter(|&p| !is_known(p)) {
                    return Ok(Tried {
                        next: None,
                        met: Some(other),
                    });
                }
                met = met.or(next.stopped);
                // Of surfaces that are all but tangent where the part is another may rise above the one that was followed.
                landed = match next.stopped {
                    Some(other) if !landing.followed.contains(&other) => {
                        land_on(self.ground, plus(self.at, step), length, vec![other])?
                    }
                    _ => None,
                };
            }
            step = times(step, SHORTER);
        }
        Ok(Tried { next: None, met })
    }

    /// Where a step comes down on the surface, and on which patches; `None` if it does not.
    fn landing(&self, step: Vec3) -> Result<Option<Landing>, QueryError> {
        let length = size(step);
        let end = plus(self.at, step);
        let is_close = |c: &Contact| {
            let is_held = self.held.iter().any(|h| core::ptr::eq(*h, c));
            let share = if is_held { FOLLOWED_HELD } else { FOLLOWED };
            let off = dot(c.space.normal, step) + c.space.room;
            off.abs() <= share * length + TOUCHES * self.ground.contact()
        };
        let close = self.contacts.iter().filter(|c| is_close(c));
        let patches: Vec<PatchId> = close.filter_map(|c| c.patch).collect();
        let all = land_on(self.ground, end, length, patches.clone())?;
        if all.is_some() || patches.len() < 2 {
            return Ok(all);
        }
        // Surfaces that are tangent where the part is may part from there on: then one of them is followed.
        let mut lowest: Option<(f64, PatchId)> = None;
        for patch in patches {
            let raised = value_off(self.ground, patch, end)?;
            if lowest.is_none_or(|l| raised < l.0) {
                lowest = Some((raised, patch));
            }
        }
        let followed = lowest.map(|l| l.1).into_iter().collect();
        land_on(self.ground, end, length, followed)
    }

    /// To a place on the surface: off it by as much as it rises between, across, and down to it again. Also which patch was met.
    fn over(&self, landing: &Landing) -> Result<Stop, QueryError> {
        let Landing { goal, followed } = landing;
        let middle = times(plus(self.at, *goal), 0.5);
        let clear = CLEAR * self.ground.contact();
        let mut lift = clear;
        for &patch in followed {
            let value = value_off(self.ground, patch, middle)?;
            lift = lift.max(clear - RISE * value);
        }
        let up = plus(self.at, times(self.off_from(followed, lift), lift));
        let raised = self.ground.advance(self.at, up)?;
        let beyond = plus(*goal, minus(raised.at, self.at));
        let across = self.ground.advance(raised.at, beyond)?;
        let down = on_surface(self.ground, across.at, followed)?.unwrap_or(*goal);
        // What is followed stops a step that is not lifted enough: then it counts what has stopped the lift.
        let is_followed = across.stopped.is_some_and(|p| followed.contains(&p));
        let stopped = if is_followed {
            raised.stopped.or(across.stopped)
        } else {
            across.stopped.or(raised.stopped)
        };
        let at = self.ground.advance(across.at, down)?.at;
        Ok(Stop { at, stopped })
    }

    /// The direction of a lift: the shortest vector with a product of at least 1 with the normal of each contact followed, and of at least
    /// 0 with those of contacts that the lift may come to. Zero if there is none.
    fn off_from(&self, followed: &[PatchId], lift: f64) -> Vec3 {
        let is_followed = |c: &Contact| c.patch.is_some_and(|p| followed.contains(&p));
        let near = (self.contacts.iter())
            .filter(|c| is_followed(c) || c.space.room <= LIFT_ROOM * lift)
            .map(|c| HalfSpace {
                normal: c.space.normal,
                room: if is_followed(c) { -1.0 } else { 0.0 },
            });
        let near: Vec<HalfSpace> = near.collect();
        let zero = [0.0; 3];
        let way = ways_along(zero, &near).into_iter().find(|w| w.allowed);
        way.map(|w| w.by)
            .filter(|by| size(*by) < STEEPEST)
            .unwrap_or(zero)
    }
}
