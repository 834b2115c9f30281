//! Builds the page with Node and npm, and its kernel, into the folder of the build: no bundle is kept with the sources. A
//! package has a bundle, made for the release, since it has no sources of the kernel.
//!
//! With the feature `page` builds with optimization have the page; where it cannot be made the crate is built without, for the rest of
//! the project does not need it. `CSPACE_PAGE` overrides that. The page's commands say why there is none, and how to get it.

mod kernel;

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// Sources of the page, files and folders in `page/`.
const SOURCES: [&str; 7] = [
    "package.json",
    "package-lock.json",
    ".npmrc",
    "tsconfig.json",
    "src",
    "index.html",
    "style.css",
];

/// Files that determine the packages installed by npm.
const INSTALLED: [&str; 3] = ["package.json", "package-lock.json", ".npmrc"];

/// Files included in the library, from the page's folder in the build.
const BUNDLE: [(&str, &str); 5] = [
    ("index.html", "index.html"),
    ("style.css", "style.css"),
    ("build/page.js", "page.js"),
    ("build/worker.js", "worker.js"),
    ("build/kernel.txt", "kernel.txt"),
];

/// The oldest Node that the tools of the page run on.
const OLDEST_NODE: u32 = 20;

/// `build` builds the page, whatever the profile and the features, and fails if it cannot be made; `skip` builds without.
const SWITCH: &str = "CSPACE_PAGE";

/// Command that builds the program with its page.
const COMMAND: &str = "`cargo build --release -p cspace-cli`";

/// Why there is no page, and how to get it.
struct Missing {
    reason: String,
    help: String,
}

fn main() -> Result<(), Box<dyn Error>> {
    let sources = PathBuf::from(variable("CARGO_MANIFEST_DIR")?).join("page");
    let out = PathBuf::from(variable("OUT_DIR")?);
    println!("cargo:rerun-if-env-changed={SWITCH}");
    let bundle = out.join("bundle");
    fs::create_dir_all(&bundle)?;
    let missing = bundled(&sources, &out, &bundle)?;
    if missing.is_some() {
        for (_, name) in BUNDLE {
            fs::write(bundle.join(name), "")?;
        }
    }
    let (reason, help) = missing.map(|m| (m.reason, m.help)).unwrap_or_default();
    fs::write(bundle.join("reason.txt"), reason)?;
    fs::write(bundle.join("help.txt"), help)?;
    Ok(())
}

/// Puts the page in `bundle`, or tells why that is not to be done or cannot be done.
fn bundled(sources: &Path, out: &Path, bundle: &Path) -> Result<Option<Missing>, Box<dyn Error>> {
    let missing = |reason: &str, help: String| {
        let reason = reason.to_owned();
        Ok(Some(Missing { reason, help }))
    };
    let switch = env::var(SWITCH).unwrap_or_default();
    let is_wanted = match &*switch {
        "build" => true,
        "skip" => {
            let help = format!("build it without {SWITCH}=skip, by {COMMAND}");
            return missing("CSPACE_PAGE=skip was set", help);
        }
        "" => false,
        other => return Err(format!("{SWITCH} is `build` or `skip`, and not {other:?}").into()),
    };
    if let Some(packaged) = packaged(sources) {
        copy(&packaged, bundle)?;
        return Ok(None);
    }
    if !is_wanted && env::var_os("CARGO_FEATURE_PAGE").is_none() {
        let help = format!(
            "build the command by {COMMAND}, Python's package by \
             `pip install . --config-settings=maturin.build-args=\"--features page\"`"
        );
        return missing("the feature `page` was not chosen", help);
    }
    if !is_wanted && variable("PROFILE")? == "debug" {
        let help = format!("build it by {COMMAND}, or set {SWITCH}=build");
        return missing("debug builds leave it out", help);
    }
    for name in SOURCES {
        println!("cargo:rerun-if-changed={}", sources.join(name).display());
    }
    kernel::watch();
    let Err(error) = make(sources, out, bundle) else {
        return Ok(None);
    };
    let reason = error.to_string().lines().collect::<Vec<_>>().join(" ");
    if is_wanted {
        return Err(format!("the page cannot be built: {reason}").into());
    }
    // It may be possible when the crate is built the next time: a file that is not there is always newer.
    println!("cargo:rerun-if-changed={}", out.join("always").display());
    println!("cargo:warning=built without the page: {reason}");
    let help = format!(
        "install what is missing (Node {OLDEST_NODE} or later with npm; a compiler for WebAssembly), then build again"
    );
    missing(&reason, help)
}

