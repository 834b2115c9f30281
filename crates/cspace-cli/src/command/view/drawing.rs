//! The page of a drawing: its faces, to make parts of those that are picked.

use std::path::Path;

use cspace_scene::OpenedDrawing;
use cspace_view::{Pages, ServeError, Server};

use crate::args::ViewArgs;
use crate::command::page;
use crate::drawing;
use crate::failure::Failure;
use crate::traces::quoted;

/// A server of the drawing.
pub(super) fn server(args: &ViewArgs, path: &Path) -> Result<Server, Failure> {
    refuse_options_of_models(args)?;
    let pages = page::bundled(Pages::bundled())?;
    let options = &args.drawing;
    drawing::check_options(options, std::iter::once(path))?;
    let drawn = drawing::read(options, path)?;
    let unit = drawing::of_model(options, std::slice::from_ref(&drawn))?;
    let scale = drawing::factor(options, path, &drawn, unit.as_deref());
    let opened = OpenedDrawing {
        name: drawing::name(path),
        unit,
        settings: drawing::settings(options, scale),
        command: format!(
            "cspace import {}{}",
            quoted(path),
            drawing::options(options)
        ),
        drawing: drawn,
    };
    Server::bind_drawing(opened, pages, args.port).map_err(|error| match error {
        ServeError::Drawing(error) => {
            Failure::input(format_args!("{}: {error}", path.display())).help(error.help())
        }
        error => super::failure(error),
    })
}

fn refuse_options_of_models(args: &ViewArgs) -> Result<(), Failure> {
    let given = [
        ("--pair", args.pair.is_some()),
        ("--theta", args.window.theta.is_some()),
        ("--with", !args.with.is_empty()),
        ("--general", args.general),
        ("--snap", args.snap),
        ("--set", !args.values.set.is_empty()),
    ];
    match given.into_iter().find(|(_, is_given)| *is_given) {
        None => Ok(()),
        Some((option, _)) => Err(Failure::input(format_args!(
            "{option} is about models, and {} is a drawing",
            args.file.display()
        ))
        .help("make a model of it on the page, or with `cspace import`")),
    }
}
