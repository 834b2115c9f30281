//! The spaces and slices of a pair: computed, read from the cache, or read from a saved file.

use core::f64::consts::TAU;

use std::sync::Arc;

use cspace::fixed_axes::Role;
use cspace::{
    AxesError, ComputeError, ContactSpace, Coordinates, NoFit, Options, PairError, PairSpace, Part,
    Relation, Slice, Symmetry,
};
use cspace_model::shown;

use super::found::{Found, Source};
use super::{Chosen, Subject};
use crate::error::Error;

impl Chosen<'_> {
    /// The slice of a planar pair at one orientation; of a model that slice alone is computed. If `exact`, what fits exactly is free.
    ///
    /// # Errors
    /// As the message says.
    pub fn slice(&self, theta: f64, exact: bool) -> Result<Slice, Error> {
        self.check_orientation(theta)?;
        if exact {
            ContactSpace::check_size(self.fixed(), self.moving())
                .map_err(|e| self.failure(&e.into()))?;
            return Ok(NoFit::new(self.fixed(), self.moving()).at(theta));
        }
        Ok(match self.subject {
            Subject::Saved { file, .. } => match &file.space {
                PairSpace::Planar(space) => space.slice(theta),
                _ => return Err(self.no_orientation("a slice")),
            },
            Subject::Model(_) => {
                ContactSpace::check_size(self.fixed(), self.moving())
                    .map_err(|e| self.failure(&e.into()))?;
                Slice::compute(self.fixed(), self.moving(), theta)
            }
        })
    }

    /// Refuses an orientation outside of the window.
    ///
    /// # Errors
    /// As the message says.
    pub fn check_orientation(&self, theta: f64) -> Result<(), Error> {
        if let Some((lo, hi)) = self.window() {
            let turned = theta + TAU * ((lo - theta) / TAU).ceil();
            if turned > hi {
                return Err(Error::new(format_args!(
                    "{} {}: outside the orientations from {} to {} of the pair {}",
                    self.option("theta"),
                    shown::number(theta),
                    shown::number(lo),
                    shown::number(hi),
                    self.names()
                ))
                .help("choose an orientation inside"));
            }
        }
        Ok(())
    }

    /// The failure of a request that needs orientations, for a pair that has none.
    pub fn no_orientation(&self, what: &str) -> Error {
        let (class, general) = (self.class(), self.option("general"));
        let failure = Error::new(format_args!(
            "pair {}: {what} needs a pair with orientations, and this is a {class} pair",
            self.names()
        ));
        if self.is_saved() {
            failure.help(format_args!(
                "give the model with {general}, which computes it in x, y and theta"
            ))
        } else {
            failure.help(format_args!(
                "with {general} it is computed in x, y and theta"
            ))
        }
    }

    /// The contact space of a planar pair.
    ///
    /// # Errors
    /// As the message says.
    pub fn contact_space(&self, what: &str) -> Result<Arc<ContactSpace>, Error> {
        if !self.is_planar() {
            return Err(self.no_orientation(what));
        }
        match &*self.space()? {
            PairSpace::Planar(space) => Ok(Arc::clone(space)),
            _ => Err(self.no_orientation(what)),
        }
    }

    /// The configuration space, computed once.
    ///
    /// # Errors
    /// As the message says.
    pub fn space(&self) -> Result<Space<'_>, Error> {
        if let Subject::Saved { file, .. } = self.subject {
            return Ok(Space {
                space: Held::Of(&file.space),
                source: Source::File,
                seconds: 0.0,
            });
        }
        let found = match self.known.get() {
            Some(known) => known,
            None => {
                let computed = self.computed(self.moving())?;
                self.known.get_or_init(|| computed)
            }
        };
        Ok(Space {
            space: Held::Of(&found.space),
            source: found.source,
            seconds: found.seconds,
        })
    }

    /// The configuration space of the pair with a clearance: with the moving part grown by it all round.
    ///
    /// # Errors
    /// As the message says.
    pub fn space_with_clearance(&self, clearance: f64) -> Result<Space<'_>, Error> {
        if self.is_saved() {
            return Err(Error::new(format_args!(
                "{}: the file is a saved contact space, whose parts are as they were",
                self.option("clearance")
            ))
            .help("give the model"));
        }
        let grown = cspace_plan::grown(self.moving(), clearance).map_err(|e| {
            let name = shown::text(self.moving().name());
            Error::new(format_args!(
                "{} {clearance:?}: {name} cannot be grown by it: {e}",
                self.option("clearance")
            ))
            .help("give a smaller clearance")
        })?;
        Ok(Space::own(self.computed(&grown)?))
    }

    /// The configuration space for a question at some configurations, and a gap: where the parts fit exactly at one of them, the moving
    /// part is smaller by the gap, so that there is room to move.
    ///
    /// # Errors
    /// As the message says.
    pub fn space_with_room(&self, at: &[Coordinates]) -> Result<(Space<'_>, Option<f64>), Error> {
        let space = self.space()?;
        // What cannot be asked there is told where it is asked.
        let fits = |&at: &Coordinates| cspace_plan::fits_exactly(&space, at).unwrap_or(false);
        if !at.iter().any(fits) {
            return Ok((space, None));
        }
        let Some((smaller, gap)) = cspace_plan::with_gap(self.fixed(), self.moving()) else {
            return Ok((space, None));
        };
        Ok((Space::own(self.computed(&smaller)?), Some(gap)))
    }

    /// The configuration space with a moving part in place of the model's, computed or kept from before.
    fn computed(&self, moving: &Part) -> Result<Found, Error> {
        let relation = match self.relation() {
            Some(relation) if !self.general => relation,
            None => match self.axes() {
                Some((fixed, moving)) => Relation::Axes { fixed, moving },
                None => Relation::Planar,
            },
            Some(_) => Relation::Planar,
        };
        let options = Options {
            window: self.pair.and_then(|p| p.window),
            symmetry: if self.general {
                Symmetry::Ignore
            } else {
                Symmetry::Detect
            },
        };
        let fixed = self.fixed();
        let progress = self.host.begin(&self.names());
        let begin = progress.seconds();
        let found = (self.host).space((fixed, moving), relation, &options, &*progress);
        let (space, kept) = found.map_err(|e| self.failure(&e))?;
        Ok(Found {
            space,
            source: Source::of(kept),
            seconds: progress.seconds() - begin,
        })
    }

    /// The error of a pair that cannot be computed.
    pub fn failure(&self, error: &PairError) -> Error {
        let (window, general) = (self.option("window"), self.option("general"));
        let failure = || Error::new(format_args!("pair {}: {error}", self.names()));
        let axis = |error: &AxesError| {
            let part = match error.part() {
                Role::Fixed => self.fixed(),
                Role::Moving => self.moving(),
            };
            Error::new(format_args!(
                "{}part {:?} of the pair {}: {error}",
                self.file(),
                part.name(),
                self.names()
            ))
        };
        match error {
            PairError::Compute(ComputeError::Window { .. }) => {
                failure().help(format_args!(
                    "give {window} LO,HI with LO < HI, at most a turn apart"
                ))
            }
            PairError::Compute(ComputeError::TooManyEdges { .. } | ComputeError::TooLarge { .. })
            | PairError::Axes(AxesError::TooLarge { .. } | AxesError::TooManyCrossings { .. }) => {
                failure().help(
                    "replace runs of short lines by arcs, leave out what cannot touch, or split a part",
                )
            }
            PairError::Compute(
                ComputeError::TooManyContacts { .. }
                | ComputeError::TooManyCrossings { .. }
                | ComputeError::TooManyPatches { .. },
            ) => failure().help(format_args!(
                "replace runs of short lines by arcs, leave out what cannot touch, split a part, or limit the orientations with {window}",
            )),
            PairError::Window { .. } => failure().help(format_args!(
                "leave the window out, or name a pair that has orientations with {}; limit the motion with `range`, or compute all of x, y and theta with {general}",
                self.option("pair")
            )),
            PairError::Axes(error @ AxesError::TooFar { .. }) => {
                axis(error).help(format_args!(
                    "draw the pivot nearer to the parts, or use {general}"
                ))
            }
            PairError::Axes(error) => axis(error).help("change the part's motion in the model"),
            _ => failure(),
        }
    }
}

/// A configuration space, and where it is from.
#[derive(Debug)]
pub struct Space<'a> {
    space: Held<'a>,
    /// Where it is from.
    pub source: Source,
    /// How long it took to compute, or to read where it was kept, by the clock of the program that asks.
    pub seconds: f64,
}

#[derive(Debug)]
enum Held<'a> {
    Of(&'a PairSpace),
    Own(PairSpace),
}

impl Space<'_> {
    fn own(found: Found) -> Self {
        Self {
            space: Held::Own(found.space),
            source: found.source,
            seconds: found.seconds,
        }
    }
}

impl core::ops::Deref for Space<'_> {
    type Target = PairSpace;

    fn deref(&self) -> &PairSpace {
        match &self.space {
            Held::Of(space) => space,
            Held::Own(space) => space,
        }
    }
}
