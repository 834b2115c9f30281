//! Extents of cells along their contact curves where they meet a cluster of events, and the pieces that two cells share.

use crate::contact::{Exact, Geometry, Orientation, PLACE_ERROR};
use crate::feature::tolerance::SHORTEST_OVERLAP;

use crate::general::cells::cell::{Cell, END};
use crate::general::events::branch::Branch;
use crate::general::events::clusters::Clusters;
use crate::general::events::placing::Placing;

/// A cell's range along its contact curve at one orientation, with the errors of both ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    pub(crate) lo_error: f64,
    pub(crate) hi_error: f64,
}

/// Piece of a curve that two cells share.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shared {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Whether the piece is certainly longer than the errors of its ends.
    pub(crate) certain: bool,
}

impl Extent {
    /// The common range as measured, if it is long enough.
    pub(crate) fn shared_with(&self, other: &Self) -> Option<Shared> {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        (hi - lo > SHORTEST_OVERLAP).then(|| Shared {
            lo,
            hi,
            certain: self.overlaps(other) == Some(true),
        })
    }

    /// Whether the two share a range; `None` if the errors of their ends leave this open.
    fn overlaps(&self, other: &Self) -> Option<bool> {
        // The longest and the shortest range that the errors admit.
        let length = |sign: f64| {
            let end = |place: f64, error: f64| place + sign * error;
            let hi = end(self.hi, self.hi_error).min(end(other.hi, other.hi_error));
            let lo = end(-self.lo, self.lo_error).min(end(-other.lo, other.lo_error));
            hi + lo
        };
        if length(-1.0) > SHORTEST_OVERLAP {
            Some(true)
        } else if length(1.0) <= SHORTEST_OVERLAP {
            Some(false)
        } else {
            None
        }
    }
}

/// Side of a cluster on which a cell lies that ends or begins there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Side {
    Below,
    Above,
}

/// Measures cells of one sheet where they meet a cluster.
///
/// A place is measured at the cluster's orientation. The event that ends or begins the cell may happen anywhere in the cluster; the
/// resulting change is bounded by the sharpness of the crossing, or, towards a tangency, measured at both edges of the cluster.
pub(crate) struct CellExtents<'a> {
    geometry: &'a Geometry,
    sheet: u32,
    at: Placing<'a>,
    branches: &'a [Branch],
    clusters: &'a Clusters,
    cluster: u32,
    width: f64,
    /// Half the length of the curve.
    half: f64,
    /// The largest speed of an end or a crossing, to be divided by the sine, in the pair's frame per radian.
    speed: f64,
    /// Bounds measured so far: most are needed again, by the cell on their other side.
    known: Vec<((u32, Side), (f64, f64))>,
    /// Bounds measured in f64.
    rough: Vec<(u32, (f64, f64))>,
    /// The cluster's orientation in double-double, once it is needed.
    turn: Option<Orientation<Exact>>,
    /// The curve in double-double at the orientations used so far, with the places of its ends.
    exact: Vec<(Exact, Placing<'a, Exact>, (Exact, Exact))>,
    /// Accuracy that is good enough (length): a bound known this well in f64 is not measured again.
    good: f64,
}

impl<'a> CellExtents<'a> {
    pub(crate) fn new(
        geometry: &'a Geometry,
        clusters: &'a Clusters,
        branches: &'a [Branch],
        sheet: u32,
        cluster: u32,
    ) -> Self {
        let orientation = Orientation {
            theta: clusters.at(cluster),
            turn: clusters.turn(cluster),
        };
        let at = Placing::new(geometry, sheet, orientation);
        // Ends that turn about a far centre are lost in the rounding of the orientation.
        let half = if geometry.contacts.sheets[sheet as usize].is_flat() {
            let turn = Orientation::by(clusters.exact_at(cluster));
            let (from, to) = Placing::new(geometry, sheet, turn).ends();
            (0.5 * (to - from).to_f64()).max(0.0)
        } else {
            at.half()
        };
        Self {
            geometry,
            sheet,
            speed: at.speed(),
            half,
            at,
            branches,
            clusters,
            cluster,
            width: clusters.width(cluster),
            known: Vec::new(),
            rough: Vec::new(),
            turn: None,
            exact: Vec::new(),
            good: GOOD,
        }
    }

