//! `cspace plan --energy`.

use std::fmt::{self, Write};
use std::time::Instant;

use crate::legacy::{Answer, Outcome, PairAnswer};
use cspace::{ComputeError, Coordinates, Vector};
use cspace_api::Given;
use cspace_plan::PlanError;
use cspace_plan::escape::{Escape, Escaped, Field, FieldError};
use serde::Serialize;

use crate::args::PlanArgs;
use crate::failure::Failure;
use crate::progress::Bar;
use crate::subject::InWords;
use crate::wording::{count, length};
use cspace_api::Chosen;
use cspace_design::FeaturePair;

use super::{goal, start};

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Name {
    Escapes,
    Cage,
    FromBlocked,
    ToBlocked,
}

/// The whole answer.
#[derive(Debug, Serialize)]
struct Told {
    verdict: Name,
    /// The gap by which the moving part is smaller, where the parts fit exactly.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    energy: Option<f64>,
    least: Option<f64>,
    most: Option<f64>,
    passes: Vec<Pass>,
    path: Vec<Coordinates>,
    #[serde(skip_serializing_if = "Option::is_none")]
    enclosed: Option<Enclosed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    blocked: Option<Overlap>,
    /// Whether energies are those of a mass of 1 kg, because the model has none.
    unit_mass: bool,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Pass {
    at: Coordinates,
    energy: f64,
    touching: Vec<[String; 2]>,
    #[serde(skip)]
    features: Vec<FeaturePair>,
}

#[derive(Debug, Serialize)]
struct Enclosed {
    region: cspace::RegionId,
    patches: usize,
    touching: Vec<[String; 2]>,
}

#[derive(Debug, Serialize)]
struct Overlap {
    depth: Option<f64>,
    nearest: Option<Coordinates>,
    touching: Option<[String; 2]>,
}

pub(super) fn run(args: &PlanArgs, pair: &Chosen<'_>) -> Result<(), Failure> {
    let told = escaped(args, pair)?;
    let outcome = match told.verdict {
        Name::Escapes => Outcome::yes("escapes"),
        Name::Cage => Outcome::no("cage"),
        Name::FromBlocked => Outcome::no("from-blocked"),
        Name::ToBlocked => Outcome::no("to-blocked"),
    };
    let answers = vec![PairAnswer::of(pair, outcome, &told)];
    let answer = Answer::of_pairs("plan", pair.unit_label(), answers);
    super::super::print(&args.common.result, &answer, |text| {
        describe(text, pair, &told)
    })
}

/// The force field that acts on the moving part, and whether that part has a mass.
fn field(args: &PlanArgs, pair: &Chosen<'_>) -> Result<(Field, bool), Failure> {
    let given = args.energy.gravity.map(|[x, y]| Vector::new(x, y));
    let Some((model, entry)) = pair.in_model() else {
        return Err(
            Failure::new("a saved contact space says nothing of masses and forces")
                .help("give the model file"),
        );
    };
    let gravity = given.unwrap_or(model.dynamics.gravity);
    let (field, weighs) = Field::of_pair(model, entry, gravity).map_err(|error| {
        let help = match error {
            FieldError::Still { .. } => "name the pair in the other order: --pair FIXED,MOVING",
            _ => "take it out of the model, or choose another pair",
        };
        Failure::new(error).help(help)
    })?;
    Ok((field, weighs || gravity == Vector::ZERO))
}

fn escaped(args: &PlanArgs, pair: &Chosen<'_>) -> Result<Told, Failure> {
    let from = start(args, pair)?;
    let to = goal(args)
        .map(|to| pair.coordinates("to", &Given::Text(to.to_string())))
        .transpose()?;
    let (field, weighs) = field(args, pair)?;
    let failed = |error: PlanError| -> Failure {
        match &error {
            PlanError::From(e) | PlanError::Pair(e) => pair.unanswered("--from", e).into(),
            PlanError::To(e) => pair.unanswered("--to", e).into(),
            PlanError::NoGoal => Failure::new(&error).help("give --to U,V"),
            PlanError::NoForce => Failure::new(&error)
                .help("give --gravity X,Y, or gravity, loads or springs in the model"),
            PlanError::TooFar { .. } => Failure::new(&error).help("choose one nearer to the parts"),
            PlanError::Stopped(ComputeError::Interrupted) => Failure::new("interrupted"),
            _ => Failure::new(error),
        }
    };
    // Wrong arguments are reported before anything is computed.
    if field.is_none() {
        return Err(failed(PlanError::NoForce));
    }
    let ends: Vec<Coordinates> = [from].into_iter().chain(to).collect();
    let (space, gap) = pair.space_with_room(&ends)?;
    let begin = Instant::now();
    let mut escape = Escape::new(&space, &field).map_err(failed)?;
    if let Some(within) = args.energy.accuracy {
        escape = escape.with_bounds_within(within);
    }
    let answer = Bar::new(pair.names())
        .watch(|bar| escape.from_with(from, to, bar))
        .map_err(failed)?;
    let seconds = begin.elapsed().as_secs_f64();
    let mut told = told(pair, answer, !weighs, seconds);
    told.gap = gap;
    Ok(told)
}

fn told(pair: &Chosen<'_>, answer: Escaped, unit_mass: bool, seconds: f64) -> Told {
    let texts = |&(fixed, moving): &FeaturePair| {
        [
            pair.fixed().feature_text(fixed),
            pair.moving().feature_text(moving),
        ]
    };
    let mut told = Told {
        verdict: Name::Escapes,
        gap: None,
        energy: None,
        least: None,
        most: None,
        passes: Vec::new(),
        path: Vec::new(),
        enclosed: None,
        blocked: None,
        unit_mass,
        seconds,
    };
    told.verdict = match &answer {
        Escaped::Held(_) => Name::Escapes,
        Escaped::Caged(_) => Name::Cage,
        Escaped::FromBlocked(_) => Name::FromBlocked,
        Escaped::ToBlocked(_) => Name::ToBlocked,
    };
    match answer {
        Escaped::Held(held) => {
            told.energy = held.energy;
            told.least = Some(held.least);
            told.most = Some(held.most).filter(|m| m.is_finite());
            told.path = held.path;
            told.passes = (held.passes.into_iter())
                .map(|pass| Pass {
                    at: pass.at,
                    energy: pass.energy,
                    touching: pass.touching.iter().map(texts).collect(),
                    features: pass.touching,
                })
                .collect();
        }
        Escaped::Caged(enclosed) => {
            told.enclosed = Some(Enclosed {
                region: enclosed.region,
                patches: enclosed.patches,
                touching: enclosed.features.iter().map(texts).collect(),
            });
        }
        Escaped::FromBlocked(blocked) | Escaped::ToBlocked(blocked) => {
            told.blocked = Some(Overlap {
                depth: Some(blocked.depth).filter(|d| d.is_finite()),
                nearest: blocked.nearest,
                touching: blocked.features.as_ref().map(texts),
            });
        }
    }
    told
}

fn describe(text: &mut String, pair: &Chosen<'_>, told: &Told) -> fmt::Result {
    let unit = pair.unit_label().unwrap_or("unit");
    if let Some(gap) = told.gap {
        writeln!(text, "{}", pair.gap_in_words(gap))?;
    }
    let energy = |e: f64| format!("{} kg {unit}^2/s^2", length(e));
    match told.verdict {
        Name::Cage => {
            writeln!(text, "cage: no energy lets it out")?;
        }
        Name::FromBlocked => writeln!(text, "from-blocked: the parts overlap at the start")?,
        Name::ToBlocked => writeln!(text, "to-blocked: the parts overlap at the goal")?,
        Name::Escapes => match told.energy {
            Some(e) if e > 0.0 => writeln!(text, "escapes with {}", energy(e))?,
            Some(_) => writeln!(text, "escapes without energy: it can go downhill")?,
            None => writeln!(text, "escapes")?,
        },
    }
    if let Some(least) = told.least {
        let most = told.most.map_or_else(|| "not known".to_owned(), energy);
        writeln!(
            text,
            "no way with less than {}; the path: {most}",
            energy(least)
        )?;
    }
    for pass in &told.passes {
        writeln!(
            text,
            "pass at {}: {}",
            pair.place(pass.at),
            energy(pass.energy)
        )?;
        for &features in &pass.features {
            writeln!(text, "  {}", pair.touches(features))?;
        }
    }
    if !told.path.is_empty() {
        let legs = told.path.len().saturating_sub(1);
        writeln!(text, "path: {}", count(legs, "leg", "legs"))?;
        for &at in &told.path {
            writeln!(text, "  {}", pair.place(at))?;
        }
    }
    if let Some(enclosed) = &told.enclosed {
        let patches = count(enclosed.patches, "contact patch", "contact patches");
        let region = pair.region(enclosed.region);
        writeln!(text, "{region} is enclosed by {patches}")?;
    }
    if let Some(Overlap {
        nearest: Some(at),
        depth: Some(depth),
        ..
    }) = &told.blocked
    {
        let unit = pair.unit();
        writeln!(
            text,
            "free     {}, {}{unit} away",
            pair.place(*at),
            length(*depth)
        )?;
    }
    if told.unit_mass {
        writeln!(
            text,
            "the model has no mass of {}: energies are for 1 kg",
            pair.moving().name()
        )?;
    }
    Ok(())
}
