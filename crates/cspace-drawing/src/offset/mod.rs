//! Parts made larger or smaller by a distance all around, as for a kerf, a burn or the allowance of a fit.
//!
//! The outline at a distance is made of the curves at that distance from single edges and corners ([`raw`]): lines of lines, arcs
//! of arcs. They are cut wherever they meet, and a piece belongs to the outline if no edge of the part is nearer to it than the
//! distance ([`cut`]). What is left joins to loops ([`chain`]). A part that is made smaller is one around which everything else is
//! made larger.

mod chain;
mod crossing;
mod cut;
mod raw;
mod tolerance;

use core::fmt;

use cspace::{Edge, Part, PartError, Point, Vector, Vertex};

use crate::nest::{self, nest};
use crate::shown;
use chain::{Ring, rings};
use cut::{cut, outermost};
use raw::{Raw, around, raw};
use tolerance::{LARGEST, NEAR, SLACK};

/// A part at a distance from another.
#[derive(Debug, Clone, PartialEq)]
pub struct Offset {
    /// The part, its loops in the order of those they come from. It has several pieces where the other falls apart.
    pub part: Part,
    /// Changes of topology from the original part, such as a hole that is closed; in words.
    pub changes: Vec<String>,
}

impl Offset {
    /// Pieces with their holes as parts of their own, with a number if there are several.
    ///
    /// # Errors
    /// If a piece is no valid part.
    pub fn pieces(&self) -> Result<Vec<Part>, PartError> {
        let loops = self.part.loops().iter().map(|l| l.vertices().to_vec());
        let loops: Vec<Vec<Vertex>> = loops.collect();
        let rings: Vec<nest::Ring> = loops.iter().map(|l| nest::Ring::of(l)).collect();
        // A part with too deeply nested loops is not divided.
        let groups = nest(&rings.iter().collect::<Vec<_>>()).unwrap_or_default();
        if groups.len() < 2 {
            return Ok(vec![self.part.clone()]);
        }
        let numbered = groups.iter().enumerate().map(|(k, group)| {
            let name = format!("{} {}", self.part.name(), k + 1);
            Part::new(name, group.iter().map(|&i| loops[i].clone()).collect())
        });
        numbered.collect()
    }
}

/// Why a part has no outline at a distance.
#[derive(Debug, Clone, PartialEq)]
pub enum OffsetError {
    /// The distance is no finite number.
    NoNumber(f64),
    /// The distance is beyond the largest coordinate of a part.
    TooFar(f64),
    /// No place of the part is as thick.
    Nothing,
    /// The outline falls apart.
    Apart {
        /// Description of the change, in words.
        what: String,
        /// Place at which edges meet that are not adjacent in the part.
        at: Option<Point>,
        /// The loops and edges of the part that come together.
        edges: Option<[(usize, usize); 2]>,
    },
    /// The outline touches itself, or is otherwise none.
    NoPart(PartError),
}

impl OffsetError {
    /// Advice on how to correct the error.
    pub fn help(&self) -> &'static str {
        match self {
            Self::NoNumber(_) => "give a length, such as 0.1, or below 0 to make the part smaller",
            Self::TooFar(_) => "give a distance of the order of the part's size",
            Self::Nothing => "give a distance nearer to 0",
            Self::Apart { .. } => {
                "give a distance nearer to 0, make the part thicker there, or take the pieces with --split (in a model: split = true)"
            }
            Self::NoPart(_) => "give a distance that is a little larger or smaller",
        }
    }
}

impl fmt::Display for OffsetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoNumber(x) => write!(f, "the offset is {x:?}"),
            Self::TooFar(x) => write!(f, "the offset is {x:?}, more than {LARGEST:?}"),
            Self::Nothing => f.write_str("nothing of the part is left: it is nowhere so thick"),
            Self::Apart { what, at, edges } => {
                write!(f, "the outline falls apart: {what}")?;
                if let (Some(at), Some([(l, e), (m, g)])) = (at, edges) {
                    let at = shown::point(*at);
                    write!(
                        f,
                        ", near {at}, between loop {l}, edge {e} and loop {m}, edge {g}"
                    )?;
                }
                Ok(())
            }
            Self::NoPart(error) => write!(f, "the outline at that distance is none: {error}"),
        }
    }
}

impl core::error::Error for OffsetError {}

