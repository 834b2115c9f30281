//! Mesh of a contact space.

use core::f64::consts::{PI, TAU};
use std::collections::BTreeMap;

use cspace::{Configuration, ContactSpace, PatchId};

use super::level::{Fineness, Level, Structure};
use super::strip::zip;

/// Fineness of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshOptions {
    /// Largest distance of a triangle from the surface, within a slice, as a share of the pair's size.
    pub tolerance: f64,
}

/// A triangle of a patch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Triangle {
    /// Indices of its vertices, counter-clockwise seen from free space.
    pub vertices: [u32; 3],
    /// The patch it lies on.
    pub patch: PatchId,
}

/// The contact surface as triangles: vertices (x, y, θ) on the exact surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// The vertices.
    pub vertices: Vec<Configuration>,
    /// The triangles.
    pub triangles: Vec<Triangle>,
    /// The greatest distance found between triangles and surface, within slices, in the model's unit.
    pub deviation: f64,
    /// The orientations at which the surface is cut off; at a full turn's ends the same vertices come in the same order.
    pub ends: (f64, f64),
    /// Length of one radian in files, as third coordinate: 1, or [`turn_as_tall_as_wide`](Self::turn_as_tall_as_wide).
    pub theta_scale: f64,
}

/// Edges of a mesh that are not shared by two triangles in opposite directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Openings {
    /// Number of all edges of the mesh.
    pub edges: usize,
    /// Number of open edges at the orientations where the surface is cut off.
    pub at_ends: usize,
    /// Elsewhere: none, if the mesh is closed.
    pub elsewhere: usize,
    /// Edges of four triangles or more, in opposite directions in equal number: where surfaces touch.
    pub touching: usize,
}

/// A mesh of nothing.
impl Default for Mesh {
    fn default() -> Self {
        Self {
            vertices: Vec::new(),
            triangles: Vec::new(),
            deviation: 0.0,
            ends: (0.0, 0.0),
            theta_scale: 1.0,
        }
    }
}

impl Default for MeshOptions {
    fn default() -> Self {
        Self { tolerance: 1e-3 }
    }
}

/// Why there is no mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The tolerance asks for too much, or a saved space is damaged and no triangles come near its surface.
    #[error("the mesh would have more than {limit} vertices")]
    TooManyVertices {
        /// The most that are made.
        limit: u32,
    },
}

/// Meshes of the finest tolerance have some millions of vertices. With more, files are larger than a gigabyte, and the mesh
/// takes several of memory.
const MOST_VERTICES: u32 = 1 << 24;

/// Points of a critical level that are nearer to each other than this share of the size are one.
const MERGE: f64 = 1e-11;

/// Largest number of times that a layer between two orientations is halved.
const DEEPEST: u32 = 14;

/// The slab between two levels, with what lies in it.
struct Slab<'a> {
    structure: &'a Structure,
    below: &'a Level,
    above: &'a Level,
}

struct Mesher<'a> {
    space: &'a ContactSpace,
    /// Tolerance in the model's unit.
    tolerance: f64,
    scale: f64,
    mesh: Mesh,
    /// Vertices that the mesh may have.
    most: u32,
    /// Numbers in the mesh of the vertices of the level last finished.
    numbers: Vec<Option<u32>>,
}

