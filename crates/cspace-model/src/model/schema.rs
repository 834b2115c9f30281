//! The JSON schema of models: the keys of all tables, and what `schema.json` says beside them.

use serde_json::{Value, json};

use super::drawings::OF_DRAWINGS;
use super::entry::ENTRY;
use super::expression::taken_names;
use super::forces::{DRIVE, LOAD, SPRING};
use super::keys::{Key, Keys, Kind, Kinds};
use super::loops::{CIRCLE, PATH};
use super::parts::{LAYER, MOTION, PART};
use super::pattern::{COPIES, PATTERN};
use super::placement::PLACE;
use super::read::FILE;
use super::relations::{JOINT, PAIR};
use super::requirements::{AXES, PLANAR, REQUIREMENT};
use super::show::SHOW;
use super::tolerance::PARAMETER;

/// Definitions of values, and what tables must obey that cannot be said key by key.
const BESIDE: &str = include_str!("schema.json");

/// The tables, by the names of their definitions; an entry and a loop may be written in several ways.
const TABLES: [(&str, &[&Keys]); 16] = [
    ("coordinates", &[&PLANAR, &AXES]),
    ("drive", &[&DRIVE]),
    ("entry", &[&ENTRY, &COPIES]),
    ("joint", &[&JOINT]),
    ("layer", &[&LAYER]),
    ("load", &[&LOAD]),
    ("loop", &[&PATH, &CIRCLE]),
    ("motion", &[&MOTION]),
    ("pair", &[&PAIR]),
    ("part", &[&PART]),
    ("pattern", &[&PATTERN]),
    ("place", &[&PLACE]),
    ("requirement", &[&REQUIREMENT]),
    ("show", &[&SHOW]),
    ("spring", &[&SPRING]),
    ("toleranced", &[&PARAMETER]),
];

/// The JSON schema of models, `docs/model.schema.json`: which keys there are, how their values are written, and what they mean.
///
/// ```
/// let schema: serde_json::Value = serde_json::from_str(&cspace_model::model::schema())?;
/// assert_eq!(schema["definitions"]["pair"]["required"], serde_json::json!(["fixed", "moving"]));
/// # Ok::<(), serde_json::Error>(())
/// ```
pub fn schema() -> String {
    let mut beside: Value = serde_json::from_str(BESIDE).unwrap_or_default();
    let (mut file, mut definitions) = (beside["file"].take(), beside["definitions"].take());
    add_keys(&mut file, &[&FILE]);
    for (name, keys) in TABLES {
        add_keys(&mut definitions[name], keys);
    }
    let taken: Vec<&str> = taken_names().collect();
    definitions["parameters"]["propertyNames"] = json!({"not": {"enum": taken}});
    for (key, drawings) in OF_DRAWINGS {
        let given = drawings
            .iter()
            .map(|drawing| json!({"required": [drawing]}));
        let given: Vec<Value> = given.collect();
        for table in ["part", "layer"] {
            definitions[table]["dependencies"][key] = json!({"anyOf": given});
        }
    }
    file["definitions"] = definitions;
    let mut text = serde_json::to_string_pretty(&file).unwrap_or_default();
    text.push('\n');
    text
}

/// Adds what is known of the keys of a table to its definition.
fn add_keys(definition: &mut Value, tables: &[&Keys]) {
    let keys = || tables.iter().flat_map(|table| table.keys);
    let kinds = tables.iter().find_map(|table| table.kinds.as_ref());
    for key in keys() {
        definition["properties"][key.name] = property(key, kinds);
    }
    definition["additionalProperties"] = false.into();
    if definition.get("type").is_none() {
        definition["type"] = "object".into();
    }
    let needed: Vec<&str> = keys().filter(|k| k.is_needed).map(|k| k.name).collect();
    if !needed.is_empty() {
        definition["required"] = needed.into();
    }
    let Some(kinds) = kinds else { return };
    for kind in kinds.all {
        let rule = rule(kind, kinds, keys());
        match &mut definition["allOf"] {
            Value::Array(rules) => rules.push(rule),
            none => *none = json!([rule]),
        }
    }
}

/// The value of a key.
fn property(key: &Key, kinds: Option<&Kinds>) -> Value {
    let list = |text: &'static str| text.strip_prefix('[')?.strip_suffix(']');
    let reference = |name: &str| format!("#/definitions/{name}");
    let mut property = match (key.value, kinds) {
        ("kind", Some(kinds)) => {
            json!({"enum": kinds.all.iter().map(|kind| kind.name).collect::<Vec<_>>()})
        }
        (names, _) if names.contains('|') => json!({"enum": names.split('|').collect::<Vec<_>>()}),
        (name, _) => match list(name) {
            Some(item) => json!({"type": "array", "items": {"$ref": reference(item)}}),
            None => json!({"$ref": reference(name)}),
        },
    };
    property["description"] = key.about.into();
    property
}

/// A rule for the tables of one kind: keys that they must have, and keys that they may not have.
fn rule<'a>(kind: &Kind, kinds: &Kinds, keys: impl Iterator<Item = &'a Key>) -> Value {
    let others = keys.filter(|key| !kind.has(key.name) && !kinds.are_indifferent_to(key.name));
    let mut then = json!({"required": kind.needs});
    for key in others {
        then["properties"][key.name] = false.into();
    }
    let mut is_of_kind = json!({"properties": {kinds.key: {"const": kind.name}}});
    if kinds.default != Some(kind.name) {
        is_of_kind["required"] = json!([kinds.key]);
    }
    json!({"if": is_of_kind, "then": then})
}
