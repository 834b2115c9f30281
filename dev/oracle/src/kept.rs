//! Files that tests leave for other people's programs to judge, which `.ci/others` runs: they are not compiled for the tests.

use std::io;
use std::path::PathBuf;

/// Folder of what is left of a kind, in `left-by-tests/` of the folder of the build.
///
/// # Errors
///
/// The folder cannot be made.
pub fn folder(kind: &str) -> io::Result<PathBuf> {
    let program = std::env::current_exe()?;
    // Tests are programs in `debug/deps` of the folder of the build.
    let build = program.ancestors().nth(3);
    let build = build.ok_or_else(|| io::Error::other("the program is in no folder of a build"))?;
    let folder = build.join("left-by-tests").join(kind);
    std::fs::create_dir_all(&folder)?;
    Ok(folder)
}
