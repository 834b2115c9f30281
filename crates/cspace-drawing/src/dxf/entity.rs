//! Entities of a DXF file, in the coordinates of the block they are in.

use core::f64::consts::TAU;
use std::sync::Arc;

use cspace::{Point, Vector};

use super::error::{DxfError, Result};
use super::file::Block;
use super::groups::{Group, Groups};
use super::names::Names;
use super::polyline::{light_polyline, polyline};
use super::spline::spline;
use crate::affine::Affine;
use crate::curve::{Curve, EllipseArc};
use crate::drawing::{Path, Piece};

/// An entity of a file.
#[derive(Clone)]
pub(super) struct Item {
    pub(super) kind: Arc<str>,
    pub(super) layer: Arc<str>,
    pub(super) handle: Arc<str>,
    pub(super) line: usize,
    /// Whether it is on a sheet of paper, not in the drawing itself.
    pub(super) on_paper: bool,
    pub(super) is_invisible: bool,
    pub(super) what: What,
}

/// What an entity is.
#[derive(Clone)]
pub(super) enum What {
    Path(Path),
    Insert(Box<Insert>),
    /// No outline, and why.
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
    /// From the block's coordinates, its base point at the origin, to those the insert is in.
    pub(super) map: Affine,
    /// The steps from column to column and from row to row.
    pub(super) steps: [Vector; 2],
    pub(super) counts: [u32; 2],
}

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
            line: first.line,
            on_paper: record.integer(67)?.unwrap_or(0) != 0,
            is_invisible: record.integer(60)?.unwrap_or(0) != 0,
            what: What::Ignored("it is no outline"),
        };
        item.what = match kind {
            b"LINE" => line(&record)?,
            b"ARC" => arc(&record)?,
            b"CIRCLE" => circle(&record)?,
            b"LWPOLYLINE" => light_polyline(&record)?,
            b"ELLIPSE" => ellipse(&record)?,
            b"SPLINE" | b"HELIX" => spline(&record)?,
            b"POLYLINE" => {
                let head: Vec<Group<'a>> = self.present.clone();
                let vertices = self.attached(b"VERTEX")?;
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

    /// What follows an entity and belongs to it, up to SEQEND.
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

/// The groups of an entity.
pub(super) struct Record<'g, 'a> {
    pub(super) groups: &'g [Group<'a>],
}

impl<'g, 'a> Record<'g, 'a> {
    pub(super) fn new(groups: &'g [Group<'a>]) -> Self {
        Self { groups }
    }

    fn find(&self, code: i32) -> Option<&'g Group<'a>> {
        self.groups.iter().find(|g| g.code == code)
    }

    fn text(&self, code: i32) -> &'a [u8] {
        self.find(code).map_or(b"", Group::text)
    }

    pub(super) fn real(&self, code: i32) -> Result<Option<f64>> {
        self.find(code).map(Group::real).transpose()
    }

    pub(super) fn integer(&self, code: i32) -> Result<Option<i64>> {
        self.find(code).map(Group::integer).transpose()
    }

    /// The point of groups `code` and `code` + 10; the third coordinate apart.
    pub(super) fn point(&self, code: i32) -> Result<(Point, f64)> {
        let [x, y, z] = [0, 10, 20].map(|c| self.real(code + c));
        Ok((
            Point::new(x?.unwrap_or(0.0), y?.unwrap_or(0.0)),
            z?.unwrap_or(0.0),
        ))
    }

    /// Whether the entity's plane is looked at from behind; none if it is no plane parallel to the drawing's.
    pub(super) fn is_from_behind(&self) -> Result<Option<bool>> {
        if self.find(210).is_none() && self.find(230).is_none() {
            return Ok(Some(false));
        }
        /// Rounding of a unit vector in a file.
        const ROUND: f64 = 1e-9;
        let (side, z) = self.point(210)?;
        let is_upright = side.to_vector().length() <= ROUND * z.abs();
        Ok((is_upright && z != 0.0).then_some(z < 0.0))
    }
}

/// That a plane is no plane of the drawing.
pub(super) fn tilted(at: Point) -> What {
    What::problem(
        Some(at),
        "it is not in the plane of the drawing: its extrusion direction is tilted",
        "flatten the drawing to two dimensions before it is exported",
    )
}

/// That something is not flat.
pub(super) fn not_flat(at: Point) -> What {
    What::problem(
        Some(at),
        "it is not flat: its z coordinates differ",
        "flatten the drawing to two dimensions before it is exported",
    )
}

/// Whether heights differ by more than rounding.
pub(super) fn heights_differ(heights: impl IntoIterator<Item = f64>) -> bool {
    /// Rounding of coordinates in files, as a share of the height.
    const ROUND: f64 = 1e-6;
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for z in heights {
        range = [range[0].min(z), range[1].max(z)];
    }
    range[1] - range[0] > ROUND * range[1].abs().max(range[0].abs()).max(1e-3)
}

/// The path in the coordinates around the entity's plane, whose first axis points left if it is seen from behind.
pub(super) fn faced(path: Path, from_behind: bool) -> What {
    What::Path(if from_behind {
        path.mapped(&Affine::MIRROR_X)
    } else {
        path
    })
}

fn line(record: &Record<'_, '_>) -> Result<What> {
    let ((from, z0), (to, z1)) = (record.point(10)?, record.point(11)?);
    if heights_differ([z0, z1]) {
        return Ok(not_flat(from));
    }
    let mut path = Path::from(from);
    path.edge_to(to, 0.0);
    Ok(What::Path(path))
}

