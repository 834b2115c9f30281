//! Exact configuration spaces of planar parts bounded by line segments and circular arcs.
//!
//! Two parts touch, slide, jam and clear each other. The placement of the *moving* part relative to the *fixed* part is a *configuration*
//! (x, y, θ): a point q of the moving part is at (x, y) + `R_θ` q, angles in radians. The configurations in which the parts overlap are
//! *blocked*, those in which they are apart are *free*, and between them lies a surface of *contact patches*: on each patch one feature of
//! one part touches one feature of the other. This crate computes that surface in closed form, without polygons for arcs and without steps
//! in θ, and answers queries from it.
//!
//! # Two examples
//!
//! A coin of radius 2 in a tray with a lip: where is it free, and does it come out?
//!
//! ```
//! use cspace::{Configuration, Coordinates, Location, Options, OutlineBuilder, PairSpace, Part, Relation};
//! let tray = OutlineBuilder::start((-6.0, -1.0))
//!     .line_to((6.0, -1.0))
//!     .line_to((6.0, 8.0))
//!     .line_to((1.5, 8.0))
//!     .line_to((1.5, 7.0))
//!     .line_to((5.0, 7.0))
//!     .fillet(1.0)
//!     .line_to((5.0, 0.0))
//!     .line_to((-5.0, 0.0))
//!     .line_to((-5.0, 8.0))
//!     .line_to((-6.0, 8.0))
//!     .close()?;
//! let tray = Part::new("tray", vec![tray])?;
//! let coin = Part::circle("coin", (0.0, 0.0), 2.0)?;
//! let space = PairSpace::compute(&tray, &coin, Relation::Planar, &Options::default())?;
//!
//! let at = |x, y| Coordinates::Planar(Configuration::new(x, y, 0.0));
//! assert!(matches!(space.locate(at(0.0, 3.0))?, Location::Free(_)));
//! assert_eq!(space.locate(at(0.0, 1.0))?, Location::Blocked);
//! // With its middle 3 above the floor, its rim is 1 above it, and everything else is farther away.
//! assert!((space.clearance(at(0.0, 3.0))? - 1.0).abs() < 1e-12);
//! // The opening is 6.5 wide: the coin comes out.
//! assert!(space.connected(at(0.0, 3.0), at(0.0, 20.0))?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A crank that turns about the origin comes down on a slide: each part has one axis, and a configuration is (u, v), an angle and a way.
//! How far has it turned when it touches?
//!
//! ```
//! use cspace::pair::PairMotion;
//! use cspace::{Axis, Coordinates, Options, PairSpace, Part, Point, Relation, Vector};
//! let crank = Part::slot("crank", (0.0, 0.0), (0.0, 4.0), 1.0)?;
//! let slide = Part::rectangle("slide", (-7.0, 0.0), 5.0, 2.0)?;
//! let fixed = Axis::revolute(Point::ORIGIN);
//! let moving = Axis::prismatic(Vector::new(1.0, 0.0));
//! let space = PairSpace::compute(&crank, &slide, Relation::Axes { fixed, moving }, &Options::default())?;
//!
//! let at = |u, v| Coordinates::Axes { u, v };
//! let PairMotion::Contact(touch) = space.first_contact(at(0.0, 0.0), at(1.0, 0.0), 2.0)? else {
//!     return Err("the crank touches the slide".into());
//! };
//! // Its rounded end, of radius 1 and 4 from the axis, meets the corner (-4.5, 1): by the law of cosines.
//! let corner = 4.5_f64.hypot(1.0);
//! let expected = 4.5_f64.atan2(1.0) - ((16.0 + corner * corner - 1.0) / (8.0 * corner)).acos();
//! assert!((touch.time - expected).abs() < 1e-9);
//! let (of_crank, of_slide) = space.patch(touch.patch)?.features()?;
//! assert_eq!(of_slide.to_string(), "vertex 2 of loop 0 of the moving part");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What can be asked
//!
//! | question | answer |
//! |---|---|
//! | where is a configuration, and how far are the parts apart | [`PairSpace::locate`], [`clearance`](PairSpace::clearance), [`connected`](PairSpace::connected) |
//! | what touches there, what is nearest to touching | [`PairSpace::contacts`], [`nearest_contact`](PairSpace::nearest_contact) |
//! | what does a motion meet, and when | [`PairSpace::first_contact`], [`crossings`](PairSpace::crossings), [`first_contact_along`](PairSpace::first_contact_along) |
//! | the patches, what is next to what, the free regions | [`PairSpace::patches`], [`links`](PairSpace::links), [`regions`](PairSpace::regions), [`bands`](PairSpace::bands) |
//! | a patch's contact function, gradient, Hessian, touching points, derivatives by the drawing | [`PairPatch::contact`] |
//! | all contacts at one orientation | [`Slice`] |
//! | the farthest, such as the lowest, place over all orientations | [`ContactSpace::farthest`] |
//! | where a part can be placed beside others or in a frame, including exact fits | [`NoFit`] |
//! | millions of configurations | [`Classifier`] |
//!
//! # Pairs of all classes
//!
//! The relative motion of the parts determines the method, and the form of a configuration:
//!
//! | [`Relation`] | class | a configuration is |
//! |---|---|---|
//! | `Planar` | general, or symmetric where a part is | (x, y, θ) |
//! | `Axes` | fixed axes: each part turns, slides or stands still | (u, v), the two motions |
//! | `Joint` | lower: a joint connects the parts | (x, y, θ), on the joint |
//!
//! A mechanism of the crate `cspace-model` has parts, axes, joints and pairs, and determines the relation of every pair.
//!
//! # How far it can be trusted
//!
//! *Exact* means exact in form and correct to a resolution, 7·10⁻¹² of the size of the pair, given by [`PairSpace::resolution`]. A
//! clearance below [`PairSpace::least_clearance`] counts as none. Orientations at which the structure of a space is in doubt are reported
//! by [`ContactSpace::doubtful_orientations`].
//!
//! # Cargo features
//!
//! | feature | by default | what it adds |
//! |---|---|---|
//! | `serde` | yes | public plain data, such as a [`Part`] or the [`SpaceData`](space::SpaceData) of a computed space, is written and read by `serde` |
//! | `rayon` | yes | work is divided among the threads of the `rayon` pool from which it is called; results do not depend on their number |
//! | `schema` | | plain data has a JSON schema, by `schemars` |
//! | `kurbo` | | `Point` and `Vec2`, an [`Edge`] of an `Arc`, `Part::from_circle`, `Part::to_bez_path`; `cspace-drawing` reads a `BezPath` |
//! | `geo-types` | | `Coord` and `Point`, `Part::from_polygons`, `Part::to_polygons` |
//! | `mint` | | `Point2` and `Vector2` |

