//! `cspace plan`.

mod energy;
mod hint;
pub(crate) mod picture;

use std::fmt::{self, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use cspace::Coordinates;
use cspace_api::plan::{Contact, Judge, Outcome, Plan, Question};
use cspace_api::{Answer, Chosen, Pairs, Rest, escape};
use cspace_model::shown;

use crate::args::{Common, Format};
use crate::ask;
use crate::command::rows;
use crate::failure::{Failure, note};
use crate::input;
use crate::output;
use crate::picture::{PictureArgs, format};
use crate::subject::InWords;
use crate::wording::{about_point, angle, count, length};

const HELP: &str = "\
Examples:
  cspace plan models/peg_hole.toml --from 40,30,90deg --to 0,2,0
  cspace plan models/peg_hole.toml --from 40,30,0 --to 0,2,0 --widest
  cspace plan models/ball_in_c.toml --from 0,0,0 --to 60,0,0 --proof proof.json
  cspace plan models/peg_hole.toml --from 40,30,0 --to 0,2,0 -o path.csv
  cspace plan models/peg_hole.toml --verify path.csv --json
  cspace plan models/peg_hole.toml --from 0,-10,0 --energy --gravity=0,-9810

The answer is a path of motions of constant rates, each of them checked, or
no-path: start and goal are in different free regions, with what encloses the
smaller; or from-blocked, to-blocked: the parts overlap there, and the nearest
free configuration. The answer is certain: a path is found if there is one.
`unknown` is the answer only at doubtful orientations, which are listed, and
where rounding hides a path. The path has at least half the clearance that is
possible; --widest and --clearance ask for more. Angles run on, not modulo a
turn.

--proof FILE writes the proof of no-path, that start and goal are in different
regions, which the program cspace-check verifies from the file alone; or
`unproved` says why there is none: there is a path, but with less than
--clearance, or the pair is on fixed axes.

-o OUT writes the path as .csv, whose rows are joined straight, the answer as
.json, or a picture of the path as .svg, .png or .pdf. --verify judges a path by
the two outlines alone, without their contact space; blocked: it meets a
contact.

With --energy the answer is the least energy with which the moving part gets
from --from to --to, or out, while the fixed part stays: over the lowest pass,
where contacts balance gravity, loads and springs of the model; `cage` if no
energy is enough. The bounds are certain: no path needs less than `least`, and
the path printed needs no more than `most`. `energy` is that of the one pass
between them, to rounding; it is null where there are several or the bounds stay
far apart. Energies are counted from that at --from. Without a mass in the model
the part weighs as 1 kg.";

/// Arguments of `cspace plan`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) question: Question,
    /// Judge the path in this file instead: configurations in rows, with the columns x,y,theta or u,v
    #[arg(long, value_name = "PATH.csv", conflicts_with_all = ["from", "to", "widest", "clearance", "prefer", "turn", "travel", "depth"])]
    pub(crate) verify: Option<PathBuf>,
    /// Write the proof that there is no path to this file, which `cspace-check` verifies
    #[arg(long, value_name = "FILE", conflicts_with_all = ["verify", "energy"])]
    pub(crate) proof: Option<PathBuf>,
    /// Bound the least energy with which the moving part gets out, or comes to --to, against gravity, loads and springs
    #[arg(long, conflicts_with_all = ["widest", "clearance", "prefer", "turn", "travel", "depth", "verify", "about"])]
    pub(crate) energy: bool,
    #[command(flatten)]
    pub(crate) escape: escape::Question,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// The largest path that is judged: as much as of rows that are classified.
const MOST_BYTES: u64 = 1 << 30;

pub(crate) fn run(args: &PlanArgs) -> Result<(), Failure> {
    let common = &args.common;
    let output = (common.result).artefact(&["csv", "json", "svg", "png", "pdf"])?;
    if format(output).is_none() {
        args.picture.refuse()?;
    }
    check_proof(args, output)?;
    let (subject, host) = ask::open(common)?;
    if args.energy {
        return energy::run(args, &subject, &host);
    }
    let question = Question {
        proof: args.proof.is_some(),
        ..args.question.clone()
    };
    let pairs = [subject.one_pair(&question.which, &host)?];
    let answer = match &args.verify {
        Some(path) => judged(args, &pairs, path)?,
        None => question.ask(&pairs)?,
    };
    for (pair, found) in pairs.iter().zip(&answer.content.pairs) {
        write_files(args, &question, pair, &found.content)?;
    }
    super::tell(&common.result, &answer, |text, found| {
        for (pair, answer) in pairs.iter().zip(&found.pairs) {
            describe(text, pair, &answer.content)?;
        }
        Ok(())
    })
}

/// Refuses a file for the proof that cannot be written, or is for something else.
fn check_proof(args: &PlanArgs, output: Option<&Path>) -> Result<(), Failure> {
    output::check(args.proof.as_deref())?;
    if args.proof.as_deref() == Some(Path::new(output::STANDARD)) {
        return Err(
            Failure::new("--proof -: the answer goes to standard output")
                .help("give the name of a file after --proof"),
        );
    }
    if let Some(proof) = args.proof.as_deref().filter(|proof| Some(*proof) == output) {
        let same = format_args!("--proof {}: -o names the same file", proof.display());
        let help = "give another path after --proof; nothing was written";
        return Err(Failure::new(same).help(help));
    }
    Ok(())
}

/// Writes the picture, the table and the proof that are asked for.
fn write_files(
    args: &PlanArgs,
    question: &Question,
    pair: &Chosen<'_>,
    plan: &Plan,
) -> Result<(), Failure> {
    let output = args.common.result.output.as_deref();
    if let Some(format) = format(output) {
        picture::write(args, question, pair, plan, format)?;
    } else if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        match as_csv(pair, plan)? {
            Some(rows) => output::write(Some(path), &rows)?,
            None => note(format_args!(
                "{}: not written, there is no path",
                path.display()
            )),
        }
    }
    match (&args.proof, &plan.proof) {
        (Some(path), Some(proof)) => output::write(Some(path), &super::json(proof)?)?,
        (Some(path), None) if plan.unproved.is_none() => note(format_args!(
            "{}: not written, there is no proof",
            path.display()
        )),
        _ => {}
    }
    Ok(())
}

