//! Cutting each sheet into cells by a sweep over orientation.

use rayon::prelude::*;

use crate::contact::{Carrier, Geometry, PLACE_ERROR, place_error, place_on, wrap};
use crate::feature::tolerance::SHORTEST_OVERLAP;
use crate::geometry::{Rotation, Vector};

use super::active::Active;
use super::branch::Branch;
use super::candidates::SheetRun;
use super::cells::{Cell, END, VerticalContact};
use super::clusters::Clusters;
use super::gaps::Gaps;
use super::triple::OnSheet;

/// Everything a sweep reads.
pub(super) struct Sweep<'a> {
    pub(super) geometry: &'a Geometry,
    pub(super) clusters: &'a Clusters,
    pub(super) branches: &'a [Branch],
    pub(super) on_sheet: &'a OnSheet,
    /// Sheets with the clusters at which branches pass each other on them, sorted.
    pub(super) passings: &'a [(u32, u32)],
    /// Sheets with the clusters at which another sheet lies on the same carrier, sorted: their cells end there.
    pub(super) splits: &'a [(u32, u32)],
}

/// The clusters listed for a sheet.
fn listed(list: &[(u32, u32)], sheet: u32) -> impl Iterator<Item = u32> + '_ {
    let from = list.partition_point(|p| p.0 < sheet);
    list[from..]
        .iter()
        .take_while(move |p| p.0 == sheet)
        .map(|p| p.1)
}

/// The cells of all sheets, sorted by sheet, and which continue each other within a sheet.
#[derive(Debug, Default)]
pub(super) struct Cells {
    pub(super) cells: Vec<Cell>,
    pub(super) vertical: Vec<VerticalContact>,
    /// The cells of sheet i are `cells[first[i]..first[i + 1]]`.
    pub(super) first: Vec<u32>,
}

impl Cells {
    /// The cells of a sheet, with their indices.
    pub(super) fn of(&self, sheet: u32) -> impl Iterator<Item = (u32, &Cell)> {
        let (from, to) = (self.first[sheet as usize], self.first[sheet as usize + 1]);
        (from..to).zip(&self.cells[from as usize..to as usize])
    }
}

/// A sheet at one orientation, able to place branches along its curve.
pub(super) struct Placing<'a> {
    geometry: &'a Geometry,
    index: u32,
    carrier: Carrier<f64>,
    turn: Rotation,
    half: f64,
    mid_angle: f64,
}

impl<'a> Placing<'a> {
    pub(super) fn new(geometry: &'a Geometry, index: u32, theta: f64) -> Self {
        let sheet = &geometry.contacts.sheets[index as usize];
        let turn = Rotation::by(theta);
        let (half, mid_angle) = if sheet.is_circle() {
            let (from, to) = (sheet.start_angle.at(theta), sheet.end_angle.at(theta));
            (
                0.5 * (to - from).abs() * sheet.radius.abs(),
                0.5 * (from + to),
            )
        } else {
            let length = sheet
                .normal_at(turn)
                .left()
                .dot(sheet.end.at(turn) - sheet.start.at(turn));
            (0.5 * length, 0.0)
        };
        let carrier = sheet.carrier(turn.cos, turn.sin);
        Self {
            geometry,
            index,
            carrier,
            turn,
            half,
            mid_angle,
        }
    }

    /// The same sheet at another orientation.
    fn turned(&self, theta: f64) -> Self {
        Self::new(self.geometry, self.index, theta)
    }

    /// Half the length of the contact curve.
    pub(super) fn half(&self) -> f64 {
        self.half
    }

    /// The place of a branch: length of travel from the middle of the curve. Where the crossing is just lost, the
    /// nearest place to one.
    pub(super) fn place(&self, b: &Branch) -> f64 {
        let g = self.other_carrier(b);
        self.length_of(place_on(&self.carrier, &g, b.root, b.second == self.index))
    }

