//! Outlines alone, as DXF or SVG.

use std::path::Path;

use cspace_drawing::{Drawn, DxfVersion, Unit};

use super::{DrawArgs, as_drawn, assembly, at_configuration, at_height};
use crate::args::DxfChoice;
use crate::ask;
use crate::failure::Failure;
use crate::output;
use cspace_api::Subject;

/// Whether a file's name asks for DXF.
pub(crate) fn is_dxf(path: Option<&Path>) -> bool {
    path.is_some_and(|path| output::ends_in(path, "dxf"))
}

/// Refuses a version of DXF where none is written.
pub(crate) fn check_version(dxf: Option<DxfChoice>, path: Option<&Path>) -> Result<(), Failure> {
    if dxf.is_none() || is_dxf(path) {
        return Ok(());
    }
    Err(Failure::new("--dxf is about DXF").help("let the name after -o end in .dxf"))
}

/// Writes outlines as the file's name says.
pub(crate) fn write(
    path: Option<&Path>,
    drawn: &[Drawn],
    unit: Option<&str>,
    version: Option<DxfChoice>,
) -> Result<(), Failure> {
    let unit = unit.and_then(Unit::of_label);
    let text = if is_dxf(path) {
        let version = match version {
            Some(DxfChoice::R12) => DxfVersion::R12,
            Some(DxfChoice::R2000) | None => DxfVersion::R2000,
        };
        cspace_drawing::dxf(drawn, unit, version)
    } else {
        cspace_drawing::svg(drawn, unit)
    };
    output::write(path, text.as_bytes())
}

/// Writes the parts of a model, or a pair at a configuration, and gives the unit of length.
pub(super) fn of_model(args: &DrawArgs) -> Result<Option<String>, Failure> {
    let common = &args.common;
    let output = common.result.output.as_deref();
    if let Some(option) = args.picture.given() {
        return Err(Failure::new(format_args!("{option} is about pictures"))
            .help("outlines are written to scale: leave the option out"));
    }
    let (subject, host) = ask::open(common)?;
    let pair;
    let mut picture = match &subject {
        Subject::Model(file) if args.named.pair.is_none() && args.at.is_none() => {
            assembly(&file.model.mechanism)
        }
        _ => {
            pair = subject.one_pair(&args.named.clone().into(), &host)?;
            let at = match &args.at {
                Some(at) => pair.coordinates("at", at)?,
                None => as_drawn(&pair),
            };
            at_configuration(&pair, at)
        }
    };
    at_height(&mut picture, args.height, subject.unit())?;
    let drawn: Vec<Drawn> = (picture.parts.iter())
        .flat_map(|p| {
            let layers = p.part.layers().iter().zip(Drawn::part(p.part));
            let there = layers.filter(|(l, _)| args.height.is_none_or(|z| l.is_at(z)));
            there.map(|(_, drawn)| drawn.moved(p.assembly_from_part))
        })
        .collect();
    write(output, &drawn, subject.unit(), args.dxf)?;
    Ok(subject.unit().map(str::to_owned))
}
