//! `cspace clearance`.

use std::fmt::{self, Write};
use std::time::Instant;

use crate::legacy::{Answer, Outcome, PairAnswer};
use cspace::{Part, Point};
use cspace_io::shown;
use cspace_mechanism::Mechanism;
use cspace_plan::clash::{Assembly, Clash, Clashes, Question, State};
use serde::Serialize;

use super::record;
use crate::args::ClearanceArgs;
use crate::ask::{read_model, set_threads};
use crate::failure::Failure;
use crate::interrupt::catch_interrupts;
use crate::wording::{count, length};
use cspace_api::subject::named_pair;

/// Number of parts up to which all pairs are listed: so many parts make some 20,000 pairs.
const MANY: usize = 200;
/// Default of `--within` for more parts, as a share of the largest part's size.
const NEARBY: f64 = 0.1;

/// Pairs, and numbers of all of them.
#[derive(Debug, Serialize)]
struct Told {
    parts: usize,
    /// The worst first.
    pairs: Vec<PairAnswer<Row>>,
    /// Pairs that are clear of each other by `within` or more.
    beyond: usize,
    within: Option<f64>,
    /// The first and the last time of the record.
    #[serde(skip_serializing_if = "Option::is_none")]
    along: Option<[f64; 2]>,
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Row {
    /// The motions over which it is.
    over: &'static str,
    #[serde(skip)]
    state: State,
    gap: Option<f64>,
    depth: Option<f64>,
    offset: Option<f64>,
    points: Option<[[f64; 2]; 2]>,
    /// The features of the two parts that touch, or are nearest.
    touching: Option<[String; 2]>,
    /// The time in the record.
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<f64>,
}

pub(crate) fn run(args: &ClearanceArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    catch_interrupts();
    set_threads(args.threads)?;
    let (path, model) = read_model(
        &args.file,
        &args.values,
        "clashes are found between all of its parts",
    )?;
    let pair = (args.pair.as_ref())
        .map(|names| {
            named_pair(
                &path,
                &model,
                names,
                &crate::ask::Terminal::new(crate::args::CacheArgs::default()),
            )
        })
        .transpose()?;
    let samples = (args.along.as_ref())
        .map(|file| record::samples(file, &model))
        .transpose()?;
    if samples.is_none() {
        super::tell_starts(&model);
    }
    let begin = Instant::now();
    let assembly = Assembly::new(&model);
    let within = args.within.unwrap_or_else(|| default_within(&model));
    let question = Question {
        within,
        touch: args.touch,
        pair: pair.map(|p| [p.fixed, p.moving]),
    };
    let found = match &samples {
        Some(samples) => assembly.along(samples, &question),
        None => assembly.drawn(&question),
    };
    let along = samples.and_then(|s| Some([s.first()?.time, s.last()?.time]));
    let told = told(&model, found, (within, along), begin);
    let outcome = Outcome::worst(told.pairs.iter().map(|p| p.outcome));
    let unit = model.unit.as_deref();
    let answer = Answer::new("clearance", unit, outcome, &told);
    super::print(&args.result, &answer, |text| describe(text, unit, &told))
}

fn default_within(model: &Mechanism) -> f64 {
    if model.parts.len() <= MANY {
        return f64::INFINITY;
    }
    let sizes = model.parts.iter().map(|p| p.part.size());
    NEARBY * sizes.fold(0.0, f64::max)
}

fn told(
    model: &Mechanism,
    found: Clashes,
    (within, along): (f64, Option<[f64; 2]>),
    begin: Instant,
) -> Told {
    let part = |i: usize| -> &Part { &model.parts[i].part };
    let over = if along.is_some() { "record" } else { "drawn" };
    let row = |clash: Clash| {
        let [a, b] = clash.parts.map(part);
        PairAnswer {
            fixed: a.name().to_owned(),
            moving: b.name().to_owned(),
            outcome: outcome(clash.state),
            content: Row {
                over,
                state: clash.state,
                gap: clash.gap,
                depth: clash.depth,
                offset: clash.offset,
                points: clash.points.map(|p| p.map(|Point { x, y }| [x, y])),
                touching: (clash.features).map(|[f, g]| [a.feature_text(f), b.feature_text(g)]),
                at: clash.time,
            },
        }
    };
    Told {
        parts: model.parts.len(),
        pairs: found.pairs.into_iter().map(row).collect(),
        beyond: found.beyond,
        within: Some(within).filter(|w| w.is_finite()),
        along,
        seconds: begin.elapsed().as_secs_f64(),
    }
}

/// How it is between two parts. Joined parts that go through each other are a note.
const fn outcome(state: State) -> Outcome {
    match state {
        State::Overlap => Outcome::no("overlaps"),
        State::Meets => Outcome::yes("meets"),
        State::Touching => Outcome::yes("touches"),
        State::Clear => Outcome::yes("clear"),
        State::Joined => Outcome::yes("joined"),
    }
}

fn describe(text: &mut String, unit: Option<&str>, told: &Told) -> fmt::Result {
    const STATES: [State; 5] = [
        State::Overlap,
        State::Meets,
        State::Touching,
        State::Clear,
        State::Joined,
    ];
    let unit = unit.map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let counts: Vec<String> = (STATES.iter())
        .filter_map(|&state| {
            let n = told
                .pairs
                .iter()
                .filter(|p| p.content.state == state)
                .count();
            (n > 0).then(|| format!("{n} {}", outcome(state).word))
        })
        .collect();
    let pairs = told.pairs.len() + told.beyond;
    let mut line = format!(
        "{}, {}",
        count(told.parts, "part", "parts"),
        count(pairs, "pair", "pairs")
    );
    if !counts.is_empty() {
        write!(line, ": {}", counts.join(", "))?;
    }
    if let (true, Some(within)) = (told.beyond > 0, told.within) {
        let more = if counts.is_empty() { ": " } else { ", " };
        let within = length(within);
        write!(
            line,
            "{more}{} clear by {within}{unit} or more",
            told.beyond
        )?;
    }
    writeln!(text, "{line}")?;
    for answer in &told.pairs {
        let [a, b] = [&answer.fixed, &answer.moving].map(|name| shown::text(name));
        let pair = &answer.content;
        let far = match (pair.depth, pair.gap) {
            (Some(l), _) | (None, Some(l)) => format!("{}{unit}", length(l)),
            (None, None) => String::new(),
        };
        write!(text, "{:<8} {far:>14}  {a}, {b}", answer.outcome.word)?;
        if let Some(time) = pair.at {
            write!(text, "  t {}", length(time))?;
        }
        if let (Some([f, g]), Some([p, q])) = (&pair.touching, pair.points) {
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
