//! The text of a file.

use std::io::Read;
use std::path::Path;

use crate::ModelError;
use crate::model::Setting;

/// The reason why a file is not to be opened, and what to do about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refused {
    /// The reason.
    pub message: String,
    /// Advice.
    pub help: String,
}

/// The program on whose behalf a file is read.
pub struct Host<'a> {
    /// Check of every file before it is opened: a model, and each drawing that it names.
    pub guard: &'a dyn Fn(&Path) -> Result<(), Refused>,
    /// The receiver of remarks for whoever reads the model, such as that a drawing is converted from another unit.
    pub note: &'a dyn Fn(&str),
    /// Values of a model's parameters in place of those in the file; of two for one parameter the last counts.
    pub set: &'a [Setting],
}

impl Default for Host<'_> {
    /// Every file may be opened, remarks are dropped, and parameters have the values of the file.
    fn default() -> Self {
        Self {
            guard: &|_| Ok(()),
            note: &|_| (),
            set: &[],
        }
    }
}

/// The text of a file of at most `limit` bytes.
///
/// Only regular files are opened: a pipe might never say anything, a device might never end.
pub(crate) fn read_text(path: &Path, limit: u64) -> Result<String, ModelError> {
    let error = |message: String, help: &str| {
        ModelError::of_file(message)
            .with_help(help)
            .in_file(&path.display().to_string())
    };
    let unreadable = |e: &std::io::Error, help| error(format!("it cannot be read: {e}"), help);
    let too_large = || too_large(path, limit);
    let meta = std::fs::metadata(path).map_err(|e| unreadable(&e, "check the path"))?;
    if meta.is_dir() {
        return Err(error("it is a folder".into(), "give a file"));
    }
    if !meta.is_file() {
        return Err(error(
            "it is no regular file but a device or a pipe".into(),
            "write the text to a file, and give that",
        ));
    }
    if meta.len() > limit {
        return Err(too_large());
    }
    let file = std::fs::File::open(path)
        .map_err(|e| unreadable(&e, "check that you are allowed to read it"))?;
    // The file may grow while it is read.
    text_of(file, limit, &path.display().to_string())
}

/// The text that a reader gives, of at most `limit` bytes; `file` is what errors call it.
pub(crate) fn text_of(source: impl Read, limit: u64, file: &str) -> Result<String, ModelError> {
    let error =
        |message: String, help: &str| ModelError::of_file(message).with_help(help).in_file(file);
    let mut bytes = Vec::new();
    (source.take(limit + 1).read_to_end(&mut bytes)).map_err(|e| {
        error(
            format!("it cannot be read: {e}"),
            "check the disk, or copy the file",
        )
    })?;
    if bytes.len() as u64 > limit {
        return Err(too_large(Path::new(file), limit));
    }
    String::from_utf8(bytes).map_err(|e| {
        error(
            format!(
                "it is not text: byte {} is no UTF-8",
                e.utf8_error().valid_up_to()
            ),
            "the text must be UTF-8: save it again in that encoding",
        )
    })
}

/// Error for a file of more than `limit` bytes.
pub(crate) fn too_large(path: &Path, limit: u64) -> ModelError {
    let help = if extension(path) == "toml" {
        "write it as .json, of which more is read, or split it into several files"
    } else {
        "split it into several files"
    };
    ModelError::of_file(format!("it is too large: at most {limit} bytes are read"))
        .with_help(help)
        .in_file(&path.display().to_string())
}

/// The text without a byte order mark, which some editors put first.
pub(crate) fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

/// Extension in small letters; empty if there is none.
pub(crate) fn extension(path: &Path) -> String {
    path.extension()
        .and_then(|e| e.to_str())
        .unwrap_or_default()
        .to_ascii_lowercase()
}
