//! Configuration spaces in files.
//!
//! A saved space is JSON. Its format is called `contact-space`, `fixed-axes-space` or `lower-pair`, its version is
//! [`SAVED_VERSION`](cspace::space::SAVED_VERSION); schemas of the same names in the folder `docs` of the project's repository describe every field and
//! its unit. Numbers are read back unchanged to the last bit. Two optional keys, `name` and `unit`, repeat the model's
//! labels. The key `checksum` shows whether the data were changed since: if they were, or there is no checksum, the
//! space is computed again from the parts in the file.

mod check;
mod error;
mod head;
mod trust;

use std::path::Path;

use cspace::pair::PairData;
use cspace::{ContactSpace, FixedAxesSpace, LowerPair, PairSpace};
use serde_json::value::RawValue;

use crate::file::{Host, extension, read_text, text_of, without_mark};
use crate::model::no_json;
use crate::{Model, ModelError, model};

use check::{check_angles, check_names, is_plain};
use error::{AGAIN, wrong};
pub use head::is_saved;
use head::{as_text, cut, head};
use trust::{checksum, trusted};

/// The largest file read, in bytes: that many take some gigabytes of memory, whatever they say.
const LARGEST: u64 = 1 << 30;

/// Content of a file.
#[derive(Debug)]
pub enum Document {
    /// Parts, motions, joints and pairs.
    Model(Box<Model>),
    /// The configuration space of a pair that was computed before.
    Space(Box<SavedFile>),
}

/// A saved configuration space, and what its file repeats of the model it was computed from.
///
/// ```
/// use cspace::pair::Joint;
/// use cspace::{LowerPair, PairSpace, Part, Point, Vertex};
/// use cspace_model::SavedFile;
/// let disc = |name: &str, r: f64| Part::new(name, vec![vec![Vertex::new(-r, 0.0, 1.0), Vertex::new(r, 0.0, 1.0)]]);
/// let pair = LowerPair::new(&disc("wheel", 2.0)?, &disc("hub", 1.0)?, Joint::Revolute { at: Point::ORIGIN }, None);
/// let file = SavedFile {
///     space: PairSpace::Lower(Box::new(pair)),
///     name: Some("wheel and hub".into()),
///     unit: Some("mm".into()),
/// };
/// let again = SavedFile::from_json(&file.to_json(), "hub.json")?;
/// assert_eq!(again.name, file.name);
/// assert_eq!(again.unit, file.unit);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct SavedFile {
    /// The space.
    pub space: PairSpace,
    /// Name of the model; `None` in files of earlier versions.
    pub name: Option<String>,
    /// The model's label for the unit of length, if it has one.
    pub unit: Option<String>,
}

impl SavedFile {
    /// The space and its labels as indented JSON text, with a line break at the end.
    pub fn to_json(&self) -> String {
        with_labels(&self.space, self.name.as_deref(), self.unit.as_deref())
    }

    /// Reads the text written by [`to_json`](Self::to_json); `file` is its name in errors.
    ///
    /// If the file's checksum is right, the space is the one that was written; otherwise it is computed from the file's
    /// parts, which takes as long as the first computation.
    ///
    /// # Errors
    /// If the text is no JSON, of another format or version, or damaged; if a name or the unit has control characters,
    /// or an orientation is beyond [`LARGEST_ANGLE`](crate::LARGEST_ANGLE); or if a changed space cannot be computed
    /// again.
    pub fn from_json(text: &str, file: &str) -> Result<Self, ModelError> {
        let text = without_mark(text);
        let (format, head) = head(text, file, &[CONTACT_SPACE, FIXED_AXES, LOWER_PAIR])?;
        let space = match format.as_str() {
            FIXED_AXES => FixedAxesSpace::from_data(data(text, file)?)
                .map(|space| PairSpace::FixedAxes(Box::new(space)))
                .map_err(|e| wrong(&e.to_string(), file))?,
            LOWER_PAIR => LowerPair::from_data(data(text, file)?)
                .map(|pair| PairSpace::Lower(Box::new(pair)))
                .map_err(|e| wrong(&e.to_string(), file))?,
            _ => PairSpace::Planar(std::sync::Arc::new(contact_space(text, file)?)),
        };
        check_names(&space, file)?;
        check_angles(&space, file)?;
        let told = head.checksum.and_then(as_text);
        let space = trusted(space, told.as_deref()).map_err(|e| wrong(&e.to_string(), file))?;
        let label = |key: &str, value: Option<&RawValue>| {
            let Some(value) = value else {
                return Ok(None);
            };
            let text = as_text(value).ok_or_else(|| {
                wrong(
                    &format!("the key {key:?} is no text but {}", cut(value)),
                    file,
                )
            })?;
            is_plain(key, &text, file).map(|()| Some(text))
        };
        Ok(Self {
            space,
            name: label("name", head.name)?,
            unit: label("unit", head.unit)?,
        })
    }
}

/// Reads a model, or a saved contact space: a JSON object with the key `format`.
///
/// ```
/// use cspace_model::Document;
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("pin.toml");
/// std::fs::write(&path, "[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n")?;
/// match cspace_model::read(&path)? {
///     Document::Model(model) => assert_eq!(model.mechanism.parts.len(), 1),
///     Document::Space(_) => unreachable!(),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the file cannot be read, or is neither; the error names the place and gives advice.
pub fn read(path: impl AsRef<Path>) -> Result<Document, ModelError> {
    read_hosted(path, &Host::default())
}