// It reads no files and prints nothing.
#![warn(clippy::print_stdout, clippy::print_stderr)]

mod boxes;
mod classifier;
pub(crate) mod contact;
#[cfg(any(feature = "geo-types", feature = "kurbo", feature = "mint"))]
pub mod convert;
pub(crate) mod feature;
pub mod fixed_axes;
#[cfg(feature = "fuzzing")]
#[doc(hidden)]
pub mod fuzzing;
pub(crate) mod general;
pub mod geometry;
mod grouped;
mod ids;
pub(crate) mod number;
pub mod pair;
pub mod parallel;
pub mod part;
pub mod query;
pub mod slice;
pub mod space;
mod union_find;

pub use classifier::Classifier;
pub use contact::{
    ContactFunction, ContactValue, FeatureShape, Placement, Spiral, Swing, Touching, TouchingPlace,
    contact_function, overlap_as_drawn, touching, touching_place,
};

pub use feature::{FeatureKind, FeatureName, PairFrame};
pub use fixed_axes::{AxesError, Axis, AxisMotion, FixedAxesSpace};
pub use general::{NoFit, NoFitError, Slicer};
pub use geometry::{Configuration, LARGEST_ANGLE, Point, Rotation, Vector};
pub use ids::{LinkId, PatchId, RegionId};
pub use number::{Ball, Dual, Real, SecondOrder};
pub use pair::{
    ByDrawing, ByVertex, Coordinates, FeatureContact, FeatureId, LinkKind, LowerPair, Metric,
    NearFeatures, PairClass, PairError, PairLink, PairPatch, PairRegion, PairSpace, Projection,
    QueryError, Relation, SmoothMotion, SmoothOutcome,
};
pub use part::{
    ArcSize, AreaMoments, Direction, Edge, Layer, Loop, OutlineBuilder, OutlineError, Part,
    PartError, PartSymmetry, Vertex,
};
pub use query::{
    Classification, Farthest, FirstContact, Location, MotionError, MotionOutcome, NearestContact,
};
pub use slice::{CurveGeometry, Slice, SliceCurve};
pub use space::{
    Band, Boundary, BoundaryCurve, BoundaryKind, ComputeError, ContactSpace, Decisions,
    FeatureCounts, FreeRegion, LONGEST_WINDOW, Options, PairSymmetry, Patch, PatchRef, Progress,
    SideLink, Silent, Stage, StageSeconds, Statistics, Symmetry, VerticalLink, Window,
};

/// The library's example in the README.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
