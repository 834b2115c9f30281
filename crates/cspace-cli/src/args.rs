//! Options that several commands have.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use cspace_api::given;
use cspace_model::model::Setting;

use crate::failure::Failure;

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
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = given::whole::<u16>(0..=1024), allow_negative_numbers = true, hide_short_help = true)]
    pub(crate) threads: u16,
}

/// Arguments common to the commands that take a file.
#[derive(Debug, Clone, Args)]
pub(crate) struct Common {
    /// A model (.toml, .json), or a contact space saved by `cspace export FILE -o OUT.json`; - is standard input
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) values: SetArgs,

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

/// Versions of DXF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum DxfChoice {
    /// R12, which every program reads
    R12,
    /// R2000
    R2000,
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

/// Choice of what is read of drawings.
#[derive(Debug, Clone, Args)]
pub(crate) struct SourceArgs {
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

    /// Take the outlines of hatches too (DXF)
    #[arg(long)]
    pub(crate) hatches: bool,
}
