//! The region diagram of `cspace modes`.

use cspace::Mechanism;
use cspace_draw::{ModeFields, ModePlane, ModeRow, ModesPicture, PictureOptions, Scene, modes};
use cspace_modes::{ModePlace, Modes};

use super::ask::LETTERS;
use crate::args::ModesArgs;
use crate::failure::{Failure, note};
use crate::picture::{PictureArgs, Plane};

/// More modes than these are not drawn.
const MOST: usize = 7;
/// Fields of each plane along each coordinate: as many as a plane has dots in a picture of the usual size.
const FIELDS: usize = 280;

/// Rejects options that say nothing of this picture.
pub(super) fn check(args: &PictureArgs) -> Result<(), Failure> {
    let of_one_plane = [
        ("--x", args.x.is_some()),
        ("--y", args.y.is_some()),
        ("--u", args.u.is_some()),
        ("--v", args.v.is_some()),
        ("--labels", args.labels.is_some()),
    ];
    match of_one_plane.into_iter().find(|o| o.1) {
        None => Ok(()),
        Some((option, _)) => Err(Failure::input(format_args!(
            "{option} is about pictures of one plane, and this picture has three"
        ))
        .help("leave it out; `cspace slice --pair FIXED,MOVING` draws one plane")),
    }
}

pub(super) fn scene(
    args: &ModesArgs,
    model: &Mechanism,
    found: &Modes,
    (at, place): ([f64; 3], ModePlace),
) -> Result<Scene, Failure> {
    let unit = model.unit.as_deref();
    let names = found.names();
    let of = unit.map_or(String::new(), |u| format!(", lengths in {u}"));
    let title = format!("{}: modes of {}{of}", model.name, names.join(", "));
    let options: PictureOptions = args.picture.options(Plane::Motions, title, unit)?;
    let extents = found.extents();
    let planes = [0, 1, 2].map(|k| {
        let pair = &found.pairs()[k];
        ModePlane {
            coordinates: pair.coordinates.map(|c| LETTERS[c]),
            parts: pair.coordinates.map(|c| names[c].as_str()),
            axes: pair.coordinates.map(|c| found.axes()[c]),
            extents: pair.coordinates.map(|c| extents[c]),
            space: pair.space.as_ref(),
        }
    });
    let all = found.list().len();
    if all > MOST {
        note(format_args!(
            "the picture has the first {MOST} of {all} modes"
        ));
    }
    let rows = (0..all.min(MOST)).map(|mode| ModeRow {
        name: format!("mode {mode}"),
        planes: [0, 1, 2].map(|k| {
            let shadow = found.shadow(mode, k, planes[k].window(), [FIELDS, FIELDS]);
            ModeFields {
                fields: shadow.fields,
                reached: shadow.reached,
            }
        }),
        mark: (place == ModePlace::Mode(mode))
            .then(|| [0, 1, 2].map(|k| found.pairs()[k].coordinates.map(|c| at[c]).into())),
    });
    let picture = ModesPicture {
        planes,
        modes: rows.collect(),
    };
    Ok(modes(&picture, &options))
}
