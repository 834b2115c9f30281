//! Results, written whole or not at all.

use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::failure::{Failure, set_answered};

/// Path that stands for standard input as FILE, and for standard output after `-o`.
pub(crate) const STANDARD: &str = "-";

/// The file to write, if it is not standard output.
fn file(path: Option<&Path>) -> Option<&Path> {
    path.filter(|p| *p != Path::new(STANDARD))
}

/// Writes to the file, or to standard output if there is none.
pub(crate) fn write(path: Option<&Path>, bytes: &[u8]) -> Result<(), Failure> {
    match file(path) {
        Some(path) if is_compressed(path) => {
            let failed = |e: std::io::Error| Failure::writing(path, &e);
            let mut packed = GzEncoder::new(Vec::new(), Compression::default());
            packed.write_all(bytes).map_err(failed)?;
            write_file(path, &packed.finish().map_err(failed)?)
        }
        Some(path) => write_file(path, bytes),
        None => write_stdout(bytes),
    }
}

/// Whether what is written to a file is compressed, as its name says.
fn is_compressed(path: &Path) -> bool {
    path.extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("gz"))
}

/// The extension of a file's name; of tables and of JSON without one that says that they are compressed.
pub(crate) fn extension(path: &Path) -> Option<&str> {
    let extension = path.extension()?.to_str()?;
    let inner = || Path::new(path.file_stem()?).extension()?.to_str();
    let is_data = |inner: &&str| {
        ["csv", "json"]
            .iter()
            .any(|e| e.eq_ignore_ascii_case(inner))
    };
    Some(match is_compressed(path) {
        true => inner().filter(is_data).unwrap_or(extension),
        false => extension,
    })
}

/// Whether the name of a file ends in an extension.
pub(crate) fn ends_in(path: &Path, extension: &str) -> bool {
    self::extension(path).is_some_and(|e| e.eq_ignore_ascii_case(extension))
}

fn write_stdout(bytes: &[u8]) -> Result<(), Failure> {
    printed(std::io::stdout().write_all(bytes))
}

