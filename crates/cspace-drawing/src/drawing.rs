//! Content of a drawing file, before the nesting of outlines is known.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use cspace::Point;
use cspace::part::tolerance::MAX_COORDINATE;
use cspace::part::{Bounds, Edge};

use crate::curve::Curve;
use crate::shown;
use crate::unit::Unit;

/// The entities of a drawing, flat: blocks are inserted, transforms done, lengths in the file's unit.
#[derive(Debug, Clone, Default)]
pub struct Drawing {
    /// Name of the drawing: its file's name without folder and extension.
    pub name: String,
    /// The unit of length that the file names.
    pub unit: Option<Unit>,
    /// The page, in the drawing's coordinates, where the file names one.
    pub page: Option<Bounds>,
    /// Whether the entities are polygons through measured points, to which lines and arcs are to be fitted.
    pub is_measured: bool,
    /// Entities that may be an outline, or a part of one.
    pub entities: Vec<Entity>,
    /// Entities that are no outline, and are left out.
    pub ignored: Vec<Ignored>,
    /// Properties of entities that are read which are not followed.
    pub unfollowed: Vec<Ignored>,
    /// Entities that would be drawn on layers that are left out; they are among the ignored ones, too.
    pub elsewhere: Vec<Elsewhere>,
    /// Entities that would be an outline but cannot be used.
    pub problems: Vec<Problem>,
}

/// A path, and where in the file it is.
#[derive(Debug, Clone)]
pub struct Entity {
    /// Origin of the entity in the file.
    pub origin: Origin,
    /// Path that it draws.
    pub path: Path,
}

/// Pieces end to end.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// Start of the first piece.
    pub start: Point,
    /// The pieces; each starts where the one before ends.
    pub pieces: Vec<Piece>,
    /// Whether the last piece ends where the first starts, according to the file.
    pub closed: bool,
}

/// A piece of a path.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// A line or an arc.
    Edge {
        /// End point.
        to: Point,
        /// tan(sweep / 4), positive counter-clockwise; 0 for a line.
        bulge: f64,
    },
    /// Curve to which lines and arcs are fitted.
    Curve(Box<Curve>),
}

impl Piece {
    /// End point of the piece.
    pub fn end(&self) -> Point {
        match self {
            Self::Edge { to, .. } => *to,
            Self::Curve(curve) => curve.end(),
        }
    }

    /// The box of the piece, which starts at a point.
    pub(crate) fn bounds(&self, from: Point) -> Bounds {
        match self {
            Self::Edge { to, bulge } => edge(from, *to, *bulge).bounds(),
            Self::Curve(curve) => curve.bounds(),
        }
    }
}

/// Line or arc with a bulge between two points; a line if both points are equal, where a bulge has no meaning.
pub(crate) fn edge(start: Point, end: Point, bulge: f64) -> Edge {
    Edge::between(start, end, if start == end { 0.0 } else { bulge })
}

impl Path {
    /// A path of no pieces yet.
    pub fn from(start: Point) -> Self {
        Self {
            start,
            pieces: Vec::new(),
            closed: false,
        }
    }

    /// End point of the last piece.
    pub fn end(&self) -> Point {
        self.pieces.last().map_or(self.start, Piece::end)
    }

    /// Bounding box of all pieces; if there are none, of the start.
    pub(crate) fn bounds(&self) -> Bounds {
        let mut from = self.start;
        let mut bounds = Bounds::of(from, from);
        for piece in &self.pieces {
            bounds = bounds.union(piece.bounds(from));
            from = piece.end();
        }
        bounds
    }

    /// Adds a line, or an arc of a bulge.
    pub fn edge_to(&mut self, to: Point, bulge: f64) {
        self.pieces.push(Piece::Edge { to, bulge });
    }

    /// Two half circles.
    pub fn circle(center: Point, radius: f64) -> Self {
        let [left, right] = [-radius, radius].map(|r| Point::new(center.x + r, center.y));
        let mut path = Self::from(left);
        path.edge_to(right, 1.0);
        path.edge_to(left, 1.0);
        path.closed = true;
        path
    }
}

