//! `cspace disassemble`.

mod picture;
mod text;

use std::path::Path;
use std::time::Instant;

use crate::legacy::{Answer, Outcome as Word};
use cspace::{Axis, ComputeError, Coordinates, PairError};
use cspace_api::{legs_in_words, motion_in_words};
use cspace_io::shown;
use cspace_mechanism::Mechanism;
use cspace_plan::PlanError;
use cspace_plan::assembly::{
    self, Assembly, AssemblyError, Enclosure, Kind, Outcome, PartFeature, TakenApart, Tried,
};
use cspace_plan::legs::Scene;
use serde::Serialize;

use crate::args::DisassembleArgs;
use crate::ask::{read_model, set_threads};
use crate::failure::Failure;
use crate::interrupt::catch_interrupts;
use crate::output;
use crate::progress::Bar;
use crate::subject::placed;

/// The whole answer.
#[derive(Debug, Serialize)]
struct Told {
    verdict: Outcome,
    gap: f64,
    steps: Vec<Step>,
    tree: Tree,
    #[serde(skip_serializing_if = "Option::is_none")]
    locked: Option<Locked>,
    #[serde(skip_serializing_if = "Option::is_none")]
    tried: Option<Tried>,
    spaces: usize,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Step {
    kind: Kind,
    moving: Vec<String>,
    staying: Vec<String>,
    path: Vec<Coordinates>,
    /// The point that legs move straight and turn the parts about, in the frame in which these are before the step.
    #[serde(skip_serializing_if = "Option::is_none")]
    about: Option<[f64; 2]>,
    words: Vec<String>,
    clearance: Option<f64>,
    /// Further translation of parts that leave, after the path, which clears the space for later steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    onward: Option<[f64; 2]>,
}

/// The order in which a group of parts is taken apart: the branches that come out, and the parts left.
#[derive(Debug, Serialize)]
struct Tree {
    parts: Vec<String>,
    out: Vec<Branch>,
    left: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Branch {
    /// The indices of the steps that make room for it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    room: Vec<usize>,
    /// The index of the step.
    step: usize,
    /// The order in which the removed group is itself taken apart; `None` for a single part.
    #[serde(skip_serializing_if = "Option::is_none")]
    tree: Option<Tree>,
}

#[derive(Debug, Serialize)]
struct Locked {
    parts: Vec<String>,
    why: Vec<Why>,
}

#[derive(Debug, Serialize)]
struct Why {
    moving: Vec<String>,
    staying: Vec<String>,
    patches: usize,
    touching: Vec<[String; 2]>,
    /// As above, with where on the parts the features are.
    #[serde(skip)]
    places: Vec<[String; 2]>,
    doubtful: Vec<(f64, f64)>,
}

pub(crate) fn run(args: &DisassembleArgs) -> Result<(), Failure> {
    let output = args.result.output.as_deref();
    let format = crate::picture::format(output);
    if format.is_none() {
        args.picture.refuse()?;
    }
    args.result.artefact(&["svg", "png", "pdf", "json"])?;
    output::check(output)?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, model) = read_model(&args.file, &args.values, "an assembly is all of its parts")?;
    let begin = Instant::now();
    let failed = |error: AssemblyError| failure(&path, error);
    let assembly = Assembly::new(&model, args.gap).map_err(failed)?;
    let apart = Bar::new(shown::text(&model.name).into_owned())
        .watch(|bar| assembly.take_apart_with(bar))
        .map_err(failed)?;
    let seconds = begin.elapsed().as_secs_f64();
    let told = told(&model, &assembly, &apart, seconds);
    if let Some(format) = format {
        picture::write(args, &model, &apart, format)?;
    }
    let outcome = match told.verdict {
        Outcome::Apart => Word::yes("apart"),
        Outcome::Locked => Word::no("locked"),
        Outcome::Unknown => Word::open("unknown"),
    };
    let unit = model.unit.as_deref();
    let answer = Answer::new("disassemble", unit, outcome, &told);
    super::print(&args.result, &answer, |text| {
        text::describe(text, unit, &told)
    })
}

/// The moving part of a step with the motion that it has.
fn scene(parts: &[cspace::Part], model: &Mechanism, step: &assembly::Step) -> Option<Scene> {
    let &first = step.moving.first()?;
    let part = &parts[first];
    let is_on_axis = matches!(
        step.path.configurations.first(),
        Some(Coordinates::Axes { .. })
    );
    let axes = (model.parts[first].axis.filter(|_| is_on_axis)).map(|axis| (Axis::FIXED, axis));
    Some(Scene::new(part, part, axes).with_about(step.path.about))
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

/// The failure for an error: bad input if the model does not allow the question, otherwise work that could not be done.
fn failure(path: &Path, error: AssemblyError) -> Failure {
    let interrupted = PairError::Compute(ComputeError::Interrupted);
    match error {
        AssemblyError::Pair(e) | AssemblyError::Plan(PlanError::Grown(e)) if e == interrupted => {
            Failure::new("interrupted")
        }
        AssemblyError::Pair(_) | AssemblyError::Query(_) | AssemblyError::Plan(_) => {
            Failure::new(format_args!("{}: {error}", path.display()))
        }
        _ => Failure::new(format_args!("{}: {error}", path.display())),
    }
}

fn told(model: &Mechanism, assembly: &Assembly, apart: &TakenApart, seconds: f64) -> Told {
    let names = |parts: &[usize]| -> Vec<String> {
        (parts.iter())
            .map(|&i| model.parts[i].part.name().to_owned())
            .collect()
    };
    let feature = |f: &PartFeature| {
        let part = &model.parts[f.part].part;
        format!("{} of {}", part.feature_text(f.feature), part.name())
    };
    let why = |why: &Enclosure| Why {
        moving: names(&why.moving),
        staying: names(&why.staying),
        patches: why.patches,
        touching: (why.features.iter())
            .map(|(a, b)| [feature(a), feature(b)])
            .collect(),
        places: (why.features.iter())
            .map(|(a, b)| [a, b].map(|f| placed(&model.parts[f.part].part, f.feature)))
            .collect(),
        doubtful: why.doubtful.clone(),
    };
    let unit = model.unit.as_deref();
    let step = |step: &assembly::Step| {
        let scene = scene(assembly.parts(), model, step);
        let path = &step.path.configurations;
        let is_planar = |s: &&Scene| s.motions().is_none();
        Step {
            kind: step.kind,
            moving: names(&step.moving),
            staying: names(&step.staying),
            clearance: Some(step.path.narrowest.clearance).filter(|c| c.is_finite()),
            about: (scene.as_ref().filter(is_planar)).map(|s| [s.about().x, s.about().y]),
            words: (scene.as_ref()).map_or_else(Vec::new, |scene| words(scene, path, unit)),
            onward: (step.kind == Kind::Leaves).then_some([step.onward.x, step.onward.y]),
            path: path.clone(),
        }
    };
    Told {
        verdict: apart.outcome,
        gap: assembly.gap(),
        steps: apart.steps.iter().map(step).collect(),
        tree: tree(&apart.tree, &names),
        locked: apart.locked.as_ref().map(|locked| Locked {
            parts: names(&locked.parts),
            why: locked.why.iter().map(why).collect(),
        }),
        tried: apart.tried,
        spaces: apart.spaces,
        seconds,
    }
}

fn tree(of: &assembly::Tree, names: &dyn Fn(&[usize]) -> Vec<String>) -> Tree {
    let branch = |branch: &assembly::Branch| Branch {
        room: branch.room.clone(),
        step: branch.step,
        tree: (branch.tree.parts.len() > 1).then(|| tree(&branch.tree, names)),
    };
    Tree {
        parts: names(&of.parts),
        out: of.out.iter().map(branch).collect(),
        left: names(&of.left),
    }
}
