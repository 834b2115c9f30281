//! The command line.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use cspace::Point;
use cspace_api::given;
use cspace_api::{Given, Vary, classify, simulate};
use cspace_design::{Criterion, Goal, Relation, Span, Value as Measured};
use cspace_drawing::Pick;
use cspace_model::model::Setting;
use cspace_plan::Prefer;

use crate::failure::Failure;
use crate::picture::{PictureArgs, SheetArgs};
use crate::template::{self, TEMPLATES, Template};

/// Exact configuration spaces of planar parts bounded by line segments and circular arcs.
#[derive(Debug, Parser)]
#[command(name = "cspace", version, after_long_help = OVERVIEW, subcommand_required = true, arg_required_else_help = true, disable_help_subcommand = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
    /// Say nothing on standard error but errors
    #[arg(short, long, global = true, hide_short_help = true)]
    pub(crate) quiet: bool,
    /// When to colour messages on standard error: auto (on a terminal), always or never; NO_COLOR is obeyed too. Of drawings, a colour such
    /// as red, #ff0000, or its number in AutoCAD's palette: what is drawn in it is read, and nothing else; may be given several times
    #[arg(long, global = true, value_parser = colored, value_name = "WHEN|COLOR", hide_short_help = true)]
    pub(crate) color: Vec<Colored>,
}

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
    ("Show", &["draw", "view", "export"]),
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
    #[command(after_long_help = INFO)]
    Info(InfoArgs),
    /// Compute the contact space of each pair and show a summary
    #[command(after_long_help = COMPUTE)]
    Compute(ComputeArgs),
    /// Show the planar slice of a contact space at one orientation
    #[command(after_long_help = SLICE)]
    Slice(SliceArgs),
    /// Classify configurations as free, blocked or in contact
    #[command(after_long_help = CLASSIFY)]
    Classify(ClassifyArgs),
    /// Find a path from one configuration to another, or prove that there is none
    #[command(after_long_help = PLAN)]
    Plan(PlanArgs),
    /// Find the order in which parts come apart, or the parts that lock each other
    #[command(after_long_help = DISASSEMBLE)]
    Disassemble(DisassembleArgs),
    /// Report the smallest gap of every two parts, or what overlaps
    #[command(after_long_help = CLEARANCE)]
    Clearance(ClearanceArgs),
    /// List the operating modes of three parts on axes
    #[command(after_long_help = MODES)]
    Modes(ModesArgs),
    /// Measure the requirements of the design, and report which are met
    #[command(after_long_help = CHECK)]
    Check(CheckArgs),
    /// Measure requirements over ranges of parameters or coordinates
    #[command(after_long_help = SWEEP)]
    Sweep(SweepArgs),
    /// Analyse what tolerances do to each requirement
    #[command(after_long_help = TOLERANCES)]
    Tolerances(TolerancesArgs),
    /// Find values of parameters at which a measure is what it must be
    #[command(after_long_help = SOLVE)]
    Solve(SolveArgs),
    /// Set a mechanism in motion by its drives, springs and loads
    #[command(after_long_help = SIMULATE)]
    Simulate(SimulateArgs),
    /// Report what touches, and how far the parts go in each direction
    #[command(after_long_help = PLAY)]
    Play(PlayArgs),
    /// Draw the parts of a model, or a pair at a configuration
    #[command(after_long_help = DRAW)]
    Draw(DrawArgs),
    /// Show the parts and their contact spaces in a browser
    #[command(after_long_help = VIEW)]
    View(ViewArgs),
    /// Write a contact space, its surface, or a page to a file
    #[command(after_long_help = EXPORT)]
    Export(ExportArgs),
    /// Make a model of drawings: DXF, SVG, or points
    #[command(after_long_help = IMPORT)]
    Import(ImportArgs),
    /// Write a model to begin with: latch, cam, gears, geneva, ratchet, peg
    #[command(after_long_help = format!("{NEW}{}", template::dimensions().trim_end()), arg_required_else_help = true)]
    New(NewArgs),
    /// Print a script that completes this command in a shell
    #[command(after_long_help = COMPLETIONS, hide = true)]
    Completions(CompletionsArgs),
    /// Print the manual page of this command, or of one of its subcommands
    #[command(after_long_help = MAN, hide = true)]
    Man(ManArgs),
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

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

/// Values of parameters.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct SetArgs {
    /// Give a parameter of the model another value: a number, an angle such as 18deg, or an expression; may be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting)]
    pub(crate) set: Vec<Setting>,
}

/// A parameter and its value.
fn setting(text: &str) -> Result<Setting, String> {
    let (name, value) = text
        .split_once('=')
        .ok_or("give it as NAME=VALUE, such as --set pin=6.2")?;
    Ok(Setting {
        name: name.trim().to_owned(),
        value: value.trim().to_owned(),
    })
}

/// Whether spaces are kept for the next command.
#[derive(Debug, Clone, Copy, Default, Args)]
pub(crate) struct CacheArgs {
    /// Compute spaces that were computed before, and keep none
    ///
    /// A space that takes 0.2 s or more is kept in the user's folder of caches, and read where the same parts move in the same
    /// way. CSPACE_CACHE names another folder; with CSPACE_CACHE=off nothing is kept.
    #[arg(long, hide_short_help = true)]
    pub(crate) no_cache: bool,
}

/// How many threads compute.
#[derive(Debug, Clone, Copy, Default, Args)]
pub(crate) struct ThreadsArg {
    /// Number of threads; 0 for one per processor. Results do not depend on it
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = threads(), allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) threads: u16,
}

/// Arguments common to the commands that take a file.
#[derive(Debug, Clone, Args)]
pub(crate) struct Common {
    /// A model (.toml, .json), or a contact space saved by `cspace export FILE -o OUT.json`; - is standard input
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) values: SetArgs,

    /// The pair: names of its fixed and its moving part
    #[arg(long, value_name = "FIXED,MOVING")]
    pub(crate) pair: Option<String>,

    /// Use the general method whatever the class of the pair
    ///
    /// The symmetry of parts is not used then.
    #[arg(long, hide_short_help = true)]
    pub(crate) general: bool,

    /// Make lines and arcs tangent that miss tangency by less than 0.001 rad; a note reports how far points were moved
    #[arg(long, hide_short_help = true)]
    pub(crate) snap: bool,

    #[command(flatten)]
    pub(crate) result: ResultArgs,

    #[command(flatten)]
    pub(crate) cache: CacheArgs,

    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

/// How the answer is printed.
#[derive(Debug, Clone, Copy, Default, Args)]
pub(crate) struct FormArgs {
    /// Print the answer as JSON; errors are printed so, too
    #[arg(long)]
    json: bool,

    /// The other name of --json
    #[arg(long, value_enum, hide = true, conflicts_with = "json")]
    format: Option<Format>,
}

impl FormArgs {
    /// How the answer is printed.
    pub(crate) fn format(self) -> Format {
        match self.json {
            true => Format::Json,
            false => self.format.unwrap_or(Format::Text),
        }
    }
}

