//! Recomputes the curves of a slice from the features as drawn: neither grown nor perturbed.
//!
//! The slice of a pair that is computed with play for exact fits gives the curves and their order; each curve is displaced by the amount by
//! which the moving part is shrunk. Its line or circle and its ends follow from its sheet, in double-double from the outlines as drawn, and
//! where two curves cross, from both:
//!
//! ```text
//!    computed:  ┌─┐ play of 2·10⁻⁹       drawn again:  ·   one point: an exact fit
//!               └─┘
//! ```

use core::f64::consts::FRAC_PI_2;

use crate::contact::{Cycle, Exact, Orientation, Sheet};
use crate::feature::tolerance::{NEGLIGIBLE, ROOM};
use crate::feature::{FeatureName, Outline, PairFrame};
use crate::geometry::{Configuration, Point, Rotation};
use crate::part::Part;
use crate::slice::{CurveGeometry, Slice, SliceCurve};
use crate::space::{Boundary, on_cycle};

use super::slicer::Sliced;

/// Distance of the ends of a curve below which they are one place: the curve exists only because of the play (length in the pair's frame).
const ONE_PLACE: f64 = 4.0 * ROOM;

/// Distance of two crossings of two curves below which they are one, at which the curves are tangent: rounding of the drawing separates
/// tangent curves by the square root of itself (length in the pair's frame).
const TANGENT: f64 = 1e-7;

/// Largest displacement of a recomputed place (length in the pair's frame): a play of [`ROOM`] moves the end of a curve that is tangent to
/// the next by its square root.
const FARTHEST: f64 = 1e-3;

/// Outlines of a pair as drawn.
#[derive(Debug)]
pub(super) struct AsDrawn {
    fixed: Outline,
    moving: Outline,
}

/// A recomputed curve of the slice.
struct Piece {
    fixed: FeatureName,
    moving: FeatureName,
    /// The curve as it was computed.
    rough: CurveGeometry,
    /// Whether that is longer than its sheet's curve: its ends have just passed each other, so that it seems to be a whole circle.
    passed: bool,
    cycle: Cycle<Exact>,
    /// Start and end, where a feature ends there.
    ends: [Option<Point<Exact>>; 2],
}

impl AsDrawn {
    pub(super) fn new(fixed: &Part, moving: &Part, frame: &PairFrame) -> Self {
        let outline = |part, center| Outline::new(part, center, frame.scale, (0.0, 0.0));
        Self {
            fixed: outline(fixed, frame.fixed_center),
            moving: outline(moving, frame.moving_center),
        }
    }

    /// The recomputed slice.
    pub(super) fn redrawn(&self, slice: &Slice, sliced: &Sliced) -> Slice {
        let frame = &sliced.geometry.frame;
        let mut doubtful = slice.doubtful;
        let mut drawn = |indices: &Vec<u32>| {
            let pieces = indices
                .iter()
                .map(|&i| self.piece(slice, sliced, i as usize));
            let pieces: Option<Vec<Piece>> = pieces.collect();
            let drawn = pieces.and_then(|p| outlined(p, frame, slice.theta));
            drawn.unwrap_or_else(|| {
                doubtful = true;
                slice.along(indices).collect()
            })
        };
        let loops = slice.loops.iter().map(&mut drawn).collect();
        Slice::of_loops(slice.theta, loops, doubtful)
    }

