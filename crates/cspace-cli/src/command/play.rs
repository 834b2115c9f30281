//! `cspace play`.

use std::fmt::Write;

use clap::Args;
use cspace::{PairSpace, RegionId};
use cspace_api::play::{Moved, Outcome, Play, Question, Stop};
use cspace_api::{Chosen, Outcome as _};
use cspace_design::Outcome as Reach;
use cspace_model::shown;

use super::regions;
use crate::args::Common;
use crate::ask;
use crate::failure::Failure;
use crate::subject::{InWords, placed};
use crate::wording::{EXACT_FIT, degrees, length};

const HELP: &str = "\
Examples:
  cspace play latch.toml
  cspace play models/peg_hole.toml --at=0,-10,0
  cspace play models/peg_hole.toml --at 0,60,0 --by 0,-80,0
  cspace play models/cam_tappet.toml --at 30deg,0 --touch 2
  cspace play models/gears_on_shafts.toml --at 5deg,-7deg --json

Of every pair, or of that of --pair: how far the moving part goes along x and y
of the fixed part's frame, and how far it turns about its own origin and about
the middle of its box, until something touches, and what; on fixed axes, how
far each part goes on its axis while the other is held, to a contact or to its
limit. From contact a direction that is blocked has distance 0. The answer
begins with the place of the configuration: free and in which region, in
contact, or blocked, which is exit code 1.

near: the features that face each other and are no farther apart than --touch
(less than 0 where they overlap, by as much), where, and in JSON the outward
normal of the fixed part there, in its frame.

--by D moves by that displacement at constant rates: free (nothing touches all
the way), contact (with the share of the displacement and what touches), blocked
or leaves (the window of orientations, or the range of a part's motion). Angles
run on and are not taken modulo a turn.";

/// Arguments of `cspace play`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct PlayArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
}

pub(crate) fn run(args: &PlayArgs) -> Result<(), Failure> {
    let common = &args.common;
    common.result.artefact(&[])?;
    let (subject, host) = ask::open(common)?;
    subject.warn(&host);
    let pairs = args.question.pairs(&subject, &host)?;
    let answer = args.question.ask(&pairs)?;
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
    // Of parts that fit exactly it is a region of the smaller part's space.
    let region = play.region.filter(|_| play.gap.is_none());
    if let (Some(region), Ok(space)) = (region, pair.space()) {
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