/// How the answer is printed, and which file is written beside it.
#[derive(Debug, Clone, Default, Args)]
pub(crate) struct ResultArgs {
    #[command(flatten)]
    form: FormArgs,

    /// Write a file beside the answer, of the kind that its name says; whole or not at all
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}

impl ResultArgs {
    /// How the answer is printed.
    pub(crate) fn format(&self) -> Format {
        self.form.format()
    }

    /// The file to write, whose name ends in one of these extensions.
    ///
    /// # Errors
    /// If it ends in another one.
    pub(crate) fn artefact(&self, known: &[&str]) -> Result<Option<&Path>, Failure> {
        let Some(path) = self.output.as_deref() else {
            return Ok(None);
        };
        if known.iter().any(|k| crate::output::ends_in(path, k)) {
            return Ok(Some(path));
        }
        let wrong = Failure::new(format_args!(
            "-o {}: this command writes no such file",
            path.display()
        ));
        Err(match known {
            [] => wrong.help("leave -o out: the answer goes to standard output, with --json for programs; `cspace draw`, `slice` and `export` write pictures, meshes and spaces"),
            known => wrong.help(format_args!(
                "let the name end in .{}; the answer goes to standard output",
                known.join(", .")
            )),
        })
    }
}

/// The window of orientations.
#[derive(Debug, Clone, Copy, Args)]
pub(crate) struct WindowArg {
    /// Compute only these orientations: two angles, in radians or such as 18deg, at most 1e6 rad from 0
    #[arg(long, value_name = "LO,HI", value_parser = given::window, allow_hyphen_values = true)]
    pub(crate) window: Option<(f64, f64)>,
}

#[derive(Debug, Args)]
pub(crate) struct InfoArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    /// More files, answered one after the other
    #[arg(value_name = "FILE")]
    pub(crate) more: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) window: WindowArg,
}

#[derive(Debug, Args)]
pub(crate) struct ComputeArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    /// More files, answered one after the other
    #[arg(value_name = "FILE")]
    pub(crate) more: Vec<PathBuf>,
    /// Say as well how certain the structure is, and which spaces were computed before and kept
    #[arg(short, long, hide_short_help = true)]
    pub(crate) verbose: bool,
    /// The space in which the parts keep this clearance, in the model's unit: with the moving part grown by it all round
    #[arg(long, value_name = "L", value_parser = length, allow_negative_numbers = true)]
    pub(crate) clearance: Option<f64>,
    #[command(flatten)]
    pub(crate) window: WindowArg,
}

#[derive(Debug, Args)]
pub(crate) struct SliceArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    /// The orientation of the moving part, in radians or such as 18deg, at most 1e6 rad from 0; a pair with fixed axes
    /// has none
    #[arg(long, value_name = "T", value_parser = given::angle, allow_hyphen_values = true)]
    pub(crate) theta: Option<f64>,
    /// Count exact fits as free: a loop of the slice may be a single point, or run along a segment or an arc and back; curves are
    /// those of the parts as drawn, and adjacent curves on one line or circle are merged
    #[arg(long, hide_short_help = true)]
    pub(crate) exact: bool,
    /// Pictures: the position x,y at which the parts are shown beside the slice [default: as drawn, or the nearest contact]
    #[arg(long, value_name = "X,Y", value_parser = position, allow_hyphen_values = true)]
    pub(crate) at: Option<(f64, f64)>,
    /// The version of DXF, where the name after -o ends in .dxf
    #[arg(long, value_enum, value_name = "VERSION", hide_short_help = true)]
    pub(crate) dxf: Option<DxfChoice>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

#[derive(Debug, Args)]
pub(crate) struct ClassifyArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) window: WindowArg,
    /// Columns added to each row, in this order
    #[arg(
        long,
        value_enum,
        value_name = "NAMES",
        value_delimiter = ',',
        default_value = "class",
        hide_short_help = true
    )]
    pub(crate) columns: Vec<Column>,
    /// How far apart features may be that touch, in the model's unit [default: the resolution]
    #[arg(long, value_name = "L", value_parser = distance, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) touch: Option<f64>,
}

/// A property of a configuration, as a column of the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Column {
    /// free, blocked or contact
    Class,
    /// The number of the free region: 0 for `outside`, 1 for `pocket 1`
    Region,
    /// How far the moving part moves to the nearest contact
    Distance,
    /// The features that touch
    Touching,
}

impl From<Column> for classify::Column {
    fn from(column: Column) -> Self {
        match column {
            Column::Class => Self::Class,
            Column::Region => Self::Region,
            Column::Distance => Self::Distance,
            Column::Touching => Self::Touching,
        }
    }
}

/// The point that legs and turns are about.
#[derive(Debug, Args)]
pub(crate) struct AboutArg {
    /// The point of the moving part, in its frame, that moves straight and about which the part turns
    #[arg(long, value_name = "X,Y", value_parser = pair_of_numbers, allow_hyphen_values = true, hide_short_help = true)]
    pub(crate) about: Option<[f64; 2]>,
}

#[derive(Debug, Args)]
pub(crate) struct PlayArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) window: WindowArg,
    #[command(flatten)]
    pub(crate) about: AboutArg,
    /// The configuration: x,y,theta, or u,v of a pair on fixed axes [default: as drawn, of every pair]
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) at: Option<Given>,
    /// Move from there by this displacement, in the same coordinates, at constant rates, to the first contact
    #[arg(long, value_name = "D", allow_hyphen_values = true)]
    pub(crate) by: Option<Given>,
    /// How far apart features may be that are near, in the model's unit [default: a hundredth of the smaller part's size]
    #[arg(long, value_name = "L", value_parser = distance, allow_negative_numbers = true)]
    pub(crate) touch: Option<f64>,
}

#[derive(Debug, Args)]
pub(crate) struct DrawArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    /// Write SVG of the outlines alone, to scale
    #[arg(long)]
    pub(crate) outlines: bool,
    /// The version of DXF
    #[arg(long, value_enum, value_name = "VERSION", hide_short_help = true)]
    pub(crate) dxf: Option<DxfChoice>,
    /// The configuration of the pair: x,y,theta, or u,v on fixed axes; what touches there is marked [default: as drawn]
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) at: Option<String>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// Versions of DXF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DxfChoice {
    /// R12, which every program reads
    R12,
    /// R2000
    R2000,
}

/// The property by which a path is chosen among those with the requested clearance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum PreferChoice {
    /// Few legs, straight along edges and axes, or turns on the spot
    Legs,
    /// Clearance all along
    Clearance,
    /// A short path
    Length,
}