/// Origin of an entity in the file.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Origin {
    /// Type in the file: `LINE`, `path`.
    pub kind: Arc<str>,
    /// The layer of a DXF file; empty elsewhere.
    pub layer: Arc<str>,
    /// The handle of a DXF entity or the id of an SVG element; empty where it has none.
    pub handle: Arc<str>,
    /// The blocks it is inserted with, or the named groups and elements of SVG that it is in, the outermost first.
    pub blocks: Arc<[Arc<str>]>,
    /// The line of the file, counted from 1; 0 where a file has none.
    pub line: usize,
}

/// Something left out because it is no outline, or a property that is not followed.
#[derive(Debug, Clone, PartialEq)]
pub struct Ignored {
    /// Origin of the entity.
    pub origin: Origin,
    /// Why it is left out, or what is not followed.
    pub reason: Cow<'static, str>,
}

/// A path on a layer that is left out.
#[derive(Debug, Clone)]
pub struct Elsewhere {
    /// The path, and where it comes from.
    pub entity: Entity,
    /// Why its layer is left out.
    pub reason: LayerReason,
}

/// Why a layer is left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LayerReason {
    /// Other layers were requested.
    NotAskedFor,
    /// The layer is for construction.
    Construction,
    /// The layer is switched off.
    Off,
    /// The layer is frozen.
    Frozen,
}

impl LayerReason {
    /// The reason, of something on the layer.
    pub(crate) fn of_it(self) -> &'static str {
        match self {
            Self::NotAskedFor => "its layer was not asked for",
            Self::Construction => "its layer is for construction",
            Self::Off => "its layer is switched off",
            Self::Frozen => "its layer is frozen",
        }
    }

    /// Reason as a relative clause, after the name of the thing.
    pub(crate) fn of_which(self) -> &'static str {
        match self {
            Self::NotAskedFor => "whose layer was not asked for",
            Self::Construction => "whose layer is for construction",
            Self::Off => "whose layer is switched off",
            Self::Frozen => "whose layer is frozen",
        }
    }

    /// Advice on how to read the layer beside another.
    pub(crate) fn way(self, own: &str, layer: &str) -> String {
        let [own, layer] = [own, layer].map(shown::start);
        match self {
            Self::NotAskedFor => {
                format!("add --layer {layer} (in a model: layer = [{own}, {layer}])")
            }
            Self::Construction => format!(
                "read both layers with --layer {own} --layer {layer} (in a model: layer = [{own}, {layer}])"
            ),
            Self::Off => format!("switch layer {layer} on in the drawing"),
            Self::Frozen => format!("thaw layer {layer} in the drawing"),
        }
    }
}

/// Something that cannot be used.
#[derive(Debug, Clone, PartialEq)]
pub struct Problem {
    /// Origin of the entity.
    pub origin: Origin,
    /// The other entities that it concerns.
    pub with: Vec<Origin>,
    /// Position, in the drawing's coordinates.
    pub at: Option<Point>,
    /// Position of the other end, if there are two.
    pub to: Option<Point>,
    /// Description of the problem.
    pub reason: String,
    /// Advice on how to solve it.
    pub help: String,
}

impl Drawing {
    /// Adds a path, or the problem that its coordinates are beyond those of a part: fitting it would take for ever.
    pub(crate) fn add(&mut self, origin: Origin, path: Path) {
        let bounds = path.bounds();
        let far = [bounds.min, bounds.max].into_iter().find(|p| {
            // Not a number is beyond, too.
            !(p.x.abs() <= MAX_COORDINATE && p.y.abs() <= MAX_COORDINATE)
        });
        match far {
            None => self.entities.push(Entity { origin, path }),
            Some(far) => self.problems.push(Problem {
                origin,
                with: Vec::new(),
                at: Some(far),
                to: None,
                reason: format!("a coordinate is beyond {MAX_COORDINATE:e}"),
                help: "check the coordinates, and the unit of length".to_owned(),
            }),
        }
    }

    /// Number of entities of each type.
    pub fn counts(&self) -> BTreeMap<String, usize> {
        let mut counts = BTreeMap::new();
        for entity in &self.entities {
            *counts.entry(entity.origin.kind.to_string()).or_default() += 1;
        }
        counts
    }
}
