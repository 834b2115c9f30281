//! `cspace play`.

use core::f64::consts::TAU;
use std::fmt::Write;

use cspace::pair::PairMotion;
use cspace::{
    Axis, AxisMotion, Configuration, Coordinates, Location, NearFeatures, PairSpace, QueryError,
    RegionId, Vector,
};
use cspace_answers::{Answer, Outcome};
use cspace_design::{Motion, Outcome as Reach, displace, reach};
use cspace_model::model::Coordinate;
use cspace_model::shown;
use serde::Serialize;

use crate::args::PlayArgs;
use crate::failure::Failure;
use crate::subject::{Chosen, FeaturePair, Subject, pair_of, placed, texts, touching};
use crate::wording::{EXACT_FIT, degrees, length};

use super::draw::as_drawn;
use super::regions;

/// Default of `--touch`, as a share of the smaller part's size.
const NEARBY: f64 = 0.01;

/// The play of a pair.
#[derive(Serialize)]
struct Play {
    class: String,
    /// The configuration asked about.
    at: Coordinates,
    /// free, contact, blocked, exact-fit, or joined of a pair that never parts.
    #[serde(skip)]
    is: Outcome,
    #[serde(skip_serializing_if = "Option::is_none")]
    region: Option<u32>,
    /// The minimum distance of the parts.
    #[serde(skip_serializing_if = "Option::is_none")]
    clearance: Option<f64>,
    /// The gap by which the moving part is smaller, where the parts fit exactly.
    #[serde(skip_serializing_if = "Option::is_none")]
    gap: Option<f64>,
    directions: Vec<Direction>,
    /// The features that touch, or nearly.
    near: Vec<Near>,
    /// How far apart features are at most that are near, where that is asked for.
    #[serde(skip)]
    within: Option<f64>,
    /// How far a displacement leads.
    #[serde(skip_serializing_if = "Option::is_none")]
    motion: Option<Moved>,
    #[serde(skip)]
    region_is: Option<String>,
}

/// Two features that touch, or nearly.
#[derive(Serialize)]
struct Near {
    /// Features of the fixed and of the moving part.
    features: [String; 2],
    #[serde(skip)]
    names: FeaturePair,
    /// How far the features are apart; less than 0 by as much as they overlap.
    distance: f64,
    /// The nearest point of the fixed part, in its frame.
    at: [f64; 2],
    /// The nearest point of the moving part, in the fixed part's frame.
    on_moving: [f64; 2],
    /// The outward unit normal of the fixed part.
    normal: [f64; 2],
}

/// How far a displacement at constant rates leads.
#[derive(Serialize)]
struct Moved {
    result: &'static str,
    /// The fraction of the displacement that is travelled.
    fraction: f64,
    at: Coordinates,
    /// Features of the fixed and of the moving part.
    touching: Vec<[String; 2]>,
    #[serde(skip)]
    outcome: Reach,
    #[serde(skip)]
    features: Vec<FeaturePair>,
}

const FREE: Outcome = Outcome::yes("free");
const CONTACT: Outcome = Outcome::yes("contact");
const EXACT: Outcome = Outcome::yes("exact-fit");
const JOINED: Outcome = Outcome::yes("joined");
const BLOCKED: Outcome = Outcome::no("blocked");

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
    let common = &args.common;
    common.result.artefact(&[])?;
    let subject = Subject::open(common)?;
    subject.warn();
    let pairs = match (&args.at, &args.by) {
        (None, None) => subject.pairs(common, args.window.window)?,
        _ => vec![subject.one_pair(common, args.window.window)?],
    };
    let answers = (pairs.iter())
        .map(|pair| play(args, pair))
        .collect::<Result<Vec<_>, Failure>>()?;
    let framed = pairs.iter().zip(&answers);
    let framed = framed.map(|(pair, play)| pair.answer(play.is, play));
    let answer = Answer::of_pairs("play", subject.unit(), framed.collect());
    super::print(&common.result, &answer, |text| {
        for (i, (pair, play)) in pairs.iter().zip(&answers).enumerate() {
            if i > 0 {
                text.push('\n');
            }
            describe(text, pair, play)?;
        }
        Ok(())
    })
}

fn play(args: &PlayArgs, pair: &Chosen<'_>) -> Result<Play, Failure> {
    let at = match &args.at {
        Some(at) => pair.coordinates("--at", at)?,
        None => as_drawn(pair),
    };
    let by = match &args.by {
        Some(by) => Some(pair.coordinates("--by", by)?),
        None => None,
    };
    let about = pair.about(&args.about)?;
    let failed = |e: QueryError| pair.unanswered("--at", &e);
    let (space, gap) = pair.space_with_room(&[at])?;
    let mut play = at_configuration(pair, &space, at, about).map_err(failed)?;
    if gap.is_some() {
        play.gap = gap;
        play.is = EXACT;
    }
    if matches!(*space, PairSpace::Lower(_)) {
        return match by {
            Some(_) => Err(pair.unanswered("--by", &QueryError::Permanent)),
            None => Ok(play),
        };
    }
    let size = pair.fixed().size().min(pair.moving().size());
    let within = args.touch.unwrap_or(NEARBY * size);
    play.within = args.touch;
    let drawn = pair.space()?;
    let near = drawn.near_features(at, within).map_err(failed)?;
    play.near = near.iter().map(|near| Near::of(&drawn, near)).collect();
    if let Some(by) = by {
        let motion = Motion::new(at, by).about(about.unwrap_or(Vector::ZERO));
        let done = displace(&space, &motion).map_err(failed)?;
        play.motion = Some(Moved {
            result: done.outcome.name(),
            fraction: done.fraction,
            at: done.at,
            touching: done.features.iter().map(|&f| texts(&space, f)).collect(),
            outcome: done.outcome,
            features: done.features,
        });
    }
    Ok(play)
}

