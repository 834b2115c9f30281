//! Queries to the configuration space of a pair of any class.

use crate::fixed_axes::AxesMotionOutcome;
use crate::geometry::Vector;
use crate::query::{Classification, MotionOutcome};

use super::answers::{Neighbours, PairContact, PairCrossing, PairMotion, PairNearest, QueryError};
use super::ids::PatchId;
use super::patch::PairPatch;
use super::relation::Coordinates;
use super::space::PairSpace;

impl PairSpace {
    pub(super) fn wrong(&self, given: Coordinates) -> QueryError {
        QueryError::coordinates(self.class(), given)
    }

    /// Whether a configuration is free, blocked or in contact.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn classify(&self, at: Coordinates) -> Result<Classification, QueryError> {
        let class = match (self, at) {
            (Self::Lower(pair), Coordinates::Planar(c)) => pair.classify(c),
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => space.classify(u, v),
            (Self::Planar(space), Coordinates::Planar(c)) => space.classify(c),
            _ => return Err(self.wrong(at)),
        };
        class.ok_or(QueryError::Outside)
    }

    /// Returns an error for a configuration for which nothing was computed.
    fn check(&self, at: Coordinates) -> Result<(), QueryError> {
        match (self, at) {
            (Self::Planar(space), Coordinates::Planar(c)) if space.covers(c) => Ok(()),
            _ => self.classify(at).map(|_| ()),
        }
    }

    /// The patches whose contact is within `tolerance` (model length) at a configuration, with the distances; the nearest first.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn contacts(
        &self,
        at: Coordinates,
        tolerance: f64,
    ) -> Result<Vec<(PatchId, f64)>, QueryError> {
        self.check(at)?;
        let found: Vec<(u32, f64)> = match (self, at) {
            (Self::Lower(pair), Coordinates::Planar(c)) => {
                let off = |f: &crate::ContactFunction| f.value(c.position(), c.theta).abs();
                (0..)
                    .zip(pair.contacts())
                    .map(|(i, contact)| (i, off(&contact.function)))
                    .filter(|&(_, off)| off <= tolerance)
                    .collect()
            }
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => space.contacts(u, v, tolerance),
            (Self::Planar(space), Coordinates::Planar(c)) => space.contacts(c, tolerance),
            _ => return Err(self.wrong(at)),
        };
        let named = |(patch, distance)| (PatchId(patch), distance);
        Ok(found.into_iter().map(named).collect())
    }

    /// Whether the contact of one patch is within `tolerance` (model length) at a configuration: as [`contacts`](Self::contacts), for a
    /// single patch. False outside the window or the ranges of motion, and if there is no such patch.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class.
    pub fn is_on(
        &self,
        patch: PatchId,
        at: Coordinates,
        tolerance: f64,
    ) -> Result<bool, QueryError> {
        Ok(match (self, at) {
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => {
                space.is_on(patch.0, u, v, tolerance)
            }
            (Self::Planar(space), Coordinates::Planar(c)) => {
                space.covers(c) && space.is_on(patch.0, c, tolerance)
            }
            (Self::Lower(_), Coordinates::Planar(_)) => {
                let all = self.contacts(at, tolerance)?;
                all.iter().any(|c| c.0 == patch)
            }
            _ => return Err(self.wrong(at)),
        })
    }

    /// The contact nearest to a configuration: for a planar pair by translation alone, for a pair with fixed axes by the motion of the
    /// moving part alone ([`FixedAxesSpace::nearest_contact`]). `None` if no such motion leads to a contact.
    ///
    /// # Errors
    /// If the configuration is in the coordinates of another class, not finite, or outside the window or the ranges of motion, or the parts
    /// are a lower pair, which is in permanent contact.
    ///
    /// [`FixedAxesSpace::nearest_contact`]: crate::FixedAxesSpace::nearest_contact
    pub fn nearest_contact(&self, at: Coordinates) -> Result<Option<PairNearest>, QueryError> {
        self.check(at)?;
        Ok(match (self, at) {
            (Self::Lower(_), _) => return Err(QueryError::Permanent),
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => {
                space.nearest_contact(u, v).map(|n| PairNearest {
                    patch: PatchId(n.patch),
                    at: Coordinates::Axes {
                        u: n.at.0,
                        v: n.at.1,
                    },
                    distance: n.distance,
                })
            }
            (Self::Planar(space), Coordinates::Planar(c)) => {
                space.nearest_contact(c).map(|n| PairNearest {
                    patch: PatchId(n.patch),
                    at: Coordinates::Planar(n.configuration),
                    distance: n.distance,
                })
            }
            _ => return Err(self.wrong(at)),
        })
    }

    /// The first contact when the configuration moves from `from` at constant `rates` at times from 0 to `duration`.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins where the parts overlap or outside the space, or the
    /// parts are a lower pair, which is in permanent contact.
    pub fn first_contact(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        self.first_contact_about(from, rates, Vector::ZERO, duration)
    }

    /// The first contact of a motion along which the moving part's point `about`, in the part's frame, moves on a straight line: see
    /// [`ContactSpace::first_contact_about`](crate::ContactSpace::first_contact_about). Parts on fixed axes move as their axes let them,
    /// whatever `about` is.
    ///
    /// # Errors
    /// As [`first_contact`](Self::first_contact).
    pub fn first_contact_about(
        &self,
        from: Coordinates,
        rates: Coordinates,
        about: Vector,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        match (self, from, rates) {
            (Self::Lower(_), ..) => Err(QueryError::Permanent),
            (
                Self::FixedAxes(space),
                Coordinates::Axes { u, v },
                Coordinates::Axes { u: du, v: dv },
            ) => Ok(match space.first_contact((u, v), (du, dv), duration)? {
                AxesMotionOutcome::Free => PairMotion::Free,
                AxesMotionOutcome::Leaves { time } => PairMotion::Leaves { time },
                AxesMotionOutcome::Contact(contact) => PairMotion::Contact(PairContact {
                    time: contact.time,
                    at: Coordinates::Axes {
                        u: contact.at.0,
                        v: contact.at.1,
                    },
                    patch: PatchId(contact.patch),
                }),
            }),
            (Self::Planar(space), Coordinates::Planar(c), Coordinates::Planar(d)) => {
                let rates = [d.x, d.y, d.theta];
                let outcome = space.first_contact_about(c, rates, about, duration)?;
                Ok(match outcome {
                    MotionOutcome::Free => PairMotion::Free,
                    MotionOutcome::LeavesWindow { time } => PairMotion::Leaves { time },
                    MotionOutcome::Contact(contact) => PairMotion::Contact(PairContact {
                        time: contact.time,
                        at: Coordinates::Planar(contact.configuration),
                        patch: PatchId(contact.patch),
                    }),
                })
            }
            (Self::FixedAxes(_), Coordinates::Axes { .. }, _)
            | (Self::Planar(_), Coordinates::Planar(_), _) => Err(self.wrong(rates)),
            _ => Err(self.wrong(from)),
        }
    }

    /// All contacts that a motion of constant rates crosses at times from 0 to `duration`, also where the parts overlap, in order of time.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins outside the space, or the parts are a
    /// lower pair.
    pub fn crossings(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<Vec<PairCrossing>, QueryError> {
        let found = match (self, from, rates) {
            (Self::Lower(_), ..) => return Err(QueryError::Permanent),
            (
                Self::FixedAxes(space),
                Coordinates::Axes { u, v },
                Coordinates::Axes { u: du, v: dv },
            ) => space.crossings((u, v), (du, dv), duration)?,
            (Self::Planar(space), Coordinates::Planar(c), Coordinates::Planar(d)) => {
                space.crossings(c, [d.x, d.y, d.theta], duration)?
            }
            (Self::FixedAxes(_), Coordinates::Axes { .. }, _)
            | (Self::Planar(_), Coordinates::Planar(_), _) => return Err(self.wrong(rates)),
            _ => return Err(self.wrong(from)),
        };
        let told = |(time, patch, enters)| PairCrossing {
            time,
            patch: PatchId(patch),
            enters,
        };
        Ok(found.into_iter().map(told).collect())
    }

    /// A patch.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn patch(&self, id: PatchId) -> Result<PairPatch<'_>, QueryError> {
        let count = self.patch_count();
        if id.index() >= count {
            return Err(QueryError::NoPatch {
                patch: id,
                last: PatchId((count as u32).saturating_sub(1)),
            });
        }
        Ok(PairPatch::new(self, id))
    }

    /// The neighbours of a patch. Permanent contacts have none.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn neighbours(&self, patch: PatchId) -> Result<Neighbours, QueryError> {
        self.patch(patch).map(|p| p.neighbours())
    }

    pub(super) fn neighbours_of(&self, patch: PatchId) -> Neighbours {
        let sorted = |list: &mut dyn Iterator<Item = u32>| {
            let mut list: Vec<PatchId> = list.map(PatchId).collect();
            list.sort_unstable();
            list.dedup();
            list
        };
        match self {
            Self::Lower(_) => Neighbours::default(),
            Self::FixedAxes(space) => {
                let p = &space.patches()[patch.index()];
                Neighbours {
                    before: p.previous.into_iter().map(PatchId).collect(),
                    after: p.next.into_iter().map(PatchId).collect(),
                    ..Neighbours::default()
                }
            }
            Self::Planar(space) => {
                let patch = patch.0;
                Neighbours {
                    before: sorted(&mut space.links_before(patch).map(|l| l.before)),
                    after: sorted(&mut space.links_after(patch).map(|l| l.after)),
                    below: sorted(&mut space.links_below(patch).map(|l| l.lower)),
                    above: sorted(&mut space.links_above(patch).map(|l| l.upper)),
                }
            }
        }
    }
}
