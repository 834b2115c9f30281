//! Results, written whole or not at all.

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::failure::Failure;

/// What stands for standard input as FILE, and for standard output after `-o`.
pub(crate) const STANDARD: &str = "-";

/// The file to write, if it is not standard output.
fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|p| *p != Path::new(STANDARD))
}

/// Writes to the file, or to standard output if there is none.
pub(crate) fn write(path: Option<&Path>, bytes: &[u8]) -> Result<(), Failure> {
    match file(path) {
        Some(path) => write_file(path, bytes),
        None => write_stdout(bytes),
    }
}

fn write_stdout(bytes: &[u8]) -> Result<(), Failure> {
    printed(std::io::stdout().write_all(bytes))
}

/// What has been printed to standard output, once all of it is there.
pub(crate) fn printed(result: std::io::Result<()>) -> Result<(), Failure> {
    match result.and_then(|()| std::io::stdout().flush()) {
        Ok(()) => Ok(()),
        // The reader has what it wanted, as `head` does.
        Err(e) if e.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(e) => Err(Failure::work(format_args!("standard output: {e}"))),
    }
}

/// Into a temporary file beside it, which then takes its name.
fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |e: std::io::Error| Failure::writing(path, &e);
    if !is_replaceable(path) {
        // A device or a pipe cannot be replaced.
        return std::fs::write(path, bytes).map_err(failed);
    }
    let path = target(path);
    let mut builder = tempfile::Builder::new();
    builder.prefix(".cspace-");
    permissions(&mut builder, &path);
    let mut file = {
        // Whoever ends the process waits until it is known what is to be removed.
        let mut known = pending();
        let file = builder.tempfile_in(directory(&path)).map_err(failed)?;
        *known = Some(file.path().to_owned());
        file
    };
    let written = (file.write_all(bytes)).and_then(|()| file.as_file().sync_all());
    let result = written.and_then(|()| file.persist(&path).map(|_| ()).map_err(|e| e.error));
    *pending() = None;
    result.map_err(failed)
}

/// A file that does not have its name yet.
static PENDING: Mutex<Option<PathBuf>> = Mutex::new(None);

fn pending() -> MutexGuard<'static, Option<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes what was not written to the end. No file is begun as long as the result is held, which is to be until the
/// process has ended: whoever waits to begin one would leave it behind.
#[must_use]
pub(crate) fn abandon() -> impl Sized {
    let mut pending = pending();
    if let Some(path) = pending.take() {
        let _ = std::fs::remove_file(path);
    }
    pending
}

/// That the output can be written is found out before the work is done.
pub(crate) fn check(path: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = file(path) else {
        return Ok(());
    };
    if path.is_dir() {
        return Err(
            Failure::input(format_args!("{}: is a directory", path.display()))
                .help("give the path of a file after -o"),
        );
    }
    let directory = directory(path);
    if !directory.is_dir() {
        return Err(Failure::input(format_args!(
            "{}: there is no directory {}",
            path.display(),
            directory.display()
        ))
        .help("create the directory first, or give another path after -o"));
    }
    if is_replaceable(path) {
        // Only trying tells whether a file may be made there. Where it needs a name for that, the process does not end meanwhile.
        let target = target(path);
        let _pending = pending();
        tempfile::tempfile_in(self::directory(&target)).map_err(|e| Failure::writing(path, &e))?;
    }
    Ok(())
}

/// That the output is not the file that is read, under whatever name: writing would destroy it.
pub(crate) fn check_apart(path: Option<&Path>, input: &Path) -> Result<(), Failure> {
    match file(path) {
        Some(path) if is_same_file(path, input) => Err(over_input(path, "the file that is read")),
        _ => Ok(()),
    }
}

/// That the output is not the file that standard input comes from.
#[cfg(unix)]
pub(crate) fn check_apart_from_stdin(path: Option<&Path>) -> Result<(), Failure> {
    use std::fs::File;
    use std::os::fd::AsFd;
    let Some(path) = file(path) else {
        return Ok(());
    };
    let stdin = std::io::stdin().as_fd().try_clone_to_owned();
    let input = stdin.and_then(|fd| File::from(fd).metadata());
    match (std::fs::metadata(path), input) {
        (Ok(output), Ok(input)) if is_same(&output, &input) => {
            Err(over_input(path, "the file that standard input comes from"))
        }
        _ => Ok(()),
    }
}

/// Which file it is cannot be known.
#[cfg(not(unix))]
pub(crate) fn check_apart_from_stdin(_: Option<&Path>) -> Result<(), Failure> {
    Ok(())
}

fn over_input(path: &Path, what: &str) -> Failure {
    let message = format_args!("{}: the output is {what}", path.display());
    Failure::input(message).help("give another path after -o; nothing was written")
}

/// Of what is no regular file, such as a terminal, nothing is destroyed.
#[cfg(unix)]
fn is_same_file(a: &Path, b: &Path) -> bool {
    match (std::fs::metadata(a), std::fs::metadata(b)) {
        (Ok(a), Ok(b)) => is_same(&a, &b),
        _ => false,
    }
}

#[cfg(unix)]
fn is_same(a: &std::fs::Metadata, b: &std::fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    a.is_file() && (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
fn is_same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b && a.is_file(),
        _ => false,
    }
}

fn is_replaceable(path: &Path) -> bool {
    std::fs::metadata(path).map_or(true, |m| m.is_file())
}

/// Where a symbolic link leads, also if nothing is there yet.
fn target(path: &Path) -> PathBuf {
    /// More links than that lead in a circle.
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        match std::fs::read_link(&path) {
            Ok(next) => path = directory(&path).join(next),
            Err(_) => break,
        }
    }
    path
}

fn directory(path: &Path) -> &Path {
    path.parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// Those of the file it replaces, or as for any new file.
#[cfg(unix)]
fn permissions(builder: &mut tempfile::Builder<'_, '_>, path: &Path) {
    use std::os::unix::fs::PermissionsExt;
    let mode = std::fs::metadata(path).map_or(0o666, |m| m.permissions().mode() & 0o777);
    builder.permissions(std::fs::Permissions::from_mode(mode));
}

#[cfg(not(unix))]
fn permissions(_: &mut tempfile::Builder<'_, '_>, _: &Path) {}