    /// The place, not beyond the ends of the curve, and its rounding error.
    fn within(&self, b: &Branch) -> (f64, f64) {
        let g = self.other_carrier(b);
        let v = place_on(&self.carrier, &g, b.root, b.second == self.index);
        let error = place_error(&self.carrier, &g, v);
        let place = self.length_of(v);
        if place.is_nan() {
            return (0.0, f64::INFINITY);
        }
        (place.clamp(-self.half, self.half), error)
    }

    /// What orders branches by their places, as the places themselves would, at less cost.
    ///
    /// On a circle it grows with the angle from the middle of the curve: y / (|x| + |y|) along and across that
    /// direction, continued beyond the quarter turns.
    pub(super) fn ranking(&self) -> impl Fn(&Branch) -> f64 {
        let middle = match self.carrier {
            Carrier::Line { .. } => Vector::ZERO,
            Carrier::Circle { radius, .. } => Vector::from_angle(self.mid_angle) * radius.signum(),
        };
        move |b| {
            let g = self.other_carrier(b);
            let v = place_on(&self.carrier, &g, b.root, b.second == self.index);
            match self.carrier {
                Carrier::Line { .. } => v.0,
                Carrier::Circle { radius, .. } => {
                    let v = Vector::new(v.0, v.1);
                    let (x, y) = (middle.dot(v), middle.cross(v) * radius.signum());
                    let quarter = y / (x.abs() + y.abs());
                    if x >= 0.0 {
                        quarter
                    } else {
                        2.0_f64.copysign(y) - quarter
                    }
                }
            }
        }
    }

    fn other_carrier(&self, b: &Branch) -> Carrier<f64> {
        let other = &self.geometry.contacts.sheets[b.other(self.index) as usize];
        other.carrier(self.turn.cos, self.turn.sin)
    }

    /// Length of travel from the middle to a place as [`place_on`] gives it.
    fn length_of(&self, v: (f64, f64)) -> f64 {
        match self.carrier {
            Carrier::Line { .. } => v.0 - self.half,
            Carrier::Circle { radius, .. } => {
                let v = Vector::new(v.0, v.1) * radius.signum();
                wrap(v.angle() - self.mid_angle) * radius
            }
        }
    }
}

