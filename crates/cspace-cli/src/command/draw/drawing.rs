//! A picture of a drawing: the parts it makes, and in red what it does not.

use std::path::Path;

use cspace::{Configuration, Point};
use cspace_draw::{PartsPicture, PictureFormat, PlacedPart, UnusedPath, parts};
use cspace_drawing::{Entity, Piece, Settings, Source};

use super::DrawArgs;
use crate::failure::{Failure, warning};
use crate::input;
use crate::picture::{self, Plane};
use crate::wording::count;

/// Writes the picture, and gives the unit of length.
pub(super) fn run(args: &DrawArgs, format: PictureFormat) -> Result<Option<String>, Failure> {
    let file: &Path = &args.common.file;
    let refused = |option: &str| {
        Err::<Option<String>, Failure>(
            Failure::new(format_args!(
                "{option} is about models, and this is a drawing"
            ))
            .help("make a model of it with `cspace import`"),
        )
    };
    if args.at.is_some() {
        return refused("--at");
    }
    if args.named.pair.is_some() {
        return refused("--pair");
    }
    let failed = |e: cspace_drawing::DrawingError| {
        Failure::new(format_args!("{}: {e}", file.display())).help(e.help())
    };
    let drawing = input::drawing(file, &Source::default())?.map_err(failed)?;
    let settings = Settings::default();
    let survey = (drawing.reading(&settings))
        .and_then(|reading| reading.survey())
        .map_err(failed)?;
    if let [first, ..] = &survey.problems[..] {
        warning(
            format_args!(
                "{}: {} cannot be used, the first: {first}",
                file.display(),
                count(survey.problems.len(), "thing", "things")
            ),
            "`cspace import` lists all of them",
        );
    }
    let picture = PartsPicture {
        parts: (survey.parts.iter().enumerate())
            .map(|(number, part)| PlacedPart {
                part,
                assembly_from_part: Configuration::default(),
                axis: None,
                number,
            })
            .collect(),
        unused: survey.unused.iter().map(unused).collect(),
        faults: (survey.problems.iter())
            .flat_map(|p| {
                [p.at, p.to]
                    .into_iter()
                    .flatten()
                    .map(|at| (at, p.reason.clone()))
            })
            .collect(),
        is_drawing: true,
        ..PartsPicture::default()
    };
    let unit = drawing.unit.map(|u| u.label());
    let options = (args.picture).options(Plane::Positions, drawing.name.clone(), unit)?;
    picture::write(
        args.common.result.output.as_deref(),
        format,
        &parts(&picture, &options),
    )?;
    Ok(unit.map(str::to_owned))
}

/// The path of an entity, with curves as chords so short that a picture shows no difference.
fn unused(entity: &Entity) -> UnusedPath {
    const CHORDS: u32 = 24;
    let mut edges: Vec<(Point, f64)> = Vec::new();
    for piece in &entity.path.pieces {
        match piece {
            Piece::Edge { to, bulge } => edges.push((*to, *bulge)),
            Piece::Curve(curve) => {
                for span in 0..curve.spans() {
                    let share = |k: u32| f64::from(k) / f64::from(CHORDS);
                    edges.extend((1..=CHORDS).map(|k| (curve.at(span, share(k)).0, 0.0)));
                }
            }
        }
    }
    UnusedPath {
        start: entity.path.start,
        edges,
        label: entity.origin.to_string(),
    }
}
