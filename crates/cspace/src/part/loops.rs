//! Parts and their loops.

use crate::geometry::{Configuration, Point};

use super::check::{check_extent, check_numbers};
use super::corner::check_corners;
use super::layer::meet;
use super::nearness::check_vertices;
use super::outline::Outline;
use super::sweep::check_meetings;
use super::tolerance::MAX_LAYERS;
use super::{Bounds, Edge, Heights, Layer, PartError, PartFeature, Vertex};

/// A closed loop of a part, as it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    vertices: Vec<Vertex>,
    /// Whether the given direction has material on the right.
    reversed: bool,
}

/// A planar part, in its own frame: the even-odd interior of its loops, or a stack of layers, each the even-odd interior of its own loops.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    pub(super) name: String,
    pub(super) loops: Vec<Loop>,
    pub(super) layers: Vec<Layer>,
    /// Names of edges and vertices, in order.
    pub(super) names: Vec<(PartFeature, String)>,
    /// The box of the loops' edges; stored because it is used for every query.
    pub(super) bounds: Bounds,
}

impl Loop {
    /// The vertices, as given, except that negligible bulges are 0.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Whether the loop was given with material on its right, so that its edges are traversed backwards.
    pub fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// The edges in order of travel, material on the left.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let n = self.vertices.len();
        (0..n).filter_map(move |i| self.edge(if self.reversed { n - 1 - i } else { i }))
    }

    /// Points along the loop, material on the left, as of [`Edge::points`].
    pub fn points(&self, tolerance: f64) -> Vec<Point> {
        self.edges().flat_map(|e| e.points(tolerance)).collect()
    }

    /// The index of the vertex at which an edge starts in the direction of travel, given the edge's own.
    pub fn start_of(&self, edge: usize) -> usize {
        (edge + usize::from(self.reversed)) % self.vertices.len()
    }

    /// The edge that a vertex describes, material on the left; `None` if there is no such vertex.
    pub fn edge(&self, index: usize) -> Option<Edge> {
        let here = self.vertices.get(index)?;
        let next = self.vertices[(index + 1) % self.vertices.len()];
        let edge = Edge {
            start: here.point(),
            end: next.point(),
            bulge: here.bulge,
            index,
        };
        Some(if self.reversed { edge.reversed() } else { edge })
    }
}

impl Part {
    /// Checks the loops and finds on which side of each the material lies.
    ///
    /// The material is the even-odd interior: the places enclosed by an odd number of loops. Loops may come in either direction, in any
    /// order, nested to any depth; they may not cross or touch themselves or each other. [`RESOLUTION`] defines what counts as touching. A
    /// bulge of magnitude up to [`FLAT_BULGE`] counts as 0, a line.
    ///
    /// Takes time in proportion to n log n for n vertices, of which there may be [`MAX_VERTICES`].
    ///
    /// # Errors
    /// The error states which loop and vertex is wrong, why, and what to do. Only one of several errors is reported.
    ///
    /// ```
    /// use cspace::{Part, PartError, Vertex};
    /// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    /// let plate: Vec<_> = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    /// let hole = |x: f64| vec![Vertex::new(x - 1.0, 2.0, 1.0), Vertex::new(x + 1.0, 2.0, 1.0)];
    ///
    /// let part = Part::new("plate", vec![plate.clone(), hole(2.0)])?;
    /// assert!((part.area() - (16.0 - core::f64::consts::PI)).abs() < 1e-14);
    ///
    /// let error = Part::new("plate", vec![plate, hole(3.5)]);
    /// assert!(matches!(error, Err(PartError::Crossing { loop_index: 0, other_loop: 1, .. })));
    /// # Ok::<(), PartError>(())
    /// ```
    ///
    /// [`RESOLUTION`]: super::tolerance::RESOLUTION
    /// [`FLAT_BULGE`]: super::tolerance::FLAT_BULGE
    /// [`MAX_VERTICES`]: super::tolerance::MAX_VERTICES
    pub fn new(name: impl Into<String>, loops: Vec<Vec<Vertex>>) -> Result<Self, PartError> {
        Self::layered(name, [(None, loops)])
    }

