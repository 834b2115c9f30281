//! Motion of a mechanism.

use cspace_model::Mechanism;
use cspace_motion::{Record, Settings, Simulation};
use serde_json::{Value, json};

use crate::queries::said;

/// Seconds that are simulated, with samples at tenths of it: few impacts, so that differences of rounding stay small.
const TIME: f64 = 0.25;

pub(crate) fn motion(mechanism: &Mechanism) -> Value {
    let settings = Settings {
        time: TIME,
        every: Some(0.1 * TIME),
    };
    let simulation = match Simulation::new(mechanism) {
        Ok(simulation) => simulation,
        Err(error) => return json!({ "refused": error.to_string() }),
    };
    let parts = |record: Record| {
        json!({
            "status": record.status,
            "until": record.until,
            "events": record.events,
            "samples": record.samples,
        })
    };
    json!({
        "kinematic": said(simulation.kinematic(&settings).map(parts)),
        "dynamic": said(simulation.dynamic(&settings).map(parts)),
    })
}
