//! Requirements of a design, measured on the configuration spaces of its pairs and on its motion.
//!
//! A model says its requirements in `[[requirement]]` ([`cspace_model::model::Requirement`]); [`check`] measures all of them.
//! [`sensitivities`] adds
//! derivatives by parameters. [`Sweep`] measures them over many values of parameters. [`measure`] measures one quantity of one space, [`touching`] names the features at a contact.
//!
//! ```
//! use cspace_design::{Value, check};
//! # let folder = tempfile::tempdir()?;
//! # let path = folder.path().join("key.toml");
//! std::fs::write(&path, r#"
//! [parameter]
//! play = 0.1
//!
//! [[part]]
//! name = "slot"
//! loops = [[[-9, -9], [9, -9], [9, 0], ["3 + play/2", 0], ["3 + play/2", -5], ["-3 - play/2", -5], ["-3 - play/2", 0], [-9, 0]]]
//!
//! [[part]]
//! name = "key"
//! loops = [[[-3, -4], [3, -4], [3, 4], [-3, 4]]]
//!
//! [[requirement]]
//! name = "sideways"
//! measure = "play"
//! of = "x"
//! limits = [0.05, 0.2]
//! "#)?;
//! let cspace_model::Document::Model(model) = cspace_model::read(&path)? else { unreachable!() };
//! let checked = check(&model);
//! assert_eq!(checked[0].is_met(), Some(true));
//! let Ok(measured) = &checked[0].measured else { unreachable!() };
//! let Value::Number(play) = measured.value else { unreachable!() };
//! assert!((play - 0.1).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod changes;
mod check;
mod displace;
mod drawing;
pub mod drawn;
mod exact_fit;
mod in_motion;
mod measure;
mod motion;
mod over_ranges;
mod range;
mod sensitivity;
mod solve;
mod sweep;
mod tolerance;
mod touching;
mod value;

pub use changes::{Change, Step, steps_in};
pub use check::{Checked, Interrupted, check, check_by, check_with};
pub use displace::{Displaced, Outcome, displace};
pub use measure::measure;
pub use motion::Motion;
pub use range::{free_range, reach};
pub use sensitivity::{Sensitivity, sensitivities, sensitivities_by};
pub use solve::{ContactGoal, Goal, Relation, Solved, Span, put_contact, solve};
pub use sweep::{Row, Sweep, Varied};
pub use tolerance::{
    Allocation, Band, Cell, ChangeKind, Contribution, Criterion, Extreme, LARGEST_FACTOR, Linear,
    Margin, MonteCarlo, NoZones, Station, Structural, ToleranceOptions, Tolerances, Unallocated,
    Variation, Variations, Zone, ZoneBand, Zones, allocate, along, area, tolerances,
    tolerances_with, zones,
};
pub use touching::{FeaturePair, pair_of, texts, touching};
pub use value::{Measured, Stop, Unmeasured, Value};
