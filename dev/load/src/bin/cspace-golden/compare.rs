//! Two answers side by side.

use serde_json::Value;

use crate::answers::Answers;

/// Difference of an answer from the frozen one.
#[derive(Debug, PartialEq)]
pub(crate) enum Difference {
    /// No difference.
    None,
    /// Differences of numbers below the tolerance.
    Places,
    /// Other difference: its place, and the value there.
    Structure(String),
}

/// Compares the answers for a pair with the frozen text.
///
/// # Errors
/// If the frozen text was not written by `freeze`.
pub(crate) fn difference(
    frozen: &str,
    now: &Answers,
    within: Option<f64>,
) -> Result<Difference, String> {
    if frozen == now.to_json() {
        return Ok(Difference::None);
    }
    let frozen: Value = serde_json::from_str(frozen).map_err(|e| e.to_string())?;
    let mut path = String::new();
    Ok(match differs(&frozen, &now.0, within, &mut path) {
        Some(what) => Difference::Structure(format!("{path}: {what}")),
        None => Difference::Places,
    })
}

/// First place at which two values differ by more than the tolerance; `path` is the path to it.
fn differs(a: &Value, b: &Value, within: Option<f64>, path: &mut String) -> Option<String> {
    let length = path.len();
    let mut inside = |key: &str, a: &Value, b: &Value| {
        path.push('/');
        path.push_str(key);
        let found = differs(a, b, within, path);
        if found.is_none() {
            path.truncate(length);
        }
        found
    };
    match (a, b) {
        (Value::Array(x), Value::Array(y)) if x.len() == y.len() => {
            let mut each = (0..).zip(x.iter().zip(y));
            each.find_map(|(i, (a, b)): (usize, _)| inside(&i.to_string(), a, b))
        }
        (Value::Array(x), Value::Array(y)) => Some(format!("{} and {} items", x.len(), y.len())),
        (Value::Object(x), Value::Object(y)) if x.len() == y.len() => x
            .iter()
            .find_map(|(key, a)| inside(key, a, y.get(key).unwrap_or(&Value::Null))),
        (Value::Number(x), Value::Number(y)) if x.is_f64() && y.is_f64() => {
            let (x, y) = (x.as_f64()?, y.as_f64()?);
            let same = x == y || within.is_some_and(|t| (x - y).abs() <= t * x.abs().max(1.0));
            (!same).then(|| format!("{x:?} is now {y:?}"))
        }
        _ => (a != b).then(|| format!("{a} is now {b}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_differs_is_told_with_its_place() {
        let now = Answers(json!({ "space": { "patches": [{ "lo": 0.5, "region": 2 }] } }));
        let frozen = |lo: f64, region: u32| {
            json!({ "space": { "patches": [{ "lo": lo, "region": region }] } }).to_string()
        };
        let compared = |lo, region, within| difference(&frozen(lo, region), &now, within).unwrap();
        assert_eq!(compared(0.5, 2, None), Difference::None);
        assert_eq!(compared(0.5 + 1e-12, 2, Some(1e-9)), Difference::Places);
        let told = |what: &str| Difference::Structure(what.to_owned());
        assert_eq!(
            compared(0.75, 2, Some(1e-9)),
            told("/space/patches/0/lo: 0.75 is now 0.5")
        );
        assert_eq!(
            compared(0.5, 1, Some(1e-9)),
            told("/space/patches/0/region: 1 is now 2")
        );
    }
}
