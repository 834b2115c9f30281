//! A motion as CSV.

use cspace_model::Mechanism;
use cspace_motion::Forces;

use crate::failure::Failure;

use super::force;
use cspace_api::simulate::{Question, Simulated, moving};

/// The columns `t`, then those of each part that can move, then their rates and the forces if they are asked for.
pub(super) fn csv(
    model: &Mechanism,
    Simulated {
        simulation, record, ..
    }: &Simulated,
    question: &Question,
) -> Result<Vec<u8>, Failure> {
    let system = simulation.system();
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
    if question.rates {
        header.extend(columns("du", ["vx", "vy", "omega"]));
    }
    let pairs = simulation.pairs().list().iter();
    let pairs: Vec<[usize; 2]> = pairs.map(|p| [p.fixed, p.moving]).collect();
    let forces = match question.forces {
        true => force::columns(model, &pairs),
        false => Vec::new(),
    };
    header.extend(forces.iter().map(force::Column::name));
    let none = Forces::default();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(&header).map_err(Failure::new)?;
    for sample in &record.samples {
        let rates = sample.rates.iter().filter(|_| question.rates);
        let there = sample.forces.as_ref().unwrap_or(&none);
        let numbers = core::iter::once(&sample.t)
            .chain(&sample.coordinates)
            .chain(rates)
            .copied()
            .chain(forces.iter().map(|c| c.value(there)));
        let texts = numbers.map(|x| format!("{x:?}"));
        writer.write_record(texts).map_err(Failure::new)?;
    }
    writer.into_inner().map_err(Failure::new)
}
