//! The configuration space of a pair, summed up: whether the parts fit as drawn, its free regions, and what it consists of.

mod summary;

use schemars::JsonSchema;
use serde::Deserialize;

pub use summary::{
    AsDrawn, Counts, Drawn, FeatureCount, Freedom, Links, PerPart, Regions, Seconds, Statistic,
    Summary,
};

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::outcome::Done;
use crate::subject::{Chosen, Space, Which};

/// The spaces of which pairs are computed.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; all of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub which: Which,
    /// The space in which the parts keep this clearance, in the model's unit: with the moving part grown by it all round.
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::length, allow_negative_numbers = true))]
    pub clearance: Option<f64>,
}

impl Content for Summary {
    const COMMAND: &'static str = "compute";
    type Outcome = Done;
}

impl Question {
    /// The space of a pair.
    ///
    /// # Errors
    /// If it cannot be computed.
    pub fn space<'a>(&self, pair: &'a Chosen<'_>) -> Result<Space<'a>, Error> {
        match self.clearance {
            Some(clearance) => pair.space_with_clearance(clearance),
            None => pair.space(),
        }
    }

    /// Computes the spaces of these pairs, and sums them up.
    ///
    /// # Errors
    /// If a pair cannot be computed.
    pub fn ask(&self, pairs: &[Chosen<'_>]) -> Result<Answer<Pairs<Summary>>, Error> {
        let spaces = pairs.iter().map(|pair| self.space(pair));
        let spaces = spaces.collect::<Result<Vec<_>, Error>>()?;
        Ok(summed_up(pairs, &spaces))
    }
}

/// The answer about pairs whose spaces are known.
pub fn summed_up(pairs: &[Chosen<'_>], spaces: &[Space<'_>]) -> Answer<Pairs<Summary>> {
    let unit = pairs.first().and_then(|pair| pair.unit_label());
    let answer = |(pair, space): (&Chosen<'_>, &Space<'_>)| {
        pair.answer(Done::Done, Summary::of(pair, space))
    };
    Answer::of_pairs(unit, pairs.iter().zip(spaces).map(answer).collect())
}