    /// Extents measured only to this accuracy (length), where f64 reaches it.
    pub(crate) fn measured_within(self, good: f64) -> Self {
        Self { good, ..self }
    }

    /// Piece of curve shared by a cell that ends at the cluster and one that begins there: in f64 if that decides whether they share any.
    pub(crate) fn shared(&mut self, lower: &Cell, upper: &Cell) -> Option<Shared> {
        let one = |a: u32, b: u32| a != END && a == b;
        if one(lower.right, upper.left) || one(upper.right, lower.left) {
            return None;
        }
        let ends = |this: &mut Self, cell: &Cell| {
            extent([(cell.left, -1.0), (cell.right, 1.0)].map(|(b, end)| this.rough(b, end)))
        };
        let (below, above) = (ends(self, lower), ends(self, upper));
        if below.overlaps(&above).is_some() {
            return below.shared_with(&above);
        }
        let (below, above) = (self.of(lower, Side::Below), self.of(upper, Side::Above));
        below.shared_with(&above)
    }

    pub(crate) fn of(&mut self, cell: &Cell, side: Side) -> Extent {
        extent([(cell.left, -1.0), (cell.right, 1.0)].map(|(b, end)| self.bound(b, end, side)))
    }

    /// The place of a bound and its error. Places beyond the curve's ends are moved to its ends.
    fn bound(&mut self, branch: u32, end: f64, side: Side) -> (f64, f64) {
        let rough = self.rough(branch, end);
        if rough.1 <= self.good {
            return rough;
        }
        if branch == END {
            return (end * self.half, ROUNDING + self.speed * self.width);
        }
        let key = (branch, side);
        if let Some(known) = self.known.iter().find(|k| k.0 == key) {
            return known.1;
        }
        let branches = self.branches;
        let measured = self.approached(&branches[branch as usize], side);
        self.known.push((key, measured));
        measured
    }

    /// A bound and its error, as [`bound`](Self::bound) but in f64 only; the error is infinite where f64 decides nothing.
    fn rough(&mut self, branch: u32, end: f64) -> (f64, f64) {
        if branch == END {
            let moved = self.speed * (self.width + TURN_ERROR);
            return (end * self.at.half(), moved + PLACE_ERROR);
        }
        if let Some(known) = self.rough.iter().find(|k| k.0 == branch) {
            return known.1;
        }
        let b = &self.branches[branch as usize];
        let small = |s: u32| self.geometry.contacts.sheets[s as usize].is_small();
        let measured = if small(self.sheet) || small(b.other(self.sheet)) {
            (0.0, f64::INFINITY)
        } else {
            let (at, rounding) = self.at.within(b);
            let moved = self.speed * self.width / PLACE_ERROR;
            (at, rounding * (1.0 + moved))
        };
        self.rough.push((branch, measured));
        measured
    }

    /// The place in double-double, slightly beside the cluster: where two lines become one, their crossing is undefined, but it has a
    /// limit.
    ///
    /// Near the cluster the place has hardly moved, but curves that become one cross at an angle so small that rounding dominates; farther
    /// from it the displacement dominates. The most accurate of several tries is used.
    fn approached(&mut self, b: &Branch, side: Side) -> (f64, f64) {
        /// Distances from the cluster, radians: above the rounding of orientations, and far below those that move places.
        const ASIDE: [f64; 3] = [1e-20, 1e-17, 1e-14];
        /// Factor to which rounding is estimated: where a place moves by more than that times its rounding, it does move.
        const TOLD: f64 = 1e3;
        let mut best = (0.0, f64::INFINITY);
        let mut near = [None; ASIDE.len()];
        for (near, aside) in near.iter_mut().zip(ASIDE) {
            let found = self.place_aside(b, side, aside);
            // Where rounding alone is too large, it may be smaller farther from the cluster.
            if found.1 > self.good && aside < ASIDE[ASIDE.len() - 1] {
                *near = Some(found);
                continue;
            }
            let measured = self.approached_to(b, side, aside, found);
            if measured.1 < best.1 {
                best = measured;
            }
            if best.1 <= self.good {
                return best;
            }
            if measured.1 > TOLD * found.1 {
                break;
            }
        }
        for (near, aside) in near.into_iter().zip(ASIDE) {
            if let Some(near) = near.filter(|near| near.1 < best.1) {
                let measured = self.approached_to(b, side, aside, near);
                if measured.1 < best.1 {
                    best = measured;
                }
            }
        }
        best
    }

