//! `cspace move`.

use std::fmt::Write;

use cspace::{Coordinates, PairSpace, Vector};
use cspace_design::{Displaced, Motion, Outcome, displace};
use serde::Serialize;

use crate::args::{Format, MoveArgs};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, FeaturePair, Subject, texts};

/// The outcome of a requested displacement.
#[derive(Serialize)]
struct Answer {
    result: &'static str,
    /// The fraction of the displacement that is travelled.
    fraction: f64,
    at: Coordinates,
    /// Features of the fixed and of the moving part.
    touching: Vec<[String; 2]>,
    /// The gap by which the moving part is smaller, where the parts fit exactly at the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    #[serde(skip)]
    outcome: Outcome,
    #[serde(skip)]
    features: Vec<FeaturePair>,
}

pub(crate) fn run(args: &MoveArgs) -> Result<(), Failure> {
    args.common.result.check_answer()?;
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, args.window.theta)?;
    let from = pair.coordinates("--from", &args.from)?;
    let by = pair.coordinates("--by", &args.by)?;
    let about = pair.about(&args.about)?.unwrap_or(Vector::ZERO);
    let motion = Motion::new(from, by).about(about);
    let (space, gap) = pair.space_with_room(&[from])?;
    let done = displace(&space, &motion).map_err(|e| pair.unanswered("--from", &e))?;
    let answer = Answer {
        gap,
        ..Answer::of(&space, done)
    };
    let bytes = match common.result.format() {
        Format::Json => super::json(&answer)?,
        Format::Text => {
            let mut text = String::new();
            describe(&mut text, &pair, &answer).map_err(Failure::work)?;
            text.into_bytes()
        }
    };
    output::write(common.result.output.as_deref(), &bytes)
}

impl Answer {
    fn of(space: &PairSpace, done: Displaced) -> Self {
        Self {
            result: done.outcome.name(),
            fraction: done.fraction,
            at: done.at,
            touching: done.features.iter().map(|&f| texts(space, f)).collect(),
            gap: None,
            outcome: done.outcome,
            features: done.features,
        }
    }
}

fn describe(text: &mut String, pair: &Chosen<'_>, answer: &Answer) -> std::fmt::Result {
    let percent = 100.0 * answer.fraction;
    match answer.outcome {
        Outcome::Free => writeln!(text, "free: nothing touches all the way")?,
        Outcome::Blocked => writeln!(text, "blocked: the parts overlap where it begins")?,
        Outcome::Contact => writeln!(text, "contact after {percent:.6} % of the way")?,
        Outcome::Leaves => writeln!(
            text,
            "leaves the window of orientations or the range of a motion after {percent:.6} % of the way"
        )?,
    }
    if let Some(gap) = answer.gap {
        writeln!(text, "  {}", pair.gap_in_words(gap))?;
    }
    writeln!(text, "  at       {}", pair.place(answer.at))?;
    for &features in &answer.features {
        writeln!(text, "  there    {}", pair.touches(features))?;
    }
    Ok(())
}
