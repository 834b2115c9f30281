//! The contact function of two features as they are drawn, in the user's coordinates and in any numbers.
//!
//! Every feature is a piece of one oriented circle: a line has curvature 0, an arc the curvature 1/r, positive where it is
//! convex, and a vertex is a convex arc of radius 0. An edge is told by its ends and its bulge b: from its middle point q
//! with the outward normal n,
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
//! Two features touch where their circles are tangent with opposing normals. With the flatter of the two as the base (q, n, k)
//! and the other (p, m, r) placed against it, the place that the other's centre has in contact lies on a circle of curvature
//! κ = k/(1 + k r) through q + r n, and with
//!
//! d = p − q − r (n + m),  g = n·d + κ d²/2,  f = 2 g / (1 + √(1 + 2 κ g))
//!
//! f is the distance along the normal by which they are apart, negative where they overlap. It is n·d for a line (equation 1
//! of Sacks 1999), and ±(|c| − |r₁ + r₂|) for arcs whose centres are apart by c (equations 2 and 3). No centre is far away,
//! however flat an arc is.

use crate::geometry::{Point, Vector};
use crate::number::Real;

use super::placement::Placement;

/// Bases with a larger |bulge| are told by their centre: it is near them.
const NEAR_CENTER: f64 = 0.125;

/// The outline of a feature as it is drawn, in its part's frame, with material on the left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FeatureShape<T> {
    /// A line or an arc.
    Edge {
        /// Where it starts.
        start: [T; 2],
        /// Where it ends.
        end: [T; 2],
        /// tan(sweep / 4), positive counter-clockwise, which is convex; 0 for a line.
        bulge: T,
    },
    /// A convex vertex.
    Vertex {
        /// Where it is.
        at: [T; 2],
    },
}

/// Where two features touch, or would if they were brought together along their normal, in the fixed part's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touching {
    /// The point of the fixed part's feature, or of the line or circle that it is a piece of.
    pub on_fixed: Point,
    /// The point of the moving part's feature. Both are one in contact.
    pub on_moving: Point,
    /// The outward unit normal of the fixed part there: the moving part's is its opposite.
    pub normal: Vector,
}

/// The value of a contact function with its first and second derivatives by the configuration.
///
/// Of a planar configuration the derivatives are by x, y and θ. Of two parts on fixed axes they are by u and v, and what
/// would be third is 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactValue {
    /// The value (the model's unit of length).
    pub value: f64,
    /// The gradient (length per length or per radian).
    pub gradient: [f64; 3],
    /// The Hessian, symmetric.
    pub hessian: [[f64; 3]; 3],
}

/// An oriented circle by one of its points.
struct Osculating<T> {
    point: [T; 2],
    normal: [T; 2],
    curvature: T,
    /// Infinite for a line.
    radius: T,
    bulge: f64,
}

fn add<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn sub<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn scale<T: Real>(a: [T; 2], s: T) -> [T; 2] {
    [a[0] * s, a[1] * s]
}

fn dot<T: Real>(a: [T; 2], b: [T; 2]) -> T {
    a[0] * b[0] + a[1] * b[1]
}

fn length<T: Real>(a: [T; 2]) -> T {
    dot(a, a).sqrt()
}

impl<T: Real> FeatureShape<T> {
    /// The same with each of its numbers made another kind of number; they are counted from 0 as start, end and bulge, or as
    /// the vertex.
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

    fn osculating(&self) -> Osculating<T> {
        let real = T::constant;
        match *self {
            Self::Edge { start, end, bulge } => {
                let chord = sub(end, start);
                let right = [chord[1], -chord[0]];
                let long = length(chord);
                let middle = scale(add(start, end), real(0.5));
                let curvature = real(4.0) * bulge / (long * (real(1.0) + bulge * bulge));
                Osculating {
                    point: add(middle, scale(right, real(0.5) * bulge)),
                    normal: scale(right, real(1.0) / long),
                    curvature,
                    radius: if bulge.value() == 0.0 {
                        real(f64::INFINITY)
                    } else {
                        real(1.0) / curvature
                    },
                    bulge: bulge.value(),
                }
            }
            Self::Vertex { at } => Osculating {
                point: at,
                normal: [real(0.0); 2],
                curvature: real(f64::INFINITY),
                radius: real(0.0),
                bulge: f64::INFINITY,
            },
        }
    }
}

