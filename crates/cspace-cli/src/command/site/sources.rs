//! The models of a site.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::template::{TEMPLATES, Template};

/// Where a model comes from.
#[derive(Debug)]
pub(super) enum Source {
    File(PathBuf),
    /// A name and the text of a TOML file.
    Text(String, String),
}

impl Source {
    pub(super) fn template(name: &str, template: &Template) -> Self {
        Self::Text(name.to_owned(), template.text.to_owned())
    }

    /// The name of its page, without extension.
    pub(super) fn stem(&self) -> String {
        match self {
            Self::File(file) => stem(file),
            Self::Text(name, _) => name.clone(),
        }
    }
}

/// A file's name without its extension.
pub(super) fn stem(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or(file.as_os_str());
    stem.to_string_lossy().into_owned()
}

/// The models that the paths name, each once, in this order; without any those that `cspace new` writes.
pub(super) fn find(paths: &[PathBuf]) -> Result<Vec<Source>, Failure> {
    if paths.is_empty() {
        let sources = TEMPLATES.iter().map(|t| Source::template(t.name, t));
        return Ok(sources.collect());
    }
    let (mut seen, mut sources) = (BTreeSet::new(), Vec::new());
    for path in paths {
        let files = match path.is_dir() {
            true => {
                let files = files_below(path, "toml")?;
                if files.is_empty() {
                    return Err(Failure::input(format_args!(
                        "{}: there is no .toml file in the folder",
                        path.display()
                    ))
                    .help("name the models, or a folder that has some"));
                }
                files
            }
            false => vec![path.clone()],
        };
        for file in files {
            let known = file.canonicalize().map_err(|e| unreadable(&file, &e))?;
            if seen.insert(known) {
                sources.push(Source::File(file));
            }
        }
    }
    Ok(sources)
}

/// All files of an extension in a folder, then those in its subfolders, but hidden ones, in order.
pub(super) fn files_below(folder: &Path, extension: &str) -> Result<Vec<PathBuf>, Failure> {
    let failed = |e: std::io::Error| unreadable(folder, &e);
    let mut entries = (std::fs::read_dir(folder).map_err(failed)?)
        .collect::<Result<Vec<_>, _>>()
        .map_err(failed)?;
    entries.sort_by_key(std::fs::DirEntry::path);
    let (mut files, mut below) = (Vec::new(), Vec::new());
    for entry in entries {
        let path = entry.path();
        if entry.file_name().to_string_lossy().starts_with('.') {
            continue;
        }
        // A link to a folder might lead in a circle.
        if entry.file_type().map_err(failed)?.is_dir() {
            below.extend(files_below(&path, extension)?);
        } else if path.is_file()
            && (path.extension()).is_some_and(|e| e.eq_ignore_ascii_case(extension))
        {
            files.push(path);
        }
    }
    files.append(&mut below);
    Ok(files)
}

/// The failure for a path that cannot be read.
pub(super) fn unreadable(path: &Path, error: &std::io::Error) -> Failure {
    Failure::input(format_args!(
        "{}: it cannot be read: {error}",
        path.display()
    ))
    .help("check the path; nothing was written")
}
