//! `cspace clearance`.

mod picture;

use std::collections::BTreeMap;
use std::fmt::{self, Write};
use std::path::PathBuf;

use clap::Args;
use cspace::Coordinates;
use cspace_api::clearance::{
    At, Clearance, Clearances, End, Halt, Outcome, Over, Question, Stopped,
};
use cspace_api::{Outcome as _, PairAnswer};
use cspace_model::{Mechanism, shown};

use super::record;
use crate::args::{CacheArgs, ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::PictureArgs;
use crate::subject::motions;
use crate::wording::{count, degrees, length};

const HELP: &str = "\
Examples:
  cspace clearance models/gears_on_shafts.toml
  cspace clearance models/peg_hole.toml --drawn
  cspace clearance models/gears_on_shafts.toml -o tightest.svg
  cspace clearance models/ratchet_mechanism.toml --within 2
  cspace simulate models/geneva.toml --time 2 -o run.csv
  cspace clearance models/geneva.toml --along run.csv --json

Every two parts, the worst first. Two that each turn, slide or stand still by
their `motion` are looked at over all motions that their ranges allow: one that
turns and has no range makes whole turns. Their contact space decides, so that
nothing between two poses is missed. Parts that joints carry and drives move are
looked at over one cycle of the drives: bounds of their motion decide, between
any two times. Others are looked at as drawn.

  overlaps  over a cycle, with the time of the first touch; as drawn,
            with the depth: the length of the shortest translation of
            the second part that separates the two, neither of them turned; and
            by how much smaller it would be clear, where that is less
  touches   over their ranges, with what stops which part where; as drawn, the
            gap or the depth is --touch or less
  meshes    neither can turn without the other: how often one turns for the
            other, and the least and the largest backlash over a turn
  meets     with --along: the boundaries meet between two samples at which the
            parts are apart
  clear     with the gap: the minimum distance, and where it is
  joined    a joint connects the two, so they may overlap: they are not judged
  undecided the contact space is in doubt, or cannot be computed

Features and points are those that are nearest, in the assembly's frame; of an
overlap those that touch after the translation, the point of the second part
where it is before. Every two parts are judged, whichever pairs the model lists;
parts at different heights never touch.

-o OUT draws the tightest places, the worst first, as .svg, .png or .pdf: the
two parts of a pair where they are nearest, or where one is stopped.

With --along the gap is the minimum over the whole motion, with its time:
between two samples all coordinates are taken to change at constant rates, and
the gap is bounded there, not sampled. Depths are those at the samples.

The exit code is 1 if parts overlap, or if one does not come to both ends of the
range that the model gives it. See docs/clearance.md.";

/// Arguments of `cspace clearance`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ClearanceArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Over the motion that `cspace simulate` wrote to this file with -o, CSV or JSON, in place of all that ranges allow
    #[arg(long, value_name = "RECORD", conflicts_with = "drawn")]
    pub(crate) along: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    // Last: what follows would stand below its heading.
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// In the order in which pairs are counted.
const OUTCOMES: [Outcome; 7] = [
    Outcome::Overlaps,
    Outcome::Undecided,
    Outcome::Meets,
    Outcome::Touches,
    Outcome::Meshes,
    Outcome::Clear,
    Outcome::Joined,
];

pub(crate) fn run(args: &ClearanceArgs) -> Result<(), Failure> {
    let output = args.result.artefact(&["svg", "png", "pdf"])?;
    let format = crate::picture::format(output);
    match (format, &args.along) {
        (None, _) => args.picture.refuse()?,
        (Some(_), Some(_)) => {
            return Err(
                Failure::new("-o draws places, and with --along there are times")
                    .help("draw the motion with `cspace simulate -o`, or leave --along out"),
            );
        }
        (Some(_), None) => {}
    }
    output::check(output)?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let model = subject.model("clashes are found between all of its parts")?;
    let along = (args.along.as_ref())
        .map(|file| record::samples(file, &model.model.mechanism))
        .transpose()?;
    let question = Question {
        along,
        ..args.question.clone()
    };
    let answer = question.ask(&subject, &Terminal::new(CacheArgs::default()))?;
    if let Some(format) = format {
        picture::write(args, &model.model.mechanism, &answer.content, format)?;
    }
    super::tell(&args.result, &answer, |text, found| {
        let words = Words {
            model: &model.model.mechanism,
            unit: (subject.unit()).map_or(String::new(), |u| format!(" {}", shown::text(u))),
            is_over_ranges: found
                .pairs
                .iter()
                .any(|p| matches!(p.content.over, Over::Ranges | Over::Cycle)),
        };
        words.describe(text, found)
    })
}

/// The words for pairs of a model.
struct Words<'a> {
    model: &'a Mechanism,
    /// The unit of length with a space before it.
    unit: String,
    /// Whether some pairs are over their ranges.
    is_over_ranges: bool,
}

