//! Two parts as drawn, without a configuration space, in numbers of any kind: enclosures give results for all drawings of a tolerance box,
//! numbers with derivatives give the effect of a dimension.
//!
//! Two boundaries first touch where a line or an arc touches an arc, or a vertex touches a line or an arc: where one of these contact
//! functions is 0 and the place of contact lies on both features. Vertices of two parts meet only where one of them meets an edge of the
//! other part.

mod affine;
mod disc;
mod encounters;
mod region;

use cspace::part::Loop;
use cspace::{
    AxisMotion, FeatureKind, FeatureName, FeatureShape, Layer, Part, Placement, Real, Relation,
    contact_function, touching_place,
};

pub use affine::{Affine, Enclosure};
pub use encounters::{Encounter, Encounters, Leg};
pub use region::{ConfigurationBox, Witness};

/// A number of the drawing of two parts: the fixed one is part 0, the moving one part 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawingNumber {
    /// A number of a vertex as given in [`Part::new`].
    Vertex {
        /// The part.
        part: usize,
        /// The loop.
        loop_index: usize,
        /// The number of the vertex in it.
        vertex: usize,
        /// 0 and 1 for its coordinates x and y, 2 for its bulge.
        component: usize,
    },
    /// A number of the centre or the direction of a part's axis.
    Axis {
        /// The part.
        part: usize,
        /// 0 for x, 1 for y.
        component: usize,
    },
}

/// Two parts as drawn, and their relative motion.
///
/// ```
/// use cspace::{Ball, Part, Relation};
/// use cspace_design::drawn::{DrawingNumber, DrawnPair, Leg};
/// let table = Part::rectangle("table", (0.0, 0.0), 4.0, 4.0)?;
/// let coin = Part::circle("coin", (0.0, 0.0), 1.0)?;
/// // The coin's size within ±0.01: it is drawn by two vertices at ±r.
/// let number = |of: DrawingNumber, x: f64| match of {
///     DrawingNumber::Vertex { part: 1, component: 0, .. } => Ball::new(x, 0.01),
///     _ => Ball::new(x, 0.0),
/// };
/// let pair = DrawnPair::new([&table, &coin], Relation::Planar, number).ok_or("the parts are jointed")?;
/// // From 5 to the right of the table's middle leftwards, it touches after 2, or by up to twice that sooner or later.
/// let leg = Leg::new([5.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
/// let found = pair.encounters(&leg, 4.0, None);
/// assert!(found.complete && found.list.iter().all(|e| e.lo > 1.95));
/// assert!(found.list.iter().any(|e| e.certain && e.hi < 2.05));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct DrawnPair<T> {
    /// Axes of the fixed and the moving part; `None` for a pair in the plane.
    axes: Option<[DrawnAxis<T>; 2]>,
    /// Edges of both parts, in frames with the origins at the axes.
    edges: [Vec<DrawnEdge<T>>; 2],
    /// Depth of overlap below which features that overlap where a motion begins may be missed by a test of the parts (model length).
    unseen: f64,
}

#[derive(Debug, Clone, Copy)]
enum DrawnAxis<T> {
    Fixed,
    Revolute([T; 2]),
    Prismatic([T; 2]),
}

impl<T> DrawnAxis<T> {
    fn map<U>(self, f: impl Fn(T) -> U) -> DrawnAxis<U> {
        match self {
            Self::Fixed => DrawnAxis::Fixed,
            Self::Revolute(x) => DrawnAxis::Revolute(x.map(f)),
            Self::Prismatic(x) => DrawnAxis::Prismatic(x.map(f)),
        }
    }
}

impl<T: Real> DrawnAxis<T> {
    /// The origin of the frame in which features are stored: for a part that turns, its centre, so that a dimension that moves both
    /// cancels.
    fn origin(self) -> [T; 2] {
        match self {
            Self::Revolute(center) => center,
            _ => [T::constant(0.0); 2],
        }
    }
}

/// Placement of the frame of the moving part's features in that of the fixed part's features.
fn facing<T: Real>(axes: Option<[DrawnAxis<T>; 2]>, at: [T; 3]) -> Placement<T> {
    let Some(axes) = axes else {
        return Placement::new([at[0], at[1]], at[2]);
    };
    let [fixed, moving] = [0, 1].map(|i| match axes[i] {
        DrawnAxis::Fixed => Placement::identity(),
        DrawnAxis::Revolute(center) => Placement::new(center, at[i]),
        DrawnAxis::Prismatic(direction) => Placement::slide(direction, at[i]),
    });
    fixed.inverse().compose(&moving)
}

