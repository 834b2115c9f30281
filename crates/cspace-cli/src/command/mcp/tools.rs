//! The tools: their names, what each is for, and the schema of what each takes.

use std::sync::LazyLock;

use cspace_api::{Kind, Question, inlined};
use serde_json::{Map, Value, json};

/// A tool that asks a question of a model.
struct Asking {
    name: &'static str,
    /// The kind of question.
    kind: &'static str,
    /// When to use it, and how to read the answer.
    when: &'static str,
}

const ASKING: [Asking; 9] = [
    Asking {
        name: "model_info",
        kind: "info",
        when: "Use it first, to see that a model says what is meant: parts with sizes and areas, axes, joints, and the class of every pair.",
    },
    Asking {
        name: "space",
        kind: "compute",
        when: "The exact contact space of each pair in numbers: how many free regions there are, where the parts are as drawn (`drawn`), and whether a region is bounded (caged: the part cannot leave).",
    },
    Asking {
        name: "play",
        kind: "play",
        when: "How far the moving part goes in each direction from a configuration, and which features stop it; with `by`, where that one motion meets something. Planar pairs have x, y, theta, pairs on axes u, v.",
    },
    Asking {
        name: "plan",
        kind: "plan",
        when: "Whether a part can get from one configuration to another at all: `path` is a motion, `no-path` is proved.",
    },
    Asking {
        name: "clearance",
        kind: "clearance",
        when: "Whether parts clear over their whole range of motion, and where it is tightest: `clear` with the smallest gap, `touches` or `stopped` with what stops which part where, `meshes` with ratio and backlash, `overlaps` with how far to move. With `drawn` as the parts are drawn.",
    },
    Asking {
        name: "check",
        kind: "check",
        when: "Which [[requirement]]s of the model are met, with the measured values and margins.",
    },
    Asking {
        name: "solve",
        kind: "solve",
        when: "For which value of a [parameter] a requirement has a value.",
    },
    Asking {
        name: "tolerances",
        kind: "tolerances",
        when: "What the tolerances of parameters do to each requirement: worst case, statistics, shares.",
    },
    Asking {
        name: "simulate",
        kind: "simulate",
        when: "The motion of a mechanism by its drives, loads, springs and masses over a time in seconds: events, where it ends, whether it jams.",
    },
];

/// The kind of question that a tool asks.
pub(super) fn kind_of(tool: &str) -> Option<&'static str> {
    let asking = ASKING.iter().find(|asking| asking.name == tool);
    asking.map(|asking| asking.kind)
}

/// A tool as it is listed.
pub(super) struct Tool {
    pub(super) name: &'static str,
    pub(super) about: String,
    /// The schema of its arguments.
    pub(super) takes: Map<String, Value>,
}

/// All tools, whose schemas are made once.
pub(super) fn tools() -> &'static [Tool] {
    static TOOLS: LazyLock<Vec<Tool>> = LazyLock::new(all);
    &TOOLS
}

fn all() -> Vec<Tool> {
    let kinds = Question::kinds();
    let asking = ASKING.iter().filter_map(|asking| {
        let kind = kinds.iter().find(|kind| kind.name == asking.kind)?;
        Some(Tool {
            name: asking.name,
            about: format!("{} {}{}", kind.about, asking.when, outcomes(kind)),
            takes: with(
                kind.asked.clone().to_value(),
                &["model", "set", "detail"],
                &["model"],
            ),
        })
    });
    let mut tools: Vec<Tool> = asking.collect();
    tools.push(Tool {
        name: "draw",
        about: "A picture (PNG) of the parts as drawn, or with `pair` or `at` of a pair at a configuration with what touches there marked."
            .to_owned(),
        takes: with(
            json!({ "properties": {
                "pair": text("The pair: names of its fixed and its moving part, with a comma between."),
                "at": text("The configuration: x,y,theta, or u,v of a pair on axes, such as 10,0,18deg."),
                "height": { "type": "number", "description": "Of parts with layers, what is at this height in full, the rest thin." },
            }}),
            &["model", "set"],
            &["model"],
        ),
    });
    let mut import = inlined::<cspace_api::import::Question>().to_value();
    // A model is called as its first drawing.
    if let Some(Value::Object(properties)) = import.get_mut("properties") {
        properties.remove("name");
    }
    tools.push(Tool {
        name: "import_drawing",
        about: "A model of drawings (DXF, SVG, or points as CSV): what parts were made of which entities, what was left out, joined or fitted; and the model's text, or with `output` a model file."
            .to_owned(),
        takes: with(
            import,
            &["drawings", "layer", "output", "detail"],
            &["drawings"],
        ),
    });
    tools.push(Tool {
        name: "reference",
        about: "How a model is written, by topic: without `topic` the list of topics and a smallest model. Read `part` before you write one."
            .to_owned(),
        takes: with(json!({}), &["topic"], &[]),
    });
    tools
}

/// The words of the outcomes of a kind of question, which every answer has under `outcome`.
fn outcomes(kind: &Kind) -> String {
    let words = kind.outcomes.iter();
    let words: Vec<String> = words
        .map(|(word, meaning)| format!("{word} ({meaning})"))
        .collect();
    match words.len() {
        0 | 1 => String::new(),
        _ => format!(" `outcome` is one of: {}.", words.join("; ")),
    }
}

fn text(about: &str) -> Value {
    json!({ "type": "string", "description": about })
}

/// The schema of arguments, with some of those that several tools take, of which some are needed.
fn with(schema: Value, beside: &[&str], needed: &[&str]) -> Map<String, Value> {
    let mut schema = match schema {
        Value::Object(keys) => keys,
        _ => Map::new(),
    };
    for key in ["$schema", "title", "description"] {
        schema.remove(key);
    }
    schema.insert("type".to_owned(), "object".into());
    let properties = schema.entry("properties").or_insert_with(|| json!({}));
    for &key in beside {
        properties[key] = shared(key);
    }
    let required = schema.entry("required").or_insert_with(|| json!([]));
    if let Value::Array(all) = required {
        all.extend(needed.iter().map(|&key| key.into()));
    }
    schema.insert("additionalProperties".to_owned(), false.into());
    schema
}

/// An argument that several tools take.
fn shared(key: &str) -> Value {
    match key {
        "model" => text(
            "The text of a model (TOML or JSON; see `reference`), or the path of a model file below the server's folder.",
        ),
        "set" => json!({
            "type": "object",
            "description": "Other values of the model's parameters: numbers, or texts such as \"18deg\" or an expression.",
            "additionalProperties": { "type": ["number", "string"] },
        }),
        "detail" => json!({
            "type": "boolean",
            "description": "The whole answer, however long; without it lists are cut so that it has at most 4 kB.",
        }),
        "drawings" => json!({
            "type": "array",
            "items": { "type": "string" },
            "minItems": 1,
            "description": "Paths of drawings below the server's folder.",
        }),
        "layer" => json!({
            "type": "array",
            "items": { "type": "string" },
            "description": "Layers of DXF drawings that are read; all if there are none here.",
        }),
        "output" => {
            text("Path of the model file to write, .toml or .json, below the server's folder.")
        }
        _ => text("The topic."),
    }
}