impl From<PreferChoice> for Prefer {
    fn from(choice: PreferChoice) -> Self {
        match choice {
            PreferChoice::Legs => Self::Legs,
            PreferChoice::Clearance => Self::Clearance,
            PreferChoice::Length => Self::Length,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) window: WindowArg,
    #[command(flatten)]
    pub(crate) about: AboutArg,
    /// The configuration to begin at, x,y,theta, or u,v of a pair on fixed axes; as drawn unless given
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) from: Option<Given>,
    /// The configuration to come to; `out`, where the parts can be taken apart for good, unless given
    #[arg(long, value_name = "C", allow_hyphen_values = true)]
    pub(crate) to: Option<Given>,
    /// The path whose smallest clearance is largest, and its bottleneck
    #[arg(long, conflicts_with_all = ["clearance", "verify"])]
    pub(crate) widest: bool,
    /// A path with at least this clearance, in the model's unit [default: half of what is possible]
    #[arg(long, value_name = "L", value_parser = distance, allow_negative_numbers = true, conflicts_with = "verify")]
    pub(crate) clearance: Option<f64>,
    /// Property by which the path is chosen among those with that clearance
    #[arg(
        long,
        value_enum,
        value_name = "WHAT",
        default_value = "legs",
        conflicts_with = "verify",
        hide_short_help = true
    )]
    pub(crate) prefer: PreferChoice,
    /// No leg turns by more than this, in radians or such as 18deg
    #[arg(long, value_name = "A", value_parser = turn, allow_hyphen_values = true, conflicts_with = "verify", hide_short_help = true)]
    pub(crate) turn: Option<f64>,
    /// No leg moves along a coordinate by more than this, in the model's unit
    #[arg(long, value_name = "L", value_parser = length, allow_negative_numbers = true, conflicts_with = "verify", hide_short_help = true)]
    pub(crate) travel: Option<f64>,
    /// With --proof: how deep its surface lies in blocked space, in the model's unit [default: as deep as can be]
    #[arg(long, value_name = "D", value_parser = length, allow_negative_numbers = true, conflicts_with = "verify", hide_short_help = true)]
    pub(crate) depth: Option<f64>,
    /// Judge the path in this file instead: configurations in rows, with the columns x,y,theta or u,v
    #[arg(long, value_name = "PATH.csv", conflicts_with_all = ["from", "to"])]
    pub(crate) verify: Option<PathBuf>,
    /// Write the proof that there is no path to this file, which `cspace-check` verifies
    #[arg(long, value_name = "FILE", conflicts_with_all = ["verify", "energy"])]
    pub(crate) proof: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) energy: EnergyArgs,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// The least energy that lets the moving part out.
#[derive(Debug, Args)]
pub(crate) struct EnergyArgs {
    /// Bound the least energy with which the moving part gets out, or comes to --to, against gravity, loads and springs
    #[arg(long, conflicts_with_all = ["widest", "clearance", "prefer", "turn", "travel", "depth", "verify", "about"])]
    pub(crate) energy: bool,
    /// With --energy: the acceleration of gravity, unit/s², in place of the model's
    #[arg(long, value_name = "X,Y", value_parser = pair_of_numbers, allow_hyphen_values = true, requires = "energy", hide_short_help = true)]
    pub(crate) gravity: Option<[f64; 2]>,
    /// With --energy: how near its bounds are brought, kg·unit²/s² [default: 3 % of it]
    #[arg(long, value_name = "E", value_parser = energy, allow_negative_numbers = true, requires = "energy", hide_short_help = true)]
    pub(crate) accuracy: Option<f64>,
}

#[derive(Debug, Args)]
pub(crate) struct DisassembleArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// How far parts that touch are opened, in the model's unit [default: a millionth of the assembly's size]
    #[arg(long, value_name = "L", value_parser = length, allow_negative_numbers = true)]
    pub(crate) gap: Option<f64>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

#[derive(Debug, Args)]
pub(crate) struct ClearanceArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// This pair alone: names of its two parts
    #[arg(long, value_name = "FIRST,SECOND")]
    pub(crate) pair: Option<String>,
    /// Over the motion that `cspace simulate` wrote to this file with -o, CSV or JSON, in place of all that ranges allow
    #[arg(long, value_name = "RECORD")]
    pub(crate) along: Option<PathBuf>,
    /// All pairs as drawn, in place of over the ranges of their parts
    #[arg(long, conflicts_with = "along")]
    pub(crate) drawn: bool,
    /// List pairs nearer than this, in the model's unit, and count the others [default: all; of more than 200 parts, or 500 pairs over
    /// their ranges, a tenth of the largest part's size]
    #[arg(long, value_name = "L", value_parser = distance, allow_negative_numbers = true)]
    pub(crate) within: Option<f64>,
    /// Parts touch that are nearer than this, or overlap by less, in the model's unit [default: 1e-11 of the larger part's size]
    #[arg(long, value_name = "L", value_parser = distance, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) touch: Option<f64>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

#[derive(Debug, Args)]
pub(crate) struct ModesArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// The three parts, whose coordinates are u, v and w in that order [default: those that move on axes, if there are three]
    #[arg(long, value_name = "A,B,C")]
    pub(crate) parts: Option<String>,
    /// The configuration of which the mode is requested; coordinates left out are as drawn [default: all as drawn]
    #[arg(long, value_name = "u=U,v=V,w=W", allow_hyphen_values = true)]
    pub(crate) at: Option<String>,
    #[command(flatten)]
    pub(crate) picture: SheetArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// This requirement alone; may be given several times
    #[arg(long, value_name = "NAME")]
    pub(crate) requirement: Vec<String>,
    /// Report how much each value changes with each parameter
    #[arg(long)]
    pub(crate) sensitivities: bool,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) cache: CacheArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

