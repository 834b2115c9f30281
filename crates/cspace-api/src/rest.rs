//! The clearance of a path that starts or ends in contact, where it is off that.

use cspace::Coordinates;
use cspace_plan::legs::Scene;
use cspace_plan::{off_contacts, touches};
use schemars::JsonSchema;
use serde::Serialize;

/// A path without the part of its first leg on which the clearance rises off a contact, and of its last on which it falls to one.
#[derive(Debug, Clone, Copy, Serialize, JsonSchema)]
pub struct Rest {
    /// Whether the path starts in contact.
    pub from_contact: bool,
    /// Whether it ends in contact.
    pub to_contact: bool,
    /// The least distance of the parts along the rest, in the model's unit; none of a path of one configuration.
    pub clearance: Option<f64>,
}

impl Rest {
    /// The rest of a free path; none if it neither starts nor ends in contact.
    pub(crate) fn of(scene: &Scene, path: &[Coordinates]) -> Option<Self> {
        let places: Vec<_> = (path.iter().filter_map(|&at| scene.numbers(at).ok())).collect();
        let (first, last) = (*places.first()?, *places.last()?);
        let (from_contact, to_contact) = (touches(scene, first), touches(scene, last));
        if !from_contact && !to_contact {
            return None;
        }
        let clearance = match off_contacts(scene, &places, (from_contact, to_contact))[..] {
            _ if places.len() < 2 => None,
            [] => None,
            [at] => Some(scene.clearance(at)),
            ref rest => {
                let legs = rest.windows(2);
                Some(legs.fold(f64::INFINITY, |least, leg| {
                    least.min(scene.least(leg[0], leg[1]).distance)
                }))
            }
        };
        Some(Self {
            from_contact,
            to_contact,
            clearance: clearance.filter(|c| c.is_finite()),
        })
    }
}
