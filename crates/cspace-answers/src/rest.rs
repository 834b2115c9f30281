//! The clearance of a path that starts or ends in contact, where it is off that.

use cspace::Coordinates;
use cspace_plan::legs::Scene;
use cspace_plan::touches;
use serde::Serialize;

/// A path without the leg that leaves a contact and the leg that comes to one.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Rest {
    /// Whether the path starts in contact.
    pub from_contact: bool,
    /// Whether it ends in contact.
    pub to_contact: bool,
    /// The clearance of the other legs, or of the one configuration between two such legs; none if nothing is left.
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
        let end = places.len().saturating_sub(usize::from(to_contact));
        let clearance = match places.get(usize::from(from_contact)..end) {
            None | Some([]) => None,
            Some(&[at]) => Some(scene.clearance(at)),
            Some(rest) => {
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
