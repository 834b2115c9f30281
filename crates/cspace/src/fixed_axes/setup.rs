//! Quantities that follow from the parts and their axes alone: frame, motions, outlines, and ranges of the coordinates.

use super::axis::{AxesError, Axis, AxisMotion, Role};
use super::displacement::Displacement;
use super::motion::{Extent, ExtentKind, Motion, Motions};
use super::repeats::Repeats;
use super::scene::{Scene, Side};
use super::tolerance::{INDEPENDENT, LAYER_APART};
use crate::contact::{Body, Permutation, overlap};
use crate::feature::tolerance::{CONTACT, GROWTH, MOVING_GROWTH};
use crate::feature::{Feature, FeatureName, Outline, PairFrame, as_drawn};
use crate::geometry::{Point, Vector};
use crate::part::{Corresponding, Part, SYMMETRIC, Symmetrized, Vertex};
use core::f64::consts::{FRAC_PI_2, TAU};

/// The farthest pivot, in units of the parts' size: positions are then right to a hundredth of the first part's growth.
const FARTHEST: f64 = 32.0;
/// The smallest angle between two slides neither of which has a range (radians and sine): below it they meet more than a million sizes
/// away, where rounding exceeds the resolution.
const LEAST_ANGLE: f64 = 1.0 / (1u64 << 20) as f64;
/// Distance of pivots below which they are united (pair's frame): more than the largest displacement by a [`Displacement`].
const SAME_PIVOT: f64 = 1e-8;
/// Angle of slides below which they are parallel (radians): their sides cannot be distinguished better.
const SAME_DIRECTION: f64 = 1e-10;
/// The longest range of a turning part, in turns.
const MOST_TURNS: u32 = 1000;

