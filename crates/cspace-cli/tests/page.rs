//! The page's own tests, in its own language: its kernel beside the command, and the page in a browser.
//!
//! They are skipped, and it is said why, where Node or a browser is missing; `CSPACE_PAGE=require` makes that a failure.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The package of the page.
fn package() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../cspace-view/page")
}

/// Runs npm in the package; what went wrong if it did.
fn npm(args: &[&str]) -> Result<(), String> {
    let output = Command::new("npm")
        .args(args)
        .current_dir(package())
        .env("CSPACE", env!("CARGO_BIN_EXE_cspace"))
        .output()
        .map_err(|e| format!("npm cannot be run ({e}): install Node 20 or later with npm"))?;
    if output.status.success() {
        return Ok(());
    }
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    Err(format!(
        "npm {}: {}\n{}{}",
        args.join(" "),
        output.status,
        text(&output.stdout),
        text(&output.stderr)
    ))
}

/// Says that something is not tested, also where the output of tests is captured.
fn skip(what: &str, why: &str) {
    assert!(
        std::env::var_os("CSPACE_PAGE").is_none_or(|v| v != "require"),
        "{what} cannot be tested: {why}"
    );
    let _ = writeln!(std::io::stderr(), "skipped: {what}: {why}");
}

/// The packages of the lock file, once they are there.
fn installed() -> Result<(), String> {
    npm(&["--version"])?;
    npm(&["ci", "--ignore-scripts"]).map_err(|e| format!("the packages cannot be fetched: {e}"))
}

/// The kernel that was compiled for the page of this command, put where the page's tests look for it.
fn kernel() -> Result<(), String> {
    let command = Path::new(env!("CARGO_BIN_EXE_cspace"));
    let built = command.ancestors().nth(2).unwrap_or(command);
    let (from, to) = (built.join("wasm/kernel"), package().join("build/kernel"));
    let failed = |e: std::io::Error| {
        format!(
            "the page was built without its kernel: {}: {e}",
            from.display()
        )
    };
    std::fs::create_dir_all(&to).map_err(failed)?;
    for entry in std::fs::read_dir(&from).map_err(failed)? {
        let entry = entry.map_err(failed)?;
        std::fs::copy(entry.path(), to.join(entry.file_name())).map_err(failed)?;
    }
    Ok(())
}

/// Whether a browser is in one of the places in which the tests look for it.
fn has_browser() -> bool {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let usual = [
        "/usr/bin/chromium",
        "/usr/bin/chromium-browser",
        "/usr/bin/google-chrome",
        "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    ];
    (named.into_iter().chain(usual.map(PathBuf::from))).any(|path| path.exists())
}

/// One after the other: both use the same packages and processors.
#[test]
fn the_page_passes_its_tests() {
    if let Err(why) = kernel().and_then(|()| installed()) {
        return skip("the page", &why);
    }
    for script in ["check", "test"] {
        npm(&["run", script]).unwrap_or_else(|e| panic!("{e}"));
    }
    if has_browser() {
        npm(&["run", "browser"]).unwrap_or_else(|e| panic!("{e}"));
    } else {
        skip(
            "the page in a browser",
            "install chromium, or name one in CHROMIUM",
        );
    }
}
