//! Outlines of planar parts from drawings: DXF, SVG and measured points.
//!
//! ```text
//! file ──dxf, svg, points──> Drawing ──join──> chains ──fit──> loops ──nest──> parts
//! ```
//!
//! [`read`] makes a flat [`Drawing`] of a file: paths of lines, arcs and curves, each with its layer, handle and line in the
//! file. [`Drawing::outlines`] makes parts of it: it joins loose pieces to loops, fits tangent lines and arcs to curves, and
//! finds which loops are holes. Nothing is left out silently: [`Outlines`] lists what was.
//!
//! ```
//! use cspace_drawing::{Settings, Source, read};
//! # let folder = tempfile::tempdir()?;
//! # let path = folder.path().join("washer.dxf");
//! std::fs::write(&path, "0\nSECTION\n2\nENTITIES\n\
//!     0\nCIRCLE\n8\nwasher\n10\n0\n20\n0\n40\n5\n\
//!     0\nCIRCLE\n8\nwasher\n10\n0\n20\n0\n40\n2\n0\nENDSEC\n0\nEOF\n")?;
//! let outlines = read(&path, &Source::default())?.outlines(&Settings::default())?;
//! assert_eq!(outlines.parts[0].name(), "washer");
//! assert!((outlines.parts[0].area() - 21.0 * std::f64::consts::PI).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod affine;
mod arrange;
#[cfg(feature = "kurbo")]
mod bez_path;
mod color;
mod corner;
mod curve;
mod drawing;
mod dxf;
mod error;
mod fit;
mod join;
mod nest;
mod offset;
mod outlines;
mod path_map;
mod placement;
mod points;
mod profile;
mod read;
mod shown;
mod source;
mod svg;
mod union;
mod unit;
mod write;

pub use affine::Affine;
pub use color::Color;
pub use curve::{Curve, EllipseArc, Spline, SplineError, interpolate};
pub use drawing::{Drawing, Elsewhere, Entity, Ignored, LayerReason, Origin, Path, Piece, Problem};
pub use error::DrawingError;
pub use offset::{Offset, OffsetError, offset};
pub use outlines::{
    Apart, DEFAULT_FIT, DEFAULT_JOIN, DrawnFace, DrawnFaces, FitSide, FittedReport, Outlines, Pick,
    Reading, SHEET, Settings, Survey, Traced,
};
pub use placement::{Mirror, Placement};
pub use profile::{ProfileError, profile};
pub use read::{Format, bytes_of, from_bytes, is_drawing, named, read};
pub use source::Source;
pub use union::{Touch, Union, UnionError, UnitedEdge, union};
pub use unit::{Conversion, Unit};
pub use write::{Drawn, DxfVersion, dxf, svg};