/// As [`read`], for a host program.
///
/// # Errors
/// As [`read`], and if the host's guard refuses a file.
pub fn read_hosted(path: impl AsRef<Path>, host: &Host<'_>) -> Result<Document, ModelError> {
    let path = path.as_ref();
    (host.guard)(path).map_err(|refused| {
        ModelError::of_file(refused.message)
            .with_help(refused.help)
            .in_file(&path.display().to_string())
    })?;
    if extension(path) == "json" {
        let text = read_text(path, LARGEST)?;
        if is_saved(&text) {
            let file = SavedFile::from_json(&text, &path.display().to_string())?;
            return Ok(Document::Space(Box::new(file)));
        }
        return model::from_text(path, text, host).map(|m| Document::Model(Box::new(m)));
    }
    model::read_hosted(path, host).map(|m| Document::Model(Box::new(m)))
}

/// As [`read`], from a reader; `file` is its name in errors. Text that begins with a brace is JSON, other text TOML.
///
/// # Errors
/// As [`read`].
pub fn read_from(source: impl std::io::Read, file: &str) -> Result<Document, ModelError> {
    read_from_hosted(source, file, &Host::default())
}

/// As [`read_from`], for a host program, whose guard is asked before a drawing is opened that the model names.
///
/// # Errors
/// As [`read_from`], and if the guard refuses a file.
pub fn read_from_hosted(
    source: impl std::io::Read,
    file: &str,
    host: &Host<'_>,
) -> Result<Document, ModelError> {
    let text = text_of(source, LARGEST, file)?;
    let is_json = without_mark(&text).trim_start().starts_with('{');
    if is_json && is_saved(&text) {
        let saved = SavedFile::from_json(&text, file)?;
        return Ok(Document::Space(Box::new(saved)));
    }
    let mut model = model::in_text(&text, file, is_json, host)?;
    if model.mechanism.name.is_empty() {
        file.clone_into(&mut model.mechanism.name);
    }
    Ok(Document::Model(Box::new(model)))
}

/// Reads a contact space from JSON text; `file` is its name in errors.
///
/// ```
/// use cspace::{ContactSpace, Options, Part, Vertex};
/// use cspace_model::saved;
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
/// let text = saved::to_json(&space);
/// let again = saved::from_json(&text, "space.json")?;
/// assert_eq!(again.data(), space.data());
/// let error = saved::from_json(r#"{"format": "contact-space", "version": 99}"#, "old.json").unwrap_err();
/// assert!(error.message().contains("version is 99"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the text is no JSON, of another format or version, or damaged.
pub fn from_json(text: &str, file: &str) -> Result<ContactSpace, ModelError> {
    let text = without_mark(text);
    head(text, file, &[CONTACT_SPACE])?;
    match SavedFile::from_json(text, file)?.space {
        PairSpace::Planar(space) => Ok(std::sync::Arc::unwrap_or_clone(space)),
        _ => Err(wrong("it is no contact space", file)),
    }
}

/// Reads the configuration space of a pair of any class from JSON text; `file` is its name in errors.
///
/// # Errors
/// If the text is no JSON, of another format or version, or damaged.
pub fn pair_from_json(text: &str, file: &str) -> Result<PairSpace, ModelError> {
    SavedFile::from_json(text, file).map(|f| f.space)
}

const CONTACT_SPACE: &str = "contact-space";
const FIXED_AXES: &str = "fixed-axes-space";
const LOWER_PAIR: &str = "lower-pair";

fn contact_space(text: &str, file: &str) -> Result<ContactSpace, ModelError> {
    ContactSpace::from_data(data(text, file)?).map_err(|e| wrong(&e.to_string(), file))
}

fn data<T: serde::de::DeserializeOwned>(text: &str, file: &str) -> Result<T, ModelError> {
    serde_json::from_str(text).map_err(|e| no_json(&e).with_help(AGAIN).in_file(file))
}

/// The contact space as indented JSON text, with a line break at the end.
///
/// For an example see [`from_json`].
pub fn to_json(space: &ContactSpace) -> String {
    labelled(PairData::Planar(space.data()), None, None)
}

/// Writes the configuration space of a pair of any class as indented JSON text, with a line break at the end.
///
/// To write the model's name and unit as well, see [`with_labels`].
pub fn pair_to_json(space: &PairSpace) -> String {
    with_labels(space, None, None)
}

/// The configuration space of a pair of any class, with what its model is called and the label of its unit of length, as
/// indented JSON text with a line break at the end. [`SavedFile`] is both together, as they are read.
pub fn with_labels(space: &PairSpace, name: Option<&str>, unit: Option<&str>) -> String {
    labelled(space.data(), name, unit)
}

fn labelled(space: PairData<'_>, name: Option<&str>, unit: Option<&str>) -> String {
    let labelled = Labelled {
        name,
        unit,
        checksum: checksum(&space),
        space,
    };
    // Plain data with text for keys can always be written.
    let mut text = serde_json::to_string_pretty(&labelled).unwrap_or_default();
    text.push('\n');
    text
}

#[derive(serde::Serialize)]
struct Labelled<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<&'a str>,
    checksum: String,
    #[serde(flatten)]
    space: PairData<'a>,
}
