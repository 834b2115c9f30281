//! The operating modes of three parts, and where a configuration of them is.

use cspace::AxisMotion;
use cspace_model::Mechanism;
use cspace_plan::modes::{ModePlace, Modes, PAIRS};
use schemars::JsonSchema;
use serde::Serialize;

use crate::frame::Content;
use crate::outcome::outcomes;

impl Content for OperatingModes {
    const COMMAND: &'static str = "modes";
    type Outcome = Outcome;
}

outcomes! {
    /// Whether there are modes.
    Outcome {
        /// The modes are known.
        Done = "done" is Yes,
        /// There is none: no configuration of the three parts is free.
        Blocked = "blocked" is No,
    }
}

/// The operating modes of three parts on axes.
#[derive(Debug, Serialize, JsonSchema)]
pub struct OperatingModes {
    /// The three parts, whose coordinates are u, v and w.
    pub parts: [Part; 3],
    /// The pairs of u and v, of v and w, of u and w.
    pub pairs: [Pair; 3],
    /// The modes: connected components of the free configurations.
    pub modes: Vec<Mode>,
    /// The configuration that is asked about.
    pub requested: Requested,
    /// Pairs of the model of one of the three parts and another part, which are not considered.
    pub left_out: Vec<[String; 2]>,
    /// The number of places at which contacts coincide but for rounding; if there are any, the modes are not to be relied upon.
    pub doubts: usize,
    /// How long it took (s).
    pub seconds: f64,
    /// The modes as they were computed.
    #[serde(skip)]
    pub found: Modes,
}

/// Name of a coordinate of the three parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Letter {
    /// Coordinate of the first part.
    U,
    /// Coordinate of the second part.
    V,
    /// Coordinate of the third part.
    W,
}

impl Letter {
    /// All, in order.
    pub const ALL: [Self; 3] = [Self::U, Self::V, Self::W];

    /// The letter.
    pub const fn name(self) -> &'static str {
        match self {
            Self::U => "u",
            Self::V => "v",
            Self::W => "w",
        }
    }
}

/// One of the three parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Name of its coordinate.
    pub coordinate: Letter,
    /// How it moves.
    pub motion: Motion,
    /// Minimum and maximum coordinate, in radians or the model's unit; none without limits.
    pub range: Option<[f64; 2]>,
}

/// How a part moves on its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Motion {
    /// It turns.
    Revolute,
    /// It slides.
    Prismatic,
}

/// Two of the three parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pair {
    /// The fixed part's name.
    pub fixed: String,
    /// The moving part's name.
    pub moving: String,
    /// The coordinates of the fixed and of the moving part.
    pub coordinates: [Letter; 2],
    /// Whether the model has the pair; one that it does not have constrains nothing.
    pub listed: bool,
    /// The number of contact patches of the pair's space.
    pub patches: usize,
    /// The number of its free regions.
    pub free_regions: usize,
}

/// A mode.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Mode {
    /// Range of u that the mode reaches.
    pub u: Reach,
    /// Range of v that the mode reaches.
    pub v: Reach,
    /// Range of w that the mode reaches.
    pub w: Reach,
    /// The turns of u, v and w by which motions within the mode come back to where they began: all are sums of whole multiples of these.
    pub turns: Vec<[i64; 3]>,
    /// A configuration in the mode.
    pub sample: ThreeCoordinates,
}

/// Range of a coordinate that a mode reaches, in radians or the model's unit.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Reach {
    /// The minimum; none if there is none.
    pub lo: Option<f64>,
    /// The maximum; none if there is none.
    pub hi: Option<f64>,
    /// Whether the part turns for ever in the mode, alone or with others.
    pub around: bool,
}

/// A configuration of the three parts, in radians or the model's unit.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct ThreeCoordinates {
    /// Motion of the first part.
    pub u: f64,
    /// Motion of the second part.
    pub v: f64,
    /// Motion of the third part.
    pub w: f64,
}

/// Where the configuration is that is asked about.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Requested {
    /// The configuration.
    pub at: ThreeCoordinates,
    /// How the parts are there.
    pub result: Is,
    /// The number of the mode, from 0, in the order of `modes`; none if it is in none.
    pub mode: Option<usize>,
    /// The parts that touch or overlap, or the one whose range is left.
    #[schemars(length(max = 2))]
    pub between: Vec<String>,
    /// The place as it was found.
    #[serde(skip)]
    pub place: ModePlace,
}

