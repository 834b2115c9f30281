//! Enumerations as the values of a command's options.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use schemars::{JsonSchema, schema_for};
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Reads one of the words of an enumeration. Its schema says which there are, and what they mean.
pub(crate) fn words<T>() -> impl TypedValueParser<Value = T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    let schema = schema_for!(T);
    let variants = schema.get("oneOf").and_then(Value::as_array);
    let words = variants.into_iter().flatten().filter_map(|variant| {
        let text = |key| variant.get(key).and_then(Value::as_str);
        let meaning = text("description").unwrap_or_default();
        let meaning = meaning.trim_end_matches('.').replace('\n', " ");
        Some(PossibleValue::new(text("const")?.to_owned()).help(meaning))
    });
    PossibleValuesParser::new(words).try_map(|word| serde_json::from_value(Value::String(word)))
}
