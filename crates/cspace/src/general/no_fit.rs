//! Positions of a part at one orientation beside others without overlap, or within a frame.

use crate::contact::{Bodies, Fit};
use crate::geometry::{Configuration, Point, Vector};
use crate::part::{Bounds, Part};
use crate::slice::{Slice, SliceCurve};

use super::redrawn::AsDrawn;
use super::slicer::Slicer;

/// The positions of a part at which it overlaps nothing, exact fits included, at any orientation: the no-fit polygon of two parts, with
/// arcs, or the inner-fit polygon of a frame and a part.
///
/// A [`ContactSpace`](crate::ContactSpace) and its [slices](crate::ContactSpace::slice) count an exact fit as blocked; here it is free: a
/// disc in a frame of its own diameter has one position, a peg in a slot of its own width has a segment. Slices have the same form: loops
/// with blocked space on the left; a loop that is one point is a segment of length zero, and one that is a segment or arc goes there and
/// back. Curves are those of the parts as drawn, up to rounding, except for ends of curves that are tangent to the next. Parts that overlap
/// by less than 9·10⁻¹⁰ of the pair's size count as fitting. Where parts fit exactly in many places at once, such as a plate on several
/// pins of the size of its holes, the position may be missed.
///
/// ```
/// use cspace::{NoFit, Part, Point};
/// let coin = Part::circle("coin", (0.0, 0.0), 200.0)?;
/// let tray = Part::rectangle("tray", (0.0, 0.0), 400.0, 600.0)?;
/// // In a tray of its own width a coin moves along a segment, and beside it around it.
/// let inside = NoFit::within(&tray, &coin).at(0.3);
/// assert_eq!(inside.loops.len(), 1);
/// assert!((inside.curves[0].geometry.length() - 200.0).abs() < 1e-9);
/// let beside = NoFit::new(&tray, &coin).at(0.3);
/// let (_, nearest) = beside.nearest(Point::new(10.0, 0.0)).ok_or("there is none")?;
/// assert!((nearest.x - 400.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct NoFit {
    slicer: Slicer,
    drawn: AsDrawn,
    /// Where the middle of the moving part's box is when the part is within a frame.
    within: Option<(Bounds, Point)>,
}

/// Reasons for which placed parts have no positions beside them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoFitError {
    /// No part is placed.
    #[error("no part is placed")]
    Nothing,
    /// Two of the placed parts overlap.
    #[error("the placed parts {first} and {second} overlap, counted from 0")]
    Overlap {
        /// Number of the first of them.
        first: usize,
        /// Number of the second.
        second: usize,
    },
}

impl NoFit {
    /// Positions of a part beside another.
    pub fn new(fixed: &Part, moving: &Part) -> Self {
        Self::of(fixed, moving)
    }

    /// Positions of a part beside several others, each placed by a configuration; these may touch each other.
    ///
    /// # Errors
    /// If two of them overlap, or there are none.
    pub fn beside(placed: &[(&Part, Configuration)], moving: &Part) -> Result<Self, NoFitError> {
        if placed.is_empty() {
            return Err(NoFitError::Nothing);
        }
        let boxes: Vec<Bounds> = (placed.iter())
            .map(|p| Part::assembled("", &[*p]).bounds())
            .collect();
        for (second, (part, at)) in placed.iter().enumerate() {
            for (first, (other, other_at)) in placed[..second].iter().enumerate() {
                let apart = boxes[first].is_apart(boxes[second], 0.0);
                if !apart
                    && Bodies::new(other, part, Fit::HasPlay)
                        .overlap(other_at.inverse().compose(*at))
                {
                    return Err(NoFitError::Overlap { first, second });
                }
            }
        }
        Ok(Self::of(&Part::assembled("placed", placed), moving))
    }

    /// Positions of a part within another, and outside the other's holes.
    pub fn within(container: &Part, moving: &Part) -> Self {
        // Frame so wide that the part cannot be on both sides of it.
        let frame = container.framing(2.0 * moving.size());
        Self::inside(&frame, moving)
    }

    /// Positions of a part inside walls whose outermost loop is two sizes of the part or more outside of them.
    pub fn inside(walls: &Part, moving: &Part) -> Self {
        let (bounds, far) = (walls.bounds(), moving.size());
        // A part that touches the loop from outside is within a size of it, and one inside two sizes from it.
        let held = Bounds {
            min: bounds.min + Vector::new(far, far),
            max: bounds.max - Vector::new(far, far),
        };
        Self {
            within: Some((held, moving.bounds().center())),
            ..Self::of(walls, moving)
        }
    }

    fn of(fixed: &Part, moving: &Part) -> Self {
        let slicer = Slicer::of_fit(fixed, moving, Fit::HasPlay);
        Self {
            drawn: AsDrawn::new(fixed, moving, slicer.frame()),
            slicer,
            within: None,
        }
    }

    /// The positions at an orientation in radians; empty if the orientation is not finite.
    pub fn at(&self, theta: f64) -> Slice {
        let (slice, sliced) = self.slicer.sliced(theta);
        let Some(sliced) = sliced else {
            return slice;
        };
        let slice = self.drawn.redrawn(&slice, &sliced);
        match self.within {
            Some((held, middle)) => inside(&slice, held, middle),
            None => slice,
        }
    }

    /// The shortest translation to a position without overlap, zero if the configuration is one; `None` if there is no such position.
    ///
    /// For two parts that overlap, its length is their penetration at this orientation.
    ///
    /// ```
    /// use cspace::{Configuration, NoFit, Part};
    /// let square = Part::rectangle("square", (0.0, 0.0), 2.0, 2.0)?;
    /// let apart = NoFit::new(&square, &square);
    /// let by = apart.least_separation(Configuration::new(1.5, 0.2, 0.0)).ok_or("there is none")?;
    /// assert!((by.x - 0.5).abs() < 1e-12 && by.y.abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn least_separation(&self, at: Configuration) -> Option<Vector> {
        let (slice, p) = (self.at(at.theta), at.position());
        // Without curves all positions beside a part are free, and no position within a frame is.
        let is_free = slice.is_free(p) && !(self.within.is_some() && slice.curves.is_empty());
        if is_free {
            return Some(Vector::ZERO);
        }
        slice.nearest(p).map(|(_, q)| q - p)
    }
}

/// The loops of a slice at which the middle of the moving part is held in a box.
fn inside(slice: &Slice, held: Bounds, middle: Point) -> Slice {
    let is_held = |curve: SliceCurve| {
        let p = curve.geometry.point(0.0);
        let at = Configuration::new(p.x, p.y, slice.theta).fixed_from_moving(middle);
        !held.is_apart(Bounds::of(at, at), 0.0)
    };
    let loops = slice.loops.iter().map(|l| slice.along(l).collect());
    let loops = loops.filter(|l: &Vec<SliceCurve>| l.iter().copied().all(is_held));
    Slice::of_loops(slice.theta, loops.collect(), slice.doubtful)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