#[derive(Debug, Args)]
pub(crate) struct TolerancesArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// This requirement alone; may be given several times
    #[arg(long, value_name = "NAME")]
    pub(crate) requirement: Vec<String>,
    /// Leave the extremes as they are found, without the proof that nothing is beyond them
    #[arg(long, conflicts_with_all = ["allocate", "along", "zones"])]
    pub(crate) no_proof: bool,
    /// Measure the yield on this many samples by chance
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u64).range(0..=100_000_000), hide_short_help = true)]
    pub(crate) samples: u64,
    /// Seed of the random samples: the same seed gives the same numbers, on any number of threads
    #[arg(long, value_name = "S", default_value_t = 0, hide_short_help = true)]
    pub(crate) seed: u64,
    /// Find the tolerances of minimum cost at which every part meets the limits (worst), or a share of the parts, such as 99.9%: halving a
    /// tolerance doubles its cost
    #[arg(long, value_name = "worst|YIELD", value_parser = criterion)]
    pub(crate) allocate: Option<Criterion>,
    /// Cost of a parameter's tolerance at the value given in the model; may be given several times [default: 1 for every parameter]
    #[arg(long, value_name = "NAME=COST", requires = "allocate", value_parser = cost, hide_short_help = true)]
    pub(crate) cost: Vec<(String, f64)>,
    /// Report each value and its extremes at N values of a coordinate from LO to HI; a play is measured about where the part was before
    #[arg(long, value_name = "NAME=LO:HI:N", value_parser = vary, allow_hyphen_values = true, conflicts_with_all = ["allocate", "samples"])]
    pub(crate) along: Option<Vary>,
    /// Report where the pair of a requirement is free, blocked, or either, within the tolerances: over u and v, or over x and y at an orientation;
    /// -o OUT.svg, .png or .pdf makes a picture of it
    #[arg(long, conflicts_with_all = ["allocate", "samples", "along"])]
    pub(crate) zones: bool,
    /// The orientation of --zones of a pair in the plane [default: that at which the requirement is measured]
    #[arg(long, value_name = "A", value_parser = given::angle, allow_hyphen_values = true)]
    pub(crate) at: Option<f64>,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    /// A model (.toml, .json)
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// A parameter, or a coordinate (x, y, theta, u, v) of the configurations at which is measured, from LO to HI in N values; of several
    /// every combination
    #[arg(long, value_name = "NAME=LO:HI:N", value_parser = vary, allow_hyphen_values = true)]
    pub(crate) vary: Vec<Vary>,
    /// Rows of values in place of --vary: CSV with names in its first line
    #[arg(long, value_name = "FILE.csv", conflicts_with = "vary")]
    pub(crate) rows: Option<PathBuf>,
    /// A requirement that is measured; may be given several times [default: all]
    #[arg(long, value_name = "NAME")]
    pub(crate) measure: Vec<String>,
    /// Report in place of the rows where the structure changes as the name that is varied last goes through its range: features that
    /// touch, free regions, whether there is a value; located to 1e-9 of the range
    #[arg(long, conflicts_with = "rows")]
    pub(crate) changes: bool,
    /// Keep the rows that the table OUT.csv of an interrupted sweep has, and compute those that it lacks; the model and the other
    /// arguments must be the same
    #[arg(long, conflicts_with = "changes")]
    pub(crate) resume: bool,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

#[derive(Debug, Args)]
pub(crate) struct SolveArgs {
    /// A model (.toml, .json)
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// A parameter that may be from LO to HI; of several the smallest change from the model's values is sought, relative to their ranges
    #[arg(long, value_name = "NAME=LO:HI", value_parser = bounds, allow_hyphen_values = true, required = true)]
    pub(crate) vary: Vec<Span>,
    /// Condition to satisfy: the name of a requirement, =, <= or >=, and a value such as 0.1, 0.5deg or true
    #[arg(long, value_name = "MEASURE = VALUE", value_parser = wanted, allow_hyphen_values = true)]
    pub(crate) so_that: Goal,
    /// One parameter: the number of values at which is measured before solutions are sought between them
    #[arg(long, value_name = "N", default_value_t = cspace_api::solve::SAMPLES, value_parser = clap::value_parser!(u32).range(2..=100_000), allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) samples: u32,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

fn bounds(text: &str) -> Result<Span, String> {
    const HELP: &str = "give it as NAME=LO:HI, such as play=0.05:0.3";
    let (name, range) = text.split_once('=').ok_or(HELP)?;
    let (lo, hi) = range.split_once(':').ok_or(HELP)?;
    let (lo, hi) = (value(lo).ok_or(HELP)?, value(hi).ok_or(HELP)?);
    if lo >= hi {
        return Err("the range is empty: give the smaller bound first".to_owned());
    }
    Ok(Span {
        parameter: name.trim().to_owned(),
        lo,
        hi,
    })
}

/// A number, or an angle with its unit.
fn value(text: &str) -> Option<f64> {
    let number = text.trim().parse::<f64>().ok();
    let number = number.or_else(|| cspace_model::parse_angle(text.trim()));
    number.filter(|x| x.is_finite())
}

fn wanted(text: &str) -> Result<Goal, String> {
    const HELP: &str =
        "give it as \"MEASURE = VALUE\", with =, <= or >=, such as --so-that \"tilt = 0.5deg\"";
    let at = text.find('=').ok_or(HELP)?;
    let (name, right) = (&text[..at], text[at + 1..].trim());
    let (name, relation) = match name.strip_suffix('<') {
        Some(name) => (name, Relation::AtMost),
        None => match name.strip_suffix('>') {
            Some(name) => (name, Relation::AtLeast),
            None => (name, Relation::Equal),
        },
    };
    let value = match right {
        "true" | "yes" => Measured::Truth(true),
        "false" | "no" => Measured::Truth(false),
        number => Measured::Number(value(number).ok_or(HELP)?),
    };
    if relation != Relation::Equal && matches!(value, Measured::Truth(_)) {
        return Err("yes and no have no order: use =".to_owned());
    }
    Ok(Goal {
        requirement: name.trim().to_owned(),
        relation,
        value,
    })
}

fn vary(text: &str) -> Result<Vary, String> {
    const HELP: &str = "give it as NAME=LO:HI:N, such as play=0.05:0.3:26 or u=0deg:360deg:361";
    let (name, range) = text.split_once('=').ok_or(HELP)?;
    let [lo, hi, count] = range.split(':').collect::<Vec<_>>()[..] else {
        return Err(HELP.to_owned());
    };
    let bound = |text: &str| value(text).ok_or(HELP);
    let count = count
        .trim()
        .parse::<usize>()
        .ok()
        .filter(|n| (1..=1_000_000).contains(n));
    Ok(Vary {
        name: name.trim().to_owned(),
        lo: bound(lo)?,
        hi: bound(hi)?,
        is_angle: [lo, hi]
            .iter()
            .any(|text| text.trim().parse::<f64>().is_err()),
        count: count.ok_or("N is a whole number from 1 to 1000000")?,
    })
}

#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    /// A model (.toml, .json); - is standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,
    /// How long, in seconds
    #[arg(long, value_name = "T", value_parser = duration, allow_negative_numbers = true)]
    pub(crate) time: f64,
    /// The time between samples, in seconds [default: a 200th of the whole]
    #[arg(long, value_name = "DT", value_parser = duration, allow_negative_numbers = true)]
    pub(crate) every: Option<f64>,
    /// Whether inertia plays a part [default: dynamic if a part has a mass, otherwise kinematic]
    #[arg(long, value_enum)]
    pub(crate) mode: Option<Mode>,
    /// Go on where the motion of a record ends: what `cspace simulate` wrote with -o RECORD.json or .json.gz, of the same model
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) resume: Option<PathBuf>,
    /// How the dynamic mode goes on
    #[arg(long, value_enum, default_value_t = Scheme::Event, hide_short_help = true)]
    pub(crate) scheme: Scheme,
    /// --scheme stepping: the longest step, in seconds [default: a 10000th of the whole]
    #[arg(long, value_name = "DT", value_parser = duration, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) step: Option<f64>,
    /// Report the rates of all coordinates as well
    #[arg(long)]
    pub(crate) rates: bool,
    /// Report the forces at contacts, in joints and of drives as well
    #[arg(long)]
    pub(crate) forces: bool,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
    #[command(flatten)]
    pub(crate) result: ResultArgs,
    #[command(flatten)]
    pub(crate) cache: CacheArgs,
    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

