//! Builds the kernel of the page: `build-kernel OUT_FOLDER`.
//!
//! Compiles `cspace-wasm` for WebAssembly. Puts the WebAssembly, its JavaScript and its types in `kernel/` of the folder, and
//! the WebAssembly as the page has it, compressed by gzip and written in base 64, in `kernel.txt`.

use std::env;
use std::error::Error;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use wasm_bindgen_cli_support::Bindgen;

const TARGET: &str = "wasm32-unknown-unknown";

/// Manifest of the crate that is compiled.
const MANIFEST: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml");

/// Folder of Debian's packages `rustc-web`, `cargo-web` and `lld`, which compile for WebAssembly where rustup is not
/// available.
const SYSTEM: &str = "/usr/bin";

/// Flags for what runs on this machine.
const FLAGS: [&str; 3] = [
    "RUSTFLAGS",
    "CARGO_BUILD_RUSTFLAGS",
    "CARGO_ENCODED_RUSTFLAGS",
];

/// Compiler for WebAssembly.
enum Compiler {
    /// The one that compiled this program, with the target's library.
    Own,
    /// The system's, which compiles the library too.
    System,
}

fn main() -> ExitCode {
    let arguments: Vec<_> = env::args_os().skip(1).collect();
    let [folder] = &arguments[..] else {
        eprintln!("usage: build-kernel OUT_FOLDER");
        return ExitCode::from(2);
    };
    match build(Path::new(folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn build(folder: &Path) -> Result<(), Box<dyn Error>> {
    let compiler = compiler().ok_or(
        "there is no compiler for WebAssembly: run `rustup target add wasm32-unknown-unknown`, or on Debian \
         `apt-get install rustc-web cargo-web rust-web-src lld`",
    )?;
    let compiled = compile(&compiler)?;
    let kernel = folder.join("kernel");
    let failed = |e: std::io::Error| format!("{}: {e}", folder.display());
    fs::create_dir_all(&kernel).map_err(failed)?;
    let mut bindings = Bindgen::new();
    let bindings = bindings.input_path(compiled).out_name("cspace").web(true)?;
    bindings
        .typescript(true)
        .omit_default_module_path(true)
        .remove_name_section(true)
        .generate(&kernel)
        .map_err(|e| format!("wasm-bindgen: {e}"))?;
    let bytes = fs::read(kernel.join("cspace_bg.wasm")).map_err(failed)?;
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    gzip.write_all(&bytes)?;
    let packed = BASE64_STANDARD.encode(gzip.finish()?);
    fs::write(folder.join("kernel.txt"), packed).map_err(failed)?;
    Ok(())
}

fn compiler() -> Option<Compiler> {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let library = Command::new(rustc)
        .args(["--print", "target-libdir", "--target", TARGET])
        .output();
    if let Ok(library) = library
        && library.status.success()
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

/// Compiles in a target folder of its own, beside that of this program, and gives the path of what comes out.
fn compile(compiler: &Compiler) -> Result<PathBuf, Box<dyn Error>> {
    let program = env::current_exe()?;
    let target = program.ancestors().nth(2).unwrap_or(&program).join("wasm");
    let mut cargo = match compiler {
        Compiler::Own => Command::new(env::var_os("CARGO").unwrap_or("cargo".into())),
        Compiler::System => Command::new(Path::new(SYSTEM).join("cargo")),
    };
    for name in FLAGS {
        cargo.env_remove(name);
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
    cargo.args(["build", "--package", "cspace-wasm", "--locked"]);
    cargo.args(["--profile", "wasm", "--target", TARGET]);
    cargo.args(["--manifest-path", MANIFEST]);
    cargo.arg("--target-dir").arg(&target);
    let status = cargo
        .status()
        .map_err(|e| format!("cargo cannot be run: {e}"))?;
    if status.success() {
        Ok(target.join(TARGET).join("wasm/cspace_wasm.wasm"))
    } else {
        Err("cspace-wasm cannot be compiled for WebAssembly".into())
    }
}
