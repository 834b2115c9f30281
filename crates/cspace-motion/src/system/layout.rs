//! Coordinates of a part, and its placement as a function of them.

use cspace::{AxisMotion, Dual, Part, Placement, Point, Real};

use super::row::{MOST, Row};

/// The coordinates of a part, by their first index in the system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PartCoordinates {
    /// No coordinate: the part does not move.
    Fixed,
    /// One coordinate: angle or displacement along an axis.
    Axis {
        /// Index of the coordinate.
        first: usize,
        /// Motion of the part.
        motion: AxisMotion,
        /// The least and the largest it may be.
        range: Option<(f64, f64)>,
    },
    /// Three: where a point of the part is in the assembly's frame, x and y, and its orientation θ.
    Planar {
        /// The index of x.
        first: usize,
        /// The point, in the part's frame: its origin, or its centre of mass.
        center: Point,
    },
}

impl PartCoordinates {
    /// The indices of its coordinates.
    pub fn indices(&self) -> core::ops::Range<usize> {
        match *self {
            Self::Fixed => 0..0,
            Self::Axis { first, .. } => first..first + 1,
            Self::Planar { first, .. } => first..first + 3,
        }
    }

    /// Placement of the part, in numbers of any kind: `variable` returns the coordinate of an index.
    pub fn placement<T: Real>(&self, variable: impl Fn(usize) -> T) -> Placement<T> {
        let point = |p: Point| [T::constant(p.x), T::constant(p.y)];
        match *self {
            Self::Fixed => Placement::identity(),
            Self::Axis { first, motion, .. } => match motion {
                AxisMotion::Fixed => Placement::identity(),
                AxisMotion::Revolute { center } => Placement::turn(point(center), variable(first)),
                AxisMotion::Prismatic { direction } => Placement::slide(
                    [T::constant(direction.x), T::constant(direction.y)],
                    variable(first),
                ),
            },
            Self::Planar { first, center } => {
                let turned = Placement::new([T::constant(0.0); 2], variable(first + 2));
                let [x, y] = turned.vector(point(center));
                Placement {
                    position: [variable(first) - x, variable(first + 1) - y],
                    ..turned
                }
            }
        }
    }

    /// The index of the coordinate that is its orientation, if it turns.
    pub fn orientation(&self) -> Option<usize> {
        match *self {
            Self::Axis {
                first,
                motion: AxisMotion::Revolute { .. },
                ..
            } => Some(first),
            Self::Planar { first, .. } => Some(first + 2),
            _ => None,
        }
    }

    /// Largest speed of a point of the part, per unit of the rate of each of its coordinates.
    pub(crate) fn levers(&self, part: &Part) -> [f64; 3] {
        let reach = |from: Point| reach(part, from);
        match self {
            Self::Axis {
                motion: AxisMotion::Revolute { center },
                ..
            } => [reach(*center), 0.0, 0.0],
            Self::Planar { center, .. } => [1.0, 1.0, reach(*center)],
            _ => [1.0, 0.0, 0.0],
        }
    }
}

/// The largest distance of a part's points from one, or a little more.
pub(crate) fn reach(part: &Part, from: Point) -> f64 {
    let corners = part.edges().flat_map(|e| e.bounds().corners());
    corners.map(|p| from.distance(p)).fold(0.0, f64::max)
}

/// Functions of where two parts are, in any numbers.
pub(crate) trait Placed<const COUNT: usize> {
    /// Values of the functions.
    fn values<T: Real>(&self, a: &Placement<T>, b: &Placement<T>) -> [T; COUNT];
}

/// Functions of where two parts are, with their derivatives by the coordinates of these.
pub(crate) fn rows_of<T: Real, const COUNT: usize>(
    parts: [&PartCoordinates; 2],
    q: &[T],
    functions: &impl Placed<COUNT>,
) -> [Row<T>; COUNT] {
    // Most parts turn or slide, and what is no coordinate needs no derivative.
    match parts.map(|p| p.indices().len()).iter().sum::<usize>() {
        0..=2 => derived::<T, 2, COUNT>(parts, q, functions),
        3..=4 => derived::<T, 4, COUNT>(parts, q, functions),
        _ => derived::<T, MOST, COUNT>(parts, q, functions),
    }
}

/// As above, with derivatives by at most N coordinates.
fn derived<T: Real, const N: usize, const COUNT: usize>(
    [a, b]: [&PartCoordinates; 2],
    q: &[T],
    functions: &impl Placed<COUNT>,
) -> [Row<T>; COUNT] {
    let (of_a, of_b) = (a.indices(), b.indices());
    let at_a = a.placement(|i| Dual::<N, T>::variable(q[i], i - of_a.start));
    let at_b = b.placement(|i| Dual::<N, T>::variable(q[i], of_a.len() + i - of_b.start));
    functions.values(&at_a, &at_b).map(|found| {
        let mut row = Row::new(found.value);
        for (i, slope) in of_a.clone().chain(of_b.clone()).zip(found.slope) {
            row.push(i, slope);
        }
        row
    })
}
