//! `cspace-check PROOF.json`: says whether a proof proves what it says.

use std::process::ExitCode;

fn main() -> ExitCode {
    let checked = (std::env::args()
        .nth(1)
        .ok_or("give a file: cspace-check PROOF.json".into()))
    .and_then(|path| std::fs::read(&path).map_err(|e| format!("{path}: {e}")))
    .and_then(|bytes| cspace_check::read(&bytes))
    .and_then(|proof| proof.check().map(|()| proof));
    match checked {
        Ok(p) => {
            println!(
                "proved: no motion of {} from {:?} to {:?} past {}",
                p.moving.name, p.start, p.goal, p.fixed.name
            );
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: not proved: {error}");
            ExitCode::FAILURE
        }
    }
}
