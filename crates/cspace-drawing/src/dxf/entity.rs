//! Entities of a DXF file, in the coordinates of the block they are in.

use std::sync::Arc;

use cspace::Point;

use super::error::{DxfError, Result};
use super::groups::{Group, Groups};
use super::hatch::hatch;
use super::item::{Block, Given, Item, What};
use super::names::Names;
use super::polyline::{light_polyline, polyline};
use super::record::Record;
use super::shapes::{arc, circle, ellipse, insert, line};
use super::spline::spline;
use crate::color::Color;

/// Reads entities one after the other.
pub(super) struct Reader<'r, 'a> {
    groups: &'r mut Groups<'a>,
    names: &'r mut Names<'a>,
    /// The group 0 that begins the next entity.
    next: Option<Group<'a>>,
    /// The groups of the present one.
    present: Vec<Group<'a>>,
}

impl<'r, 'a> Reader<'r, 'a> {
    pub(super) fn new(groups: &'r mut Groups<'a>, names: &'r mut Names<'a>) -> Self {
        Self {
            groups,
            names,
            next: None,
            present: Vec::new(),
        }
    }

    /// Reads the next entity's groups; its first is apart.
    fn advance(&mut self) -> Result<Group<'a>> {
        let first = match self.next.take() {
            Some(group) => group,
            None => self.group()?,
        };
        self.present.clear();
        loop {
            let group = self.group()?;
            if group.code == 0 {
                self.next = Some(group);
                return Ok(first);
            }
            // Nothing of what programs add for themselves is an outline.
            if group.code < 999 {
                self.present.push(group);
            }
        }
    }

    fn group(&mut self) -> Result<Group<'a>> {
        let line = self.groups.line();
        self.groups.next()?.ok_or_else(|| DxfError::cut_off(line))
    }

    /// The entities up to one of these ends, which is taken too.
    pub(super) fn items(&mut self, ends: &[&[u8]]) -> Result<Vec<Item>> {
        let mut items = Vec::new();
        loop {
            let peeked = match self.next {
                Some(group) => group,
                None => {
                    let group = self.group()?;
                    self.next = Some(group);
                    group
                }
            };
            if peeked.code == 0 && ends.contains(&peeked.text()) {
                // A section's end has no groups of its own, and what follows belongs to another.
                if peeked.text() == b"ENDSEC" {
                    self.next = None;
                } else {
                    self.advance()?;
                }
                return Ok(items);
            }
            if peeked.code == 0 && peeked.text() == b"EOF" {
                return Err(DxfError::cut_off(peeked.line));
            }
            let first = self.advance()?;
            if let Some(item) = self.item(first)? {
                items.push(item);
            }
        }
    }

    /// The next block; none at the end of the section.
    pub(super) fn block(&mut self) -> Result<Option<(Arc<str>, Block)>> {
        let first = match self.next.take() {
            Some(group) => group,
            None => self.group()?,
        };
        if first.begins(b"ENDSEC") {
            return Ok(None);
        }
        self.next = Some(first);
        let first = self.advance()?;
        if first.text() != b"BLOCK" {
            let message = "an entity outside of any block in the section of blocks";
            return Err(DxfError::new(
                first.line,
                message,
                "export the drawing again",
            ));
        }
        let Record { groups, .. } = &Record::new(&self.present);
        let mut name = self.names.get(b"");
        let (mut base, mut flags) = (Point::ORIGIN, 0);
        for group in *groups {
            match group.code {
                2 => name = self.names.get(group.text()),
                10 => base.x = group.real()?,
                20 => base.y = group.real()?,
                70 => flags = group.integer()?,
                _ => {}
            }
        }
        let items = self.items(&[b"ENDBLK"])?;
        let block = Block {
            name: Arc::clone(&name),
            base,
            is_external: flags & (4 | 8) != 0,
            items,
        };
        Ok(Some((name, block)))
    }

    fn item(&mut self, first: Group<'a>) -> Result<Option<Item>> {
        let kind = first.text();
        let record = Record::new(&self.present);
        let (layer, handle) = (record.text(8), record.text(5));
        let mut item = Item {
            kind: self.names.get(kind),
            layer: self.names.get(layer),
            handle: self.names.own(handle),
            line: if self.groups.has_lines() {
                first.line
            } else {
                0
            },
            on_paper: record.integer(67)?.unwrap_or(0) != 0,
            is_invisible: record.integer(60)?.unwrap_or(0) != 0,
            color: color(&record)?,
            linetype: linetype(record.text(6), self.names),
            unfollowed: None,
            what: What::Ignored("it is no outline"),
        };
        item.what = match kind {
            b"LINE" => line(&record)?,
            b"ARC" => arc(&record)?,
            b"CIRCLE" => circle(&record)?,
            b"LWPOLYLINE" => {
                item.unfollowed = has_width(record.groups)?.then_some(WIDTH);
                light_polyline(&record)?
            }
            b"ELLIPSE" => ellipse(&record)?,
            b"SPLINE" | b"HELIX" => spline(&record)?,
            b"HATCH" => hatch(&record)?,
            b"POLYLINE" => {
                let head: Vec<Group<'a>> = self.present.clone();
                let vertices = self.attached(b"VERTEX")?;
                for groups in [&head].into_iter().chain(&vertices) {
                    if has_width(groups)? {
                        item.unfollowed = Some(WIDTH);
                    }
                }
                polyline(&Record::new(&head), &vertices)?
            }
            b"INSERT" => {
                let insert = insert(&record, self.names)?;
                let has_attributes = record.integer(66)?.unwrap_or(0) != 0;
                if has_attributes {
                    self.attached(b"ATTRIB")?;
                }
                insert
            }
            // The end of what is attached to an entity that is read past.
            b"SEQEND" | b"VERTEX" => return Ok(None),
            _ => other(kind),
        };
        Ok(Some(item))
    }

    /// Entities attached to this one, which follow it up to SEQEND.
    fn attached(&mut self, kind: &[u8]) -> Result<Vec<Vec<Group<'a>>>> {
        let mut attached = Vec::new();
        while let Some(next) = self.next {
            if next.text() == b"SEQEND" {
                self.advance()?;
                break;
            }
            // Some programs leave the end out.
            if next.text() != kind {
                break;
            }
            self.advance()?;
            attached.push(self.present.clone());
        }
        Ok(attached)
    }
}

