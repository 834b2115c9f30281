//! Spaces of fixed-axes pairs as files: read back they answer the same, and damaged ones are refused or answer something,
//! but never panic and never hang.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use cspace::pair::PairSpace;
use cspace::{FixedAxesSpace, PatchId};
use cspace_model::saved;
use cspace_oracle::effort;
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, mechanisms};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

fn compute(m: &Mechanism) -> FixedAxesSpace {
    FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap()
}

fn text(space: FixedAxesSpace) -> String {
    saved::pair_to_json(&PairSpace::FixedAxes(Box::new(space)))
}

fn read(text: &str) -> Option<FixedAxesSpace> {
    match saved::pair_from_json(text, "space.json") {
        Ok(PairSpace::FixedAxes(space)) => Some(*space),
        _ => None,
    }
}

/// A value in the extent of a coordinate, or a little beyond.
fn within((lo, hi): (f64, f64), rng: &mut ChaCha8Rng) -> f64 {
    lo + (hi - lo) * rng.random_range(-0.1..1.1)
}

/// Answers to some queries, as text: equal numbers give equal text.
fn answers(space: &FixedAxesSpace, rng: &mut ChaCha8Rng) -> Vec<String> {
    let [u, v] = space.extent();
    let mut said = vec![
        format!("{:?}", space.regions()),
        format!("{:?} {:?}", space.patches(), space.branches()),
        (space.free_gaps())
            .map(|g| format!("{} {:?}", g.region(), [0.1, 0.5, 0.9].map(|s| g.ends(s))))
            .collect(),
    ];
    for _ in 0..20 {
        let at = (within(u, rng), within(v, rng));
        let to = (within(u, rng), within(v, rng));
        said.push(format!(
            "{:?} {:?} {:?} {:?}",
            space.classify(at.0, at.1),
            space.contacts(at.0, at.1, 0.1),
            space.first_contact(at, (to.0 - at.0, to.1 - at.1), 1.0),
            space.configuration(at.0, at.1),
        ));
        let k = rng.random_range(0..space.branches().len().max(1));
        let patch = PatchId(k as u32);
        said.push(format!(
            "{:?} {:?} {:?}",
            space.branch_at(k, at.0),
            space.contact_function(patch, at.0, at.1),
            space.contact_gradient(patch, at.0, at.1),
        ));
    }
    said
}

#[test]
fn a_space_read_back_answers_the_same() {
    for m in mechanisms() {
        let space = compute(&m);
        let expected = answers(&space, &mut ChaCha8Rng::seed_from_u64(5));
        let written = text(space);
        let again = read(&written).unwrap();
        let given = answers(&again, &mut ChaCha8Rng::seed_from_u64(5));
        assert_eq!(given, expected, "{}", m.name);
        assert_eq!(text(again), written, "{}", m.name);
    }
}

/// Path to every number, word and truth value of a tree of values.
fn leaves(value: &Value, way: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                leaves(item, &format!("{way}/{i}"), found);
            }
        }
        Value::Object(fields) => {
            for (name, field) in fields {
                leaves(field, &format!("{way}/{name}"), found);
            }
        }
        _ => found.push(way.to_owned()),
    }
}

fn other_value(old: &Value, rng: &mut ChaCha8Rng) -> Value {
    let near = old.as_i64().unwrap_or(0);
    match rng.random_range(0..12) {
        0 => json!(0),
        1 => json!(-1),
        2 => json!(u32::MAX),
        3 => json!(near + 1),
        4 => json!(near - 1),
        5 => json!(1e300),
        6 => json!(-1e300),
        7 => json!(1e-300),
        8 => json!(old.as_f64().unwrap_or(1.0) * rng.random_range(-3.0..3.0)),
        9 => json!(rng.random_range(0..1000)),
        10 => json!(i32::MAX),
        _ => Value::Null,
    }
}

#[test]
fn damaged_spaces_never_panic() {
    /// Time limit, which only a hang exceeds.
    const LONG: Duration = Duration::from_secs(10);
    let mut rng = ChaCha8Rng::seed_from_u64(6);
    let list = mechanisms();
    let named = |name: &str| compute(list.iter().find(|m| m.name == name).unwrap());
    let spaces = [
        compute(&gears(5, 4)),
        named("disc off its axis and bar"),
        named("gear against a stop"),
        named("concentric"),
        named("discs that slide"),
        named("peg and slot"),
        named("rack and pinion"),
    ];
    let (mut refused, mut accepted) = (0, 0);
    let mut wrong = Vec::new();
    for space in spaces {
        let good: Value = serde_json::from_str(&text(space)).unwrap();
        let mut ways = Vec::new();
        leaves(&good, "", &mut ways);
        // As often in the short parts of the file as in the long ones.
        let part = |way: &String| way.split('/').nth(1).unwrap_or_default().to_owned();
        let mut parts: Vec<String> = ways.iter().map(part).collect();
        parts.dedup();
        for _ in 0..effort(40, 400) {
            let mut damaged = good.clone();
            let mut what = Vec::new();
            for _ in 0..rng.random_range(1..3) {
                let of = parts.choose(&mut rng).unwrap();
                let some: Vec<&String> = ways.iter().filter(|w| &part(w) == of).collect();
                let way = *some.choose(&mut rng).unwrap();
                let value = damaged.pointer_mut(way).unwrap();
                *value = other_value(value, &mut rng);
                what.push(format!("{way} = {value}"));
            }
            let begin = Instant::now();
            let mut questions = ChaCha8Rng::seed_from_u64(7);
            let read = catch_unwind(AssertUnwindSafe(|| {
                let space = read(&damaged.to_string());
                space.map(|s| answers(&s, &mut questions).len())
            }));
            match read {
                Ok(Some(_)) => accepted += 1,
                Ok(None) => refused += 1,
                Err(_) => wrong.push(format!("panics: {what:?}")),
            }
            if begin.elapsed() > LONG {
                wrong.push(format!("{:?}: {what:?}", begin.elapsed()));
            }
        }
    }
    println!("{refused} refused, {accepted} accepted");
    assert!(
        wrong.is_empty(),
        "{} of:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
    assert!(
        refused > effort(50, 500) && accepted > effort(10, 100),
        "{refused} refused, {accepted} accepted"
    );
}
