//! Model files: read once, for any values of their parameters.

use std::path::{Path, PathBuf};

use cspace::{Ball, Dual};

use super::drawings::{DRAWINGS, Files};
use super::error::ModelError;
use super::locate::{in_json, in_toml, line_and_column, parameter_in_toml, part_keys_in_toml};
use super::node::Node;
use super::parameters::{Setting, Variation, middles_of_limits};
use super::read::{Model, from_tree, parameters_of};
use super::scope::Result;
use super::slopes::{Slope, Slopes, slopes};
use super::to_toml::{motion, outlines};
use super::value::Value;
use crate::file::{Host, extension, read_text, too_large, without_mark};
use crate::mechanism::Mechanism;
use crate::shown;

/// Largest model files, in bytes: each takes some 2 GB of memory and ten seconds to read. A part may have a million
/// vertices, for which JSON has room.
const LARGEST_TOML: u64 = 16 << 20;
const LARGEST_JSON: u64 = 64 << 20;

/// Largest number of bytes read from a model of this name.
fn largest(path: &Path) -> u64 {
    if extension(path) == "json" {
        LARGEST_JSON
    } else {
        LARGEST_TOML
    }
}

/// Reads a model file: `.toml`, or the same structure as `.json`.
///
/// ```
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("pin.toml");
/// std::fs::write(&path, "[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n")?;
/// let model = cspace_model::model::read(&path)?;
/// assert_eq!(model.name, "pin"); // the file's name, since the file gives none
/// assert_eq!(model.parts.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the file cannot be read or is no model; the error names the line, part, loop and vertex.
pub fn read(path: impl AsRef<Path>) -> Result<Mechanism> {
    read_hosted(path.as_ref(), &Host::default()).map(|m| m.mechanism)
}

/// As [`read`], for a host program, which was already asked whether the model may be read.
pub(crate) fn read_hosted(path: &Path, host: &Host<'_>) -> Result<Model> {
    check_extension(path)?;
    from_text(path, read_text(path, largest(path))?, host)
}

/// Refuses a file whose extension is not that of a model.
fn check_extension(path: &Path) -> Result<()> {
    let extension = extension(path);
    if !matches!(extension.as_str(), "toml" | "json") && !path.is_dir() {
        let message = match extension.as_str() {
            "" => "the name has no extension".to_owned(),
            _ => format!("the extension .{extension} is not that of a model file"),
        };
        let help = match extension.as_str() {
            "dxf" | "svg" | "csv" => {
                "make a model of the drawing first: cspace import DRAWING -o MODEL.toml"
            }
            _ => "model files end in .toml or .json",
        };
        return Err(ModelError::of_file(message)
            .with_help(help)
            .in_file(&path.display().to_string()));
    }
    Ok(())
}

/// Reads a model from the text of a file; the extension determines whether it is JSON.
pub(crate) fn from_text(path: &Path, text: String, host: &Host<'_>) -> Result<Model> {
    Template::from_text(text, path)?.model(host)
}

/// Reads a model from text; `file` is its name in errors. A model without a name has none.
pub(crate) fn in_text(text: &str, file: &str, is_json: bool, host: &Host<'_>) -> Result<Model> {
    Template::parsed(text.to_owned(), file.into(), is_json)?.unnamed(host)
}

/// Reads a model from TOML text; `file` is its name in errors.
///
/// ```
/// use cspace_model::model;
/// let model = model::from_toml("[[part]]\nname = \"pin\"\nloops = [[[6, 0, 1], [8, 0, 1]]]\n", "pin.toml")?;
/// assert_eq!(model.parts[0].part.loops().len(), 1);
/// let error = model::from_toml("[[part]]\nnmae = \"pin\"\n", "pin.toml").unwrap_err();
/// assert_eq!(error.to_string(), "pin.toml:2:1: part 0: unknown key \"nmae\"");
/// assert_eq!(error.help(), Some("did you mean `name`?"));
/// # Ok::<(), cspace_model::ModelError>(())
/// ```
///
/// # Errors
/// If the text is no model; the error names the line, part, loop and vertex.
pub fn from_toml(text: &str, file: &str) -> Result<Mechanism> {
    in_text(text, file, false, &Host::default()).map(|m| m.mechanism)
}

