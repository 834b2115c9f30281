//! Models from a file's tree of values.

use cspace_drawing::Unit;

use super::bodies::Bodies;
use super::drawings::{Files, Setting};
use super::dynamics::read_dynamics;
use super::error::ModelError;
use super::keys::{Key, Keys};
use super::node::Node;
use super::parameters::{Parameter, Parameters, Variation};
use super::parts::read_parts;
use super::place::Place;
use super::profile::with_profiles;
use super::relations::{read_joints, read_pairs};
use super::requirements::{Requirement, read_requirements};
use super::scope::{Entry, Result};
use super::show::read_show;
use super::table::Table;
use super::unmoved::unmoved;
use super::value::Value;
use crate::file::Host;
use crate::mechanism::Mechanism;
use crate::shown;

/// The most parts of a model: a file that lists no pairs stands for every two.
pub const MOST_PARTS: usize = 1000;

/// Keys of the file itself. `$schema` is for editors, which complete and check the file by the schema it names.
#[rustfmt::skip]
pub(super) const FILE: Keys = Keys::new(
    "give keys such as name and part",
    &[
        Key::new("name", "text", "What the model is called. Default: the file's name."),
        Key::new("unit", "text", "The unit of length, a label such as \"mm\". Default: none."),
        Key::new("parameter", "parameters", "Names for numbers: letters, digits and underscores. Any number of the model may be an expression of them. Default: none."),
        Key::new("requirement", "[requirement]", "What the design must do: what is measured, and what it must be. In TOML each is a [[requirement]] table. Default: none."),
        Key::new("part", "parts", "The parts. In TOML each is a [[part]] table.").needed("[[part]]"),
        Key::new("joint", "[joint]", "Permanent connections of two parts. In TOML each is a [[joint]] table. Default: none."),
        Key::new("pair", "[pair]", "The pairs to compute. In TOML each is a [[pair]] table. Default: every two parts, the one listed first fixed."),
        Key::new("show", "show", "What the page shows first, and the question that it answers. Default: a pair that has something to tell."),
        Key::new("$schema", "any_text", "Where an editor finds this schema; `cspace` does not look at it."),
        Key::new("gravity", "point", "The acceleration of what falls, [x, y] in unit/s². Default: none."),
        Key::new("friction", "not_negative", "The coefficient of friction of pairs that have none of their own. Default: 0."),
        Key::new("restitution", "up_to_one", "The coefficient of restitution of pairs that have none of their own: from 0, no bounce, to 1, no loss. Default: 0."),
        Key::new("drive", "[drive]", "Prescribed motions. In TOML each is a [[drive]] table. Default: none."),
        Key::new("load", "[load]", "Constant forces and torques. In TOML each is a [[load]] table. Default: none."),
        Key::new("spring", "[spring]", "Springs and dampers between two parts, or a part and the ground. In TOML each is a [[spring]] table. Default: none."),
    ],
);

/// Model as written in a file: a mechanism, and the parameters of the expressions for its numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// Parts, motions, joints and pairs, in numbers.
    pub mechanism: Mechanism,
    /// The model's parameters, by name.
    pub parameters: Vec<Parameter>,
    /// Requirements of the design, in the order of the file.
    pub requirements: Vec<Requirement>,
    /// Notes for who asks about its pairs: axes that have no effect, since the other part says no motion.
    pub on_pairs: Vec<String>,
}

/// The parameters of a file.
pub(super) fn parameters_of(
    file: &Node,
    host: &Host<'_>,
    variation: Option<&Variation<'_>>,
) -> Result<Parameters> {
    let given = with_profiles(file)?;
    let unit = file.get("unit").and_then(Node::text);
    let place = Place::default().key("parameter");
    let unit = unit.and_then(Unit::of_label);
    Parameters::read(given.as_deref(), &place, host.set, variation, unit)
}

/// Notes on a model.
#[derive(Default)]
pub(super) struct Notes {
    /// For who reads it.
    pub(super) on_all: Vec<ModelError>,
    /// For who asks about its pairs.
    pub(super) on_pairs: Vec<ModelError>,
}

/// The model, without the notes on its pairs, and all notes.
pub(super) fn from_tree(file: &Node, files: &Files<'_>) -> Result<(Model, Notes)> {
    let parameters = parameters_of(file, files.host, None)?;
    let root = Table::new(Value::root(file, &parameters.scope), &FILE)?;
    let (mechanism, mut notes) = mechanism(&root, files)?;
    let requirements = read_requirements(&root, &mechanism)?;
    let words = |entry: &Entry| match (entry.key.as_str(), entry.item) {
        ("part", Some(i)) => {
            let name = match file.get("part") {
                Some(Node::List(parts)) => parts.get(i).and_then(|p| p.get("name")?.text()),
                _ => None,
            };
            format!("part {}", shown::quoted(name.unwrap_or_default()))
        }
        ("requirement", Some(i)) if i < requirements.len() => {
            format!("requirement {}", shown::quoted(&requirements[i].name))
        }
        (key, Some(i)) => format!("{key} {i}"),
        (key, None) => key.to_owned(),
    };
    let place = root.place.key("parameter");
    let (parameters, unused) = parameters.used(&place, words)?;
    notes.on_all.extend(unused);
    let model = Model {
        mechanism,
        parameters,
        requirements,
        on_pairs: Vec::new(),
    };
    Ok((model, notes))
}

/// The mechanism of a file.
fn mechanism(root: &Table<'_>, files: &Files<'_>) -> Result<(Mechanism, Notes)> {
    let parts = root.nodes("part", "write each part as [[part]], in two brackets")?;
    let count = parts.map_or(0, <[Node]>::len);
    if count == 0 {
        return Err(ModelError::of_file("the model has no parts")
            .with_help("describe each part in a [[part]] table with its name and loops"));
    }
    if count > MOST_PARTS {
        let error = root.error("part", format!("{count} parts, more than {MOST_PARTS}"));
        return Err(error.with_help("split the model into several files"));
    }
    root.text("$schema")?;
    let mut setting = Setting {
        files,
        unit: root.text("unit")?,
        notes: Vec::new(),
    };
    let drawn = read_parts(root, &mut setting)?;
    let bodies = Bodies::read(root, drawn)?;
    let joints = read_joints(root, &bodies.parts)?;
    let (pairs, surfaces) = read_pairs(root, &bodies.parts)?;
    let mut mechanism = Mechanism {
        name: root.text("name")?.unwrap_or_default().to_owned(),
        unit: setting.unit.map(str::to_owned),
        parts: bodies.parts.clone(),
        joints,
        pairs,
        ..Mechanism::default()
    };
    if mechanism.pairs.is_empty() {
        mechanism.pairs = mechanism.every_two();
    }
    mechanism.show = read_show(root, &mechanism)?;
    mechanism.dynamics = read_dynamics(root, &mechanism, &bodies, surfaces)?;
    let notes = Notes {
        on_all: setting.notes,
        on_pairs: unmoved(root, &mechanism, &bodies)?,
    };
    Ok((mechanism, notes))
}
