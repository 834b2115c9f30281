//! `cspace view`.

mod drawing;

use std::path::{Path, PathBuf};

use clap::Args;
use cspace_api::Which;
use cspace_api::import::Finding;
use cspace_api::scene::Opened;

use super::page;
use crate::args::{CacheArgs, Common, ResultArgs, SetArgs, SourceArgs, ThreadsArg};
use crate::ask;
use crate::drawing as drawings;
use crate::failure::{Failure, note};
use crate::interrupt::until_interrupted;
use crate::output;
use crate::view::{Page, ServeError, Server};

const HELP: &str = "\
Examples:
  cspace view latch.toml
  cspace view models/ratchet_mechanism.toml --pair ratchet,pawl
  cspace view models/geneva.toml --with run.json --port 8080 --no-open
  cspace view plate.dxf
  cspace view

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

Without FILE the page has a model without parts, to which they are added there;
its New has the models of `cspace new`, too.

--with has what `cspace plan`, `cspace disassemble` or `cspace simulate` wrote
with -o OUT.json.
Ctrl-C ends it. `cspace export FILE -o OUT.html` writes the page as a file.";

/// Arguments of `cspace view`.
#[derive(Debug, Args)]
#[command(after_long_help = HELP)]
pub(crate) struct ViewArgs {
    /// A model (.toml, .json), a contact space saved by `cspace export FILE -o OUT.json`, or a drawing (.dxf, .svg), whose faces are
    /// picked as parts; - is a model on standard input. Without it a model is made from nothing
    pub(crate) file: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) values: SetArgs,

    #[command(flatten)]
    pub(crate) which: Which,

    /// An answer of `cspace plan`, `disassemble` or `simulate` in JSON, to be played; may be given several times
    #[arg(long, value_name = "RECORD.json")]
    pub(crate) with: Vec<PathBuf>,

    #[command(flatten)]
    pub(crate) source: SourceArgs,

    #[command(flatten)]
    pub(crate) finding: Finding,

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

    /// Make lines and arcs tangent that miss tangency by less than 0.001 rad; a note reports how far points were moved
    #[arg(long, hide_short_help = true)]
    pub(crate) snap: bool,

    #[command(flatten)]
    pub(crate) cache: CacheArgs,

    #[command(flatten)]
    pub(crate) threads: ThreadsArg,
}

impl ViewArgs {
    /// The options that it shares with the other commands that take a file; the others have their defaults.
    fn common(&self, file: &Path) -> Common {
        Common {
            file: file.to_owned(),
            values: self.values.clone(),
            snap: self.snap,
            result: ResultArgs::default(),
            cache: self.cache,
            threads: self.threads,
        }
    }

    /// The first option that was given and is about models.
    fn first_of_models(&self) -> Option<&'static str> {
        let given = [
            ("--pair", self.which.named.pair.is_some()),
            ("--window", self.which.window.is_some()),
            ("--with", !self.with.is_empty()),
            ("--general", self.which.named.general),
            ("--snap", self.snap),
            ("--set", !self.values.set.is_empty()),
        ];
        let found = given.into_iter().find(|(_, is_given)| *is_given);
        found.map(|(option, _)| option)
    }
}

pub(crate) fn run(args: &ViewArgs) -> Result<(), Failure> {
    let of_drawings = drawings::first_given(&args.source, &args.finding);
    let Some(file) = &args.file else {
        let option = of_drawings.or(args.first_of_models().map(str::to_owned));
        return match option {
            Some(option) => Err(Failure::new(format_args!("{option} is about a file"))
                .help(format_args!("name the file, or leave {option} out"))),
            None => serve(Opened::blank("new model", Some("mm".to_owned())), args),
        };
    };
    if cspace_drawing::is_drawing(file) {
        return show(drawing::server(args, file)?, args);
    }
    if let Some(option) = of_drawings {
        let file = file.display();
        return Err(Failure::new(format_args!("{option} is about drawings"))
            .help(format_args!("leave {option} out: {file} is a model")));
    }
    let common = args.common(file);
    let (subject, host) = ask::open(&common)?;
    subject.warn(&host);
    let chosen = subject.pairs(&args.which, &host)?;
    if args.which.named.pair.is_some() {
        for pair in &chosen {
            pair.check_window()?;
        }
    }
    let entries = page::entries(&chosen);
    let mut opened = page::opened(subject, entries, (&common, &args.which))?;
    opened.records = page::records(&args.with, &opened)?;
    serve(opened, args)
}

fn serve(opened: Opened, args: &ViewArgs) -> Result<(), Failure> {
    let page = page::bundled(Page::bundled())?;
    let server = Server::bind(opened, &page, args.port).map_err(failure)?;
    show(server, args)
}

/// Serves until the process ends, in a browser where there is one.
fn show(server: Server, args: &ViewArgs) -> Result<(), Failure> {
    let url = server.url();
    output::write(None, format!("{url}\n").as_bytes())?;
    until_interrupted();
    if args.no_open {
        note("Ctrl-C ends it");
    } else if !has_display() {
        note("there is no display to open a browser on; Ctrl-C ends it");
    } else {
        match open::that_detached(&url) {
            Ok(()) => note("opened in the browser; Ctrl-C ends it"),
            Err(error) => note(format_args!(
                "no browser could be opened ({error}); Ctrl-C ends it"
            )),
        }
    }
    match server.run().map_err(failure)? {}
}

fn failure(error: ServeError) -> Failure {
    let failure = Failure::new(&error);
    match error {
        ServeError::PortInUse { .. } | ServeError::Port { .. } => {
            failure.help("give another --port, or leave it out for any that is free")
        }
        _ => failure,
    }
}

/// Whether a browser has somewhere to show itself.
#[cfg(all(unix, not(target_os = "macos")))]
fn has_display() -> bool {
    // Under WSL the browser is that of Windows.
    ["DISPLAY", "WAYLAND_DISPLAY", "WSL_DISTRO_NAME"]
        .iter()
        .any(|name| std::env::var_os(name).is_some_and(|v| !v.is_empty()))
}

#[cfg(not(all(unix, not(target_os = "macos"))))]
fn has_display() -> bool {
    true
}