/// Reads a model from JSON text; `file` is its name in errors.
///
/// ```
/// let text = r#"{"part": [{"name": "pin", "loops": [[[6, 0, 1], [8, 0, 1]]]}]}"#;
/// let model = cspace_model::model::from_json(text, "pin.json")?;
/// assert_eq!(model.parts[0].part.name(), "pin");
/// # Ok::<(), cspace_model::ModelError>(())
/// ```
///
/// # Errors
/// If the text is no model; the error names the line, part, loop and vertex.
pub fn from_json(text: &str, file: &str) -> Result<Mechanism> {
    in_text(text, file, true, &Host::default()).map(|m| m.mechanism)
}

/// Template of a model whose parameters may be given other values: its text is read once.
///
/// ```
/// use cspace_model::Host;
/// use cspace_model::model::{Setting, Template};
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("pin.toml");
/// std::fs::write(&path, "[parameter]\nr = 1\n[[part]]\nname = \"pin\"\nloops = [{ circle = \"r\", at = [0, 0] }]\n")?;
/// let template = Template::read(&path, &Host::default())?;
/// for r in [0.5, 2.0] {
///     let set = [Setting { name: "r".into(), value: r.to_string() }];
///     let model = template.model(&Host { set: &set, ..Host::default() })?;
///     assert!((model.mechanism.parts[0].part.bounds().max.x - r).abs() < 1e-12);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Template {
    tree: Node,
    text: String,
    path: PathBuf,
    is_json: bool,
}

impl Template {
    /// Reads the text of a model file.
    ///
    /// # Errors
    /// If the file cannot be read, or is neither TOML nor JSON.
    pub fn read(path: impl AsRef<Path>, host: &Host<'_>) -> Result<Self> {
        let path = path.as_ref();
        (host.guard)(path).map_err(|refused| {
            ModelError::of_file(refused.message)
                .with_help(refused.help)
                .in_file(&path.display().to_string())
        })?;
        check_extension(path)?;
        Self::from_text(read_text(path, largest(path))?, path)
    }

    /// Creates a template from a text that is in no file. `path` is its name in errors; its extension determines
    /// whether it is JSON, and drawings are searched beside it.
    ///
    /// # Errors
    /// If the text is neither TOML nor JSON.
    pub fn from_text(text: String, path: impl Into<PathBuf>) -> Result<Self> {
        let path = path.into();
        // It may have been read as a saved space, which may be longer.
        let limit = largest(&path);
        if text.len() as u64 > limit {
            return Err(too_large(&path, limit));
        }
        let is_json = extension(&path) == "json";
        Self::parsed(text, path, is_json)
    }

    fn parsed(text: String, path: PathBuf, is_json: bool) -> Result<Self> {
        let tree = tree(without_mark(&text), is_json)
            .map_err(|e| e.in_file(&path.display().to_string()))?;
        Ok(Self {
            tree,
            text,
            path,
            is_json,
        })
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Path of the file, or the one that stands for it.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether a part is taken from a drawing, which is in another file.
    pub fn names_drawings(&self) -> bool {
        let Some(Node::List(parts)) = self.tree.get("part") else {
            return false;
        };
        let is_drawn = |part: &Node| DRAWINGS.iter().any(|key| part.get(key).is_some());
        parts.iter().any(is_drawn)
    }

    /// Model with the values that the host sets.
    ///
    /// # Errors
    /// If the text is no model with these values; the error names the line, part, loop and vertex.
    pub fn model(&self, host: &Host<'_>) -> Result<Model> {
        let mut model = self.unnamed(host)?;
        if model.mechanism.name.is_empty() {
            model.mechanism.name = name_of(&self.path);
        }
        Ok(model)
    }

    /// The model as it is in the text, which may give it no name.
    fn unnamed(&self, host: &Host<'_>) -> Result<Model> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let placed = |e: ModelError| {
            let text = without_mark(&self.text);
            let position = match self.is_json {
                true => in_json(text, e.tree_place()),
                false => in_toml(text, e.tree_place()),
            };
            e.at(position).in_file(&self.path.display().to_string())
        };
        let (mut model, notes) = from_tree(&self.tree, &Files { folder, host }).map_err(placed)?;
        for note in notes.on_all {
            (host.note)(&placed(note).to_string());
        }
        let on_pairs = notes.on_pairs.into_iter();
        model.on_pairs = on_pairs.map(|note| placed(note).to_string()).collect();
        Ok(model)
    }

