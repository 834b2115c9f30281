//! The spaces and slices of a pair: computed, read from the cache, or read from a saved file.

use core::f64::consts::TAU;

use std::sync::Arc;

use cspace::fixed_axes::Role;
use cspace::{
    AxesError, ComputeError, ContactSpace, Coordinates, NoFit, Options, PairError, PairSpace, Part,
    Relation, Slice, Symmetry,
};
use cspace_model::shown;

use super::{Chosen, Subject};
use crate::cache;
use crate::failure::Failure;
use crate::progress::Bar;

impl Chosen<'_> {
    /// The slice of a planar pair at one orientation; of a model that slice alone is computed. If `exact`, what fits exactly is free.
    pub(crate) fn slice(&self, theta: f64, exact: bool) -> Result<Slice, Failure> {
        self.check_orientation(theta)?;
        if exact {
            ContactSpace::check_size(self.fixed(), self.moving())
                .map_err(|e| self.failure(&e.into()))?;
            return Ok(NoFit::new(self.fixed(), self.moving()).at(theta));
        }
        Ok(match self.subject {
            Subject::Saved(file) => match &file.space {
                PairSpace::Planar(space) => space.slice(theta),
                _ => return Err(self.no_orientation("a slice")),
            },
            Subject::Model { .. } => {
                ContactSpace::check_size(self.fixed(), self.moving())
                    .map_err(|e| self.failure(&e.into()))?;
                Slice::compute(self.fixed(), self.moving(), theta)
            }
        })
    }

    /// Refuses an orientation outside of the window.
    pub(crate) fn check_orientation(&self, theta: f64) -> Result<(), Failure> {
        if let Some((lo, hi)) = self.window() {
            let turned = theta + TAU * ((lo - theta) / TAU).ceil();
            if turned > hi {
                return Err(Failure::new(format_args!(
                    "--theta {}: outside the orientations from {} to {} of the pair {}",
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
    pub(crate) fn no_orientation(&self, what: &str) -> Failure {
        let class = self.class();
        let failure = Failure::new(format_args!(
            "pair {}: {what} needs a pair with orientations, and this is a {class} pair",
            self.names()
        ));
        if self.is_saved() {
            failure.help("give the model with --general, which computes it in x, y and theta")
        } else {
            failure.help("with --general it is computed in x, y and theta")
        }
    }

    /// The contact space of a planar pair.
    pub(crate) fn contact_space(&self, what: &str) -> Result<Arc<ContactSpace>, Failure> {
        if !self.is_planar() {
            return Err(self.no_orientation(what));
        }
        match self.space()? {
            Space::Computed(PairSpace::Planar(space)) | Space::Kept(PairSpace::Planar(space)) => {
                Ok(space)
            }
            Space::Saved(PairSpace::Planar(space)) => Ok(Arc::clone(space)),
            _ => Err(self.no_orientation(what)),
        }
    }

    /// The configuration space.
    pub(crate) fn space(&self) -> Result<Space<'_>, Failure> {
        match self.subject {
            Subject::Saved(file) => Ok(Space::Saved(&file.space)),
            Subject::Model { .. } => self.computed(self.moving()),
        }
    }

    /// The configuration space of the pair with a clearance: with the moving part grown by it all round.
    pub(crate) fn space_with_clearance(&self, clearance: f64) -> Result<Space<'_>, Failure> {
        if self.is_saved() {
            return Err(Failure::new(
                "--clearance: the file is a saved contact space, whose parts are as they were",
            )
            .help("give the model"));
        }
        let grown = cspace_plan::grown(self.moving(), clearance).map_err(|e| {
            let name = shown::text(self.moving().name());
            Failure::new(format_args!(
                "--clearance {clearance:?}: {name} cannot be grown by it: {e}"
            ))
            .help("give a smaller clearance")
        })?;
        self.computed(&grown)
    }

    /// The configuration space for a question at some configurations, and a gap: where the parts fit exactly at one of them, the moving
    /// part is smaller by the gap, so that there is room to move.
    pub(crate) fn space_with_room(
        &self,
        at: &[Coordinates],
    ) -> Result<(Space<'_>, Option<f64>), Failure> {
        let space = self.space()?;
        // What cannot be asked there is told where it is asked.
        let fits = |&at: &Coordinates| cspace_plan::fits_exactly(&space, at).unwrap_or(false);
        if !at.iter().any(fits) {
            return Ok((space, None));
        }
        let Some((smaller, gap)) = cspace_plan::with_gap(self.fixed(), self.moving()) else {
            return Ok((space, None));
        };
        Ok((self.computed(&smaller)?, Some(gap)))
    }

    /// A line that says by which gap the moving part is smaller.
    pub(crate) fn gap_in_words(&self, gap: f64) -> String {
        format!(
            "gap {:.1e}{}: the parts fit exactly, and {} is smaller by it all around",
            gap,
            self.unit(),
            shown::text(self.moving().name())
        )
    }

    /// The configuration space with a moving part in place of the model's, computed or kept from before.
    fn computed(&self, moving: &Part) -> Result<Space<'_>, Failure> {
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
        let bar = Bar::new(self.names());
        let (space, kept) = bar
            .watch(|bar| cache::space(self.keeps, (fixed, moving), relation, &options, bar))
            .map_err(|e| self.failure(&e))?;
        Ok(match kept {
            true => Space::Kept(space),
            false => Space::Computed(space),
        })
    }

    pub(crate) fn failure(&self, error: &PairError) -> Failure {
        let failure = || Failure::new(format_args!("pair {}: {error}", self.names()));
        let axis = |error: &AxesError| {
            let part = match error.part() {
                Role::Fixed => self.fixed(),
                Role::Moving => self.moving(),
            };
            Failure::new(format_args!(
                "{}part {:?} of the pair {}: {error}",
                self.file(),
                part.name(),
                self.names()
            ))
        };
        match error {
            PairError::Compute(ComputeError::Window { .. }) => {
                failure().help("give --window LO,HI with LO < HI, at most a turn apart")
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
            ) => failure().help(
                "replace runs of short lines by arcs, leave out what cannot touch, split a part, or limit the orientations with --window",
            ),
            PairError::Window { .. } => failure().help(
                "leave the window out, or name a pair that has orientations with --pair; limit the motion with `range`, or compute all of x, y and theta with --general",
            ),
            PairError::Axes(error @ AxesError::TooFar { .. }) => {
                axis(error).help("draw the pivot nearer to the parts, or use --general")
            }
            PairError::Axes(error) => axis(error).help("change the part's motion in the model"),
            _ => failure(),
        }
    }
}

/// A configuration space that was read, or computed.
pub(crate) enum Space<'a> {
    /// Read.
    Saved(&'a PairSpace),
    /// Computed by a command before, and kept.
    Kept(PairSpace),
    /// Computed.
    Computed(PairSpace),
}

impl core::ops::Deref for Space<'_> {
    type Target = PairSpace;

    fn deref(&self) -> &PairSpace {
        match self {
            Self::Saved(space) => space,
            Self::Computed(space) | Self::Kept(space) => space,
        }
    }
}
