//! Names of edges and vertices: `names = { "line 3 of loop 0" = "tip" }`.

use cspace::part::PartFeature;
use cspace::{Edge, Part, PartError};

use super::error::ModelError;
use super::node::Node;
use super::scope::Result;
use super::value::Value;
use crate::shown::quoted;

/// Help text on how to give a name.
const HELP: &str = "give it as names = { \"line 3 of loop 0\" = \"tip\" }: what is printed, and what it is to be called";

/// The part with the names that a file gives its edges and vertices.
pub(super) fn with_names(mut part: Part, names: &Value<'_>) -> Result<Part> {
    let Node::Table(entries) = names.node else {
        let found = names.node.describe();
        let message = format!("{found} where a table of names is expected");
        return Err(names.error(message).with_help(HELP));
    };
    for (text, name) in entries.iter() {
        let at = || names.place.key(text).itself();
        let wrong =
            |message: String, help: &str| Err(ModelError::new(&at(), message).with_help(help));
        let Node::Text(name) = name else {
            return wrong(
                format!("{} where a name is expected", name.describe()),
                HELP,
            );
        };
        let Some((kind, feature)) = feature(text) else {
            return wrong(format!("{} is no feature", quoted(text)), HELP);
        };
        match edge(&part, feature).map(|e| kind_of(&e)) {
            Some(is) if !kind.is_empty() && !is.ends_with(kind) => {
                let message = format!("{} is a {is}, no {kind}", quoted(text));
                return wrong(message, "call it what `cspace play` and others print");
            }
            _ => {}
        }
        part = part
            .with_feature_name(feature, &**name)
            .map_err(|e| match &e {
                PartError::NoFeature { .. } => {
                    ModelError::new(&at(), format!("there is no {}", quoted(text)))
                        .with_help("choose one of the part's loops and vertices, counted from 0")
                }
                _ => ModelError::new(
                    &at(),
                    format!("the name {} is empty or given twice", quoted(name)),
                )
                .with_help("give every feature a name of its own"),
            })?;
    }
    Ok(part)
}

/// The kind, if the text names one, and the place of a feature such as `convex arc 3 of loop 0`.
pub(super) fn feature(text: &str) -> Option<(&str, PartFeature)> {
    let (feature, loop_index) = text.trim().split_once(" of loop ")?;
    let (kind, index) = feature.rsplit_once(' ')?;
    let (loop_index, index) = (loop_index.parse().ok()?, index.parse().ok()?);
    match kind {
        "vertex" => Some(("", PartFeature::Vertex { loop_index, index })),
        "edge" => Some(("", PartFeature::Edge { loop_index, index })),
        "line" | "arc" | "convex arc" | "concave arc" => {
            Some((kind, PartFeature::Edge { loop_index, index }))
        }
        _ => None,
    }
}

fn edge(part: &Part, feature: PartFeature) -> Option<Edge> {
    let PartFeature::Edge { loop_index, index } = feature else {
        return None;
    };
    let mut edges = part.loops().get(loop_index as usize)?.edges();
    edges.find(|e| e.index == index as usize)
}

/// Kind of an edge, for messages.
fn kind_of(edge: &Edge) -> &'static str {
    match edge {
        e if e.is_line() => "line",
        e if e.sweep() > 0.0 => "convex arc",
        _ => "concave arc",
    }
}