    /// The edge of the cluster on a side, and a step from it of at most `aside` that stays before the next cluster.
    fn step(&self, side: Side, aside: f64) -> (Exact, f64) {
        let (lo, hi) = self.clusters.exact_ends(self.cluster);
        let (edge, slab) = match side {
            Side::Below => (lo, self.clusters.exact_below(self.cluster)),
            Side::Above => (hi, self.clusters.exact_above(self.cluster)),
        };
        (edge, ((slab - edge).to_f64() * 0.5).clamp(-aside, aside))
    }

    /// The place at a distance of at most `aside` from the cluster, and its rounding.
    fn place_aside(&mut self, b: &Branch, side: Side, aside: f64) -> (f64, f64) {
        let (edge, step) = self.step(side, aside);
        let half = self.half;
        let (placing, ends) = self.exact_at(edge + step);
        let (place, rounding) = placing.place_and_rounding(b);
        (from_nearer_end(place, ends, half), ROUNDING + rounding)
    }

    /// The place on a side of the cluster and its error, from the place at a distance of at most `aside` and its rounding.
    fn approached_to(
        &mut self,
        b: &Branch,
        side: Side,
        aside: f64,
        (near, rounding): (f64, f64),
    ) -> (f64, f64) {
        /// Ratio of the displacement towards the other edge of a cluster to that from the near to the far orientation: towards a tangency,
        /// where places move with the square root of the orientation, the worst case, it is (1 + 2^½) for this edge, and 2^½ times that for
        /// the other edge of a cluster as wide as the step.
        const FURTHER: f64 = 4.0;
        let (edge, step) = self.step(side, aside);
        let far = self.exact_place(b, edge + step * 2.0);
        let mut moved = FURTHER * (far - near).abs();
        // The event that ends or begins the cell may happen anywhere in the cluster.
        if self.width > step.abs() {
            let (lo, hi) = self.clusters.exact_ends(self.cluster);
            let other = if side == Side::Below { hi } else { lo };
            moved += (self.exact_place(b, other - step) - near).abs();
        }
        (near, rounding + moved)
    }

    /// The curve in double-double at an orientation, with the places of its ends.
    fn exact_at(&mut self, theta: Exact) -> (&Placing<'a, Exact>, (Exact, Exact)) {
        let known = self.exact.iter().position(|e| e.0 == theta);
        let index = known.unwrap_or_else(|| {
            let (clusters, cluster) = (self.clusters, self.cluster);
            let turn =
                (self.turn).get_or_insert_with(|| Orientation::by(clusters.exact_at(cluster)));
            let placing = Placing::new(self.geometry, self.sheet, turn.turned_to(theta));
            let ends = placing.ends();
            self.exact.push((theta, placing, ends));
            self.exact.len() - 1
        });
        let (_, placing, ends) = &self.exact[index];
        (placing, *ends)
    }

    /// A place at an orientation.
    fn exact_place(&mut self, b: &Branch, theta: Exact) -> f64 {
        let half = self.half;
        let (placing, ends) = self.exact_at(theta);
        from_nearer_end(placing.place(b), ends, half)
    }
}

/// A place limited to the ends of its curve, measured from the nearer end as in f64, in which the curve has half the length `half`.
fn from_nearer_end(place: Exact, (from, to): (Exact, Exact), half: f64) -> f64 {
    let place = if place < from { from } else { place };
    let place = if place > to { to } else { place };
    if place.to_f64() < 0.0 {
        (place - from).to_f64() - half
    } else {
        half - (to - place).to_f64()
    }
}

/// The extent between two places with their errors.
fn extent([(lo, lo_error), (hi, hi_error)]: [(f64, f64); 2]) -> Extent {
    /// Errors of events and places are estimates; this is the factor by which they may be too small.
    const MARGIN: f64 = 2.0;
    Extent {
        lo,
        hi,
        lo_error: MARGIN * lo_error,
        hi_error: MARGIN * hi_error,
    }
}

/// See [`CellExtents::good`].
const GOOD: f64 = 1e-12;

/// Rounding of an orientation and its rotation in f64, radians.
const TURN_ERROR: f64 = 4.0 * f64::EPSILON;

/// Rounding of a place that was found in double-double (length).
const ROUNDING: f64 = 1e-15;