/// The model of motion: with or without inertia.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Mode {
    /// Masses move by forces
    Dynamic,
    /// Drives move slowly; forces of loads, springs and weights balance at every instant
    Kinematic,
}

impl From<Mode> for simulate::Mode {
    fn from(mode: Mode) -> Self {
        match mode {
            Mode::Dynamic => Self::Dynamic,
            Mode::Kinematic => Self::Kinematic,
        }
    }
}

/// How a motion with masses is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Scheme {
    /// From event to event, each located to rounding
    Event,
    /// Moreau-Jean: in steps of one length, right to the order of a step; a check of the other
    Stepping,
}

impl From<Scheme> for simulate::Scheme {
    fn from(scheme: Scheme) -> Self {
        match scheme {
            Scheme::Event => Self::Event,
            Scheme::Stepping => Self::Stepping,
        }
    }
}

#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    #[command(flatten)]
    pub(crate) common: Common,
    #[command(flatten)]
    pub(crate) window: WindowArg,
    /// Meshes: how far a triangle may be from the contact surface, as a share of the pair's size [default: 0.001]
    #[arg(long, value_name = "SHARE", value_parser = share, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) tolerance: Option<f64>,
    /// Meshes: what a radian of θ is as third coordinate, in the model's unit [default: 1 in PLY; else a turn is as tall as
    /// the surface is wide]
    #[arg(long, value_name = "S", value_parser = scale, allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) theta_scale: Option<f64>,
    /// Meshes: write numbers as text where the format can have either
    #[arg(long, hide_short_help = true)]
    pub(crate) ascii: bool,
    /// Pictures: the number of slices, at even steps of orientation [default: 12]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=400), allow_negative_numbers = true)]
    pub(crate) slices: Option<u32>,
    /// Pages: an answer of `cspace plan`, `disassemble` or `simulate` in JSON, to be played; may be given several times
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) with: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

#[derive(Debug, Args)]
pub(crate) struct ViewArgs {
    /// A model (.toml, .json), a contact space saved by `cspace export FILE -o OUT.json`, or a drawing (.dxf, .svg), whose faces are
    /// picked as parts; - is a model on standard input
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) values: SetArgs,

    /// Show this pair alone: names of its fixed and its moving part
    #[arg(long, value_name = "FIXED,MOVING")]
    pub(crate) pair: Option<String>,

    #[command(flatten)]
    pub(crate) window: WindowArg,

    /// An answer of `cspace plan`, `disassemble` or `simulate` in JSON, to be played; may be given several times
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) with: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,

    /// The port of this machine that is listened to; 0 for any that is free
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        allow_negative_numbers = true
    )]
    pub(crate) port: u16,

    /// Print the address, and open no browser
    #[arg(long)]
    pub(crate) no_open: bool,

    /// Use the general method whatever the class of the pair
    ///
    /// The symmetry of parts is not used then.
    #[arg(long, hide_short_help = true)]
    pub(crate) general: bool,

    /// Make lines and arcs tangent that miss tangency by less than 0.001 rad; a note reports how far points were moved
    #[arg(long, hide_short_help = true)]
    pub(crate) snap: bool,

    #[command(flatten)]
    pub(crate) cache: CacheArgs,

    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

impl ViewArgs {
    /// The arguments that it shares with the other commands that take a file; the others have their defaults.
    pub(crate) fn common(&self) -> Common {
        Common {
            file: self.file.clone(),
            values: self.values.clone(),
            pair: self.pair.clone(),
            general: self.general,
            snap: self.snap,
            result: ResultArgs::default(),
            cache: self.cache,
            threads: self.threads,
        }
    }
}

fn criterion(text: &str) -> Result<Criterion, String> {
    let text = text.trim();
    if text == "worst" {
        return Ok(Criterion::Worst);
    }
    let share = match text.strip_suffix('%') {
        Some(percent) => percent.trim().parse::<f64>().map(|x| x / 100.0),
        None => text.parse(),
    };
    // Beyond, fewer than a hundred of a million samples would fail.
    share
        .ok()
        .filter(|share| (0.5..=0.9999).contains(share))
        .map(Criterion::Yield)
        .ok_or_else(|| "give worst, or a yield from 50% to 99.99%, such as 99.9%".into())
}

fn cost(text: &str) -> Result<(String, f64), String> {
    let parsed = text.split_once('=').and_then(|(name, cost)| {
        let cost = cost.trim().parse::<f64>().ok()?;
        (cost.is_finite() && cost > 0.0).then(|| (name.trim().to_owned(), cost))
    });
    parsed.ok_or_else(|| "give it as NAME=COST with a cost above 0, such as --cost pin=2.5".into())
}

fn threads() -> clap::builder::RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(..=1024)
}

#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Kind of the model
    #[arg(value_name = "KIND", value_parser = template_parser())]
    pub(crate) template: &'static Template,

    #[command(flatten)]
    pub(crate) values: SetArgs,

    /// Write the model to this file, NAME.toml, instead of standard output; whole or not at all
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
}

/// Reads the name of a template.
fn template_parser() -> impl TypedValueParser<Value = &'static Template> {
    let names = PossibleValuesParser::new(TEMPLATES.iter().map(Template::choice));
    names.try_map(|name| Template::named(&name).ok_or("there is no such model"))
}

#[derive(Debug, Args)]
pub(crate) struct ImportArgs {
    /// Drawings: .dxf, .svg, or .csv with the columns x and y
    #[arg(value_name = "DRAWING", required = true)]
    pub(crate) drawings: Vec<PathBuf>,

    /// Write the model to this file, .toml or .json; whole or not at all
    #[arg(short, long, value_name = "MODEL")]
    pub(crate) output: Option<PathBuf>,

    /// How to print what was done
    #[command(flatten)]
    pub(crate) form: FormArgs,

    #[command(flatten)]
    pub(crate) drawing: DrawingArgs,

    /// Fit lines and arcs to loops of 64 edges and more, too: they are traces of something smooth
    #[arg(long)]
    pub(crate) trace: bool,

    /// On which side of a curve they may be, seen from the material
    #[arg(long, value_enum, default_value_t = Side::Both, value_name = "SIDE")]
    pub(crate) fit_side: Side,

    /// Make every part larger by this all around, or smaller if it is below 0, after scaling and fitting
    #[arg(long, value_name = "L", value_parser = offset, allow_negative_numbers = true)]
    pub(crate) offset: Option<f64>,

    /// Let the offset divide a part: every piece is one
    #[arg(long, requires = "offset")]
    pub(crate) split: bool,

    /// Make one part of this name of all loops
    #[arg(long, value_name = "NAME")]
    pub(crate) part: Option<String>,

    /// Make one part of all outlines of each layer (DXF)
    #[arg(long, conflicts_with_all = ["part", "pick"])]
    pub(crate) by_layer: bool,

