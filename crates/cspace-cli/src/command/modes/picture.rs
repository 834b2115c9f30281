//! The region diagram of `cspace modes`.

use cspace_api::Subject;
use cspace_api::modes::OperatingModes;
use cspace_draw::{ModeFields, ModePlane, ModeRow, ModesPicture, PictureOptions, Scene, modes};
use cspace_plan::modes::{ModePlace, Modes};

use super::ModesArgs;
use crate::failure::note;

/// More modes than these are not drawn.
const MOST: usize = 7;
/// Fields of each plane along each coordinate: as many as a plane has dots in a picture of the usual size.
const FIELDS: usize = 280;

/// The picture of the modes of three parts.
pub(super) fn scene(
    args: &ModesArgs,
    subject: &Subject,
    answer: &OperatingModes,
    found: &Modes,
) -> Scene {
    let unit = subject.unit();
    let (at, place) = (answer.requested.at.all(), answer.requested.place);
    let letters = ["u", "v", "w"];
    let names = found.names();
    let of = unit.map_or(String::new(), |u| format!(", lengths in {u}"));
    let title = format!(
        "{}: modes of {}{of}",
        subject.name().unwrap_or_default(),
        names.join(", ")
    );
    let options = PictureOptions {
        size: args.picture.size,
        title: args.picture.title.clone().unwrap_or(title),
        unit: unit.map(str::to_owned),
        ..PictureOptions::default()
    };
    let extents = found.extents();
    let planes = [0, 1, 2].map(|k| {
        let pair = &found.pairs()[k];
        ModePlane {
            coordinates: pair.coordinates.map(|c| letters[c]),
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
    modes(&picture, &options)
}