/// Placement of the moving part in the frame of the fixed part.
fn placed<T: Real>(axes: Option<[DrawnAxis<T>; 2]>, at: [T; 3]) -> Placement<T> {
    let facing = facing(axes, at);
    let Some([fixed, moving]) = axes.map(|axes| axes.map(DrawnAxis::origin)) else {
        return facing;
    };
    let [x, y] = facing.vector(moving);
    let [from_x, from_y] = facing.position;
    Placement {
        position: [fixed[0] + (from_x - x), fixed[1] + (from_y - y)],
        ..facing
    }
}

/// An edge, and the vertex at which its travel starts.
#[derive(Debug, Clone)]
struct DrawnEdge<T> {
    name: FeatureName,
    shape: FeatureShape<T>,
    vertex: FeatureName,
    /// Shape of the vertex; `None` if it is certainly concave, because such a vertex is never the first to touch.
    corner: Option<FeatureShape<T>>,
    circle: OfCircle,
    /// The layer to which it belongs.
    layer: Layer,
}

/// Role of an edge on its circle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum OfCircle {
    /// The edge is an arc of its circle, or a line.
    Piece,
    /// The edge represents the whole circle, which has no ends.
    Whole,
    /// Another edge represents the whole circle.
    Other,
}

/// Depth of overlap, relative to the sizes of the parts, below which parts may be taken to touch: ten times the amount by which a part is
/// shrunk in [`overlap_as_drawn`](cspace::overlap_as_drawn).
const UNSEEN: f64 = 1e-8;

/// A contact of two features, by their numbers in a [`DrawnPair`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DrawnContact {
    /// Edge of the fixed and of the moving part; the flag is true if the vertex at the start of the edge is meant.
    features: [(u32, bool); 2],
}

impl<T: Real> DrawnPair<T> {
    /// The fixed and the moving part of a pair; `number` converts each number of the drawing. `None` for parts that are connected by a
    /// joint.
    pub fn new(
        parts: [&Part; 2],
        relation: Relation,
        number: impl Fn(DrawingNumber, f64) -> T,
    ) -> Option<Self> {
        let axis = |part: usize, motion: AxisMotion| {
            let both = |numbers: [f64; 2]| {
                [0, 1].map(|component| {
                    number(DrawingNumber::Axis { part, component }, numbers[component])
                })
            };
            match motion {
                AxisMotion::Fixed => DrawnAxis::Fixed,
                AxisMotion::Revolute { center } => DrawnAxis::Revolute(both([center.x, center.y])),
                AxisMotion::Prismatic { direction } => {
                    DrawnAxis::Prismatic(both([direction.x, direction.y]))
                }
            }
        };
        let axes = match relation {
            Relation::Joint(..) => return None,
            Relation::Planar => None,
            Relation::Axes { fixed, moving } => {
                Some([axis(0, fixed.motion), axis(1, moving.motion)])
            }
        };
        let edges = [0, 1].map(|part| {
            let loops = (0..).zip(parts[part].loops());
            let layer = |loop_index| &parts[part].layers()[parts[part].layer_of(loop_index)];
            let edges = loops.flat_map(|(loop_index, outline)| {
                let of = |vertex: usize, component: usize, x: f64| {
                    let of = DrawingNumber::Vertex {
                        part,
                        loop_index,
                        vertex,
                        component,
                    };
                    let x = number(of, x);
                    match axes {
                        Some(axes) if component < 2 => x - axes[part].origin()[component],
                        _ => x,
                    }
                };
                edges_of(outline, (loop_index as u32, layer(loop_index)), of)
            });
            edges.collect()
        });
        let unseen = UNSEEN * (parts[0].size() + parts[1].size());
        Some(Self {
            axes,
            edges,
            unseen,
        })
    }

    /// The pair in numbers of another kind.
    pub fn map<U>(&self, f: impl Fn(T) -> U) -> DrawnPair<U> {
        DrawnPair {
            axes: self.axes.map(|axes| axes.map(|axis| axis.map(&f))),
            edges: [0, 1].map(|part| {
                let edges = self.edges[part].iter().map(|e| DrawnEdge {
                    name: e.name,
                    shape: e.shape.map(|_, x| f(x)),
                    vertex: e.vertex,
                    corner: e.corner.map(|c| c.map(|_, x| f(x))),
                    circle: e.circle,
                    layer: e.layer.clone(),
                });
                edges.collect()
            }),
            unseen: self.unseen,
        }
    }

