//! `cspace clearance`.

use std::fmt::{self, Write};

use cspace_api::Outcome as _;
use cspace_api::clearance::{Clearances, Outcome, Question};
use cspace_model::shown;

use super::record;
use crate::args::{CacheArgs, ClearanceArgs};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::wording::{count, length};

/// In the order in which pairs are counted.
const OUTCOMES: [Outcome; 5] = [
    Outcome::Overlaps,
    Outcome::Meets,
    Outcome::Touches,
    Outcome::Clear,
    Outcome::Joined,
];

pub(crate) fn run(args: &ClearanceArgs) -> Result<(), Failure> {
    args.result.artefact(&[])?;
    let subject = ask::read(&args.file, &args.values, args.threads)?;
    let model = subject.model("clashes are found between all of its parts")?;
    let along = (args.along.as_ref())
        .map(|file| record::samples(file, &model.model.mechanism))
        .transpose()?;
    let question = Question {
        pair: args.pair.clone(),
        within: args.within,
        touch: args.touch,
        along,
    };
    let answer = question.ask(&subject, &Terminal::new(CacheArgs::default()))?;
    super::tell(&args.result, &answer, |text, found| {
        describe(text, subject.unit(), found)
    })
}

fn describe(text: &mut String, unit: Option<&str>, found: &Clearances) -> fmt::Result {
    let unit = unit.map_or(String::new(), |u| format!(" {}", shown::text(u)));
    let counts: Vec<String> = (OUTCOMES.iter())
        .filter_map(|&outcome| {
            let pairs = found.pairs.iter();
            let n = pairs.filter(|p| p.outcome == outcome).count();
            (n > 0).then(|| format!("{n} {}", outcome.word()))
        })
        .collect();
    let pairs = found.pairs.len() + found.beyond;
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
    writeln!(text, "{line}")?;
    for answer in &found.pairs {
        let [a, b] = [&answer.fixed, &answer.moving].map(|name| shown::text(name));
        let pair = &answer.content;
        let far = match (pair.depth, pair.gap) {
            (Some(l), _) | (None, Some(l)) => format!("{}{unit}", length(l)),
            (None, None) => String::new(),
        };
        write!(text, "{:<8} {far:>14}  {a}, {b}", answer.outcome.word())?;
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
