//! The flat drawing of a DXF file: its blocks inserted, its hidden layers left out.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::Arc;

use super::error::{DxfError, Result};
use super::file::File;
use super::item::{Block, Insert, Item, What};
use super::names::folded;
use super::tables::Hidden;
use crate::affine::Affine;
use crate::color::Color;
use crate::drawing::{Drawing, Elsewhere, Entity, Ignored, LayerReason, Origin, Problem};
use crate::shown;
use crate::source::{OFFERED, OTHER_COLOR, Source};

/// The most entities that inserting blocks may make, those left out included: ten times what a large drawing has.
const MOST_ENTITIES: usize = 2_000_000;

/// The deepest that blocks may be inserted in one another.
const DEEPEST: usize = 64;

pub(super) fn flatten(mut file: File, source: &Source) -> Result<Drawing> {
    let items = core::mem::take(&mut file.items);
    let mut flat = Flat {
        file: &file,
        layers: source.layers.iter().map(|l| folded(l)).collect(),
        linetypes: source.linetypes.iter().map(|l| folded(l)).collect(),
        colors: &source.colors,
        hatches: source.hatches,
        drawing: Drawing {
            unit: file.unit,
            ..Drawing::default()
        },
        open: Vec::new(),
        count: 0,
    };
    let ground = Ground {
        map: Affine::IDENTITY,
        layer: None,
        blocks: Arc::from([]),
        hidden: None,
        color: None,
        linetype: None,
    };
    for item in items {
        // Entities outside of blocks are drawn once, and need not be kept.
        flat.add(Cow::Owned(item), &ground)?;
    }
    let Flat { drawing, .. } = flat;
    check_layers(&source.layers, &file, &drawing)?;
    Ok(drawing)
}

/// Refuses layers that are asked for and not there: they are misspelt.
fn check_layers(asked: &[String], file: &File, drawing: &Drawing) -> Result<()> {
    /// Names that are listed, at most.
    const MOST_NAMES: usize = 12;
    if asked.is_empty() {
        return Ok(());
    }
    let drawn = (drawing.entities.iter().map(|e| &e.origin))
        .chain(drawing.ignored.iter().map(|i| &i.origin))
        .chain(drawing.problems.iter().map(|p| &p.origin));
    let mut names: BTreeMap<String, &str> = (file.layers.names())
        .map(|name| (folded(name), name))
        .collect();
    names.extend(drawn.map(|origin| (folded(&origin.layer), &*origin.layer)));
    let Some(absent) = asked.iter().find(|name| !names.contains_key(&folded(name))) else {
        return Ok(());
    };
    let shown: Vec<String> = names
        .values()
        .take(MOST_NAMES)
        .map(|n| shown::start(n))
        .collect();
    let more = match names.len().saturating_sub(MOST_NAMES) {
        0 => String::new(),
        n => format!(" and {n} more"),
    };
    let message = format!("there is no layer {}", shown::start(absent));
    let help = format!("the drawing's layers are {}{more}", shown.join(", "));
    Err(DxfError::new(DxfError::WHOLE, message, help))
}

/// Drawing context of a block's entities.
struct Ground {
    map: Affine,
    /// Layer for entities on layer 0 of the block.
    layer: Option<Arc<str>>,
    blocks: Arc<[Arc<str>]>,
    /// Reason why entities on layer 0 of the block are not drawn; if frozen, nothing of the block is.
    hidden: Option<Hidden>,
    /// Properties of the insert.
    color: Option<Color>,
    linetype: Option<Arc<str>>,
}

/// Beginnings of the folded names of line types that are no outlines: centre lines, hidden edges and ends of motions.
const NO_OUTLINE: [&str; 11] = [
    "center",
    "hidden",
    "phantom",
    "dashdot",
    "mitte",
    "verdeckt",
    "acad_iso02",
    "acad_iso04",
    "acad_iso05",
    "acad_iso08",
    "acad_iso10",
];

struct Flat<'f> {
    file: &'f File,
    /// Folded names of the requested layers; all if empty.
    layers: Vec<String>,
    /// Folded names of the requested line types; if empty, all of outlines.
    linetypes: Vec<String>,
    /// The requested colours; all if empty.
    colors: &'f [Color],
    /// Whether the outlines of hatches are read.
    hatches: bool,
    drawing: Drawing,
    /// The blocks that are being inserted.
    open: Vec<*const Block>,
    count: usize,
}