    /// Leave out what cannot be used, and list it
    #[arg(long)]
    pub(crate) partial: bool,

    /// Make a part of the face at a point, with its holes, after scaling; several points of one part are joined by `;`, and a
    /// part is given its name as NAME=X,Y. May be given several times
    #[arg(long, value_name = "X,Y", value_parser = pick, allow_hyphen_values = true, conflicts_with_all = ["part", "partial", "trace"])]
    pub(crate) pick: Vec<Pick>,
}

/// How drawings are read.
#[derive(Debug, Clone, Args)]
pub(crate) struct DrawingArgs {
    /// Read this layer alone; may be given several times (DXF)
    #[arg(long, value_name = "NAME")]
    pub(crate) layer: Vec<String>,

    /// Read the element of this id alone; may be given several times (SVG)
    #[arg(long, value_name = "ID")]
    pub(crate) id: Vec<String>,

    /// Read what is drawn in this line type alone; may be given several times [default: all but those of centre lines, hidden edges and
    /// the like] (DXF)
    #[arg(long, value_name = "NAME")]
    pub(crate) linetype: Vec<String>,

    /// The colours that `--color` names
    #[arg(skip)]
    pub(crate) colors: Vec<cspace_drawing::Color>,

    /// Leave out a rectangle around everything, such as the sheet of material
    #[arg(long)]
    pub(crate) without_sheet: bool,

    /// Take the outlines of hatches too (DXF)
    #[arg(long)]
    pub(crate) hatches: bool,

    /// Multiply all lengths by this; nothing else converts them then [default: from the drawing's unit to the model's]
    #[arg(long, value_name = "F", value_parser = scale, allow_negative_numbers = true)]
    pub(crate) scale: Option<f64>,

    /// The unit of length of the model: a drawing that names another is converted, one that names none is taken to be in it
    /// [default: that of the first drawing that names one]
    #[arg(long, value_name = "LABEL")]
    pub(crate) unit: Option<String>,

    /// Ends nearer than this are one, after scaling [default: 1e-5 of the drawing's size]
    #[arg(long, value_name = "L", value_parser = length, allow_negative_numbers = true)]
    pub(crate) join: Option<f64>,

    /// How far lines and arcs may be from curves and points that they are fitted to, after scaling [default: 1e-4 of the
    /// drawing's size]
    #[arg(long, value_name = "L", value_parser = length, allow_negative_numbers = true)]
    pub(crate) fit: Option<f64>,
}

/// On which side of a curve lines and arcs may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Side {
    /// On both
    Both,
    /// Outside: the part is never smaller than drawn
    Outside,
    /// Inside: the part is never larger than drawn
    Inside,
}

#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Debug, Args)]
pub(crate) struct ManArgs {
    /// The subcommand; without one, the page of `cspace` itself
    #[arg(value_name = "COMMAND")]
    pub(crate) command: Option<String>,
}

fn position(text: &str) -> Result<(f64, f64), String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    (text.split_once(','))
        .and_then(|(x, y)| Some((number(x)?, number(y)?)))
        .ok_or_else(|| "give two numbers with a comma between, such as 10,-2.5".into())
}

/// A finite number of which something is true, or advice.
fn number(text: &str, is_right: impl Fn(f64) -> bool, advice: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    let right = number.filter(|&x| x.is_finite() && is_right(x));
    right.ok_or_else(|| advice.to_owned())
}

fn distance(text: &str) -> Result<f64, String> {
    number(text, |x| x >= 0.0, "give a length, 0 or more")
}

fn length(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "give a positive length")
}

fn energy(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "give a positive energy")
}

fn duration(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "give a positive time in seconds")
}

fn offset(text: &str) -> Result<f64, String> {
    number(
        text,
        |_| true,
        "give a length, below 0 to make parts smaller",
    )
}

fn scale(text: &str) -> Result<f64, String> {
    let is_right = |x| (1e-9..=1e9).contains(&x);
    number(text, is_right, "give a number from 1e-9 to 1e9")
}

fn share(text: &str) -> Result<f64, String> {
    let is_right = |x| (1e-6..=0.5).contains(&x);
    number(text, is_right, "give a number from 1e-6 to 0.5")
}

fn pair_of_numbers(text: &str) -> Result<[f64; 2], String> {
    let numbers: Vec<f64> = (text.split(','))
        .map_while(|t| t.trim().parse().ok().filter(|x: &f64| x.is_finite()))
        .collect();
    match numbers[..] {
        [x, y] if text.matches(',').count() == 1 => Ok([x, y]),
        _ => Err("give two numbers, such as 0,-9810".to_owned()),
    }
}

fn turn(text: &str) -> Result<f64, String> {
    given::angle(text).and_then(|a| {
        if a > 0.0 {
            Ok(a)
        } else {
            Err("give a positive angle".to_owned())
        }
    })
}

