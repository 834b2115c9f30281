//! A picture of the tightest places: a frame for each pair, the worst first, with the two parts where they are nearest.

use cspace::{Configuration, Coordinates, Point};
use cspace_api::clearance::{At, Clearance, Clearances, Outcome};
use cspace_api::{Outcome as _, PairAnswer};
use cspace_draw::{FramesPicture, PartsPicture, PictureFormat, PlacedPart, frames};
use cspace_model::Mechanism;

use super::ClearanceArgs;
use crate::failure::Failure;
use crate::picture::{self, Plane};
use crate::wording::length;

/// Pairs that are drawn: of more the first are.
const MOST: usize = 12;

pub(super) fn write(
    args: &ClearanceArgs,
    model: &Mechanism,
    found: &Clearances,
    format: PictureFormat,
) -> Result<(), Failure> {
    let pairs = found.pairs.iter().filter(|p| p.outcome != Outcome::Joined);
    let shown = FramesPicture {
        frames: pairs.filter_map(|p| frame(model, p)).take(MOST).collect(),
    };
    if shown.frames.is_empty() {
        return Err(
            Failure::new("-o: no pair of parts is listed, so there is no place to draw")
                .help("give a larger --within, or leave -o out"),
        );
    }
    let unit = model.unit.as_deref();
    let options = (args.picture).options(Plane::Positions, model.name.clone(), unit)?;
    picture::write(
        args.result.output.as_deref(),
        format,
        &frames(&shown, &options),
    )
}

/// The two parts of a pair where they are nearest, or where the first of them is stopped, with their nearest points marked.
fn frame<'a>(
    model: &'a Mechanism,
    pair: &PairAnswer<Clearance>,
) -> Option<(String, PartsPicture<'a>)> {
    let content = &pair.content;
    let at = match (content.stopped.first(), content.at) {
        (Some(stop), _) => Some(stop.at),
        (None, Some(At::Place(at))) => Some(at),
        (None, _) => None,
    };
    let motions = match at {
        Some(Coordinates::Axes { u, v }) => [u, v],
        _ => [0.0, 0.0],
    };
    let names = [&pair.fixed, &pair.moving];
    let part = |k: usize| {
        let named = |entry: &cspace_model::PartEntry| entry.part.name() == names[k];
        let number = model.parts.iter().position(named)?;
        let entry = &model.parts[number];
        let moved = |axis: cspace::Axis| axis.configuration(motions[k]);
        let pose = content.cycle.as_ref().map(|cycle| cycle.poses[k]);
        let pose = pose.map(|[x, y, theta]| Configuration::new(x, y, theta));
        Some(PlacedPart {
            part: &entry.part,
            assembly_from_part: pose
                .unwrap_or_else(|| entry.axis.map_or(Configuration::default(), moved)),
            axis: entry.axis,
            number,
        })
    };
    let far = content.depth.or(content.gap);
    let caption = format!(
        "{}{}: {}, {}",
        pair.outcome.word(),
        far.filter(|l| *l > 0.0)
            .map_or(String::new(), |l| format!(" {}", length(l))),
        names[0],
        names[1]
    );
    let marks = content.points.into_iter().flatten();
    let picture = PartsPicture {
        parts: vec![part(0)?, part(1)?],
        faults: marks
            .map(|[x, y]| (Point::new(x, y), String::new()))
            .collect(),
        without_origins: true,
        ..PartsPicture::default()
    };
    Some((caption, picture))
}