    /// A model of this text with each parameter that is outside its limits in their middle, about which its tolerance is, and the settings
    /// that put it there, beside those with which the model was read. The nominal size of a shaft is outside its limits for most fits.
    ///
    /// # Errors
    /// If the text is no model with these values.
    pub fn about_middles(&self, set: &[Setting], model: Model) -> Result<(Vec<Setting>, Model)> {
        let mut set = set.to_vec();
        let middles = middles_of_limits(&model.parameters);
        if middles.is_empty() {
            return Ok((set, model));
        }
        set.extend(middles.iter().map(|(_, setting)| setting.clone()));
        let host = Host {
            set: &set,
            ..Host::default()
        };
        let mut moved = self.model(&host)?;
        for (i, _) in middles {
            let half =
                (model.parameters[i].deviations).map(|(a, b)| (0.5 * (a + b), 0.5 * (a + b)));
            moved.parameters[i].deviations = half;
        }
        Ok((set, moved))
    }

    /// The text with other values for parameters, where it is TOML; `None` of other text, and where a value stands in no place of its own.
    ///
    /// ```
    /// use cspace_model::model::{Setting, Template};
    /// let text = "[parameter]\nd = 3 # of the bore\n[[part]]\nname = \"pin\"\nloops = [{ circle = \"d/2\", at = [0, 0] }]\n";
    /// let template = Template::from_text(text.to_owned(), "pin.toml")?;
    /// let text = template.text_with(&[Setting::number("d", 4.5)]);
    /// assert!(text.is_some_and(|t| t.contains("d = 4.5 # of the bore")));
    /// # Ok::<(), cspace_model::ModelError>(())
    /// ```
    pub fn text_with(&self, set: &[Setting]) -> Option<String> {
        let host = Host {
            set,
            ..Host::default()
        };
        self.text_of(set, &[], &self.model(&host).ok()?.mechanism)
    }

