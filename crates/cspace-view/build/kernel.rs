//! The kernel of the page: the crate `cspace-wasm`, compiled for WebAssembly by another run of cargo.

use std::env;
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use wasm_bindgen_cli_support::Bindgen;

const TARGET: &str = "wasm32-unknown-unknown";

/// Crates that this one and its dependencies consist of, beside this crate's folder.
const CRATES: [&str; 11] = [
    "cspace",
    "cspace-answers",
    "cspace-check",
    "cspace-design",
    "cspace-drawing",
    "cspace-io",
    "cspace-mechanism",
    "cspace-motion",
    "cspace-plan",
    "cspace-scene",
    "cspace-wasm",
];

/// Folder of Debian's packages `rustc-web`, `cargo-web` and `lld`, which compile for WebAssembly where rustup is not
/// available.
const SYSTEM: &str = "/usr/bin";

/// Compiler for WebAssembly.
enum Compiler {
    /// Compiler of this build, with the target's library.
    Own,
    /// The system's, which compiles the library too.
    System,
}

/// Whether the sources of the kernel are beside this crate, as in the repository and not in a package.
pub(crate) fn is_here() -> bool {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    crates.join("cspace-wasm").is_dir()
}

/// Compiles the kernel; puts its JavaScript and its types in `glue`, and itself, compressed and as text, in `packed`.
pub(crate) fn make(target: &Path, glue: &Path, packed: &Path) -> Result<(), Box<dyn Error>> {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for name in CRATES {
        for part in ["src", "Cargo.toml"] {
            println!(
                "cargo:rerun-if-changed={}",
                crates.join(name).join(part).display()
            );
        }
    }
    // How it is compiled is said there.
    let workspace = crates.join("../Cargo.toml");
    if workspace.exists() {
        println!("cargo:rerun-if-changed={}", workspace.display());
    }
    if !is_here() {
        return Err("the sources of the crate cspace-wasm are not beside those of this one".into());
    }
    let compiler = compiler().ok_or(
        "there is no compiler for WebAssembly: run `rustup target add wasm32-unknown-unknown`, or on Debian \
         `apt-get install rustc-web cargo-web rust-web-src lld`",
    )?;
    let compiled = compile(&compiler, &crates.join("cspace-wasm/Cargo.toml"), target)?;
    let mut bindings = Bindgen::new();
    let bindings = bindings.input_path(compiled).out_name("cspace").web(true)?;
    let bindings = bindings
        .typescript(true)
        .omit_default_module_path(true)
        .remove_name_section(true);
    bindings
        .generate(glue)
        .map_err(|e| format!("wasm-bindgen: {e}"))?;
    let bytes = std::fs::read(glue.join("cspace_bg.wasm"))?;
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    gzip.write_all(&bytes)?;
    std::fs::write(packed, BASE64_STANDARD.encode(gzip.finish()?))?;
    Ok(())
}

fn compiler() -> Option<Compiler> {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let library = Command::new(rustc)
        .args(["--print", "target-libdir", "--target", TARGET])
        .output()
        .ok()?;
    if library.status.success()
        && Path::new(String::from_utf8_lossy(&library.stdout).trim()).is_dir()
    {
        return Some(Compiler::Own);
    }
    let sysroot = Command::new(Path::new(SYSTEM).join("rustc"))
        .args(["--print", "sysroot"])
        .output()
        .ok()?;
    let sources = Path::new(String::from_utf8_lossy(&sysroot.stdout).trim())
        .join("lib/rustlib/src/rust/library");
    let has = |tool: &str| Path::new(SYSTEM).join(tool).exists();
    (sources.is_dir() && has("cargo") && has("wasm-ld")).then_some(Compiler::System)
}

/// Compiles in a target folder of its own, and gives the path of what comes out.
fn compile(compiler: &Compiler, manifest: &Path, target: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let mut cargo = match compiler {
        Compiler::Own => Command::new(env::var_os("CARGO").unwrap_or("cargo".into())),
        Compiler::System => Command::new(Path::new(SYSTEM).join("cargo")),
    };
    // Settings of this build are not meant for that one.
    for (name, _) in env::vars_os() {
        let told = name.to_string_lossy();
        let kept = ["CARGO_HOME", "CARGO_NET_OFFLINE", "CARGO_HTTP_CAINFO"].contains(&&*told);
        if !kept
            && ["CARGO_", "RUSTFLAGS", "RUSTC", "RUSTDOC", "CLIPPY"]
                .iter()
                .any(|p| told.starts_with(p))
        {
            if let Compiler::Own = compiler
                && told == "RUSTC"
            {
                continue;
            }
            cargo.env_remove(&name);
        }
    }
    if let Compiler::System = compiler {
        let path = env::var("PATH").unwrap_or_default();
        cargo.env("RUSTC", Path::new(SYSTEM).join("rustc"));
        cargo.env("PATH", format!("{SYSTEM}:{path}"));
        // The library is compiled along, which only compilers in development are allowed otherwise.
        cargo.env("RUSTC_BOOTSTRAP", "1");
        cargo.env(
            "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER",
            Path::new(SYSTEM).join("wasm-ld"),
        );
        cargo.arg("-Zbuild-std=std,panic_abort");
        // Sorting and writing numbers alone would be a quarter of the kernel.
        cargo.arg("-Zbuild-std-features=optimize_for_size");
    }
    cargo.arg("build").arg("--manifest-path").arg(manifest);
    cargo.args([
        "--profile",
        "wasm",
        "--target",
        TARGET,
        "--locked",
        "--quiet",
    ]);
    cargo.env("CARGO_TARGET_DIR", target);
    let output = cargo
        .output()
        .map_err(|e| format!("cargo cannot be run: {e}"))?;
    if output.status.success() {
        return Ok(target.join(TARGET).join("wasm/cspace_wasm.wasm"));
    }
    /// Number of the last lines, which contain the error.
    const LINES: usize = 12;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let said: Vec<&str> = said.lines().filter(|l| !l.trim().is_empty()).collect();
    let said = said[said.len().saturating_sub(LINES)..].join("; ");
    Err(format!("the kernel cannot be compiled for WebAssembly: {said}").into())
}