fn variable(name: &str) -> Result<String, Box<dyn Error>> {
    env::var(name).map_err(|_| format!("{name} is not set").into())
}

/// The bundle of a package, which has no crate of the kernel beside it.
fn packaged(sources: &Path) -> Option<PathBuf> {
    let bundle = sources.with_file_name("bundle");
    let is_whole = BUNDLE.iter().all(|(_, name)| bundle.join(name).is_file());
    (is_whole && !kernel::is_here()).then_some(bundle)
}

/// Copies the sources to a folder of `out`, bundles them there, and puts what comes out in `bundle`.
fn make(sources: &Path, out: &Path, bundle: &Path) -> Result<(), Box<dyn Error>> {
    let work = &out.join("page");
    check_node()?;
    fs::create_dir_all(work)?;
    // Files that are no longer among the sources are removed.
    let _ = fs::remove_dir_all(work.join("src"));
    for name in SOURCES {
        copy(&sources.join(name), &work.join(name))?;
    }
    // Steps that fail early come before those that take minutes.
    install(work)?;
    let compiled = target(out).join("kernel");
    kernel::make(&compiled, &work.join("build"))?;
    npm(work, &["run", "bundle"])?;
    for (from, to) in BUNDLE {
        fs::copy(work.join(from), bundle.join(to)).map_err(|e| format!("{from}: {e}"))?;
    }
    Ok(())
}

/// Folder of all build results, of which `out` is four folders below.
fn target(out: &Path) -> PathBuf {
    out.ancestors().nth(4).unwrap_or(out).to_owned()
}

fn check_node() -> Result<(), Box<dyn Error>> {
    let output = Command::new("node").arg("--version").output();
    let output = output.map_err(|e| format!("`node` cannot be run: {e}"))?;
    let version = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    let major = version.trim_start_matches('v').split('.').next();
    match major.and_then(|m| m.parse::<u32>().ok()) {
        Some(major) if major >= OLDEST_NODE => Ok(()),
        _ => {
            Err(format!("Node {OLDEST_NODE} or later is needed, and `node` is {version:?}").into())
        }
    }
}

/// Installs what the page needs, unless that was done for the same lists before.
fn install(work: &Path) -> Result<(), Box<dyn Error>> {
    let mut wanted = String::new();
    for name in INSTALLED {
        wanted += &fs::read_to_string(work.join(name)).map_err(|e| format!("{name}: {e}"))?;
    }
    let stamp = work.join("installed.txt");
    let is_there = work.join("node_modules").is_dir();
    if is_there && fs::read_to_string(&stamp).is_ok_and(|done| done == wanted) {
        return Ok(());
    }
    // The tools are used as they were published: no script of theirs runs.
    npm(
        work,
        &["ci", "--omit=dev", "--ignore-scripts", "--fetch-retries=1"],
    )?;
    fs::write(stamp, wanted)?;
    Ok(())
}

fn npm(folder: &Path, arguments: &[&str]) -> Result<(), Box<dyn Error>> {
    let program = if cfg!(windows) { "npm.cmd" } else { "npm" };
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .map_err(|e| format!("`npm` cannot be run: {e}"))?;
    if output.status.success() {
        return Ok(());
    }
    /// Number of the first lines, which contain the error.
    const LINES: usize = 8;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let said: Vec<&str> = said.lines().filter(|l| !l.trim().is_empty()).collect();
    let said = said[..said.len().min(LINES)].join("; ");
    Err(format!("`npm {}` failed: {said}", arguments[0]).into())
}

/// Copies a file, or a folder with all that is in it.
fn copy(from: &Path, to: &Path) -> Result<(), Box<dyn Error>> {
    let failed = |e: std::io::Error| format!("{}: {e}", from.display());
    if !from.is_dir() {
        fs::copy(from, to).map_err(failed)?;
        return Ok(());
    }
    fs::create_dir_all(to).map_err(failed)?;
    for entry in fs::read_dir(from).map_err(failed)? {
        let entry = entry?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}