    /// Whether features may overlap at a configuration by so little that an overlap test of the parts misses it.
    pub fn may_overlap_unseen(&self, contact: DrawnContact, at: [T; 3]) -> bool {
        let gap = self.gap(contact, at, |x| x);
        let (value, spread) = (gap.value(), gap.spread());
        let is_near = value - spread <= 0.0 && value + spread >= -self.unseen;
        let is_on = |w: &T| w.value() + w.spread() >= -UNSEEN;
        is_near && self.within(contact, at).iter().flatten().all(is_on)
    }

    /// The features of a contact.
    pub fn names(&self, contact: DrawnContact) -> [FeatureName; 2] {
        [0, 1].map(|part| {
            let (edge, is_vertex) = contact.features[part];
            let edge = &self.edges[part][edge as usize];
            if is_vertex { edge.vertex } else { edge.name }
        })
    }

    fn shape(&self, contact: DrawnContact, part: usize) -> FeatureShape<T> {
        let (edge, is_vertex) = contact.features[part];
        let edge = &self.edges[part][edge as usize];
        match edge.corner {
            Some(corner) if is_vertex => corner,
            _ => edge.shape,
        }
    }

    /// Placement of the moving part in the frame of the fixed part at x, y and θ; or at u, v and any third number.
    pub fn placed(&self, at: [T; 3]) -> Placement<T> {
        placed(self.axes, at)
    }

    fn facing(&self, at: [T; 3]) -> Placement<T> {
        facing(self.axes, at)
    }

    /// The contact function at a configuration: the distance of the two features, extended to whole lines and circles. The configuration
    /// may be in numbers of another kind, to which `lift` converts those of the drawing.
    pub fn gap<U: Real>(&self, contact: DrawnContact, at: [U; 3], lift: impl Fn(T) -> U) -> U {
        let [fixed, moving] = [0, 1].map(|part| self.shape(contact, part).map(|_, x| lift(x)));
        let axes = self.axes.map(|axes| axes.map(|axis| axis.map(&lift)));
        contact_function(&fixed, &moving, &facing(axes, at))
    }

    /// Points of contact at a configuration in contact: on the fixed part, in its frame; and on the moving part, in the frame of the fixed
    /// part.
    pub fn touching(&self, contact: DrawnContact, at: [T; 3]) -> [[T; 2]; 2] {
        let [fixed, moving] = [0, 1].map(|part| self.shape(contact, part));
        let place = touching_place(&fixed, &moving, &self.facing(at));
        let origin = self.axes.map(|axes| axes[0].origin());
        [place.on_fixed, place.on_moving].map(|[x, y]| match origin {
            Some(origin) => [x + origin[0], y + origin[1]],
            None => [x, y],
        })
    }

    /// Position of the place of contact within the two features at a configuration in contact, relative to their chords: three numbers for
    /// each feature, of which one is negative beyond its ends; for a vertex all are 1.
    pub fn within(&self, contact: DrawnContact, at: [T; 3]) -> [[T; 3]; 2] {
        let [fixed, moving] = [0, 1].map(|part| self.shape(contact, part));
        let facing = self.facing(at);
        let place = touching_place(&fixed, &moving, &facing);
        let back = facing.inverse().point(place.on_moving);
        let of = |part: usize, shape, point| {
            let (edge, is_vertex) = contact.features[part];
            if !is_vertex && self.edges[part][edge as usize].circle == OfCircle::Whole {
                return [T::constant(1.0); 3];
            }
            within_ends(shape, point)
        };
        [of(0, &fixed, place.on_fixed), of(1, &moving, back)]
    }

    /// The contacts of two edges.
    fn contacts(&self, fixed: u32, moving: u32) -> impl Iterator<Item = DrawnContact> + '_ {
        let (f, m) = (
            &self.edges[0][fixed as usize],
            &self.edges[1][moving as usize],
        );
        let is_line = |e: &DrawnEdge<T>| e.name.kind == FeatureKind::Line;
        let meet = f.layer.meets(&m.layer);
        let is = [f, m].map(|e| meet && e.circle != OfCircle::Other);
        let edges = is[0] && is[1] && !(is_line(f) && is_line(m));
        let corners = [is[1] && f.corner.is_some(), is[0] && m.corner.is_some()];
        [
            (edges, [(fixed, false), (moving, false)]),
            (corners[0], [(fixed, true), (moving, false)]),
            (corners[1], [(fixed, false), (moving, true)]),
        ]
        .into_iter()
        .filter_map(|(is, features)| is.then_some(DrawnContact { features }))
    }
}