fn linetype<'a>(name: &'a [u8], names: &mut Names<'a>) -> Given<Arc<str>> {
    if name.is_empty() || name.eq_ignore_ascii_case(b"BYLAYER") {
        Given::ByLayer
    } else if name.eq_ignore_ascii_case(b"BYBLOCK") {
        Given::ByBlock
    } else {
        Given::Own(names.get(name))
    }
}

/// Property of a polyline that is not followed.
const WIDTH: &str = "its width is not followed: the middle of the line is the outline";

/// Whether a polyline or a vertex of it has a width.
fn has_width(groups: &[Group<'_>]) -> Result<bool> {
    for group in groups.iter().filter(|g| matches!(g.code, 40 | 41 | 43)) {
        if group.real()? > 0.0 {
            return Ok(true);
        }
    }
    Ok(false)
}

/// The colour of an entity or a layer: a true one, or else a number.
pub(super) fn color(record: &Record<'_, '_>) -> Result<Given<Color>> {
    if let Some(rgb) = record.integer(420)? {
        let [_, red, green, blue] = (rgb as u32).to_be_bytes();
        return Ok(Given::Own(Color::of_rgb([red, green, blue])));
    }
    Ok(match record.integer(62)? {
        Some(0) => Given::ByBlock,
        // A layer that is switched off has a negative one.
        Some(index) => match u8::try_from(index.unsigned_abs()) {
            Ok(index) => Given::Own(Color::of_index(index)),
            Err(_) => Given::ByLayer,
        },
        None => Given::ByLayer,
    })
}

/// Classifies an entity of any other type.
fn other(kind: &[u8]) -> What {
    What::Ignored(match kind {
        b"TEXT" | b"MTEXT" | b"ATTRIB" | b"ATTDEF" | b"RTEXT" | b"ARCALIGNEDTEXT" => "a text",
        b"DIMENSION"
        | b"ARC_DIMENSION"
        | b"LARGE_RADIAL_DIMENSION"
        | b"LEADER"
        | b"MLEADER"
        | b"MULTILEADER"
        | b"TOLERANCE" => "a dimension or leader",
        b"POINT" => "a point",
        b"MPOLYGON" => "a fill, which has no outline of its own",
        b"SOLID" | b"TRACE" => "a filled area, such as the head of an arrow",
        b"XLINE" | b"RAY" => "an endless construction line",
        b"VIEWPORT" | b"IMAGE" | b"WIPEOUT" | b"PDFUNDERLAY" | b"DWFUNDERLAY" | b"DGNUNDERLAY"
        | b"OLEFRAME" | b"OLE2FRAME" | b"ACAD_TABLE" | b"TABLE" | b"LIGHT" | b"SUN" | b"CAMERA"
        | b"SECTION" | b"GEOPOSITIONMARKER" => "no outline",
        b"REGION" | b"3DSOLID" | b"BODY" | b"SURFACE" | b"EXTRUDEDSURFACE" | b"REVOLVEDSURFACE"
        | b"PLANESURFACE" | b"LOFTEDSURFACE" | b"SWEPTSURFACE" => {
            return What::problem(
                None,
                "its outline is in a form that only the program that made it can read",
                "explode it to lines and arcs before it is exported, or leave its layer out",
            );
        }
        b"MLINE" | b"SHAPE" => {
            return What::problem(
                None,
                "its lines are defined elsewhere",
                "explode it to lines and arcs before it is exported, or leave its layer out",
            );
        }
        b"3DFACE" | b"MESH" => {
            return What::problem(
                None,
                "it is a surface in space",
                "draw the outline with lines and arcs, or leave its layer out",
            );
        }
        _ => {
            return What::problem(
                None,
                "entities of this type are not known",
                "explode it to lines and arcs before it is exported, or leave its layer out",
            );
        }
    })
}