/// The verdict on the path in a file.
fn judged(
    args: &PlanArgs,
    pairs: &[Chosen<'_>],
    path: &Path,
) -> Result<Answer<Pairs<Plan>>, Failure> {
    let mut judge = Judge {
        path: Vec::new(),
        source: path.display().to_string(),
        about: args.question.about,
    };
    for pair in pairs {
        pair.check_window()?;
        let help = "give a file as `cspace plan -o PATH.csv` writes it";
        let bytes = input::bytes(path, MOST_BYTES, help)?;
        let rows = rows::read((&judge.source, &bytes), pair, Format::Text, &[])?;
        judge.path = rows.configurations;
    }
    if judge.path.is_empty() {
        return Err(
            Failure::new(format_args!("{}: there is no configuration", judge.source))
                .help("give one configuration in each row, below the names of the columns"),
        );
    }
    Ok(judge.ask(pairs)?)
}

/// Rows of a path, in full precision, which are as free as the path where coordinates change straight from row to row; none without a path.
fn as_csv(pair: &Chosen<'_>, plan: &Plan) -> Result<Option<Vec<u8>>, Failure> {
    let Some(scene) = &plan.scene else {
        return Ok(None);
    };
    let rows = cspace_plan::straight(scene, &plan.path).map_err(Failure::new)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    match pair.is_on_axes() {
        true => writer.write_record(["u", "v"]),
        false => writer.write_record(["x", "y", "theta"]),
    }
    .map_err(Failure::new)?;
    for at in rows {
        match at {
            Coordinates::Planar(c) => writer.serialize([c.x, c.y, c.theta]),
            Coordinates::Axes { u, v } => writer.serialize([u, v]),
        }
        .map_err(Failure::new)?;
    }
    writer.into_inner().map(Some).map_err(Failure::new)
}

fn describe(text: &mut String, pair: &Chosen<'_>, plan: &Plan) -> fmt::Result {
    let unit = pair.unit();
    if let Some(hit) = &plan.contact {
        return met(text, pair, hit);
    }
    if let Some(gap) = plan.gap {
        writeln!(text, "{}", pair.gap_in_words(gap))?;
    }
    match plan.verdict {
        Outcome::Path => {
            let legs = plan.path.len().saturating_sub(1);
            let is_out = if plan.is_out && legs == 0 {
                ", it is out"
            } else {
                ""
            };
            writeln!(text, "path: {}{is_out}", count(legs, "leg", "legs"))?;
            for (i, &at) in plan.path.iter().enumerate() {
                writeln!(text, "  {}", pair.place(at))?;
                if let Some(words) = plan.words.get(i) {
                    writeln!(text, "    {words}")?;
                }
            }
            if let Some(point) = about_point(&plan.path, plan.about, &unit) {
                let name = shown::text(pair.moving().name());
                writeln!(text, "legs are about the point {point} of {name}")?;
            }
        }
        Outcome::NoPath if plan.bottleneck.is_some() => {
            writeln!(text, "no-path: no way has the clearance that is asked for")?;
        }
        Outcome::NoPath => writeln!(text, "no-path")?,
        Outcome::FromBlocked => writeln!(text, "from-blocked: the parts overlap at the start")?,
        Outcome::ToBlocked => writeln!(text, "to-blocked: the parts overlap at the goal")?,
        Outcome::Blocked => writeln!(text, "blocked: the given path meets a contact")?,
        Outcome::Unknown if plan.bottleneck.as_ref().is_some_and(|b| b.most.is_none()) => writeln!(
            text,
            "unknown: no way with that clearance was found, and none is excluded off the contact"
        )?,
        Outcome::Unknown if plan.doubtful.is_empty() => writeln!(
            text,
            "unknown: no such way was found, and none is excluded: rounding hides it"
        )?,
        Outcome::Unknown => writeln!(
            text,
            "unknown: no way was found, and none is excluded, at doubtful orientations"
        )?,
    }
    if let (Some(clearance), Some(place)) = (plan.clearance, &plan.narrowest) {
        let rest = (plan.rest).map_or(String::new(), |rest| off_contact(&rest, &unit));
        writeln!(text, "clearance {}{unit}{rest}", length(clearance))?;
        writeln!(text, "  at       {}", pair.place(place.at))?;
        if let Some(features) = place.features {
            writeln!(text, "  there    {}", pair.beside(features))?;
        }
    }
    if let Some(b) = &plan.bottleneck {
        write!(text, "bottleneck {}{unit}: ", length(b.clearance))?;
        match b.most {
            Some(_) if plan.gap.is_some() => writeln!(
                text,
                "the parts fit exactly, and no way has more than the gap"
            )?,
            Some(most) => writeln!(
                text,
                "no way has more than {}{unit}, so much may {} grow all round",
                length(most),
                shown::text(pair.moving().name()),
            )?,
            None => writeln!(
                text,
                "the most that was found off the contact; another leg off it may leave more"
            )?,
        }
        writeln!(text, "  at       {}", pair.place(b.place.at))?;
        if let Some(features) = b.place.features {
            writeln!(text, "  there    {}", pair.beside(features))?;
        }
    }
    if let Some(enclosed) = &plan.enclosed {
        /// Maximum number of pairs of features that are listed.
        const MOST: usize = 12;
        let region = pair.region(enclosed.region);
        let patches = count(enclosed.patches, "contact patch", "contact patches");
        if plan.is_out {
            writeln!(text, "the start is in {region}, enclosed by {patches}:")?;
        } else {
            writeln!(
                text,
                "start and goal are in different regions; {region} is enclosed by {patches}:"
            )?;
        }
        for &features in enclosed.features.iter().take(MOST) {
            writeln!(text, "  {}", pair.touches(features))?;
        }
        let more = enclosed.features.len().saturating_sub(MOST);
        if more > 0 {
            let pairs = count(more, "more pair of features", "more pairs of features");
            writeln!(text, "  {pairs}")?;
        }
    }
    if let Some(proof) = &plan.proof {
        let triangles = count(proof.triangles.len(), "triangle", "triangles");
        let depth = length(proof.depth);
        writeln!(text, "proof: {triangles} at a depth of {depth}{unit}")?;
    }
    if let Some(why) = &plan.unproved {
        writeln!(text, "no proof: {why}")?;
    }
    if let Some(blocked) = &plan.blocked {
        if let Some(features) = blocked.features {
            writeln!(text, "  overlap  {}", pair.beside(features))?;
        }
        if let (Some(depth), Some(at)) = (blocked.depth, blocked.nearest) {
            writeln!(
                text,
                "  free     {}, {}{unit} away",
                pair.place(at),
                length(depth)
            )?;
        }
    }
    for &(lo, hi) in &plan.doubtful {
        writeln!(text, "  doubtful {} to {}", angle(lo), angle(hi))?;
    }
    hint::write(text, pair, plan)
}

/// A given path that meets a contact.
fn met(text: &mut String, pair: &Chosen<'_>, hit: &Contact) -> fmt::Result {
    writeln!(
        text,
        "blocked: the given path meets a contact on leg {}, after {:.6} % of it",
        hit.leg + 1,
        100.0 * hit.fraction
    )?;
    writeln!(text, "  at       {}", pair.place(hit.place.at))?;
    if let Some(features) = hit.place.features {
        writeln!(text, "  there    {}", pair.touches(features))?;
    }
    Ok(())
}

/// The clearance of a path off the contacts that it starts or ends in, as it follows the clearance of all of it.
fn off_contact(rest: &Rest, unit: &str) -> String {
    let (begins, place) = match (rest.from_contact, rest.to_contact) {
        (true, true) => ("starts and ends", "between"),
        (true, false) => ("starts", "after leaving it"),
        (false, _) => ("ends", "before coming to it"),
    };
    let clearance =
        (rest.clearance).map_or(String::new(), |c| format!("; {}{unit} {place}", length(c)));
    format!(": the path {begins} in contact{clearance}")
}
