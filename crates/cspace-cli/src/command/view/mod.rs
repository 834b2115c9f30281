//! `cspace view`.

mod drawing;

use super::page;
use crate::args::ViewArgs;
use crate::ask;
use crate::drawing as drawings;
use crate::failure::{Failure, note};
use crate::interrupt::until_interrupted;
use crate::output;
use crate::view::{Page, ServeError, Server};

pub(crate) fn run(args: &ViewArgs) -> Result<(), Failure> {
    if cspace_drawing::is_drawing(&args.file) {
        return show(drawing::server(args, &args.file)?, args);
    }
    if let Some(option) = drawings::first_given(&args.drawing) {
        return Err(
            Failure::new(format_args!("{option} is about drawings")).help(format_args!(
                "leave {option} out: {} is a model",
                args.file.display()
            )),
        );
    }
    let page = page::bundled(Page::bundled())?;
    let common = args.common();
    let (subject, host) = ask::open(&common)?;
    subject.warn(&host);
    let chosen = subject.pairs(&ask::which(&common, args.window.window), &host)?;
    if args.pair.is_some() {
        for pair in &chosen {
            pair.check_window()?;
        }
    }
    let entries = page::entries(&chosen);
    let mut opened = page::opened(subject, entries, &common)?;
    opened.records = page::records(&args.with, &opened)?;
    show(
        Server::bind(opened, &page, args.port).map_err(failure)?,
        args,
    )
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
