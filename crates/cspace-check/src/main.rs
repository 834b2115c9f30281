//! `cspace-check PROOF.json`: checks a proof and prints the result.

use std::process::ExitCode;

const USAGE: &str = "usage: cspace-check PROOF.json

Checks a proof that there is no path: what `cspace plan FILE --from .. --to .. --proof PROOF.json` writes.
Ends with 0 if it proves what it says, and with 1 if not.";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path] = arguments.as_slice() else {
        eprintln!("{USAGE}");
        return ExitCode::FAILURE;
    };
    if path == "--help" || path == "-h" {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    let checked = (std::fs::read(path).map_err(|e| format!("{path}: {e}")))
        .and_then(|bytes| cspace_check::read(&bytes))
        .and_then(|proof| match proof.check() {
            Ok(()) => Ok(proof),
            Err(wrong) => Err(format!("not proved: {wrong}")),
        });
    match checked {
        Ok(p) => {
            println!(
                "proved: no motion of {} from {:?} to {:?} past {}",
                p.moving.name, p.start, p.goal, p.fixed.name
            );
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
