//! Questions to the configuration space of a pair of any class.

use crate::geometry::Configuration;
use crate::query::{Classification, MotionError, MotionOutcome};

use super::relation::{Coordinates, PairClass};
use super::space::PairSpace;

/// Where a motion first touches.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairContact {
    /// When, in the unit of time of the rates.
    pub time: f64,
    /// The configuration then.
    pub at: Coordinates,
    /// The patch it touches: one of them, where it touches several.
    pub patch: u32,
}

/// The contact nearest to a configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PairNearest {
    /// The patch it is on.
    pub patch: u32,
    /// The configuration in contact.
    pub at: Coordinates,
    /// How far the moving part moves to it: a length, or radians of a part that turns on its axis.
    pub distance: f64,
}

/// What becomes of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum PairMotion {
    /// It is free to the end.
    Free,
    /// It touches.
    Contact(PairContact),
    /// It is free until it leaves the window of orientations or the range of a part's motion, at this time.
    Leaves {
        /// When.
        time: f64,
    },
}

/// The neighbours of a patch along the boundary of free space, each once, in order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Neighbours {
    /// Those before it, at its left boundary.
    pub before: Vec<u32>,
    /// Those after it, at its right boundary.
    pub after: Vec<u32>,
    /// Those it continues at its lowest orientation. Patches of fixed axes have none.
    pub below: Vec<u32>,
    /// Those that continue it at its highest orientation.
    pub above: Vec<u32>,
}

/// Why a question has no answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QueryError {
    /// The configuration is in the coordinates of another class.
    #[error("a configuration of a {class} pair is given by {wanted}, not by {given}")]
    Coordinates {
        /// The class.
        class: PairClass,
        /// The coordinates it has.
        wanted: &'static str,
        /// Those it was given.
        given: &'static str,
    },
    /// The configuration is not finite, or outside the window or the ranges of motion.
    #[error("the configuration is not finite, or outside the window or the ranges of motion")]
    Outside,
    /// There is no such patch.
    #[error("there is no patch {patch}; the last is {last}")]
    NoPatch {
        /// The number given.
        patch: u32,
        /// The largest there is.
        last: u32,
    },
    /// The parts never part.
    #[error(
        "the parts of a lower pair are in contact for ever: there is no first or nearest contact"
    )]
    Permanent,
    /// A motion cannot be followed.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

impl PairSpace {
    fn wrong(&self, given: Coordinates) -> QueryError {
        QueryError::Coordinates {
            class: self.class(),
            wanted: match self {
                Self::FixedAxes(_) => Coordinates::Axes { u: 0.0, v: 0.0 }.names(),
                _ => Coordinates::Planar(Configuration::new(0.0, 0.0, 0.0)).names(),
            },
            given: given.names(),
        }
    }

