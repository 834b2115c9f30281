//! Parts from drawings.

mod blunt;
mod crossing;
mod faces;
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
pub use result::{FittedReport, Outlines, Survey};
pub use settings::{DEFAULT_FIT, DEFAULT_JOIN, FitSide, Pick, Settings};
pub use trace::Traced;

use crate::affine::Affine;
use crate::drawing::Drawing;
use crate::error::DrawingError;
use making::Making;
use settings::check;

impl Drawing {
    /// The parts that the drawing shows.
    ///
    /// Loose pieces are joined to loops, what is drawn twice is taken once, curves become tangent lines and arcs, and loops
    /// within loops are holes.
    ///
    /// # Errors
    /// If anything cannot be used, such as a chain that is not closed, unless that is to be left out; if nothing is left; or
    /// if loops cross or touch.
    pub fn outlines(&self, settings: &Settings) -> Result<Outlines, DrawingError> {
        check(settings)?;
        let scaled = self.scaled(settings.scale);
        if settings.picks.is_empty() {
            return Making::new(&scaled, settings)?.make();
        }
        check_divisible(self)?;
        let partial = settings.partially();
        Making::new(&scaled, &partial)?.picked()
    }

    /// The faces into which all that is drawn divides the plane: for a choice among them, where [`Drawing::outlines`] refuses
    /// the drawing because its curves cross, meet in threes or end freely.
    ///
    /// # Errors
    /// If the settings or the coordinates are beyond use, nothing is drawn, or the curves cross too often.
    pub fn faces(&self, settings: &Settings) -> Result<DrawnFaces, DrawingError> {
        check(settings)?;
        check_divisible(self)?;
        let scaled = self.scaled(settings.scale);
        let partial = settings.partially();
        Making::new(&scaled, &partial)?.faces()
    }

    /// The parts that the drawing shows, and what of it cannot be used: for a picture of both.
    ///
    /// # Errors
    /// If the settings or the coordinates are beyond use.
    pub fn survey(&self, settings: &Settings) -> Result<Survey, DrawingError> {
        check(settings)?;
        let settings = settings.partially();
        let scaled = self.scaled(settings.scale);
        let mut making = Making::new(&scaled, &settings)?;
        let outlines = making.outlines();
        let parts = making.parts(outlines);
        let mut unused: Vec<u32> = making.unused.clone();
        unused.sort_unstable();
        unused.dedup();
        Ok(Survey {
            parts: parts.0,
            unused: (unused.iter())
                .map(|&e| scaled.entities[e as usize].clone())
                .collect(),
            problems: making.told,
        })
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
        for entity in &mut scaled.entities {
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

/// That curves bound faces, and not measured points.
fn check_divisible(drawing: &Drawing) -> Result<(), DrawingError> {
    match drawing.is_measured {
        false => Ok(()),
        true => Err(DrawingError::file(
            "measured points are one outline, without faces to pick",
            "leave the picks out",
        )),
    }
}
