//! Measures the cost of a motion's steps: `cargo run --release -p cspace-motion --example steps -- MODEL TIME
//! [kinematic]`.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use cspace_motion::{Settings, Simulation};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [file, time, mode @ ..] = &args[..] else {
        return Err("a model and a time, please".into());
    };
    let cspace_model::Document::Model(model) = cspace_model::read(Path::new(file))? else {
        return Err("a space is no mechanism".into());
    };
    let begin = Instant::now();
    let simulation = Simulation::new(&model.mechanism)?;
    let prepared = begin.elapsed();
    let time: f64 = time.parse()?;
    // Samples at the two ends alone, so that steps are what takes the time.
    let settings = Settings {
        time,
        every: Some(time),
    };
    let begin = Instant::now();
    let record = if mode.is_empty() {
        simulation.dynamic(&settings)?
    } else {
        simulation.kinematic(&settings)?
    };
    let took = begin.elapsed();
    let steps = record.trace.len();
    println!("{:?} at {} s", record.status, record.until);
    println!("prepared in {prepared:.1?}, moved in {took:.1?}");
    println!(
        "{steps} steps, {} events, {:.1} µs a step",
        record.events.len(),
        1e6 * took.as_secs_f64() / steps as f64
    );
    Ok(())
}