    /// The text of a mechanism that differs from this one by values of parameters and by the outlines and motions of the parts of these
    /// indices, which are written as numbers; `None` where [`Template::text_with`] has none, and if there is more that differs.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::model::{Template, from_toml};
    /// let text = "# A pin.\n[[part]]\nname = \"pin\" # of steel\nplace = { at = [1, 0] }\nloops = [{ circle = 2, at = [0, 0] }]\n";
    /// let template = Template::from_text(text.to_owned(), "pin.toml")?;
    /// let mut drawn = from_toml(text, "pin.toml")?;
    /// drawn.name = "pin".to_owned();
    /// drawn.parts[0].part = Part::polygon("pin", &[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)])?;
    /// let text = template.text_of(&[], &[0], &drawn).unwrap_or_default();
    /// assert!(text.starts_with("# A pin.\n[[part]]\nname = \"pin\" # of steel\nloops = [\n"), "{text}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn text_of(
        &self,
        set: &[Setting],
        drawn: &[usize],
        mechanism: &Mechanism,
    ) -> Option<String> {
        if self.is_json {
            return None;
        }
        let mut text = without_mark(&self.text).to_owned();
        for setting in set {
            let place = parameter_in_toml(&text, &setting.name)?;
            let is_number = setting.value.parse::<f64>().is_ok_and(f64::is_finite);
            let value = match is_number {
                true => setting.value.clone(),
                false => format!("\"{}\"", setting.value),
            };
            text.replace_range(place, &value);
        }
        let host = Host {
            set,
            ..Host::default()
        };
        let base = match drawn {
            [] => None,
            _ => Some(self.model(&host).ok()?.mechanism),
        };
        for &part in drawn {
            let entry = mechanism.parts.get(part)?;
            let old = base.as_ref()?.parts.get(part)?;
            let mut keys = part_keys_in_toml(&text, entry.part.name())?;
            keys.sort_by_key(|(_, place)| core::cmp::Reverse(place.start));
            for (key, place) in keys {
                let value = match (&*key, entry.axis.filter(|_| entry.axis != old.axis)) {
                    ("loops", _) => outlines(entry.part.loops()),
                    ("motion", Some(axis)) => motion(axis),
                    // The outline is written where it is.
                    ("place", _) => String::new(),
                    _ => continue,
                };
                text.replace_range(place, &value);
            }
        }
        // The written text must be read back as the model.
        let read = Self::from_text(text.clone(), &self.path).ok()?;
        let read = read.model(&Host::default()).ok()?;
        (read.mechanism == *mechanism).then_some(text)
    }

    /// Computes the derivatives of the numbers of a model of this template by one of its parameters, in dual numbers:
    /// through expressions, patterns, arcs and fillets.
    ///
    /// ```
    /// use cspace_model::Host;
    /// use cspace_model::model::Template;
    /// # let folder = tempfile::tempdir()?;
    /// # let path = folder.path().join("pin.toml");
    /// std::fs::write(&path, "[parameter]\nd = 3\n[[part]]\nname = \"pin\"\nloops = [{ circle = \"d/2\", at = [0, 0] }]\n")?;
    /// let template = Template::read(&path, &Host::default())?;
    /// let model = template.model(&Host::default())?;
    /// let slopes = template.slopes(&Host::default(), &model, "d")?;
    /// assert_eq!(slopes.parts[0].loops[0][0], [-0.5, 0.0, 0.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the numbers have no derivatives, as where the parameter is the number of copies.
    pub fn slopes(&self, host: &Host<'_>, model: &Model, parameter: &str) -> Result<Slopes> {
        let variation = Variation {
            parameter,
            ranges: &[],
        };
        self.varied(host, model, &variation)
    }

    /// Computes enclosures of the numbers of a model of this template, and of their derivatives by one of its
    /// parameters, where parameters deviate from their values within `ranges` (the name, from and to). A formula
    /// without a finite enclosure, as for the angle of an arc that varies, gives all reals; arcs and fillets are on the
    /// same sides as in the model.
    ///
    /// ```
    /// use cspace_model::Host;
    /// use cspace_model::model::Template;
    /// let text = "[parameter]\nd = 3\n[[part]]\nname = \"pin\"\nloops = [{ circle = \"d/2\", at = [0, 0] }]\n";
    /// let template = Template::from_text(text.to_owned(), "pin.toml")?;
    /// let model = template.model(&Host::default())?;
    /// let d = [("d".to_owned(), -0.1, 0.2)];
    /// let enclosed = template.enclosures(&Host::default(), &model, "d", &d)?;
    /// let [lo, hi] = enclosed.parts[0].loops[0][0][0].value.ends();
    /// assert!(lo <= -1.6 && -1.45 <= hi && hi - lo < 0.151);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the numbers have no derivatives, as where the parameter is the number of copies.
    pub fn enclosures(
        &self,
        host: &Host<'_>,
        model: &Model,
        parameter: &str,
        ranges: &[(String, f64, f64)],
    ) -> Result<Slopes<Dual<1, Ball>>> {
        self.varied(host, model, &Variation { parameter, ranges })
    }

    fn varied<T: Slope>(
        &self,
        host: &Host<'_>,
        model: &Model,
        variation: &Variation<'_>,
    ) -> Result<Slopes<T>> {
        let parameters = parameters_of(&self.tree, host, Some(variation))?;
        let file = Value::root(&self.tree, &parameters.scope);
        slopes(&file, &model.mechanism)
    }
}

/// The tree of values in a text.
fn tree(text: &str, is_json: bool) -> Result<Node> {
    if text.trim().is_empty() {
        return Err(ModelError::of_file("the file is empty")
            .with_help("describe each part in a [[part]] table with its name and loops"));
    }
    if is_json {
        return serde_json::from_str(text).map_err(|e| no_json(&e));
    }
    toml::from_str(text).map_err(|e| {
        ModelError::of_file(format!("the file is no TOML: {}", e.message()))
            .with_help("see the message for what was expected there")
            .at(e.span().map(|span| line_and_column(text, span.start)))
    })
}

/// Default name of a model without one: the file's name without its extension.
fn name_of(path: &Path) -> String {
    path.file_stem()
        .map(|s| shown::text(&s.to_string_lossy()).into_owned())
        .unwrap_or_default()
}

/// Error for text that is not valid JSON.
pub(crate) fn no_json(error: &serde_json::Error) -> ModelError {
    // The position is removed from the message, at whose end the library repeats it.
    let message = error.to_string();
    let end = format!(" at line {} column {}", error.line(), error.column());
    let message = message.strip_suffix(&end).unwrap_or(&message);
    let (what, help) = if error.is_data() {
        ("", "see the message for what was expected there")
    } else if error.is_eof() {
        (
            "the file is no JSON: ",
            "the text ends too early: is the file whole?",
        )
    } else {
        (
            "the file is no JSON: ",
            "see the message for what was expected there",
        )
    };
    ModelError::of_file(format!("{what}{message}"))
        .with_help(help)
        .at((error.line() > 0).then(|| (error.line(), error.column().max(1))))
}
