//! How parts are made of a drawing.

use cspace::Point;

use crate::error::DrawingError;

/// How near ends are that are one, as a share of the drawing's size, unless it is said.
pub const DEFAULT_JOIN: f64 = 1e-5;

/// How far lines and arcs may be from what they are fitted to, as a share of the loop's size, or of the drawing's where it is one
/// part, unless it is said.
pub const DEFAULT_FIT: f64 = 1e-4;

/// How a drawing is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Every length of the drawing is multiplied by it first.
    pub scale: f64,
    /// Ends nearer than this are one, in lengths after scaling; [`DEFAULT_JOIN`] where it is not said.
    pub join: Option<f64>,
    /// Curves and points become lines and arcs within this, in lengths after scaling; [`DEFAULT_FIT`] where it is not said.
    pub fit: Option<f64>,
    /// On which side of the curves the lines and arcs may be.
    pub side: FitSide,
    /// Whether what cannot be used is left out, and listed, instead of being an error.
    pub partial: bool,
    /// One part of this name of all loops, instead of one of every outermost loop.
    pub one_part: Option<String>,
    /// One part of all outermost loops of each layer, with their holes, instead of one of every such loop.
    pub by_layer: bool,
    /// Whether loops of many edges are traces of something else, which fewer lines and arcs are fitted to.
    pub trace: bool,
    /// The parts are the faces at points, instead of one of every outermost loop; see [`Reading::faces`].
    ///
    /// [`Reading::faces`]: crate::Reading::faces
    pub picks: Vec<Pick>,
}

/// Faces that are one part.
#[derive(Debug, Clone, PartialEq)]
pub struct Pick {
    /// The name of the part; the one that import gives where there is none.
    pub name: Option<String>,
    /// A point in each face, in lengths after scaling.
    pub at: Vec<Point>,
}

/// On which side of a curve lines and arcs may be that are fitted to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FitSide {
    /// On both.
    #[default]
    Both,
    /// Outside of the material alone: the part is as large as drawn, or larger.
    Outside,
    /// Inside of the material alone: the part is as large as drawn, or smaller.
    Inside,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            scale: 1.0,
            join: None,
            fit: None,
            side: FitSide::Both,
            partial: false,
            one_part: None,
            by_layer: false,
            trace: false,
            picks: Vec::new(),
        }
    }
}

impl Settings {
    /// These settings, with what cannot be used left out.
    pub(super) fn partially(&self) -> Self {
        Self {
            partial: true,
            ..self.clone()
        }
    }
}

/// Checks that all given lengths are positive.
pub(super) fn check(settings: &Settings) -> Result<(), DrawingError> {
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let wrong = |what: &str, x: f64| {
        let message = format!("`{what}` is {x:?}");
        Err(DrawingError::file(
            message,
            format!("give a positive number as {what}"),
        ))
    };
    if !positive(settings.scale) {
        return wrong("scale", settings.scale);
    }
    for (what, length) in [("join", settings.join), ("fit", settings.fit)] {
        if let Some(x) = length.filter(|&x| !positive(x)) {
            return wrong(what, x);
        }
    }
    Ok(())
}