impl Sweep<'_> {
    pub(super) fn run(&self, runs: &[SheetRun]) -> Cells {
        let parts: Vec<Cells> = runs.par_iter().map(|run| self.sheet(run)).collect();
        let mut all = Cells::default();
        for part in parts {
            let offset = all.cells.len() as u32;
            all.cells.extend(part.cells);
            all.vertical
                .extend(part.vertical.into_iter().map(|v| VerticalContact {
                    lower: v.lower + offset,
                    upper: v.upper + offset,
                    ..v
                }));
        }
        all.first = vec![0; self.geometry.contacts.sheets.len() + 1];
        for c in &all.cells {
            all.first[c.sheet as usize + 1] += 1;
        }
        for i in 1..all.first.len() {
            all.first[i] += all.first[i - 1];
        }
        all
    }

    fn sheet(&self, run: &SheetRun) -> Cells {
        let clusters = self.clusters;
        let (first, last) = (clusters.index(run.lo), clusters.index(run.hi));
        let mine = self.on_sheet.of(run.sheet);
        let mut times = vec![first, last];
        let within = |t: &u32| first < *t && *t < last;
        for &b in mine {
            let b = &self.branches[b as usize];
            times.extend([b.from, b.to].iter().filter(|t| within(t)));
        }
        times.extend(listed(self.passings, run.sheet).filter(within));
        let splits: Vec<u32> = listed(self.splits, run.sheet).filter(within).collect();
        times.extend(&splits);
        times.sort_unstable();
        times.dedup();

        let mut gaps = Gaps::of(self.geometry, run.sheet);
        let mut out = Cells::default();
        let mut open: Vec<u32> = Vec::new();
        let mut active = Active::new(self.branches, mine);
        let (mut keys, mut closing): (Vec<(u32, u32)>, Vec<u32>) = (Vec::new(), Vec::new());
        for w in times.windows(2) {
            let (t0, t1) = (w[0], w[1]);
            gaps.arrange(
                self.geometry,
                self.branches,
                run.sheet,
                active.after(t0),
                clusters.between(t0, t1),
            );
            keys.clear();
            keys.extend((0..=gaps.branches()).map(|gap| gaps.bounds(gap)));
            let same = |c: u32, key: &(u32, u32)| {
                let cell: &Cell = &out.cells[c as usize];
                (cell.left, cell.right) == *key
            };
            let split = splits.binary_search(&t0).is_ok();
            let same = |c: u32, key: &(u32, u32)| !split && same(c, key);
            let kept_before = open
                .iter()
                .zip(&keys)
                .take_while(|(c, k)| same(**c, k))
                .count();
            let room = open.len().min(keys.len()) - kept_before;
            let kept_after = open
                .iter()
                .rev()
                .zip(keys.iter().rev())
                .take(room)
                .take_while(|(c, k)| same(**c, k))
                .count();
            let (kept_to, opened_to) = (open.len() - kept_after, keys.len() - kept_after);
            closing.clear();
            closing.extend(&open[kept_before..kept_to]);
            let new_first = out.cells.len() as u32;
            for gap in kept_before..opened_to {
                let (left, right) = keys[gap];
                out.cells.push(Cell {
                    sheet: run.sheet,
                    from: t0,
                    to: t1,
                    left,
                    right,
                    blocked: !gaps.is_open(gap) || (t0 == first && run.lo_blocked),
                    at_bottom: t0 == first && !run.lo_blocked,
                    at_top: false,
                });
            }
            let new = new_first..out.cells.len() as u32;
            if t0 != first && !split {
                self.connect(run.sheet, t0, &closing, new.clone(), &mut out);
            }
            open.splice(kept_before..kept_to, new);
            for &c in &open {
                out.cells[c as usize].to = t1;
            }
        }
        for &c in &open {
            let cell = &mut out.cells[c as usize];
            cell.blocked |= run.hi_blocked;
            cell.at_top = !run.hi_blocked;
        }
        out
    }

    /// Cells that end and cells that begin at one cluster continue each other where they overlap.
    fn connect(
        &self,
        sheet: u32,
        at: u32,
        closing: &[u32],
        opening: core::ops::Range<u32>,
        out: &mut Cells,
    ) {
        let Cells {
            cells, vertical, ..
        } = out;
        // What is blocked below and above is so anyway.
        let matters = |i: u32| !cells[i as usize].blocked;
        let any_matters = closing.iter().copied().chain(opening.clone()).any(matters);
        if closing.is_empty() || opening.is_empty() || !any_matters {
            return;
        }
        let measure = |side: Side| {
            CellExtents::new(self.geometry, self.clusters, self.branches, sheet, at, side)
        };
        let (below, above) = (measure(Side::Below), measure(Side::Above));
        let upper: Vec<(u32, Extent)> =
            opening.map(|c| (c, above.of(&cells[c as usize]))).collect();
        for &lower in closing {
            let b = below.of(&cells[lower as usize]);
            for &(upper, a) in &upper {
                if matters(lower) || matters(upper) {
                    vertical.extend(b.shared_with(&a).map(|shared| VerticalContact {
                        lower,
                        upper,
                        at,
                        lo: shared.lo,
                        hi: shared.hi,
                        certain: shared.certain,
                    }));
                }
            }
        }
    }
}

/// A cell's range along its contact curve at one orientation, with the errors of both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    pub(super) lo: f64,
    pub(super) hi: f64,
    pub(super) lo_error: f64,
    pub(super) hi_error: f64,
}

/// What two cells share of one curve.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shared {
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Whether it is longer than the errors of its ends.
    pub(super) certain: bool,
}

impl Extent {
    /// The common range as measured, if there is one.
    pub(super) fn shared_with(&self, other: &Self) -> Option<Shared> {
        let (lo, lo_error) = if self.lo > other.lo {
            (self.lo, self.lo_error)
        } else {
            (other.lo, other.lo_error)
        };
        let (hi, hi_error) = if self.hi < other.hi {
            (self.hi, self.hi_error)
        } else {
            (other.hi, other.hi_error)
        };
        let length = hi - lo;
        (length > SHORTEST_OVERLAP).then_some(Shared {
            lo,
            hi,
            certain: length > lo_error + hi_error + SHORTEST_OVERLAP,
        })
    }
}