/// Both parts in the frame of the pair, the one whose coordinate is swept first: the data for queries, and the data used only for computing
/// the partition. The plane is swept along the coordinate of the part `along`, if given.
pub(super) fn set_up(
    (fixed, moving): (&Part, &Part),
    (fixed_axis, moving_axis): (Axis, Axis),
    displacement: Displacement,
    along: Option<Role>,
) -> Result<(Setting, Scene), AxesError> {
    let straight = (straightened(fixed), straightened(moving));
    let fixed = straight.0.as_ref().map_or(fixed, |s| &s.0);
    let moving = straight.1.as_ref().map_or(moving, |s| &s.0);
    let frame = PairFrame::new(fixed, moving);
    let mut motions = Motions {
        first: motion(&fixed_axis, Role::Fixed, &frame)?,
        second: motion(&moving_axis, Role::Moving, &frame)?,
    };
    let joined = motions.join_pivots(SAME_PIVOT);
    let mut symmetric = (
        Symmetric::find(fixed, &fixed_axis),
        Symmetric::find(moving, &moving_axis),
    );
    let rank = |m: &Motion, s: &Option<Symmetric>| match m {
        Motion::Turn { .. } => 2 + s.as_ref().map_or(0, |s| s.redrawn.fold),
        Motion::Slide { .. } => 1,
        Motion::Still => 0,
    };
    let swapped = match along {
        Some(role) => role == Role::Moving,
        None => rank(&motions.second, &symmetric.1) > rank(&motions.first, &symmetric.0),
    };
    let mut parts = (fixed, moving);
    let mut axes = (fixed_axis, moving_axis);
    if swapped {
        parts = (parts.1, parts.0);
        axes = (axes.1, axes.0);
        symmetric = (symmetric.1, symmetric.0);
        motions = motions.swapped();
    }
    let unlimited = axes.0.range.is_none() && axes.1.range.is_none();
    let angle = motions.between_slides().filter(|_| unlimited);
    if let Some(angle) = angle.filter(|a| (INDEPENDENT..LEAST_ANGLE).contains(a)) {
        return Err(AxesError::NearlyParallel {
            angle,
            least: LEAST_ANGLE,
        });
    }
    let tilt = motions.join_slides(SAME_DIRECTION);
    if !displacement.is_none() {
        // Its outline is no longer about its pivot.
        symmetric.0 = None;
        // For slides along one line without limits only the difference matters, and this must remain so.
        let apart = angle.is_none_or(|a| a >= INDEPENDENT);
        motions.first = displacement.tilted(motions.first, false);
        motions.second = displacement.tilted(motions.second, apart);
    }
    let unit = |m: &Motion| if m.turns() { 1.0 } else { 1.0 / frame.scale };
    let map = Map {
        frame,
        swapped,
        x_unit: unit(&motions.first),
        y_unit: unit(&motions.second),
    };
    // The fixed part is the one that is grown more. All sums of steps of the two parts differ by a step at least.
    let count = |part: &Part| part.layers().len() as f64;
    let layers = (count(fixed), count(moving));
    let drawn = |part: &Part, center: Point, fixed, closing| {
        let growth = match fixed {
            true => (GROWTH + closing, LAYER_APART),
            false => (MOVING_GROWTH, LAYER_APART * layers.0),
        };
        let outline = Outline::new(part, center, frame.scale, growth);
        let body = Body::new(&outline, part, center, frame.scale, 0.0);
        (outline, body)
    };
    let shifts = displacement.shifts();
    let about = |shift: Vector| frame.fixed_center + shift * (-1.0 / frame.scale);
    let turned = displacement.turned(parts.1, frame.fixed_center);
    let turned = turned.as_ref().unwrap_or(parts.1);
    let first_drawn = |closing| drawn(parts.0, about(shifts.0), !swapped, closing);
    let second_drawn = |closing| drawn(turned, about(shifts.1), swapped, closing);
    let repeating = symmetric.0.and_then(|s| {
        let center = s.center_in(&frame);
        let first = drawn(&s.redrawn.part, center, !swapped, 0.0);
        let repeats = s.repeats(&first.0)?;
        Some((first, repeats, Some(s)))
    });
    let (mut first, repeats, symmetric) = repeating.unwrap_or_else(|| {
        let first = first_drawn(0.0);
        let repeats = Repeats::none(&first.0);
        (first, repeats, None)
    });
    let mut second = second_drawn(0.0);
    let farthest = |axis: &Axis, unit: f64| {
        let far = |(lo, hi): (f64, f64)| lo.abs().max(hi.abs()) / unit;
        axis.range.map(far)
    };
    let ranges = (farthest(&axes.0, map.x_unit), farthest(&axes.1, map.y_unit));
    let reach = reach(&first.0, &second.0, &motions, ranges);
    let x = extent(&axes.0, &motions.first, map.x_unit, reach);
    let y = extent(&axes.1, &motions.second, map.y_unit, reach);
    let slide = |m: &Motion, e: &Extent| match m {
        Motion::Slide { .. } => e.lo.abs().max(e.hi.abs()),
        _ => 0.0,
    };
    let slides = slide(&motions.first, &x) + slide(&motions.second, &y);
    // A displacement opens nothing that contact closes (a passage between parts that are drawn flush): growth outdoes it.
    let closing = displacement.deviation(slides);
    if !displacement.is_none() {
        (first, second) = (first_drawn(closing), second_drawn(closing));
    }
    let ((first, first_body), (second, second_body)) = (first, second);
    let grown = frame.grown((fixed, GROWTH + closing), (moving, MOVING_GROWTH));
    let grown = frame.outer_length(grown);
    let of_straight = |s: Option<(Part, f64)>| s.map_or(0.0, |s| s.1);
    let bent = of_straight(straight.0) + of_straight(straight.1);
    let deviation = bent
        + frame.outer_length(LAYER_APART * (layers.0 * layers.1 - 1.0))
        + frame.outer_length(joined + tilt * slides)
        + symmetric.as_ref().map_or(0.0, |s| s.deviation)
        + frame.outer_length(closing + closing);
    let redrawn = symmetric.map(|s| s.redrawn);
    let name = |f: &Feature| as_drawn(&redrawn, f.name);
    let setting = Setting {
        map,
        motions,
        x,
        y,
        deviation,
        grown,
        names: (
            first.features.iter().map(name).collect(),
            second.features.iter().map(|f| f.name).collect(),
        ),
        bodies: Bodies {
            first: first_body,
            second: second_body,
            motions,
        },
    };
    let scene = Scene {
        x,
        y,
        first: Side::new(first),
        second: Side::new(second),
        motions,
        repeats,
    };
    Ok((setting, scene))
}

