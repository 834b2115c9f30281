//! Bytes allocated while contact spaces are computed, one line of JSON for each pair of Figure 5.

use std::error::Error;

use cspace::{ContactSpace, Options, Symmetry};
use cspace_baseline::paper;
use cspace_model::model;
use peak_alloc::PeakAlloc;

// Counting costs time: this is a program of its own, and nothing is timed in it.
#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

fn main() -> Result<(), Box<dyn Error>> {
    for pair in &paper::PAIRS {
        let model = model::from_toml(pair.model, pair.name)?;
        let part = |index: usize| &model.parts[index].part;
        let (fixed, moving) = (part(model.pairs[0].fixed), part(model.pairs[0].moving));
        let measure = |symmetry| {
            let options = Options {
                symmetry,
                ..Options::default()
            };
            let before = MEMORY.current_usage();
            MEMORY.reset_peak_usage();
            let space = ContactSpace::compute(fixed, moving, &options)?;
            let (peak, after) = (MEMORY.peak_usage(), MEMORY.current_usage());
            drop(space);
            Ok::<_, cspace::ComputeError>([peak, after].map(|bytes| bytes.saturating_sub(before)))
        };
        // Threads and their stores are there before anything is counted.
        measure(Symmetry::Detect)?;
        let [peak, kept] = measure(Symmetry::Detect)?;
        let [peak_without, kept_without] = measure(Symmetry::Ignore)?;
        let row = serde_json::json!({
            "pair": pair.name,
            "peak_bytes": peak,
            "result_bytes": kept,
            "peak_bytes_without_symmetry": peak_without,
            "result_bytes_without_symmetry": kept_without,
        });
        println!("{row}");
    }
    Ok(())
}
