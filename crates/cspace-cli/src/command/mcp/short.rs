//! Answers in few words: lists are cut where the whole is too long.

use serde_json::{Map, Value, json};

/// The most bytes of an answer that is not asked for in detail.
const MOST: usize = 4000;

/// Lengths to which lists are cut, in turn, until the whole is short enough.
const LENGTHS: [usize; 6] = [24, 12, 6, 3, 1, 0];

/// The text of an answer; if it is too long, with its lists cut, and under `shortened` which ones, and how many they have.
pub(super) fn short(answer: &Value) -> String {
    let whole = answer.to_string();
    if whole.len() <= MOST {
        return whole;
    }
    let mut text = whole;
    for most in LENGTHS {
        let (mut cut, mut lists) = (answer.clone(), Map::new());
        shorten(&mut cut, most, "", &mut lists);
        let count = lists.len();
        // A list within a list is one of many alike.
        let named: Map<String, Value> = lists.into_iter().take(8).collect();
        if let Value::Object(keys) = &mut cut {
            keys.insert(
                "shortened".to_owned(),
                json!({ "lists": count, "of": named, "help": "give `detail`: true for all" }),
            );
        }
        text = cut.to_string();
        if text.len() <= MOST {
            return text;
        }
    }
    text
}

/// Cuts the lists in a value, but those of numbers of a point or a configuration; `lists` gets the number of entries of each that is cut.
fn shorten(value: &mut Value, most: usize, path: &str, lists: &mut Map<String, Value>) {
    /// A list so short is one thing: a point, a range, a configuration, two features.
    const ONE: usize = 3;
    match value {
        Value::Array(all) => {
            let are_lists = all.iter().any(|v| v.is_array() || v.is_object());
            if all.len() > most.max(if are_lists { 0 } else { ONE }) {
                lists.insert(path.to_owned(), all.len().into());
                all.truncate(most);
            }
            for (i, one) in all.iter_mut().enumerate() {
                shorten(one, most, &format!("{path}[{i}]"), lists);
            }
        }
        Value::Object(keys) => {
            for (key, one) in keys {
                let below = match path {
                    "" => key.clone(),
                    _ => format!("{path}.{key}"),
                };
                shorten(one, most, &below, lists);
            }
        }
        _ => {}
    }
}
