//! The frame of every answer in JSON: the command, the units, and in one word how it came out.

use cspace_api::{Is, Units};
use serde::Serialize;

/// Version of the form of answers.
const VERSION: u32 = 1;

/// How a question came out: a word of the answer's schema, and whether that is a yes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Outcome {
    /// The word.
    pub(crate) word: &'static str,
    /// Whether it says yes.
    pub(crate) is: Is,
}

impl Outcome {
    /// Outcome of a question for values, which are known.
    pub(crate) const DONE: Self = Self::yes("done");

    /// An outcome that says yes.
    pub(crate) const fn yes(word: &'static str) -> Self {
        Self { word, is: Is::Yes }
    }

    /// An outcome that says no.
    pub(crate) const fn no(word: &'static str) -> Self {
        Self { word, is: Is::No }
    }

    /// An outcome that leaves the question open.
    pub(crate) const fn open(word: &'static str) -> Self {
        Self { word, is: Is::Open }
    }

    /// How a question came out that is about all of these: with no if one is no, otherwise open if one is; done if there is none.
    pub(crate) fn worst(all: impl IntoIterator<Item = Self>) -> Self {
        let worse = |a: Self, b: Self| if b.is > a.is { b } else { a };
        all.into_iter().reduce(worse).unwrap_or(Self::DONE)
    }
}

impl Serialize for Outcome {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.word)
    }
}

/// An answer in its frame: `content` is an object, whose keys follow those of the frame.
#[derive(Debug, Serialize)]
pub(crate) struct Answer<T> {
    answer: &'static str,
    version: u32,
    units: Units,
    /// How it came out; of several pairs the worst.
    pub(crate) outcome: Outcome,
    #[serde(flatten)]
    content: T,
}

impl<T> Answer<T> {
    /// The answer of a command for a model in whose unit lengths are.
    pub(crate) fn new(
        command: &'static str,
        unit: Option<&str>,
        outcome: Outcome,
        content: T,
    ) -> Self {
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
pub(crate) struct Pairs<T> {
    pairs: Vec<PairAnswer<T>>,
}

/// The answer for one pair.
#[derive(Debug, Serialize)]
pub(crate) struct PairAnswer<T> {
    /// Name of the fixed part.
    pub(crate) fixed: String,
    /// Name of the moving part.
    pub(crate) moving: String,
    /// How it came out.
    pub(crate) outcome: Outcome,
    /// Keys of the pair, beside its names.
    #[serde(flatten)]
    pub(crate) content: T,
}

impl<T> Answer<Pairs<T>> {
    /// The answer of a command on pairs.
    pub(crate) fn of_pairs(
        command: &'static str,
        unit: Option<&str>,
        pairs: Vec<PairAnswer<T>>,
    ) -> Self {
        let outcome = Outcome::worst(pairs.iter().map(|p| p.outcome));
        Self::new(command, unit, outcome, Pairs { pairs })
    }
}

impl<T> PairAnswer<T> {
    /// Answer about a pair, with its names.
    pub(crate) fn of(pair: &cspace_api::Chosen<'_>, outcome: Outcome, content: T) -> Self {
        Self {
            fixed: pair.fixed().name().to_owned(),
            moving: pair.moving().name().to_owned(),
            outcome,
            content,
        }
    }
}
