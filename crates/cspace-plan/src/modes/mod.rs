//! Operating modes of parts on fixed axes: the connected components of the configurations in which no two overlap.
//!
//! [`Modes`] are those of three parts, each of which may touch both others; [`TreeModes`] those of any number of parts whose contacts
//! make a tree.
//!
//! Three parts A, B and C that each turn or slide on an axis have the coordinates u, v and w (radians, or the model's unit of
//! length). A configuration is free if it is free for each of the three pairs:
//!
//! free(u, v, w) ⇔ (u, v) ∈ free(A, B), (v, w) ∈ free(B, C) and (u, w) ∈ free(A, C).
//!
//! Each set on the right is a [`FixedAxesSpace`](cspace::FixedAxesSpace), bounded by contact curves in closed form. [`Modes`]
//! computes the intersection from the curves, and which of its configurations a motion joins.
//!
//! ```
//! use cspace::Part;
//! use cspace_model::{Mechanism, PartEntry};
//! use cspace_plan::modes::{ModePlace, Modes};
//! // Two bolts and a slide across them, which has a slot that takes the end of one bolt at a time.
//! let mut lock = Mechanism::new("lock");
//! let mut add = |part, direction: (f64, f64), range: (f64, f64)| {
//!     let mut entry = PartEntry::prismatic(part, direction);
//!     entry.axis = entry.axis.map(|axis| axis.within(range.0, range.1));
//!     lock.parts.push(entry);
//! };
//! let slot = [(-9.0, 0.0), (9.0, 0.0), (9.0, 4.0), (1.5, 4.0), (1.5, 1.0), (-1.5, 1.0), (-1.5, 4.0), (-9.0, 4.0)];
//! add(Part::rectangle("left bolt", (-4.0, 7.0), 2.0, 4.0)?, (0.0, 1.0), (-3.0, 1.0));
//! add(Part::polygon("slide", &slot)?, (1.0, 0.0), (-4.0, 4.0));
//! add(Part::rectangle("right bolt", (4.0, 7.0), 2.0, 4.0)?, (0.0, 1.0), (-3.0, 1.0));
//! lock.pairs = lock.every_two();
//! let modes = Modes::compute(&lock, [0, 1, 2])?;
//! // With the slide to the left the left bolt enters the slot, with the slide to the right the right one: one mode.
//! assert_eq!(modes.list().len(), 1);
//! assert_eq!(modes.locate([-3.0, -4.0, 0.0])?, ModePlace::Mode(0));
//! assert_eq!(modes.locate([0.0, 4.0, -3.0])?, ModePlace::Mode(0));
//! // Both at once they do not.
//! assert!(matches!(modes.locate([-3.0, -4.0, -3.0])?, ModePlace::Blocked(_)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//!
//! One coordinate, s, is swept; the others are p and q. Over a *slab* of s the free p and the free q are intervals between monotone
//! curves (`graph`, `plane`). A *column* is one of each (`column`). Its section at s is what the rectangle of both leaves of the plane
//! (p, q): at most one piece of each gap there, because a gap has monotone ends (`section`). A column is cut into *layers* where pieces
//! come and go: where an end of an interval passes a critical value of the plane, or a corner of the rectangle one of its curves. The
//! latter is a root of f(a(s)) − c(s) with monotone f, a and c, which ranges and enclosures of derivatives isolate (`roots`). Pieces that
//! share an opening are joined, with the turns that lead from one to the other (`sweep`, `turns`).

mod column;
mod components;
mod error;
mod extent;
mod graph;
mod locate;
mod mode;
mod plane;
mod roots;
mod section;
mod shadow;
mod shape;
mod sweep;
mod tree;
mod trio;
mod turns;

pub use components::Modes;
pub use error::ModesError;
pub use locate::{ModePlace, coordinate_name};
pub use mode::Mode;
pub use shadow::Shadow;
pub use tree::{TreeMode, TreeModes};
pub use trio::{PAIRS, TrioPair, moving_parts};
