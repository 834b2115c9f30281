//! `cspace plan`.

mod energy;
mod hint;
pub(crate) mod picture;
mod proof;

use std::fmt::{self, Write};
use std::path::Path;
use std::time::Instant;

use cspace::{Coordinates, Vector};
use cspace_io::shown;
use cspace_plan::legs::Scene;
use cspace_plan::{Checked, Clearance, PlanError, Planner, Wishes, check, touching_distance};

use crate::args::{Format, PlanArgs};
use crate::ask;
use crate::command::draw::as_drawn;
use crate::command::rows;
use crate::failure::{Failure, note};
use crate::input;
use crate::output;
use crate::picture::format;
use crate::progress::Bar;
use crate::subject::InWords;
use crate::wording::{about_point, angle, count, length};
use cspace_api::Given;
use cspace_api::{Chosen, Subject};

use crate::legacy::{Answer, Outcome, PairAnswer};
use cspace_api::Rest;
use cspace_api::plan::{Contact, Name, Parts, Told};

/// Reason for a missing proof: there is a path, but it is too narrow.
const NARROW: &str = "there is a way, with less clearance than is asked for; what is proved is that there is no way at all";

/// The largest path that is judged: as much as of rows that are classified.
const MOST_BYTES: u64 = 1 << 30;

pub(crate) fn run(args: &PlanArgs) -> Result<(), Failure> {
    let common = &args.common;
    let output = (common.result).artefact(&["csv", "json", "svg", "png", "pdf"])?;
    let picture = format(output);
    if picture.is_none() {
        args.picture.refuse()?;
    }
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
    let (subject, host) = ask::open(common)?;
    let pair = subject.one_pair(&ask::which(common, args.window.window), &host)?;
    if args.energy.energy {
        if picture.is_some() || output.is_some_and(|path| output::ends_in(path, "csv")) {
            return Err(
                Failure::new("-o: with --energy there is no picture and no table")
                    .help("let the name end in .json"),
            );
        }
        return energy::run(args, &pair);
    }
    let (told, scene) = match &args.verify {
        Some(path) => checked(args, &pair, path)?,
        None => planned(args, &pair)?,
    };
    if let Some(format) = picture {
        picture::write(args, &pair, &told, format)?;
    } else if let Some(path) = output.filter(|path| output::ends_in(path, "csv")) {
        if told.path.is_empty() {
            note(format_args!(
                "{}: not written, there is no path",
                path.display()
            ));
        } else {
            output::write(Some(path), &as_csv(&pair, &told, &scene)?)?;
        }
    }
    match (&args.proof, &told.proof) {
        (Some(path), Some(proof)) => output::write(Some(path), &super::json(proof)?)?,
        (Some(path), None) if told.unproved.is_none() => note(format_args!(
            "{}: not written, there is no proof",
            path.display()
        )),
        _ => {}
    }
    let outcome = match told.verdict {
        Name::Path => Outcome::yes("path"),
        Name::NoPath => Outcome::no("no-path"),
        Name::Blocked => Outcome::no("blocked"),
        Name::FromBlocked => Outcome::no("from-blocked"),
        Name::ToBlocked => Outcome::no("to-blocked"),
        Name::Unknown => Outcome::open("unknown"),
    };
    let answers = vec![PairAnswer::of(&pair, outcome, &told)];
    let answer = Answer::of_pairs("plan", pair.unit_label(), answers);
    super::print(&common.result, &answer, |text| describe(text, &pair, &told))
}

/// The goal that is given; none if it is any that is out.
fn goal(args: &PlanArgs) -> Option<&str> {
    args.to.as_deref().filter(|to| *to != "out")
}

/// The start: the parts as drawn unless one is given.
fn start(args: &PlanArgs, pair: &Chosen<'_>) -> Result<Coordinates, Failure> {
    match &args.from {
        Some(from) => Ok(pair.coordinates("from", &Given::Text(from.to_string()))?),
        None => Ok(as_drawn(pair)),
    }
}

