//! In which order the parts of an assembly come apart, or which lock each other.

use std::time::Instant;

use cspace::{ComputeError, Coordinates, PairError};
use cspace_model::{Mechanism, shown};
use cspace_plan::PlanError;
use cspace_plan::assembly::{
    self, Assembly, AssemblyError, Enclosure, Kind, PartFeature, TakenApart, Tried,
};
use cspace_plan::legs::Scene;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::frame::{Answer, Content};
use crate::given;
use crate::host::Host;
use crate::leg::{legs_in_words, motion_in_words};
use crate::outcome::outcomes;
use crate::subject::Subject;

/// The way in which an assembly is taken apart.
#[derive(Debug, Clone, Copy, Default, Deserialize, JsonSchema)]
#[cfg_attr(feature = "command", derive(clap::Args))]
#[serde(default, deny_unknown_fields)]
pub struct Question {
    /// How far parts that touch are opened, in the model's unit [default: a millionth of the assembly's size]
    #[cfg_attr(feature = "command", arg(long, value_name = "L", value_parser = crate::command::length, allow_negative_numbers = true))]
    pub gap: Option<f64>,
}

outcomes! {
    /// Whether an assembly comes apart.
    Outcome {
        /// All parts that may go out do.
        Apart = "apart" is Yes,
        /// Some do not, however the others move: of two parts one encloses the other.
        Locked = "locked" is No,
        /// No way was found, and none is excluded.
        Unknown = "unknown" is Open,
    }
}

impl Content for Disassembly {
    const COMMAND: &'static str = "disassemble";
    type Outcome = Outcome;
}

/// How an assembly comes apart.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Disassembly {
    /// How it came out, as `outcome`.
    pub verdict: Outcome,
    /// The gap between parts that touch as drawn, in the model's unit.
    pub gap: f64,
    /// Motions, one after the other.
    pub steps: Vec<Step>,
    /// Tree of what comes out of what.
    pub tree: Tree,
    /// If not all comes apart, the smallest set of parts that is known of which none goes out while the others stay; if the outcome is `locked`,
    /// two parts of which one encloses the other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub locked: Option<Locked>,
    /// Effort that was spent where nothing goes out while the others stay; none if that was not needed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tried: Option<Tried>,
    /// The number of contact spaces that were computed.
    pub spaces: usize,
    /// How long it took (s).
    pub seconds: f64,
    /// As above, with parts by their numbers in the mechanism.
    #[serde(skip)]
    pub taken: TakenApart,
}

/// A motion of some parts while others stay.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Step {
    /// `leaves`: the parts go out of those that stay; `moves`: a part makes room and stays among the others.
    pub kind: Kind,
    /// The parts that move, as one.
    pub moving: Vec<String>,
    /// The parts that stay where they are.
    pub staying: Vec<String>,
    /// Configurations joined by motions of constant rates. Of a part on an axis its motion v, with u = 0; of others where they are relative to
    /// where they are before the step: it begins at 0, 0, 0.
    pub path: Vec<Coordinates>,
    /// The point that legs move straight and turn the parts about, x and y in the assembly's frame as the parts are before the step; none on
    /// an axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub about: Option<[f64; 2]>,
    /// Description of each leg of the path in words.
    pub words: Vec<String>,
    /// The least distance along the path, in the model's unit.
    pub clearance: Option<f64>,
    /// Further straight motion, x and y, of parts that leave: so far they go to be out of the way of all that comes later and to have room to be
    /// taken apart, when the steps are played; in the frame of the path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub onward: Option<[f64; 2]>,
}

/// Parts that come out of others.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Tree {
    /// The parts.
    pub parts: Vec<String>,
    /// Branches that go out of them, one after the other.
    pub out: Vec<Branch>,
    /// Parts that are left of them.
    pub left: Vec<String>,
}

/// Parts that go out of others in a step.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Branch {
    /// The indices of the steps by which others make room for it, from 0; absent if nothing has to.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub room: Vec<usize>,
    /// The index of the step, from 0.
    pub step: usize,
    /// Tree of what comes out of it in turn, if it is more than one part.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tree: Option<Tree>,
}

/// Parts of which none goes out while the others stay.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Locked {
    /// The parts.
    pub parts: Vec<String>,
    /// Reasons: every division of the parts into two divides the sides of one of these.
    pub why: Vec<Enclosed>,
}

/// Parts that cannot leave.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Enclosed {
    /// Parts that are enclosed.
    pub moving: Vec<String>,
    /// Parts that enclose them.
    pub staying: Vec<String>,
    /// The number of contact patches that enclose it.
    pub patches: usize,
    /// The features of these: of what stays, and of what moves, each with its part.
    pub touching: Vec<[String; 2]>,
    /// As above, not as text.
    #[serde(skip)]
    pub features: Vec<(PartFeature, PartFeature)>,
    /// Orientations at which the contact space is not relied upon, radians.
    pub doubtful: Vec<(f64, f64)>,
}