impl Near {
    fn of(space: &PairSpace, near: &NearFeatures) -> Self {
        let (p, q, n) = (
            near.touching.on_fixed,
            near.touching.on_moving,
            near.touching.normal,
        );
        Self {
            features: texts(space, pair_of(near)),
            names: pair_of(near),
            distance: near.distance,
            at: [p.x, p.y],
            on_moving: [q.x, q.y],
            normal: [n.x, n.y],
        }
    }
}

fn at_configuration(
    pair: &Chosen<'_>,
    space: &PairSpace,
    at: Coordinates,
    about: Option<Vector>,
) -> Result<Play, QueryError> {
    let mut play = Play {
        class: space.class().to_string(),
        at,
        is: JOINED,
        region: None,
        clearance: None,
        gap: None,
        directions: Vec::new(),
        near: Vec::new(),
        within: None,
        motion: None,
        region_is: None,
    };
    if matches!(space, PairSpace::Lower(_)) {
        return Ok(play);
    }
    play.is = match space.locate(at)? {
        Location::Free(region) => {
            play.region = Some(region.0);
            play.region_is = Some(region_in_words(pair, space, region.0));
            FREE
        }
        Location::Contact => CONTACT,
        Location::Blocked => BLOCKED,
        Location::Outside => return Err(QueryError::Outside),
    };
    play.clearance = space.clearance(at).ok();
    if play.is != BLOCKED {
        play.directions = match (space, at) {
            (PairSpace::FixedAxes(axes), Coordinates::Axes { .. }) => {
                on_axes(space, axes.axes(), at)?
            }
            (_, Coordinates::Planar(c)) => in_the_plane(space, c, about)?,
            _ => Vec::new(),
        };
    }
    Ok(play)
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

fn describe(text: &mut String, pair: &Chosen<'_>, play: &Play) -> std::fmt::Result {
    let unit = pair.unit();
    let name = |part: &cspace::Part| shown::text(part.name()).into_owned();
    let (fixed, moving) = (name(pair.fixed()), name(pair.moving()));
    writeln!(text, "{moving} relative to {fixed}")?;
    if play.is == JOINED {
        return writeln!(text, "  joined: their play is that of the joint");
    }
    let apart = match play.clearance {
        Some(clearance) if play.is == FREE => format!(", {}{unit} apart", length(clearance)),
        _ => String::new(),
    };
    let is = match play.is {
        BLOCKED => "blocked: the parts overlap",
        EXACT => EXACT_FIT,
        is => is.word,
    };
    writeln!(
        text,
        "  at                       {}: {is}{apart}",
        pair.place(play.at)
    )?;
    if let Some(gap) = play.gap {
        writeln!(text, "  {}", pair.gap_in_words(gap))?;
    }
    if let (Some(region), Some(words)) = (play.region, &play.region_is) {
        writeln!(text, "  {:24} {words}", pair.region(RegionId(region)))?;
    }
    for d in &play.directions {
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
    describe_near(text, pair, play)?;
    (play.motion.as_ref()).map_or(Ok(()), |motion| describe_motion(text, pair, motion))
}

fn describe_near(text: &mut String, pair: &Chosen<'_>, play: &Play) -> std::fmt::Result {
    /// More are for programs.
    const MOST: usize = 12;
    let unit = pair.unit();
    if let (true, Some(within)) = (play.near.is_empty(), play.within) {
        let within = length(within);
        return writeln!(text, "  {:24} nothing within {within}{unit}", "near");
    }
    for near in play.near.iter().take(MOST) {
        let [x, y] = near.at.map(length);
        writeln!(
            text,
            "  {:24} {}{unit} apart at ({x}, {y}): {} and {}",
            "near",
            length(near.distance),
            placed(pair.fixed(), near.names.0),
            placed(pair.moving(), near.names.1),
        )?;
    }
    match play.near.len().saturating_sub(MOST) {
        0 => Ok(()),
        more => writeln!(text, "  {:24} {more} more; --json has all", ""),
    }
}

fn describe_motion(text: &mut String, pair: &Chosen<'_>, motion: &Moved) -> std::fmt::Result {
    let percent = 100.0 * motion.fraction;
    let led = match motion.outcome {
        Reach::Free => "free: nothing touches all the way".to_owned(),
        Reach::Blocked => "blocked: the parts overlap where it begins".to_owned(),
        Reach::Contact => format!("contact after {percent:.6} % of the way"),
        Reach::Leaves => format!(
            "leaves the window of orientations or the range of a motion after {percent:.6} % of the way"
        ),
    };
    writeln!(text, "  {:24} {led}", "displaced")?;
    writeln!(text, "  {:24} at {}", "", pair.place(motion.at))?;
    for &features in &motion.features {
        writeln!(text, "  {:24} {}", "", pair.touches(features))?;
    }
    Ok(())
}