    /// Whether a configuration is free, blocked or in contact.
    ///
    /// # Errors
    /// If it is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn classify(&self, at: Coordinates) -> Result<Classification, QueryError> {
        let class = match (self, at) {
            (Self::Lower(pair), Coordinates::Planar(c)) => pair.classify(c),
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => space.classify(u, v),
            (Self::Planar(space), Coordinates::Planar(c)) => space.classify(c),
            _ => return Err(self.wrong(at)),
        };
        class.ok_or(QueryError::Outside)
    }

    /// The patches in contact at a configuration, up to `tolerance` (model length) off, with how far; the nearest first.
    ///
    /// # Errors
    /// If it is in the coordinates of another class, not finite, or outside the window or the ranges of motion.
    pub fn contacts(&self, at: Coordinates, tolerance: f64) -> Result<Vec<(u32, f64)>, QueryError> {
        self.classify(at)?;
        Ok(match (self, at) {
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
        })
    }

    /// The contact nearest to a configuration: of a planar pair by translation alone, of a pair with fixed axes by the
    /// motion of the moving part alone ([`FixedAxesSpace::nearest_contact`]). `None` if nothing touches that way.
    ///
    /// # Errors
    /// If it is in the coordinates of another class, not finite, or outside the window or the ranges of motion, or the parts
    /// are a lower pair, which is in contact for ever.
    ///
    /// [`FixedAxesSpace::nearest_contact`]: crate::FixedAxesSpace::nearest_contact
    pub fn nearest_contact(&self, at: Coordinates) -> Result<Option<PairNearest>, QueryError> {
        self.classify(at)?;
        Ok(match (self, at) {
            (Self::Lower(_), _) => return Err(QueryError::Permanent),
            (Self::FixedAxes(space), Coordinates::Axes { u, v }) => {
                space.nearest_contact(u, v).map(|n| PairNearest {
                    patch: n.patch,
                    at: Coordinates::Axes {
                        u: n.at.0,
                        v: n.at.1,
                    },
                    distance: n.distance,
                })
            }
            (Self::Planar(space), Coordinates::Planar(c)) => {
                space.nearest_contact(c).map(|n| PairNearest {
                    patch: n.patch,
                    at: Coordinates::Planar(n.configuration),
                    distance: n.distance,
                })
            }
            _ => return Err(self.wrong(at)),
        })
    }

    /// The first contact when the configuration moves from `from` at constant `rates` for times from 0 to `duration`.
    ///
    /// # Errors
    /// If coordinates are of another class, numbers are not finite, the motion begins where the parts overlap or outside
    /// the space, or the parts are a lower pair, which is in contact for ever.
    pub fn first_contact(
        &self,
        from: Coordinates,
        rates: Coordinates,
        duration: f64,
    ) -> Result<PairMotion, QueryError> {
        match (self, from, rates) {
            (Self::Lower(_), ..) => Err(QueryError::Permanent),
            (
                Self::FixedAxes(space),
                Coordinates::Axes { u, v },
                Coordinates::Axes { u: du, v: dv },
            ) => Ok(space.first_contact((u, v), (du, dv), duration)?),
            (Self::Planar(space), Coordinates::Planar(c), Coordinates::Planar(d)) => {
                let outcome = space.first_contact(c, [d.x, d.y, d.theta], duration)?;
                Ok(match outcome {
                    MotionOutcome::Free => PairMotion::Free,
                    MotionOutcome::LeavesWindow { time } => PairMotion::Leaves { time },
                    MotionOutcome::Contact(contact) => PairMotion::Contact(PairContact {
                        time: contact.time,
                        at: Coordinates::Planar(contact.configuration),
                        patch: contact.patch,
                    }),
                })
            }
            (Self::FixedAxes(_), Coordinates::Axes { .. }, _)
            | (Self::Planar(_), Coordinates::Planar(_), _) => Err(self.wrong(rates)),
            _ => Err(self.wrong(from)),
        }
    }

    /// The neighbours of a patch. Permanent contacts have none.
    ///
    /// # Errors
    /// If there is no such patch.
    pub fn neighbours(&self, patch: u32) -> Result<Neighbours, QueryError> {
        let count = self.patches() as u32;
        if patch >= count {
            return Err(QueryError::NoPatch {
                patch,
                last: count.saturating_sub(1),
            });
        }
        let sorted = |mut list: Vec<u32>| {
            list.sort_unstable();
            list.dedup();
            list
        };
        Ok(match self {
            Self::Lower(_) => Neighbours::default(),
            Self::FixedAxes(space) => {
                let p = &space.patches()[patch as usize];
                Neighbours {
                    before: p.previous.into_iter().collect(),
                    after: p.next.into_iter().collect(),
                    ..Neighbours::default()
                }
            }
            Self::Planar(space) => {
                let vertical = space.vertical_links();
                Neighbours {
                    before: sorted(space.links_before(patch).map(|l| l.before).collect()),
                    after: sorted(space.links_after(patch).map(|l| l.after).collect()),
                    below: sorted(
                        vertical
                            .iter()
                            .filter(|l| l.upper == patch)
                            .map(|l| l.lower)
                            .collect(),
                    ),
                    above: sorted(
                        vertical
                            .iter()
                            .filter(|l| l.lower == patch)
                            .map(|l| l.upper)
                            .collect(),
                    ),
                }
            }
        })
    }
}