/// A part that is symmetric about the point about which it turns without limits.
struct Symmetric {
    redrawn: Symmetrized,
    pivot: Point,
    /// Deviation of the exactly symmetric part from the drawing.
    deviation: f64,
}

impl Symmetric {
    fn find(part: &Part, axis: &Axis) -> Option<Self> {
        let AxisMotion::Revolute { center: pivot } = axis.motion else {
            return None;
        };
        if axis.range.is_some() {
            return None;
        }
        let redrawn = part.symmetrized(Corresponding::Outlines)?;
        let aside = redrawn.center.distance(pivot);
        (aside <= SYMMETRIC * part.size()).then_some(Self {
            deviation: redrawn.deviation + aside,
            redrawn,
            pivot,
        })
    }

    /// The point of the part, as redrawn about its own centre, that becomes the origin of the frame.
    fn center_in(&self, frame: &PairFrame) -> Point {
        Point::ORIGIN + (frame.fixed_center - self.pivot)
    }

    /// Symmetry of the features; `None` if they do not correspond.
    fn repeats(&self, outline: &Outline) -> Option<Repeats> {
        let step = Permutation::of_loops(outline, &self.redrawn.images)?;
        Some(Repeats::new(outline, self.redrawn.fold, &step))
    }
}

fn motion(axis: &Axis, part: Role, frame: &PairFrame) -> Result<Motion, AxesError> {
    if let Some((lo, hi)) = axis.range {
        if !(lo.is_finite() && hi.is_finite()) {
            return Err(AxesError::NotFinite { part });
        }
        if lo >= hi {
            return Err(AxesError::EmptyRange { part, lo, hi });
        }
    }
    match axis.motion {
        AxisMotion::Fixed => Ok(Motion::Still),
        AxisMotion::Revolute { center } => {
            if !center.is_finite() {
                return Err(AxesError::NotFinite { part });
            }
            let center = Point::ORIGIN + (center - frame.fixed_center) * frame.scale;
            let times = center.to_vector().length();
            if times > FARTHEST {
                return Err(AxesError::TooFar {
                    part,
                    times,
                    limit: FARTHEST,
                });
            }
            if let Some((lo, hi)) = axis.range {
                let turns = (hi - lo) / TAU;
                if turns > f64::from(MOST_TURNS) {
                    return Err(AxesError::TooManyTurns {
                        part,
                        turns,
                        limit: MOST_TURNS,
                    });
                }
            }
            Ok(Motion::Turn { center })
        }
        AxisMotion::Prismatic { direction } => {
            if !(direction.x.is_finite() && direction.y.is_finite()) {
                return Err(AxesError::NotFinite { part });
            }
            let unit = direction.unit();
            if !unit.length().is_finite() || unit == Vector::ZERO {
                return Err(AxesError::NoDirection { part });
            }
            Ok(Motion::Slide { direction: unit })
        }
    }
}

/// Largest displacement of sliding parts from where they are drawn at which they can still touch, in the frame of the pair, given the
/// ranges of both coordinates.
fn reach(
    first: &Outline,
    second: &Outline,
    motions: &Motions,
    ranges: (Option<f64>, Option<f64>),
) -> f64 {
    let radius = |o: &Outline| {
        let of = |f: &Feature| {
            let far = |j: u32| o.joints[j as usize].point.to_vector().length();
            let round = match f.near {
                // Its ends are as far from the middle point as any point of it.
                Some(near) => {
                    let half = |j: u32| o.joints[j as usize].point.distance(near.point);
                    near.point.to_vector().length() + half(f.start).max(half(f.end))
                }
                None => f.center.to_vector().length() + f.radius.abs(),
            };
            far(f.start).max(far(f.end)).max(round)
        };
        o.features.iter().map(of).fold(0.0, f64::max)
    };
    let arm = |m: &Motion| match m {
        Motion::Turn { center } => 2.0 * center.to_vector().length(),
        _ => 0.0,
    };
    let apart = radius(first) + radius(second) + arm(&motions.first) + arm(&motions.second) + 1.0;
    match motions.between_slides() {
        Some(cross) => {
            // |x d − y e| is at most `apart`: both coordinates are bounded if one is, and also if the directions differ.
            let bound = [ranges.0, ranges.1].into_iter().flatten();
            let bound = bound.fold(f64::INFINITY, f64::min) + apart;
            if cross >= INDEPENDENT {
                bound.min(apart / cross)
            } else if bound.is_finite() {
                bound
            } else {
                // Only the difference of the coordinates matters.
                apart
            }
        }
        None => apart,
    }
}

