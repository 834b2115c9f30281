//! Where a pair is free, blocked, or either, within the tolerances.

use cspace::{Options, PairSpace, Part};
use cspace_design::{Cell, Zones as Found};
use cspace_model::PairEntry;
use cspace_model::model::{Coordinate, Requirement, Subject as Measured};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Nominal;
use crate::error::Error;
use crate::frame::{Answer, Content, PairAnswer, Pairs};
use crate::host::Host;
use crate::outcome::Done;
use crate::subject::Subject;

/// The pair of which the zones are asked for, and where.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[cfg_attr(feature = "command", group(skip))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// The names of requirements: the pair is that of the first of them that is about one; of all of the model without a name.
    #[cfg_attr(feature = "command", arg(skip))]
    pub requirement: Vec<String>,
    /// The orientation of the zones of a pair in the plane [default: that at which the requirement is measured]
    #[cfg_attr(feature = "command", arg(long, value_name = "A", value_parser = crate::given::angle, allow_hyphen_values = true))]
    pub at: Option<f64>,
    /// The ranges of both coordinates that are looked at: of u and v, or of x and y.
    #[cfg_attr(feature = "command", arg(skip))]
    pub window: Option<Cell>,
}

/// The zones of a pair.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Zones {
    /// The names of the coordinates.
    pub coordinates: [Coordinate; 2],
    /// The orientation of a pair in the plane, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theta: Option<f64>,
    /// The rectangle that is looked at: the ranges of both coordinates.
    pub window: Cell,
    /// Rectangles in it, each the ranges of both coordinates.
    #[serde(flatten)]
    pub found: Found,
}

impl Content for Zones {
    const COMMAND: &'static str = "tolerances";
    type Outcome = Done;
}

/// The pair of a question.
pub struct Pair {
    nominal: Nominal,
    entry: PairEntry,
    requirement: Requirement,
    /// Its space as drawn, which is on two axes or in the plane.
    pub space: PairSpace,
    /// Its coordinates: u and v, or x and y.
    pub coordinates: [Coordinate; 2],
    /// The orientation of a pair in the plane, radians.
    pub theta: f64,
}

impl Question {
    /// The pair of the question.
    ///
    /// # Errors
    /// If the model has no such requirements or no tolerances, none is about a pair, or the pair cannot be computed.
    pub fn pair(&self, subject: &Subject, host: &dyn Host) -> Result<Pair, Error> {
        let nominal = Nominal::of(subject, &self.requirement, host)?;
        let mut pairs = (nominal.model.requirements.iter()).filter_map(|r| match r.subject {
            Measured::Pair(pair, _) => Some((r.clone(), pair)),
            Measured::Motion(..) => None,
        });
        let option = host.option("zones");
        let Some((requirement, entry)) = pairs.next() else {
            return Err(subject
                .error("no requirement is about a pair of parts")
                .help(format_args!(
                    "{option} shows the pair of a requirement such as play, position or clearance"
                )));
        };
        let mechanism = &nominal.model.mechanism;
        let part = |i: usize| &mechanism.parts[i].part;
        let options = Options {
            window: entry.window,
            ..Options::default()
        };
        let progress = host.begin(&mechanism.name);
        let parts = (part(entry.fixed), part(entry.moving));
        let (space, _) = host
            .space(parts, mechanism.relation(&entry), &options, &*progress)
            .map_err(Error::new)?;
        let coordinates = match &space {
            PairSpace::FixedAxes(_) => [Coordinate::U, Coordinate::V],
            PairSpace::Planar(_) => [Coordinate::X, Coordinate::Y],
            PairSpace::Lower(_) => {
                return Err(Error::new(format_args!(
                    "{option}: the parts are connected by a joint, which has no tolerances"
                ))
                .help(format_args!(
                    "name a requirement of another pair: {} NAME",
                    host.option("requirement")
                )));
            }
        };
        drop(progress);
        if self.at.is_some() && matches!(space, PairSpace::FixedAxes(_)) {
            let [fixed, moving] = [&parts.0, &parts.1].map(|part| part.name());
            let at = host.option("at");
            return Err(Error::new(format_args!(
                "{at}: {fixed} and {moving} move on axes, and their zones are those of all u and v, without an orientation"
            ))
            .help(format_args!(
                "leave {at} out; the ranges of u and v that are looked at are chosen by {} and {}",
                host.option("u"),
                host.option("v")
            )));
        }
        let mut pair = Pair {
            nominal,
            entry,
            requirement,
            space,
            coordinates,
            theta: 0.0,
        };
        pair.theta = self
            .at
            .or(pair.measured_at(Coordinate::Theta))
            .unwrap_or(0.0);
        Ok(pair)
    }

    /// The zones in the window.
    ///
    /// # Errors
    /// As [`pair`](Self::pair), and if there is no window, or the work is interrupted.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Pairs<Zones>>, Error> {
        let Some(window) = self.window else {
            return Err(
                Error::new("zones are those in a window, and there is none").help(
                    "give `window`, the ranges of both coordinates, such as [[0, 1], [-0.5, 0.5]]",
                ),
            );
        };
        self.pair(subject, host)?.zones(window, subject, host)
    }
}

impl Pair {
    /// The value of a coordinate where the requirement is measured, if it has one there.
    pub fn measured_at(&self, coordinate: Coordinate) -> Option<f64> {
        match self.requirement.subject {
            Measured::Pair(_, mut quantity) => coordinate.of(*quantity.at()),
            Measured::Motion(..) => None,
        }
    }

    /// The zones in a window: ranges of both coordinates.
    ///
    /// # Errors
    /// If nothing is drawn within the tolerances, or the work is interrupted.
    pub fn zones(
        &self,
        window: Cell,
        subject: &Subject,
        host: &dyn Host,
    ) -> Result<Answer<Pairs<Zones>>, Error> {
        let (template, set) = self.nominal.template(subject)?;
        let model = &self.nominal.model;
        let progress = host.begin(&model.mechanism.name);
        let place = (self.entry, window, self.theta);
        let found =
            cspace_design::zones(template, set, model, place, &*progress).map_err(Error::new)?;
        let is_planar = matches!(self.space, PairSpace::Planar(_));
        let name = |part: &Part| part.name().to_owned();
        let answer = PairAnswer {
            fixed: name(self.space.fixed()),
            moving: name(self.space.moving()),
            outcome: Done::Done,
            content: Zones {
                coordinates: self.coordinates,
                theta: is_planar.then_some(self.theta),
                window,
                found,
            },
        };
        Ok(Answer::of_pairs(subject.unit(), vec![answer]))
    }
}