impl Mesh {
    /// Meshes the surface of a contact space.
    ///
    /// # Errors
    /// If it would have more than 2²⁴ vertices.
    ///
    /// ```
    /// use cspace::{ContactSpace, Options, Part, Vertex};
    /// use cspace_model::write::mesh::{Mesh, MeshOptions};
    /// let square = |name: &str, r: f64| {
    ///     let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    ///     Part::new(name, vec![corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()])
    /// };
    /// let space = ContactSpace::compute(&square("table", 2.0)?, &square("block", 1.0)?, &Options::default())?;
    /// let mesh = Mesh::new(&space, &MeshOptions { tolerance: 0.01 })?;
    /// assert_eq!(mesh.openings().elsewhere, 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(space: &ContactSpace, options: &MeshOptions) -> Result<Self, MeshError> {
        Self::limited(space, options, MOST_VERTICES)
    }

    /// As above, with at most `most` vertices.
    pub(super) fn limited(
        space: &ContactSpace,
        options: &MeshOptions,
        most: u32,
    ) -> Result<Self, MeshError> {
        let size = space.fixed().size().max(space.moving().size());
        let mut mesher = Mesher {
            space,
            tolerance: options.tolerance * size,
            scale: space.data().frame.scale,
            mesh: Self::default(),
            most,
            numbers: Vec::new(),
        };
        mesher.run(size, options.tolerance)?;
        Ok(mesher.mesh)
    }

    /// Copy of the mesh with another length per radian in files.
    #[must_use]
    pub fn with_theta_scale(self, theta_scale: f64) -> Self {
        Self {
            theta_scale,
            ..self
        }
    }

    /// The scale of θ, in the model's unit per radian, with which a turn is as tall as the surface is wide in x or y; 1 for a
    /// mesh of nothing.
    pub fn turn_as_tall_as_wide(&self) -> f64 {
        let extent = |of: fn(&Configuration) -> f64| {
            let (lo, hi) = (self.vertices.iter().map(of))
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
                    (lo.min(x), hi.max(x))
                });
            hi - lo
        };
        let width = extent(|v| v.x).max(extent(|v| v.y));
        if width > 0.0 && width.is_finite() {
            width / TAU
        } else {
            1.0
        }
    }

    /// A vertex as files have it: x, y, and θ scaled.
    pub fn place(&self, vertex: u32) -> [f64; 3] {
        let v = &self.vertices[vertex as usize];
        [v.x, v.y, v.theta * self.theta_scale]
    }

    /// The vertices as files have them.
    pub(crate) fn places(&self) -> impl Iterator<Item = [f64; 3]> {
        (0..self.vertices.len() as u32).map(|v| self.place(v))
    }

    /// Description of the coordinates of files.
    pub(crate) fn coordinates(&self) -> String {
        if self.theta_scale == 1.0 {
            "x and y in the model's unit, z is theta in radians".to_owned()
        } else {
            format!(
                "x and y in the model's unit, z is theta in radians times {}",
                self.theta_scale
            )
        }
    }

    /// Whether every coordinate is finite in single precision, which is all that some formats have.
    pub fn fits_single_precision(&self) -> bool {
        self.places().flatten().all(|x| (x as f32).is_finite())
    }

    /// Counts the edges that are open.
    pub fn openings(&self) -> Openings {
        let mut edges: BTreeMap<(u32, u32), (i32, u32)> = BTreeMap::new();
        for t in &self.triangles {
            let [a, b, c] = t.vertices;
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let entry = edges.entry((p.min(q), p.max(q))).or_default();
                entry.0 += if p < q { 1 } else { -1 };
                entry.1 += 1;
            }
        }
        let mut openings = Openings {
            edges: edges.len(),
            ..Openings::default()
        };
        for ((a, b), (sum, uses)) in edges {
            let theta = |v: u32| self.vertices[v as usize].theta;
            if sum != 0 {
                let at = |end: f64| theta(a) == end && theta(b) == end;
                if at(self.ends.0) || at(self.ends.1) {
                    openings.at_ends += 1;
                } else {
                    openings.elsewhere += 1;
                }
            } else if uses > 2 {
                openings.touching += 1;
            }
        }
        openings
    }
}

