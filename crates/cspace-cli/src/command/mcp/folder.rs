//! The folder below which files are read and written.

use std::path::{Component, Path, PathBuf};

use cspace_api::Error;
use cspace_model::Refused;

use crate::failure::Failure;

/// A folder, by its path without links.
#[derive(Debug, Clone)]
pub(super) struct Folder(PathBuf);

impl Folder {
    /// The folder of a path, or the current one.
    pub(super) fn new(path: Option<&Path>) -> Result<Self, Failure> {
        let path = path.unwrap_or(Path::new("."));
        let wrong = |what: &dyn core::fmt::Display| {
            Failure::new(format_args!("--root {}: {what}", path.display()))
                .help("give a folder that is there")
        };
        let folder = path.canonicalize().map_err(|e| wrong(&e))?;
        match folder.is_dir() {
            true => Ok(Self(folder)),
            false => Err(wrong(&"it is no folder")),
        }
    }

    /// Where a file of this name would be that is not there: a model that is given as text.
    pub(super) fn beside(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The file of a path below the folder.
    ///
    /// # Errors
    /// If it is not there, or elsewhere.
    pub(super) fn file(&self, path: &str) -> Result<PathBuf, Error> {
        let full = self.0.join(path);
        self.guard(&full)
            .map_err(|refused| Error::new(refused.message).help(refused.help))?;
        Ok(full)
    }

    /// Refuses a file that is not there, or not below the folder once links are followed.
    pub(super) fn guard(&self, path: &Path) -> Result<(), Refused> {
        let shown = path.strip_prefix(&self.0).unwrap_or(path).display();
        match path.canonicalize() {
            Ok(full) if full.starts_with(&self.0) => Ok(()),
            Ok(_) => Err(outside(&shown)),
            // Of a file elsewhere nothing is said, not even whether it is there.
            Err(_) if !self.would_hold(path) => Err(outside(&shown)),
            Err(e) => Err(Refused {
                message: format!("{shown}: {e}"),
                help: "give the path of a file below the folder of this server, or the text of the model".to_owned(),
            }),
        }
    }

    /// The path of a file to write, which is below the folder.
    ///
    /// # Errors
    /// If it is elsewhere, or its folder is not there.
    pub(super) fn output(&self, path: &str) -> Result<PathBuf, Error> {
        let full = self.0.join(path);
        let folder = full.parent().unwrap_or(&self.0);
        let is_inside = folder
            .canonicalize()
            .is_ok_and(|folder| folder.starts_with(&self.0));
        // A link in the folder may lead out of it.
        let is_link = full.canonicalize().is_ok_and(|f| !f.starts_with(&self.0));
        if !is_inside || is_link || full.file_name().is_none() {
            let refused = outside(&path);
            return Err(Error::new(refused.message).help(refused.help));
        }
        Ok(full)
    }

    /// Whether a path leads below the folder by its names alone.
    fn would_hold(&self, path: &Path) -> bool {
        let Ok(below) = path.strip_prefix(&self.0) else {
            return false;
        };
        below
            .components()
            .all(|c| matches!(c, Component::Normal(_)))
    }
}

fn outside(path: &dyn core::fmt::Display) -> Refused {
    Refused {
        message: format!("{path}: it is not below the folder of this server"),
        help: "give a path in the folder that `cspace mcp --root FOLDER` was started with"
            .to_owned(),
    }
}
