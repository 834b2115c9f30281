//! Many slices of one pair.

use core::f64::consts::TAU;

use crate::contact::Geometry;
use crate::part::Part;

use super::arrange::Arrangement;
use super::coincident::Coincidences;
use super::types::Slice;

/// Slots of orientations, each with the contacts that exist in it.
const SLOTS: usize = 256;

/// A pair of parts prepared for slices at any orientation: what does not depend on it is computed once.
///
/// ```
/// use cspace::{Part, Slice, Slicer, Vertex};
/// let square = |name: &str, r: f64| {
///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
/// };
/// let slicer = Slicer::new(&square("fixed", 2.0)?, &square("moving", 1.0)?);
/// assert_eq!(slicer.slice(0.1).curves.len(), 8);
/// assert_eq!(slicer.slice(0.1 + core::f64::consts::TAU).loops.len(), 1);
/// # Ok::<(), cspace::PartError>(())
/// ```
#[derive(Debug)]
pub struct Slicer {
    geometry: Geometry,
    coincidences: Coincidences,
    slots: Vec<Vec<u32>>,
}

impl Slicer {
    /// Prepares a pair.
    pub fn new(fixed: &Part, moving: &Part) -> Self {
        let geometry = Geometry::new(fixed, moving, None, usize::MAX);
        let mut slots = vec![Vec::new(); SLOTS];
        let lo = geometry.contacts.span.lo;
        for (i, sheet) in (0u32..).zip(&geometry.contacts.sheets) {
            for slot in &mut slots[slot(sheet.lo - lo)..=slot(sheet.hi - lo)] {
                slot.push(i);
            }
        }
        Self {
            coincidences: Coincidences::new(&geometry),
            geometry,
            slots,
        }
    }

    /// The slice at an orientation in radians, as [`Slice::compute`] gives it.
    ///
    /// An orientation that is not finite has an empty slice.
    pub fn slice(&self, theta: f64) -> Slice {
        if !theta.is_finite() {
            return Slice::from_curves(theta, Vec::new(), false, &self.geometry.frame);
        }
        let lo = self.geometry.contacts.span.lo;
        let arrangement = Arrangement::new(&self.geometry, &self.coincidences, theta, |theta| {
            let turned = theta - TAU * ((theta - lo) / TAU).floor();
            (turned, self.slots[slot(turned - lo)].iter().copied())
        });
        Slice::from_arrangement(&arrangement, &self.geometry, theta)
    }
}

/// The slot of an orientation above the lowest.
fn slot(above: f64) -> usize {
    ((above / TAU * SLOTS as f64) as usize).min(SLOTS - 1)
}
