//! The schemas of all answers, made from their types.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::{Value, json};

use crate::error::Failed;
use crate::files::OneOrSeveral;
use crate::frame::{Answer, Content, Pairs};
use crate::tolerances::{allocation, along, analysis, zones};
use crate::written::Written;
use crate::{
    check, classify, clearance, compute, disassemble, escape, import, info, modes, plan, play,
    simulate, slice, solve, sweep,
};

/// The schema of each answer, by the name of its file in `docs/answers`.
pub fn schemas() -> Vec<(&'static str, Schema)> {
    vec![
        answer::<check::Requirements>("check"),
        answer::<Pairs<classify::Rows>>("classify"),
        one_or_several::<Pairs<compute::Summary>>("compute"),
        answer::<clearance::Clearances>("clearance"),
        answer::<disassemble::Disassembly>("disassemble"),
        with::<Pairs<escape::Escape>>("energy", "--energy"),
        named::<Failed<'_>>(
            "error",
            "What a command prints with --json where it has no answer",
        ),
        answer::<import::Imported>("import"),
        answer::<modes::OperatingModes>("modes"),
        answer::<Pairs<plan::Plan>>("plan"),
        answer::<simulate::Simulated>("simulate"),
        answer::<solve::Solutions>("solve"),
        answer::<sweep::Rows>("sweep"),
        answer::<analysis::Analysis>("tolerances"),
        with::<along::Bands>("along", "--along"),
        with::<Pairs<zones::Zones>>("zones", "--zones"),
        with::<allocation::Allocation>("allocation", "--allocate"),
        one_or_several::<info::Info>("info"),
        answer::<Pairs<play::Play>>("play"),
        answer::<Pairs<slice::Sliced<'_>>>("slice"),
        named::<Written>(
            "written",
            "What `cspace draw` and `cspace export` print with `--json`",
        ),
    ]
}

fn answer<T: Content>(name: &'static str) -> (&'static str, Schema) {
    named::<Answer<T>>(name, &title::<T>())
}

fn one_or_several<T: Content>(name: &'static str) -> (&'static str, Schema) {
    named::<OneOrSeveral<T>>(name, &title::<T>())
}

fn title<T: Content>() -> String {
    format!("What `cspace {} --json` prints", T::COMMAND)
}

/// The schema of the answer that a command gives with an option.
fn with<T: Content>(name: &'static str, option: &str) -> (&'static str, Schema) {
    let title = format!("What `cspace {} {option} --json` prints", T::COMMAND);
    named::<Answer<T>>(name, &title)
}

fn named<T: JsonSchema>(name: &'static str, title: &str) -> (&'static str, Schema) {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let mut schema = settings.into_generator().into_root_schema_for::<T>();
    schema.insert("$id".to_owned(), json!(format!("urn:cspace:answer:{name}")));
    schema.insert("title".to_owned(), json!(title));
    schema.remove("description");
    let mut value = schema.to_value();
    tidy(&mut value, true);
    let defs = value.get_mut("$defs").and_then(Value::as_object_mut);
    defs.into_iter()
        .flat_map(|defs| defs.values_mut())
        .for_each(|def| tidy(def, true));
    // It stays what it was: an object.
    (name, value.try_into().unwrap_or_default())
}

/// Brings the schema of a type into the form of a document, in which objects have no other keys than those that are named: an answer says
/// nothing that its schema does not describe. What is not `closed` is a piece of an object, which is closed as a whole.
fn tidy(schema: &mut Value, closed: bool) {
    const PIECES: [&str; 3] = ["oneOf", "anyOf", "allOf"];
    let Value::Object(keys) = schema else { return };
    // How a number is held says nothing of it; examples are for those who read the code.
    keys.remove("format");
    if let Some(Value::String(text)) = keys.get_mut("description") {
        *text = text
            .split("\n\n")
            .next()
            .unwrap_or_default()
            .replace('\n', " ");
    }
    let has_pieces = PIECES.iter().any(|key| keys.contains_key(*key));
    let is_object = keys.contains_key("properties");
    for key in PIECES {
        if let Some(Value::Array(pieces)) = keys.get_mut(key) {
            (pieces.iter_mut()).for_each(|piece| tidy(piece, closed && !is_object));
        }
    }
    if let Some(Value::Object(properties)) = keys.get_mut("properties") {
        properties.values_mut().for_each(|p| tidy(p, true));
    }
    for key in ["items", "additionalProperties"] {
        if let Some(inner) = keys.get_mut(key) {
            tidy(inner, true);
        }
    }
    if let Some(Value::Array(items)) = keys.get_mut("prefixItems") {
        items.iter_mut().for_each(|item| tidy(item, true));
    }
    if is_object && closed && !keys.contains_key("additionalProperties") {
        let key = match has_pieces {
            true => "unevaluatedProperties",
            false => "additionalProperties",
        };
        keys.insert(key.to_owned(), json!(false));
    }
}
