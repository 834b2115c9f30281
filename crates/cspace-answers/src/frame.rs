//! The frame of every answer in JSON: the command, the units, and in one word how it came out.

use serde::Serialize;

/// Version of the form of answers.
const VERSION: u32 = 1;

/// Whether the answer to a question is yes, which is also that of a question for a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Is {
    /// Yes, or a value.
    Yes,
    /// The question is open: nothing is decided.
    Open,
    /// No.
    No,
}

/// How a question came out: a word of the answer's schema, and whether that is a yes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outcome {
    /// The word.
    pub word: &'static str,
    /// Whether it says yes.
    pub is: Is,
}

impl Outcome {
    /// Outcome of a question for values, which are known.
    pub const DONE: Self = Self::yes("done");

    /// An outcome that says yes.
    pub const fn yes(word: &'static str) -> Self {
        Self { word, is: Is::Yes }
    }

    /// An outcome that says no.
    pub const fn no(word: &'static str) -> Self {
        Self { word, is: Is::No }
    }

    /// An outcome that leaves the question open.
    pub const fn open(word: &'static str) -> Self {
        Self { word, is: Is::Open }
    }

    /// How a question came out that is about all of these: with no if one is no, otherwise open if one is; done if there is none.
    pub fn worst(all: impl IntoIterator<Item = Self>) -> Self {
        let worse = |a: Self, b: Self| if b.is > a.is { b } else { a };
        all.into_iter().reduce(worse).unwrap_or(Self::DONE)
    }
}

impl Serialize for Outcome {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word)
    }
}

/// Units of the numbers of an answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Units {
    /// Unit of lengths, as the model says; `None` if it says none.
    pub length: Option<String>,
    /// Unit of angles.
    pub angle: &'static str,
    /// Unit of times.
    pub time: &'static str,
    /// Unit of forces, kg times the unit of length per s²; `None` where that has no name.
    pub force: Option<&'static str>,
}

impl Units {
    /// The units of a model in which lengths have this unit.
    ///
    /// ```
    /// assert_eq!(cspace_answers::Units::of(Some("mm")).force, Some("mN"));
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
#[derive(Debug, Serialize)]
pub struct Answer<T> {
    answer: &'static str,
    version: u32,
    units: Units,
    /// How it came out; of several pairs the worst.
    pub outcome: Outcome,
    #[serde(flatten)]
    content: T,
}

impl<T> Answer<T> {
    /// The answer of a command for a model in whose unit lengths are.
    pub fn new(command: &'static str, unit: Option<&str>, outcome: Outcome, content: T) -> Self {
        Self {
            answer: command,
            version: VERSION,
            units: Units::of(unit),
            outcome,
            content,
        }
    }
}

/// The answers for pairs.
#[derive(Debug, Serialize)]
pub struct Pairs<T> {
    pairs: Vec<PairAnswer<T>>,
}

/// The answer for one pair.
#[derive(Debug, Serialize)]
pub struct PairAnswer<T> {
    /// Name of the fixed part.
    pub fixed: String,
    /// Name of the moving part.
    pub moving: String,
    /// How it came out.
    pub outcome: Outcome,
    /// Keys of the pair, beside its names.
    #[serde(flatten)]
    pub content: T,
}

impl<T> Answer<Pairs<T>> {
    /// The answer of a command on pairs.
    pub fn of_pairs(command: &'static str, unit: Option<&str>, pairs: Vec<PairAnswer<T>>) -> Self {
        let outcome = Outcome::worst(pairs.iter().map(|p| p.outcome));
        Self::new(command, unit, outcome, Pairs { pairs })
    }
}
