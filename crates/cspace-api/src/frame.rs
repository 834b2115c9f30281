//! The frame of every answer: the command, the units, and in one word how it came out.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;

use crate::outcome::{Outcome, worst};

/// Version of the form of answers.
const VERSION: u32 = 1;

/// Content of an answer, beside the frame.
pub trait Content: Serialize + JsonSchema {
    /// The command that asks.
    const COMMAND: &'static str;
    /// How it comes out.
    type Outcome: Outcome;
}

/// Units of the numbers of an answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Units {
    /// Unit of lengths, as the model says; `None` if it says none.
    pub length: Option<String>,
    /// Unit of angles.
    #[schemars(extend("const" = "rad"))]
    pub angle: &'static str,
    /// Unit of times.
    #[schemars(extend("const" = "s"))]
    pub time: &'static str,
    /// Unit of forces, kg times the unit of length per s²; `None` where that has no name.
    pub force: Option<&'static str>,
}

impl Units {
    /// The units of a model in which lengths have this unit.
    ///
    /// ```
    /// assert_eq!(cspace_api::Units::of(Some("mm")).force, Some("mN"));
    /// ```
    pub fn of(length: Option<&str>) -> Self {
        Self {
            length: length.map(str::to_owned),
            angle: "rad",
            time: "s",
            force: match length {
                Some("m") => Some("N"),
                Some("cm") => Some("cN"),
                Some("mm") => Some("mN"),
                Some("µm" | "um") => Some("µN"),
                _ => None,
            },
        }
    }
}

/// An answer in its frame: `content` is an object, whose keys follow those of the frame.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer<T: Content> {
    #[schemars(schema_with = "command::<T>")]
    answer: &'static str,
    /// Version of the form of answers.
    #[schemars(extend("const" = VERSION))]
    version: u32,
    /// Units of the numbers.
    units: Units,
    /// How it came out; of several pairs the worst.
    pub outcome: T::Outcome,
    /// The content.
    #[serde(flatten)]
    pub content: T,
}

impl<T: Content> Answer<T> {
    /// The answer to a question about a model in whose unit lengths are.
    pub fn new(unit: Option<&str>, outcome: T::Outcome, content: T) -> Self {
        Self {
            answer: T::COMMAND,
            version: VERSION,
            units: Units::of(unit),
            outcome,
            content,
        }
    }
}

/// The schema of the key that names the command.
fn command<T: Content>(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "description": "The command.", "const": T::COMMAND })
}

/// The answers for pairs.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pairs<T: Content> {
    /// The answer for each pair.
    pub pairs: Vec<PairAnswer<T>>,
}

impl<T: Content> Content for Pairs<T> {
    const COMMAND: &'static str = T::COMMAND;
    type Outcome = T::Outcome;
}

/// The answer for one pair.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(rename = "{T}OfPair")]
pub struct PairAnswer<T: Content> {
    /// Name of the fixed part.
    pub fixed: String,
    /// Name of the moving part.
    pub moving: String,
    /// How it came out.
    pub outcome: T::Outcome,
    /// Keys of the pair, beside its names.
    #[serde(flatten)]
    pub content: T,
}

impl<T: Content> Answer<Pairs<T>> {
    /// The answer of a command on pairs.
    pub fn of_pairs(unit: Option<&str>, pairs: Vec<PairAnswer<T>>) -> Self {
        let outcome = worst(pairs.iter().map(|p| p.outcome));
        Self::new(unit, outcome, Pairs { pairs })
    }
}
