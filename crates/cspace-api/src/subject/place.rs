//! Configurations and displacements as they are given.

use cspace::{Configuration, Coordinates, PairClass, QueryError};
use cspace_model::shown;

use super::Chosen;
use crate::error::Error;
use crate::given::{self, Given};

impl Chosen<'_> {
    /// Whether a configuration of the pair is (u, v).
    pub fn is_on_axes(&self) -> bool {
        !self.is_planar() && self.class() == PairClass::FixedAxes
    }

    /// The configuration, or displacement, that is given as the option of this name: x, y, θ, or u, v of a pair on fixed axes.
    ///
    /// # Errors
    /// If there are more or fewer numbers, or some are none.
    pub fn coordinates(&self, option: &str, given: &Given) -> Result<Coordinates, Error> {
        let (option, given) = (self.option(option), given.texts());
        let names: &[(&str, bool)] = if self.is_on_axes() {
            let (u, v) = self.turns();
            &[("u", u), ("v", v)]
        } else {
            &[("x", false), ("y", false), ("theta", true)]
        };
        let wanted: Vec<&str> = names.iter().map(|n| n.0).collect();
        if given.len() != names.len() {
            let class = self.class();
            let by_general = class == PairClass::FixedAxes && !self.is_on_axes();
            let method = if by_general {
                " by the general method"
            } else {
                ""
            };
            return Err(Error::new(format_args!(
                "{option} {}: a {class} pair{method} takes {} numbers",
                shown::cut(&given.join(",")),
                names.len()
            ))
            .help(format_args!("give {option} {}", wanted.join(","))));
        }
        let mut numbers = [0.0; 3];
        for ((to, text), (name, is_angle)) in numbers.iter_mut().zip(&given).zip(names) {
            let number = if *is_angle {
                given::angle(text)
            } else {
                (text.trim().parse::<f64>().ok().filter(|x| x.is_finite()))
                    .ok_or_else(|| format!("{} is no number", shown::quoted(text)))
            };
            *to = number.map_err(|why| {
                Error::new(format_args!("{option}, {name}: {why}")).help(
                    "give a finite number; angles are in radians, or have a unit such as 18deg",
                )
            })?;
        }
        let [a, b, c] = numbers;
        Ok(if self.is_on_axes() {
            Coordinates::Axes { u: a, v: b }
        } else {
            Coordinates::Planar(Configuration::new(a, b, c))
        })
    }

    /// The configuration in which the parts are as drawn.
    pub fn as_drawn(&self) -> Coordinates {
        match self.is_on_axes() {
            true => Coordinates::Axes { u: 0.0, v: 0.0 },
            false => Coordinates::Planar(Configuration::default()),
        }
    }

    /// The configuration that is given as the option of this name, or as drawn.
    ///
    /// # Errors
    /// As [`coordinates`](Self::coordinates).
    pub(crate) fn at(&self, option: &str, given: Option<&Given>) -> Result<Coordinates, Error> {
        given.map_or(Ok(self.as_drawn()), |given| self.coordinates(option, given))
    }

    /// The error of a query that has no answer at a place, such as the configuration that an option gives.
    pub fn unanswered(&self, place: &str, error: &QueryError) -> Error {
        let failure = Error::new(format_args!("{place}: pair {}: {error}", self.names()));
        match error {
            QueryError::Outside => {
                failure.help("choose a configuration within the window and the ranges of motion")
            }
            QueryError::Permanent => failure.help(format_args!(
                "ask about a pair without a joint, or with {}",
                self.option("general")
            )),
            _ => failure,
        }
    }
}
