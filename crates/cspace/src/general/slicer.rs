//! Slices of two parts without a contact space: the general method over a small interval of orientations, once or many times.

use core::f64::consts::{PI, TAU};

use crate::contact::{Fit, Geometry};
use crate::feature::PairFrame;
use crate::part::Part;
use crate::slice::{Slice, SliceCurve};
use crate::space::{Patch, Silent, StageSeconds, Window};

use crate::general::broad::discs::Cores;
use crate::general::compute::{Clock, Stages};
use crate::general::plan::{BEYOND_WINDOW, Names};

/// The smallest orientation at which slices are computed, radians; others are reduced by turns.
const FIRST: f64 = -PI;

/// Half width of the interval computed around a slice, radians: above the largest error of an event, so that the slice is not affected by
/// the interval's ends.
const ABOUT: f64 = BEYOND_WINDOW;

/// Number of intervals of orientation, each with the sheets that exist in it.
const SLOTS: usize = 256;

/// A pair of parts prepared for slices at any orientation: data that do not depend on it are computed once.
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
    /// Geometry from [`FIRST`] over a full turn, extended at both ends.
    geometry: Geometry,
    cores: Cores,
    /// Numbers of the sheets in each interval, in order.
    slots: Vec<Vec<u32>>,
}

impl Slicer {
    /// Prepares a pair.
    pub fn new(fixed: &Part, moving: &Part) -> Self {
        Self::of_fit(fixed, moving, Fit::Overlaps)
    }

    /// Prepares a pair, with a choice of how exact fits count.
    pub(super) fn of_fit(fixed: &Part, moving: &Part, fit: Fit) -> Self {
        let window = (FIRST - ABOUT, FIRST + TAU + ABOUT);
        let geometry = Geometry::attempt(fixed, moving, (fit, 0), Some(window), usize::MAX);
        let mut slots = vec![Vec::new(); SLOTS];
        for (i, sheet) in (0u32..).zip(&geometry.contacts.sheets) {
            for slot in &mut slots[slot(sheet.lo - ABOUT)..=slot(sheet.hi + ABOUT)] {
                slot.push(i);
            }
        }
        Self {
            cores: Cores::new(&geometry),
            geometry,
            slots,
        }
    }

    /// The frame of the pair.
    pub(super) fn frame(&self) -> &PairFrame {
        &self.geometry.frame
    }

    /// The slice at an orientation in radians, equal to that of [`Slice::compute`].
    ///
    /// It is empty for an orientation that is not finite.
    pub fn slice(&self, theta: f64) -> Slice {
        self.sliced(theta).0
    }

    /// The slice, and the data from which it was computed; `None` if it is empty because the orientation is not finite or there are too
    /// many contacts.
    pub(super) fn sliced(&self, theta: f64) -> (Slice, Option<Sliced>) {
        let at = turned(theta);
        if at.is_nan() {
            let empty = Slice::from_curves(theta, Vec::new(), false, &self.geometry.frame);
            return (empty, None);
        }
        let geometry = (self.geometry).within((at - ABOUT, at + ABOUT), &self.slots[slot(at)]);
        slice_of(geometry, &self.cores, at, theta)
    }
}

/// Data from which a slice was computed, with the patch of each of its curves.
pub(super) struct Sliced {
    pub(super) geometry: Geometry,
    /// The orientation computed, which differs from that of the slice by whole turns.
    pub(super) at: f64,
    pub(super) patches: Vec<Patch>,
}

impl Slice {
    /// Computes the slice of a pair at one orientation from scratch.
    ///
    /// If `theta` is a critical orientation, or up to 1.2·10⁻¹⁰ rad below one, the slice is that just above it. For a pair with too many
    /// contacts the slice is empty and doubtful. For many slices of one pair a [`Slicer`] is faster.
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
        let at = turned(theta);
        let geometry = Geometry::new(fixed, moving, Some((at - ABOUT, at + ABOUT)), usize::MAX);
        if at.is_nan() {
            return Self::from_curves(theta, Vec::new(), false, &geometry.frame);
        }
        let cores = Cores::single(&geometry);
        slice_of(geometry, &cores, at, theta).0
    }
}

/// The slice in the middle of a geometry's interval, with positions at an orientation that differs from it by whole turns.
fn slice_of(geometry: Geometry, cores: &Cores, at: f64, theta: f64) -> (Slice, Option<Sliced>) {
    // Patches that end within the narrowest band of the window's beginning have ended there, and those that begin there have begun.
    let window = Window {
        lo: at,
        hi: geometry.contacts.span.hi,
        full_turn: false,
    };
    let stages = Stages {
        geometry: &geometry,
        names: &Names::default(),
        window,
        edges: (0, 0),
        progress: &Silent,
    };
    let made = stages.run(
        cores,
        &mut StageSeconds::default(),
        &mut Clock::new(&Silent),
    );
    let Ok(Some((judged, chains, _))) = made else {
        let empty = Slice::from_curves(theta, Vec::new(), true, &geometry.frame);
        return (empty, None);
    };
    let linked = stages.assembler(judged).link(chains);
    let mut slice = linked.slice(at, theta, &geometry.frame);
    let patches = linked.patches;
    let of_curve = |c: &mut SliceCurve| c.patch.take().map(|i| patches[i.index()]);
    let patches = slice.curves.iter_mut().filter_map(of_curve).collect();
    let sliced = Sliced {
        geometry,
        at,
        patches,
    };
    (slice, Some(sliced))
}

/// An orientation reduced to the turn that begins with [`FIRST`]; NaN if it is not finite.
fn turned(theta: f64) -> f64 {
    let above = theta - FIRST;
    if (0.0..TAU).contains(&above) {
        theta
    } else {
        FIRST + above.rem_euclid(TAU)
    }
}

/// The interval of an orientation.
fn slot(theta: f64) -> usize {
    (((theta - FIRST) / TAU * SLOTS as f64).max(0.0) as usize).min(SLOTS - 1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
