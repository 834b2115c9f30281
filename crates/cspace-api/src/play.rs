//! Contacts at a configuration, and how far the parts go from it in each direction.

use core::f64::consts::TAU;

use cspace::pair::PairMotion;
use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Location, NearFeatures, PairSpace, QueryError,
    RegionId, Vector,
};
use cspace_design::{
    FeaturePair, Motion, Outcome as Reach, displace, pair_of, reach, texts, touching,
};
use cspace_model::model::Coordinate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content, Pairs};
use crate::given::{self, Given};
use crate::host::Host;
use crate::outcome::outcomes;
use crate::subject::{Chosen, Subject, Which, about};

/// Default of `touch`, as a share of the smaller part's size.
const NEARBY: f64 = 0.01;

/// At which configuration is asked.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default)]
pub struct Question {
    /// The pair; all of the model without `at` and `by`.
    #[serde(flatten)]
    #[cfg_attr(feature = "command", command(flatten))]
    pub which: Which,
    /// The point of the moving part, in its frame, that moves straight and about which the part turns.
    #[cfg_attr(feature = "command", arg(long, value_name = "X,Y", value_parser = crate::command::point, allow_hyphen_values = true, hide_short_help = true))]
    pub about: Option<[f64; 2]>,
    /// The configuration: x,y,theta, or u,v of a pair on fixed axes [default: as drawn, of every pair]
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "C", allow_hyphen_values = true)
    )]
    pub at: Option<Given>,
    /// Move from there by this displacement, in the same coordinates, at constant rates, to the first contact.
    #[cfg_attr(
        feature = "command",
        arg(long, value_name = "D", allow_hyphen_values = true)
    )]
    pub by: Option<Given>,
    /// How far apart features may be that are near, in the model's unit [default: a hundredth of the smaller part's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::distance, allow_negative_numbers = true))]
    pub touch: Option<f64>,
}

outcomes! {
    /// How the parts are at the configuration.
    Outcome {
        /// They do not touch.
        Free = "free" is Yes,
        /// They touch.
        Contact = "contact" is Yes,
        /// They touch, and have no room to move.
        ExactFit = "exact-fit" is Yes,
        /// They never part.
        Joined = "joined" is Yes,
        /// They overlap.
        Blocked = "blocked" is No,
    }
}

impl Content for Play {
    const COMMAND: &'static str = "play";
    type Outcome = Outcome;
}

/// The play of a pair.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Play {
    /// The class of the pair.
    pub class: String,
    /// The configuration asked about.
    pub at: Coordinates,
    /// How the parts are there.
    #[serde(skip)]
    pub is: Outcome,
    /// The number of the free region.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<u32>")]
    pub region: Option<RegionId>,
    /// The minimum distance of the parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearance: Option<f64>,
    /// The gap by which the moving part is smaller, where the parts fit exactly.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
    /// How far the parts go.
    pub directions: Vec<Direction>,
    /// The features that touch, or nearly.
    pub near: Vec<Near>,
    /// How far apart features are at most that are near, where that is asked for.
    #[serde(skip)]
    pub within: Option<f64>,
    /// How far a displacement leads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<Moved>,
}

/// Two features that touch, or nearly.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Near {
    /// Features of the fixed and of the moving part.
    pub features: [String; 2],
    /// As above, not as text.
    #[serde(skip)]
    pub names: FeaturePair,
    /// How far the features are apart; less than 0 by as much as they overlap.
    pub distance: f64,
    /// The nearest point of the fixed part, in its frame.
    pub at: [f64; 2],
    /// The nearest point of the moving part, in the fixed part's frame.
    pub on_moving: [f64; 2],
    /// The outward unit normal of the fixed part.
    pub normal: [f64; 2],
}

/// How far a displacement at constant rates leads.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Moved {
    /// The outcome in a word.
    pub result: &'static str,
    /// The fraction of the displacement that is travelled.
    pub fraction: f64,
    /// The configuration that is reached.
    pub at: Coordinates,
    /// Features of the fixed and of the moving part.
    pub touching: Vec<[String; 2]>,
    /// How it ends.
    #[serde(skip)]
    pub outcome: Reach,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<FeaturePair>,
}

