//! Output to the terminal. A closed stream ends no thread.

use std::any::Any;
use std::fmt::Display;
use std::io::{ErrorKind, Write};

/// Prints to standard output. Its reader may close it early, as `head` does.
///
/// # Errors
/// If writing fails for another reason.
pub fn print(text: &str) -> Result<(), String> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != ErrorKind::BrokenPipe => Err(format!("standard output: {e}")),
        _ => Ok(()),
    }
}

/// A line on standard error. Where nobody listens nothing can be done.
pub fn note(line: impl Display) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Message of a panic.
pub fn panic_text(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("of no text")
}
