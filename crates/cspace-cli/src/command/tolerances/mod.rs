//! `cspace tolerances`.

mod allocation;
mod along;
mod text;
mod zones;

use cspace_api::tolerances::Outcome;
use cspace_api::tolerances::analysis::Question;

use crate::args::TolerancesArgs;
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::progress::tell_above;

pub(crate) fn run(args: &TolerancesArgs) -> Result<(), Failure> {
    let format = crate::picture::format(args.result.output.as_deref());
    if format.is_none() && !args.zones {
        args.picture.refuse()?;
    }
    args.result.artefact(&["json", "svg", "png", "pdf"])?;
    output::check(args.result.output.as_deref())?;
    let has_zones = args.zones || format.is_some() && args.along.is_none();
    if args.at.is_some() && !has_zones {
        return Err(Failure::new("--at is the orientation of contact zones")
            .help("give --zones or -o OUT.svg, or leave it out"));
    }
    if format.is_some() && (args.allocate.is_some() || args.samples > 0) {
        return Err(
            Failure::new("-o: a picture shows contact zones, or values along a motion")
                .help("leave --allocate and --samples out, or let the name end in .txt or .json"),
        );
    }
    let subject = ask::read_again(&args.file, &args.values, args.threads)?;
    let host = Terminal::default();
    if has_zones {
        let printed = zones::run(args, &subject, &host);
        // Without --zones they are a picture beside the answer.
        if args.zones || printed.is_err() {
            return printed;
        }
    }
    if let Some(vary) = &args.along {
        return along::run(args, vary, &subject, &host);
    }
    if let Some(criterion) = args.allocate {
        return allocation::run(args, criterion, &subject, &host);
    }
    let unit = subject.unit().map_or(String::new(), |u| format!(" {u}"));
    let question = Question {
        requirement: args.requirement.clone(),
        no_proof: args.no_proof,
        samples: args.samples,
        seed: args.seed,
    };
    let answer = question.ask_with(&subject, &host, &|nominal, known| {
        tell_above(text::at_once(&nominal.variations, known, &unit));
    })?;
    let printed = super::tell(&args.result, &answer, |text, analysis| {
        let (nominal, found) = (&analysis.nominal, &analysis.found);
        let mechanism = &nominal.model.mechanism;
        *text = text::described(mechanism, &nominal.variations, found, &unit);
        Ok(())
    });
    let mut effects = answer.content.requirements.iter();
    if effects.any(|effect| effect.outcome == Outcome::Interrupted) {
        return Err(Failure::new("interrupted: what is known is written"));
    }
    printed
}