fn planned(args: &PlanArgs, pair: &Chosen<'_>) -> Result<(Told, Scene), Failure> {
    let from = start(args, pair)?;
    let to = match goal(args) {
        Some(to) => Some(pair.coordinates("to", &Given::Text(to.to_string()))?),
        None => None,
    };
    let clearance = match args.clearance {
        Some(least) => Clearance::AtLeast(least),
        None if args.widest => Clearance::Widest,
        None => Clearance::Half,
    };
    let (turn, travel) = (
        args.turn.unwrap_or(f64::INFINITY),
        args.travel.unwrap_or(f64::INFINITY),
    );
    let (u_turns, v_turns) = pair.turns();
    let limit = |turns: bool| if turns { turn } else { travel };
    let steps = if pair.is_on_axes() {
        [limit(u_turns), limit(v_turns), f64::INFINITY]
    } else {
        [travel, travel, turn]
    };
    let ends: Vec<Coordinates> = [from].into_iter().chain(to).collect();
    let (space, gap) = pair.space_with_room(&ends)?;
    let failed = |error: PlanError| match &error {
        PlanError::From(e) => pair.unanswered("--from", e).into(),
        PlanError::To(e) => pair.unanswered("--to", e).into(),
        PlanError::Pair(e) => pair.unanswered("--from", e).into(),
        PlanError::Grown(e) => pair.failure(e).into(),
        PlanError::NoGoal => Failure::new("--to is missing: on fixed axes no configuration is out")
            .help("give the configuration to come to: --to=U,V"),
        PlanError::TooFar { .. } => Failure::new(&error).help("choose one nearer to the parts"),
        PlanError::TooManyLegs(_) => {
            Failure::new(format_args!("--turn, --travel: {error}")).help("give larger ones")
        }
        _ => Failure::new(error),
    };
    let begin = Instant::now();
    let planner = match pair.about(args.about.about)? {
        Some(about) => Planner::with_about(&space, about),
        None => Planner::new(&space),
    }
    .map_err(failed)?;
    let wishes = Wishes {
        clearance,
        steps,
        prefer: args.prefer.into(),
    };
    let goal = to;
    let (to, answer) = Bar::new(pair.names())
        .watch(|bar| match to {
            Some(to) => Ok((to, planner.plan_with(from, to, &wishes, bar)?)),
            None => planner.plan_out(from, &wishes, bar),
        })
        .map_err(failed)?;
    let mut told = Told::planned(
        &space,
        (planner.scene(), pair.unit_label()),
        goal,
        answer,
        begin.elapsed().as_secs_f64(),
    );
    told.gap = gap;
    if told.verdict == Name::NoPath && (args.depth.is_some() || args.proof.is_some()) {
        if told.enclosed.is_some() {
            proof::add(&mut told, pair, &space, [from, to], args.depth)?;
        } else {
            told.unproved = Some(NARROW.to_owned());
        }
    }
    let about = told.about.map_or(Vector::ZERO, |[x, y]| Vector::new(x, y));
    let scene = planner.scene().clone().with_about(about);
    Ok((told, scene))
}

fn checked(args: &PlanArgs, pair: &Chosen<'_>, path: &Path) -> Result<(Told, Scene), Failure> {
    pair.check_window()?;
    let source = path.display().to_string();
    let help = "give a file as `cspace plan -o PATH.csv` writes it";
    let bytes = input::bytes(path, MOST_BYTES, help)?;
    let rows = rows::read((&source, &bytes), pair, Format::Text, &[])?;
    if rows.configurations.is_empty() {
        return Err(
            Failure::new(format_args!("{source}: there is no configuration"))
                .help("give one configuration in each row, below the names of the columns"),
        );
    }
    let axes = if pair.is_on_axes() { pair.axes() } else { None };
    let mut scene = Scene::new(pair.fixed(), pair.moving(), axes);
    if let Some(window) = pair.window() {
        scene = scene.with_window(window);
    }
    if let Some(about) = pair.about(args.about.about)? {
        scene = scene.with_about(about);
    }
    let begin = Instant::now();
    let judged = |scene: &Scene| {
        check(scene, &rows.configurations).map_err(|error| -> Failure {
            match &error {
                PlanError::Pair(e) => pair.unanswered(&source, e).into(),
                _ => Failure::new(format_args!("{source}: {error}"))
                    .help("let the path stay nearer to the parts"),
            }
        })
    };
    let mut found = judged(&scene)?;
    // A path from an exact fit was found with a gap, and is judged with it.
    let mut gap = None;
    let ends = [rows.configurations.first(), rows.configurations.last()];
    let touches = |at: &Coordinates| {
        let numbers = scene.numbers(*at).ok();
        numbers.is_some_and(|n| scene.touches(n, touching_distance(pair.fixed(), pair.moving())))
    };
    if !matches!(found, Checked::Free(_))
        && ends.into_iter().flatten().any(touches)
        && let Some((smaller, by)) = cspace_plan::with_gap(pair.fixed(), pair.moving())
    {
        let mut narrower = Scene::new(pair.fixed(), &smaller, axes).with_about(scene.about());
        if let Some(window) = pair.window() {
            narrower = narrower.with_window(window);
        }
        (found, gap) = (judged(&narrower)?, Some(by));
        scene = narrower;
    }
    let parts = Parts {
        fixed: pair.fixed(),
        moving: pair.moving(),
    };
    let seconds = begin.elapsed().as_secs_f64();
    let mut told = Told::checked(
        parts,
        (&scene, pair.unit_label()),
        rows.configurations,
        &found,
        seconds,
    );
    told.gap = gap;
    Ok((told, scene))
}

