//! `cspace play`.

use core::f64::consts::TAU;
use std::fmt::Write;

use cspace::pair::PairMotion;
use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Location, PairSpace, QueryError, RegionId, Vector,
};
use cspace_design::{Motion, reach};
use cspace_io::model::Coordinate;
use serde::Serialize;

use crate::args::{Format, PlayArgs};
use crate::failure::Failure;
use crate::output;
use crate::subject::{Chosen, FeaturePair, Subject, texts, touching};
use crate::wording::{EXACT_FIT, degrees, length};

use super::regions;

/// The play of a pair.
#[derive(Serialize)]
struct Answer {
    fixed: String,
    moving: String,
    class: String,
    /// The configuration asked about.
    at: Coordinates,
    /// free, contact, blocked, exact-fit, or joined of a pair that never parts.
    result: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    region: Option<u32>,
    /// The minimum distance of the parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    clearance: Option<f64>,
    /// The gap by which the moving part is smaller, where the parts fit exactly.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    directions: Vec<Direction>,
    #[serde(skip)]
    region_is: Option<String>,
}

/// How far the parts go in one direction.
#[derive(Serialize)]
struct Direction {
    direction: String,
    /// In the model's unit of length, or radians; none where nothing stops it.
    distance: Option<f64>,
    stopped_by: Stop,
    /// Features of the fixed and of the moving part that stop it.
    touching: Vec<[String; 2]>,
    #[serde(skip)]
    is_turn: bool,
    #[serde(skip)]
    features: Vec<FeaturePair>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Stop {
    Contact,
    /// The end of a motion's range, or of the window of orientations.
    Limit,
    Nothing,
}

pub(crate) fn run(args: &PlayArgs) -> Result<(), Failure> {
    args.common.result.check_answer()?;
    let common = &args.common;
    let subject = Subject::open(common)?;
    subject.warn();
    let pairs = match &args.at {
        Some(_) => vec![subject.one_pair(common, args.window.theta)?],
        None => subject.pairs(common, args.window.theta)?,
    };
    let mut answers = Vec::new();
    let mut text = String::new();
    for pair in &pairs {
        let at = match &args.at {
            Some(at) => pair.coordinates("--at", at)?,
            None if pair.is_on_axes() => Coordinates::Axes { u: 0.0, v: 0.0 },
            None => Coordinates::Planar(Configuration::default()),
        };
        let (space, gap) = pair.space_with_room(&[at])?;
        let mut answer = answer(pair, &space, at, pair.about(&args.about)?)
            .map_err(|e| pair.unanswered("--at", &e))?;
        if gap.is_some() {
            answer.gap = gap;
            answer.result = "exact-fit";
        }
        if !answers.is_empty() {
            text.push('\n');
        }
        describe(&mut text, pair, &answer).map_err(Failure::work)?;
        answers.push(answer);
    }
    let bytes = match common.result.format() {
        Format::Json => super::json(&answers)?,
        Format::Text => text.into_bytes(),
    };
    output::write(common.result.output.as_deref(), &bytes)
}

fn answer(
    pair: &Chosen<'_>,
    space: &PairSpace,
    at: Coordinates,
    about: Option<Vector>,
) -> Result<Answer, QueryError> {
    let mut answer = Answer {
        fixed: pair.fixed().name().to_owned(),
        moving: pair.moving().name().to_owned(),
        class: space.class().to_string(),
        at,
        result: "joined",
        region: None,
        clearance: None,
        gap: None,
        directions: Vec::new(),
        region_is: None,
    };
    if matches!(space, PairSpace::Lower(_)) {
        return Ok(answer);
    }
    answer.result = match space.locate(at)? {
        Location::Free(region) => {
            answer.region = Some(region.0);
            answer.region_is = Some(region_in_words(pair, space, region.0));
            "free"
        }
        Location::Contact => "contact",
        Location::Blocked => "blocked",
        Location::Outside => return Err(QueryError::Outside),
    };
    answer.clearance = space.clearance(at).ok();
    if answer.result != "blocked" {
        answer.directions = match (space, at) {
            (PairSpace::FixedAxes(axes), Coordinates::Axes { .. }) => {
                on_axes(space, axes.axes(), at)?
            }
            (_, Coordinates::Planar(c)) => in_the_plane(space, c, about)?,
            _ => Vec::new(),
        };
    }
    Ok(answer)
}

fn region_in_words(pair: &Chosen<'_>, space: &PairSpace, region: u32) -> String {
    match space {
        PairSpace::Planar(space) => regions::planar(space, region),
        PairSpace::FixedAxes(space) => {
            regions::on_axes(space, &space.regions()[region as usize], &pair.unit())
        }
        PairSpace::Lower(_) => String::new(),
    }
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

fn describe(text: &mut String, pair: &Chosen<'_>, answer: &Answer) -> std::fmt::Result {
    let unit = pair.unit();
    writeln!(text, "{} relative to {}", answer.moving, answer.fixed)?;
    if answer.result == "joined" {
        return writeln!(text, "  joined: their play is that of the joint");
    }
    let apart = match answer.clearance {
        Some(clearance) if answer.result == "free" => {
            format!(", {}{unit} apart", length(clearance))
        }
        _ => String::new(),
    };
    let is = match answer.result {
        "blocked" => "blocked: the parts overlap",
        "exact-fit" => EXACT_FIT,
        result => result,
    };
    writeln!(
        text,
        "  at                       {}: {is}{apart}",
        pair.place(answer.at)
    )?;
    if let Some(gap) = answer.gap {
        writeln!(text, "  {}", pair.gap_in_words(gap))?;
    }
    if let (Some(region), Some(words)) = (answer.region, &answer.region_is) {
        writeln!(text, "  {:24} {words}", pair.region(RegionId(region)))?;
    }
    for d in &answer.directions {
        let far = match d.distance {
            None if d.is_turn => "turns for ever".to_owned(),
            None => "no limit".to_owned(),
            Some(angle) if d.is_turn => degrees(angle),
            Some(distance) => format!("{}{unit}", length(distance)),
        };
        let to = match d.stopped_by {
            Stop::Nothing => String::new(),
            Stop::Limit => ", its limit".to_owned(),
            Stop::Contact => {
                /// More are counted.
                const MOST: usize = 2;
                let shown = d.features.iter().take(MOST).map(|&f| pair.touches(f));
                let touches = shown.collect::<Vec<_>>().join(" and ");
                match d.features.len().saturating_sub(MOST) {
                    0 => format!(", to where {touches}"),
                    more => format!(", to where {touches} (and {more} more)"),
                }
            }
        };
        writeln!(text, "  {:24} {far}{to}", d.direction)?;
    }
    Ok(())
}