    /// A stack of layers: for each the lowest and the highest place, or `None` if it is at every height, and its loops.
    ///
    /// The loops of each layer are checked as those of a part; loops of different layers may cross. Loops are numbered through the part.
    ///
    /// # Errors
    /// As for [`new`](Self::new), and if a height is not finite or the upper one is not above the lower one.
    ///
    /// ```
    /// use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};
    /// let disc = |r: f64| vec![Part::circle("disc", (0.0, 0.0), r).unwrap().loops()[0].vertices().to_vec()];
    /// // A wheel and a pinion on one arbor; another wheel beside it at the height of the pinion.
    /// let arbor = Part::layered("arbor", [(Some([0.0, 4.0]), disc(9.0)), (Some([4.0, 10.0]), disc(2.0))])?;
    /// let wheel = Part::layered("wheel", [(Some([5.0, 8.0]), disc(6.0))])?;
    /// let space = PairSpace::compute(&arbor, &wheel, Relation::Planar, &Options::default())?;
    /// let beside = space.clearance(Coordinates::Planar(Configuration::new(8.5, 0.0, 0.0)))?;
    /// assert!((beside - 0.5).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn layered(
        name: impl Into<String>,
        layers: impl IntoIterator<Item = (Heights, Vec<Vec<Vertex>>)>,
    ) -> Result<Self, PartError> {
        let mut loops: Vec<Vec<Vertex>> = Vec::new();
        let mut stack = Vec::new();
        for (layer, (z, outlines)) in layers.into_iter().enumerate() {
            // Written so that NaN is rejected too.
            let rises = z.is_none_or(|[lo, hi]| lo.is_finite() && hi.is_finite() && meet(z, z));
            if !rises {
                return Err(PartError::BadHeights { layer });
            }
            let first = loops.len();
            loops.extend(outlines);
            let loops = first..loops.len();
            stack.push(Layer { z, loops });
        }
        if stack.len() > MAX_LAYERS {
            return Err(PartError::TooManyLayers { count: stack.len() });
        }
        let empty = stack.iter().position(|l| l.loops.is_empty());
        if let Some(layer) = empty.filter(|_| !loops.is_empty()) {
            return Err(PartError::EmptyLayer { layer });
        }
        check_numbers(&mut loops)?;
        let bounds = check_extent(&loops)?;
        let mut reversed = Vec::with_capacity(loops.len());
        for layer in &stack {
            let outline = Outline::new(&loops[layer.loops()], layer.loops.start, bounds);
            check_corners(&outline)?;
            check_vertices(&outline, &loops)?;
            reversed.extend(check_meetings(&outline)?);
        }
        let loops = loops.into_iter().zip(reversed);
        Ok(Self {
            name: name.into(),
            loops: loops
                .map(|(vertices, reversed)| Loop { vertices, reversed })
                .collect(),
            layers: stack,
            names: Vec::new(),
            bounds,
        })
    }

    /// The part with other loops, as many in every layer; edges and vertices keep their names if every loop has as many as before.
    ///
    /// # Errors
    /// As for [`new`](Self::new).
    pub fn redrawn(&self, loops: Vec<Vec<Vertex>>) -> Result<Self, PartError> {
        let mut loops = loops.into_iter();
        let layer = |l: &Layer| (l.z, loops.by_ref().take(l.loops.len()).collect());
        let mut redrawn = Self::layered(self.name(), self.layers.iter().map(layer))?;
        let count =
            |part: &Self| -> Vec<usize> { part.loops.iter().map(|l| l.vertices.len()).collect() };
        if count(&redrawn) == count(self) {
            redrawn.names.clone_from(&self.names);
        }
        Ok(redrawn)
    }

    /// The part with an outline that is made of each of its layers; layers of which nothing is left are left out. `None` if none is left.
    ///
    /// # Errors
    /// As for [`new`](Self::new), and errors of `outline`.
    pub fn by_layers<E: From<PartError>>(
        &self,
        mut outline: impl FnMut(&Self) -> Result<Vec<Vec<Vertex>>, E>,
    ) -> Result<Option<Self>, E> {
        let mut layers = Vec::with_capacity(self.layers.len());
        for (i, layer) in self.layers.iter().enumerate() {
            let loops = outline(&self.layer(i))?;
            if !loops.is_empty() {
                layers.push((layer.z, loops));
            }
        }
        if layers.is_empty() {
            return Ok(None);
        }
        Ok(Some(Self::layered(self.name(), layers)?))
    }

    /// A part of loops whose sides are known.
    pub(super) fn checked(name: String, layers: Vec<Layer>, loops: Vec<Loop>) -> Self {
        let edges = loops.iter().flat_map(Loop::edges);
        Self {
            name,
            bounds: edges.fold(Bounds::EMPTY, |all, e| all.union(e.bounds())),
            loops,
            layers,
            names: Vec::new(),
        }
    }

    /// Several parts, each moved by a configuration, as one part: they may touch, which is not checked.
    pub(crate) fn assembled(name: &str, placed: &[(&Self, Configuration)]) -> Self {
        let (mut loops, mut layers) = (Vec::new(), Vec::<Layer>::new());
        for (part, at) in placed {
            let vertex = |v: &Vertex| {
                let p = at.fixed_from_moving(v.point());
                Vertex::new(p.x, p.y, v.bulge)
            };
            let moved = |l: &Loop| Loop {
                vertices: l.vertices.iter().map(vertex).collect(),
                reversed: l.reversed,
            };
            for (i, layer) in part.layers.iter().enumerate() {
                let first = loops.len();
                loops.extend(part.loops[layer.loops()].iter().map(moved));
                match layers.last_mut() {
                    // Layers of one part may cross, and stay apart.
                    Some(last) if i == 0 && last.z == layer.z => last.loops.end = loops.len(),
                    _ => layers.push(Layer {
                        z: layer.z,
                        loops: first..loops.len(),
                    }),
                }
            }
        }
        Self::checked(name.to_owned(), layers, loops)
    }

    /// The complement of the part within a rectangle that is larger than the part's box by `far` on every side, at the part's heights.
    pub(crate) fn framing(&self, far: f64) -> Self {
        let (lo, hi) = (self.bounds.min, self.bounds.max);
        let around = Loop {
            vertices: vec![
                Vertex::line(lo.x - far, lo.y - far),
                Vertex::line(hi.x + far, lo.y - far),
                Vertex::line(hi.x + far, hi.y + far),
                Vertex::line(lo.x - far, hi.y + far),
            ],
            reversed: false,
        };
        let out = |l: &Loop| Loop {
            vertices: l.vertices.clone(),
            reversed: !l.reversed,
        };
        let (mut loops, mut layers) = (Vec::new(), Vec::new());
        for layer in &self.layers {
            let first = loops.len();
            loops.push(around.clone());
            loops.extend(self.loops[layer.loops()].iter().map(out));
            layers.push(Layer {
                z: layer.z,
                loops: first..loops.len(),
            });
        }
        Self::checked(self.name.clone(), layers, loops)
    }

    /// The part's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The loops, in the order given.
    pub fn loops(&self) -> &[Loop] {
        &self.loops
    }

    /// All edges of all loops, material on the left.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.loops.iter().flat_map(Loop::edges)
    }
}