/// How three parts are at a configuration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Is {
    /// Free, in a mode.
    Free,
    /// The parts of a pair touch.
    Contact,
    /// The parts of a pair overlap.
    Blocked,
    /// Outside the range of a part.
    Outside,
    /// Free in each pair, but there is no opening between contacts of several pairs.
    Closed,
}

impl From<[f64; 3]> for ThreeCoordinates {
    fn from([u, v, w]: [f64; 3]) -> Self {
        Self { u, v, w }
    }
}

impl From<ThreeCoordinates> for [f64; 3] {
    fn from(c: ThreeCoordinates) -> Self {
        [c.u, c.v, c.w]
    }
}

impl OperatingModes {
    /// The modes of three parts of a mechanism, and the place of a configuration among them, which took so many seconds to compute.
    pub fn of(
        model: &Mechanism,
        found: Modes,
        (at, place): ([f64; 3], ModePlace),
        seconds: f64,
    ) -> Self {
        Self {
            parts: [0, 1, 2].map(|k| Part::of(&found, k)),
            pairs: [0, 1, 2].map(|k| Pair::of(&found, k)),
            modes: found.list().iter().map(Mode::of).collect(),
            requested: Requested::of(&found, at, place),
            left_out: left_out(model, found.parts()),
            doubts: found.doubts(),
            seconds,
            found,
        }
    }
}

impl Part {
    fn of(found: &Modes, k: usize) -> Self {
        let axis = found.axes()[k];
        Self {
            name: found.names()[k].clone(),
            coordinate: Letter::ALL[k],
            motion: match axis.motion {
                AxisMotion::Prismatic { .. } => Motion::Prismatic,
                _ => Motion::Revolute,
            },
            range: axis.range.map(|(lo, hi)| [lo, hi]),
        }
    }
}

impl Pair {
    fn of(found: &Modes, k: usize) -> Self {
        let (names, pair) = (found.names(), &found.pairs()[k]);
        let space = pair.space.as_ref();
        Self {
            fixed: names[pair.coordinates[0]].clone(),
            moving: names[pair.coordinates[1]].clone(),
            coordinates: pair.coordinates.map(|c| Letter::ALL[c]),
            listed: space.is_some(),
            patches: space.map_or(0, |s| s.patches().len()),
            free_regions: space.map_or(1, |s| s.regions().len()),
        }
    }
}

impl Mode {
    fn of(mode: &cspace_plan::modes::Mode) -> Self {
        let reach = |k: usize| Reach {
            lo: Some(mode.ranges[k].0).filter(|_| !mode.open[k].0 && !mode.around(k)),
            hi: Some(mode.ranges[k].1).filter(|_| !mode.open[k].1 && !mode.around(k)),
            around: mode.around(k),
        };
        Self {
            u: reach(0),
            v: reach(1),
            w: reach(2),
            turns: mode.turns.clone(),
            sample: mode.sample.into(),
        }
    }
}

impl Requested {
    fn of(found: &Modes, at: [f64; 3], place: ModePlace) -> Self {
        let name = |k: usize| found.names()[k].clone();
        let both = |pair: usize| PAIRS[pair].map(name).to_vec();
        let (result, mode, between) = match place {
            ModePlace::Mode(mode) => (Is::Free, Some(mode), Vec::new()),
            ModePlace::Contact(pair) => (Is::Contact, None, both(pair)),
            ModePlace::Blocked(pair) => (Is::Blocked, None, both(pair)),
            ModePlace::Outside(k) => (Is::Outside, None, vec![name(k)]),
            ModePlace::Closed => (Is::Closed, None, Vec::new()),
        };
        Self {
            at: at.into(),
            result,
            mode,
            between,
            place,
        }
    }
}

fn left_out(model: &Mechanism, parts: [usize; 3]) -> Vec<[String; 2]> {
    let is_one = |part: usize| parts.contains(&part);
    (model.pairs.iter())
        .filter(|p| is_one(p.fixed) != is_one(p.moving))
        .map(|p| [p.fixed, p.moving].map(|i| model.parts[i].part.name().to_owned()))
        .collect()
}