    /// Recomputes a curve from its sheet and the outlines as drawn; `None` if the features as drawn differ from those computed.
    fn piece(&self, slice: &Slice, sliced: &Sliced, index: usize) -> Option<Piece> {
        let (geometry, at) = (&sliced.geometry, sliced.at);
        let (curve, patch) = (&slice.curves[index], sliced.patches.get(index)?);
        let turn = Rotation::by(at);
        let middle = inner(&geometry.frame, curve.geometry.point(0.5), slice.theta);
        let name = |sheet: &Sheet| {
            let fixed = self.fixed.features.get(sheet.fixed as usize)?.name;
            let moving = self.moving.features.get(sheet.moving as usize)?.name;
            Some((fixed, moving))
        };
        // Distance of the curve from the middle of a sheet's curve, relative to half of that curve's length; other sheets of the pair are
        // elsewhere.
        let off = |s: &Sheet| {
            let c = s.curve(at, turn);
            c.position(middle).abs() / c.half
        };
        let sheet = (geometry.contacts.sheets.iter())
            .filter(|s| s.function() == patch.function)
            .filter(|s| name(s) == Some((curve.fixed, curve.moving)))
            .min_by(|s, t| off(s).total_cmp(&off(t)))?;
        let whole = sheet.curve(at, turn).half;
        let locus = sheet.exact(&self.fixed, &self.moving);
        let turn = Orientation::by(Exact::from(at)).turn;
        let [start, end] = locus.ends(turn);
        let end_of = |b: &Boundary, p| matches!(b, Boundary::End { .. }).then_some(p);
        Some(Piece {
            fixed: curve.fixed,
            moving: curve.moving,
            rough: curve.geometry,
            passed: curve.geometry.length() * geometry.frame.scale > 2.0 * whole + ONE_PLACE,
            cycle: locus.carrier.cycle(turn),
            ends: [end_of(&patch.left, start), end_of(&patch.right, end)],
        })
    }
}

/// A position at an orientation, in the pair's frame.
fn inner(frame: &PairFrame, p: Point, theta: f64) -> Point {
    frame.inner_from_outer(Configuration::new(p.x, p.y, theta))
}

/// The loop of some pieces: pieces that exist only because of the play are dropped, and consecutive pieces of one line or circle are
/// joined. `None` if a place is far from where it was.
fn outlined(pieces: Vec<Piece>, frame: &PairFrame, theta: f64) -> Option<Vec<SliceCurve>> {
    let n = pieces.len();
    let moved = Rotation::by(theta) * frame.moving_center.to_vector();
    let place = |i: usize| {
        let (before, after) = (&pieces[i], &pieces[(i + 1) % n]);
        let rough = inner(frame, before.rough.point(1.0), theta);
        let end = before.ends[1]
            .or(after.ends[0])
            .map(|p| p.map(Exact::to_f64));
        let p = end.or_else(|| crossing(before, after, rough))?;
        (p.distance(rough) <= FARTHEST).then_some(p)
    };
    // Each piece with its end; it starts where the one before it ends.
    let ends: Option<Vec<Point>> = (0..n).map(place).collect();
    let mut kept: Vec<(&Piece, Point)> = pieces.iter().zip(ends?).collect();
    loop {
        let n = kept.len();
        let start = |i: usize| kept[(i + n - 1) % n].1;
        let Some(i) = (0..n).find(|&i| kept[i].0.is_only_play(start(i), kept[i].1)) else {
            break;
        };
        let (first, last) = (start(i), kept[i].1);
        if n == 1 {
            let at = frame.outer_from_inner(last, theta).position();
            let point = CurveGeometry::Segment { start: at, end: at };
            return Some(vec![kept[0].0.curve(point)]);
        }
        // The pieces before and after it meet there.
        let (before, after) = (kept[(i + n - 1) % n].0, kept[(i + 1) % n].0);
        let within = ONE_PLACE.max(2.0 * first.distance(last));
        let met = crossing(before, after, first).filter(|p| p.distance(first) <= within);
        kept[(i + n - 1) % n].1 = met.unwrap_or(first);
        kept.remove(i);
    }
    let mut start = kept.last()?.1;
    let mut drawn: Vec<(Cycle, SliceCurve)> = Vec::with_capacity(kept.len());
    for (piece, end) in kept {
        let cycle = piece.cycle.rounded();
        let (geometry, _) = on_cycle(&cycle, [start, end], frame, moved);
        start = end;
        if let Some((before, curve)) = drawn.last_mut()
            && goes_on(before, &cycle)
            && let Some(both) = joined(&curve.geometry, &geometry)
        {
            curve.geometry = both;
        } else {
            drawn.push((cycle, piece.curve(geometry)));
        }
    }
    // The last curve may continue in the first.
    if let [first, .., last] = &mut drawn[..]
        && goes_on(&last.0, &first.0)
        && let Some(both) = joined(&last.1.geometry, &first.1.geometry)
    {
        first.1.geometry = both;
        drawn.pop();
    }
    Some(drawn.into_iter().map(|d| d.1).collect())
}

