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
pub use result::{Apart, FittedReport, Outlines, Survey};
pub use settings::{DEFAULT_FIT, DEFAULT_JOIN, FitSide, Pick, Settings};
pub use trace::Traced;

use crate::affine::Affine;
use crate::drawing::Drawing;
use crate::error::DrawingError;
use fits::Fits;
use making::Making;
use settings::check;

/// A drawing that is read in one way: what is found for one question about it is kept for the next.
pub struct Reading<'d> {
    drawing: Cow<'d, Drawing>,
    settings: &'d Settings,
    /// The settings, with what cannot be used left out.
    partial: Settings,
    fits: Fits,
}

impl Reading<'_> {
    /// The parts that the drawing shows.
    ///
    /// Loose pieces are joined to loops, what is drawn twice is taken once, curves become tangent lines and arcs, and loops
    /// within loops are holes.
    ///
    /// # Errors
    /// If anything cannot be used, such as a chain that is not closed, unless that is to be left out; if nothing is left; or
    /// if loops cross or touch.
    pub fn outlines(&self) -> Result<Outlines, DrawingError> {
        if self.settings.picks.is_empty() {
            return Making::new(&self.drawing, self.settings, &self.fits)?.make();
        }
        check_divisible(&self.drawing)?;
        self.partially()?.picked()
    }

    /// The faces into which all that is drawn divides the plane: for a choice among them, where [`Reading::outlines`] refuses
    /// the drawing because its curves cross, meet in threes or end freely.
    ///
    /// # Errors
    /// If the coordinates are beyond use, nothing is drawn, or the curves cross too often.
    pub fn faces(&self) -> Result<DrawnFaces, DrawingError> {
        check_divisible(&self.drawing)?;
        self.partially()?.faces()
    }

    /// The parts that the drawing shows, and what of it cannot be used: for a picture of both.
    ///
    /// # Errors
    /// If the coordinates are beyond use.
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
    /// The drawing as it is read with settings.
    ///
    /// # Errors
    /// If the settings are beyond use.
    pub fn reading<'d>(&'d self, settings: &'d Settings) -> Result<Reading<'d>, DrawingError> {
        check(settings)?;
        Ok(Reading {
            drawing: self.scaled(settings.scale),
            settings,
            partial: settings.partially(),
            fits: Fits::default(),
        })
    }

    /// The parts that the drawing shows; see [`Reading::outlines`].
    ///
    /// # Errors
    /// If the settings are beyond use, and as [`Reading::outlines`].
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
