//! `cspace move`.

use std::fmt::Write;

use cspace::pair::PairMotion;
use cspace::{Configuration, Coordinates, Location, MotionError, PairSpace, QueryError};
use serde::Serialize;

use crate::args::{Format, MoveArgs};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, FeaturePair, Subject, texts, touching};

/// What becomes of a motion.
#[derive(Serialize)]
struct Answer {
    result: Outcome,
    /// How much of the displacement is done.
    fraction: f64,
    at: Coordinates,
    /// Features of the fixed and of the moving part.
    touching: Vec<[String; 2]>,
    #[serde(skip)]
    features: Vec<FeaturePair>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Outcome {
    Free,
    Contact,
    Blocked,
    Leaves,
}

pub(crate) fn run(args: &MoveArgs) -> Result<(), Failure> {
    args.common.result.check_answer()?;
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, args.window.theta)?;
    let from = pair.coordinates("--from", &args.from)?;
    let by = pair.coordinates("--by", &args.by)?;
    let space = pair.space()?;
    let answer = answer(&space, from, by).map_err(|e| pair.unanswered("--from", &e))?;
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

fn answer(space: &PairSpace, from: Coordinates, by: Coordinates) -> Result<Answer, QueryError> {
    if space.locate(from)? == Location::Outside {
        return Err(QueryError::Outside);
    }
    // The displacement is the rate, and the motion lasts for 1.
    let (result, fraction, features) = match space.first_contact(from, by, 1.0) {
        Err(QueryError::Motion(MotionError::StartsBlocked)) => (Outcome::Blocked, 0.0, Vec::new()),
        Err(error) => return Err(error),
        Ok(PairMotion::Free) => (Outcome::Free, 1.0, Vec::new()),
        Ok(PairMotion::Leaves { time }) => (Outcome::Leaves, time, Vec::new()),
        Ok(PairMotion::Contact(contact)) => {
            let features = touching(space, (from, by), &contact)?;
            (Outcome::Contact, contact.time, features)
        }
    };
    Ok(Answer {
        result,
        fraction,
        at: moved(from, by, fraction),
        touching: features.iter().map(|&f| texts(space, f)).collect(),
        features,
    })
}

/// The configuration a share of a displacement on.
fn moved(from: Coordinates, by: Coordinates, share: f64) -> Coordinates {
    match (from, by) {
        (Coordinates::Planar(c), Coordinates::Planar(d)) => {
            Coordinates::Planar(Configuration::new(
                c.x + share * d.x,
                c.y + share * d.y,
                c.theta + share * d.theta,
            ))
        }
        (Coordinates::Axes { u, v }, Coordinates::Axes { u: du, v: dv }) => Coordinates::Axes {
            u: u + share * du,
            v: v + share * dv,
        },
        (from, _) => from,
    }
}

fn describe(text: &mut String, pair: &Chosen<'_>, answer: &Answer) -> std::fmt::Result {
    let percent = 100.0 * answer.fraction;
    match answer.result {
        Outcome::Free => writeln!(text, "free: nothing touches all the way")?,
        Outcome::Blocked => writeln!(text, "blocked: the parts overlap where it begins")?,
        Outcome::Contact => writeln!(text, "contact after {percent:.6} % of the way")?,
        Outcome::Leaves => writeln!(
            text,
            "leaves the window of orientations or the range of a motion after {percent:.6} % of the way"
        )?,
    }
    writeln!(text, "  at       {}", pair.place(answer.at))?;
    for &features in &answer.features {
        writeln!(text, "  there    {}", pair.touch(features))?;
    }
    Ok(())
}
