//! The kernel of the page: made by the program `build-kernel` of the workspace `cspace-wasm`, which another run of cargo
//! compiles and starts.

use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crates that the kernel consists of.
const CRATES: [&str; 9] = [
    "cspace",
    "cspace-api",
    "cspace-check",
    "cspace-design",
    "cspace-drawing",
    "cspace-model",
    "cspace-motion",
    "cspace-plan",
    "cspace-wasm",
];

/// Other files that decide how it is compiled.
const SETTINGS: [&str; 3] = [
    "cspace-wasm/build-kernel",
    "cspace-wasm/Cargo.lock",
    "../Cargo.toml",
];

/// Settings of this build that hold for that one: where packages come from, and how many processors it takes.
const KEPT: [&str; 5] = [
    "CARGO_HOME",
    "CARGO_NET_OFFLINE",
    "CARGO_HTTP_CAINFO",
    "CARGO_BUILD_JOBS",
    "RUSTC",
];

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Whether the sources of the kernel are beside this crate, as in the repository and not in a package.
pub(crate) fn is_here() -> bool {
    crates().join("cspace-wasm").is_dir()
}

/// Has the page built again when the kernel's sources change.
pub(crate) fn watch() {
    let crates = crates();
    let parts = |name| ["src", "Cargo.toml"].map(|part| Path::new(name).join(part));
    let sources = CRATES.into_iter().flat_map(parts);
    for path in sources.chain(SETTINGS.map(PathBuf::from)) {
        println!("cargo:rerun-if-changed={}", crates.join(path).display());
    }
}

/// Puts the kernel, with its JavaScript and its types, in `kernel/` of a folder, and itself as text in `kernel.txt`. All is
/// compiled in the folder `target`.
pub(crate) fn make(target: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    if !is_here() {
        return Err("the sources of the crate cspace-wasm are not beside those of this one".into());
    }
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    for (name, _) in env::vars_os() {
        let told = name.to_string_lossy();
        let of_cargo = ["CARGO_", "RUSTFLAGS", "RUSTC", "RUSTDOC", "CLIPPY"];
        if of_cargo.iter().any(|p| told.starts_with(p)) && !KEPT.contains(&&*told) {
            cargo.env_remove(&name);
        }
    }
    cargo.args(["run", "--quiet", "--locked", "--package", "build-kernel"]);
    let manifest = crates().join("cspace-wasm/Cargo.toml");
    cargo.arg("--manifest-path").arg(manifest);
    cargo.arg("--target-dir").arg(target);
    let output = cargo.arg("--").arg(folder).output();
    let output = output.map_err(|e| format!("cargo cannot be run: {e}"))?;
    if output.status.success() {
        return Ok(());
    }
    /// Number of the last lines, which contain the error.
    const LINES: usize = 12;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let said: Vec<&str> = said.lines().filter(|l| !l.trim().is_empty()).collect();
    Err(said[said.len().saturating_sub(LINES)..].join("; ").into())
}
