//! The field of force of a pair, from what its mechanism says.

use cspace::{AxisMotion, Vector};
use cspace_model::{LoadKind, Mechanism, PairEntry, SpringKind};

use super::energy::{Body, Field, Spring, Weight};

/// Reasons why a model has no energy that depends on the places of two parts alone.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FieldError {
    /// A torque or a torsion spring counts whole turns.
    #[error("the torque on part `{part}` counts whole turns, which a configuration does not")]
    Torque {
        /// The part.
        part: String,
    },
    /// The part whose energy is asked for stands still.
    #[error("part `{part}` is the moving one of the pair, and stands still in the model")]
    Still {
        /// The part.
        part: String,
    },
    /// A spring leads to a part that is not of the pair.
    #[error("a spring joins part `{part}` to `{other}`, which is not of the pair")]
    Elsewhere {
        /// The part of the pair.
        part: String,
        /// The other one.
        other: String,
    },
}

impl Field {
    /// The weights, loads and springs of the two parts of a pair: gravity, which acts at the centres of mass, forces of constant
    /// direction, and springs between the two or to the ground. Of a planar pair the fixed part stays where it is drawn.
    ///
    /// The second part of the answer is whether the moving part has a mass in the model; without one it weighs as 1 kg.
    ///
    /// # Errors
    /// For torques and torsion springs on these parts, springs to others, and a moving part that stands still.
    pub fn of_pair(
        mechanism: &Mechanism,
        pair: &PairEntry,
        gravity: Vector,
    ) -> Result<(Self, bool), FieldError> {
        let dynamics = &mechanism.dynamics;
        let body = |part: usize| match part {
            _ if part == pair.fixed => Some(Body::Fixed),
            _ if part == pair.moving => Some(Body::Moving),
            _ => None,
        };
        let name = |part: usize| {
            (mechanism.parts.get(part)).map_or_else(String::new, |p| p.part.name().to_owned())
        };
        let stands = |part: usize| {
            (mechanism.parts.get(part).and_then(|p| p.axis))
                .is_some_and(|a| a.motion == AxisMotion::Fixed)
        };
        if stands(pair.moving) && !stands(pair.fixed) {
            let part = name(pair.moving);
            return Err(FieldError::Still { part });
        }
        let mut field = Self::default();
        let weighs = mechanism.mass_properties(pair.moving).is_some();
        for (part, on) in [(pair.fixed, Body::Fixed), (pair.moving, Body::Moving)] {
            let properties = mechanism.mass_properties(part);
            let (mass, at) = match (properties, on) {
                (Some(p), _) => (p.mass, p.center),
                (None, Body::Moving) => {
                    let own = dynamics.part(part);
                    (1.0, own.center_of_mass(&mechanism.parts[part].part))
                }
                (None, _) => continue,
            };
            if gravity != Vector::ZERO {
                let force = gravity * mass;
                field.weights.push(Weight { on, at, force });
            }
        }
        for load in &dynamics.loads {
            let Some(on) = body(load.part) else {
                continue;
            };
            match load.kind {
                LoadKind::Force { force, at } => {
                    let own = dynamics.part(load.part);
                    let center = || own.center_of_mass(&mechanism.parts[load.part].part);
                    let at = at.unwrap_or_else(center);
                    field.weights.push(Weight { on, at, force });
                }
                LoadKind::Torque(_) => {
                    return Err(FieldError::Torque {
                        part: name(load.part),
                    });
                }
            }
        }
        for spring in &dynamics.springs {
            let (first, second) = (body(spring.part), spring.other.map(body));
            let (first, second) = match (first, second) {
                (None, None | Some(None)) => continue,
                (Some(first), None) => (first, Body::Ground),
                (Some(first), Some(Some(second))) => (first, second),
                (Some(_), Some(None)) => {
                    return Err(FieldError::Elsewhere {
                        part: name(spring.part),
                        other: spring.other.map_or_else(String::new, name),
                    });
                }
                (None, Some(Some(_))) => {
                    return Err(FieldError::Elsewhere {
                        part: spring.other.map_or_else(String::new, name),
                        other: name(spring.part),
                    });
                }
            };
            match spring.kind {
                SpringKind::Linear {
                    at,
                    stiffness,
                    length,
                    ..
                } => field.springs.push(Spring {
                    ends: [(first, at.0), (second, at.1)],
                    stiffness,
                    length,
                }),
                SpringKind::Torsion { .. } => {
                    return Err(FieldError::Torque {
                        part: name(spring.part),
                    });
                }
            }
        }
        Ok((field, weighs))
    }

    /// Whether nothing acts.
    pub fn is_none(&self) -> bool {
        self.weights.is_empty() && self.springs.is_empty()
    }
}
