//! Folders of results, written whole or not at all.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::{STANDARD, directory, pending, target};
use crate::failure::Failure;

/// The file in a folder that lists what this command has written there: what is not in it is somebody else's.
const LIST: &str = "files.txt";
/// How that file begins.
const SIGNED: &str =
    "Written by `cspace site`, which replaces this folder as long as these are its only files:";

/// A folder that takes its place once all is written.
pub(crate) struct Folder {
    place: PathBuf,
    /// Beside the place, so that it can be renamed; it is removed with all that is left in it.
    beside: TempDir,
    written: BTreeSet<String>,
}

impl Folder {
    /// Begins a folder. The place must be free, or be taken by a folder that is empty or was written by this.
    pub(crate) fn begin(path: &Path) -> Result<Self, Failure> {
        if path == Path::new(STANDARD) {
            return Err(
                Failure::new("a site is a folder, which standard output cannot be")
                    .help("give the path of a folder after -o"),
            );
        }
        // What is there under another name, such as `.`, is replaced where it is.
        let place = path.canonicalize().unwrap_or_else(|_| target(path));
        check(&place)?;
        let parent = directory(&place);
        if place.file_name().is_none() || !parent.is_dir() {
            return Err(Failure::new(format_args!(
                "{}: there is no directory {}",
                place.display(),
                parent.display()
            ))
            .help("create the directory first, or give another path after -o"));
        }
        // Whoever ends the process waits until it is known what is to be removed.
        let mut known = pending();
        let beside = (tempfile::Builder::new().prefix(".cspace-"))
            .tempdir_in(parent)
            .map_err(|e| Failure::writing(path, &e))?;
        known.unnamed = Some(beside.path().to_owned());
        drop(known);
        let folder = Self {
            place,
            beside,
            written: BTreeSet::new(),
        };
        folder.work(|| std::fs::create_dir(folder.staged()))?;
        Ok(folder)
    }

    /// Where it will be.
    pub(crate) fn place(&self) -> &Path {
        &self.place
    }

    /// Writes a file of this name, in which `/` separates folders.
    pub(crate) fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let file = self.staged().join(name);
        self.work(|| {
            std::fs::create_dir_all(directory(&file))?;
            std::fs::write(&file, bytes)
        })?;
        self.written.insert(name.to_owned());
        Ok(())
    }

    /// Copies a file.
    pub(crate) fn copy(&mut self, name: &str, from: &Path) -> Result<(), Failure> {
        let bytes = std::fs::read(from).map_err(|e| {
            Failure::new(format_args!("{}: it cannot be read: {e}", from.display()))
                .help("let it be read, or remove the links to it; nothing was written")
        })?;
        self.write(name, &bytes)
    }

    /// Writes a file that is needed only meanwhile.
    pub(crate) fn lay_aside(&self, name: &str, bytes: &[u8]) -> Result<PathBuf, Failure> {
        let file = self.beside.path().join(name);
        self.work(|| std::fs::write(&file, bytes))?;
        Ok(file)
    }

    /// Lets it take its place.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        let names = self.written.iter().map(|name| format!("{name}\n"));
        let list = format!("{SIGNED}\n{}", names.collect::<String>());
        self.write(LIST, list.as_bytes())?;
        // Much may have been done there meanwhile.
        check(&self.place)?;
        let (staged, replaced) = (self.staged(), self.beside.path().join("replaced"));
        let failed = |e: std::io::Error| Failure::writing(&self.place, &e);
        // An interrupt comes before the folder has its name, or after.
        let mut known = pending();
        let is_replacing = self.place.exists();
        if is_replacing {
            std::fs::rename(&self.place, &replaced).map_err(failed)?;
        }
        let placed = std::fs::rename(staged, &self.place);
        if placed.is_err() && is_replacing {
            std::fs::rename(&replaced, &self.place).map_err(failed)?;
        }
        placed.map_err(failed)?;
        known.unnamed = None;
        known.is_written = true;
        Ok(())
    }

    fn staged(&self) -> PathBuf {
        self.beside.path().join("site")
    }

    /// Nothing is begun once the process is about to end.
    fn work(&self, work: impl FnOnce() -> std::io::Result<()>) -> Result<(), Failure> {
        let _until_done = pending();
        work().map_err(|e| Failure::writing(&self.place, &e))
    }
}

/// Checks that a folder is missing, is empty, or holds only files that `cspace site` wrote.
fn check(place: &Path) -> Result<(), Failure> {
    let unreadable = |e: std::io::Error| {
        Failure::new(format_args!("{}: it cannot be read: {e}", place.display()))
            .help("give another folder after -o; nothing was written")
    };
    if !place.exists() {
        return Ok(());
    }
    if !place.is_dir() {
        return Err(
            Failure::new(format_args!("{}: is no folder", place.display()))
                .help("give the path of a folder after -o; nothing was written"),
        );
    }
    let mut files = Vec::new();
    files_in(place, "", &mut files).map_err(unreadable)?;
    if files.is_empty() {
        return Ok(());
    }
    let list = std::fs::read_to_string(place.join(LIST)).unwrap_or_default();
    let Some(list) = list.strip_prefix(SIGNED) else {
        return Err(Failure::new(format_args!(
            "{}: the folder is not empty, and was not written by `cspace site`",
            place.display()
        ))
        .help("give a new or empty folder after -o; nothing was written"));
    };
    let own: BTreeSet<&str> = list.lines().chain([LIST]).collect();
    match files.iter().find(|name| !own.contains(name.as_str())) {
        None => Ok(()),
        Some(other) => Err(Failure::new(format_args!(
            "{}: the file was not written by `cspace site`, which replaces the whole folder",
            place.join(other).display()
        ))
        .help("move the file elsewhere, or give another folder after -o; nothing was written")),
    }
}

/// The names of all files in a folder and its subfolders.
fn files_in(folder: &Path, before: &str, files: &mut Vec<String>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        match entry.file_type()?.is_dir() {
            true => files_in(&entry.path(), &format!("{name}/"), files)?,
            false => files.push(name),
        }
    }
    Ok(())
}
