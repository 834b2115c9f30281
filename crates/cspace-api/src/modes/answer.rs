//! The operating modes of parts on axes, and where a configuration of them is.

use cspace::{Axis, AxisMotion};
use cspace_model::Mechanism;
use cspace_plan::modes::{
    ModePlace, Modes, ModesError, TreeMode, TreeModes, TrioPair, coordinate_name,
};
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
        /// There is none: no configuration of the parts is free.
        Blocked = "blocked" is No,
    }
}

/// The operating modes of three parts or more on axes.
#[derive(Debug, Serialize, JsonSchema)]
pub struct OperatingModes {
    /// The parts, whose coordinates are u, v, w, and of those after the third q4, q5 and so on.
    #[schemars(length(min = 3))]
    pub parts: Vec<Part>,
    /// Pairs of the parts: of three parts those of u and v, of v and w, of u and w; of more those that the model has.
    pub pairs: Vec<Pair>,
    /// The modes: connected components of the free configurations.
    pub modes: Vec<Mode>,
    /// The configuration that is asked about.
    pub requested: Requested,
    /// Pairs of the model of one of the parts and another part, which are not considered.
    pub left_out: Vec<[String; 2]>,
    /// The number of places at which contacts coincide but for rounding; if there are any, the modes are not to be relied upon.
    pub doubts: usize,
    /// How long it took (s).
    pub seconds: f64,
    /// The modes as they were computed.
    #[serde(skip)]
    pub found: Found,
}

/// The modes as they were computed.
#[derive(Debug)]
pub enum Found {
    /// Modes of three parts, each of which may touch both others.
    Three(Box<Modes>),
    /// Modes of more parts, whose contacts make a tree.
    Tree(Box<TreeModes>),
}

impl Found {
    /// Computes the modes of three parts or more.
    ///
    /// # Errors
    /// As [`Modes::compute`] and [`TreeModes::compute`].
    pub fn compute(model: &Mechanism, parts: &[usize]) -> Result<Self, ModesError> {
        Ok(match <[usize; 3]>::try_from(parts) {
            Ok(three) => Self::Three(Box::new(Modes::compute(model, three)?)),
            Err(_) => Self::Tree(Box::new(TreeModes::compute(model, parts)?)),
        })
    }

    /// Finds the mode of a configuration; radians or the model's unit of length.
    ///
    /// # Errors
    /// If it is not finite, or has another number of coordinates than there are parts.
    pub fn locate(&self, at: &[f64]) -> Result<ModePlace, ModesError> {
        match self {
            Self::Three(modes) => match <[f64; 3]>::try_from(at) {
                Ok(at) => modes.locate(at),
                Err(_) => Err(ModesError::Coordinates {
                    given: at.len(),
                    parts: 3,
                }),
            },
            Self::Tree(modes) => modes.locate(at),
        }
    }

    /// The parts' indices in the mechanism.
    pub fn parts(&self) -> Vec<usize> {
        match self {
            Self::Three(modes) => modes.parts().to_vec(),
            Self::Tree(modes) => modes.parts().to_vec(),
        }
    }

    /// The names of the parts.
    pub fn names(&self) -> &[String] {
        match self {
            Self::Three(modes) => modes.names(),
            Self::Tree(modes) => modes.names(),
        }
    }

    /// The axes of the parts.
    pub fn axes(&self) -> &[Axis] {
        match self {
            Self::Three(modes) => modes.axes(),
            Self::Tree(modes) => modes.axes(),
        }
    }

    /// The pairs.
    pub fn pairs(&self) -> &[TrioPair] {
        match self {
            Self::Three(modes) => modes.pairs(),
            Self::Tree(modes) => modes.pairs(),
        }
    }

    /// The modes.
    pub fn list(&self) -> Vec<TreeMode> {
        match self {
            Self::Three(modes) => modes.list().iter().map(whole).collect(),
            Self::Tree(modes) => modes.list().to_vec(),
        }
    }

    fn doubts(&self) -> usize {
        match self {
            Self::Three(modes) => modes.doubts(),
            Self::Tree(modes) => modes.doubts(),
        }
    }
}

/// A mode of three parts as one of any number.
fn whole(mode: &cspace_plan::modes::Mode) -> TreeMode {
    TreeMode {
        sample: mode.sample.to_vec(),
        ranges: mode.ranges.to_vec(),
        open: mode.open.to_vec(),
        turns: mode.turns.iter().map(|t| t.to_vec()).collect(),
    }
}

/// One of the parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Part {
    /// Its name.
    pub name: String,
    /// Name of its coordinate.
    #[schemars(regex(pattern = "^(u|v|w|q[1-9][0-9]*)$"))]
    pub coordinate: String,
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

