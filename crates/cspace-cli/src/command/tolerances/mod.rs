//! `cspace tolerances`.

mod allocation;
mod along;
mod text;
mod zones;

use std::path::PathBuf;

use clap::Args;
use cspace_api::tolerances::{self as asked, Outcome};

use crate::args::{ResultArgs, SetArgs, ThreadsArg};
use crate::ask::{self, Terminal};
use crate::failure::Failure;
use crate::output;
use crate::picture::PictureArgs;
use crate::progress::tell_above;

const HELP: &str = "\
Examples:
  cspace tolerances models/tolerances/overrunning_clutch.toml
  cspace tolerances models/tolerances/geneva_lock.toml --samples 100000
  cspace tolerances models/tolerances/geneva_lock.toml -o zones.svg
  cspace tolerances models/tolerances/geneva_lock.toml --allocate 99.9%
  cspace tolerances models/tolerances/geneva_lock.toml --along u=0deg:90deg:3

Parameters have tolerances in the model: tol, plus and minus, limits, position.
Of each requirement are printed: what each parameter contributes; the linear
worst case and the root of the sum of squares; the smallest and the largest
value, and whether that is proved; where other contacts take over or parts jam;
and the factor on all tolerances at which something fails. Angles in JSON are in
radians.
";

/// Arguments of `cspace tolerances`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct TolerancesArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    #[command(flatten)]
    pub(crate) analysis: asked::analysis::Question,
    #[command(flatten)]
    pub(crate) allocation: Option<asked::allocation::Question>,
    /// Cost of a parameter's tolerance at the value given in the model; may be given several times [default: 1 for every parameter]
    #[arg(long, value_name = "NAME=COST", requires = "allocate", value_parser = cost, hide_short_help = true)]
    pub(crate) cost: Vec<(String, f64)>,
    #[command(flatten)]
    pub(crate) bands: Option<asked::along::Question>,
    /// Report where the pair of a requirement is free, blocked, or either, within the tolerances: over u and v, or over x and y at an orientation;
    /// -o OUT.svg, .png or .pdf makes a picture of it
    #[arg(long, conflicts_with_all = ["no_proof", "allocate", "samples", "along"])]
    pub(crate) zones: bool,
    #[command(flatten)]
    pub(crate) zone: asked::zones::Question,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

fn cost(text: &str) -> Result<(String, f64), String> {
    let parsed = text.split_once('=').and_then(|(name, cost)| {
        let cost = cost.trim().parse::<f64>().ok()?;
        (cost.is_finite() && cost > 0.0).then(|| (name.trim().to_owned(), cost))
    });
    parsed.ok_or_else(|| "give it as NAME=COST with a cost above 0, such as --cost pin=2.5".into())
}

pub(crate) fn run(args: &TolerancesArgs) -> Result<(), Failure> {
    let format = crate::picture::format(args.result.output.as_deref());
    if format.is_none() && !args.zones {
        args.picture.refuse()?;
    }
    args.result.artefact(&["json", "svg", "png", "pdf"])?;
    output::check(args.result.output.as_deref())?;
    let has_zones = args.zones || format.is_some() && args.bands.is_none();
    if args.zone.at.is_some() && !has_zones {
        return Err(Failure::new("--at is the orientation of contact zones")
            .help("give --zones or -o OUT.svg, or leave it out"));
    }
    if format.is_some() && (args.allocation.is_some() || args.analysis.samples > 0) {
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
    if let Some(bands) = &args.bands {
        return along::run(args, bands, &subject, &host);
    }
    if let Some(allocation) = &args.allocation {
        return allocation::run(args, allocation, &subject, &host);
    }
    let unit = subject.unit().map_or(String::new(), |u| format!(" {u}"));
    let answer = args.analysis.ask_with(&subject, &host, &|nominal, known| {
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