/// Rows of a path, in full precision, which are as free as the path where coordinates change straight from row to row.
fn as_csv(pair: &Chosen<'_>, told: &Told, scene: &Scene) -> Result<Vec<u8>, Failure> {
    let rows = cspace_plan::straight(scene, &told.path).map_err(Failure::new)?;
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
    writer.into_inner().map_err(Failure::new)
}

fn describe(text: &mut String, pair: &Chosen<'_>, told: &Told) -> fmt::Result {
    let unit = pair.unit();
    if let Some(hit) = &told.contact {
        return met(text, pair, hit);
    }
    if let Some(gap) = told.gap {
        writeln!(text, "{}", pair.gap_in_words(gap))?;
    }
    match told.verdict {
        Name::Path => {
            let legs = told.path.len().saturating_sub(1);
            let is_out = if told.is_out && legs == 0 {
                ", it is out"
            } else {
                ""
            };
            writeln!(text, "path: {}{is_out}", count(legs, "leg", "legs"))?;
            for (i, &at) in told.path.iter().enumerate() {
                writeln!(text, "  {}", pair.place(at))?;
                if let Some(words) = told.words.get(i) {
                    writeln!(text, "    {words}")?;
                }
            }
            if let Some(point) = about_point(&told.path, told.about, &unit) {
                let name = shown::text(pair.moving().name());
                writeln!(text, "legs are about the point {point} of {name}")?;
            }
        }
        Name::NoPath if told.bottleneck.is_some() => {
            writeln!(text, "no-path: no way has the clearance that is asked for")?;
        }
        Name::NoPath => writeln!(text, "no-path")?,
        Name::FromBlocked => writeln!(text, "from-blocked: the parts overlap at the start")?,
        Name::ToBlocked => writeln!(text, "to-blocked: the parts overlap at the goal")?,
        Name::Blocked => writeln!(text, "blocked: the given path meets a contact")?,
        Name::Unknown if told.bottleneck.as_ref().is_some_and(|b| b.most.is_none()) => writeln!(
            text,
            "unknown: no way with that clearance was found, and none is excluded off the contact"
        )?,
        Name::Unknown if told.doubtful.is_empty() => writeln!(
            text,
            "unknown: no such way was found, and none is excluded: rounding hides it"
        )?,
        Name::Unknown => writeln!(
            text,
            "unknown: no way was found, and none is excluded, at doubtful orientations"
        )?,
    }
    if let (Some(clearance), Some(place)) = (told.clearance, &told.narrowest) {
        let rest = (told.rest).map_or(String::new(), |rest| off_contact(&rest, &unit));
        writeln!(text, "clearance {}{unit}{rest}", length(clearance))?;
        writeln!(text, "  at       {}", pair.place(place.at))?;
        if let Some(features) = place.features {
            writeln!(text, "  there    {}", pair.beside(features))?;
        }
    }
    if let Some(b) = &told.bottleneck {
        write!(text, "bottleneck {}{unit}: ", length(b.clearance))?;
        match b.most {
            Some(_) if told.gap.is_some() => writeln!(
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
    if let Some(enclosed) = &told.enclosed {
        /// Maximum number of pairs of features that are listed.
        const MOST: usize = 12;
        let region = pair.region(enclosed.region);
        let patches = count(enclosed.patches, "contact patch", "contact patches");
        if told.is_out {
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
    if let Some(proof) = &told.proof {
        let triangles = count(proof.triangles.len(), "triangle", "triangles");
        let depth = length(proof.depth);
        writeln!(text, "proof: {triangles} at a depth of {depth}{unit}")?;
    }
    if let Some(why) = &told.unproved {
        writeln!(text, "no proof: {why}")?;
    }
    if let Some(blocked) = &told.blocked {
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
    for &(lo, hi) in &told.doubtful {
        writeln!(text, "  doubtful {} to {}", angle(lo), angle(hi))?;
    }
    hint::write(text, pair, told)
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
