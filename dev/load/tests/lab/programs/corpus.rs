//! The families, all values of each: no answer is wrong beyond 1e-10 of the size, nothing panics, and what is no part is
//! refused.

use std::collections::HashSet;

use cspace::{PartError, Silent};
use cspace_load::{Effort, Fault, Report, check};
use cspace_oracle::{effort, families};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Number of configurations asked of each pair: enough to detect a missing region or arc, but not a corner of 1e-8.
const CONFIGURATIONS: usize = 60;
const BANDS: usize = 6;

/// Outcome for one value of one family.
struct Outcome {
    family: &'static str,
    value: f64,
    came: Result<Report, PartError>,
}

fn outcomes() -> Vec<Outcome> {
    // Of each family the first value and, by default, few others.
    let every = effort(6, 1);
    let all: Vec<_> = families()
        .into_iter()
        .flat_map(|f| {
            f.values
                .clone()
                .into_iter()
                .step_by(every)
                .map(move |v| (f.clone(), v))
        })
        .collect();
    all.par_iter()
        .enumerate()
        .map(|(i, (family, value))| {
            let effort = Effort {
                configurations: CONFIGURATIONS,
                bands: BANDS,
                thorough: true,
            };
            let mut rng = ChaCha8Rng::seed_from_u64(i as u64);
            let came = family
                .build(*value)
                .map(|case| check(&case, effort, &mut rng, &Silent).unwrap());
            Outcome {
                family: family.name,
                value: *value,
                came,
            }
        })
        .collect()
}

#[test]
fn families_have_names_of_their_own() {
    let all = families();
    let names: HashSet<_> = all.iter().map(|f| f.name).collect();
    assert_eq!(names.len(), all.len());
    let values: usize = all.iter().map(|f| f.values.len()).sum();
    assert!(values >= 300, "{values}");
}

/// Values of a family that are no parts, with their errors.
struct Refused {
    family: &'static str,
    values: &'static [f64],
    rightly: fn(&PartError) -> bool,
}

const REFUSED: [Refused; 1] = [Refused {
    // Details below 2⁻³⁶ of the part's size are taken for one place.
    family: "step in a side, height",
    values: &[1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 0.0],
    rightly: |e| matches!(e, PartError::CoincidentVertices { .. }),
}];

/// Clearances as large as the resolution: one of space and slice from scratch may see the pocket, and the other not.
const AT_THE_RESOLUTION: [(&str, f64); 1] = [("disc in a hole, clearance", 1e-11)];

#[test]
fn families_agree_with_brute_force() {
    let mut unexpected = Vec::new();
    let (mut certain, mut slices, mut doubtful, mut conflicts) = (0, 0, 0, 0);
    for Outcome {
        family,
        value,
        came,
    } in outcomes()
    {
        let refused = REFUSED
            .iter()
            .find(|r| r.family == family && r.values.contains(&value));
        let report = match (&came, refused) {
            (Err(e), Some(refused)) if (refused.rightly)(e) => continue,
            (Err(e), _) => {
                unexpected.push(format!("{family} {value:e}: refused: {e}"));
                continue;
            }
            (Ok(_), Some(_)) => {
                unexpected.push(format!("{family} {value:e}: not refused"));
                continue;
            }
            (Ok(report), None) => report,
        };
        certain += report.certain;
        conflicts += report.conflicts;
        slices += report.slices;
        doubtful += report.doubtful_slices;
        let at_the_resolution = AT_THE_RESOLUTION.contains(&(family, value));
        let faults: Vec<_> = (report.faults.iter())
            .filter(|f| !(at_the_resolution && matches!(f, Fault::Loops { .. })))
            .collect();
        if let Some(fault) = faults.first() {
            let n = faults.len();
            unexpected.push(format!(
                "{family} {value:e}: {n} faults, the first {fault:?}"
            ));
        }
    }
    println!("{certain} certain, {conflicts} conflicts, {doubtful} of {slices} slices doubtful");
    assert!(unexpected.is_empty(), "{unexpected:#?}");
    assert!(certain > effort(3_000, 20_000), "{certain} certain");
    // Doubtful slices are not compared with slices from scratch.
    assert!(4 * doubtful < slices, "{doubtful} of {slices}");
}