/// Flushes standard output after `result` of writing to it; a reader that closed the pipe is no error.
pub(crate) fn printed(result: std::io::Result<()>) -> Result<(), Failure> {
    set_answered();
    match result.and_then(|()| std::io::stdout().flush()) {
        Ok(()) => Ok(()),
        // The reader has what it wanted, as `head` does.
        Err(e) if e.kind() == ErrorKind::BrokenPipe => Ok(()),
        Err(e) => Err(Failure::new(format_args!("standard output: {e}"))),
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
    let mut is_written = writing();
    let mut file = builder.tempfile_in(directory(&path)).map_err(failed)?;
    file.write_all(bytes).map_err(failed)?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(&path).map_err(|e| failed(e.error))?;
    *is_written = true;
    Ok(())
}

/// Whether a result has been written; held while one is being written.
static WRITTEN: Mutex<bool> = Mutex::new(false);

/// Waits until no file is half written, and says whether a result has been written. No file is begun as long as the answer is held, which is
/// to be until the process has ended.
pub(crate) fn writing() -> MutexGuard<'static, bool> {
    WRITTEN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Checks that the output can be written; to be called before any input is read and any work is done.
pub(crate) fn check(path: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = file(path) else {
        return Ok(());
    };
    if path.is_dir() {
        return Err(
            Failure::new(format_args!("{}: is a directory", path.display()))
                .help("give the path of a file after -o"),
        );
    }
    let directory = directory(path);
    if !directory.is_dir() {
        return Err(Failure::new(format_args!(
            "{}: there is no directory {}",
            path.display(),
            directory.display()
        ))
        .help("create the directory first, or give another path after -o"));
    }
    if let Some(replaced) = regular(path) {
        // What is protected is not replaced, although a name in the directory could be.
        let writable = std::fs::File::options().write(true).open(path);
        if replaced.permissions().readonly() || writable.is_err() {
            let message = format_args!("{}: the file is read-only", path.display());
            return Err(Failure::new(message).help(
                "give another path after -o, or allow writing to the file; nothing was written",
            ));
        }
    }
    if let Some(identity) = identity(path) {
        outputs().push((identity, path.to_owned()));
    }
    if is_replaceable(path) {
        // Whether a file may be made there is known only by trying. If that needs a named file, the process does not end before it is removed.
        let target = target(path);
        let _held = writing();
        tempfile::tempfile_in(self::directory(&target)).map_err(|e| Failure::writing(path, &e))?;
    }
    Ok(())
}

/// The outputs that are there already, none of which is to be read: it would be lost.
static OUTPUTS: Mutex<Vec<(Identity, PathBuf)>> = Mutex::new(Vec::new());

fn outputs() -> MutexGuard<'static, Vec<(Identity, PathBuf)>> {
    OUTPUTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Checks that a file that is about to be read is not the output, under whatever name; to be called before every file is read.
pub(crate) fn before_reading(path: &Path) -> Result<(), Failure> {
    check_apart(identity(path), OVER_INPUT)
}

/// As [`before_reading`], for the file that standard input comes from, if any.
pub(crate) fn before_reading_stdin() -> Result<(), Failure> {
    check_apart(
        stdin_identity(),
        "the output is the file that standard input comes from",
    )
}

fn check_apart(read: Option<Identity>, what: &str) -> Result<(), Failure> {
    let outputs = outputs();
    match outputs
        .iter()
        .find(|(output, _)| Some(output) == read.as_ref())
    {
        Some((_, path)) => {
            let message = format_args!("{}: {what}", path.display());
            Err(Failure::new(message).help(ANOTHER))
        }
        None => Ok(()),
    }
}

/// The reason why an output is refused, and what to do.
pub(crate) const OVER_INPUT: &str = "the output is the file that is read";
pub(crate) const ANOTHER: &str = "give another path after -o; nothing was written";

/// A regular file under whatever name; of others, such as a terminal, nothing is destroyed.
#[cfg(unix)]
type Identity = (u64, u64);

#[cfg(unix)]
fn identified(meta: &std::fs::Metadata) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    meta.is_file().then(|| (meta.dev(), meta.ino()))
}

#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    identified(&regular(path)?)
}

#[cfg(unix)]
fn stdin_identity() -> Option<Identity> {
    use std::os::fd::AsFd;
    let stdin = std::io::stdin().as_fd().try_clone_to_owned().ok()?;
    identified(&std::fs::File::from(stdin).metadata().ok()?)
}

#[cfg(not(unix))]
type Identity = PathBuf;

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    regular(path)?;
    path.canonicalize().ok()
}

/// Which file it is cannot be known.
#[cfg(not(unix))]
fn stdin_identity() -> Option<Identity> {
    None
}

/// The metadata of a regular file; `None` for anything else.
fn regular(path: &Path) -> Option<std::fs::Metadata> {
    std::fs::metadata(path)
        .ok()
        .filter(std::fs::Metadata::is_file)
}

fn is_replaceable(path: &Path) -> bool {
    std::fs::metadata(path).map_or(true, |m| m.is_file())
}

/// Where a symbolic link leads, also if nothing is there yet.
fn target(path: &Path) -> PathBuf {
    let led = || std::fs::read_link(path).map(|to| directory(path).join(to));
    let found = path.canonicalize().or_else(|_| led());
    found.unwrap_or_else(|_| path.to_owned())
}

fn directory(path: &Path) -> &Path {
    path.parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// Gives the temporary file the permissions of the file it replaces, or those of a new file.
#[cfg(unix)]
fn permissions(builder: &mut tempfile::Builder<'_, '_>, path: &Path) {
    use std::os::unix::fs::PermissionsExt;
    let mode = std::fs::metadata(path).map_or(0o666, |m| m.permissions().mode() & 0o777);
    builder.permissions(std::fs::Permissions::from_mode(mode));
}

#[cfg(not(unix))]
fn permissions(_: &mut tempfile::Builder<'_, '_>, _: &Path) {}
