//! What a model file says.

use cspace::{Part, Point, Vector};

/// A mechanism: parts, how each may move, how they are joined, and which pairs of them to study.
///
/// Lengths are in the model's unit, angles in radians. Indices of parts count from 0 in the order
/// of the file.
///
/// ```
/// let model = cspace_io::Model::from_toml(
///     r#"
///     name = "pin in a plate"
///     [[part]]
///     name = "plate"
///     loops = [[[0, 0], [4, 0], [4, 4], [0, 4]]]
///     motion = { type = "fixed" }
///     [[part]]
///     name = "pin"
///     loops = [[[6, 0, 1], [8, 0, 1]]]
///     "#,
///     "pin.toml",
/// )?;
/// assert_eq!(model.parts[1].part.name(), "pin");
/// assert_eq!((model.pairs[0].fixed, model.pairs[0].moving), (0, 1));
/// # Ok::<(), cspace_io::ModelError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    /// What the mechanism is called; the file's name without extension when the file does not say, its control characters
    /// escaped.
    pub name: String,
    /// A label for the unit of length.
    pub unit: Option<String>,
    /// The parts, in the file's order.
    pub parts: Vec<PartEntry>,
    /// The permanent connections.
    pub joints: Vec<Joint>,
    /// The pairs to study. A file without any stands for every two parts, the earlier one fixed.
    pub pairs: Vec<Pair>,
}

/// A part and how it may move.
#[derive(Debug, Clone, PartialEq)]
pub struct PartEntry {
    /// The outline, in the part's own frame, which is the assembly's frame at zero motion.
    pub part: Part,
    /// The motion relative to the ground.
    pub motion: Motion,
    /// The fold of a rotational symmetry about the part's own centre, as the file declares it. At least 1, and true:
    /// the reader refuses what the outline contradicts.
    pub symmetry: Option<u32>,
}

/// The motion of a part relative to the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Motion {
    /// The part does not move.
    Fixed,
    /// Motion u takes q to `center` + `R_u` (q − `center`).
    Revolute {
        /// The pivot, in assembly coordinates.
        center: Point,
        /// Least and greatest u in radians, in that order; the span may exceed a turn.
        range: Option<(f64, f64)>,
    },
    /// Motion s takes q to q + s·d/|d|.
    Prismatic {
        /// The direction d: finite, not zero, of any length.
        direction: Vector,
        /// Least and greatest s in the model's unit of length, in that order.
        range: Option<(f64, f64)>,
    },
    /// The part moves freely in the plane.
    #[default]
    Planar,
}

/// A permanent connection of two different parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// What the connection leaves free.
    pub kind: JointKind,
    /// The two parts' indices.
    pub parts: (usize, usize),
}

/// What a joint leaves free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointKind {
    /// Rotation about a point.
    Revolute {
        /// The pivot, in assembly coordinates.
        at: Point,
    },
    /// Translation along a line.
    Prismatic {
        /// The line's direction: finite, not zero, of any length.
        direction: Vector,
        /// A point of the line, in assembly coordinates, when the file gives one.
        at: Option<Point>,
    },
    /// Nothing.
    Rigid,
}

/// Two different parts whose contact space is wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Index of the part in whose frame configurations are expressed.
    pub fixed: usize,
    /// Index of the part that moves in that frame.
    pub moving: usize,
    /// The orientations of interest (lo, hi) in radians: lo < hi, at most a turn apart. All when absent.
    pub window: Option<(f64, f64)>,
}

impl Model {
    /// The index of the part called `name`.
    pub fn part_index(&self, name: &str) -> Option<usize> {
        self.parts.iter().position(|p| p.part.name() == name)
    }
}

/// The pairs of a file that lists none: every two of `parts` parts, the earlier one fixed.
pub(super) fn every_two(parts: usize) -> impl Iterator<Item = Pair> {
    (0..parts).flat_map(move |fixed| {
        (fixed + 1..parts).map(move |moving| Pair {
            fixed,
            moving,
            window: None,
        })
    })
}
