//! `cspace assembly`.

use std::fmt::{self, Write};
use std::path::Path;
use std::time::Instant;

use cspace::{ComputeError, Coordinates, Mechanism, PairError};
use cspace_io::shown;
use cspace_plan::PlanError;
use cspace_plan::assembly::{Assembly, AssemblyError, Enclosure, Outcome, PartFeature, TakenApart};
use serde::Serialize;

use crate::args::{AssemblyArgs, Format};
use crate::failure::Failure;
use crate::interrupt::catch_interrupts;
use crate::output;
use crate::progress::Bar;
use crate::subject::{read_model, set_threads};
use crate::wording::{count, degrees, length};

/// The whole answer.
#[derive(Debug, Serialize)]
struct Told {
    verdict: Outcome,
    gap: f64,
    steps: Vec<Step>,
    #[serde(skip_serializing_if = "Option::is_none")]
    locked: Option<Locked>,
    spaces: usize,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Step {
    moving: Vec<String>,
    staying: Vec<String>,
    path: Vec<Coordinates>,
    clearance: Option<f64>,
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
    doubtful: Vec<(f64, f64)>,
}

pub(crate) fn run(args: &AssemblyArgs) -> Result<(), Failure> {
    args.result.check_answer()?;
    let output = args.result.output.as_deref();
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
    let told = told(&model, assembly.gap(), apart, begin.elapsed().as_secs_f64());
    let answer = match args.result.format() {
        Format::Json => super::json(&told)?,
        Format::Text => {
            let mut text = String::new();
            describe(&mut text, model.unit.as_deref(), &told).map_err(Failure::work)?;
            text.into_bytes()
        }
    };
    output::write(output, &answer)
}

/// What the model cannot be asked is bad input; what could not be computed is not.
fn failure(path: &Path, error: AssemblyError) -> Failure {
    let interrupted = PairError::Compute(ComputeError::Interrupted);
    match error {
        AssemblyError::Pair(e) | AssemblyError::Plan(PlanError::Grown(e)) if e == interrupted => {
            Failure::work("interrupted")
        }
        AssemblyError::Pair(_) | AssemblyError::Query(_) | AssemblyError::Plan(_) => {
            Failure::work(format_args!("{}: {error}", path.display()))
        }
        _ => Failure::input(format_args!("{}: {error}", path.display())),
    }
}

fn told(model: &Mechanism, gap: f64, apart: TakenApart, seconds: f64) -> Told {
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
        doubtful: why.doubtful.clone(),
    };
    Told {
        verdict: apart.outcome,
        gap,
        steps: (apart.steps.into_iter())
            .map(|step| Step {
                moving: names(&step.moving),
                staying: names(&step.staying),
                clearance: Some(step.path.narrowest.clearance).filter(|c| c.is_finite()),
                path: step.path.configurations,
            })
            .collect(),
        locked: apart.locked.map(|locked| Locked {
            parts: names(&locked.parts),
            why: locked.why.iter().map(why).collect(),
        }),
        spaces: apart.spaces,
        seconds,
    }
}

fn describe(text: &mut String, unit: Option<&str>, told: &Told) -> fmt::Result {
    /// More of them tell nothing new.
    const MOST: usize = 12;
    let list = |names: &[String]| shown::text(&names.join(", ")).into_owned();
    let unit = unit.map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let steps = count(told.steps.len(), "step", "steps");
    match told.verdict {
        Outcome::Apart => writeln!(text, "apart: {steps}")?,
        Outcome::Locked => writeln!(
            text,
            "locked: no part or group goes out while the others stay as drawn, after {steps}"
        )?,
        Outcome::Unknown => writeln!(
            text,
            "unknown: no way was found to take all apart, and none is excluded, {steps}"
        )?,
    }
    writeln!(text, "gap {}{unit}", length(told.gap))?;
    for (i, step) in told.steps.iter().enumerate() {
        let (moving, staying) = (list(&step.moving), list(&step.staying));
        let clearance = step.clearance.map(length);
        let clearance = clearance.map_or(String::new(), |c| format!(", clearance {c}{unit}"));
        writeln!(text, "{}. {moving} out of {staying}{clearance}", i + 1)?;
        for at in &step.path {
            if let Coordinates::Planar(c) = at {
                let (x, y, theta) = (length(c.x), length(c.y), degrees(c.theta));
                writeln!(text, "  x {x}, y {y}{unit}, theta {theta}")?;
            }
        }
    }
    if let Some(locked) = &told.locked {
        writeln!(text, "lock each other: {}", list(&locked.parts))?;
        for why in &locked.why {
            writeln!(
                text,
                "  {} cannot leave {}: enclosed by {}",
                list(&why.moving),
                list(&why.staying),
                count(why.patches, "contact patch", "contact patches")
            )?;
            for [a, b] in why.touching.iter().take(MOST) {
                writeln!(text, "    {} and {}", shown::text(a), shown::text(b))?;
            }
            let more = why.touching.len().saturating_sub(MOST);
            if more > 0 {
                writeln!(text, "    {more} more pairs of features")?;
            }
        }
    }
    Ok(())
}
