//! A drawing whose faces are shown, to make parts of those that are picked.

use cspace::{Mechanism, MechanismError, PartEntry, Point, Vertex};
use cspace_drawing::{Drawing, DrawingError, Pick, Settings};
use serde::{Deserialize, Serialize};

/// The `format` of a [`DrawingScene`].
const FORMAT: &str = "cspace-drawing";

/// The version that is written.
const VERSION: u32 = 1;

/// A drawing, and how it is read.
#[derive(Debug, Clone)]
pub struct OpenedDrawing {
    /// The name of the model.
    pub name: String,
    /// The unit of the model.
    pub unit: Option<String>,
    /// The drawing.
    pub drawing: Drawing,
    /// How it is read, without picks.
    pub settings: Settings,
    /// The command that makes the model, up to its picks: the page shows it.
    pub command: String,
}

/// All that the page of a drawing shows. Lengths are in the model's unit.
#[derive(Debug, Clone, Serialize)]
pub struct DrawingScene {
    /// Always `cspace-drawing`.
    pub format: &'static str,
    /// Always 1.
    pub version: u32,
    /// The name of the model.
    pub name: String,
    /// The label of the unit of length.
    pub unit: Option<String>,
    /// The command that makes the model, up to its picks.
    pub command: String,
    /// All curves, as the ends of lines and arcs.
    pub curves: Vec<Vec<Vertex>>,
    /// The faces, the largest first; of very many the largest only.
    pub faces: Vec<SceneFace>,
    /// The number of faces of the drawing.
    pub count: usize,
}

/// A face that can be picked.
#[derive(Debug, Clone, Serialize)]
pub struct SceneFace {
    /// A point inside, which picks the face.
    pub inside: Point,
    /// The area, without what lies within.
    pub area: f64,
    /// The outer boundary, then those of what lies within.
    pub loops: Vec<Vec<Vertex>>,
    /// Why the face alone is no part; it may be one together with others.
    pub refusal: Option<String>,
}

/// Faces that are to be one part.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct PickedPart {
    /// The name of the part.
    pub name: String,
    /// A point in each face.
    pub at: Vec<Point>,
}

/// Why picked faces make no model.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PickError {
    /// Nothing is picked.
    #[error("no face is picked")]
    Nothing,
    /// The faces make no parts.
    #[error(transparent)]
    Drawing(#[from] DrawingError),
    /// The parts make no mechanism.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
}

impl PickError {
    /// What to do about it.
    pub fn help(&self) -> &str {
        match self {
            Self::Nothing => "click faces: each click makes a part",
            Self::Drawing(error) => error.help(),
            Self::Mechanism(_) => "rename parts on the page",
        }
    }
}

impl OpenedDrawing {
    /// The faces and curves of the drawing.
    ///
    /// # Errors
    /// If the drawing is one of measured points, its settings or coordinates are beyond use, or its curves cross too often.
    pub fn scene(&self) -> Result<DrawingScene, DrawingError> {
        let found = self.drawing.reading(&self.settings)?.faces()?;
        let faces = found.faces.into_iter().map(|face| SceneFace {
            inside: face.inside,
            area: face.area,
            loops: face.loops,
            refusal: face.refusal.map(|error| error.to_string()),
        });
        Ok(DrawingScene {
            format: FORMAT,
            version: VERSION,
            name: self.name.clone(),
            unit: self.unit.clone(),
            command: self.command.clone(),
            curves: found.curves,
            faces: faces.collect(),
            count: found.count,
        })
    }

    /// The model of picked parts, each of which moves freely, with all pairs.
    ///
    /// # Errors
    /// If nothing is picked, a point is in no face, a face is picked twice, or two parts have the same name.
    pub fn model(&self, picked: &[PickedPart]) -> Result<Mechanism, PickError> {
        if picked.is_empty() || picked.iter().any(|part| part.at.is_empty()) {
            return Err(PickError::Nothing);
        }
        let picks = picked.iter().map(|part| Pick {
            name: Some(part.name.clone()),
            at: part.at.clone(),
        });
        let settings = Settings {
            picks: picks.collect(),
            ..self.settings.clone()
        };
        let parts = self.drawing.outlines(&settings)?.parts;
        let mut model = Mechanism::new(self.name.clone());
        model.unit.clone_from(&self.unit);
        model.parts = parts.into_iter().map(PartEntry::planar).collect();
        model.pairs = model.every_two();
        model.check()?;
        Ok(model)
    }
}