impl Piece {
    /// Whether a piece exists only because of the play: it is one place, or leads back.
    fn is_only_play(&self, start: Point, end: Point) -> bool {
        let (cycle, off) = (self.cycle.rounded(), start.distance(end));
        let travel = if cycle.is_centred() {
            let (from, to) = (start - cycle.through, end - cycle.through);
            from.cross(to).atan2(from.dot(to)) * cycle.weight
        } else {
            cycle.place(end).x - cycle.place(start).x
        };
        // If it was most of a circle, its short remainder does not show that it leads back.
        let is_round =
            matches!(self.rough, CurveGeometry::Arc { sweep, .. } if sweep.abs() > FRAC_PI_2);
        if is_round && !self.passed && cycle.size > ONE_PLACE {
            return false;
        }
        off <= ONE_PLACE || (travel < 0.0 && (self.passed || off <= FARTHEST))
    }

    fn curve(&self, geometry: CurveGeometry) -> SliceCurve {
        SliceCurve {
            fixed: self.fixed,
            moving: self.moving,
            geometry,
            patch: None,
            next: 0,
        }
    }
}

/// Place where one piece ends and another begins: of two crossings the one nearer to a given place; on one line or circle that place; and
/// where they are tangent, or were, the place nearest to both.
fn crossing(before: &Piece, after: &Piece, near: Point) -> Option<Point> {
    let one = before.cycle.rounded();
    if goes_on(&one, &after.cycle.rounded()) {
        return Some(near + one.slope(near).unit() * -one.distance(near));
    }
    let (before, after) = (&before.cycle, &after.cycle);
    // A circle so small that it is a point.
    let point = |c: &Cycle<Exact>| c.is_centred() && c.size.to_f64() < ROOM;
    if let Some(c) = [before, after].into_iter().find(|c| point(c)) {
        return Some(c.through.map(Exact::to_f64));
    }
    let both = [0, 1].map(|root| before.at(before.root(after, root, false)));
    let [p, q] = both.map(|p| p.map(Exact::to_f64));
    match (p.is_finite(), q.is_finite()) {
        (true, true) if p.distance(q) <= TANGENT => Some(p.midpoint(q)),
        (true, true) if q.distance(near) < p.distance(near) => Some(q),
        (true, _) => Some(p),
        (false, true) => Some(q),
        (false, false) => None,
    }
}

/// Whether one cycle is the other, traversed in the same direction.
fn goes_on(before: &Cycle, after: &Cycle) -> bool {
    let alike = match (before.is_line(), after.is_line()) {
        (true, true) => before.normal.dot(after.normal) > 0.0,
        (false, false) => before.weight * after.weight > 0.0,
        _ => false,
    };
    alike && before.is_one_with(after, NEGLIGIBLE)
}

/// Two pieces of one line or circle as one; `None` for a large circle.
fn joined(before: &CurveGeometry, after: &CurveGeometry) -> Option<CurveGeometry> {
    match (*before, *after) {
        (CurveGeometry::Segment { start, .. }, CurveGeometry::Segment { end, .. }) => {
            Some(CurveGeometry::Segment { start, end })
        }
        (
            CurveGeometry::Arc {
                center,
                radius,
                start_angle,
                sweep,
            },
            CurveGeometry::Arc { sweep: more, .. },
        ) => Some(CurveGeometry::Arc {
            center,
            radius,
            start_angle,
            sweep: sweep + more,
        }),
        _ => None,
    }
}
