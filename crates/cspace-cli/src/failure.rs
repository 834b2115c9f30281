//! Why a command ends without having done its work.

use std::borrow::Cow;
use std::fmt::Display;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use anstyle::AnsiColor;
use cspace_io::{ModelError, shown};

/// An error of a command: its exit code, its message, and how to fix it.
#[derive(Debug)]
pub(crate) struct Failure {
    code: u8,
    message: String,
    help: Option<String>,
}

impl Failure {
    /// The input or the usage is wrong: exit code 2.
    pub(crate) fn input(message: impl Display) -> Self {
        Self {
            code: 2,
            message: message.to_string(),
            help: None,
        }
    }

    /// The work could not be done: exit code 1.
    pub(crate) fn work(message: impl Display) -> Self {
        Self {
            code: 1,
            message: message.to_string(),
            help: None,
        }
    }

    /// The question was not answered: exit code 2.
    pub(crate) fn unanswered(message: impl Display) -> Self {
        Self::input(message)
    }

    /// Says what to do.
    #[must_use]
    pub(crate) fn help(mut self, help: impl Display) -> Self {
        self.help = Some(help.to_string());
        self
    }

    /// A file cannot be written.
    pub(crate) fn writing(path: &Path, error: &std::io::Error) -> Self {
        Self::work(format_args!(
            "{}: cannot be written: {error}",
            path.display()
        ))
        .help("choose another place with -o; nothing was written")
    }

    /// Whether it is reported rather than another one: bad input comes before work that could not be done.
    pub(crate) fn is_worse_than(&self, other: &Self) -> bool {
        self.code > other.code
    }

    /// The message, without the help.
    pub(crate) fn message(&self) -> &str {
        &self.message
    }

    /// Says it on stderr as a warning: the rest of the work is done all the same.
    pub(crate) fn warn(&self) {
        if !is_quiet() {
            say(
                "warning",
                AnsiColor::Yellow,
                &self.message,
                self.help.as_deref(),
            );
        }
    }

    /// This failure without message and help, for one that has been printed already.
    pub(crate) fn said(self) -> Self {
        Self {
            message: String::new(),
            help: None,
            ..self
        }
    }

    pub(crate) const fn code(&self) -> u8 {
        self.code
    }

    /// Prints to stderr, control characters escaped. Where nobody listens nothing can be done.
    pub(crate) fn print(&self) {
        // An empty one has been said.
        if !self.message.is_empty() {
            say("error", AnsiColor::Red, &self.message, self.help.as_deref());
        }
    }
}

/// Prints an entry of a list to stderr, below a message that it belongs to.
pub(crate) fn list(entry: impl Display) {
    let _ = writeln!(
        anstream::stderr().lock(),
        "  {}",
        harmless(&entry.to_string())
    );
}

/// Whether nothing but errors is said.
static QUIET: AtomicBool = AtomicBool::new(false);

/// Lets notes, warnings and progress be silent.
pub(crate) fn set_quiet(quiet: bool) {
    QUIET.store(quiet, Ordering::Relaxed);
}

/// Whether they are.
pub(crate) fn is_quiet() -> bool {
    QUIET.load(Ordering::Relaxed)
}

/// A message on stderr and what to do about it.
fn say(kind: &str, colour: AnsiColor, message: &str, help: Option<&str>) {
    let (kind_style, help_style) = (colour.on_default().bold(), AnsiColor::Cyan.on_default());
    let mut err = anstream::stderr().lock();
    let message = harmless(message);
    let _ = writeln!(err, "{kind_style}{kind}:{kind_style:#} {message}");
    if let Some(help) = help {
        let help = harmless(help);
        let _ = writeln!(err, "  {help_style}help:{help_style:#} {help}");
    }
}

/// Says on stderr what a user should know of work that is done all the same.
pub(crate) fn note(message: impl Display) {
    if !is_quiet() {
        say("note", AnsiColor::Blue, &message.to_string(), None);
    }
}

/// Says on stderr what is most likely a slip, and what to do about it.
pub(crate) fn warning(message: impl Display, help: impl Display) {
    if !is_quiet() {
        let help = help.to_string();
        say(
            "warning",
            AnsiColor::Yellow,
            &message.to_string(),
            Some(&help),
        );
    }
}

/// Nobody reads more characters than that. Names may be as long as files.
const LONGEST: usize = 10_000;

/// The text with its control characters escaped, and its beginning if it is enormous.
fn harmless(message: &str) -> Cow<'_, str> {
    match message.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", shown::text(&message[..end])).into(),
        None => shown::text(message),
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        Self {
            help: error.help().map(str::to_owned),
            ..Self::input(error)
        }
    }
}
