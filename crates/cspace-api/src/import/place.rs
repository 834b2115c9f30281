//! Where the parts of drawings are put.

use std::path::Path;

use cspace_drawing::{Mirror, Outlines, Placement};
use cspace_model::shown::quoted;
use schemars::JsonSchema;
use serde::Deserialize;

use crate::error::Error;

/// Place of all parts, in the words of a model's `place`: they are mirrored, then turned about the origin, then moved.
#[derive(Debug, Clone, Copy, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Place {
    /// Where the origin is moved to.
    pub at: [f64; 2],
    /// The turn about the origin, radians, counter-clockwise.
    pub turn: f64,
    /// The axis through the origin at which they are mirrored first.
    pub mirror: Option<Mirror>,
}

impl Place {
    /// Puts parts there.
    ///
    /// # Errors
    /// If they are put so far away that their details are lost.
    pub(super) fn put(self, path: &Path, outlines: &mut Outlines) -> Result<(), Error> {
        let placement = Placement {
            at: self.at.into(),
            turn: self.turn,
            mirror: self.mirror,
        };
        for part in &mut outlines.parts {
            *part = placement.part(part).map_err(|e| {
                let (file, name) = (path.display(), quoted(part.name()));
                Error::new(format_args!(
                    "{file}: part {name}: where it is put, the outline is none: {e}"
                ))
                .help("put it nearer to the origin")
            })?;
        }
        Ok(())
    }
}

/// Reads text such as `at=10,5,turn=30deg,mirror=x`; brackets, braces, quotes and spaces, as the table of a model has them, may stand
/// between.
#[cfg(feature = "command")]
pub(super) fn place(text: &str) -> Result<Place, String> {
    const HELP: &str = "give at=X,Y, turn=A and mirror=x or mirror=y, or some of these, such as at=10,5,turn=30deg,mirror=x";
    let plain: String = text.chars().filter(|c| !"[]{}\"' ".contains(*c)).collect();
    let mut given: Vec<(&str, Vec<&str>)> = Vec::new();
    for piece in plain.split(',') {
        match (piece.split_once('='), given.last_mut()) {
            (Some((key, value)), _) => given.push((key, vec![value])),
            (None, Some((_, values))) => values.push(piece),
            (None, None) => return Err(HELP.to_owned()),
        }
    }
    let mut place = Place::default();
    for (i, (key, values)) in given.iter().enumerate() {
        if given[..i].iter().any(|(other, _)| other == key) {
            return Err(format!("{key} is given twice"));
        }
        match (*key, &values[..]) {
            ("at", [x, y]) => {
                let at = crate::given::two(&format!("{x},{y}"));
                let (x, y) = at.ok_or("give at as two numbers, such as at=10,5")?;
                place.at = [x, y];
            }
            ("at", _) => return Err("give at as two numbers, such as at=10,5".to_owned()),
            ("turn", [turn]) => place.turn = crate::given::angle(turn)?,
            ("mirror", [axis]) => {
                let known = Mirror::ALL.iter().find(|(name, _)| name == axis);
                let known = known.ok_or(
                    "give mirror=x, which turns y around, or mirror=y, which turns x around",
                )?;
                place.mirror = Some(known.1);
            }
            _ => return Err(HELP.to_owned()),
        }
    }
    Ok(place)
}

#[cfg(all(test, feature = "command"))]
mod tests {
    use core::f64::consts::FRAC_PI_2;

    use super::*;

    #[test]
    fn a_place_is_read_as_a_model_has_it() {
        let right = Place {
            at: [10.0, -5.5],
            turn: FRAC_PI_2,
            mirror: Some(Mirror::X),
        };
        for text in [
            "at=10,-5.5,turn=90deg,mirror=x",
            "mirror=x,at=10,-5.5,turn=0.25turn",
            "{ at = [10, -5.5], turn = \"90deg\", mirror = \"x\" }",
        ] {
            assert_eq!(place(text), Ok(right), "{text}");
        }
        for (text, told) in [
            ("10,5", "at=X,Y"),
            ("", "at=X,Y"),
            ("at=10", "two numbers"),
            ("at=10,y", "two numbers"),
            ("turn=x", "no angle"),
            ("mirror=z", "mirror=y"),
            ("by=3", "at=X,Y"),
            ("turn=1,turn=2", "twice"),
        ] {
            let error = place(text).unwrap_err();
            assert!(error.contains(told), "{text}: {error}");
        }
    }
}
