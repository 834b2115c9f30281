//! Bodies: parts that are joined rigidly are one part, called `a + b`.

use cspace::fixed_axes::Axis;
use cspace::part::{Part, PartError};

use super::dynamics::{Mass, MassProperties, PartDynamics};
use super::entries::{Member, PartEntry};

/// Reason why parts make no body.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BodyError {
    /// Two of the parts say different things of the body; `key` is how a model file calls what they say.
    #[error(
        "parts {first} and {second} are one body and have different values of `{key}`; give it of one of them"
    )]
    Differ {
        /// The key of a model file.
        key: &'static str,
        /// Number of the first part among the members.
        first: usize,
        /// Number of the second.
        second: usize,
    },
    /// The outlines together make no part.
    #[error(transparent)]
    Outline(#[from] PartError),
}

impl PartEntry {
    /// Parts that are joined rigidly, as one: each where it is drawn, called `a + b`, with the motion that one of them has. Symmetry is
    /// detected of the body.
    ///
    /// ```
    /// use cspace::Part;
    /// use cspace_model::PartEntry;
    /// let arm = PartEntry::revolute(Part::rectangle("arm", (3.0, 0.0), 8.0, 1.0)?, (0.0, 0.0));
    /// let knob = PartEntry::planar(Part::circle("knob", (6.0, 0.0), 1.0)?);
    /// let body = PartEntry::body(&[arm.clone(), knob])?;
    /// assert_eq!(body.part.name(), "arm + knob");
    /// assert_eq!(body.axis, arm.axis);
    /// assert!(body.is_called("knob"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If two of them have different motions, or have more layers together than a part may have.
    pub fn body(members: &[Self]) -> Result<Self, BodyError> {
        let axis: Option<Axis> = said_once("motion", members, |m| m.axis)?;
        let parts: Vec<&Part> = members.iter().map(|m| &m.part).collect();
        let name = parts.iter().map(|p| p.name()).collect::<Vec<_>>();
        Ok(Self {
            part: Part::together(name.join(" + "), &parts)?,
            axis,
            symmetry: None,
            members: (parts.iter())
                .map(|p| Member {
                    name: p.name().to_owned(),
                    layers: p.layers().len(),
                })
                .collect(),
        })
    }

    /// The parts that a body is made of, as they are drawn; the part itself if it is none.
    pub fn drawn(&self) -> Vec<Part> {
        let layers: usize = self.members.iter().map(|m| m.layers).sum();
        if layers != self.part.layers().len() {
            return vec![self.part.clone()];
        }
        let mut before = 0;
        let member = |m: &Member| {
            let first = before;
            before += m.layers;
            self.part.of_layers(&*m.name, first..before)
        };
        self.members.iter().map(member).collect()
    }
}

impl PartDynamics {
    /// Mass and motion of a body of these parts: masses add up, with parallel axes; parts without mass add none. Without any mass,
    /// `center_of_mass` is what one of them says. Start and rate are those of the body, which one of them gives.
    ///
    /// # Errors
    /// If two of them give different values.
    pub fn body(members: &[(&Part, Self)]) -> Result<Self, BodyError> {
        let masses: Vec<MassProperties> = (members.iter())
            .filter_map(|(part, dynamics)| dynamics.mass_properties(part))
            .collect();
        let start = said_once("start", members, |m| m.1.start)?;
        let rate = said_once("rate", members, |m| m.1.rate)?;
        let own = || said_once("center_of_mass", members, |m| m.1.center_of_mass);
        let (mass, inertia, center_of_mass) = match MassProperties::sum(&masses) {
            Some(all) => (
                Some(Mass::Total(all.mass)),
                Some(all.inertia),
                Some(all.center),
            ),
            None => (None, None, own()?),
        };
        Ok(Self {
            mass,
            inertia,
            center_of_mass,
            start,
            rate,
        })
    }
}

/// Value that one of the members gives of the body, or several alike.
fn said_once<M, T: PartialEq>(
    key: &'static str,
    members: &[M],
    says: impl Fn(&M) -> Option<T>,
) -> Result<Option<T>, BodyError> {
    let mut said = (members.iter().enumerate()).filter_map(|(i, m)| Some((i, says(m)?)));
    let Some((first, value)) = said.next() else {
        return Ok(None);
    };
    match said.find(|(_, other)| *other != value) {
        Some((second, _)) => Err(BodyError::Differ { key, first, second }),
        None => Ok(Some(value)),
    }
}
