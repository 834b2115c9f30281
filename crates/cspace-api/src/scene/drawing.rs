//! A drawing whose faces are shown, to make parts of those that are picked.

use std::path::Path;

use cspace::{Part, Point, Vertex};
use cspace_drawing::{Color, Conversion, Drawing, DrawingError, DrawnFace, Pick, Settings, Source};
use cspace_model::{Mechanism, MechanismError, ModelError, PartEntry, shown};
use serde::{Deserialize, Serialize};

use crate::scene::base_64;

/// The `format` of a [`DrawingScene`].
const FORMAT: &str = "cspace-drawing";

/// The version that is written.
const VERSION: u32 = 2;

/// The file of a drawing, and how it is read: the model of picked faces follows from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawingSource {
    /// Name of the file; its extension determines the format.
    pub file: String,
    /// The bytes of the file; in base 64 as JSON.
    #[serde(with = "base_64")]
    pub data: Vec<u8>,
    /// The name of the model.
    pub name: String,
    /// The unit of the model.
    pub unit: Option<String>,
    /// The command that makes the model, up to its picks: the page shows it.
    pub command: String,
    /// Layers of a DXF file that are read; all if empty.
    pub layers: Vec<String>,
    /// The ids of the SVG elements that are read; all if empty.
    pub ids: Vec<String>,
    /// Colours of what is read, as `cspace import --color` takes them; all if empty.
    pub colors: Vec<String>,
    /// Line types of a DXF file that are read; if empty, all of outlines.
    pub linetypes: Vec<String>,
    /// Whether a rectangle around everything is left out.
    pub without_sheet: bool,
    /// Whether the outlines of a DXF file's hatches are read too.
    pub hatches: bool,
    /// Every length of the drawing is multiplied by it.
    pub scale: f64,
    /// Ends nearer than this are one (model unit).
    pub join: Option<f64>,
    /// Curves become lines and arcs within this (model unit).
    pub fit: Option<f64>,
}

/// Drawing with its source.
#[derive(Debug, Clone)]
pub struct OpenedDrawing {
    /// Source from which it was read.
    pub source: DrawingSource,
    /// Content of the drawing, in the file's unit.
    pub drawing: Drawing,
}

/// Data of a drawing's page. Lengths are in the model's unit.
#[derive(Debug, Clone, Serialize)]
pub struct DrawingScene {
    /// Always `cspace-drawing`.
    pub format: &'static str,
    /// Always 2.
    pub version: u32,
    /// Source of the model.
    pub source: DrawingSource,
    /// Curves, as the ends of lines and arcs.
    pub curves: Vec<Vec<Vertex>>,
    /// The faces, the largest first; of very many the largest only.
    pub faces: Vec<SceneFace>,
    /// The number of faces of the drawing.
    pub count: usize,
    /// The parts that `cspace import` makes without picks, if each is one face; none otherwise.
    pub parts: Vec<ImportedPart>,
    /// Problems of what bounds no face, in the words of `cspace import`, and what to do; `None` if there is nothing.
    pub dropped: Option<String>,
}

/// A part that `cspace import` makes without picks.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ImportedPart {
    /// The name that it gives to the part.
    pub name: String,
    /// Index of the face.
    pub face: usize,
}

/// A face that can be picked.
#[derive(Debug, Clone, Serialize)]
pub struct SceneFace {
    /// A point inside, which picks the face.
    pub inside: Point,
    /// The area, without what lies within.
    pub area: f64,
    /// Outer boundary, then the boundaries of the components within it.
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
#[derive(Debug, thiserror::Error)]
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
    /// The model would not be read as it is written.
    #[error(transparent)]
    Model(#[from] ModelError),
}

impl PickError {
    /// Advice on how to correct the error.
    pub fn help(&self) -> &str {
        match self {
            Self::Nothing => "click faces: each click makes a part",
            Self::Drawing(error) => error.help(),
            Self::Mechanism(_) => "rename parts on the page",
            Self::Model(error) => error.help().unwrap_or("rename parts on the page"),
        }
    }
}

impl DrawingSource {
    /// Source for the file of a drawing, with the default options of `cspace import FILE`. The drawing's unit, which is
    /// the model's, is not known before it is read: see [`OpenedDrawing::of_file`].
    fn of_file(file: &str, data: Vec<u8>) -> Self {
        Self {
            name: model_name(Path::new(file)),
            command: format!("cspace import {}", shown::word(file)),
            file: file.to_owned(),
            data,
            unit: None,
            layers: Vec::new(),
            ids: Vec::new(),
            colors: Vec::new(),
            linetypes: Vec::new(),
            without_sheet: false,
            hatches: false,
            scale: 1.0,
            join: None,
            fit: None,
        }
    }

    fn read(&self) -> Result<Drawing, DrawingError> {
        let source = Source {
            layers: self.layers.clone(),
            ids: self.ids.clone(),
            colors: self.colors.iter().map(color).collect::<Result<_, _>>()?,
            linetypes: self.linetypes.clone(),
            hatches: self.hatches,
        };
        cspace_drawing::named(&self.file, &self.data, &source)
    }

