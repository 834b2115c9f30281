//! Lines and columns of places.
//!
//! Values do not remember where they stood: a model has many, and an error only one. When there is one, the text is
//! gone through again.

use core::ops::Range;
use std::collections::HashMap;

use serde_json::value::RawValue;
use toml::de::{DeTable, DeValue};

use super::place::{Place, Step};

/// Line and column of a place in valid TOML text, or of the last value on the path to it that exists.
pub(super) fn in_toml(text: &str, place: &Place) -> Option<(usize, usize)> {
    let root = DeTable::parse(text).ok()?;
    let mut at = None;
    let mut table = Some(root.get_ref());
    let mut list = None;
    for (i, step) in place.way().iter().enumerate() {
        let value = match step {
            Step::Key(key) => table?.iter().find(|(k, _)| k.get_ref() == key),
            Step::Item(index) => {
                let item = list.and_then(|l: &toml::de::DeArray<'_>| l.get(*index));
                match item {
                    None => break,
                    Some(v) => {
                        at = Some(v.span().start);
                        (table, list) = children(v.get_ref());
                        continue;
                    }
                }
            }
        };
        let Some((key, value)) = value else {
            break;
        };
        let is_last = i + 1 == place.way().len();
        at = Some(if is_last && place.is_key() {
            key.span().start
        } else {
            value.span().start
        });
        (table, list) = children(value.get_ref());
    }
    at.map(|offset| line_and_column(text, offset))
}

type Children<'a> = (Option<&'a DeTable<'a>>, Option<&'a toml::de::DeArray<'a>>);

/// Byte range of a parameter's value in TOML text; for a table that of its `value`. `None` if there is no such
/// parameter.
pub(super) fn parameter_in_toml(text: &str, name: &str) -> Option<Range<usize>> {
    let root = DeTable::parse(text).ok()?;
    let mut span = None;
    let mut table = Some(root.get_ref());
    for key in ["parameter", name, "value"] {
        // A value that is no table has no further keys.
        let Some(inner) = table else { break };
        let (_, value) = inner.iter().find(|(k, _)| k.get_ref() == key)?;
        span = Some(value.span());
        (table, _) = children(value.get_ref());
    }
    span
}

/// Keys of a part in TOML text, with the byte ranges of their values; of `place` the range is all of its line. `None` if there is no such part.
pub(super) fn part_keys_in_toml(text: &str, name: &str) -> Option<Vec<(String, Range<usize>)>> {
    let root = DeTable::parse(text).ok()?;
    let parts = root.get_ref().get("part")?.get_ref().as_array()?;
    let mut tables = parts.iter().filter_map(|p| p.get_ref().as_table());
    let part = tables.find(|t| {
        let own = t.get("name").and_then(|n| n.get_ref().as_str());
        own == Some(name)
    })?;
    let keys = part.iter().map(|(key, value)| {
        let mut place = value.span();
        if key.get_ref() == "place" {
            place.start = key.span().start;
            place.end += text[place.end..].find('\n').map_or(0, |i| i + 1);
        }
        (key.get_ref().to_string(), place)
    });
    Some(keys.collect())
}

fn children<'a>(value: &'a DeValue<'a>) -> Children<'a> {
    match value {
        DeValue::Table(t) => (Some(t), None),
        DeValue::Array(a) => (None, Some(a)),
        _ => (None, None),
    }
}

/// Line and column of a place in valid JSON text, or of the last value on the path to it that exists.
pub(super) fn in_json(text: &str, place: &Place) -> Option<(usize, usize)> {
    let mut value: &RawValue = serde_json::from_str(text).ok()?;
    for (i, step) in place.way().iter().enumerate() {
        let next = match step {
            Step::Key(key) => serde_json::from_str::<HashMap<String, &RawValue>>(value.get())
                .ok()
                .and_then(|mut t| t.remove(key)),
            Step::Item(index) => serde_json::from_str::<Vec<&RawValue>>(value.get())
                .ok()
                .and_then(|l| l.get(*index).copied()),
        };
        let Some(next) = next else {
            break;
        };
        value = next;
        if i + 1 == place.way().len() && place.is_key() {
            let offset = key_before(text, offset_in(text, value.get()));
            return Some(line_and_column(text, offset));
        }
    }
    Some(line_and_column(text, offset_in(text, value.get())))
}

/// Offset of a piece of the text.
fn offset_in(text: &str, piece: &str) -> usize {
    piece.as_ptr() as usize - text.as_ptr() as usize
}

/// Offset of the key whose value begins at `offset`: a value is preceded by its key in quotes, and a colon.
fn key_before(text: &str, offset: usize) -> usize {
    let before = text[..offset].trim_end().trim_end_matches(':').trim_end();
    let inner = before.strip_suffix('"').unwrap_or(before);
    inner
        .rmatch_indices('"')
        .map(|(at, _)| at)
        // A quote after an odd number of backslashes belongs to the key.
        .find(|&at| {
            inner[..at]
                .bytes()
                .rev()
                .take_while(|b| *b == b'\\')
                .count()
                % 2
                == 0
        })
        .unwrap_or(offset)
}

/// Counted from 1, columns in characters.
pub(super) fn line_and_column(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
    (line, column)
}

#[cfg(test)]
mod tests {
    use super::{Place, in_json, in_toml};

    #[test]
    fn places_are_found_in_toml() {
        let text = "a = 1\n[[part]]\nname = \"p\"\nloops = [\n  [[0, 0],\n   [1, 2]]]\n[part.motion]\ntype = 3\n";
        let part = Place::default().key("part").item(0);
        let at = |p: &Place| in_toml(text, p);
        assert_eq!(at(&Place::default()), None);
        assert_eq!(at(&Place::default().key("a")), Some((1, 5)));
        assert_eq!(at(&Place::default().key("a").itself()), Some((1, 1)));
        assert_eq!(at(&part), Some((2, 1)));
        let vertex = part.key("loops").item(0).item(1);
        assert_eq!(at(&vertex), Some((6, 4)));
        assert_eq!(at(&vertex.item(1)), Some((6, 8)));
        assert_eq!(at(&vertex.item(2)), Some((6, 4)), "the nearest there is");
        assert_eq!(at(&part.key("motion").key("type")), Some((8, 8)));
        assert_eq!(at(&part.key("motion").key("type").itself()), Some((8, 1)));
    }

    #[test]
    fn places_are_found_in_json() {
        let text = "{\n \"a\": 1, \"part\": [\n  {\"na\\\"me\" : \"p\",\n   \"loops\": [[[0, 0], [1, 2]]]}]}\n";
        let part = Place::default().key("part").item(0);
        let at = |p: &Place| in_json(text, p);
        assert_eq!(at(&Place::default()), Some((1, 1)));
        assert_eq!(at(&Place::default().key("a")), Some((2, 7)));
        assert_eq!(at(&part), Some((3, 3)));
        assert_eq!(at(&part.key("na\"me")), Some((3, 15)));
        assert_eq!(at(&part.key("na\"me").itself()), Some((3, 4)));
        assert_eq!(at(&part.key("loops").item(0).item(1)), Some((4, 23)));
        assert_eq!(at(&part.key("none")), Some((3, 3)));
    }
}
