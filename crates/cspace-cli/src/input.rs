//! Files that are read, each of which is known to [`output`](crate::output) before.

use std::io::Read;
use std::path::{Path, PathBuf};

use cspace_drawing::{Drawing, DrawingError, Source};
use cspace_model::model::{Parameter, Template};
use cspace_model::saved;
use cspace_model::shown::number;
use cspace_model::{Document, Host, Mechanism, Model, Refused};

use crate::args::SetArgs;
use crate::failure::{Failure, note};
use crate::output::{self, ANOTHER, OVER_INPUT, STANDARD};
use crate::wording;

/// The name of standard input in messages.
const STDIN: &str = "standard input";

/// Asks before a file is opened whether the output would overwrite it.
fn guard(path: &Path) -> Result<(), Refused> {
    output::before_reading(path).map_err(|_| Refused {
        message: OVER_INPUT.to_owned(),
        help: ANOTHER.to_owned(),
    })
}

/// This command, as the readers of models know it.
pub(crate) fn host(values: &SetArgs) -> Host<'_> {
    Host {
        guard: &guard,
        note: &|text| note(format_args!("{text}")),
        set: &values.set,
    }
}

/// The model that FILE names, and its text, of which the parameters may be given other values.
pub(crate) fn template(file: &Path, values: &SetArgs) -> Result<(Template, Model), Failure> {
    if file == Path::new(STANDARD) {
        return Err(Failure::new(
            "the model is read several times, which standard input cannot be",
        )
        .help("give the name of a file"));
    }
    output::before_reading(file)?;
    let host = host(values);
    let template = Template::read(file, &host)?;
    if saved::is_saved(template.text()) {
        return Err(Failure::new(format_args!(
            "{}: the file is a saved contact space of two parts",
            file.display()
        ))
        .help("give the model file, whose parameters can have other values"));
    }
    let model = template.model(&host)?;
    tell_sizes(&model.mechanism);
    Ok((template, model))
}

/// The model or saved space that FILE names, with the values that its parameters are given, and how messages call it.
pub(crate) fn document(file: &Path, values: &SetArgs) -> Result<(PathBuf, Document), Failure> {
    let host = host(values);
    let (path, mut document) = if file == Path::new(STANDARD) {
        output::before_reading_stdin()?;
        let read = cspace_model::read_from_hosted(std::io::stdin().lock(), STDIN, &host)?;
        (PathBuf::from(STDIN), read)
    } else {
        output::before_reading(file)?;
        (file.to_owned(), cspace_model::read_hosted(file, &host)?)
    };
    match &mut document {
        Document::Model(model) => {
            let Model {
                mechanism,
                parameters,
                ..
            } = &mut **model;
            tell_sizes(mechanism);
            let values = values_of(parameters);
            if !values.is_empty() {
                note(format_args!("{}: with {values}", path.display()));
                mechanism.name.push_str(&format!(" ({values})"));
            }
        }
        Document::Space(_) if values.set.is_empty() => {}
        Document::Space(_) => {
            return Err(Failure::new(format_args!(
                "{}: --set is about parameters of models, and the file is a saved contact space",
                path.display()
            ))
            .help("give the model file"));
        }
    }
    Ok((path, document))
}

/// Lengths of the model are told as finely as its parts are large.
fn tell_sizes(mechanism: &Mechanism) {
    let sizes = mechanism.parts.iter().map(|p| p.part.size());
    wording::tell_lengths_of(sizes.fold(0.0, f64::max));
}

/// The values that were set, such as `pin = 6.2, n = 4`.
fn values_of(parameters: &[Parameter]) -> String {
    let set = parameters.iter().filter(|p| p.is_set);
    let values: Vec<String> = set
        .map(|p| format!("{} = {}", p.name, number(p.value)))
        .collect();
    values.join(", ")
}

/// Reads a drawing. The inner error is one in its content, which the caller reports.
pub(crate) fn drawing(
    path: &Path,
    source: &Source,
) -> Result<Result<Drawing, DrawingError>, Failure> {
    output::before_reading(path)?;
    Ok(cspace_drawing::read(path, source))
}

/// The bytes of a drawing's file. The inner error is one in its content, which the caller reports.
pub(crate) fn drawing_bytes(path: &Path) -> Result<Result<Vec<u8>, DrawingError>, Failure> {
    output::before_reading(path)?;
    Ok(cspace_drawing::bytes_of(path))
}

/// The bytes of a regular file, of at most `limit` bytes, also once they are not compressed any more; `help` says what the file is to be.
///
/// A pipe might never say anything, a device might never end.
pub(crate) fn bytes(path: &Path, limit: u64, help: &str) -> Result<Vec<u8>, Failure> {
    let wrong = |what: String| Failure::new(format_args!("{}: {what}", path.display())).help(help);
    let unreadable = |e: std::io::Error| wrong(format!("it cannot be read: {e}"));
    output::before_reading(path)?;
    let meta = std::fs::metadata(path).map_err(unreadable)?;
    if !meta.is_file() {
        return Err(wrong("it is no regular file".to_owned()));
    }
    let file = std::fs::File::open(path).map_err(unreadable)?;
    let too_large = || wrong(format!("it is too large: at most {limit} bytes are read"));
    if meta.len() > limit {
        return Err(too_large());
    }
    let bytes = taken(file, limit)
        .map_err(unreadable)?
        .ok_or_else(too_large)?;
    if !bytes.starts_with(&GZIP) {
        return Ok(bytes);
    }
    taken(flate2::read::GzDecoder::new(&bytes[..]), limit)
        .map_err(|e| wrong(format!("what is compressed in it cannot be read: {e}")))?
        .ok_or_else(too_large)
}

/// How compressed files begin.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// The bytes of standard input, of at most `limit`; `help` says what to do if there are more.
pub(crate) fn stdin(limit: u64, help: &str) -> Result<Vec<u8>, Failure> {
    output::before_reading_stdin()?;
    let wrong = |what: String| Failure::new(format_args!("{STDIN}: {what}"));
    let too_large = || wrong(format!("it is too large: at most {limit} bytes are read")).help(help);
    taken(std::io::stdin().lock(), limit)
        .map_err(|e| wrong(e.to_string()))?
        .ok_or_else(too_large)
}

/// All that a reader gives; nothing if that is more than the limit.
fn taken(source: impl Read, limit: u64) -> std::io::Result<Option<Vec<u8>>> {
    let mut bytes = Vec::new();
    source.take(limit + 1).read_to_end(&mut bytes)?;
    Ok((bytes.len() as u64 <= limit).then_some(bytes))
}