impl Words<'_> {
    fn describe(&self, text: &mut String, found: &Clearances) -> fmt::Result {
        let unit = &self.unit;
        let counts: Vec<String> = (OUTCOMES.iter())
            .filter_map(|&outcome| {
                let pairs = found.pairs.iter();
                let n = pairs.filter(|p| p.outcome == outcome).count();
                (n > 0).then(|| format!("{n} {}", outcome.word()))
            })
            .collect();
        let pairs = found.pairs.len() + found.beyond + found.different_heights;
        let mut line = format!(
            "{}, {}",
            count(found.parts, "part", "parts"),
            count(pairs, "pair", "pairs")
        );
        if !counts.is_empty() {
            write!(line, ": {}", counts.join(", "))?;
        }
        if let (true, Some(within)) = (found.beyond > 0, found.within) {
            let more = if counts.is_empty() { ": " } else { ", " };
            let within = length(within);
            write!(
                line,
                "{more}{} clear by {within}{unit} or more",
                found.beyond
            )?;
        }
        if found.different_heights > 0 {
            let more = if line.contains(':') { ", " } else { ": " };
            write!(
                line,
                "{more}{} at different heights",
                found.different_heights
            )?;
        }
        writeln!(text, "{line}")?;
        for answer in &found.pairs {
            let [a, b] = [&answer.fixed, &answer.moving].map(|name| shown::text(name));
            let pair = &answer.content;
            let far = match (pair.depth, pair.gap) {
                (Some(l), _) | (None, Some(l)) => format!("{}{unit}", length(l)),
                (None, None) => String::new(),
            };
            write!(text, "{:<8} {far:>14}  {a}, {b}", answer.outcome.word())?;
            match pair.over {
                Over::Ranges => self.over_ranges(text, answer)?,
                Over::Cycle => self.over_cycle(text, pair)?,
                Over::Drawn if self.is_over_ranges && answer.outcome != Outcome::Joined => {
                    write!(text, "  as drawn")?;
                }
                Over::Drawn | Over::Record => {}
            }
            if let Some(At::Time(time)) = pair.at {
                write!(text, "  t {}", length(time))?;
            }
            if let (Some([f, g]), Some([p, q])) = (&pair.touching, pair.points)
                && pair.stopped.is_empty()
            {
                let at = |[x, y]: [f64; 2]| format!("({}, {})", length(x), length(y));
                let (f, g) = (shown::text(f), shown::text(g));
                write!(text, "  {f} at {}, {g} at {}", at(p), at(q))?;
            }
            // What a translation of the same length does need not be said.
            if let (Some(offset), Some(depth)) = (pair.offset, pair.depth)
                && offset < 0.999 * depth
            {
                write!(
                    text,
                    "  clear if {b} is {}{unit} smaller all around",
                    length(offset)
                )?;
            }
            writeln!(text)?;
        }
        Ok(())
    }

    /// Tells what a cycle is, how far the parts go through it, and where drives are at the time that is told.
    fn over_cycle(&self, text: &mut String, pair: &Clearance) -> fmt::Result {
        let Some(cycle) = &pair.cycle else {
            return Ok(());
        };
        let turns: Vec<String> = (cycle.turns.iter())
            .map(|(part, turns)| {
                let part = shown::text(part);
                match turns {
                    1 => format!("one turn of {part}"),
                    more => format!("{more} turns of {part}"),
                }
            })
            .collect();
        let drives = |at: &BTreeMap<String, f64>| -> String {
            let each = at.iter().map(|(part, &value)| {
                let far = match cycle.angles.contains(part) {
                    true => degrees(value),
                    false => format!("{}{}", length(value), self.unit),
                };
                format!("{} {far}", shown::text(part))
            });
            each.collect::<Vec<_>>().join(", ")
        };
        match turns.is_empty() {
            true => {
                let [from, to] = cycle.times.map(length);
                write!(text, "  over t {from} to {to}")?;
            }
            false => write!(text, "  over {}", turns.join(" and "))?,
        }
        if let Some(halt) = &cycle.halt {
            let why = match halt {
                Halt::DeadPoint => "a dead point of the joints".to_owned(),
                Halt::Range(part) => format!("the end of the range of {}", shown::text(part)),
            };
            write!(text, ", which stops at {}: {why}", drives(&cycle.halted))?;
        }
        let verb = match pair.gap {
            Some(gap) if gap > 0.0 => "at",
            _ => "from",
        };
        write!(text, "  {verb} {}", drives(&cycle.drives))
    }

    /// Tells what is found of a pair over its ranges.
    fn over_ranges(&self, text: &mut String, answer: &PairAnswer<Clearance>) -> fmt::Result {
        let pair = &answer.content;
        let names = [&answer.fixed, &answer.moving];
        let [a, b] = names.map(|name| shown::text(name));
        if let Some(ratio) = pair.ratio {
            write!(
                text,
                "  {b} turns {} times as {a} turns once",
                shown::number(ratio)
            )?;
        }
        if let Some(play) = pair.backlash {
            let (least, most) = (degrees(play.least), degrees(play.most));
            write!(text, ", with a backlash of {least} to {most}")?;
        }
        if let Some(room) = pair.room {
            write!(text, "  with a gap of {room:.1e}{} all around", self.unit)?;
        }
        for (i, stop) in pair.stopped.iter().enumerate() {
            text.push_str(if i == 0 { "  " } else { "; " });
            self.stop(text, stop, names)?;
        }
        match pair.at {
            Some(At::Place(at)) if pair.stopped.is_empty() => {
                let names = [names[0].as_str(), names[1].as_str()];
                write!(text, "  at {}", motions(self.model, names, at, &self.unit))
            }
            _ => Ok(()),
        }
    }

    fn stop(&self, text: &mut String, stop: &Stopped, names: [&String; 2]) -> fmt::Result {
        let part = shown::text(&stop.part);
        let shown = |x: f64| match stop.turns {
            true => degrees(x),
            false => format!("{}{}", length(x), self.unit),
        };
        let Coordinates::Axes { u, v } = stop.at else {
            return Ok(());
        };
        let come = if &stop.part == names[0] { u } else { v };
        let verb = match (stop.end, stop.of) {
            (End::Hi, Some(_)) => "cannot pass",
            (End::Lo, Some(_)) => "cannot go back past",
            (End::Hi, None) => "stops at",
            (End::Lo, None) => "going back stops at",
        };
        write!(text, "{part} {verb} {}", shown(come))?;
        if let Some(of) = stop.of {
            write!(text, " of {}", shown(of))?;
        }
        for (i, [f, g]) in stop.touching.iter().enumerate() {
            let (f, g) = (shown::text(f), shown::text(g));
            let [a, b] = names.map(|name| shown::text(name));
            text.push_str(if i == 0 { ": " } else { ", " });
            write!(text, "{g} of {b} touches {f} of {a}")?;
        }
        Ok(())
    }
}