fn extent(axis: &Axis, motion: &Motion, unit: f64, reach: f64) -> Extent {
    let limits = |kind| {
        axis.range.map(|(lo, hi)| Extent {
            lo: lo / unit,
            hi: hi / unit,
            kind,
        })
    };
    match motion {
        Motion::Turn { .. } => limits(ExtentKind::TurnLimits).unwrap_or_else(Extent::circle),
        Motion::Slide { .. } => limits(ExtentKind::SlideLimits).unwrap_or(Extent {
            lo: -reach,
            hi: reach,
            kind: ExtentKind::Open,
        }),
        // The coordinate is 0; any interval about it can be used.
        Motion::Still => Extent {
            lo: -FRAC_PI_2,
            hi: FRAC_PI_2,
            kind: ExtentKind::Open,
        },
    }
}

// The frame of the sweep: the map from the motions u and v to its coordinates x and y, their ranges, and the parts in it.

/// Map from u and v to x and y and back.
///
/// x is the coordinate along which the plane is swept: that of a part that turns, if there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Map {
    pub(super) frame: PairFrame,
    pub(super) swapped: bool,
    /// Model units per unit of x and y.
    pub(super) x_unit: f64,
    pub(super) y_unit: f64,
}

impl Map {
    pub(super) fn inner(&self, u: f64, v: f64) -> (f64, f64) {
        let (x, y) = self.exchanged(u, v);
        (x / self.x_unit, y / self.y_unit)
    }

    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let (x, y) = (x * self.x_unit, y * self.y_unit);
        self.exchanged(x, y)
    }

    /// Values for x and y as values for u and v.
    pub(super) fn exchanged<T>(&self, of_x: T, of_y: T) -> (T, T) {
        if self.swapped {
            (of_y, of_x)
        } else {
            (of_x, of_y)
        }
    }

    /// Model units per unit of u and of v.
    pub(super) fn units(&self) -> (f64, f64) {
        self.outer(1.0, 1.0)
    }
}

/// Both parts, prepared for overlap tests.
#[derive(Debug)]
pub(super) struct Bodies {
    pub(super) first: Body,
    pub(super) second: Body,
    pub(super) motions: Motions,
}

impl Bodies {
    /// Whether the parts overlap at (x, y). Certain away from contact.
    pub(super) fn overlap(&self, x: f64, y: f64) -> bool {
        let (p, theta) = self.motions.relative(x, y);
        overlap(&self.first, &self.second, p, theta)
    }
}

/// Quantities that follow from the parts and their axes alone, as queries need them.
#[derive(Debug)]
pub(super) struct Setting {
    pub(super) map: Map,
    pub(super) motions: Motions,
    pub(super) x: Extent,
    pub(super) y: Extent,
    pub(super) bodies: Bodies,
    /// Names of the features of the first and of the second part.
    pub(super) names: (Vec<FeatureName>, Vec<FeatureName>),
    /// Deviation of the parts as computed from the parts as drawn, in the model's unit of length.
    pub(super) deviation: f64,
    /// Largest displacement of a contact because sharp corners are grown by more than sides, in the model's unit.
    pub(super) grown: f64,
}

impl Setting {
    /// Distance below which a configuration is in contact (model length): the resolution, plus the deviation of the parts as computed from
    /// the parts as drawn; growth of corners is not included.
    pub(super) fn contact_distance(&self) -> f64 {
        self.map.frame.outer_length(CONTACT) + self.deviation
    }

    /// The contact distance in the frame of the pair.
    pub(super) fn inner_contact_distance(&self) -> f64 {
        self.contact_distance() * self.map.frame.scale
    }

