//! A slice of which every curve is drawn again by the features as they are drawn: neither grown nor perturbed.
//!
//! A slice of a pair that is computed with play for exact fits tells which curves there are, and which follows which; each curve is
//! off its place by what the moving part is smaller. Its line or circle and its ends follow from the sheet that it is of, in
//! double-double from the outlines as drawn, and where two curves cross, from both:
//!
//! ```text
//!    computed:  ┌─┐ play of 2·10⁻⁹       drawn again:  ·   one point: an exact fit
//!               └─┘
//! ```

use core::f64::consts::PI;

use crate::contact::{Cycle, Exact, Orientation, Sheet};
use crate::feature::tolerance::{NARROWEST_BAND, ROOM, SAME_CARRIER};
use crate::feature::{FeatureName, Outline, PairFrame};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::Part;
use crate::slice::{CurveGeometry, Slice, SliceCurve};
use crate::space::{Boundary, on_cycle};

use super::slicer::Sliced;

/// Ends of a curve nearer to each other than this are one place: the curve is there only because of the play (length in the pair's
/// frame).
const ONE_PLACE: f64 = 4.0 * ROOM;

/// Crossings of two curves nearer to each other than this are one, at which the curves are tangent: rounding of the drawing tells
/// tangent curves apart by the square root of itself (length in the pair's frame).
const TANGENT: f64 = 1e-7;

/// A place drawn again is nearer than this to what it was (length in the pair's frame): a play of [`ROOM`] moves the end of a curve
/// that is tangent to the next by its square root.
const FARTHEST: f64 = 1e-4;

/// Outlines of a pair as they are drawn.
#[derive(Debug)]
pub(super) struct AsDrawn {
    fixed: Outline,
    moving: Outline,
}

/// A curve of the slice, drawn again.
struct Piece {
    fixed: FeatureName,
    moving: FeatureName,
    /// As it was computed.
    rough: CurveGeometry,
    cycle: Cycle<Exact>,
    /// Where it starts and ends if a feature ends there.
    ends: [Option<Point<Exact>>; 2],
}

impl AsDrawn {
    pub(super) fn new(fixed: &Part, moving: &Part, frame: &PairFrame) -> Self {
        let outline = |part, center| Outline::new(part, center, frame.scale, 0.0);
        Self {
            fixed: outline(fixed, frame.fixed_center),
            moving: outline(moving, frame.moving_center),
        }
    }

    /// The slice drawn again.
    pub(super) fn redrawn(&self, slice: &Slice, sliced: &Sliced) -> Slice {
        let frame = &sliced.geometry.frame;
        let moved = Rotation::by(slice.theta) * frame.moving_center.to_vector();
        let (mut curves, mut doubtful) = (Vec::new(), slice.doubtful);
        let mut loops = Vec::new();
        for indices in &slice.loops {
            let pieces: Option<Vec<Piece>> = (indices.iter())
                .map(|&i| self.piece(slice, sliced, i as usize))
                .collect();
            let drawn = pieces.and_then(|p| outlined(p, frame, moved));
            let drawn = drawn.unwrap_or_else(|| {
                doubtful = true;
                indices.iter().map(|&i| slice.curves[i as usize]).collect()
            });
            let first = curves.len() as u32;
            let count = drawn.len() as u32;
            curves.extend(
                (0..)
                    .zip(drawn)
                    .map(|(k, c): (u32, SliceCurve)| SliceCurve {
                        next: first + (k + 1) % count,
                        ..c
                    }),
            );
            loops.push((first..first + count).collect());
        }
        Slice {
            theta: slice.theta,
            curves,
            loops,
            doubtful,
        }
    }

    /// A curve by its sheet and the outlines as drawn; `None` if features as drawn are others than those that were computed.
    fn piece(&self, slice: &Slice, sliced: &Sliced, index: usize) -> Option<Piece> {
        let (geometry, at) = (&sliced.geometry, sliced.at);
        let (curve, patch) = (&slice.curves[index], sliced.patches.get(index)?);
        let turn = Rotation::by(at);
        let middle = curve.geometry.point(0.5) - geometry.frame.fixed_center;
        let moved = Rotation::by(slice.theta) * geometry.frame.moving_center.to_vector();
        let middle = Point::ORIGIN + (middle + moved) * geometry.frame.scale;
        let name = |sheet: &Sheet| {
            let fixed = self.fixed.features.get(sheet.fixed as usize)?.name;
            let moving = self.moving.features.get(sheet.moving as usize)?.name;
            Some((fixed, moving))
        };
        // How far from the middle of its sheet's curve it is, as a part of half of that; other sheets of the pair are elsewhere.
        let off = |s: &Sheet| {
            let c = s.curve(at, turn);
            c.position(middle).abs() / c.half
        };
        let sheet = (geometry.contacts.sheets.iter())
            .filter(|s| s.lo - NARROWEST_BAND <= at && at <= s.hi + NARROWEST_BAND)
            .filter(|s| s.function() == patch.function)
            .filter(|s| name(s) == Some((curve.fixed, curve.moving)))
            .min_by(|s, t| off(s).total_cmp(&off(t)))?;
        let locus = sheet.exact(&self.fixed, &self.moving);
        let turn = Orientation::by(Exact::from(at)).turn;
        let [start, end] = locus.ends(turn);
        let end_of = |b: &Boundary, p| matches!(b, Boundary::End { .. }).then_some(p);
        Some(Piece {
            fixed: curve.fixed,
            moving: curve.moving,
            rough: curve.geometry,
            cycle: locus.cycle(turn),
            ends: [end_of(&patch.left, start), end_of(&patch.right, end)],
        })
    }
}

