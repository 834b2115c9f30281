//! A motion as CSV.

use cspace::Mechanism;
use cspace_motion::{Record, System};

use crate::failure::Failure;

use super::answer::moving;

/// The columns `t`, then those of each part that can move, then their rates if they are asked for.
pub(super) fn csv(
    model: &Mechanism,
    system: &System,
    record: &Record,
    with_rates: bool,
) -> Result<Vec<u8>, Failure> {
    let columns = |one: &str, three: [&str; 3]| -> Vec<String> {
        moving(model, system)
            .flat_map(|(name, part)| match part.indices().len() {
                1 => vec![format!("{name}.{one}")],
                _ => three.map(|c| format!("{name}.{c}")).to_vec(),
            })
            .collect()
    };
    let mut header = vec!["t".to_owned()];
    header.extend(columns("u", ["x", "y", "theta"]));
    if with_rates {
        header.extend(columns("du", ["vx", "vy", "omega"]));
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&header).map_err(Failure::work)?;
    for sample in &record.samples {
        let rates = sample.rates.iter().filter(|_| with_rates);
        let numbers = core::iter::once(&sample.t)
            .chain(&sample.coordinates)
            .chain(rates);
        let texts = numbers.map(|x| format!("{x:?}"));
        writer.write_record(texts).map_err(Failure::work)?;
    }
    writer.into_inner().map_err(Failure::work)
}
