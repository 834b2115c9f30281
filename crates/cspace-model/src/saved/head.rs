//! Head of a saved space, which distinguishes it from other JSON before the data are read.

use cspace::space::{DataError, SAVED_VERSION};
use serde::de::IgnoredAny;
use serde_json::value::RawValue;

use super::error::wrong;
use crate::file::without_mark;
use crate::model::no_json;
use crate::{ModelError, shown};

/// The format of the text, if it is one of those wanted, in the version that is read.
pub(super) fn head<'t>(
    text: &'t str,
    file: &str,
    wanted: &[&'static str],
) -> Result<(String, Head<'t>), ModelError> {
    let wrong = |message: String| wrong(&message, file);
    if !is_object(text) {
        // Text that is no JSON at all has its own error.
        serde_json::from_str::<IgnoredAny>(text).map_err(|e| no_json(&e).in_file(file))?;
        return Err(wrong("it is no contact space: not an object".into()));
    }
    let head: Head<'_> = serde_json::from_str(text).map_err(|e| no_json(&e).in_file(file))?;
    let format = match (head.format, head.format.and_then(as_text)) {
        (_, Some(f)) if wanted.contains(&f.as_str()) => f,
        (_, Some(found)) => {
            let (found, wanted) = (shown::cut(&found).into_owned(), wanted[0]);
            return Err(wrong(DataError::Format { found, wanted }.to_string()));
        }
        (Some(found), None) => {
            return Err(wrong(format!(
                "the format is {}, not \"contact-space\"",
                cut(found)
            )));
        }
        (None, None) => {
            return Err(wrong(
                "it is no contact space: the key \"format\" is missing".into(),
            ));
        }
    };
    // Data of another version need not have the same fields.
    match head.version {
        Some(v) if v.get() == SAVED_VERSION.to_string() => Ok((format, head)),
        Some(found) => Err(wrong(format!(
            "the format's version is {}, this program reads version {SAVED_VERSION}",
            cut(found)
        ))),
        None => Err(wrong("the format's version is missing".into())),
    }
}

/// The value as text, if it is text.
pub(super) fn as_text(value: &RawValue) -> Option<String> {
    serde_json::from_str(value.get()).ok()
}

/// A value as it stands in the file, its beginning if it is long.
pub(super) fn cut(value: &RawValue) -> String {
    shown::cut(value.get()).into_owned()
}

/// A structure would be read from a list, too.
fn is_object(text: &str) -> bool {
    text.trim_start().starts_with('{')
}

/// Head of a saved contact space: format, version, name, unit and checksum. The values are kept as raw text, for they
/// may be anything.
#[derive(serde::Deserialize)]
pub(super) struct Head<'t> {
    #[serde(borrow)]
    format: Option<&'t RawValue>,
    #[serde(borrow)]
    version: Option<&'t RawValue>,
    #[serde(borrow)]
    pub(super) name: Option<&'t RawValue>,
    #[serde(borrow)]
    pub(super) unit: Option<&'t RawValue>,
    #[serde(borrow)]
    pub(super) checksum: Option<&'t RawValue>,
}

/// Whether the text is meant to be a saved contact space: models have no format.
pub fn is_saved(text: &str) -> bool {
    let text = without_mark(text);
    is_object(text)
        && serde_json::from_str::<Head<'_>>(text).is_ok_and(|head| head.format.is_some())
}
