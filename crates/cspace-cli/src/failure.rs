//! Why a command ends without having done its work.

use std::borrow::Cow;
use std::fmt::Display;
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use anstyle::AnsiColor;
use cspace_api::error::Failed;
use cspace_api::{Error, Is};
use cspace_model::{ModelError, shown};

/// Exit code of a question that was answered with no.
const NO: u8 = 1;
/// Exit code of a question that was not answered.
pub(crate) const UNANSWERED: u8 = 2;

/// An error of a command: its exit code, its message, and how to fix it.
#[derive(Debug)]
pub(crate) struct Failure {
    code: u8,
    error: Error,
}

impl Failure {
    /// The question was not answered, because the input or the usage is wrong, or the work could not be done: exit code 2.
    pub(crate) fn new(message: impl Display) -> Self {
        Error::new(message).into()
    }

    /// The exit code of an answer that is printed: an error only if that is no or open.
    pub(crate) fn of(outcome: Is) -> Result<(), Self> {
        let code = match outcome {
            Is::Yes => return Ok(()),
            Is::No => NO,
            Is::Open => UNANSWERED,
        };
        Err(Self {
            code,
            ..Self::new("")
        })
    }

    /// Says what to do.
    #[must_use]
    pub(crate) fn help(mut self, help: impl Display) -> Self {
        self.error = self.error.help(help);
        self
    }

    /// A file cannot be written.
    pub(crate) fn writing(path: &Path, error: &std::io::Error) -> Self {
        Self::new(format_args!(
            "{}: cannot be written: {error}",
            path.display()
        ))
        .help("choose another place with -o; nothing was written")
    }

    /// Says it on stderr as a warning: the rest of the work is done all the same.
    pub(crate) fn warn(&self) {
        if !is_quiet() {
            say(
                "warning",
                AnsiColor::Yellow,
                &self.error.message,
                self.error.help.as_deref(),
            );
        }
    }

    /// The error alone.
    pub(crate) fn into_error(self) -> Error {
        self.error
    }

    pub(crate) const fn code(&self) -> u8 {
        self.code
    }

    /// Prints to stderr, control characters escaped. Where nobody listens nothing can be done.
    pub(crate) fn print(&self) {
        // An empty one has been said, or is an answer.
        if self.error.message.is_empty() {
            return;
        }
        self.print_beside();
        self.tell();
    }

    /// Prints to stderr alone.
    pub(crate) fn print_beside(&self) {
        say(
            "error",
            AnsiColor::Red,
            &self.error.message,
            self.error.help.as_deref(),
        );
    }

    /// The error.
    pub(crate) fn error(&self) -> &Error {
        &self.error
    }

    /// Prints it as JSON, where that is asked for and no answer is printed.
    fn tell(&self) {
        if !JSON.load(Ordering::Relaxed) || ANSWERED.load(Ordering::Relaxed) {
            return;
        }
        let error = &self.error;
        // Where nobody listens nothing can be done.
        if let Ok(told) = serde_json::to_string_pretty(&Failed { error }) {
            let mut out = std::io::stdout().lock();
            let _ = writeln!(out, "{told}").and_then(|()| out.flush());
        }
    }
}

/// Tells as JSON what is wrong with the command line, where JSON is asked for.
pub(crate) fn tell(message: &str) {
    let message = message.strip_prefix("error: ").unwrap_or(message);
    let (message, advice) = message.split_once("\n\n").unwrap_or((message, ""));
    // A tip if there is one, and how the command is used.
    Failure::new(message.trim_end()).help(advice.trim()).tell();
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

/// Whether an error is told as JSON, too.
static JSON: AtomicBool = AtomicBool::new(false);

/// Whether something was printed to standard output.
static ANSWERED: AtomicBool = AtomicBool::new(false);

/// Notes that something is printed to standard output, where errors are no longer told then.
pub(crate) fn set_answered() {
    ANSWERED.store(true, Ordering::Relaxed);
}

/// Lets errors be told as JSON on standard output as well, where no answer is.
pub(crate) fn set_json(json: bool) {
    JSON.store(json, Ordering::Relaxed);
}

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

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self {
            code: UNANSWERED,
            error,
        }
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        Error::from(error).into()
    }
}
