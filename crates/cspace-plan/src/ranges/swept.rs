//! Boxes around all places that parts come to on their axes, and which of them are near each other.

use cspace::part::Bounds;
use cspace::{Axis, AxisMotion, Part, Point, Vector};
use cspace_model::Mechanism;

use crate::clash::{Boxed, near as near_boxes};

/// Every two parts on axes whose boxes over their ranges have a gap of less than `within`, by their numbers, the lower first: all others are
/// farther apart wherever they are. Parts that a joint connects are left out, and two that both stand still.
pub fn near(mechanism: &Mechanism, within: f64) -> Vec<[usize; 2]> {
    let numbers: Vec<usize> = (0..mechanism.parts.len())
        .filter(|&i| mechanism.parts[i].axis.is_some())
        .collect();
    let boxes = (numbers.iter())
        .filter_map(|&i| {
            let entry = &mechanism.parts[i];
            entry.axis.map(|axis| around(&entry.part, axis))
        })
        .collect();
    let mut found: Vec<[usize; 2]> = (near_boxes(&Boxed::new(boxes), within).into_iter())
        .map(|pair| pair.map(|i| numbers[i]))
        .filter(|&pair| is_on_axes(mechanism, pair))
        .collect();
    found.sort_unstable();
    found
}

/// The number of pairs of parts on axes, near or not.
pub fn count(mechanism: &Mechanism) -> usize {
    let n = mechanism.parts.len();
    let all = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
    all.filter(|&pair| is_on_axes(mechanism, pair)).count()
}

/// Whether each of two parts has an axis or stands still, one of them can move, and no joint connects them.
pub fn is_on_axes(mechanism: &Mechanism, [a, b]: [usize; 2]) -> bool {
    let axis = |i: usize| mechanism.parts.get(i).and_then(|p| p.axis);
    let (Some(first), Some(second)) = (axis(a), axis(b)) else {
        return false;
    };
    let moves = |axis: Axis| axis.motion != AxisMotion::Fixed;
    let is_joined = (mechanism.joints.iter()).any(|j| j.parts == (a, b) || j.parts == (b, a));
    (moves(first) || moves(second)) && !is_joined
}

/// A box around all places that a part comes to on its axis.
fn around(part: &Part, axis: Axis) -> Bounds {
    let drawn = part.bounds();
    match axis.motion {
        AxisMotion::Fixed => drawn,
        AxisMotion::Revolute { center } => {
            let corners = [
                drawn.min,
                drawn.max,
                Point::new(drawn.min.x, drawn.max.y),
                Point::new(drawn.max.x, drawn.min.y),
            ];
            let reach = corners.map(|c| c.distance(center)).into_iter();
            let reach = reach.fold(0.0, f64::max);
            Bounds {
                min: center - Vector::new(reach, reach),
                max: center + Vector::new(reach, reach),
            }
        }
        AxisMotion::Prismatic { direction } => {
            let (lo, hi) = (axis.range).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            let unit = direction.unit();
            // Not a number where it does not move along an axis, however far it goes.
            let along = |rate: f64, t: f64| if rate == 0.0 { 0.0 } else { rate * t };
            let by = [lo, hi].map(|t| Vector::new(along(unit.x, t), along(unit.y, t)));
            let moved = by.map(|by| Bounds {
                min: drawn.min + by,
                max: drawn.max + by,
            });
            moved[0].union(moved[1])
        }
    }
}