/// How far the parts go in one direction.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Direction {
    /// Its name.
    pub direction: String,
    /// In the model's unit of length, or radians; none where nothing stops it.
    pub distance: Option<f64>,
    /// The end that it comes to.
    pub stopped_by: Stop,
    /// Features of the fixed and of the moving part that stop it.
    pub touching: Vec<[String; 2]>,
    /// Whether the distance is an angle.
    #[serde(skip)]
    pub is_turn: bool,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<FeaturePair>,
}

/// The end of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Stop {
    /// A contact.
    Contact,
    /// The end of a motion's range, or of the window of orientations.
    Limit,
    /// Nothing.
    Nothing,
}

impl Question {
    fn of(&self, pair: &Chosen<'_>) -> Result<Play, Error> {
        given::size(pair.host(), "touch", self.touch)?;
        let at = pair.at("at", self.at.as_ref())?;
        let by = (self.by.as_ref())
            .map(|by| pair.coordinates("by", by))
            .transpose()?;
        let about = pair.about(self.about)?;
        let failed = |e: QueryError| pair.unanswered(&pair.option("at"), &e);
        let (space, gap) = pair.space_with_room(&[at])?;
        let mut play = at_configuration(&space, at, about).map_err(failed)?;
        if gap.is_some() {
            play.gap = gap;
            play.is = Outcome::ExactFit;
        }
        if matches!(*space, PairSpace::Lower(_)) {
            return match by {
                Some(_) => Err(pair.unanswered(&pair.option("by"), &QueryError::Permanent)),
                None => Ok(play),
            };
        }
        let size = pair.fixed().size().min(pair.moving().size());
        let within = self.touch.unwrap_or(NEARBY * size);
        play.within = self.touch;
        let drawn = pair.space()?;
        let near = drawn.near_features(at, within).map_err(failed)?;
        play.near = near.iter().map(|near| Near::of(&drawn, near)).collect();
        if let Some(by) = by {
            let motion = Motion::new(at, by).about(about.unwrap_or(Vector::ZERO));
            let done = displace(&space, &motion).map_err(failed)?;
            play.motion = Some(Moved {
                result: done.outcome.name(),
                fraction: done.fraction,
                at: done.at,
                touching: done.features.iter().map(|&f| texts(&space, f)).collect(),
                outcome: done.outcome,
                features: done.features,
            });
        }
        Ok(play)
    }

    /// The pairs that are asked about.
    ///
    /// # Errors
    /// If there are none, or several for one configuration.
    pub fn pairs<'a>(
        &self,
        subject: &'a Subject,
        host: &'a dyn Host,
    ) -> Result<Vec<Chosen<'a>>, Error> {
        match (&self.at, &self.by) {
            (None, None) => subject.pairs(&self.which, host),
            _ => Ok(vec![subject.one_pair(&self.which, host)?]),
        }
    }

    /// The play of these pairs.
    ///
    /// # Errors
    /// If a pair cannot be computed, or not be asked there.
    pub fn ask(&self, pairs: &[Chosen<'_>]) -> Result<Answer<Pairs<Play>>, Error> {
        about(pairs, |pair| {
            let play = self.of(pair)?;
            Ok(pair.answer(play.is, play))
        })
    }
}

impl Near {
    fn of(space: &PairSpace, near: &NearFeatures) -> Self {
        let (p, q, n) = (
            near.touching.on_fixed,
            near.touching.on_moving,
            near.touching.normal,
        );
        Self {
            features: texts(space, pair_of(near)),
            names: pair_of(near),
            distance: near.distance,
            at: [p.x, p.y],
            on_moving: [q.x, q.y],
            normal: [n.x, n.y],
        }
    }
}

fn at_configuration(
    space: &PairSpace,
    at: Coordinates,
    about: Option<Vector>,
) -> Result<Play, QueryError> {
    let mut play = Play {
        class: space.class().to_string(),
        at,
        is: Outcome::Joined,
        region: None,
        clearance: None,
        gap: None,
        directions: Vec::new(),
        near: Vec::new(),
        within: None,
        motion: None,
    };
    if matches!(space, PairSpace::Lower(_)) {
        return Ok(play);
    }
    play.is = match space.locate(at)? {
        Location::Free(region) => {
            play.region = Some(region);
            Outcome::Free
        }
        Location::Contact => Outcome::Contact,
        Location::Blocked => Outcome::Blocked,
        Location::Outside => return Err(QueryError::Outside),
    };
    play.clearance = space.clearance(at).ok().filter(|c| c.is_finite());
    if play.is != Outcome::Blocked {
        play.directions = match (space, at) {
            (PairSpace::FixedAxes(axes), Coordinates::Axes { .. }) => {
                on_axes(space, axes.axes(), at)?
            }
            (_, Coordinates::Planar(c)) => in_the_plane(space, c, about)?,
            _ => Vec::new(),
        };
    }
    Ok(play)
}