/// The edges of a loop traversed with material on the left.
fn edges_of<T: Real>(
    outline: &Loop,
    (loop_index, layer): (u32, &Layer),
    number: impl Fn(usize, usize, f64) -> T,
) -> Vec<DrawnEdge<T>> {
    let (vertices, n) = (outline.vertices(), outline.vertices().len());
    let reversed = outline.is_reversed();
    let point = |i: usize| [number(i, 0, vertices[i].x), number(i, 1, vertices[i].y)];
    let shape = |i: usize| {
        let next = (i + 1) % n;
        let bulge = number(i, 2, vertices[i].bulge);
        if reversed {
            (point(next), point(i), -bulge)
        } else {
            (point(i), point(next), bulge)
        }
    };
    let name = |kind, i: usize| FeatureName {
        kind,
        loop_index,
        index: i as u32,
    };
    let edge = |i: usize| {
        let (start, end, bulge) = shape(i);
        // The previous edge in travel, and the vertex between them.
        let corner = outline.start_of(i);
        let before = if reversed { corner } else { (i + n - 1) % n };
        let (from, to, before_bulge) = shape(before);
        let comes = direction(from, to, before_bulge);
        let goes = direction(start, end, -bulge);
        let turn = comes[0] * goes[1] - comes[1] * goes[0];
        let is_concave = turn.value() + turn.spread() < 0.0;
        DrawnEdge {
            name: name(FeatureKind::of_bulge(bulge.value()), i),
            shape: FeatureShape::Edge { start, end, bulge },
            vertex: name(FeatureKind::Vertex, corner),
            corner: (!is_concave).then_some(FeatureShape::Vertex { at: start }),
            circle: OfCircle::Piece,
            layer: layer.clone(),
        }
    };
    // Two half circles on one chord are one circle, whatever the chord.
    let is_half = |i: usize| {
        let bulge = number(i, 2, vertices[i].bulge);
        bulge.value().abs() == 1.0 && bulge.spread() == 0.0
    };
    if n == 2 && is_half(0) && is_half(1) {
        let of = |i: usize, circle: OfCircle| DrawnEdge {
            corner: None,
            circle,
            ..edge(i)
        };
        return vec![of(0, OfCircle::Whole), of(1, OfCircle::Other)];
    }
    (0..n).map(edge).collect()
}

/// Direction along an edge at its end: the chord turned by half the sweep, c (1 + i b)². The direction at its start is that for the bulge
/// −b.
fn direction<T: Real>(start: [T; 2], end: [T; 2], bulge: T) -> [T; 2] {
    let one = T::constant(1.0);
    let [x, y] = [end[0] - start[0], end[1] - start[1]];
    let (cos, sin) = (one - bulge * bulge, bulge + bulge);
    [x * cos - y * sin, y * cos + x * sin]
}

/// Three numbers, of which one is negative where a point of a line or circle lies beyond the ends of a feature on it.
fn within_ends<T: Real>(feature: &FeatureShape<T>, [x, y]: [T; 2]) -> [T; 3] {
    /// Bulge above which an arc is distinguished from the rest of its circle by the side of the chord; smaller ones, by the feet on it.
    const SIDE: f64 = 0.5;
    let FeatureShape::Edge { start, end, bulge } = *feature else {
        return [T::constant(1.0); 3];
    };
    let c = [end[0] - start[0], end[1] - start[1]];
    let p = [x - start[0], y - start[1]];
    let square = c[0] * c[0] + c[1] * c[1];
    // Distance towards the side of the arc, in units of the chord's length.
    let right = (c[1] * p[0] - c[0] * p[1]) / square;
    let side = if bulge.value() > 0.0 { right } else { -right };
    if bulge.value().abs() > SIDE {
        return [side; 3];
    }
    // Where the arc is flatter than that, the opposite part of the circle is at least 3/4 of the chord away.
    let foot = (c[0] * p[0] + c[1] * p[1]) / square;
    let one = T::constant(1.0);
    let near = if bulge.value() == 0.0 {
        one
    } else {
        side + T::constant(0.25)
    };
    [foot, one - foot, near]
}