/// Offset of a part by a distance: the points within the distance of the material, or, for a negative one, the points
/// farther than that from all points outside the material. Lines stay lines and arcs stay arcs; at convex corners (of
/// the outside, for a negative distance) arcs are added.
///
/// If loops close or join where material grows, this is reported. If the part shrinks and loops join or are divided, or
/// a piece vanishes, that is an error unless `split`.
///
/// # Errors
/// If nothing is left, or the outline falls apart.
///
/// ```
/// use cspace::Part;
/// let plate = Part::rectangle("plate", (0.0, 0.0), 4.0, 3.0)?;
/// let larger = cspace_drawing::offset(&plate, 0.1, false)?.part;
/// // Steiner's formula: area + perimeter d + π d².
/// let area = 12.0 + 14.0 * 0.1 + core::f64::consts::PI * 0.01;
/// assert!((larger.area() - area).abs() < 1e-14);
/// let back = cspace_drawing::offset(&larger, -0.1, false)?.part;
/// assert!((back.area() - 12.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn offset(part: &Part, by: f64, split: bool) -> Result<Offset, OffsetError> {
    if !by.is_finite() {
        return Err(OffsetError::NoNumber(by));
    }
    let distance = by.abs();
    if distance > LARGEST {
        return Err(OffsetError::TooFar(by));
    }
    let size = part.size() + 2.0 * distance;
    let near = NEAR * size;
    if distance <= near {
        let changes = match by {
            0.0 => Vec::new(),
            _ => vec!["the offset is too small to be told from 0".to_owned()],
        };
        let part = part.clone();
        return Ok(Offset { part, changes });
    }
    // Far from the origin coordinates have few digits left for distances: all is computed in a frame about the part.
    let home = home(part, size);
    let (drawn, part) = (part, &moved(part.name(), loops_of(part), -home)?);
    let loops = around(part, by);
    let edges: Vec<Edge> = loops.iter().flatten().copied().collect();
    let raw = raw(&loops, distance, near);
    let pieces = outermost(cut(&raw, near), &edges, distance - SLACK * size);
    let rings = rings(&pieces, near);
    if rings.is_empty() {
        return Err(OffsetError::Nothing);
    }
    let vertices = rings.iter().map(|r| directed(&r.vertices, by)).collect();
    let made = moved(drawn.name(), vertices, home)?;
    let changes = changes(part, &made);
    if by < 0.0 && !split && !changes.is_empty() {
        let joint = farthest_joint(part, &raw, &rings);
        return Err(OffsetError::Apart {
            what: changes.join("; "),
            at: joint.map(|j| j.1 + home),
            edges: joint.map(|j| j.0),
        });
    }
    Ok(Offset {
        part: made,
        changes,
    })
}

/// A place near the middle of a part, on a grid coarse enough that moving the part there and back changes few digits, and none of a part
/// about the origin.
fn home(part: &Part, size: f64) -> Vector {
    let step = size.log2().ceil().exp2();
    let bounds = part.bounds();
    let middle = bounds.min.midpoint(bounds.max);
    let near = |x: f64| (x / step).round() * step;
    Vector::new(near(middle.x), near(middle.y))
}

fn loops_of(part: &Part) -> Vec<Vec<Vertex>> {
    let loops = part.loops().iter();
    loops.map(|l| l.vertices().to_vec()).collect()
}

/// The part of some loops, moved.
fn moved(name: &str, mut loops: Vec<Vec<Vertex>>, by: Vector) -> Result<Part, OffsetError> {
    if by.x != 0.0 || by.y != 0.0 {
        for vertex in loops.iter_mut().flatten() {
            let at = vertex.point() + by;
            *vertex = Vertex::new(at.x, at.y, vertex.bulge);
        }
    }
    Part::new(name, loops).map_err(OffsetError::NoPart)
}

/// The loop with the material on the left.
fn directed(vertices: &[Vertex], by: f64) -> Vec<Vertex> {
    if by > 0.0 {
        return vertices.to_vec();
    }
    let n = vertices.len();
    (0..n)
        .map(|i| {
            let at = vertices[(n - i) % n];
            Vertex::new(at.x, at.y, -vertices[n - 1 - i].bulge)
        })
        .collect()
}

/// Number of outer loops and of holes of a part.
fn counts(part: &Part) -> [usize; 2] {
    let outer = part.loops().iter().filter(|l| l.signed_area() > 0.0);
    let outer = outer.count();
    [outer, part.loops().len() - outer]
}

/// Changes in the numbers of pieces and holes, in words.
fn changes(from: &Part, to: &Part) -> Vec<String> {
    let mut changes = Vec::new();
    let words = [["piece", "pieces"], ["hole", "holes"]];
    for ((from, to), words) in counts(from).into_iter().zip(counts(to)).zip(words) {
        if from != to {
            changes.push(match from {
                1 => format!("1 {} becomes {to}", words[0]),
                _ => format!("{from} {} become {to}", words[1]),
            });
        }
    }
    changes
}

type Joint = ([(usize, usize); 2], Point);

/// Place at which edges meet that are farthest apart along the part's loops.
fn farthest_joint(part: &Part, raw: &[Raw], rings: &[Ring]) -> Option<Joint> {
    let apart = |[(l, e), (m, g)]: [(usize, usize); 2]| {
        if l != m {
            return usize::MAX;
        }
        let between = e.abs_diff(g);
        between.min(part.loops()[l].vertices().len() - between)
    };
    let joints = rings.iter().flat_map(|r| &r.joints);
    joints
        .map(|&(a, b, at)| ([raw[a].of, raw[b].of], at))
        .filter(|j| apart(j.0) > 1)
        .max_by_key(|j| apart(j.0))
}
