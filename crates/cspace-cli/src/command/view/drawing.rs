//! The page of a drawing: its faces, to make parts of those that are picked.

use std::path::Path;

use cspace_api::scene::{DrawingSource, OpenedDrawing, model_name};

use super::ViewArgs;
use crate::ask::Terminal;
use crate::command::page;
use crate::drawing;
use crate::failure::Failure;
use crate::traces::quoted;
use crate::view::{Page, Server};

/// A server of the drawing.
pub(super) fn server(args: &ViewArgs, path: &Path) -> Result<Server, Failure> {
    if let Some(option) = args.first_of_models() {
        let file = path.display();
        let wrong = Failure::new(format_args!(
            "{option} is about models, and {file} is a drawing"
        ));
        return Err(wrong.help("make a model of it on the page, or with `cspace import`"));
    }
    let page = page::bundled(Page::bundled())?;
    let (options, finding) = (&args.source, &args.finding);
    drawing::check_options(options, std::iter::once(path))?;
    let (drawn, data) = drawing::read_with_bytes(options, path)?;
    let (lengths, host) = (&finding.lengths, Terminal::default());
    let unit = lengths.unit([&drawn], &host)?;
    let opened = OpenedDrawing {
        source: DrawingSource {
            file: path.to_string_lossy().into_owned(),
            data,
            name: model_name(path),
            command: format!(
                "cspace import {}{}",
                quoted(path),
                drawing::options(options, finding)
            ),
            layers: options.layer.clone(),
            ids: options.id.clone(),
            colors: options.colors.iter().map(ToString::to_string).collect(),
            linetypes: options.linetype.clone(),
            without_sheet: finding.without_sheet,
            hatches: options.hatches,
            scale: lengths.factor(path, &drawn, unit.as_deref(), &host),
            join: finding.join,
            fit: finding.fit,
            unit,
        },
        drawing: drawn,
    };
    let scene = opened.scene().map_err(|e| drawing::failed(path, &e))?;
    Server::bind_drawing(&scene, &page, args.port).map_err(super::failure)
}
