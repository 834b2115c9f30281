//! A picture of an assembly that comes apart: as drawn, then each step with the sweep of what moves.

use cspace::{Configuration, Coordinates};
use cspace_draw::{FramesPicture, PartsPicture, PictureFormat, PlacedPart, frames};
use cspace_model::Mechanism;
use cspace_plan::assembly::{Kind, Step, TakenApart};

use super::DisassembleArgs;
use crate::command::plan::picture::steps as along;
use crate::failure::Failure;
use crate::picture::{self, Plane};

pub(super) fn write(
    args: &DisassembleArgs,
    model: &Mechanism,
    apart: &TakenApart,
    format: PictureFormat,
) -> Result<(), Failure> {
    let mut at = vec![Configuration::default(); model.parts.len()];
    let all: Vec<usize> = (0..at.len()).collect();
    let mut shown = FramesPicture {
        frames: vec![("as drawn".to_owned(), placed(model, &at, &all))],
    };
    for (i, step) in apart.steps.iter().enumerate() {
        shown.frames.push(frame(model, &mut at, i + 1, step));
    }
    let unit = model.unit.as_deref();
    let options = (args.picture).options(Plane::Positions, model.name.clone(), unit)?;
    let output = args.result.output.as_deref();
    picture::write(output, format, &frames(&shown, &options))
}

/// Parts where they are.
fn placed<'a>(model: &'a Mechanism, at: &[Configuration], parts: &[usize]) -> PartsPicture<'a> {
    PartsPicture {
        parts: parts.iter().map(|&i| part(model, i, at[i])).collect(),
        without_origins: true,
        ..PartsPicture::default()
    }
}

fn part(model: &Mechanism, number: usize, at: Configuration) -> PlacedPart<'_> {
    PlacedPart {
        part: &model.parts[number].part,
        assembly_from_part: at,
        axis: model.parts[number].axis,
        number,
    }
}

/// The picture of a step: the parts that stay, and those that move, at the end of the step and along the path. Parts that move aside keep
/// their new configuration in later pictures; parts that leave keep the old one, so that later steps that take them apart are drawn there.
fn frame<'a>(
    model: &'a Mechanism,
    at: &mut [Configuration],
    number: usize,
    step: &Step,
) -> (String, PartsPicture<'a>) {
    let axis = step.moving.first().and_then(|&i| model.parts[i].axis);
    let place = |c: Coordinates, before: Configuration| step.placed(c, axis, before);
    let mut picture = placed(model, at, &step.staying);
    let parts: Vec<_> = model.parts.iter().map(|p| p.part.clone()).collect();
    if let Some(scene) = step.scene(&parts, model) {
        for c in along(&scene, &step.path.configurations) {
            (picture.swept).extend(step.moving.iter().map(|&i| part(model, i, place(c, at[i]))));
        }
    }
    if let Some(&last) = step.path.configurations.last() {
        (picture.parts).extend(
            step.moving
                .iter()
                .map(|&i| part(model, i, place(last, at[i]))),
        );
        if step.kind == Kind::Moves {
            for &i in &step.moving {
                at[i] = place(last, at[i]);
            }
        }
    }
    let names: Vec<&str> = step
        .moving
        .iter()
        .map(|&i| model.parts[i].part.name())
        .collect();
    let does = match step.kind {
        Kind::Leaves => "out",
        Kind::Moves => "aside",
    };
    (format!("{number}. {} {does}", names.join(", ")), picture)
}
