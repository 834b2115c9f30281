//! The command line: its commands, what each is for, and the options that all of them have.

use clap::{CommandFactory, Parser, Subcommand, ValueEnum};
use cspace_api::written::{Export, Picture};

use crate::command;
use crate::failure::Failure;

/// Exact configuration spaces of planar parts bounded by line segments and circular arcs.
#[derive(Debug, Parser)]
#[command(name = "cspace", version, after_long_help = OVERVIEW, subcommand_required = true, arg_required_else_help = true, disable_help_subcommand = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
    /// Say nothing on standard error but errors
    #[arg(short, long, global = true, hide_short_help = true, display_order = AFTER_OWN)]
    pub(crate) quiet: bool,
    /// When to colour messages on standard error: auto (on a terminal), always or never; NO_COLOR is obeyed too. Of drawings, a colour such
    /// as red, #ff0000, or its number in AutoCAD's palette: what is drawn in it is read, and nothing else; may be given several times
    #[arg(long, global = true, value_parser = colored, value_name = "WHEN|COLOR", hide_short_help = true, display_order = AFTER_OWN + 1)]
    pub(crate) color: Vec<Colored>,
}

/// Help lists options of all commands after those of the command itself, which are fewer.
const AFTER_OWN: usize = 900;

/// Commands by what they are for, in the order in which the help lists them.
const GROUPS: [(&str, &[&str]); 5] = [
    ("Make a model", &["new", "import", "info"]),
    (
        "Ask about contact",
        &[
            "compute",
            "slice",
            "classify",
            "play",
            "plan",
            "disassemble",
            "clearance",
            "modes",
        ],
    ),
    ("Set in motion", &["simulate"]),
    ("Design", &["check", "sweep", "solve", "tolerances"]),
    ("Show", &["draw", "view", "export", "mcp"]),
];

/// The command line, whose help lists the commands in groups.
pub(crate) fn command() -> clap::Command {
    let command = Cli::command();
    let mut list = String::new();
    for (group, names) in GROUPS {
        list += &format!("{group}:\n");
        for name in names {
            let about = command.find_subcommand(name).and_then(|c| c.get_about());
            let about = about.map(ToString::to_string).unwrap_or_default();
            list += &format!("  {name:11}  {about}\n");
        }
        list.push('\n');
    }
    // Braces are the template's own.
    let template = format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{list}Options:\n{{options}}{{after-help}}"
    );
    let command = command.help_template(template);
    // They are refused with what else writes files.
    let silent = ["info", "compute", "play", "clearance", "check", "solve"];
    silent.into_iter().fold(command, |command, name| {
        command.mut_subcommand(name, |c| c.mut_arg("output", |arg| arg.hide(true)))
    })
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Show the parts of a model, and the class of every pair
    Info(command::info::InfoArgs),
    /// Compute the contact space of each pair and show a summary
    Compute(command::compute::ComputeArgs),
    /// Show the planar slice of a contact space at one orientation
    Slice(command::slice::SliceArgs),
    /// Classify configurations as free, blocked or in contact
    Classify(command::classify::ClassifyArgs),
    /// Find a path from one configuration to another, or prove that there is none
    Plan(command::plan::PlanArgs),
    /// Find the order in which parts come apart, or the parts that lock each other
    Disassemble(command::disassemble::DisassembleArgs),
    /// Report the smallest gap of every two parts, or what overlaps
    Clearance(command::clearance::ClearanceArgs),
    /// List the operating modes of three parts or more on axes
    Modes(command::modes::ModesArgs),
    /// Measure the requirements of the design, and report which are met
    Check(command::check::CheckArgs),
    /// Measure requirements over ranges of parameters or coordinates
    Sweep(command::sweep::SweepArgs),
    /// Analyse what tolerances do to each requirement
    Tolerances(command::tolerances::TolerancesArgs),
    /// Find values of parameters at which a measure is what it must be
    Solve(command::solve::SolveArgs),
    /// Set a mechanism in motion by its drives, springs and loads
    Simulate(command::simulate::SimulateArgs),
    /// Report what touches, and how far the parts go in each direction
    Play(command::play::PlayArgs),
    /// Draw the parts of a model, or a pair at a configuration
    Draw(command::draw::DrawArgs),
    /// Show the parts and their contact spaces in a browser
    View(command::view::ViewArgs),
    /// Write a contact space, its surface, or a page to a file
    Export(command::export::ExportArgs),
    /// Make a model of drawings: DXF, SVG, or points
    Import(command::import::ImportArgs),
    /// Write a model to begin with: latch, cam, gears, geneva, ratchet, peg
    New(command::new::NewArgs),
    /// Answer questions as tools of an assistant, on standard input and output
    Mcp(command::mcp::McpArgs),
    /// Print a script that completes this command in a shell
    #[command(hide = true)]
    Completions(command::completions::CompletionsArgs),
    /// Print the manual page of this command, or of one of its subcommands
    #[command(hide = true)]
    Man(command::man::ManArgs),
}