impl Flat<'_> {
    fn add_all(&mut self, items: &[Item], ground: &Ground) -> Result<()> {
        for item in items {
            self.add(Cow::Borrowed(item), ground)?;
        }
        Ok(())
    }

    fn add(&mut self, item: Cow<'_, Item>, ground: &Ground) -> Result<()> {
        self.count(item.line)?;
        let layer = match &ground.layer {
            Some(layer) if &*item.layer == "0" => layer,
            _ => &item.layer,
        };
        let origin = Origin {
            kind: Arc::clone(&item.kind),
            layer: Arc::clone(layer),
            handle: Arc::clone(&item.handle),
            blocks: Arc::clone(&ground.blocks),
            line: item.line,
        };
        let is_insert = matches!(item.what, What::Insert(_));
        let inherits = ground.hidden == Some(Hidden::Frozen) || &*item.layer == "0";
        let hidden = (self.file.layers.hidden(layer)).or(ground.hidden.filter(|_| inherits));
        let left_out = if item.on_paper {
            Some("it is on a sheet of paper, not in the drawing itself")
        } else if item.is_invisible {
            Some("it is invisible")
        } else {
            None
        };
        if let Some(reason) = left_out {
            self.ignore(origin, reason);
            return Ok(());
        }
        // Even if an insert is on a hidden layer, entities of its block on other layers may be drawn.
        if !is_insert && let Some(reason) = self.reason(hidden, layer) {
            if let What::Path(path) = &item.what {
                self.drawing.elsewhere.push(Elsewhere {
                    entity: Entity {
                        origin: origin.clone(),
                        path: path.mapped(&ground.map),
                    },
                    reason,
                });
            }
            self.ignore(origin, reason.of_it());
            return Ok(());
        }
        let color = (item.color).of(|| self.file.layers.color(layer), &ground.color);
        let linetype = (item.linetype).of(|| self.file.layers.linetype(layer), &ground.linetype);
        if matches!(item.what, What::Path(_) | What::Hatch(_)) {
            if let Some(reason) = self.unlike(color, linetype.as_deref()) {
                self.drawing.ignored.push(Ignored { origin, reason });
                return Ok(());
            }
            if let Some(what) = item.unfollowed {
                self.drawing.unfollowed.push(Ignored {
                    origin: origin.clone(),
                    reason: what.into(),
                });
            }
        }
        if let Cow::Owned(Item {
            what: What::Path(path),
            ..
        }) = item
        {
            self.draw(origin, path);
            return Ok(());
        }
        match &item.what {
            What::Path(path) => self.draw(origin, path.mapped(&ground.map)),
            What::Hatch(_) if !self.hatches => self.ignore(origin, OFFERED),
            What::Hatch(paths) => {
                for path in paths {
                    self.draw(origin.clone(), path.mapped(&ground.map));
                }
            }
            What::Ignored(reason) => self.ignore(origin, reason),
            What::Insert(insert) => {
                let hidden = match (hidden, ground.hidden) {
                    (Some(Hidden::Frozen), _) | (_, Some(Hidden::Frozen)) => Some(Hidden::Frozen),
                    (hidden, _) => hidden,
                };
                let given = Ground {
                    map: ground.map,
                    layer: None,
                    blocks: Arc::clone(&ground.blocks),
                    hidden,
                    color,
                    linetype,
                };
                return self.insert(insert, origin, given);
            }
            What::Problem(fault) => self.drawing.problems.push(Problem {
                origin,
                with: Vec::new(),
                at: fault.at.map(|p| ground.map.point(p)),
                to: None,
                reason: fault.reason.clone(),
                help: fault.help.to_owned(),
            }),
        }
        Ok(())
    }

    /// Why something of a colour and a line type is left out; none if it is read.
    fn unlike(&self, color: Option<Color>, linetype: Option<&str>) -> Option<Cow<'static, str>> {
        let asked_for = |asked: &Color| color.is_some_and(|own| asked.is(own));
        if !self.colors.is_empty() && !self.colors.iter().any(asked_for) {
            return Some(OTHER_COLOR.into());
        }
        let shown = linetype.unwrap_or("CONTINUOUS");
        let folded = folded(shown);
        if !self.linetypes.is_empty() {
            let is_asked_for = self.linetypes.contains(&folded);
            return (!is_asked_for).then(|| "its line type was not asked for".into());
        }
        let is_no_outline = NO_OUTLINE.iter().any(|name| folded.starts_with(name));
        is_no_outline.then(|| {
            let name = shown::start(shown);
            format!("its line type is {name}, which is no outline's; --linetype {name} reads it")
                .into()
        })
    }

    /// Bounds time and memory whatever blocks insert.
    fn count(&mut self, line: usize) -> Result<()> {
        self.count += 1;
        if self.count > MOST_ENTITIES {
            return Err(DxfError::new(
                line,
                format!(
                    "with its blocks inserted the drawing has more than {MOST_ENTITIES} entities"
                ),
                "remove what is no outline, or split the drawing",
            ));
        }
        Ok(())
    }

    /// Why a layer is left out; none of one that is read.
    fn reason(&self, hidden: Option<Hidden>, layer: &str) -> Option<LayerReason> {
        match hidden {
            Some(Hidden::Frozen) => Some(LayerReason::Frozen),
            Some(Hidden::Off) => Some(LayerReason::Off),
            None if self.is_asked_for(layer) => None,
            None if self.layers.is_empty() => Some(LayerReason::Construction),
            None => Some(LayerReason::NotAskedFor),
        }
    }

    fn is_asked_for(&self, layer: &str) -> bool {
        let layer = folded(layer);
        if self.layers.is_empty() {
            // By custom what is there is never plotted.
            return layer != "defpoints";
        }
        self.layers.contains(&layer)
    }

    fn draw(&mut self, origin: Origin, path: crate::drawing::Path) {
        self.drawing.add(origin, path);
    }

    fn ignore(&mut self, origin: Origin, reason: &'static str) {
        self.drawing.ignored.push(Ignored {
            origin,
            reason: reason.into(),
        });
    }

    fn insert(&mut self, insert: &Insert, origin: Origin, ground: Ground) -> Result<()> {
        let at = Some(ground.map.point(insert.map.origin));
        let mut refuse = |reason: String, help: &str| {
            self.drawing.problems.push(Problem {
                origin: origin.clone(),
                with: Vec::new(),
                at,
                to: None,
                reason,
                help: help.to_owned(),
            });
            Ok(())
        };
        let name = &insert.block;
        let Some(block) = self.file.blocks.get(&folded(name)) else {
            return refuse(
                format!("there is no block {}", shown::start(name)),
                "export the drawing with its blocks",
            );
        };
        if block.is_external && block.items.is_empty() {
            return refuse(
                format!("the block {} is in another file", shown::start(name)),
                "bind the external reference before the drawing is exported",
            );
        }
        if self.open.contains(&core::ptr::from_ref(block)) {
            return refuse(
                format!("the block {} is inserted in itself", shown::start(name)),
                "remove the insert from the block",
            );
        }
        if self.open.len() >= DEEPEST {
            return refuse(
                format!("blocks are inserted in one another more than {DEEPEST} deep"),
                "explode some of them before the drawing is exported",
            );
        }
        let mut blocks = ground.blocks.to_vec();
        blocks.push(Arc::clone(&block.name));
        let blocks: Arc<[Arc<str>]> = blocks.into();
        let base = Affine {
            origin: cspace::Point::ORIGIN - block.base.to_vector(),
            ..Affine::IDENTITY
        };
        self.open.push(core::ptr::from_ref(block));
        for row in 0..insert.counts[1] {
            for column in 0..insert.counts[0] {
                self.count(origin.line)?;
                let step = insert.steps[0] * f64::from(column) + insert.steps[1] * f64::from(row);
                let mut map = insert.map;
                map.origin += step;
                let inner = Ground {
                    map: ground.map.after(&map).after(&base),
                    layer: Some(Arc::clone(&origin.layer)),
                    blocks: Arc::clone(&blocks),
                    hidden: ground.hidden,
                    color: ground.color,
                    linetype: ground.linetype.clone(),
                };
                self.add_all(&block.items, &inner)?;
            }
        }
        self.open.pop();
        Ok(())
    }
}