    /// u and v of a point on a curve; 0 for a part that does not move, for which the arrangement has a strip.
    pub(super) fn outer(&self, x: f64, y: f64) -> (f64, f64) {
        let at = |t: f64, m: Motion| if m == Motion::Still { 0.0 } else { t };
        self.map
            .outer(at(x, self.motions.first), at(y, self.motions.second))
    }

    /// Coordinates within the extents; `None` outside the ranges.
    pub(super) fn placed(&self, u: f64, v: f64) -> Option<(f64, f64)> {
        let (mut x, mut y) = self.map.inner(u, v);
        if !(x.is_finite() && y.is_finite()) {
            return None;
        }
        for (t, extent) in [(&mut x, &self.x), (&mut y, &self.y)] {
            match extent.kind {
                ExtentKind::Circle => *t = extent.reduced(*t),
                ExtentKind::TurnLimits | ExtentKind::SlideLimits => {
                    if !(extent.lo..=extent.hi).contains(t) {
                        return None;
                    }
                }
                ExtentKind::Open => {}
            }
        }
        // A part that does not move is at 0 only.
        let moved = |t: f64, m: Motion| m == Motion::Still && t != 0.0;
        if moved(x, self.motions.first) || moved(y, self.motions.second) {
            return None;
        }
        if let Some(share) = self.on_one_line() {
            y -= x * share;
            x = 0.0;
        }
        Some((x, y))
    }

    /// Factor s for parts that slide along one line without limits: there only y − s x matters. `None` for other parts.
    pub(super) fn on_one_line(&self) -> Option<f64> {
        let (Motion::Slide { direction: d }, Motion::Slide { direction: e }) =
            (self.motions.first, self.motions.second)
        else {
            return None;
        };
        let open = self.x.kind == ExtentKind::Open && self.y.kind == ExtentKind::Open;
        (open && d.cross(e).abs() < INDEPENDENT).then(|| d.dot(e))
    }
}

// Replaces arcs that are almost straight by their chords.
//
// Where a line touches an arc of radius r, or a large arc another one, the place follows from the angle between them, and so is known to
// some ε r. This exceeds the distance of the arc from its chord, b c / 2 for the bulge b and the chord c with r = c / 4b, if b² is less
// than some ε.

/// Bulge below which arcs are replaced by lines, √(9 ε): a sweep of less than 2·10⁻⁷ rad.
const STRAIGHT: f64 = 4.5e-8;

/// The part with such arcs straightened, and its deviation from the part as drawn, in the model's unit of length. `None` if there are no
/// such arcs, or if its loops were separated only by them.
pub(super) fn straightened(part: &Part) -> Option<(Part, f64)> {
    let is_straight = |bulge: f64| bulge != 0.0 && bulge.abs() < STRAIGHT;
    let deviation = (part.edges())
        .filter(|e| is_straight(e.bulge))
        .map(|e| e.height())
        .reduce(f64::max)?;
    let vertex = |v: &Vertex| {
        let bulge = if is_straight(v.bulge) { 0.0 } else { v.bulge };
        Vertex::new(v.x, v.y, bulge)
    };
    let loops = part.loops().iter();
    let loops = loops.map(|l| l.vertices().iter().map(vertex).collect());
    let straight = part.redrawn(loops.collect()).ok()?;
    Some((straight, deviation))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod straighten_tests {
    use super::*;

    #[test]
    fn only_arcs_that_rounding_makes_straight_are() {
        let part = |bulge: f64| {
            let corners = [(0.0, 0.0, bulge), (2.0, 0.0, 0.0), (1.0, 2.0, 0.0)];
            let corners = corners.map(|(x, y, b)| Vertex::new(x, y, b));
            Part::new("part", vec![corners.to_vec()]).unwrap()
        };
        assert!(straightened(&part(0.0)).is_none());
        assert!(straightened(&part(-1e-7)).is_none());
        let (straight, deviation) = straightened(&part(-1e-8)).unwrap();
        assert_eq!(straight, part(0.0));
        // The height of the arc above its chord.
        assert!((deviation - 1e-8).abs() < 1e-20);
    }
}
