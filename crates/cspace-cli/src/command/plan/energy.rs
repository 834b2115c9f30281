//! `cspace plan --energy`.

use std::fmt::{self, Write};

use cspace_api::escape::{Escape, Outcome, Question};
use cspace_api::plan::Overlap;
use cspace_api::{Chosen, Subject};
use cspace_model::{Quantity, shown};

use super::PlanArgs;
use crate::ask::Terminal;
use crate::failure::Failure;
use crate::output;
use crate::picture::format;
use crate::subject::InWords;
use crate::wording::{count, decimals, digits_beside, length};

pub(super) fn run(args: &PlanArgs, subject: &Subject, host: &Terminal) -> Result<(), Failure> {
    let question = Question {
        which: args.question.which.clone(),
        from: args.question.from.clone(),
        to: args.question.to.clone(),
        ..args.escape.clone()
    };
    let pairs = [subject.one_pair(&question.which, host)?];
    let output = args.common.result.output.as_deref();
    if format(output).is_some() || output.is_some_and(|path| output::ends_in(path, "csv")) {
        return Err(
            Failure::new("-o: with --energy there is no picture and no table")
                .help("let the name end in .json"),
        );
    }
    let answer = question.ask(&pairs)?;
    super::super::tell(&args.common.result, &answer, |text, found| {
        for (pair, answer) in pairs.iter().zip(&found.pairs) {
            describe(text, pair, &answer.content)?;
        }
        Ok(())
    })
}

fn describe(text: &mut String, pair: &Chosen<'_>, escape: &Escape) -> fmt::Result {
    let bounds = [escape.energy, escape.least, escape.most];
    let energies = bounds
        .into_iter()
        .flatten()
        .chain(escape.passes.iter().map(|p| p.energy));
    let largest = energies.fold(0.0_f64, |m, e| m.max(e.abs()));
    let unit = Quantity::Energy.shown(pair.unit_label(), largest);
    if let Some(gap) = escape.gap {
        writeln!(text, "{}", pair.gap_in_words(gap))?;
    }
    let digits = digits_beside(largest * unit.factor);
    let name = shown::text(&unit.name);
    let energy = |e: f64| format!("{} {name}", decimals(unit.factor * e, digits));
    match escape.verdict {
        Outcome::Cage => {
            writeln!(text, "cage: no energy lets it out")?;
        }
        Outcome::FromBlocked => writeln!(text, "from-blocked: the parts overlap at the start")?,
        Outcome::ToBlocked => writeln!(text, "to-blocked: the parts overlap at the goal")?,
        Outcome::Escapes => match escape.energy {
            Some(e) if e > 0.0 => writeln!(text, "escapes with {}", energy(e))?,
            Some(_) => writeln!(text, "escapes without energy: it can go downhill")?,
            None => writeln!(text, "escapes")?,
        },
    }
    if let Some(least) = escape.least {
        let most = escape.most.map_or_else(|| "not known".to_owned(), energy);
        writeln!(
            text,
            "no way with less than {}; the path: {most}",
            energy(least)
        )?;
    }
    for pass in &escape.passes {
        writeln!(
            text,
            "pass at {}: {}",
            pair.place(pass.at),
            energy(pass.energy)
        )?;
        for &features in &pass.features {
            writeln!(text, "  {}", pair.touches(features))?;
        }
    }
    if !escape.path.is_empty() {
        let legs = escape.path.len().saturating_sub(1);
        writeln!(text, "path: {}", count(legs, "leg", "legs"))?;
        for &at in &escape.path {
            writeln!(text, "  {}", pair.place(at))?;
        }
    }
    if let Some(enclosed) = &escape.enclosed {
        let patches = count(enclosed.patches, "contact patch", "contact patches");
        let region = pair.region(enclosed.region);
        writeln!(text, "{region} is enclosed by {patches}")?;
    }
    if let Some(Overlap {
        nearest: Some(at),
        depth: Some(depth),
        ..
    }) = &escape.blocked
    {
        let unit = pair.unit();
        writeln!(
            text,
            "free     {}, {}{unit} away",
            pair.place(*at),
            length(*depth)
        )?;
    }
    if escape.unit_mass {
        writeln!(
            text,
            "the model has no mass of {}: energies are for 1 kg",
            pair.moving().name()
        )?;
    }
    Ok(())
}