impl Question {
    /// Takes the parts of a model apart.
    ///
    /// # Errors
    /// If the model has parts that cannot be taken apart, or the gap is none.
    pub fn ask(&self, subject: &Subject, host: &dyn Host) -> Result<Answer<Disassembly>, Error> {
        let file = subject.model("an assembly is all of its parts")?;
        given::size(host, "gap", self.gap)?;
        let model = &file.model.mechanism;
        let begin = Instant::now();
        let failed = |error: AssemblyError| match error {
            AssemblyError::Pair(e) | AssemblyError::Plan(PlanError::Grown(e))
                if e == PairError::Compute(ComputeError::Interrupted) =>
            {
                Error::new("interrupted")
            }
            AssemblyError::Gap { gap, least, most } => {
                let option = host.option("gap");
                let gap = shown::number(gap);
                let what = format!("{option} {gap}: a gap of this size cannot be opened");
                // Inward, so that what is said is taken.
                let (least, most) = (two_digits(least, f64::ceil), two_digits(most, f64::floor));
                file.error(what)
                    .help(format_args!("give a length from {least} to {most}"))
            }
            error => file.error(error),
        };
        let assembly = Assembly::new(model, self.gap).map_err(failed)?;
        let taken = {
            let progress = host.begin(&shown::text(&model.name));
            assembly.take_apart_with(&*progress).map_err(failed)?
        };
        let seconds = begin.elapsed().as_secs_f64();
        let found = Disassembly::of(model, &assembly, taken, seconds);
        Ok(Answer::new(model.unit.as_deref(), found.verdict, found))
    }
}

/// A positive number to two digits, rounded as `to` says.
fn two_digits(x: f64, to: fn(f64) -> f64) -> shown::Number {
    let decimals = 1.0 - x.log10().floor();
    let step = 10.0_f64.powf(-decimals);
    // Through text, which is free of the rounding of the product.
    let rounded = format!("{}e{}", to(x / step), -decimals);
    shown::number(rounded.parse().unwrap_or(x))
}

impl Disassembly {
    /// How the parts of an assembly of a model come apart, with the time that it took (s).
    pub fn of(model: &Mechanism, assembly: &Assembly, taken: TakenApart, seconds: f64) -> Self {
        let names = |parts: &[usize]| names(model, parts);
        Self {
            verdict: match taken.outcome {
                assembly::Outcome::Apart => Outcome::Apart,
                assembly::Outcome::Locked => Outcome::Locked,
                assembly::Outcome::Unknown => Outcome::Unknown,
            },
            gap: assembly.gap(),
            steps: (taken.steps.iter())
                .map(|step| Step::of(model, assembly, step))
                .collect(),
            tree: Tree::of(&taken.tree, &names),
            locked: taken.locked.as_ref().map(|locked| Locked {
                parts: names(&locked.parts),
                why: (locked.why.iter())
                    .map(|why| Enclosed::of(model, why))
                    .collect(),
            }),
            tried: taken.tried,
            spaces: taken.spaces,
            seconds,
            taken,
        }
    }
}

fn names(model: &Mechanism, parts: &[usize]) -> Vec<String> {
    (parts.iter())
        .map(|&i| model.parts[i].part.name().to_owned())
        .collect()
}

impl Step {
    fn of(model: &Mechanism, assembly: &Assembly, step: &assembly::Step) -> Self {
        let scene = step.scene(assembly.parts(), model);
        let path = &step.path.configurations;
        let is_planar = |s: &&Scene| s.motions().is_none();
        let unit = model.unit.as_deref();
        Self {
            kind: step.kind,
            moving: names(model, &step.moving),
            staying: names(model, &step.staying),
            clearance: Some(step.path.narrowest.clearance).filter(|c| c.is_finite()),
            about: (scene.as_ref().filter(is_planar)).map(|s| [s.about().x, s.about().y]),
            words: (scene.as_ref()).map_or_else(Vec::new, |scene| words(scene, path, unit)),
            onward: (step.kind == Kind::Leaves).then_some([step.onward.x, step.onward.y]),
            path: path.clone(),
        }
    }
}

/// A description of each leg; for a part on an axis, of its motion about or along that axis.
fn words(scene: &Scene, path: &[Coordinates], unit: Option<&str>) -> Vec<String> {
    let Some((_, motion)) = scene.motions() else {
        return legs_in_words(scene, path, unit);
    };
    (path.windows(2))
        .map(|leg| match (leg[0], leg[1]) {
            (Coordinates::Axes { v: from, .. }, Coordinates::Axes { v: to, .. }) => {
                motion_in_words(motion, to - from, unit)
            }
            _ => String::new(),
        })
        .collect()
}

impl Tree {
    fn of(tree: &assembly::Tree, names: &dyn Fn(&[usize]) -> Vec<String>) -> Self {
        let branch = |branch: &assembly::Branch| Branch {
            room: branch.room.clone(),
            step: branch.step,
            tree: (branch.tree.parts.len() > 1).then(|| Self::of(&branch.tree, names)),
        };
        Self {
            parts: names(&tree.parts),
            out: tree.out.iter().map(branch).collect(),
            left: names(&tree.left),
        }
    }
}

impl Enclosed {
    fn of(model: &Mechanism, why: &Enclosure) -> Self {
        let feature = |f: PartFeature| {
            let part = &model.parts[f.part].part;
            format!("{} of {}", part.feature_text(f.feature), part.name())
        };
        Self {
            moving: names(model, &why.moving),
            staying: names(model, &why.staying),
            patches: why.patches,
            touching: (why.features.iter())
                .map(|&(a, b)| [feature(a), feature(b)])
                .collect(),
            features: why.features.clone(),
            doubtful: why.doubtful.clone(),
        }
    }
}
