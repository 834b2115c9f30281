//! The free positions at one orientation, or the plane of two motions on axes.

use cspace::{PairClass, PairSpace, Slice};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize, Serializer};

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::outcome::Done;
use crate::subject::{Chosen, Named, Space};

/// At which orientation a pair is sliced.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; that of the model without.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub named: Named,
    /// The orientation of the moving part, in radians or such as 18deg, at most 1e6 rad from 0; a pair with fixed axes has none.
    #[cfg_attr(feature = "command", arg(long, value_name = "T", value_parser = crate::given::angle, allow_hyphen_values = true))]
    pub theta: Option<f64>,
    /// Count exact fits as free: a loop of the slice may be a single point, or run along a segment or an arc and back; curves are those of
    /// the parts as drawn, and adjacent curves on one line or circle are merged.
    #[cfg_attr(feature = "command", arg(long, hide_short_help = true))]
    pub exact: bool,
}

/// A slice of a pair.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Sliced<'a> {
    /// The positions at one orientation.
    Positions {
        /// The curves between free and blocked positions.
        #[serde(flatten)]
        slice: Slice,
    },
    /// The plane of two motions on axes.
    Plane {
        /// The space, as `fixed-axes-space.schema.json` describes it.
        #[serde(serialize_with = "data")]
        #[schemars(schema_with = "object")]
        space: Space<'a>,
    },
}

impl Content for Sliced<'_> {
    const COMMAND: &'static str = "slice";
    type Outcome = Done;
}

fn data<S: Serializer>(space: &Space<'_>, serializer: S) -> Result<S::Ok, S::Error> {
    match &**space {
        PairSpace::FixedAxes(space) => space.data().serialize(serializer),
        _ => serializer.serialize_none(),
    }
}

fn object(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "object" })
}

impl Question {
    /// Refuses what a pair on fixed axes does not have.
    ///
    /// # Errors
    /// If an orientation is given, or exact fits are to be free.
    pub fn check(&self, pair: &Chosen<'_>) -> Result<(), Error> {
        if pair.is_planar() {
            return Ok(());
        }
        let general = pair.option("general");
        if self.theta.is_some() {
            let (class, theta) = (pair.class(), pair.option("theta"));
            let error = Error::new(format_args!(
                "{theta}: orientation is no coordinate of the {class} pair {}",
                pair.names()
            ));
            return Err(match class {
                PairClass::FixedAxes => error.help(format_args!(
                    "leave {theta} out: the plane of the two motions is shown; or use {general} with the model"
                )),
                _ => error.help(format_args!(
                    "use {general} with the model, which computes it in x, y and theta"
                )),
            });
        }
        if self.exact {
            let exact = pair.option("exact");
            return Err(Error::new(format_args!(
                "{exact}: the plane of two motions has no slices"
            ))
            .help(format_args!(
                "leave {exact} out, or use {general} with the model"
            )));
        }
        Ok(())
    }

    /// Slices a pair.
    ///
    /// # Errors
    /// If it has orientations and none is given, or one outside of the window; if it has none and one is given; if a joint connects the parts.
    pub fn ask<'a>(&self, pair: &'a Chosen<'_>) -> Result<Answer<Pairs<Sliced<'a>>>, Error> {
        self.check(pair)?;
        let sliced = match (pair.is_planar(), self.theta) {
            (true, Some(theta)) => Sliced::Positions {
                slice: pair.slice(theta, self.exact)?,
            },
            (true, None) => {
                return Err(Error::new("slice needs an orientation").help(format_args!(
                    "give {} T, in radians or such as 18deg",
                    pair.option("theta")
                )));
            }
            (false, _) => {
                let space = pair.space()?;
                if !matches!(*space, PairSpace::FixedAxes(_)) {
                    return Err(pair.no_orientation("a slice"));
                }
                Sliced::Plane { space }
            }
        };
        let answers = vec![pair.answer(Done::Done, sliced)];
        Ok(Answer::of_pairs(pair.unit_label(), answers))
    }
}
