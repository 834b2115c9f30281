//! Parts from drawings.

mod apart;
mod blunt;
mod copies;
mod crossing;
mod faces;
mod fits;
mod left_out;
mod making;
mod names;
mod refusal;
mod result;
mod settings;
mod trace;

use std::borrow::Cow;

use cspace::Point;
use cspace::part::Bounds;

pub use faces::{DrawnFace, DrawnFaces};
pub use making::SHEET;
pub use result::{Apart, FittedReport, Outlines, Survey};
pub use settings::{DEFAULT_FIT, DEFAULT_JOIN, FitSide, Pick, Settings};
pub use trace::Traced;

use crate::affine::Affine;
use crate::drawing::Drawing;
use crate::error::DrawingError;
use fits::Fits;
use making::Making;
use settings::check;

/// Drawing with the settings for reading it; results for one query are kept for the next.
pub struct Reading<'d> {
    drawing: Cow<'d, Drawing>,
    settings: &'d Settings,
    /// The settings, with what cannot be used left out.
    partial: Settings,
    fits: Fits,
}

impl Reading<'_> {
    /// Makes the parts that the drawing shows.
    ///
    /// Loose pieces are joined to loops, repeated pieces are used once, curves become tangent lines and arcs, and loops
    /// within loops are holes.
    ///
    /// # Errors
    /// If an entity cannot be used, such as a chain that is not closed, unless such entities are to be left out; if
    /// nothing is left; or if loops cross or touch.
    pub fn outlines(&self) -> Result<Outlines, DrawingError> {
        if self.settings.picks.is_empty() {
            let making = Making::new(&self.drawing, self.settings, &self.fits)?;
            let closes = making.closes();
            return match (making.make(), closes) {
                (Err(error), Some((join, tiny))) => self.closed(join, tiny).ok_or(error),
                (made, _) => made,
            };
        }
        check_divisible(&self.drawing)?;
        self.partially()?.picked()
    }

    /// The parts with ends joined at a distance at which no chain is open; none if which ends belong together is not clear then, or pieces
    /// are lost that are not as short as `tiny`.
    fn closed(&self, join: f64, tiny: usize) -> Option<Outlines> {
        let settings = Settings {
            join: Some(join),
            ..self.settings.clone()
        };
        let fits = Fits::default();
        let made = Making::new(&self.drawing, &settings, &fits)
            .ok()?
            .make()
            .ok()?;
        (made.tiny == tiny).then_some(Outlines {
            closed: Some(join),
            ..made
        })
    }

    /// Faces into which the drawn curves divide the plane: for a choice among them, where [`Reading::outlines`] refuses
    /// the drawing because its curves cross, meet in threes or end freely.
    ///
    /// # Errors
    /// If the coordinates are out of range, nothing is drawn, or the curves cross too often.
    pub fn faces(&self) -> Result<DrawnFaces, DrawingError> {
        check_divisible(&self.drawing)?;
        self.partially()?.faces()
    }

    /// Parts that the drawing shows, and its entities that cannot be used: for a picture of both.
    ///
    /// # Errors
    /// If the coordinates are out of range.
    pub fn survey(&self) -> Result<Survey, DrawingError> {
        let mut making = self.partially()?;
        let outlines = making.outlines();
        let parts = making.parts(outlines);
        let mut unused: Vec<u32> = making.unused.clone();
        unused.sort_unstable();
        unused.dedup();
        Ok(Survey {
            parts: parts.0,
            unused: (unused.iter())
                .map(|&e| self.drawing.entities[e as usize].clone())
                .collect(),
            problems: making.told,
        })
    }

    fn partially(&self) -> Result<Making<'_>, DrawingError> {
        Making::new(&self.drawing, &self.partial, &self.fits)
    }
}

impl Drawing {
    /// Prepares to read the drawing with settings.
    ///
    /// # Errors
    /// If the settings are invalid.
    pub fn reading<'d>(&'d self, settings: &'d Settings) -> Result<Reading<'d>, DrawingError> {
        check(settings)?;
        Ok(Reading {
            drawing: self.scaled(settings.scale),
            settings,
            partial: settings.partially(),
            fits: Fits::default(),
        })
    }

    /// Makes the parts that the drawing shows; see [`Reading::outlines`].
    ///
    /// # Errors
    /// If the settings are invalid, and as [`Reading::outlines`].
    pub fn outlines(&self, settings: &Settings) -> Result<Outlines, DrawingError> {
        self.reading(settings)?.outlines()
    }

    fn scaled(&self, scale: f64) -> Cow<'_, Self> {
        if scale == 1.0 {
            return Cow::Borrowed(self);
        }
        let mut scaled = self.clone();
        let map = Affine {
            x: Affine::IDENTITY.x * scale,
            y: Affine::IDENTITY.y * scale,
            origin: Point::ORIGIN,
        };
        let elsewhere = scaled.elsewhere.iter_mut().map(|e| &mut e.entity);
        for entity in scaled.entities.iter_mut().chain(elsewhere) {
            entity.path = entity.path.mapped(&map);
        }
        scaled.page = (self.page).map(|page| Bounds::of(map.point(page.min), map.point(page.max)));
        Cow::Owned(scaled)
    }

    /// The diagonal of the box of all that is drawn.
    pub fn size(&self) -> f64 {
        let bounds =
            (self.entities.iter()).fold(Bounds::EMPTY, |all, e| all.union(e.path.bounds()));
        if bounds.min.x <= bounds.max.x {
            bounds.diagonal()
        } else {
            0.0
        }
    }
}

/// Checks that faces are bounded by curves, and not by measured points.
fn check_divisible(drawing: &Drawing) -> Result<(), DrawingError> {
    match drawing.is_measured {
        false => Ok(()),
        true => Err(DrawingError::file(
            "measured points are one outline, without faces to pick",
            "leave the picks out: `cspace import` makes one part of the points",
        )),
    }
}