/// The base, the flatter of two features, with the other placed against it.
struct Against<T> {
    base: Osculating<T>,
    other: Osculating<T>,
    /// Whether the base is the moving part's.
    moves: bool,
}

impl<T: Real> Against<T> {
    fn new(
        fixed: &FeatureShape<T>,
        moving: &FeatureShape<T>,
        fixed_from_moving: &Placement<T>,
    ) -> Self {
        let (first, second) = (fixed.osculating(), moving.osculating());
        let moves = second.curvature.value().abs() < first.curvature.value().abs();
        let (base, other, placed) = if moves {
            (second, first, fixed_from_moving.inverse())
        } else {
            (first, second, *fixed_from_moving)
        };
        Self {
            base,
            other: Osculating {
                point: placed.point(other.point),
                normal: placed.vector(other.normal),
                ..other
            },
            moves,
        }
    }

    /// f, and the gradient of f by the place of the other feature, in the base's frame: the base's normal in contact.
    fn value_and_normal(&self) -> (T, [T; 2]) {
        let real = T::constant;
        let (base, other) = (&self.base, &self.other);
        if base.bulge.abs() > NEAR_CENTER {
            let center = |o: &Osculating<T>| sub(o.point, scale(o.normal, o.radius));
            let apart = sub(center(other), center(base));
            let radius = base.radius + other.radius;
            let sign = real(if radius.value() < 0.0 { -1.0 } else { 1.0 });
            let far = length(apart);
            return (far * sign - radius, scale(apart, sign / far));
        }
        let (k, r, n) = (base.curvature, other.radius, base.normal);
        let facing = if r.value() == 0.0 {
            scale(n, r)
        } else {
            scale(add(n, other.normal), r)
        };
        let d = sub(sub(other.point, base.point), facing);
        let bend = k / (real(1.0) + k * r);
        let g = dot(n, d) + real(0.5) * bend * dot(d, d);
        let root = (real(1.0) + real(2.0) * bend * g).sqrt();
        let normal = add(n, scale(d, bend));
        (
            real(2.0) * g / (real(1.0) + root),
            scale(normal, real(1.0) / length(normal)),
        )
    }
}

/// The contact function of two features: how far they are apart along their common normal, in the unit of length in which
/// they are drawn; 0 in contact, negative where they overlap.
///
/// It is the distance of the whole lines and circles, with the side on which material lies: beyond the ends of a feature
/// another one touches. `fixed_from_moving` places the moving part in the fixed part's frame. With numbers that carry
/// derivatives it gives these too, by the configuration, by the vertices and by the bulges.
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
    Against::new(fixed, moving, fixed_from_moving)
        .value_and_normal()
        .0
}

/// Where two features touch, or would along their common normal, in numbers of any kind: in the fixed part's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TouchingPlace<T> {
    /// The contact function: how far the features are apart along their common normal.
    pub gap: T,
    /// The point of the fixed part's feature, or of the line or circle that it is a piece of.
    pub on_fixed: [T; 2],
    /// The point of the moving part's feature. Both are one in contact.
    pub on_moving: [T; 2],
    /// The outward unit normal of the fixed part there.
    pub normal: [T; 2],
}

/// Where two features touch, with the contact function, in numbers of any kind: with those that carry derivatives the points and the
/// normal come with theirs.
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
    let against = Against::new(fixed, moving, fixed_from_moving);
    let (gap, normal) = against.value_and_normal();
    let (base, other) = (&against.base, &against.other);
    // From the other's circle along its normal, which is the opposite one: p − r (m + N).
    let on_other = if other.radius.value() == 0.0 {
        other.point
    } else {
        sub(other.point, scale(add(other.normal, normal), other.radius))
    };
    let on_base = sub(on_other, scale(normal, gap));
    debug_assert!(base.bulge.is_finite() || other.bulge.is_infinite());
    if against.moves {
        let place = |p| fixed_from_moving.point(p);
        let turned = fixed_from_moving.vector(normal);
        TouchingPlace {
            gap,
            on_fixed: place(on_other),
            on_moving: place(on_base),
            normal: [-turned[0], -turned[1]],
        }
    } else {
        TouchingPlace {
            gap,
            on_fixed: on_base,
            on_moving: on_other,
            normal,
        }
    }
}

/// Where two features touch, or would along their common normal.
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
