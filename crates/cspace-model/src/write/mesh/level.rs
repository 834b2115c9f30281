//! The rows of vertices at one orientation.

use core::f64::consts::TAU;
use std::collections::{BTreeMap, HashMap};

use cspace::{ContactFunction, ContactSpace, CurveGeometry, PatchId, PatchRef, Point, Vector};

/// The boundary of free space within a band: patches, and for each the one that follows.
#[derive(Debug, Clone, Default)]
pub(super) struct Structure {
    /// Patches.
    pub(super) patches: Vec<PatchId>,
    /// Sweeps of their curves, 0 for segments.
    sweeps: Vec<f64>,
    /// The place before each; none where the boundary is broken.
    before: Vec<Option<usize>>,
}

/// Row of vertices in the direction of travel, each with its share of the row's length.
#[derive(Debug, Clone, Default)]
pub(super) struct Row {
    pub(super) vertices: Vec<(u32, f64)>,
}

/// Vertices at one orientation.
#[derive(Debug, Clone, Default)]
pub(super) struct Level {
    pub(super) theta: f64,
    pub(super) points: Vec<Point>,
    /// Rows of the patches of the structure below, in its order; and of that above.
    pub(super) below: Vec<Row>,
    pub(super) above: Vec<Row>,
    /// Pieces of rows that have no counterpart.
    pub(super) unmatched: usize,
}

/// Fineness of rows, in lengths of the model.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// The greatest distance of a chord from its arc.
    pub(super) sagitta: f64,
    /// The longest piece of a line that turns.
    pub(super) turning: f64,
    /// The scale of the frame in which patches are written.
    pub(super) scale: f64,
}

impl Structure {
    pub(super) fn at(space: &ContactSpace, theta: f64) -> Self {
        let slice = space.slice(theta);
        // Every curve of a slice of a space has its patch.
        let patches: Vec<PatchId> = slice.curves.iter().filter_map(|c| c.patch).collect();
        let mut before = vec![None; patches.len()];
        for (i, c) in slice.curves.iter().enumerate() {
            if let Some(slot) = before.get_mut(c.next as usize) {
                *slot = Some(i);
            }
        }
        let sweeps = slice
            .curves
            .iter()
            .map(|c| match c.geometry {
                CurveGeometry::Arc { sweep, .. } => sweep,
                CurveGeometry::Segment { .. } | CurveGeometry::FlatArc { .. } => 0.0,
            })
            .collect();
        Self {
            patches,
            sweeps,
            before,
        }
    }
}

/// A curve of a patch at the level, on one side of it.
struct Curve {
    patch: PatchId,
    start: u32,
    end: u32,
    geometry: CurveGeometry,
    turning: bool,
}

impl Level {
    /// The level between two structures; `merge` is the distance below which points are one, or `None` between
    /// critical orientations, where the structures are the same.
    pub(super) fn new(
        space: &ContactSpace,
        theta: f64,
        below: &Structure,
        above: &Structure,
        merge: Option<f64>,
        fineness: Fineness,
    ) -> Self {
        let Some(merge) = merge else {
            return Builder::new(space, theta, 0.0, fineness).build(&[above], true);
        };
        // A critical orientation is known to some 1e-13, and where curves become tangent the places where they
        // cross are known to the root of that: take the smallest distance that lets everything fit.
        let mut best: Option<Self> = None;
        for factor in [1.0, 10.0, 100.0, 1e3, 1e4, 1e5] {
            let level =
                Builder::new(space, theta, merge * factor, fineness).build(&[below, above], false);
            if best.as_ref().is_none_or(|b| level.unmatched < b.unmatched) {
                best = Some(level);
            }
            if best.as_ref().is_some_and(|b| b.unmatched == 0) {
                break;
            }
        }
        best.unwrap_or_default()
    }
}

struct Builder<'a> {
    space: &'a ContactSpace,
    theta: f64,
    merge: f64,
    fineness: Fineness,
    points: Vec<Point>,
    grid: HashMap<(i64, i64), Vec<u32>>,
    /// For each point the one it was merged with.
    same: Vec<u32>,
}

