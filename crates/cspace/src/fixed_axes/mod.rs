//! Pairs on fixed axes: each part turns about a point, slides along a direction, or does not move (section 3.2 of
//! Sacks 1999, *higher pairs with two degrees of freedom*).
//!
//! A configuration is (u, v), the motions of the fixed and of the moving part. The space of configurations is a torus,
//! a cylinder, a strip, a rectangle or a plane. Contact of two features is a curve in it, and with one coordinate given the
//! other has a closed form: a cos v + b sin v = c for a part that turns, a linear or quadratic equation for one that slides.
//!
//! ```
//! use cspace::{Axis, Classification, FixedAxesSpace, Part, Point, Vector, Vertex};
//! // A disc of radius 1 that turns about a point half way out, and a flat follower above it.
//! let cam = Part::new("cam", vec![vec![Vertex::new(1.5, 0.0, 1.0), Vertex::new(-0.5, 0.0, 1.0)]])?;
//! let corners = [(-3.0, 0.0), (3.0, 0.0), (3.0, 1.0), (-3.0, 1.0)];
//! let follower = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
//! let follower = Part::new("follower", vec![follower])?;
//! let space = FixedAxesSpace::compute(
//!     &cam,
//!     Axis::revolute(Point::new(0.0, 0.0)),
//!     &follower,
//!     Axis::prismatic(Vector::new(0.0, 1.0)).within(-1.0, 9.0),
//! )?;
//! // The follower's lower side is at the top of the disc, 1 + sin(u) / 2.
//! let u = 0.7_f64;
//! let top = 1.0 + 0.5 * u.sin();
//! assert_eq!(space.classify(u, top + 1e-6), Some(Classification::Free));
//! assert_eq!(space.classify(u, top - 1e-6), Some(Classification::Blocked));
//! assert!(space.regions()[0].around_u);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Method
//!
//! The plane is swept along x, the coordinate of a part that turns if there is one (u or v); y is the other.
//!
//! 0. *Setting* (`setup`, `scene`, `repeats`): frame, motions, outlines. A part that turns without limits about its own centre of symmetry
//!    is swept over one period of its motion, the *window*; one feature of every orbit is examined.
//! 1. *Nodes* (`nodes`, `meeting`): a contact curve ends where one of its features ends and its neighbour begins. These configurations have
//!    closed forms and names: a joint of one part and a feature of the other, two vertices, two lines. Pairs that meet at a node compute it
//!    from the same numbers, to the same bit; coordinates are not compared to find which pairs meet.
//! 2. *Pieces* (`condition`, `build`, `sections`, `place`): the curve of a pair is cut at nodes, at turnings (dx = 0 and dy = 0, closed
//!    forms), at ends of the window and at limits into monotone graphs y(x), and vertical segments where y does not matter (dwell). A piece
//!    is a contact if its midpoint lies within the extents of both features.
//! 3. *Crossings* (`cross`): crossings of two monotone graphs are decided by their order at the ends of their common interval; where that
//!    is not enough, the resultant of both conditions isolates all roots. Nothing is found by sampling.
//! 4. *Cells* (`arrange`): pieces between crossings. Cells that follow each other around the outside form a chain.
//! 5. *Verdicts* (`judge`): a chain bounds free space as a whole or not at all; exact overlap tests beside its largest cells decide. A
//!    chain that is known to be blocked but tests free, or whose tests differ, is decided cell by cell and counted as a conflict.
//! 6. *Bands and regions* (`sweep`, `region`): between critical values of x the free gaps of y are bounded by an ordered list of cells.
//!    Gaps are joined across critical values by overlap; turns are counted, so that it is known around which coordinates a region extends.
//!    Every gap that is wide enough for a certain test is tested for overlap; if a test contradicts the cells beside it, all cells are
//!    decided one by one, and this counts as a conflict.
//! 7. *Copies* (`copies`): the boundary of free space in the window is copied to all periods, with the images of the features.
//! 8. *Patches* (`patches`): free cells of one pair of features, in order of travel, with their neighbours.
//!
//! `compute` runs these steps. The result is data (`data`), and quantities that follow from them (`space`); a saved space is read back by
//! the same constructor. Where the partition contradicts itself, the steps are repeated with the parts displaced by less than the
//! resolution (`displacement`).
//!
//! The sweep does not need the chains to be right everywhere: a gap is free where both the cell below and the cell above it bound free
//! space there. Therefore it was preferred to faces made of loops, which are awkward on a torus anyway.
//!
//! # Ties
//!
//! Both parts are grown as for general pairs (`feature/tolerance.rs`), so a pin exactly as wide as its slot has no free space. A third
//! curve is on the same side of a node for all pieces that end there, so rounding never makes a curve cross half a chain. Pieces that
//! coincide and face the same way count as one. Sections too short to have a place are contracted; ends that differ from a vertical piece
//! only by rounding are moved onto it; normals that oppose each other exactly are ordered by one rule.

mod arrange;
mod axis;
mod bearing;
mod build;
mod carriers;
mod classify;
mod compute;
mod condition;
mod copies;
mod cross;
mod data;
mod displacement;
mod equation;
mod faults;
mod first_contact;
mod free;
mod judge;
mod meeting;
mod motion;
mod nearest;
mod nodes;
mod patches;
mod piece;
mod place;
mod project;
mod ranges;
mod reach;
mod region;
mod repeats;
mod scene;
mod sections;
mod setup;
mod space;
mod sweep;
mod swept_plane;
mod tolerance;
mod turnings;

pub use axis::{AxesError, Axis, AxisMotion, Role};
pub use data::{AxesData, AxesDataError, AxesStatistics, SAVED_AXES_VERSION};
pub use first_contact::{AxesContact, AxesMotionOutcome};
pub use free::FreeGap;
pub use nearest::NearestOnAxes;
pub use patches::{AxesBranch, AxesPatch, BranchForm};
pub use region::AxesRegion;
pub use space::FixedAxesSpace;
pub use swept_plane::{PlaneBand, PlaneCurve, PlaneGap, SweptPlane};
