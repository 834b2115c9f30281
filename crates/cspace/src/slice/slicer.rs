//! Slices computed from the parts themselves: one, or many of one pair.

use core::f64::consts::TAU;

use crate::contact::Geometry;
use crate::part::Part;

use super::arrange::Arrangement;
use super::boundary::{Slice, SliceCurve};
use super::coincident::Coincidences;
use super::curve_geometry::CurveGeometry;

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

impl Slice {
    /// Computes the slice of a pair at one orientation from scratch.
    ///
    /// If `theta` is a critical orientation, the slice just above it is meant: within 1e-9 rad, or 1e-7 rad beside a tangency. For many slices
    /// of one pair a [`Slicer`] is faster.
    ///
    /// ```
    /// use cspace::{Part, Slice, Vertex};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let slice = Slice::compute(&square("fixed", 2.0)?, &square("moving", 1.0)?, 0.1);
    /// assert_eq!(slice.loops.len(), 1);
    /// assert_eq!(slice.curves.len(), 8);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn compute(fixed: &Part, moving: &Part, theta: f64) -> Self {
        let geometry = Geometry::new(
            fixed,
            moving,
            Some((theta - 0.25, theta + 0.25)),
            usize::MAX,
        );
        let sheets = geometry.contacts.sheets.len() as u32;
        let arrangement = Arrangement::new(&geometry, &Coincidences::new(&geometry), theta, |t| {
            (t, 0..sheets)
        });
        Self::from_arrangement(&arrangement, &geometry, theta)
    }

    /// The arrangement as positions at the orientation that was asked for; it may belong to one a little above.
    fn from_arrangement(arrangement: &Arrangement, geometry: &Geometry, theta: f64) -> Self {
        let curves = arrangement
            .gaps
            .iter()
            .map(|gap| {
                let sheet = &geometry.contacts.sheets[gap.sheet as usize];
                SliceCurve {
                    fixed: geometry.fixed.features[sheet.fixed as usize].name,
                    moving: geometry.moving.features[sheet.moving as usize].name,
                    geometry: CurveGeometry::from_inner(
                        &gap.curve,
                        gap.from_position,
                        gap.to_position,
                        &geometry.frame,
                        theta,
                    ),
                    patch: None,
                    next: gap.next,
                }
            })
            .collect();
        Self::from_curves(theta, curves, arrangement.doubtful, &geometry.frame)
    }
}

/// The slot of an orientation above the lowest.
fn slot(above: f64) -> usize {
    ((above / TAU * SLOTS as f64) as usize).min(SLOTS - 1)
}