/// On which side of a cluster a cell lies that ends or begins there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Below,
    Above,
}

/// Measures cells of one sheet where they meet a cluster.
///
/// A place is measured at the cluster's orientation. The event that ends or begins the cell may happen anywhere in the
/// cluster; what that may change is bounded by the sharpness of the crossing, or, towards a tangency, seen by measuring
/// again at both edges of the cluster.
pub(super) struct CellExtents<'a> {
    at: Placing<'a>,
    branches: &'a [Branch],
    clusters: &'a Clusters,
    cluster: u32,
    side: Side,
    width: f64,
}

impl<'a> CellExtents<'a> {
    pub(super) fn new(
        geometry: &'a Geometry,
        clusters: &'a Clusters,
        branches: &'a [Branch],
        sheet: u32,
        cluster: u32,
        side: Side,
    ) -> Self {
        Self {
            at: Placing::new(geometry, sheet, clusters.at(cluster)),
            branches,
            clusters,
            cluster,
            side,
            width: clusters.hi(cluster) - clusters.lo(cluster),
        }
    }

    pub(super) fn of(&self, cell: &Cell) -> Extent {
        /// Errors are estimates, of events and of places; this much worse they may be.
        const MARGIN: f64 = 2.0;
        let (lo, lo_error) = self.bound(cell.left, -1.0);
        let (hi, hi_error) = self.bound(cell.right, 1.0);
        Extent {
            lo,
            hi,
            lo_error: MARGIN * lo_error,
            hi_error: MARGIN * hi_error,
        }
    }

    /// The place of a bound and its error. Places beyond the curve's ends are at its ends.
    fn bound(&self, branch: u32, end: f64) -> (f64, f64) {
        /// The largest speed of an end or a crossing, to be divided by the sine, in the pair's frame per radian.
        const SPEED: f64 = 4.0;
        /// Up to this length the sharpness of the crossing hardly changes on the way, and bounds its motion.
        const SHORT: f64 = 1e-8;
        /// A larger rounding error than this is worth a second measurement, in the pair's frame.
        const GOOD: f64 = 1e-7;
        if branch == END {
            return (end * self.at.half(), SPEED * self.width + PLACE_ERROR);
        }
        let b = &self.branches[branch as usize];
        let (at, rounding) = self.at.within(b);
        let error = rounding * (1.0 + SPEED * self.width / PLACE_ERROR);
        if error <= SHORT {
            return (at, error);
        }
        let motion = [
            self.clusters.lo(self.cluster),
            self.clusters.hi(self.cluster),
        ]
        .map(|edge| (self.at.turned(edge).within(b).0 - at).abs());
        let error = rounding + motion[0].max(motion[1]);
        if rounding <= GOOD {
            return (at, error);
        }
        let (place, other) = self.approached(b);
        if other < error {
            (place.clamp(-self.at.half(), self.at.half()), other)
        } else {
            (at, error)
        }
    }

    /// The place measured a little aside. Where two lines become one, their crossing is undefined, yet it has a limit.
    fn approached(&self, b: &Branch) -> (f64, f64) {
        /// How far aside, radians: the motion and the rounding divided by the sine are both about this then.
        const ASIDE: f64 = 1e-7;
        let (edge, slab) = match self.side {
            Side::Below => (
                self.clusters.lo(self.cluster),
                self.clusters.below(self.cluster),
            ),
            Side::Above => (
                self.clusters.hi(self.cluster),
                self.clusters.above(self.cluster),
            ),
        };
        let step = (0.5 * (slab - edge)).clamp(-ASIDE, ASIDE);
        let (near, rounding) = self.at.turned(edge + step).within(b);
        let (far, _) = self.at.turned(edge + 2.0 * step).within(b);
        let theta = self.clusters.at(self.cluster);
        let away = ((edge + step - theta).abs() + self.width) / step.abs();
        // If places move with the square root of the orientation, the worst there is, the limit is 2.4 times further.
        (near, rounding + 3.0 * away * (far - near).abs())
    }
}
