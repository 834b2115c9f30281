//! Parts and their loops.

use super::{Edge, PartError, Vertex};

/// A closed loop of a part, as it was given.
#[derive(Debug, Clone, PartialEq)]
pub struct Loop {
    vertices: Vec<Vertex>,
    /// Whether the given direction has material on the right.
    reversed: bool,
}

/// A planar part: the even-odd interior of its loops, in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    name: String,
    loops: Vec<Loop>,
}

impl Loop {
    /// The vertices, as given.
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Whether the loop was given with material on its right, so that its edges are travelled backwards.
    pub fn is_reversed(&self) -> bool {
        self.reversed
    }

    /// The edges in order of travel, material on the left.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        let n = self.vertices.len();
        (0..n).map(move |i| {
            let index = if self.reversed { n - 1 - i } else { i };
            let (here, next) = (self.vertices[index], self.vertices[(index + 1) % n]);
            if self.reversed {
                Edge {
                    start: next.point(),
                    end: here.point(),
                    bulge: -here.bulge,
                    index,
                }
            } else {
                Edge {
                    start: here.point(),
                    end: next.point(),
                    bulge: here.bulge,
                    index,
                }
            }
        })
    }
}

impl Part {
    /// Checks the loops and finds on which side of each the material lies.
    ///
    /// # Errors
    /// Says which loop and vertex is wrong and why.
    pub fn new(name: impl Into<String>, loops: Vec<Vec<Vertex>>) -> Result<Self, PartError> {
        if loops.is_empty() {
            return Err(PartError::Empty);
        }
        // Provisional: direction by signed area, no nesting.
        let loops = loops
            .into_iter()
            .map(|vertices| Loop {
                reversed: signed_area(&vertices) < 0.0,
                vertices,
            })
            .collect();
        Ok(Self {
            name: name.into(),
            loops,
        })
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

fn signed_area(vertices: &[Vertex]) -> f64 {
    let n = vertices.len();
    (0..n)
        .map(|i| {
            let (a, b) = (vertices[i], vertices[(i + 1) % n]);
            let chord = b.point() - a.point();
            let sweep = 4.0 * a.bulge.atan();
            let r = chord.length() * (1.0 + a.bulge * a.bulge) / (4.0 * a.bulge.abs());
            let segment = if a.bulge == 0.0 {
                0.0
            } else {
                0.5 * r * r * (sweep - sweep.sin())
            };
            0.5 * a.point().to_vector().cross(b.point().to_vector()) + segment
        })
        .sum()
}
