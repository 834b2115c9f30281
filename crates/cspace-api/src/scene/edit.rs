//! A mechanism with some of its parts edited.

use cspace::pair::Joint;
use cspace::part::PartFeature;
use cspace::{AxisMotion, Part, PartError, Vertex};
use cspace_model::{Mechanism, MechanismError, PartEntry, shown};
use serde::Deserialize;

use crate::scene::data::SceneMotion;
use crate::scene::design::SceneSetting;

/// Changes of a model: values of its parameters first, then parts.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
pub struct Edits {
    /// Values for parameters.
    #[serde(default)]
    pub set: Vec<SceneSetting>,
    /// Parts in place of the model's.
    #[serde(default)]
    pub parts: Vec<EditedPart>,
}

/// A part that replaces one of the mechanism's.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct EditedPart {
    /// Index of the part.
    pub index: usize,
    /// Loops of the part.
    pub loops: Vec<Vec<Vertex>>,
    /// Motion relative to the ground.
    pub motion: SceneMotion,
    /// Distance by which it is grown, or shrunk if negative, in the model's unit of length.
    #[serde(default)]
    pub offset: f64,
}

/// Reason why an edited mechanism is invalid.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EditError {
    /// There is no such part.
    #[error("there is no part {index}: there are {parts}, counted from 0")]
    NoPart {
        /// The index.
        index: usize,
        /// Number of parts.
        parts: usize,
    },
    /// A part is edited twice.
    #[error("part {index} is listed twice; list every part once")]
    Twice {
        /// The part.
        index: usize,
    },
    /// Loops do not make a part.
    #[error("part {index} {}: {error}", shown::quoted(name))]
    Part {
        /// The part.
        index: usize,
        /// Name of the part.
        name: String,
        /// Reason why they are no part.
        error: PartError,
    },
    /// A loop is added to a part of several layers, or removed.
    #[error(
        "part {index} {} has layers of {loops} loops together; give as many, in their order",
        shown::quoted(name)
    )]
    Layers {
        /// The part.
        index: usize,
        /// Name of the part.
        name: String,
        /// Number of its loops.
        loops: usize,
    },
    /// A part is shrunk to nothing.
    #[error("part {index} {}: nothing is left of it when it is shrunk by {}; shrink it by less", shown::quoted(name), shown::number(*by))]
    Nothing {
        /// The part.
        index: usize,
        /// Name of the part.
        name: String,
        /// Distance of the offset.
        by: f64,
    },
    /// The mechanism makes no sense.
    #[error(transparent)]
    Mechanism(#[from] MechanismError),
}

/// Copy of the mechanism with edited parts.
///
/// Parts of several layers, as bodies are, keep their layers: each loop is that of the same number. Names of features are kept where loops have as many vertices as before and the part is not grown. A declared
/// symmetry that the part no longer has is removed. A joint with a part that does not move follows the pivot or the
/// direction of the edited part.
///
/// # Errors
/// If an index is out of range or occurs twice, loops make no part, or joints and motions contradict each other.
pub fn edited(model: &Mechanism, parts: &[EditedPart]) -> Result<Mechanism, EditError> {
    let mut model = model.clone();
    let mut done = vec![false; model.parts.len()];
    for part in parts {
        let index = part.index;
        match done.get_mut(index) {
            None => {
                return Err(EditError::NoPart {
                    index,
                    parts: model.parts.len(),
                });
            }
            Some(true) => return Err(EditError::Twice { index }),
            Some(done) => *done = true,
        }
        let entry = replaced(&model.parts[index], part)?;
        model.parts[index] = entry;
    }
    for part in parts {
        take_joints_along(&mut model, part.index);
    }
    model.check()?;
    Ok(model)
}

fn replaced(old: &PartEntry, edit: &EditedPart) -> Result<PartEntry, EditError> {
    let name = old.part.name();
    let wrong = |error| EditError::Part {
        index: edit.index,
        name: name.to_owned(),
        error,
    };
    // Of a part of one layer, loops may be added and removed.
    let old_loops = old.part.loops().len();
    let drawn = match old.part.has_heights() {
        true if edit.loops.len() != old_loops => {
            return Err(EditError::Layers {
                index: edit.index,
                name: name.to_owned(),
                loops: old_loops,
            });
        }
        true => old.part.redrawn(edit.loops.clone()),
        false => Part::new(name, edit.loops.clone()),
    };
    let drawn = drawn.map_err(wrong)?;
    let part = if edit.offset > 0.0 {
        cspace_plan::grown(&drawn, edit.offset).map_err(wrong)?
    } else if edit.offset < 0.0 {
        let left = cspace_plan::shrunk(&drawn, -edit.offset).map_err(wrong)?;
        left.ok_or_else(|| EditError::Nothing {
            index: edit.index,
            name: name.to_owned(),
            by: -edit.offset,
        })?
    } else {
        with_names_of(drawn, &old.part).map_err(wrong)?
    };
    // What is not edited stays.
    let mut entry = old.clone();
    entry.symmetry = old.symmetry.filter(|&fold| part.is_symmetric(fold));
    entry.axis = edit.motion.axis();
    entry.part = part;
    Ok(entry)
}

/// The part with the other's names of features in loops that have as many vertices.
fn with_names_of(part: Part, other: &Part) -> Result<Part, PartError> {
    let vertices = |part: &Part, i: u32| part.loops().get(i as usize).map(|l| l.vertices().len());
    let mut named = part;
    for (feature, name) in other.feature_names() {
        let (PartFeature::Edge { loop_index, .. } | PartFeature::Vertex { loop_index, .. }) =
            feature;
        if vertices(&named, loop_index) == vertices(other, loop_index) {
            named = named.with_feature_name(feature, name)?;
        }
    }
    Ok(named)
}

/// Moves a joint between a part and one that does not move to the place given by the part's motion.
fn take_joints_along(model: &mut Mechanism, part: usize) {
    let motion = |i: usize| model.parts[i].axis.map(|a| a.motion);
    let own = motion(part);
    let still: Vec<bool> = (0..model.parts.len())
        .map(|i| motion(i) == Some(AxisMotion::Fixed))
        .collect();
    for entry in &mut model.joints {
        let other = match entry.parts {
            (a, b) if a == part => b,
            (a, b) if b == part => a,
            _ => continue,
        };
        if !still[other] {
            continue;
        }
        match (&mut entry.joint, own) {
            (Joint::Revolute { at }, Some(AxisMotion::Revolute { center })) => *at = center,
            (
                Joint::Prismatic { direction, .. },
                Some(AxisMotion::Prismatic { direction: own }),
            ) => {
                *direction = own;
            }
            _ => {}
        }
    }
}
