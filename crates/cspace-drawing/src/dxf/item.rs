//! Items of a DXF file: entities, and blocks of them.

use std::sync::Arc;

use cspace::{Point, Vector};

use crate::affine::Affine;
use crate::color::Color;
use crate::drawing::Path;

/// An entity of a file.
#[derive(Clone)]
pub(super) struct Item {
    pub(super) kind: Arc<str>,
    pub(super) layer: Arc<str>,
    pub(super) handle: Arc<str>,
    pub(super) line: usize,
    /// Whether it is in paper space, and not in the drawing itself.
    pub(super) on_paper: bool,
    pub(super) is_invisible: bool,
    pub(super) color: Given<Color>,
    pub(super) linetype: Given<Arc<str>>,
    /// Property of the entity that is not followed.
    pub(super) unfollowed: Option<&'static str>,
    pub(super) what: What,
}

/// Where a property of an entity is given.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Given<T> {
    /// By the layer.
    ByLayer,
    /// By what the block is inserted with.
    ByBlock,
    /// By the entity itself.
    Own(T),
}

impl<T: Clone> Given<T> {
    /// The property, given that of the layer and of the block.
    pub(super) fn of(&self, layer: impl FnOnce() -> Option<T>, block: &Option<T>) -> Option<T> {
        match self {
            Self::ByLayer => layer(),
            Self::ByBlock => block.clone(),
            Self::Own(own) => Some(own.clone()),
        }
    }
}

/// Kind of an entity, with its data.
#[derive(Clone)]
pub(super) enum What {
    Path(Path),
    Insert(Box<Insert>),
    /// The outlines of a fill.
    Hatch(Vec<Path>),
    /// Entity that is no outline, with the reason.
    Ignored(&'static str),
    /// An outline that cannot be used.
    Problem(Box<Fault>),
}

/// Why an entity cannot be used.
#[derive(Clone)]
pub(super) struct Fault {
    pub(super) at: Option<Point>,
    pub(super) reason: String,
    pub(super) help: &'static str,
}

impl What {
    pub(super) fn problem(
        at: Option<Point>,
        reason: impl Into<String>,
        help: &'static str,
    ) -> Self {
        Self::Problem(Box::new(Fault {
            at,
            reason: reason.into(),
            help,
        }))
    }
}

/// A block that is inserted, once or in rows and columns.
#[derive(Clone)]
pub(super) struct Insert {
    pub(super) block: Arc<str>,
    /// Map from the block's coordinates, with its base point at the origin, to those of the insert.
    pub(super) map: Affine,
    /// The steps from column to column and from row to row.
    pub(super) steps: [Vector; 2],
    pub(super) counts: [u32; 2],
}

/// Entities that are inserted together.
pub(super) struct Block {
    pub(super) name: Arc<str>,
    /// The point of the block that comes to the point of insertion.
    pub(super) base: Point,
    /// Whether the entities are in another file.
    pub(super) is_external: bool,
    pub(super) items: Vec<Item>,
}