impl<'a> Builder<'a> {
    fn new(space: &'a ContactSpace, theta: f64, merge: f64, fineness: Fineness) -> Self {
        Self {
            space,
            theta,
            merge,
            fineness,
            points: Vec::new(),
            grid: HashMap::new(),
            same: Vec::new(),
        }
    }

    fn build(mut self, structures: &[&Structure], shared: bool) -> Level {
        let sides: Vec<Vec<Curve>> = structures.iter().map(|s| self.curves(s)).collect();
        self.join_through(&sides);
        let corners = self.points.len() as u32;
        let pieces: Vec<Vec<Vec<Piece>>> = sides
            .iter()
            .map(|side| side.iter().map(|c| self.pieces(c, corners)).collect())
            .collect();
        let unmatched = if shared { 0 } else { unmatched(&pieces) };
        let mut samples: BTreeMap<Key, Vec<u32>> = BTreeMap::new();
        let mut counts: BTreeMap<Key, usize> = BTreeMap::new();
        for (side, of_side) in sides.iter().zip(&pieces) {
            for (curve, list) in side.iter().zip(of_side) {
                for p in list {
                    let n = self.samples(curve, p);
                    let most = counts.entry(p.key).or_insert(n);
                    *most = n.max(*most);
                }
            }
        }
        let mut rows: Vec<Vec<Row>> = Vec::new();
        for (side, of_side) in sides.iter().zip(&pieces) {
            let mut of = Vec::new();
            for (curve, list) in side.iter().zip(of_side) {
                of.push(self.row(curve, list, &counts, &mut samples));
            }
            rows.push(of);
        }
        let above = rows.pop().unwrap_or_default();
        let below = if shared {
            above.clone()
        } else {
            rows.pop().unwrap_or_default()
        };
        Level {
            theta: self.theta,
            points: self.points,
            below,
            above,
            unmatched,
        }
    }

    /// The point's number; that of a point nearby if there is one.
    fn add(&mut self, p: Point) -> u32 {
        let number = self.points.len() as u32;
        if self.merge > 0.0 {
            let cell = self.cell(p);
            if let Some(found) = self.near(p, cell) {
                return found;
            }
            self.grid.entry(cell).or_default().push(number);
        }
        self.points.push(p);
        self.same.push(number);
        number
    }

    fn cell(&self, p: Point) -> (i64, i64) {
        (
            (p.x / self.merge).floor() as i64,
            (p.y / self.merge).floor() as i64,
        )
    }

    fn near(&self, p: Point, cell: (i64, i64)) -> Option<u32> {
        let mut best: Option<(f64, u32)> = None;
        for dx in -1..=1 {
            for dy in -1..=1 {
                let list = self.grid.get(&(cell.0 + dx, cell.1 + dy));
                for &i in list.into_iter().flatten() {
                    let d = self.points[i as usize].distance(p);
                    if d <= self.merge && best.is_none_or(|b| (d, i) < b) {
                        best = Some((d, i));
                    }
                }
            }
        }
        best.map(|b| b.1)
    }

    fn find(&self, mut i: u32) -> u32 {
        while self.same[i as usize] != i {
            i = self.same[i as usize];
        }
        i
    }

    fn union(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.same[a.max(b) as usize] = a.min(b);
    }

    fn curves(&mut self, structure: &Structure) -> Vec<Curve> {
        let ends: Vec<Option<u32>> = structure
            .patches
            .iter()
            .map(|&p| {
                let patch = self.space.patch(p)?;
                Some(self.add(patch.right().at(self.theta).position()))
            })
            .collect();
        let mut curves = Vec::new();
        for (i, &number) in structure.patches.iter().enumerate() {
            let (Some(patch), Some(end)) = (self.space.patch(number), ends[i]) else {
                continue;
            };
            let start = structure.before[i]
                .and_then(|b| ends[b])
                .unwrap_or_else(|| self.add(patch.left().at(self.theta).position()));
            let function = &patch.data().function;
            curves.push(Curve {
                patch: number,
                start,
                end,
                geometry: self.geometry(patch, structure.sweeps[i]),
                turning: matches!(
                    function,
                    ContactFunction::MovingLine { .. }
                        | ContactFunction::FlatCircle { turns: true, .. }
                ),
            });
        }
        curves
    }

