//! The contact function of two features as drawn, in the user's coordinates and in numbers of any kind.
//!
//! Every feature is a piece of an oriented circle (`cycle.rs`): a vertex is a convex arc of radius 0. An edge is given by its ends and its
//! bulge b: from its middle point q with the outward normal n,
//!
//! ```text
//!          n
//!          ↑            chord c = end − start, to be travelled with material on the left
//!      ___ q ___        q = (start + end)/2 + b/2 right(c)
//!     /         \       n = right(c)/|c|
//!  start  →c→   end     k = 1/r = 4 b / (|c| (1 + b²))
//!     (material)
//! ```
//!
//! The contact function is the gap of the two cycles: equations (1) to (3) of Sacks 1999 in one.

use crate::geometry::{Point, Rotation, Vector};
use crate::number::Real;
use crate::part::Edge;

use super::cycle::Cycle;
use super::placement::Placement;

/// The outline of a feature as drawn, in its part's frame, with material on the left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FeatureShape<T> {
    /// A line or an arc.
    Edge {
        /// Start of the edge.
        start: [T; 2],
        /// End of the edge.
        end: [T; 2],
        /// tan(sweep / 4), positive counter-clockwise, which is convex; 0 for a line.
        bulge: T,
    },
    /// A convex vertex.
    Vertex {
        /// Position of the vertex.
        at: [T; 2],
    },
}

impl From<Edge> for FeatureShape<f64> {
    fn from(edge: Edge) -> Self {
        Self::Edge {
            start: [edge.start.x, edge.start.y],
            end: [edge.end.x, edge.end.y],
            bulge: edge.bulge,
        }
    }
}

/// Points where two features touch, or would touch if they were moved together along their normal, in the fixed part's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touching {
    /// Point of the fixed part's feature, or of its line or circle.
    pub on_fixed: Point,
    /// Point of the moving part's feature. In contact the two points coincide.
    pub on_moving: Point,
    /// Outward unit normal of the fixed part there, opposite to that of the moving part.
    pub normal: Vector,
}

/// The value of a contact function with its first and second derivatives by the configuration.
///
/// For a planar configuration the derivatives are by x, y and θ. For two parts on fixed axes they are by u and v, and the third is 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactValue {
    /// The value (the model's unit of length).
    pub value: f64,
    /// The gradient (length per length or per radian).
    pub gradient: [f64; 3],
    /// The Hessian, symmetric.
    pub hessian: [[f64; 3]; 3],
}

impl<T: Real> FeatureShape<T> {
    /// The shape with each of its numbers converted by `f`, which also gets the number's index: start, end and bulge, or the vertex,
    /// counted from 0.
    pub fn map<U>(&self, mut f: impl FnMut(usize, T) -> U) -> FeatureShape<U> {
        match *self {
            Self::Edge { start, end, bulge } => FeatureShape::Edge {
                start: [f(0, start[0]), f(1, start[1])],
                end: [f(2, end[0]), f(3, end[1])],
                bulge: f(4, bulge),
            },
            Self::Vertex { at } => FeatureShape::Vertex {
                at: [f(0, at[0]), f(1, at[1])],
            },
        }
    }

    /// The line or circle of the feature.
    fn cycle(&self) -> Cycle<T> {
        match *self {
            Self::Edge { start, end, bulge } => {
                let [start, end] = [start, end].map(|[x, y]| Point::new(x, y));
                Cycle::of_edge(&Edge::between(start, end, bulge))
            }
            Self::Vertex { at: [x, y] } => Cycle::round(Point::new(x, y), T::constant(0.0)),
        }
    }
}

/// The flatter of two features, and the other in its frame: the one that is hardly curved is not turned.
struct Facing<T> {
    base: Cycle<T>,
    other: Cycle<T>,
    /// Whether the base is the moving part's.
    moves: bool,
}

impl<T: Real> Facing<T> {
    fn new(
        fixed: &FeatureShape<T>,
        moving: &FeatureShape<T>,
        fixed_from_moving: &Placement<T>,
    ) -> Self {
        let (first, second) = (fixed.cycle(), moving.cycle());
        // For a vertex, an enclosure of the curvature would contain all reals, with 0 in the middle.
        let curvature = |c: &Cycle<T>| (c.weight.value() / c.size.value()).abs();
        let moves = curvature(&second) < curvature(&first);
        let (base, other, placed) = if moves {
            (second, first, fixed_from_moving.inverse())
        } else {
            (first, second, *fixed_from_moving)
        };
        let Placement {
            position: [x, y],
            cos,
            sin,
        } = placed;
        Self {
            base,
            other: other.moved(Rotation { cos, sin }, Vector::new(x, y)),
            moves,
        }
    }
}

