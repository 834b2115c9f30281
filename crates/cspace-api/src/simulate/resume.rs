//! A record that is taken up where its motion ends.

use cspace_model::Mechanism;
use cspace_motion::{Event, Record, Sample, Status, System};
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::answer::moving;
use super::question::{Earlier, Mode};
use crate::error::Error;
use crate::host::Host;
use crate::made_of::MadeOf;

/// Times nearer than this are the same, relative to the duration: rounding.
const SAME: f64 = 1e-11;

const HELP: &str = "give what `cspace simulate` wrote with -o RECORD.json, of the same model";

/// The record to resume; refused unless it has this model and mode, can go on, and ends before `time`.
pub(super) fn record(
    earlier: &Earlier,
    model: &Mechanism,
    (mode, time): (Mode, f64),
    host: &dyn Host,
) -> Result<Record, Error> {
    let value = &earlier.answer;
    let wrong = |what: &str, help: &str| Error::in_file(&earlier.path, what).help(help);
    let bad = |what: &str| wrong(what, HELP);
    let system = System::new(model);
    let names: Vec<&str> = moving(model, &system).map(|(name, _)| name).collect();
    let told = value["parts"].as_array().into_iter().flatten();
    if !told.map(Value::as_str).eq(names.iter().map(|n| Some(*n))) {
        return Err(bad("its parts are not those that move in the model"));
    }
    let others = MadeOf::of(model)
        .map_err(Error::new)?
        .others(&value["model"]);
    if !others.is_empty() {
        let what = format!("it was made with other {}", others.join(", "));
        return Err(bad(&what));
    }
    // Only records of motions with masses have a balance of energy.
    let (its_mode, its_name) = match value.get("energy") {
        Some(_) => (Mode::Dynamic, "dynamic"),
        None => (Mode::Kinematic, "kinematic"),
    };
    if its_mode != mode {
        let what = format!("its motion is {its_name}");
        let help = format!("go on with {} {its_name}", host.option("mode"));
        return Err(wrong(&what, &help));
    }
    let status: Status = part(value, "status").map_err(|e| bad(&e))?;
    if !matches!(status, Status::Done | Status::Interrupted) {
        return Err(bad("its motion cannot go on: it ended as its reason says"));
    }
    let until: f64 = part(value, "until").map_err(|e| bad(&e))?;
    if until >= time {
        return Err(wrong(
            &format!("its motion has come to {until} s already"),
            &format!("ask for a longer {}", host.option("time")),
        ));
    }
    let states: Vec<Vec<f64>> = match value.get("states") {
        Some(_) => part(value, "states").map_err(|e| bad(&e))?,
        None => return Err(bad("it has no states")),
    };
    let count = system.count();
    let mut trace = Vec::with_capacity(states.len());
    for (i, state) in states.iter().enumerate() {
        let [t, numbers @ ..] = &state[..] else {
            return Err(bad(&format!("state {i} is empty")));
        };
        if numbers.len() != 2 * count {
            return Err(bad(&format!(
                "state {i} has {} numbers after its time, and the model {count} coordinates and as many rates",
                numbers.len()
            )));
        }
        let (coordinates, rates) = numbers.split_at(count);
        trace.push(Sample {
            t: *t,
            coordinates: coordinates.to_vec(),
            rates: rates.to_vec(),
            forces: None,
        });
    }
    if trace.is_empty() {
        return Err(bad("it has no states"));
    }
    // Samples are states, whose rates the record has there.
    let rows = value["samples"].as_array().map_or(&[][..], Vec::as_slice);
    let mut samples = Vec::with_capacity(rows.len());
    for (i, row) in rows.iter().enumerate() {
        let t = row["t"].as_f64();
        let at = t.and_then(|t| {
            let after = trace.partition_point(|s| s.t < t - SAME * until);
            let state = trace.get(after).filter(|s| s.t <= t + SAME * until);
            state.map(|state| (t, state))
        });
        let (t, state) = at.ok_or_else(|| bad(&format!("sample {i} is no state of it")))?;
        let forces = match row.get("forces") {
            Some(_) => Some(part(row, "forces").map_err(|e| bad(&e))?),
            None => None,
        };
        samples.push(Sample {
            t,
            forces,
            ..state.clone()
        });
    }
    let events: Vec<Event> = part(value, "events").map_err(|e| bad(&e))?;
    let energy = match value.get("energy") {
        Some(_) => Some(part(value, "energy").map_err(|e| bad(&e))?),
        None => None,
    };
    Ok(Record {
        status,
        until,
        reason: None,
        obstacles: Vec::new(),
        samples,
        events,
        trace,
        energy,
        open: 0.0,
    })
}

fn part<T: DeserializeOwned>(value: &Value, key: &str) -> Result<T, String> {
    T::deserialize(&value[key]).map_err(|e| format!("{key}: {e}"))
}