    fn settings(&self) -> Settings {
        Settings {
            scale: self.scale,
            join: self.join,
            fit: self.fit,
            without_sheet: self.without_sheet,
            ..Settings::default()
        }
    }
}

fn color(text: &String) -> Result<Color, DrawingError> {
    text.parse().map_err(|help| DrawingError::File {
        line: None,
        message: format!("{text:?} is no colour"),
        help,
    })
}

/// The name of the model of a drawing: its file's without folder and extension, in characters that a model may have.
///
/// ```
/// use cspace_api::scene::model_name;
/// assert_eq!(model_name("parts/pawl.dxf".as_ref()), "pawl");
/// ```
pub fn model_name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    shown::text(&stem).into_owned()
}

impl OpenedDrawing {
    /// Reads the drawing in the bytes of a file of this name, as `cspace view FILE` and `cspace import FILE` do without
    /// further options: in the drawing's unit.
    ///
    /// ```
    /// use cspace::Point;
    /// use cspace_api::scene::{OpenedDrawing, PickedPart};
    /// let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="8mm" height="8mm" viewBox="0 -4 8 8">
    ///     <path d="M0 0h4v-4h-4z"/><path d="M5 0h2v-2h-2z"/></svg>"#;
    /// let opened = OpenedDrawing::of_file("squares.svg", text.into())?;
    /// assert_eq!(opened.source.unit.as_deref(), Some("mm"));
    /// let picked = |name: &str, x: f64| PickedPart { name: name.into(), at: vec![Point::new(x, 1.0)] };
    /// let model = opened.model(&[picked("left", 1.0), picked("right", 6.0)])?;
    /// assert_eq!((model.name.as_str(), model.parts[1].part.area()), ("squares", 4.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the extension is not that of a drawing, or the bytes are not a drawing.
    pub fn of_file(file: &str, data: Vec<u8>) -> Result<Self, DrawingError> {
        let mut source = DrawingSource::of_file(file, data);
        let drawing = source.read()?;
        source.unit = drawing.unit.map(|unit| unit.label().to_owned());
        source.scale = Conversion::new(drawing.unit, source.unit.as_deref()).factor();
        Ok(Self { source, drawing })
    }

    /// Reads the drawing again from the source in a scene.
    ///
    /// # Errors
    /// If the extension is not that of a drawing, or the bytes are not a drawing.
    pub fn from_source(source: DrawingSource) -> Result<Self, DrawingError> {
        let drawing = source.read()?;
        Ok(Self { source, drawing })
    }

    /// The faces and curves of the drawing.
    ///
    /// # Errors
    /// If the drawing consists of measured points, its settings or coordinates are out of range, or its curves cross
    /// too often.
    pub fn scene(&self) -> Result<DrawingScene, DrawingError> {
        let settings = self.source.settings();
        let reading = self.drawing.reading(&settings)?;
        let found = reading.faces()?;
        let outlines = reading.outlines();
        let parts = outlines.map_or(None, |o| one_face_each(&o.parts, &found.faces));
        let faces = found.faces.into_iter().map(|face| SceneFace {
            inside: face.inside,
            area: face.area,
            loops: face.loops,
            refusal: face.refusal.map(|error| error.to_string()),
        });
        let dropped = (!found.dropped.is_empty()).then(|| {
            let error = DrawingError::Entities(found.dropped);
            format!("{error} ({})", error.help())
        });
        Ok(DrawingScene {
            format: FORMAT,
            version: VERSION,
            source: self.source.clone(),
            curves: found.curves,
            faces: faces.collect(),
            count: found.count,
            parts: parts.unwrap_or_default(),
            dropped,
        })
    }

    /// Model of picked parts, each of which moves freely, with all pairs.
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
            ..self.source.settings()
        };
        let parts = self.drawing.outlines(&settings)?.parts;
        let mut model = Mechanism::new(self.source.name.clone());
        model.unit.clone_from(&self.source.unit);
        model.parts = parts.into_iter().map(PartEntry::planar).collect();
        model.pairs = model.every_two();
        model.check()?;
        Ok(model)
    }

    /// Model of picked parts as TOML: equal to the file that `cspace import` writes for the same picks.
    ///
    /// # Errors
    /// As [`OpenedDrawing::model`], and if the written model is refused by the reader.
    pub fn toml(&self, picked: &[PickedPart]) -> Result<String, PickError> {
        let text = cspace_model::model::to_toml(&self.model(picked)?);
        cspace_model::model::from_toml(&text, "model.toml")?;
        Ok(text)
    }
}

/// Tolerance, as a share of the box, of areas and boxes by which a part and a face have the same outline: both consist
/// of the same lines and arcs, but the face's may begin elsewhere and are cut where others end on them.
const SAME: f64 = 1e-9;

/// The face of each part, if all parts are one face, each another.
fn one_face_each(parts: &[Part], faces: &[DrawnFace]) -> Option<Vec<ImportedPart>> {
    let mut is_taken = vec![false; faces.len()];
    let found = parts.iter().map(|part| {
        let (bounds, area) = (part.bounds(), part.area());
        let size = bounds.diagonal();
        let is_part = |face: &DrawnFace| {
            (face.area - area).abs() <= SAME * size * size
                && face.bounds.min.distance(bounds.min) <= SAME * size
                && face.bounds.max.distance(bounds.max) <= SAME * size
        };
        let face = (0..faces.len()).find(|&i| !is_taken[i] && is_part(&faces[i]))?;
        is_taken[face] = true;
        Some(ImportedPart {
            name: part.name().to_owned(),
            face,
        })
    });
    found.collect()
}
