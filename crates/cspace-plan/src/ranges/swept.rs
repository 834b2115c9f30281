//! Boxes around all places that parts come to on their axes, and which of them are near each other.

use cspace::part::Bounds;
use cspace::{Axis, AxisMotion, Part, Point, Vector};
use cspace_model::Mechanism;

use crate::clash::{Boxed, near};

/// The pairs of a mechanism that are looked at over their ranges.
///
/// Each part has an axis or stands still, one of them can move, they are at a common height, and neither a joint nor a chain of joints connects them: parts of a linkage do not
/// move independently of each other. Joints to parts that stand still are pivots, and connect nothing.
#[derive(Debug)]
pub struct Pairs<'a> {
    mechanism: &'a Mechanism,
    /// The linkage of each part, by the number of one of its parts.
    linkages: Vec<usize>,
}

impl<'a> Pairs<'a> {
    /// The pairs of a mechanism.
    pub fn of(mechanism: &'a Mechanism) -> Self {
        let mut linkages: Vec<usize> = (0..mechanism.parts.len()).collect();
        let stands = |i: usize| {
            let axis = mechanism.parts[i].axis;
            axis.is_some_and(|a| a.motion == AxisMotion::Fixed)
        };
        for joint in &mechanism.joints {
            let (a, b) = joint.parts;
            if !stands(a) && !stands(b) {
                let (one, other) = (linkages[a], linkages[b]);
                for of in &mut linkages {
                    if *of == other {
                        *of = one;
                    }
                }
            }
        }
        Self {
            mechanism,
            linkages,
        }
    }

    /// Whether two parts are looked at over their ranges.
    pub fn has(&self, [a, b]: [usize; 2]) -> bool {
        let axis = |i: usize| self.mechanism.parts.get(i).and_then(|p| p.axis);
        let (Some(first), Some(second)) = (axis(a), axis(b)) else {
            return false;
        };
        let moves = |axis: Axis| axis.motion != AxisMotion::Fixed;
        let parts = &self.mechanism.parts;
        (moves(first) || moves(second))
            && parts[a].part.meets(&parts[b].part)
            && !self.are_linked([a, b])
            && self.mechanism.joint(a, b).is_none()
    }

    /// Whether two parts belong to one linkage, and do not move independently of each other.
    pub fn are_linked(&self, [a, b]: [usize; 2]) -> bool {
        self.linkages.get(a) == self.linkages.get(b)
    }

    /// Their number.
    pub fn count(&self) -> usize {
        let n = self.mechanism.parts.len();
        let all = (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j]));
        all.filter(|&pair| self.has(pair)).count()
    }

    /// Pairs whose boxes over their ranges have a gap of less than `within`, by the numbers of their parts, the lower first: all others are
    /// farther apart wherever they are.
    pub fn near(&self, within: f64) -> Vec<[usize; 2]> {
        let axes = self.mechanism.parts.iter().enumerate();
        let (numbers, boxes): (Vec<usize>, Vec<Bounds>) = axes
            .filter_map(|(i, entry)| Some((i, around(&entry.part, entry.axis?))))
            .unzip();
        let mut found: Vec<[usize; 2]> = (near(&Boxed::new(boxes), within).into_iter())
            .map(|pair| pair.map(|i| numbers[i]))
            .filter(|&pair| self.has(pair))
            .collect();
        found.sort_unstable();
        found
    }
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
