//! Schemas, and walks through trees of values.

use serde_json::Value;

pub(crate) const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

pub(crate) fn schema(name: &str) -> Value {
    let text = std::fs::read_to_string(format!("{ROOT}/docs/{name}.schema.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// Paths to all objects; of every list only the first three items are included.
pub(crate) fn objects(value: &Value) -> Vec<String> {
    fn gather(value: &Value, at: &str, all: &mut Vec<String>) {
        match value {
            Value::Object(map) => {
                all.push(at.to_owned());
                map.iter()
                    .for_each(|(k, v)| gather(v, &format!("{at}/{k}"), all));
            }
            Value::Array(list) => (list.iter().take(3).enumerate())
                .for_each(|(i, v)| gather(v, &format!("{at}/{i}"), all)),
            _ => {}
        }
    }
    let mut all = Vec::new();
    gather(value, "", &mut all);
    all
}

/// Missing values are null or left out: no index is the largest number, which marks missing values in memory.
#[track_caller]
pub(crate) fn has_no_mark(value: &Value, name: &str) {
    match value {
        Value::Object(map) => map.values().for_each(|v| has_no_mark(v, name)),
        Value::Array(list) => list.iter().for_each(|v| has_no_mark(v, name)),
        Value::Number(n) => {
            let marks = [u64::from(u32::MAX), u64::MAX];
            assert!(n.as_u64().is_none_or(|n| !marks.contains(&n)), "{name}");
        }
        _ => {}
    }
}
