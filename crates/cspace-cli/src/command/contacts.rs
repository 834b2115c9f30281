//! `cspace contacts`.

use std::fmt::Write;

use cspace::{Coordinates, Location, NearFeatures, PairSpace, QueryError, RegionId};
use serde::Serialize;

use cspace_plan::fits_exactly;

use crate::args::{ContactsArgs, Format};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, FeaturePair, Subject, pair_of, placed, texts};
use crate::wording::length;

/// Default of `--within`, as a share of the smaller part's size.
const NEARBY: f64 = 0.01;

/// The pairs of features that touch or nearly touch at a configuration.
#[derive(Serialize)]
struct Answer {
    at: Coordinates,
    class: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    region: Option<u32>,
    /// The minimum distance of the parts, if they do not overlap.
    #[serde(skip_serializing_if = "Option::is_none")]
    clearance: Option<f64>,
    within: f64,
    contacts: Vec<Contact>,
}

#[derive(Serialize)]
struct Contact {
    /// Features of the fixed and of the moving part.
    features: [String; 2],
    /// The features, not as text.
    #[serde(skip)]
    names: FeaturePair,
    /// How far the features are apart; less than 0 by as much as they overlap.
    distance: f64,
    /// Nearest points, in the fixed part's frame.
    on_fixed: [f64; 2],
    on_moving: [f64; 2],
    /// The outward unit normal of the fixed part.
    normal: [f64; 2],
}

pub(crate) fn run(args: &ContactsArgs) -> Result<(), Failure> {
    args.common.result.check_answer()?;
    let common = &args.common;
    let subject = Subject::open(common)?;
    let pair = subject.one_pair(common, args.window.theta)?;
    let at = pair.coordinates("--at", &args.at)?;
    let size = pair.fixed().size().min(pair.moving().size());
    let within = args.within.unwrap_or(NEARBY * size);
    let space = pair.space()?;
    let answer = answer(&space, at, within).map_err(|e| pair.unanswered("--at", &e))?;
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

fn answer(space: &PairSpace, at: Coordinates, within: f64) -> Result<Answer, QueryError> {
    let (class, region) = match space.locate(at)? {
        Location::Free(region) => ("free", Some(region.0)),
        Location::Contact => ("contact", None),
        Location::Blocked if fits_exactly(space, at)? => ("exact-fit", None),
        Location::Blocked => ("blocked", None),
        Location::Outside => return Err(QueryError::Outside),
    };
    let contact = |near: &NearFeatures| {
        let (p, q, n) = (
            near.touching.on_fixed,
            near.touching.on_moving,
            near.touching.normal,
        );
        Contact {
            features: texts(space, pair_of(near)),
            names: pair_of(near),
            distance: near.distance,
            on_fixed: [p.x, p.y],
            on_moving: [q.x, q.y],
            normal: [n.x, n.y],
        }
    };
    let near = space.near_features(at, within)?;
    let contacts = near.iter().map(contact).collect();
    Ok(Answer {
        at,
        class,
        region,
        clearance: space.clearance(at).ok(),
        within,
        contacts,
    })
}

fn describe(text: &mut String, pair: &Chosen<'_>, answer: &Answer) -> std::fmt::Result {
    let unit = pair.unit();
    let class = match answer.region {
        Some(region) => pair.is_free(RegionId(region)),
        None => answer.class.to_owned(),
    };
    write!(text, "{}: {class}", pair.place(answer.at))?;
    match (answer.region, answer.clearance) {
        (Some(_), Some(clearance)) => writeln!(text, ", {}{unit} apart", length(clearance))?,
        _ => writeln!(text)?,
    }
    if answer.contacts.is_empty() {
        let within = length(answer.within);
        return writeln!(text, "  no contact within {within}{unit}: see --within");
    }
    for c in &answer.contacts {
        let point = |p: [f64; 2]| format!("({}, {})", length(p[0]), length(p[1]));
        writeln!(
            text,
            "  {:>12}{unit}  {} at {}, {} at {}, normal {}",
            length(c.distance),
            placed(pair.fixed(), c.names.0),
            point(c.on_fixed),
            placed(pair.moving(), c.names.1),
            point(c.on_moving),
            point(c.normal)
        )?;
    }
    Ok(())
}
