//! How a model is written, by topic: from the tables that the reader of models knows, and models to begin with.

use std::fmt::Write;

use cspace_api::Error;
use cspace_api::template::TEMPLATES;
use cspace_model::model::schema;
use serde_json::Value;

/// A smallest model.
const SMALLEST: &str = r#"unit = "mm"

[parameter]
gap = 0.2                                     # a number that may be used in expressions, and varied

[[part]]
name = "plate"
motion = { type = "fixed" }
loops = [
  [[-20, -8], [20, -8], [20, 8], [-20, 8]],   # vertices [x, y] or [x, y, bulge]: tan(sweep / 4) of the arc that leaves it
  { circle = "3 + gap", at = [0, 0] },        # a hole: material is what is within an odd number of loops
]

[[part]]
name = "pin"                                  # without motion it moves in x, y and theta
loops = [{ circle = 3, at = [0, 0] }]

[[part]]
name = "arm"
motion = { type = "revolute", center = [30, 0], range = [0, "90deg"] }   # or prismatic, direction = [1, 0]
loops = [[[30, -2], [45, -2], [45, 2], [30, 2]]]

[[requirement]]
name = "clears"
measure = "clearance"
over = "ranges"
pair = ["plate", "arm"]
limits = [0.5, 100]
"#;

/// A section of the reference, or the list of its topics.
pub(super) fn section(topic: Option<&str>) -> Result<String, Error> {
    let schema: Value = serde_json::from_str(&schema()).map_err(Error::new)?;
    let tables = schema["definitions"].as_object();
    let tables = || tables.into_iter().flatten();
    let of_tables: Vec<&str> = tables()
        .filter(|(_, d)| d.get("properties").is_some())
        .map(|(name, _)| name.as_str())
        .collect();
    let models: Vec<String> = TEMPLATES
        .iter()
        .map(|t| format!("model {}", t.name))
        .collect();
    let topics = || {
        format!(
            "file, {}, values, {}",
            of_tables.join(", "),
            models.join(", ")
        )
    };
    let Some(topic) = topic else {
        return Ok(format!(
            "A model is TOML, or the same structure as JSON. Every part is drawn in its own frame, which is the assembly's at zero motion; angles are radians or texts such as \"18deg\"; a number may be an expression of parameters, as text.\n\nTopics: {}\n\nA model with three parts:\n\n{SMALLEST}",
            topics()
        ));
    };
    let mut text = String::new();
    match topic {
        "file" => describe(&mut text, "file", &schema),
        "values" => {
            for (name, definition) in tables().filter(|(_, d)| d.get("properties").is_none()) {
                describe(&mut text, name, definition);
            }
        }
        _ => match (
            topic
                .strip_prefix("model ")
                .and_then(|name| TEMPLATES.iter().find(|t| t.name == name)),
            tables().find(|(name, _)| *name == topic),
        ) {
            (Some(template), _) => text.push_str(template.text),
            (None, Some((name, definition))) => describe(&mut text, name, definition),
            (None, None) => {
                return Err(Error::new(format_args!("there is no topic {topic:?}"))
                    .help(format_args!("the topics are {}", topics())));
            }
        },
    }
    Ok(text)
}

/// The keys of a table, or the form of a value, line by line.
fn describe(text: &mut String, name: &str, definition: &Value) {
    let about = |value: &Value| value["description"].as_str().unwrap_or_default().to_owned();
    let _ = writeln!(text, "{name}: {}", about(definition));
    let needed = definition["required"].as_array();
    let is_needed = |key: &str| needed.is_some_and(|all| all.iter().any(|n| n == key));
    for (key, value) in definition["properties"].as_object().into_iter().flatten() {
        let must = if is_needed(key) {
            ", must be given"
        } else {
            ""
        };
        let _ = writeln!(text, "- {key} ({}{must}): {}", form(value), about(value));
    }
    if definition.get("properties").is_none() {
        let _ = writeln!(text, "  {}", form(definition));
    }
    text.push('\n');
}

/// How a value is written, in short.
fn form(value: &Value) -> String {
    if let Some(reference) = value["$ref"].as_str() {
        return reference.rsplit('/').next().unwrap_or_default().to_owned();
    }
    if let Some(words) = value["enum"].as_array() {
        let words: Vec<String> = words.iter().map(ToString::to_string).collect();
        return words.join(" or ");
    }
    for several in ["anyOf", "oneOf"] {
        if let Some(all) = value[several].as_array() {
            let all: Vec<String> = all.iter().map(form).collect();
            return all.join(" or ");
        }
    }
    match (value["type"].as_str(), &value["items"]) {
        (Some("array"), items) if items.is_object() => format!("list of {}", form(items)),
        (Some("array"), Value::Array(items)) => {
            let items: Vec<String> = items.iter().map(form).collect();
            format!("[{}]", items.join(", "))
        }
        (Some(kind), _) => kind.to_owned(),
        (None, _) => "value".to_owned(),
    }
}