fn pick(text: &str) -> Result<Pick, String> {
    let (name, points) = match text.rsplit_once('=') {
        Some((name, points)) if name.trim().is_empty() => {
            return Err(format!("give a name before `={points}`"));
        }
        Some((name, points)) => (Some(name.trim().to_owned()), points),
        None => (None, text),
    };
    let number = |x: &str| x.trim().parse::<f64>().ok().filter(|x| x.is_finite());
    let at = points.split(';').map(|point| {
        let (x, y) = point.split_once(',')?;
        Some(Point::new(number(x)?, number(y)?))
    });
    match at.collect() {
        Some(at) => Ok(Pick { name, at }),
        None => Err("give a point as X,Y, such as 12.5,-3, and several joined by `;`".to_owned()),
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

const INFO: &str = "\
Examples:
  cspace info models/ratchet_pawl.toml
  cspace info models/geneva.toml --json

A model of one part is shown as well; the other commands need two.

The class is what the motions and joints of the model make of a pair: lower,
fixed-axes or general; symmetric is a general pair of which a part is mapped to
itself by a rotation about its centre. Symmetry is found from the outlines.
With --window the class is shown that the pair has in those orientations; pairs
without orientations are shown as they are. Features are lines, arcs and
vertices that are not smooth joints.";

const COMPUTE: &str = "\
Examples:
  cspace compute models/ratchet_pawl.toml
  cspace compute models/ratchet_pawl.toml --window=-10deg,10deg
  cspace compute models/fixture_plate.toml --json
  cspace compute models/ratchet_mechanism.toml --pair driver,link

All pairs of the file are computed, or the one that --pair names. The class in
the result is the method that was used: `lower` for two parts that a joint
connects, whose patches are permanent contacts; `fixed-axes` for two of which
each turns, slides or stands still, in (u, v); `symmetric` if one slab of
orientations was computed and the others are copies; else `general`. `slices`
are the bands that were computed. `cspace info` shows the class of the pair
itself.

--window is for the pairs that have orientations; the others are computed as if
it were not given, and a note on standard error says so. It is an error if
--pair names one of them.

A clearance that is too small counts as none: such a channel is blocked. The
summary says how small.";

const SLICE: &str = "\
Examples:
  cspace slice models/ratchet_pawl.toml --theta 5deg
  cspace slice models/ratchet_mechanism.toml --pair driver,link -o rocking.svg
  cspace slice models/snap_fastener.toml --theta=-0.02 --json
  cspace slice models/ratchet_pawl.toml --theta 0 -o slice.svg

Each loop is one closed piece of the boundary of free space: blocked space on
the left of travel, free space on the right. Features are named by the loop and
vertex of the part as given, counted from 0. At a critical orientation the
slice just above it is shown. A pair with fixed axes has no orientation to
choose: the plane of its two motions (u, v) is shown. -o OUT.svg, .png or .pdf
is a picture, with the parts beside it to scale at the position --at; .dxf the
loops as lines and arcs, .json the answer.";

const PLAN: &str = "\
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

const DISASSEMBLE: &str = "\
Examples:
  cspace disassemble models/latch_box.toml
  cspace disassemble models/latch_box.toml --gap 0.01 --json
  cspace disassemble models/latch_box.toml -o steps.svg
  cspace disassemble models/latch_box.toml -o apart.json
  cspace view models/latch_box.toml --with apart.json

One part, or a group as one, moves at a time, while the others stay. Where none
goes out, one part or two make room first: parts on axes (doors, bolts) along
these, others straight; they stay where they have come to. The tree shows what
comes out of what; a step gives the moving parts and their path: x, y, theta of
these parts from where they are before the step, or what a part on an axis does.
A path ends where a line lies between the parts and the others.

  apart    all comes apart, in the order listed
  locked   some parts do not, however the others move: of two parts one encloses
           the other, by the features listed. That is certain
  unknown  no path was found and none is excluded: the answer gives the extent
           of the search, and the smallest set of which none leaves while the
           others stay

Parts on axes never go out; parts joined by a joint move as one. All parts are
taken to lie in one plane, whichever pairs the model lists. Parts may touch as
drawn: every boundary is moved inward by half of --gap. Parts that overlap by
more are an error.

-o OUT writes the answer as .json, which `cspace view --with OUT.json` plays
with all parts, or a picture with a frame for each step as .svg, .png or .pdf.";

const CHECK: &str = "\
Examples:
  cspace check models/ratchet_pawl.toml
  cspace check models/ratchet_pawl.toml --set tip=50.02
  cspace check models/ratchet_pawl.toml --json

Requirements are [[requirement]] tables of the model: what is measured, and what
it must be. Each is printed with its value, its limits, and what touches there.
The exit code is 1 if one is not met, and 2 if one is not decided or cannot be
measured.
";

const TOLERANCES: &str = "\
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

const SWEEP: &str = "\
Examples:
  cspace sweep models/ratchet_pawl.toml --vary tip=49.9:50.1:5
  cspace sweep models/ratchet_pawl.toml --vary tip=49:50:5 --vary root=43:45:3
  cspace sweep models/ratchet_pawl.toml --rows sizes.csv -o measured.csv

A column for each name and each measure, and the column failure: an empty field
has its reason there. Angles are in radians. -o OUT.csv or .json writes the
table as well, -o OUT.svg, .png or .pdf a curve over what is varied last.
Ctrl-C ends it and keeps the rows that are done.
";

const SOLVE: &str = "\
Examples:
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face = 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 \\
      --so-that \"clear of the face >= 0.04\"
  cspace solve models/ratchet_pawl.toml --vary tip=49.7:50.5 --vary root=43:45 \\
      --so-that \"clear of the face = 0.04\"

Values are exact to some 12 digits of the range. Of one parameter all that were
found are printed; between two of the N values at which is measured, one is
missed if the measure comes near only there and goes away again. Angles are in
radians, unless they have a unit.
";

const MODES: &str = "\
Examples:
  cspace modes models/shift_interlock.toml
  cspace modes models/shift_interlock.toml --at u=8 --json
  cspace modes models/shift_interlock.toml -o modes.svg

Three parts that each turn or slide on an axis have three coordinates u, v, w.
A configuration of all three is free if (u, v), (v, w) and (u, w) are free in
the spaces of their pairs; a pair that the model does not list constrains
nothing. An operating mode is a connected component of the free configurations:
a motion of the three parts leads from one to another if and only if both are
in one mode. Modes are found from the contact curves, not by sampling; openings
of less than 1e-11 of the size are closed, as in the spaces of the pairs.

For each mode: the range of each coordinate, a configuration within it, and the
coordinates that turn for ever in it. Where parts turn for ever together the
answer lists the turns: all motions that end where they began turn the parts by
sums of whole multiples of these.

Other parts of the model are not considered; neither are drives and springs.

-o modes.svg, .png or .pdf is a picture: for each mode a row with the
planes of the three pairs, in which the mode's projection is coloured.
";

const CLEARANCE: &str = "\
Examples:
  cspace clearance models/gears_on_shafts.toml
  cspace clearance models/peg_hole.toml --drawn
  cspace clearance models/ratchet_mechanism.toml --within 2
  cspace simulate models/geneva.toml --time 2 -o run.csv
  cspace clearance models/geneva.toml --along run.csv --json

Every two parts, the worst first. Two that each turn, slide or stand still by
their `motion` are looked at over all motions that their ranges allow: one that
turns and has no range makes whole turns. Their contact space decides, so that
nothing between two poses is missed. Others are looked at as drawn.

  overlaps  as drawn; with the depth: the length of the shortest translation of
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
where it is before. All parts are taken to lie in one plane, whichever pairs
the model lists.

With --along the gap is the minimum over the whole motion, with its time:
between two samples all coordinates are taken to change at constant rates, and
the gap is bounded there, not sampled. Depths are those at the samples.

The exit code is 1 if parts overlap, or if one does not come to both ends of the
range that the model gives it. See docs/clearance.md.";

const SIMULATE: &str = "\
Examples:
  cspace simulate models/geneva.toml --time 2
  cspace simulate models/ratchet_mechanism.toml --time 3 --every 0.01 -o run.csv
  cspace simulate models/gears_on_shafts.toml --time 1 --rates --json
  cspace simulate models/escapement.toml --time 3 -o run.svg

The answer reports whether the motion repeats, what each part does in a cycle,
and how long each contact lasts. -o OUT.csv writes the samples beside it,
-o OUT.svg, .png or .pdf a page: the mechanism at some times, each part's
motion and the contacts over time, the path in the plane of each pair on axes.

The model says what moves it: [[drive]], [[load]] and [[spring]]. In the
kinematic mode drives move slowly, and loads, springs and weights balance at
every instant; other parts go only where contacts push them.

  done          it came to the end
  jammed        what is driven cannot go on: no velocity is allowed by the
                contacts that are listed
  undetermined  how it goes on is not determined, and why

Events are contacts that come (touch) and go (release), ends of ranges that are
reached (limit), and balances that end (snap). Their times do not depend on
--every. The exit code is 1 if it jams, and 2 if it is undetermined.

-o OUT.csv writes the samples: t, then NAME.u of each part that turns or
slides, NAME.x, NAME.y, NAME.theta of others, and with --rates NAME.du or
NAME.vx, NAME.vy, NAME.omega. OUT.json gets the record, which --resume goes on
with and `cspace view --with` plays.";

const PLAY: &str = "\
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

const DRAW: &str = "\
Examples:
  cspace draw models/ratchet_mechanism.toml -o mechanism.svg
  cspace draw models/ratchet_pawl.toml --labels all -o pawl.pdf
  cspace draw models/gears_on_shafts.toml --at 5deg,-7deg -o gears.png

All parts are drawn as they are in the file; with --pair or --at, the two parts
of the pair at the configuration, and the features that touch there are marked
by a point and the normal of the fixed part. A cross with a long and a short
arm is the x and y axis of a part's frame, a ring the pivot of a part that
turns, a double arrow the direction of one that slides. With --labels all
vertices are numbered as in the file, loop and index from 0. Without -o the
picture is SVG on standard output.

FILE may be a drawing too: what of it makes no part is red. An output that ends
in .dxf has the outlines alone, arcs as arcs, each part on a layer of its name;
so has SVG with --outlines.";

const CLASSIFY: &str = "\
Examples:
  printf 'x,y,theta\\n42,56,0\\n' | cspace classify models/ratchet_pawl.toml
  cspace classify latch.toml --columns class,region,distance < rows.csv
  cspace classify latch.toml --columns touching --touch 0.1 < rows.csv

The first row names the columns, in any order: x, y and theta, or, for a pair
with fixed axes, u and v, the motions of the fixed and of the moving part. With
--general such a pair too is asked by x, y and theta, not by u and v. Other
columns are repeated and not looked at. Angles are radians, or have a unit such
as 18deg, and are at most 1e6 rad from 0. The answer repeats the columns and
adds those of --columns, which the input may not have:

  class     free: the interiors of the parts do not meet; blocked: they do;
            contact: within the resolution of the boundary between the two
  region    the number of the free region: 0 for `outside`, 1 for `pocket 1`;
            empty where not free
  distance  how far the moving part moves to the nearest contact: a length at
            that orientation, or, on fixed axes, along or about its axis; 0 in
            contact, empty where blocked or nothing is met
  touching  features no farther apart than --touch, FIXED|MOVING, several
            joined by ;

FILE may be a saved contact space, so that many lists are classified without
computing it again.";

const EXPORT: &str = "\
Examples:
  cspace export models/ratchet_pawl.toml -o pawl.json
  cspace export models/ratchet_pawl.toml -o pawl.svg --slices 20
  cspace export models/snap_fastener.toml -o snap.ply --tolerance 1e-4
  cspace export models/ball_in_c.toml -o ball.stl
  cspace export models/knee.toml -o knee.glb
  cspace export pawl.json -o pawl.obj
  cspace export models/gears.toml -o gears.html

Formats, by the extension of OUT:
  .json   the whole configuration space; every command reads it in place of a
          model. The schemas are docs/contact-space.schema.json,
          docs/fixed-axes-space.schema.json and docs/lower-pair.schema.json.
          The model's `name` and `unit` are written with it
  .html   one page to look at and drag, with all pairs or that of --pair, which
          works without a network; --with adds what `cspace plan`, `disassemble`
          or `simulate` wrote with -o OUT.json, to be played
  .svg, .png, .pdf
          pictures of slices at even steps of orientation, free regions
          numbered, blocked space grey; of a pair with fixed axes of the plane
          of its two motions
  .ply    the contact surface as triangles: vertices (x, y, theta) on the exact
          surface, in double precision; triangles are counter-clockwise seen
          from free space and carry their `patch`
  .obj    the same as text, the triangles of a patch in a group, such as
          patch_7
  .stl    the same as loose triangles, in single precision, which is all the
          format has
  .glb    binary glTF 2.0: positions (x, y, theta) in single precision, which
          is all the format has; the attribute `_PATCH` of a triangle's
          vertices is its patch";

const VIEW: &str = "\
Examples:
  cspace view latch.toml
  cspace view models/ratchet_mechanism.toml --pair ratchet,pawl
  cspace view models/geneva.toml --with run.json --port 8080 --no-open
  cspace view plate.dxf

The page shows the parts to scale, and beside them the contact space in x, y
and theta, or the plane of two motions; drag either, and the other follows. It
is served on this machine alone, at an address that is printed first and that
nobody can guess; whoever has it may look. Pairs are computed when they are
looked at. Parts can be edited: the space is computed again while they are
dragged, and the edited model is saved by the browser; FILE stays as it is.

Of a drawing the page shows the faces, which all lines, arcs and curves enclose
together: a click makes a part of a face, Shift-click adds faces to it. The
model is saved by the browser, or its contact spaces are shown at once. The
options for drawings are those of `cspace import`. A model or a drawing that is
dropped onto the page is opened in it, also in a page that was exported.

--with has what `cspace plan`, `cspace disassemble` or `cspace simulate` wrote
with -o OUT.json.
Ctrl-C ends it. `cspace export FILE -o OUT.html` writes the page as a file.";

const MAN: &str = "\
Example:
  mkdir -p ~/.local/share/man/man1
  cspace man > ~/.local/share/man/man1/cspace.1
  cspace man compute > ~/.local/share/man/man1/cspace-compute.1
  man cspace-compute";

const NEW: &str = "\
Examples:
  cspace new latch -o latch.toml
  cspace new peg --set diameter=12 --set clearance=0.05 -o peg.toml
  cspace new gears --set gear=30 --set pinion=18 --set pressure=20deg

The model is TOML with comments. Its dimensions are parameters, in mm or any
other unit: change `unit` in the file. --set changes their values in what is
written. The comment at the top says what the parts do at which configuration.
See docs/model.md for how a model is written.

Parameters, with their values:
";

const IMPORT: &str = "\
Examples:
  cspace import plate.dxf -o plate.toml
  cspace import pawl.dxf wheel.svg --unit mm -o ratchet.toml
  cspace import gear.dxf --layer OUTLINE --layer HOLES --part gear -o gear.toml
  cspace import scan.csv --fit 0.02 -o profile.toml
  cspace import traced.dxf --trace --fit 0.02 -o gear.toml

Every outermost loop with the holes in it is a part, called as its block, its
layer or its file. Loose lines and arcs are joined where their ends meet, what
is drawn twice is taken once, splines, ellipses and points become tangent lines
and arcs. What was made, left out, joined and fitted is printed; what cannot be
used is an error that names it, or with --partial is left out and listed.
Without -o nothing is written. A model may name a drawing as well: dxf =
\"plate.dxf\" in place of loops. See docs/drawings.md.";

const COMPLETIONS: &str = "\
Example:
  cspace completions bash > ~/.local/share/bash-completion/completions/cspace";
