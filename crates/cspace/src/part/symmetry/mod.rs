//! Rotational symmetry of a part.
//!
//! A part is k-fold symmetric if turning it by 2π/k about its centre of area maps it to itself. The symmetry is found from the outline: a
//! rotation that maps the part to itself maps loops to loops and vertices to vertices, so k divides their number, and among the divisors
//! only powers of primes need to be tried. A loop that is one whole circle has no vertices that count: a bore drawn as two half circles
//! does not break the symmetry of a wheel, wherever the halves meet. Other vertices count, also those that could be left out because an
//! edge continues straight there.

mod mapping;
mod merge;
mod redraw;
mod trace;

pub use mapping::SYMMETRIC;
pub(crate) use mapping::{Corresponding, LoopImage};
pub(crate) use redraw::Symmetrized;

use crate::geometry::Point;

use super::Part;
use merge::merged;
use trace::Trace;

/// The rotations about its own centre that map a part to itself.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PartSymmetry {
    fold: u32,
    center: Point,
    deviation: f64,
    round: bool,
}

impl PartSymmetry {
    /// The largest k for which turning by 2π/k maps the part to itself; 1 without symmetry.
    ///
    /// For a part of concentric circles only, which every rotation maps to itself, it is the largest that also maps
    /// the arcs as drawn to each other: 2 for a disc of two half circles.
    pub const fn fold(&self) -> u32 {
        self.fold
    }

    /// The centre of the rotations, in the part's own frame. Without symmetry it has no meaning.
    pub const fn center(&self) -> Point {
        self.center
    }

    /// Deviation of the outline from that of the nearest exactly symmetric part, in the part's unit of length: at most [`SYMMETRIC`] of its
    /// size.
    pub const fn deviation(&self) -> f64 {
        self.deviation
    }

    /// Whether the part consists of concentric circles, so that every rotation maps it to itself.
    pub const fn is_round(&self) -> bool {
        self.round
    }

    /// Whether turning by 2π/`fold` maps the part to itself: `fold` divides the largest, or the part is round.
    pub const fn allows(&self, fold: u32) -> bool {
        fold > 0 && (self.round || self.fold.is_multiple_of(fold))
    }
}

impl Part {
    /// Finds the part's rotational symmetry.
    ///
    /// Takes time in proportion to n log n for n vertices, at most once for every power of a prime that divides the
    /// number of vertices; most of these fail at the first vertex.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// let corners = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (0.0, 1.0)];
    /// let bar = Part::new("bar", vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])?;
    /// assert_eq!(bar.symmetry().fold(), 2);
    /// assert_eq!(bar.symmetry().center(), cspace::Point::new(1.5, 0.5));
    /// assert!(!bar.symmetry().allows(4));
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn symmetry(&self) -> PartSymmetry {
        let trace = Trace::new(self, Corresponding::Outlines);
        let fold = trace.fold();
        let found = (fold > 1)
            .then(|| Symmetrized::new(self, &trace, fold))
            .flatten();
        PartSymmetry {
            fold: found.as_ref().map_or(1, |f| f.fold),
            center: trace.center(),
            deviation: found.map_or(0.0, |f| f.deviation),
            round: trace.is_round(),
        }
    }

    /// Whether turning by 2π/`fold` about its own centre maps the part to itself.
    ///
    /// As [`PartSymmetry::allows`], except that vertices at which an edge continues straight, or along the same arc, do not count either.
    ///
    /// ```
    /// use cspace::{Part, Vertex};
    /// let corners = [(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    /// let square = Part::new("square", vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])?;
    /// assert!(square.is_symmetric(4) && !square.is_symmetric(8));
    /// assert_eq!(square.symmetry().fold(), 1);
    /// # Ok::<(), cspace::PartError>(())
    /// ```
    pub fn is_symmetric(&self, fold: u32) -> bool {
        self.symmetry().allows(fold)
            || merged(self).is_some_and(|part| part.symmetry().allows(fold))
    }

    /// The nearest exactly symmetric part, with the images of its loops; `None` without symmetry.
    ///
    /// If only its vertices are used, circles are not divided further than drawn, and the fold may be smaller.
    pub(crate) fn symmetrized(&self, by: Corresponding) -> Option<Symmetrized> {
        let trace = Trace::new(self, by);
        let fold = trace.fold();
        (fold > 1)
            .then(|| Symmetrized::new(self, &trace, fold))
            .flatten()
    }
}

#[cfg(test)]
mod tests;