impl Mesher<'_> {
    fn run(&mut self, size: f64, share: f64) -> Result<(), MeshError> {
        let window = self.space.window();
        let (lo, hi) = if window.full_turn {
            (-PI, PI)
        } else {
            (window.lo, window.hi)
        };
        self.mesh.ends = (lo, hi);
        let mut bounds = vec![lo];
        bounds.extend(
            self.space
                .critical_orientations()
                .iter()
                .filter(|c| lo < **c && **c < hi),
        );
        bounds.push(hi);
        let structures: Vec<Structure> = bounds
            .windows(2)
            .map(|w| Structure::at(self.space, 0.5 * (w[0] + w[1])))
            .collect();
        let (Some(first), Some(last)) = (structures.first(), structures.last()) else {
            return Ok(());
        };
        // A chord of an arc of this many radians about a centre at most a size away keeps half the tolerance.
        let longest = (4.0 * share).sqrt();
        let none = Structure::default();
        let merge = Some(MERGE * size);
        let ends = if window.full_turn {
            (last, first)
        } else {
            (&none, &none)
        };
        let fineness = self.fineness(longest);
        let mut below = if window.full_turn {
            Level::new(self.space, lo, ends.0, ends.1, merge, fineness)
        } else {
            Level::new(self.space, lo, &none, first, None, fineness)
        };
        let bottom = below.clone();
        self.numbers = self.number(&below, lo);
        for (k, structure) in structures.iter().enumerate() {
            let (from, to) = (bounds[k], bounds[k + 1]);
            let slabs = ((to - from) / longest).ceil().max(1.0) as u32;
            let step = (to - from) / f64::from(slabs);
            for i in 1..=slabs {
                let above = if i < slabs {
                    let theta = from + step * f64::from(i);
                    self.inner_level(theta, structure, step)
                } else if k + 1 < structures.len() {
                    let next = &structures[k + 1];
                    Level::new(
                        self.space,
                        to,
                        structure,
                        next,
                        merge,
                        self.fineness(longest.min(step)),
                    )
                } else if window.full_turn {
                    Level {
                        theta: to,
                        ..bottom.clone()
                    }
                } else {
                    self.inner_level(to, structure, step)
                };
                self.fill(structure, &below, &above, 0)?;
                below = above;
            }
        }
        Ok(())
    }

    fn inner_level(&self, theta: f64, structure: &Structure, step: f64) -> Level {
        Level::new(
            self.space,
            theta,
            structure,
            structure,
            None,
            self.fineness(step),
        )
    }

    /// For rows with slabs of this thickness above and below.
    fn fineness(&self, step: f64) -> Fineness {
        Fineness {
            sagitta: 0.5 * self.tolerance,
            // A piece of length l that turns by t is off by l t / 4 in the middle when it is cut into two triangles.
            turning: 2.0 * self.tolerance / step,
            scale: self.scale,
        }
    }

    /// Fills the layer between two levels with triangles. The lower one is numbered already; the upper one is numbered
    /// here.
    fn fill(
        &mut self,
        structure: &Structure,
        below: &Level,
        above: &Level,
        depth: u32,
    ) -> Result<(), MeshError> {
        let slab = Slab {
            structure,
            below,
            above,
        };
        let deviation = self.deviation(&slab);
        let middle = 0.5 * (below.theta + above.theta);
        let thick = above.theta - below.theta > 1e-7 && middle > below.theta;
        if deviation > self.tolerance && depth < DEEPEST && thick {
            let step = 0.5 * (above.theta - below.theta);
            let level = self.inner_level(middle, structure, step);
            self.fill(structure, below, &level, depth + 1)?;
            return self.fill(structure, &level, above, depth + 1);
        }
        self.mesh.deviation = self.mesh.deviation.max(deviation);
        let upper = self.number(above, above.theta);
        let limit = self.most;
        if self.mesh.vertices.len() > limit as usize {
            return Err(MeshError::TooManyVertices { limit });
        }
        let lower = std::mem::replace(&mut self.numbers, upper);
        for (i, &patch) in structure.patches.iter().enumerate() {
            let (Some(low), Some(high)) = (below.above.get(i), above.below.get(i)) else {
                continue;
            };
            zip(low, high, |corners| {
                let vertices = corners.map(|(is_upper, at)| {
                    if is_upper {
                        self.numbers[high.vertices[at].0 as usize]
                    } else {
                        lower[low.vertices[at].0 as usize]
                    }
                });
                if let [Some(a), Some(b), Some(c)] = vertices {
                    self.mesh.triangles.push(Triangle {
                        vertices: [a, b, c],
                        patch,
                    });
                }
            });
        }
        Ok(())
    }

    /// Puts the vertices that rows of a level use into the mesh.
    fn number(&mut self, level: &Level, theta: f64) -> Vec<Option<u32>> {
        let mut numbers = vec![None; level.points.len()];
        let rows = level.below.iter().chain(&level.above);
        for &(v, _) in rows.flat_map(|r| &r.vertices) {
            let slot = &mut numbers[v as usize];
            if slot.is_none() {
                let p = level.points[v as usize];
                *slot = Some(self.mesh.vertices.len() as u32);
                self.mesh.vertices.push(Configuration::new(p.x, p.y, theta));
            }
        }
        numbers
    }

    /// The greatest distance from the surface, within slices, of the middles of triangles and of their edges.
    fn deviation(&self, slab: &Slab<'_>) -> f64 {
        let mut most = 0.0_f64;
        for (i, &number) in slab.structure.patches.iter().enumerate() {
            let (Some(low), Some(high), Some(patch)) = (
                slab.below.above.get(i),
                slab.above.below.get(i),
                self.space.patch(number),
            ) else {
                continue;
            };
            zip(low, high, |corners| {
                let c = corners.map(|(is_upper, at)| {
                    let (level, row) = if is_upper {
                        (slab.above, high)
                    } else {
                        (slab.below, low)
                    };
                    let p = level.points[row.vertices[at].0 as usize];
                    [p.x, p.y, level.theta]
                });
                let mut look = |w: [f64; 3]| {
                    let at = |k: usize| w[0] * c[0][k] + w[1] * c[1][k] + w[2] * c[2][k];
                    let place = Configuration::new(at(0), at(1), at(2));
                    most = most.max(patch.contact_function(place).abs());
                };
                const THIRD: f64 = 1.0 / 3.0;
                for weights in [
                    [0.5, 0.5, 0.0],
                    [0.0, 0.5, 0.5],
                    [0.5, 0.0, 0.5],
                    [THIRD, THIRD, THIRD],
                ] {
                    look(weights);
                }
            });
        }
        most
    }
}