fn radius(record: &Record<'_, '_>, at: Point) -> Result<core::result::Result<f64, What>> {
    let radius = record.real(40)?.unwrap_or(0.0);
    Ok(if radius > 0.0 {
        Ok(radius)
    } else {
        Err(What::problem(
            Some(at),
            format!("its radius is {radius:?}"),
            "remove it, or give it a radius",
        ))
    })
}

fn circle(record: &Record<'_, '_>) -> Result<What> {
    let center = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    Ok(match radius(record, center)? {
        Ok(radius) => faced(Path::circle(center, radius), behind),
        Err(problem) => problem,
    })
}

fn arc(record: &Record<'_, '_>) -> Result<What> {
    let center = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    let radius = match radius(record, center)? {
        Ok(radius) => radius,
        Err(problem) => return Ok(problem),
    };
    let [from, to] = [50, 51].map(|c| record.real(c));
    let (from, to) = (from?.unwrap_or(0.0), to?.unwrap_or(360.0));
    let sweep = (to - from).rem_euclid(360.0);
    if sweep == 0.0 {
        return Ok(faced(Path::circle(center, radius), behind));
    }
    let mut path = Path::from(center + direction(from) * radius);
    path.edge_to(
        center + direction(to) * radius,
        (sweep.to_radians() / 4.0).tan(),
    );
    Ok(faced(path, behind))
}

/// The direction of an angle in degrees; that of a right angle to the last bit.
pub(super) fn direction(degrees: f64) -> Vector {
    let turned = degrees.rem_euclid(360.0);
    let quarter = (turned / 90.0).round();
    let (sin, cos) = (turned - 90.0 * quarter).to_radians().sin_cos();
    match quarter as u8 % 4 {
        0 => Vector::new(cos, sin),
        1 => Vector::new(-sin, cos),
        2 => Vector::new(-cos, -sin),
        _ => Vector::new(sin, -cos),
    }
}

fn ellipse(record: &Record<'_, '_>) -> Result<What> {
    let (center, _) = record.point(10)?;
    let (major, z) = record.point(11)?;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(center));
    };
    if heights_differ([0.0, z]) {
        return Ok(not_flat(center));
    }
    let u = major.to_vector();
    let ratio = record.real(40)?.unwrap_or(1.0);
    let v = if behind { u.right() } else { u.left() } * ratio;
    if u.cross(v) == 0.0 {
        return Ok(What::problem(
            Some(center),
            "an axis of it has no length",
            "remove it, or draw it as a line",
        ));
    }
    let [from, to] = [41, 42].map(|c| record.real(c));
    let (from, to) = (from?.unwrap_or(0.0), to?.unwrap_or(TAU));
    Ok(What::Path(ellipse_path(&EllipseArc {
        center,
        u,
        v,
        from,
        to: from + sweep(to - from),
    })))
}

/// The sweep, more than none and at most a turn. Angles in files have some digits.
fn sweep(angle: f64) -> f64 {
    const ROUND: f64 = 1e-9;
    let sweep = angle.rem_euclid(TAU);
    if sweep < ROUND || TAU - sweep < ROUND {
        TAU
    } else {
        sweep
    }
}

/// An arc of an ellipse as a path; circles as the arcs they are.
pub(crate) fn ellipse_path(arc: &EllipseArc) -> Path {
    let curve = Curve::Ellipse(*arc);
    let is_whole = (arc.to - arc.from).abs() >= TAU;
    if is_whole {
        let half = EllipseArc {
            to: arc.from + core::f64::consts::PI,
            ..*arc
        };
        if half.bulge().is_some() {
            return Path::circle(arc.center, arc.u.length());
        }
    }
    let mut path = Path::from(curve.start());
    path.closed = is_whole;
    match arc.bulge() {
        Some(bulge) => path.edge_to(curve.end(), bulge),
        None => path.pieces.push(Piece::Curve(Box::new(curve))),
    }
    path
}

fn insert<'a>(record: &Record<'_, 'a>, names: &mut Names<'a>) -> Result<What> {
    let at = record.point(10)?.0;
    let Some(behind) = record.is_from_behind()? else {
        return Ok(tilted(at));
    };
    let [sx, sy] = [41, 42].map(|c| record.real(c));
    let (sx, sy) = (sx?.unwrap_or(1.0), sy?.unwrap_or(1.0));
    let x = direction(record.real(50)?.unwrap_or(0.0));
    let front = if behind {
        Affine::MIRROR_X
    } else {
        Affine::IDENTITY
    };
    let map = front.after(&Affine {
        x: x * sx,
        y: x.left() * sy,
        origin: at,
    });
    if !map.is_usable() {
        return Ok(What::problem(
            Some(at),
            "its scale is zero or beyond computing",
            "give the block a scale of ordinary size",
        ));
    }
    let count = |code| -> Result<u32> {
        let count = record.integer(code)?.unwrap_or(1).max(1);
        Ok(u32::try_from(count).unwrap_or(u32::MAX))
    };
    let [columns, rows] = [44, 45].map(|c| record.real(c));
    Ok(What::Insert(Box::new(Insert {
        block: names.get(record.text(2)),
        map,
        steps: [
            front.vector(x * columns?.unwrap_or(0.0)),
            front.vector(x.left() * rows?.unwrap_or(0.0)),
        ],
        counts: [count(70)?, count(71)?],
    })))
}

/// What other types are.
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
        b"HATCH" | b"MPOLYGON" => "a fill, which has no outline of its own",
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
