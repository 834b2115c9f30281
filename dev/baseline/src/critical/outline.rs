//! A part as the search sees it: what can touch, where that ends, and the boundary.

use core::f64::consts::PI;

use cspace::{Edge, Part, Point, Rotation, Vector};

use super::tolerance::SMOOTH;

/// A line, an arc or a convex vertex.
#[derive(Debug, Clone, Copy)]
pub(super) struct Feature {
    pub(super) shape: Shape,
    /// Angles of the outward normals, unwrapped; equal for a line.
    pub(super) lo: f64,
    pub(super) hi: f64,
    /// Joints at which travel along it starts and ends.
    pub(super) joints: [u32; 2],
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Line {
        start: Point,
        end: Point,
    },
    /// Signed radius: positive convex, negative concave, 0 a vertex.
    Round {
        center: Point,
        radius: f64,
    },
}

/// The end of a feature: a point and the outward normal there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    pub(super) point: Point,
    /// Angle of the normal.
    pub(super) angle: f64,
    /// Whether a line ends at this joint.
    pub(super) on_line: bool,
}

/// A part about its own centre, scaled.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    pub(super) features: Vec<Feature>,
    pub(super) joints: Vec<Joint>,
    /// Edges of all loops, material on the left.
    pub(super) edges: Vec<Edge>,
}

impl Feature {
    pub(super) fn is_line(&self) -> bool {
        matches!(self.shape, Shape::Line { .. })
    }

    /// The width of its normals, radians.
    pub(super) fn width(&self) -> f64 {
        self.hi - self.lo
    }
}

impl Outline {
    pub(super) fn new(part: &Part, scale: f64) -> Self {
        /// Both parts are turned by this, which changes no orientation, so that no ray along an axis meets a corner by design.
        const ASKEW: f64 = 0.739_085;
        let (center, turn) = (part.bounds().center(), Rotation::by(ASKEW));
        let place = |p: Point| Point::ORIGIN + turn * ((p - center) * scale);
        let mut outline = Self {
            features: Vec::new(),
            joints: Vec::new(),
            edges: Vec::new(),
        };
        for l in part.loops() {
            let edges: Vec<Edge> = l.edges().map(|e| e.placed(place)).collect();
            outline.add_loop(&edges);
            outline.edges.extend(edges);
        }
        outline
    }

    /// Two joints at every corner, one where edges are joined smoothly; then the features between.
    fn add_loop(&mut self, edges: &[Edge]) {
        let n = edges.len();
        // Joints at the start of each edge: where the edge before ends, and where this one starts.
        let mut at_start = Vec::with_capacity(n);
        for (i, e) in edges.iter().enumerate() {
            let before = &edges[(i + n - 1) % n];
            let (from, to) = (before.end_direction(), e.start_direction());
            let turn = from.cross(to).atan2(from.dot(to));
            let first = self.joint(e.start, from.right(), before.is_line());
            let second = if turn.abs() <= SMOOTH {
                // One normal for both; a line's, if there is one.
                if e.is_line() {
                    self.joints[first as usize].angle = to.right().angle();
                    self.joints[first as usize].on_line = true;
                }
                first
            } else {
                self.joint(e.start, to.right(), e.is_line())
            };
            if turn > SMOOTH {
                let lo = from.right().angle();
                self.features.push(Feature {
                    shape: Shape::Round {
                        center: e.start,
                        radius: 0.0,
                    },
                    lo,
                    hi: lo + turn,
                    joints: [first, second],
                });
            }
            at_start.push((first, second));
        }
        for (i, e) in edges.iter().enumerate() {
            let joints = [at_start[i].1, at_start[(i + 1) % n].0];
            let from = e.start_direction().right().angle();
            let feature = if e.is_line() {
                Feature {
                    shape: Shape::Line {
                        start: e.start,
                        end: e.end,
                    },
                    lo: from,
                    hi: from,
                    joints,
                }
            } else {
                // The normal turns with the direction of travel.
                let to = from + e.sweep();
                Feature {
                    shape: Shape::Round {
                        center: e.center(),
                        radius: e.radius() * e.bulge.signum(),
                    },
                    lo: from.min(to),
                    hi: from.max(to),
                    joints,
                }
            };
            self.features.push(feature);
        }
    }

    fn joint(&mut self, point: Point, normal: Vector, on_line: bool) -> u32 {
        self.joints.push(Joint {
            point,
            angle: normal.angle(),
            on_line,
        });
        self.joints.len() as u32 - 1
    }

    /// Features to which a normal belongs as a whole: lines, and joints at which no line ends. Each is given by its two
    /// ends, equal for a joint.
    pub(super) fn facets(&self) -> Vec<Facet> {
        let mut facets = Vec::new();
        for f in &self.features {
            if let Shape::Line { start, end } = f.shape {
                facets.push(Facet {
                    start,
                    end,
                    angle: f.lo,
                });
            }
        }
        for j in self.joints.iter().filter(|j| !j.on_line) {
            facets.push(Facet {
                start: j.point,
                end: j.point,
                angle: j.angle,
            });
        }
        facets
    }
}

/// A line or the end of an arc, with its normal.
#[derive(Debug, Clone, Copy)]
pub(super) struct Facet {
    pub(super) start: Point,
    pub(super) end: Point,
    pub(super) angle: f64,
}

impl Facet {
    /// The orientation at which this normal of the fixed part opposes one of the moving part.
    pub(super) fn opposes(&self, moving: &Self) -> f64 {
        self.angle - moving.angle - PI
    }
}