    /// The curve of a patch at the level, from its own bounds.
    fn geometry(&self, patch: PatchRef<'_>, usual_sweep: f64) -> CurveGeometry {
        let (left, right) = (patch.left().at(self.theta), patch.right().at(self.theta));
        let (start, end) = (left.position(), right.position());
        match patch.data().function {
            ContactFunction::Circle { radius, .. } => {
                // The gradient in the slice is the unit normal, away from the centre if the radius is positive.
                let radius = radius / self.fineness.scale;
                let g = patch.gradient(left);
                let center = start - Vector::new(g[0], g[1]) * radius;
                let (a, b) = (start - center, end - center);
                let mut turned = a.cross(b).atan2(a.dot(b)) * radius.signum();
                // A curve that has shrunk to a point may have its ends in the wrong order by rounding.
                if turned < 0.0 {
                    let shrunk = turned > -1e-3 && usual_sweep.abs() < 3.0;
                    turned = if shrunk { 0.0 } else { turned + TAU };
                }
                CurveGeometry::Arc {
                    center,
                    radius: radius.abs(),
                    start_angle: a.angle(),
                    sweep: turned * radius.signum(),
                }
            }
            ContactFunction::FlatCircle { radius, .. } => {
                // Half the chord is the radius times the sine of half the sweep; the bulge is the tangent of a quarter.
                let half = 0.5 * start.distance(end) * self.fineness.scale / radius;
                let bulge = half / (1.0 + ((1.0 - half) * (1.0 + half)).max(0.0).sqrt());
                CurveGeometry::FlatArc { start, end, bulge }
            }
            _ => CurveGeometry::Segment { start, end },
        }
    }

    /// A patch that is on both sides has the same ends on both.
    fn join_through(&mut self, sides: &[Vec<Curve>]) {
        let [below, above] = sides else {
            return;
        };
        let mut at: HashMap<PatchId, (u32, u32)> = HashMap::new();
        for c in below {
            at.insert(c.patch, (c.start, c.end));
        }
        for c in above {
            if let Some(&(start, end)) = at.get(&c.patch) {
                self.union(start, c.start);
                self.union(end, c.end);
            }
        }
    }

    /// The curve cut where ends of other curves lie on it.
    fn pieces(&mut self, curve: &Curve, corners: u32) -> Vec<Piece> {
        let mut marks = vec![(0.0, self.find(curve.start)), (1.0, self.find(curve.end))];
        if self.merge > 0.0 {
            let (start, end) = (marks[0].1, marks[1].1);
            for i in 0..corners {
                if self.same[i as usize] != i || i == start || i == end {
                    continue;
                }
                let share = share(&curve.geometry, self.points[i as usize], self.merge);
                marks.extend(share.map(|s| (s, i)));
            }
            marks.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        }
        let length = curve.geometry.length();
        let mut pieces = Vec::new();
        for w in marks.windows(2) {
            let ((from, a), (to, b)) = (w[0], w[1]);
            // A whole circle begins where it ends.
            if a == b && (to - from) * length <= 8.0 * self.merge.max(f64::MIN_POSITIVE) {
                continue;
            }
            let middle = if self.merge > 0.0 {
                let m = self.add(curve.geometry.point(0.5 * (from + to)));
                self.find(m)
            } else {
                // Between critical orientations nothing coincides: the patch is name enough.
                curve.patch.0
            };
            pieces.push(Piece {
                from,
                to,
                key: (a.min(b), a.max(b), middle),
                forward: if a == b {
                    !matches!(curve.geometry, CurveGeometry::Arc { sweep, .. } if sweep < 0.0)
                } else {
                    a < b
                },
            });
        }
        pieces
    }

