//! Values of a command's options: the words of enumerations, and numbers with what is true of them.

use std::ffi::OsStr;
use std::marker::PhantomData;

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::given;

/// Reads one of the words of an enumeration. Its schema says which there are, and what they mean; it is made when one is read or listed,
/// since all commands are declared whichever is run.
pub(crate) fn words<T>() -> impl TypedValueParser<Value = T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    Words(PhantomData)
}

struct Words<T>(PhantomData<fn() -> T>);

impl<T> Clone for Words<T> {
    fn clone(&self) -> Self {
        Self(PhantomData)
    }
}

impl<T: JsonSchema> Words<T> {
    fn listed() -> Vec<PossibleValue> {
        let words = crate::ask::words::<T>().into_iter();
        words
            .map(|(word, meaning)| PossibleValue::new(word).help(meaning))
            .collect()
    }
}

impl<T> TypedValueParser for Words<T>
where
    T: JsonSchema + DeserializeOwned + Clone + Send + Sync + 'static,
{
    type Value = T;

    fn parse_ref(
        &self,
        command: &clap::Command,
        arg: Option<&clap::Arg>,
        value: &OsStr,
    ) -> Result<T, clap::Error> {
        PossibleValuesParser::new(Self::listed())
            .try_map(|word| serde_json::from_value(Value::String(word)))
            .parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(Self::listed().into_iter()))
    }
}

/// A positive angle in radians, as [`angle`](given::angle) reads it.
pub(crate) fn turn(text: &str) -> Result<f64, String> {
    match given::angle(text)? {
        turn if turn > 0.0 => Ok(turn),
        _ => Err("give a positive angle".to_owned()),
    }
}

/// A length of 0 or more, from text.
pub(crate) fn distance(text: &str) -> Result<f64, String> {
    given::number(text, |x| x >= 0.0, "give a length, 0 or more")
}

/// A length above 0, from text.
pub(crate) fn length(text: &str) -> Result<f64, String> {
    given::number(text, |x| x > 0.0, "give a positive length")
}

/// A length of either sign by which parts become larger, from text.
pub(crate) fn offset(text: &str) -> Result<f64, String> {
    let advice = "give a length, below 0 to make parts smaller";
    given::number(text, |_| true, advice)
}

/// An energy above 0, from text.
pub(crate) fn energy(text: &str) -> Result<f64, String> {
    given::number(text, |x| x > 0.0, "give a positive energy")
}

/// A time above 0 in seconds, from text.
pub(crate) fn duration(text: &str) -> Result<f64, String> {
    given::number(text, |x| x > 0.0, "give a positive time in seconds")
}

/// The coordinates of a point, from text such as `10,2.5`.
pub(crate) fn point(text: &str) -> Result<[f64; 2], String> {
    two(text, "give the two coordinates of a point, such as 10,2.5")
}

/// An acceleration, from text such as `0,-9810`.
pub(crate) fn acceleration(text: &str) -> Result<[f64; 2], String> {
    two(text, "give two numbers, such as 0,-9810")
}

fn two(text: &str, advice: &str) -> Result<[f64; 2], String> {
    let (x, y) = given::two(text).ok_or(advice)?;
    Ok([x, y])
}