impl Command {
    /// Runs the command; of drawings what is in these colours is read.
    pub(crate) fn run(mut self, colors: Vec<cspace_drawing::Color>) -> Result<(), Failure> {
        match &mut self {
            Self::Import(args) => args.source.colors = colors,
            Self::View(args) => args.source.colors = colors,
            _ => {
                if let Some(color) = colors.first() {
                    let message = format_args!("--color {color}: colours are chosen of drawings");
                    return Err(Failure::new(message).help("give auto, always or never"));
                }
            }
        }
        match self {
            Self::Info(args) => command::info::run(&args),
            Self::Compute(args) => command::compute::run(&args),
            Self::Slice(args) => command::slice::run(&args),
            Self::Classify(args) => command::classify::run(&args),
            Self::Draw(args) => {
                let answer = |written| Picture { written };
                command::writing(&args.common.result, answer, || command::draw::run(&args))
            }
            Self::Plan(args) => command::plan::run(&args),
            Self::Disassemble(args) => command::disassemble::run(&args),
            Self::Check(args) => command::check::run(&args),
            Self::Clearance(args) => command::clearance::run(&args),
            Self::Modes(args) => command::modes::run(&args),
            Self::Sweep(args) => command::sweep::run(&args),
            Self::Tolerances(args) => command::tolerances::run(&args),
            Self::Solve(args) => command::solve::run(&args),
            Self::Simulate(args) => command::simulate::run(&args),
            Self::Play(args) => command::play::run(&args),
            Self::View(args) => command::view::run(&args),
            Self::Export(args) => {
                let answer = |written| Export { written };
                command::writing(&args.common.result, answer, || command::export::run(&args))
            }
            Self::Import(args) => command::import::run(&args),
            Self::New(args) => command::new::run(&args),
            Self::Mcp(args) => command::mcp::run(&args),
            Self::Completions(args) => command::completions::run(&args, Cli::command()),
            Self::Man(args) => command::man::run(&args, Cli::command()),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorWhen {
    /// On a terminal
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl From<ColorWhen> for anstream::ColorChoice {
    fn from(when: ColorWhen) -> Self {
        match when {
            ColorWhen::Auto => Self::Auto,
            ColorWhen::Always => Self::Always,
            ColorWhen::Never => Self::Never,
        }
    }
}

/// Meaning of `--color`: when to colour messages, or colours of drawings to read.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Colored {
    When(ColorWhen),
    In(cspace_drawing::Color),
}

fn colored(text: &str) -> Result<Colored, String> {
    match ColorWhen::from_str(text, true) {
        Ok(when) => Ok(Colored::When(when)),
        Err(_) => match text.parse() {
            Ok(color) => Ok(Colored::In(color)),
            Err(_) => Err(
                "give auto, always or never; or, of drawings, a colour such as red, #ff0000 or 1"
                    .to_owned(),
            ),
        },
    }
}

const OVERVIEW: &str = "\
Start with a model that the project ships:
  cspace info models/ratchet_pawl.toml
  cspace compute models/ratchet_pawl.toml
  cspace slice models/ratchet_pawl.toml --theta 5deg -o slice.svg

A configuration (x, y, theta) takes the moving part's point q to (x, y) + R q
in the fixed part's frame. Angles are radians; a string such as 18deg is
accepted too. Lengths are in the model's unit.

The answer goes to standard output, with --json as one object whose schema is
in docs/answers; -o OUT writes a file beside it. Messages go to standard error.

Exit codes:
  0  the question was answered, and the answer is yes or a value
  1  it was answered, and the answer is no: not met, overlap, no path, jammed
  2  it was not answered: bad input or usage, undecided, failed, interrupted";