    /// Into how many parts a piece is cut.
    fn samples(&self, curve: &Curve, piece: &Piece) -> usize {
        let share = piece.to - piece.from;
        let parts = match curve.geometry {
            CurveGeometry::Arc { radius, sweep, .. } => {
                let step = 2.0 * (1.0 - self.fineness.sagitta / radius).max(0.866).acos();
                share * sweep.abs() / step
            }
            CurveGeometry::Segment { .. } if curve.turning => {
                share * curve.geometry.length() / self.fineness.turning
            }
            CurveGeometry::Segment { .. } => 1.0,
            CurveGeometry::FlatArc { start, end, bulge } => {
                // n pieces are off the arc by its height / n².
                let height = 0.5 * bulge.abs() * start.distance(end);
                let turning = if curve.turning {
                    curve.geometry.length() / self.fineness.turning
                } else {
                    1.0
                };
                share * (height / self.fineness.sagitta).sqrt().max(turning)
            }
        };
        // A share of the tolerance bounds this; the limit is against what is not finite.
        (parts - 1e-9).ceil().clamp(1.0, 4096.0) as usize
    }

    fn row(
        &mut self,
        curve: &Curve,
        pieces: &[Piece],
        counts: &BTreeMap<Key, usize>,
        samples: &mut BTreeMap<Key, Vec<u32>>,
    ) -> Row {
        let mut vertices = vec![(self.find(curve.start), 0.0)];
        for p in pieces {
            let n = counts.get(&p.key).copied().unwrap_or(1);
            let inner = samples.entry(p.key).or_insert_with(|| {
                let mut list: Vec<u32> = (1..n)
                    .map(|k| {
                        let s = p.from + (p.to - p.from) * k as f64 / n as f64;
                        let number = self.points.len() as u32;
                        self.points.push(curve.geometry.point(s));
                        self.same.push(number);
                        number
                    })
                    .collect();
                if !p.forward {
                    list.reverse();
                }
                list
            });
            let mut push = |k: usize, v: u32| {
                let s = p.from + (p.to - p.from) * (k + 1) as f64 / n as f64;
                vertices.push((v, s));
            };
            let m = inner.len();
            for k in 0..m {
                push(k, inner[if p.forward { k } else { m - 1 - k }]);
            }
            push(m, if p.forward { p.key.1 } else { p.key.0 });
        }
        Row { vertices }
    }
}

/// Two end points, and a point between that distinguishes curves through both.
type Key = (u32, u32, u32);

/// A part of a curve between two points of the level.
struct Piece {
    from: f64,
    to: f64,
    key: Key,
    /// Whether it is travelled from the smaller number to the larger.
    forward: bool,
}

/// Pieces that do not have as many counterparts in the opposite direction.
fn unmatched(pieces: &[Vec<Vec<Piece>>]) -> usize {
    let mut sums: BTreeMap<Key, i32> = BTreeMap::new();
    for (side, sign) in pieces.iter().zip([1, -1]) {
        for p in side.iter().flatten() {
            *sums.entry(p.key).or_default() += if p.forward { sign } else { -sign };
        }
    }
    sums.values().filter(|s| **s != 0).count()
}

/// Share of a curve's length at which a point lies, if it is within the curve.
fn share(geometry: &CurveGeometry, p: Point, near: f64) -> Option<f64> {
    let s = match *geometry {
        CurveGeometry::Segment { start, end } => {
            let v = end - start;
            let length = v.length();
            if length <= 0.0 || (v.cross(p - start) / length).abs() > near {
                return None;
            }
            v.dot(p - start) / (length * length)
        }
        CurveGeometry::FlatArc { start, end, bulge } => {
            let v = end - start;
            let length = v.length();
            let off = geometry.nearest(p).distance(p);
            if length <= 0.0 || off > near || bulge.abs() > 1.0 {
                return None;
            }
            // Along the chord, which is as long as the arc but for some of the bulge's square.
            v.dot(p - start) / (length * length)
        }
        CurveGeometry::Arc {
            center,
            radius,
            start_angle,
            sweep,
        } => {
            if ((p - center).length() - radius).abs() > near || sweep == 0.0 {
                return None;
            }
            let turned = ((p - center).angle() - start_angle) * sweep.signum();
            (turned - TAU * (turned / TAU).floor()) / sweep.abs()
        }
    };
    (s > 0.0 && s < 1.0).then_some(s)
}