/// Two of the parts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pair {
    /// The fixed part's name.
    pub fixed: String,
    /// The moving part's name.
    pub moving: String,
    /// The coordinates of the fixed and of the moving part.
    pub coordinates: [String; 2],
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
    /// Ranges of the coordinates of the fourth part and those after it, if there are such.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub more: Vec<Reach>,
    /// The turns of all coordinates by which motions within the mode come back to where they began: all are sums of whole multiples of these.
    pub turns: Vec<Vec<i64>>,
    /// A configuration in the mode.
    pub sample: PartCoordinates,
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

/// A configuration of the parts, in radians or the model's unit.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PartCoordinates {
    /// Motion of the first part.
    pub u: f64,
    /// Motion of the second part.
    pub v: f64,
    /// Motion of the third part.
    pub w: f64,
    /// Motions of the fourth part and those after it, if there are such.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub more: Vec<f64>,
}

/// Where the configuration is that is asked about.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Requested {
    /// The configuration.
    pub at: PartCoordinates,
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

/// How the parts are at a configuration.
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

impl PartCoordinates {
    fn of(at: &[f64]) -> Self {
        let one = |k: usize| at.get(k).copied().unwrap_or_default();
        Self {
            u: one(0),
            v: one(1),
            w: one(2),
            more: at.iter().skip(3).copied().collect(),
        }
    }

    /// All, in the order of the parts.
    pub fn all(&self) -> Vec<f64> {
        [&[self.u, self.v, self.w], &self.more[..]].concat()
    }
}

impl OperatingModes {
    /// The modes of three parts or more of a mechanism, and the place of a configuration among them, which took so many seconds to
    /// compute.
    pub fn of(
        model: &Mechanism,
        found: Found,
        (at, place): (&[f64], ModePlace),
        seconds: f64,
    ) -> Self {
        Self {
            parts: (0..found.axes().len())
                .map(|k| Part::of(&found, k))
                .collect(),
            pairs: (found.pairs().iter())
                .map(|pair| Pair::of(&found, pair))
                .collect(),
            modes: found.list().iter().map(Mode::of).collect(),
            requested: Requested::of(&found, at, place),
            left_out: left_out(model, &found.parts()),
            doubts: found.doubts(),
            seconds,
            found,
        }
    }
}

impl Part {
    fn of(found: &Found, k: usize) -> Self {
        let axis = found.axes()[k];
        Self {
            name: found.names()[k].clone(),
            coordinate: coordinate_name(k),
            motion: match axis.motion {
                AxisMotion::Prismatic { .. } => Motion::Prismatic,
                _ => Motion::Revolute,
            },
            range: axis.range.map(|(lo, hi)| [lo, hi]),
        }
    }
}

impl Pair {
    fn of(found: &Found, pair: &TrioPair) -> Self {
        let (names, space) = (found.names(), pair.space.as_ref());
        Self {
            fixed: names[pair.coordinates[0]].clone(),
            moving: names[pair.coordinates[1]].clone(),
            coordinates: pair.coordinates.map(coordinate_name),
            listed: space.is_some(),
            patches: space.map_or(0, |s| s.patches().len()),
            free_regions: space.map_or(1, |s| s.regions().len()),
        }
    }
}

impl Mode {
    fn of(mode: &TreeMode) -> Self {
        let reach = |k: usize| Reach {
            lo: Some(mode.ranges[k].0).filter(|_| !mode.open[k].0 && !mode.around(k)),
            hi: Some(mode.ranges[k].1).filter(|_| !mode.open[k].1 && !mode.around(k)),
            around: mode.around(k),
        };
        Self {
            u: reach(0),
            v: reach(1),
            w: reach(2),
            more: (3..mode.ranges.len()).map(reach).collect(),
            turns: mode.turns.clone(),
            sample: PartCoordinates::of(&mode.sample),
        }
    }
}

impl Requested {
    fn of(found: &Found, at: &[f64], place: ModePlace) -> Self {
        let name = |k: usize| found.names()[k].clone();
        // Of three parts in their order, whichever is the pair's fixed one.
        let both = |pair: usize| {
            let mut of = found.pairs()[pair].coordinates;
            of.sort_unstable();
            of.map(name).to_vec()
        };
        let (result, mode, between) = match place {
            ModePlace::Mode(mode) => (Is::Free, Some(mode), Vec::new()),
            ModePlace::Contact(pair) => (Is::Contact, None, both(pair)),
            ModePlace::Blocked(pair) => (Is::Blocked, None, both(pair)),
            ModePlace::Outside(k) => (Is::Outside, None, vec![name(k)]),
            ModePlace::Closed => (Is::Closed, None, Vec::new()),
        };
        Self {
            at: PartCoordinates::of(at),
            result,
            mode,
            between,
            place,
        }
    }
}

fn left_out(model: &Mechanism, parts: &[usize]) -> Vec<[String; 2]> {
    let is_one = |part: usize| parts.contains(&part);
    (model.pairs.iter())
        .filter(|p| is_one(p.fixed) != is_one(p.moving))
        .map(|p| [p.fixed, p.moving].map(|i| model.parts[i].part.name().to_owned()))
        .collect()
}
