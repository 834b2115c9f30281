//! Pictures for the `cspace` library: parts, slices of contact spaces, planes of motions; as SVG, PNG or PDF.
//!
//! A picture is first a [`Scene`]: paths of lines and arcs, and text, at places in dots. What it shows is decided there, so
//! that it looks the same in every format.
//!
//! ```text
//!   parts     ┐
//!   slices    ├─→  Scene  ─→  svg, png, pdf
//!   plane     ┤
//!   zones     ┤
//!   modes     ┤
//!   motion    ┤
//!   frames    ┘
//! ```
//!
//! | picture | function |
//! |---|---|
//! | parts as drawn or at a configuration | [`parts`] |
//! | slices of a contact space, the parts beside | [`slices`] |
//! | the plane of motions of a pair with fixed axes | [`plane`] |
//! | what is free, blocked, and between within tolerances | [`zones`] |
//! | the modes of three parts, in the planes of their pairs | [`modes`] |
//! | a mechanism in motion: parts, coordinates, contacts over time | [`motion`] |
//! | parts at several times, one frame for each | [`frames`] |
//!
//! ```
//! use cspace::{Axis, FixedAxesSpace, Part, Vector};
//! use cspace_draw::{PictureFormat, PictureOptions, plane};
//! let slide = Axis::prismatic(Vector::new(1.0, 0.0)).within(-10.0, 10.0);
//! let wall = Part::rectangle("wall", (0.0, 0.0), 2.0, 2.0)?;
//! let wheel = Part::rectangle("wheel", (5.0, 0.0), 2.0, 2.0)?;
//! let turn = Axis::revolute((5.0, 0.0).into());
//! let space = FixedAxesSpace::compute(&wall, slide, &wheel, turn)?;
//! let picture = plane(&space, &PictureOptions::default());
//! assert!(PictureFormat::Pdf.write(&picture)?.starts_with(b"%PDF"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod arc;
mod colour;
mod curves;
mod error;
mod feature_labels;
mod font;
mod format;
mod frames;
mod labels;
mod legend;
mod line;
mod modes;
mod motion;
mod options;
mod outline;
mod page;
mod parts;
mod pdf;
mod placed_part;
mod plane;
mod plot;
mod png;
mod scene;
mod slice;
mod strips;
mod svg;
mod ticks;
mod timeline;
mod view;
mod zones;

pub use curves::{Curve, CurveStrip, CurvesPicture, curves};
pub use error::PictureError;
pub use format::PictureFormat;
pub use frames::{FramesPicture, frames};
pub use modes::{ModeFields, ModePlane, ModeRow, ModesPicture, modes};
pub use motion::{MotionFrame, MotionPicture, PlanePath, motion};
pub use options::{Labels, PictureOptions};
pub use parts::{ContactMark, PartsPicture, UnusedPath, parts};
pub use pdf::pdf;
pub use placed_part::PlacedPart;
pub use plane::plane;
pub use png::png;
pub use scene::{Anchor, Area, Colour, Dot, Item, Path, Scene, Step, Stroke, Text};
pub use slice::{SlicesPicture, slices};
pub use svg::svg;
pub use timeline::{ContactBar, ContactRow, Track, TrackCurve};
pub use zones::{Nominal, ZonesPicture, zones};
