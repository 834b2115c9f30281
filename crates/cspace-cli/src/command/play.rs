//! `cspace play`.

use std::fmt::Write;

use cspace::{PairSpace, RegionId};
use cspace_api::play::{Moved, Outcome, Play, Question, Stop};
use cspace_api::{Chosen, Outcome as _};
use cspace_design::Outcome as Reach;
use cspace_model::shown;

use super::regions;
use crate::args::PlayArgs;
use crate::ask;
use crate::failure::Failure;
use crate::subject::{InWords, placed};
use crate::wording::{EXACT_FIT, degrees, length};

pub(crate) fn run(args: &PlayArgs) -> Result<(), Failure> {
    let common = &args.common;
    common.result.artefact(&[])?;
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    let question = Question {
        which: ask::which(common, args.window.window),
        at: args.at.clone(),
        by: args.by.clone(),
        about: args.about.about,
        touch: args.touch,
    };
    let pairs = question.pairs(&subject, &host)?;
    let answer = question.ask(&pairs)?;
    super::tell(&common.result, &answer, |text, found| {
        for (i, (pair, answer)) in pairs.iter().zip(&found.pairs).enumerate() {
            if i > 0 {
                text.push('\n');
            }
            describe(text, pair, &answer.content)?;
        }
        Ok(())
    })
}

fn region_in_words(pair: &Chosen<'_>, space: &PairSpace, region: RegionId) -> String {
    match space {
        PairSpace::Planar(space) => regions::planar(space, region),
        PairSpace::FixedAxes(space) => {
            regions::on_axes(space, &space.regions()[region.index()], &pair.unit())
        }
        PairSpace::Lower(_) => String::new(),
    }
}

fn describe(text: &mut String, pair: &Chosen<'_>, play: &Play) -> std::fmt::Result {
    let unit = pair.unit();
    let name = |part: &cspace::Part| shown::text(part.name()).into_owned();
    let (fixed, moving) = (name(pair.fixed()), name(pair.moving()));
    writeln!(text, "{moving} relative to {fixed}")?;
    if play.is == Outcome::Joined {
        return writeln!(text, "  joined: their play is that of the joint");
    }
    let apart = match play.clearance {
        Some(clearance) if play.is == Outcome::Free => {
            format!(", {}{unit} apart", length(clearance))
        }
        _ => String::new(),
    };
    let is = match play.is {
        Outcome::Blocked => "blocked: the parts overlap",
        Outcome::ExactFit => EXACT_FIT,
        is => is.word(),
    };
    writeln!(
        text,
        "  at                       {}: {is}{apart}",
        pair.place(play.at)
    )?;
    if let Some(gap) = play.gap {
        writeln!(text, "  {}", pair.gap_in_words(gap))?;
    }
    if let (Some(region), Ok(space)) = (play.region, pair.space()) {
        let words = region_in_words(pair, &space, region);
        writeln!(text, "  {:24} {words}", pair.region(region))?;
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
