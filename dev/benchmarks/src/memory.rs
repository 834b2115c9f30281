//! Memory of the eleven pairs, counted by a program of its own.

use std::process::Command;

use serde::{Deserialize, Serialize};

use crate::Failure;

/// Memory of a pair in bytes, as requested from the allocator.
#[derive(Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) pair: String,
    /// Peak during the computation.
    pub(crate) peak_bytes: u64,
    /// Memory kept with the result.
    pub(crate) result_bytes: u64,
    pub(crate) peak_bytes_without_symmetry: u64,
    pub(crate) result_bytes_without_symmetry: u64,
}

pub(crate) fn measure() -> Result<Vec<Row>, Failure> {
    let program = std::env::current_exe()?.with_file_name("cspace-memory");
    let output = Command::new(&program)
        .output()
        .map_err(|e| format!("{}: {e}; dev/benchmarks/run builds it", program.display()))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let text = String::from_utf8(output.stdout)?;
    (text.lines().map(|line| Ok(serde_json::from_str(line)?))).collect()
}
