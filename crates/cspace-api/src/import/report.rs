//! The report of an import: the parts made, and the entities used, left out, joined and fitted.

use std::collections::BTreeMap;

use cspace::Part;
use cspace_drawing::{Ignored, Origin, Outlines};
use cspace_model::Mechanism;
use schemars::JsonSchema;
use serde::Serialize;

use crate::frame::Content;
use crate::outcome::Done;

/// The model that was made of drawings.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Imported {
    /// The parts, in the order of the drawings and of their outermost loops in them.
    pub parts: Vec<PartReport>,
    /// Layers of which several outlines are apart from each other, and a part each; what is in a block is not counted.
    pub apart: Vec<Apart>,
    /// How many entities the parts are made of, by type.
    pub used: BTreeMap<String, usize>,
    /// Entities that were left out.
    pub ignored: Vec<Entity>,
    /// Properties that are not followed of entities that are read, such as the width of a line.
    pub unfollowed: Vec<Entity>,
    /// Rectangles around everything that may be sheets, with parts in what would be their holes.
    pub sheets: Vec<Entity>,
    /// The gaps that were closed, wider than rounding.
    pub joined: Vec<Gap>,
    /// How well lines and arcs were fitted to curves and points.
    pub fitted: Fitted,
    /// Pieces that are drawn and add nothing.
    pub removed: Removed,
    /// The unit of length of the model; left out where none is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The model.
    #[serde(skip)]
    pub mechanism: Mechanism,
    /// The outlines of each drawing.
    #[serde(skip)]
    pub outlines: Vec<Outlines>,
}

impl Content for Imported {
    const COMMAND: &'static str = "import";
    type Outcome = Done;
}

/// A part that was made.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PartReport {
    /// The part's name in the model.
    pub name: String,
    /// The number of closed loops.
    pub loops: usize,
    /// The number of lines.
    pub lines: usize,
    /// The number of arcs.
    pub arcs: usize,
    /// The area of the material.
    pub area: f64,
    /// The length of all loops.
    pub perimeter: f64,
    /// The box of the outline: x0, y0, x1, y1.
    pub bounds: [f64; 4],
}

/// Outlines on one layer that are apart from each other.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Apart {
    /// The layer; empty where a format has none.
    pub layer: String,
    /// Names of the parts, before an offset.
    pub parts: Vec<String>,
}

/// Something of a drawing.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Entity {
    /// Its type, as the file calls it.
    pub r#type: String,
    /// Its layer; empty where there is none.
    pub layer: String,
    /// The handle of a DXF entity, the id of an SVG element; empty where it has none.
    pub handle: String,
    /// Why it was left out, what is not followed of it, or what to do.
    pub reason: String,
}

/// A gap that was closed.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Gap {
    /// How far the ends were apart.
    pub gap: f64,
    /// Where they are now.
    pub at: [f64; 2],
}

/// How well lines and arcs were fitted.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Fitted {
    /// The number of entities they were fitted to.
    pub curves: usize,
    /// The number of lines and arcs.
    pub pieces: usize,
    /// How far these are from the curves or points, at most.
    pub deviation: f64,
    /// The largest angle between neighbours that should be tangent, radians: rounding.
    pub kink: f64,
}

/// Pieces that are drawn and add nothing.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Removed {
    /// Pieces drawn twice, or within others.
    pub duplicates: usize,
    /// Pieces that overlapped others on one line or circle, and were made one with them.
    pub overlaps: usize,
    /// Pieces without length.
    pub tiny: usize,
}

impl Imported {
    /// The report on a model that was made of drawings.
    pub(super) fn of(mechanism: Mechanism, outlines: Vec<Outlines>, without_sheet: &str) -> Self {
        let sum = |of: fn(&Outlines) -> usize| outlines.iter().map(of).sum();
        let most = |of: fn(&Outlines) -> f64| outlines.iter().map(of).fold(0.0, f64::max);
        let mut used = BTreeMap::new();
        for (kind, n) in outlines.iter().flat_map(|o| &o.used) {
            *used.entry(kind.clone()).or_default() += n;
        }
        let sheet = |sheet: &Origin| {
            let what = format!("if it is the sheet, leave it out with {without_sheet}");
            Entity::new(sheet, &what)
        };
        let gap = |&(gap, at): &(f64, cspace::Point)| Gap {
            gap,
            at: [at.x, at.y],
        };
        Self {
            parts: mechanism.parts.iter().map(|p| part(&p.part)).collect(),
            apart: (outlines.iter().flat_map(|o| &o.apart))
                .map(|a| Apart {
                    layer: a.layer.to_string(),
                    parts: a.parts.clone(),
                })
                .collect(),
            used,
            ignored: entities(outlines.iter().flat_map(|o| &o.ignored)),
            unfollowed: entities(outlines.iter().flat_map(|o| &o.unfollowed)),
            sheets: (outlines.iter().filter_map(|o| o.sheet.as_ref()))
                .map(sheet)
                .collect(),
            joined: (outlines.iter().flat_map(|o| &o.joined)).map(gap).collect(),
            fitted: Fitted {
                curves: sum(|o| o.fitted.curves),
                pieces: sum(|o| o.fitted.pieces),
                deviation: most(|o| o.fitted.deviation),
                kink: most(|o| o.fitted.kink),
            },
            removed: Removed {
                duplicates: sum(|o| o.duplicates),
                overlaps: sum(|o| o.merged),
                tiny: sum(|o| o.tiny),
            },
            unit: mechanism.unit.clone(),
            mechanism,
            outlines,
        }
    }
}

impl Entity {
    fn new(origin: &Origin, reason: &str) -> Self {
        Self {
            r#type: origin.kind.to_string(),
            layer: origin.layer.to_string(),
            handle: origin.handle.to_string(),
            reason: reason.to_owned(),
        }
    }
}

fn entities<'a>(ignored: impl Iterator<Item = &'a Ignored>) -> Vec<Entity> {
    ignored.map(|i| Entity::new(&i.origin, &i.reason)).collect()
}

fn part(part: &Part) -> PartReport {
    let bounds = part.bounds();
    let lines = part.edges().filter(|e| e.is_line()).count();
    let edges = part.edges().count();
    let perimeter = part
        .edges()
        .map(|e| match e.is_line() {
            true => e.start.distance(e.end),
            false => (e.radius() * e.sweep()).abs(),
        })
        .sum();
    PartReport {
        name: part.name().to_owned(),
        loops: part.loops().len(),
        lines,
        arcs: edges - lines,
        area: part.area(),
        perimeter,
        bounds: [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y],
    }
}