/// Along both axes of the fixed part's frame, and turned about the moving part's origin and its middle or about a given point of it.
fn in_the_plane(
    space: &PairSpace,
    c: Configuration,
    about: Option<Vector>,
) -> Result<Vec<Direction>, QueryError> {
    let from = Coordinates::Planar(c);
    let far = reach(space, from, Coordinate::X);
    let mut all = Vec::new();
    for (name, x, y) in [
        ("+x", 1.0, 0.0),
        ("-x", -1.0, 0.0),
        ("+y", 0.0, 1.0),
        ("-y", 0.0, -1.0),
    ] {
        let rates = Coordinates::Planar(Configuration::new(x, y, 0.0));
        all.push(straight(
            space,
            &Motion::new(from, rates),
            far,
            name.to_owned(),
            false,
        )?);
    }
    let middle = space.moving().bounds().center().to_vector();
    let origin = Vector::ZERO;
    let points = match about {
        Some(about) => vec![(about, "the point given")],
        None if middle == origin => vec![(origin, "its origin")],
        None => vec![(origin, "its origin"), (middle, "its middle")],
    };
    for (point, named) in points {
        for (sign, turn) in [("+", 1.0), ("-", -1.0)] {
            let rates = Coordinates::Planar(Configuration::new(0.0, 0.0, turn));
            let motion = Motion::new(from, rates).about(point);
            let name = format!("turn {sign} about {named}");
            all.push(straight(space, &motion, TAU, name, true)?);
        }
    }
    Ok(all)
}

/// The motions of each part that moves, in both directions, while the other is held.
fn on_axes(
    space: &PairSpace,
    (fixed, moving): (Axis, Axis),
    at: Coordinates,
) -> Result<Vec<Direction>, QueryError> {
    let mut all = Vec::new();
    for (of, part, axis) in [
        (Coordinate::U, space.fixed().name(), fixed),
        (Coordinate::V, space.moving().name(), moving),
    ] {
        let is_turn = match axis.motion {
            AxisMotion::Fixed => continue,
            AxisMotion::Revolute { .. } => true,
            AxisMotion::Prismatic { .. } => false,
        };
        let far = reach(space, at, of);
        for (sign, way) in [("+", 1.0), ("-", -1.0)] {
            let (u, v) = match of {
                Coordinate::U => (way, 0.0),
                _ => (0.0, way),
            };
            let rates = Coordinates::Axes { u, v };
            let verb = if is_turn { "turns" } else { "slides" };
            let name = format!("{sign}{} ({part} {verb})", of.name());
            all.push(straight(
                space,
                &Motion::new(at, rates),
                far,
                name,
                is_turn,
            )?);
        }
    }
    Ok(all)
}

/// A motion of constant rates of 1.
fn straight(
    space: &PairSpace,
    motion: &Motion,
    far: f64,
    direction: String,
    is_turn: bool,
) -> Result<Direction, QueryError> {
    let (distance, stopped_by, features) = match motion.first_contact(space, far)? {
        PairMotion::Free => (None, Stop::Nothing, Vec::new()),
        PairMotion::Leaves { time } => (Some(time), Stop::Limit, Vec::new()),
        PairMotion::Contact(contact) => {
            // The motion takes a time of 1 to its contact, by which times of moments are measured.
            let features = touching(space, motion, &contact)?;
            (Some(contact.time), Stop::Contact, features)
        }
    };
    Ok(Direction::new(
        space, direction, distance, stopped_by, features, is_turn,
    ))
}

impl Direction {
    fn new(
        space: &PairSpace,
        direction: String,
        distance: Option<f64>,
        stopped_by: Stop,
        features: Vec<FeaturePair>,
        is_turn: bool,
    ) -> Self {
        Self {
            direction,
            distance,
            stopped_by,
            touching: features.iter().map(|&f| texts(space, f)).collect(),
            is_turn,
            features,
        }
    }
}
