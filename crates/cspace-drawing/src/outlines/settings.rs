//! Settings for making parts from a drawing.

use cspace::Point;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::DrawingError;

/// Default distance at which ends are joined, as a share of the drawing's size.
pub const DEFAULT_JOIN: f64 = 1e-5;

/// Default tolerance of fitted lines and arcs, as a share of the loop's size, or of the drawing's size if it is one
/// part.
pub const DEFAULT_FIT: f64 = 1e-4;

/// Settings for reading a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Every length of the drawing is multiplied by it first.
    pub scale: f64,
    /// Ends nearer than this are joined, in lengths after scaling; [`DEFAULT_JOIN`] by default.
    pub join: Option<f64>,
    /// Tolerance with which curves and points become lines and arcs, in lengths after scaling; [`DEFAULT_FIT`] by
    /// default.
    pub fit: Option<f64>,
    /// Side of the curves on which the lines and arcs may be.
    pub side: FitSide,
    /// Whether entities that cannot be used are left out, and listed, instead of being an error.
    pub partial: bool,
    /// Name of the single part made from all loops, instead of one part from every outermost loop.
    pub one_part: Option<String>,
    /// Whether all outermost loops of a layer, with their holes, make one part, instead of one part each.
    pub by_layer: bool,
    /// Whether a rectangle around everything, such as the sheet of material, is left out.
    pub without_sheet: bool,
    /// Whether loops of many edges are traces of curves, to which fewer lines and arcs are fitted.
    pub trace: bool,
    /// The parts are the faces at points, instead of one of every outermost loop; see [`Reading::faces`].
    ///
    /// [`Reading::faces`]: crate::Reading::faces
    pub picks: Vec<Pick>,
}

/// Faces that are one part.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Pick {
    /// Name of the part; the default name of the import if `None`.
    #[serde(default)]
    pub name: Option<String>,
    /// A point in each face, in lengths after scaling.
    pub at: Vec<Point>,
}

/// Side of a curve on which fitted lines and arcs may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FitSide {
    /// Both sides.
    #[default]
    Both,
    /// Outside of the material: the part is as large as drawn, or larger.
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
            without_sheet: false,
            trace: false,
            picks: Vec::new(),
        }
    }
}

impl Settings {
    /// Copy of the settings that leaves out entities that cannot be used.
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
