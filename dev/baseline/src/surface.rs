//! The polyhedral surface through the contours of a stack.

use core::f64::consts::TAU;

use cspace::{Configuration, CurveGeometry, Point, Slice};
use rayon::prelude::*;

use crate::Stack;
use crate::join::join;

/// Between two consecutive slices.
#[derive(Debug, Clone)]
pub struct Layer {
    /// Index of the slice below; the one above is the next, after the last the first.
    pub slice: usize,
    /// Orientations of the two slices, radians, in increasing order.
    pub theta: (f64, f64),
    /// Curves of the two slices that are joined, by their indices.
    pub joined: Vec<(u32, u32)>,
    /// Number of curves of either slice that are joined to none: there the surface has holes.
    pub open: usize,
    /// Whether the joined curves form closed loops: each curve has a partner, and partners of consecutive curves are
    /// consecutive.
    pub closed: bool,
    /// Corners (x, y, θ).
    pub vertices: Vec<Configuration>,
    /// Triangles by their corners, counter-clockwise seen from free space.
    pub triangles: Vec<[u32; 3]>,
    /// First of the corners of each joined pair, and how many straight pieces its contour was cut into.
    pieces: Vec<(u32, u32)>,
}

/// Layers of triangles over a turn.
#[derive(Debug, Clone)]
pub struct Surface {
    /// The layers, in order of orientation.
    pub layers: Vec<Layer>,
    /// Largest distance of a straight piece from its arc, in the model's unit.
    pub accuracy: f64,
}

impl Surface {
    /// Joins curves of equal features in consecutive slices by straight boundary lines, with triangles between them. Arcs are cut
    /// into straight pieces no farther than `accuracy` (in the model's unit) from them, and into 4096 a turn at most.
    ///
    /// ```
    /// use cspace::{Configuration, Part, Vertex};
    /// use cspace_baseline::{Stack, Surface, evenly};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// // An even number of slices: none is at the orientation 0, where sides align.
    /// let stack = Stack::new(&square("table", 2.0)?, &square("block", 1.0)?, &evenly(std::f64::consts::TAU / 1256.0)?);
    /// let surface = Surface::new(&stack, 0.01);
    /// assert_eq!(surface.layers.len(), stack.slices.len());
    /// assert_eq!(surface.is_free(Configuration::new(4.0, 0.0, 0.1)), Some(true));
    /// assert_eq!(surface.is_free(Configuration::new(2.0, 0.0, 0.1)), Some(false));
    /// // The features change there, and the layer is open.
    /// assert_eq!(surface.is_free(Configuration::new(2.0, 0.0, 0.0)), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(stack: &Stack, accuracy: f64) -> Self {
        let n = stack.slices.len();
        let layers = (0..n).into_par_iter().map(|i| {
            let (lower, upper) = (&stack.slices[i], &stack.slices[(i + 1) % n]);
            Layer::new(i, lower, upper, accuracy)
        });
        Self {
            layers: layers.collect(),
            accuracy,
        }
    }

    /// Whether a configuration is free according to the surface: `None` where its layer is open, so that the surface
    /// does not separate free from blocked space.
    pub fn is_free(&self, c: Configuration) -> Option<bool> {
        let lowest = self.layers.first()?.theta.0;
        let theta = c.theta - TAU * ((c.theta - lowest) / TAU).floor();
        let above = self.layers.partition_point(|l| l.theta.0 <= theta);
        let layer = self.layers.get(above.checked_sub(1)?)?;
        layer.is_free(c.position(), theta)
    }

    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.layers.iter().map(|l| l.triangles.len()).sum()
    }
}

impl Layer {
    fn new(index: usize, lower: &Slice, upper: &Slice, accuracy: f64) -> Self {
        let joined = join(lower, upper);
        let turned = upper.theta <= lower.theta;
        let top = upper.theta + if turned { TAU } else { 0.0 };
        let mut layer = Self {
            slice: index,
            theta: (lower.theta, top),
            open: lower.curves.len() + upper.curves.len() - 2 * joined.len(),
            closed: false,
            vertices: Vec::new(),
            triangles: Vec::new(),
            pieces: Vec::new(),
            joined,
        };
        layer.closed = layer.open == 0 && layer.follows(lower, upper);
        for k in 0..layer.joined.len() {
            let (i, j) = layer.joined[k];
            let (a, b) = (
                &lower.curves[i as usize].geometry,
                &upper.curves[j as usize].geometry,
            );
            layer.add(a, b, accuracy);
        }
        layer
    }

    /// Whether partners of consecutive curves are consecutive.
    fn follows(&self, lower: &Slice, upper: &Slice) -> bool {
        let partner = |i: u32| {
            let at = self.joined.binary_search_by_key(&i, |p| p.0).ok()?;
            Some(self.joined[at].1)
        };
        self.joined.iter().all(|&(i, j)| {
            let next = lower.curves[i as usize].next;
            partner(next) == Some(upper.curves[j as usize].next)
        })
    }

    fn add(&mut self, a: &CurveGeometry, b: &CurveGeometry, accuracy: f64) {
        let n = pieces(a, accuracy).max(pieces(b, accuracy));
        let first = self.vertices.len() as u32;
        self.pieces.push((first, n));
        for k in 0..=n {
            let s = f64::from(k) / f64::from(n);
            for (curve, theta) in [(a, self.theta.0), (b, self.theta.1)] {
                let p = curve.point(s);
                self.vertices.push(Configuration::new(p.x, p.y, theta));
            }
        }
        for k in 0..n {
            let at = first + 2 * k;
            // Travel × up is to the right, where free space is.
            self.triangles.push([at, at + 2, at + 3]);
            self.triangles.push([at, at + 3, at + 1]);
        }
    }

    /// Whether a position is free, by the parity of a ray's crossings with the contour halfway between the two slices'
    /// corners.
    fn is_free(&self, p: Point, theta: f64) -> Option<bool> {
        if !self.closed {
            return None;
        }
        let t = (theta - self.theta.0) / (self.theta.1 - self.theta.0);
        let corner = |at: u32| {
            let [a, b] = [at, at + 1].map(|i| self.vertices[i as usize].position());
            a.lerp(b, t)
        };
        let mut free = true;
        for &(first, n) in &self.pieces {
            for k in 0..n {
                let (a, b) = (corner(first + 2 * k), corner(first + 2 * k + 2));
                if (a.y > p.y) != (b.y > p.y) {
                    let x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
                    free ^= x > p.x;
                }
            }
        }
        Some(free)
    }
}

/// Number of straight pieces for a curve: a chord of angle α is r (1 − cos α/2) from its arc.
fn pieces(curve: &CurveGeometry, accuracy: f64) -> u32 {
    /// Smallest and largest number of chords of a turn: fewer than two have no length, and the upper limit holds for
    /// any accuracy.
    const FEWEST: f64 = 2.0;
    const MOST: f64 = 4096.0;
    match *curve {
        CurveGeometry::Segment { .. } => 1,
        CurveGeometry::FlatArc { start, end, bulge } => {
            // n pieces of an arc are off it by its height / n².
            let height = 0.5 * bulge.abs() * start.distance(end);
            (height / accuracy).sqrt().ceil().clamp(1.0, MOST) as u32
        }
        CurveGeometry::Arc { radius, sweep, .. } => {
            let angle = 2.0 * (1.0 - accuracy / radius).clamp(-1.0, 1.0).acos();
            let angle = angle.clamp(TAU / MOST, TAU / FEWEST);
            (sweep.abs() / angle).ceil().max(1.0) as u32
        }
    }
}