/// The loop of some pieces: without those that are there only because of the play, and what goes on in one line or circle is one
/// curve. `None` if a place is far from where it was.
fn outlined(pieces: Vec<Piece>, frame: &PairFrame, moved: Vector) -> Option<Vec<SliceCurve>> {
    let n = pieces.len();
    let inner = |p: Point| Point::ORIGIN + (p - frame.fixed_center + moved) * frame.scale;
    let place = |i: usize| {
        let (before, after) = (&pieces[i], &pieces[(i + 1) % n]);
        let rough = inner(before.rough.point(1.0));
        let end = before.ends[1]
            .or(after.ends[0])
            .map(|p| p.map(Exact::to_f64));
        let p = end.or_else(|| {
            let cycle = before.rounded();
            if goes_on(&cycle, &after.rounded()) {
                let outward = cycle.slope(rough).unit();
                return Some(rough + outward * -cycle.distance(rough));
            }
            let p = crossing(&before.cycle, &after.cycle, rough)?;
            Some(p.map(Exact::to_f64))
        })?;
        (p.distance(rough) <= FARTHEST).then_some(p)
    };
    let places: Option<Vec<Point>> = (0..n).map(place).collect();
    let places = places?;
    // All around a circle that is more than a point.
    let is_round = |piece: &Piece| {
        matches!(piece.rough, CurveGeometry::Arc { sweep, .. } if sweep.abs() > PI)
            && piece.cycle.size.to_f64() > ONE_PLACE
    };
    let is_long = |i: usize| places[(i + n - 1) % n].distance(places[i]) > ONE_PLACE;
    let stays = |&i: &usize| is_long(i) || is_round(&pieces[i]);
    let kept: Vec<usize> = (0..n).filter(stays).collect();
    let curve = |piece: &Piece, geometry| SliceCurve {
        fixed: piece.fixed,
        moving: piece.moving,
        geometry,
        patch: None,
        next: 0,
    };
    let Some(last) = kept.last() else {
        let (_, (at, _)) = on_cycle(&pieces[0].line(), [places[0]; 2], frame, moved);
        let point = CurveGeometry::Segment { start: at, end: at };
        return Some(vec![curve(&pieces[0], point)]);
    };
    let mut start = places[*last];
    let mut drawn: Vec<(Cycle, SliceCurve)> = Vec::with_capacity(kept.len());
    for &i in &kept {
        let cycle = pieces[i].rounded();
        let (geometry, _) = on_cycle(&cycle, [start, places[i]], frame, moved);
        start = places[i];
        match drawn.last_mut() {
            Some((before, c)) if goes_on(before, &cycle) => match joined(&c.geometry, &geometry) {
                Some(both) => c.geometry = both,
                None => drawn.push((cycle, curve(&pieces[i], geometry))),
            },
            _ => drawn.push((cycle, curve(&pieces[i], geometry))),
        }
    }
    // The last may go on in the first.
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
    fn rounded(&self) -> Cycle {
        Cycle {
            through: self.cycle.through.map(Exact::to_f64),
            normal: self.cycle.normal.map(Exact::to_f64),
            weight: self.cycle.weight.to_f64(),
            size: self.cycle.size.to_f64(),
        }
    }

    /// Some line: what a point is drawn on.
    fn line(&self) -> Cycle {
        Cycle::line(Point::ORIGIN, Vector::new(1.0, 0.0))
    }
}

/// Where two cycles cross, of two crossings the one nearer to a place; where they are tangent, or were, the nearest place to that.
fn crossing(before: &Cycle<Exact>, after: &Cycle<Exact>, near: Point) -> Option<Point<Exact>> {
    // A circle that is a point.
    let point = |c: &Cycle<Exact>| (c.is_centred() && c.size.to_f64() < ROOM).then_some(c.through);
    if let Some(p) = point(before).or_else(|| point(after)) {
        return Some(p);
    }
    let both = [0, 1].map(|root| before.at(before.root(after, root, false)));
    let [p, q] = both.map(|p| p.map(Exact::to_f64));
    match (p.is_finite(), q.is_finite()) {
        (true, true) if p.distance(q) <= TANGENT => Some(both[0].midpoint(both[1])),
        (true, true) if q.distance(near) < p.distance(near) => Some(both[1]),
        (true, _) => Some(both[0]),
        (false, true) => Some(both[1]),
        (false, false) => None,
    }
}

/// Whether one cycle is the other, travelled in the same direction.
fn goes_on(before: &Cycle, after: &Cycle) -> bool {
    let alike = match (before.is_line(), after.is_line()) {
        (true, true) => before.normal.dot(after.normal) > 0.0,
        (false, false) => before.weight * after.weight > 0.0,
        _ => false,
    };
    alike && before.is_one_with(after, SAME_CARRIER)
}

/// Two pieces of one line or circle as one; not of a large circle.
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