/// The contact function of two features: their distance along their common normal, in the unit of length in which they are drawn; 0 in
/// contact, negative where they overlap.
///
/// It is the distance of the whole lines and circles, with the side on which material lies: beyond the ends of a feature another one
/// touches. `fixed_from_moving` places the moving part in the fixed part's frame. Numbers that carry derivatives give the derivatives too:
/// by the configuration, by the vertices and by the bulges.
///
/// ```
/// use cspace::{contact_function, Dual, FeatureShape, Placement, Real};
/// let c = |x: f64| Dual::<1>::constant(x);
/// // A disc of radius 1 about (0, 3) above a line along the x axis, and how the gap grows with the bulge of the line.
/// let line = FeatureShape::Edge { start: [c(1.0), c(0.0)], end: [c(-1.0), c(0.0)], bulge: Dual::variable(0.0, 0) };
/// let disc = FeatureShape::Edge { start: [c(-1.0), c(0.0)], end: [c(1.0), c(0.0)], bulge: c(1.0) };
/// let gap = contact_function(&line, &disc, &Placement::new([c(0.0), c(3.0)], c(0.0)));
/// assert!((gap.value - 2.0).abs() < 1e-12);
/// assert!((gap.slope[0] + 1.0).abs() < 1e-12);
/// ```
pub fn contact_function<T: Real>(
    fixed: &FeatureShape<T>,
    moving: &FeatureShape<T>,
    fixed_from_moving: &Placement<T>,
) -> T {
    let Facing { base, other, .. } = Facing::new(fixed, moving, fixed_from_moving);
    base.gap(&other)
}

/// Points where two features touch, or would touch along their common normal, in numbers of any kind: in the fixed part's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TouchingPlace<T> {
    /// The contact function: the distance of the features along their common normal.
    pub gap: T,
    /// Point of the fixed part's feature, or of its line or circle.
    pub on_fixed: [T; 2],
    /// Point of the moving part's feature. In contact the two points coincide.
    pub on_moving: [T; 2],
    /// The outward unit normal of the fixed part there.
    pub normal: [T; 2],
}

/// Points where two features touch, and the contact function, in numbers of any kind: with numbers that carry derivatives, the points and
/// the normal carry theirs.
///
/// ```
/// use cspace::{touching_place, Dual, FeatureShape, Placement, Real};
/// let c = |x: f64| Dual::<1>::constant(x);
/// // A disc of radius 1 about (0.5, 3) above a line along the x axis with material below, moved along it.
/// let line = FeatureShape::Edge { start: [c(5.0), c(0.0)], end: [c(-5.0), c(0.0)], bulge: c(0.0) };
/// let disc = FeatureShape::Edge { start: [c(-1.0), c(0.0)], end: [c(1.0), c(0.0)], bulge: c(1.0) };
/// let moved = Placement::new([Dual::variable(0.5, 0), c(3.0)], c(0.0));
/// let place = touching_place(&line, &disc, &moved);
/// assert!((place.gap.value - 2.0).abs() < 1e-12 && place.gap.slope[0].abs() < 1e-12);
/// assert!((place.on_moving[0].value - 0.5).abs() < 1e-12 && (place.on_moving[0].slope[0] - 1.0).abs() < 1e-12);
/// ```
pub fn touching_place<T: Real>(
    fixed: &FeatureShape<T>,
    moving: &FeatureShape<T>,
    fixed_from_moving: &Placement<T>,
) -> TouchingPlace<T> {
    let Facing { base, other, moves } = Facing::new(fixed, moving, fixed_from_moving);
    let (gap, normal) = (base.gap(&other), base.common_normal(&other));
    let on_other = other.place_of_normal(-normal);
    let on_base = on_other + normal * -gap;
    let [on_base, on_other] = [on_base, on_other].map(|p| [p.x, p.y]);
    if moves {
        let [x, y] = fixed_from_moving.vector([normal.x, normal.y]);
        TouchingPlace {
            gap,
            on_fixed: fixed_from_moving.point(on_other),
            on_moving: fixed_from_moving.point(on_base),
            normal: [-x, -y],
        }
    } else {
        TouchingPlace {
            gap,
            on_fixed: on_base,
            on_moving: on_other,
            normal: [normal.x, normal.y],
        }
    }
}

/// Points where two features touch, or would touch along their common normal.
pub fn touching(
    fixed: &FeatureShape<f64>,
    moving: &FeatureShape<f64>,
    fixed_from_moving: &Placement<f64>,
) -> Touching {
    let place = touching_place(fixed, moving, fixed_from_moving);
    let point = |[x, y]: [f64; 2]| Point::new(x, y);
    Touching {
        on_fixed: point(place.on_fixed),
        on_moving: point(place.on_moving),
        normal: Vector::new(place.normal[0], place.normal[1]),
    }
}

#[cfg(test)]
mod tests;
