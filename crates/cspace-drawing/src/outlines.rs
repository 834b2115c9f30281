//! Parts from drawings.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

use cspace::{Part, PartError, Point, Vertex};

use crate::affine::Affine;
use crate::drawing::{Drawing, Entity, Ignored, Origin, Path, Piece, Problem, Unit};
use crate::error::DrawingError;
use crate::fit::{self, NotFitted, Outline, Sided};
use crate::join::{self, Chain, Joined};
use crate::nest::{Lone, nest};

/// How near ends are that are one, as a share of the drawing's size, unless it is said.
pub const DEFAULT_JOIN: f64 = 1e-5;

/// How far lines and arcs may be from what they are fitted to, as a share of the drawing's size, unless it is said.
pub const DEFAULT_FIT: f64 = 1e-4;

/// How a drawing is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    /// Every length of the drawing is multiplied by it first.
    pub scale: f64,
    /// Ends nearer than this are one, in lengths after scaling; [`DEFAULT_JOIN`] where it is not said.
    pub join: Option<f64>,
    /// Curves and points become lines and arcs within this, in lengths after scaling; [`DEFAULT_FIT`] of the size where it
    /// is not said.
    pub fit: Option<f64>,
    /// On which side of the curves the lines and arcs may be.
    pub side: FitSide,
    /// Whether what cannot be used is left out, and listed, instead of being an error.
    pub partial: bool,
    /// One part of this name of all loops, instead of one of every outermost loop.
    pub one_part: Option<String>,
}

/// On which side of a curve lines and arcs may be that are fitted to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FitSide {
    /// On both.
    #[default]
    Both,
    /// Outside of the material alone: the part is as large as drawn, or larger.
    Outside,
    /// Inside of the material alone: the part is as large as drawn, or smaller.
    Inside,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            scale: 1.0,
            join: None,
            fit: None,
            side: FitSide::Both,
            partial: false,
            one_part: None,
        }
    }
}

/// The parts of a drawing, and how they came about.
#[derive(Debug, Clone)]
pub struct Outlines {
    /// The parts, in the order of their outermost loops in the file.
    pub parts: Vec<Part>,
    /// The unit that the file names.
    pub unit: Option<Unit>,
    /// How many entities of each type the parts are made of.
    pub used: BTreeMap<String, usize>,
    /// What was left out.
    pub ignored: Vec<Ignored>,
    /// The gaps that were closed, and where.
    pub joined: Vec<(f64, Point)>,
    /// What was fitted.
    pub fitted: FittedReport,
    /// Outlines of two parts that cross or touch, if there are any: parts may, but a drawing may be wrong.
    pub crossing: Option<Problem>,
    /// How many pieces were drawn twice, or lay within others.
    pub duplicates: usize,
    /// How many pieces overlapped others and were made one with them.
    pub merged: usize,
    /// How many pieces had no length.
    pub tiny: usize,
}

/// What a drawing shows, and what of it cannot be used.
#[derive(Debug, Clone)]
pub struct Survey {
    /// The parts.
    pub parts: Vec<Part>,
    /// The entities that would be outlines, but are in no part.
    pub unused: Vec<Entity>,
    /// Why.
    pub problems: Vec<Problem>,
}

/// How well lines and arcs were fitted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FittedReport {
    /// The number of curves.
    pub curves: usize,
    /// The number of lines and arcs they became.
    pub pieces: usize,
    /// How far these are from the curves, at most.
    pub deviation: f64,
    /// The largest angle between neighbours that should be tangent, in radians; rounding.
    pub kink: f64,
}

impl Drawing {
    /// The parts that the drawing shows.
    ///
    /// Loose pieces are joined to loops, what is drawn twice is taken once, curves become tangent lines and arcs, and loops
    /// within loops are holes.
    ///
    /// # Errors
    /// If anything cannot be used, such as a chain that is not closed, unless that is to be left out; if nothing is left; or
    /// if loops cross or touch.
    pub fn outlines(&self, settings: &Settings) -> Result<Outlines, DrawingError> {
        check(settings)?;
        Making::new(&self.scaled(settings.scale), settings)?.make()
    }

    /// The parts that the drawing shows, and what of it cannot be used: for a picture of both.
    ///
    /// # Errors
    /// If the settings or the coordinates are beyond use.
    pub fn survey(&self, settings: &Settings) -> Result<Survey, DrawingError> {
        check(settings)?;
        let settings = Settings {
            partial: true,
            ..settings.clone()
        };
        let scaled = self.scaled(settings.scale);
        let mut making = Making::new(&scaled, &settings)?;
        let outlines = making.outlines();
        let parts = making.parts(outlines);
        let mut unused: Vec<u32> = making.unused.clone();
        unused.sort_unstable();
        unused.dedup();
        Ok(Survey {
            parts: parts.0,
            unused: (unused.iter())
                .map(|&e| scaled.entities[e as usize].clone())
                .collect(),
            problems: making.told,
        })
    }

    fn scaled(&self, scale: f64) -> Cow<'_, Self> {
        if scale == 1.0 {
            return Cow::Borrowed(self);
        }
        let mut scaled = self.clone();
        let map = Affine {
            x: Affine::IDENTITY.x * scale,
            y: Affine::IDENTITY.y * scale,
            origin: Point::ORIGIN,
        };
        for entity in &mut scaled.entities {
            entity.path = entity.path.mapped(&map);
        }
        Cow::Owned(scaled)
    }

    /// The diagonal of the box of all ends and some points of curves.
    pub fn size(&self) -> f64 {
        let mut lo = [f64::INFINITY; 2];
        let mut hi = [f64::NEG_INFINITY; 2];
        for p in self.entities.iter().flat_map(|e| points(&e.path)) {
            lo = [lo[0].min(p.x), lo[1].min(p.y)];
            hi = [hi[0].max(p.x), hi[1].max(p.y)];
        }
        if lo[0] <= hi[0] {
            (hi[0] - lo[0]).hypot(hi[1] - lo[1])
        } else {
            0.0
        }
    }
}

fn points(path: &Path) -> impl Iterator<Item = Point> {
    let of_piece = |piece: &Piece| match piece {
        Piece::Edge { to, .. } => vec![*to],
        Piece::Curve(curve) => (0..curve.spans())
            .flat_map(|span| [0.5, 1.0].map(|s| curve.at(span, s).0))
            .collect(),
    };
    let pieces: Vec<Point> = path.pieces.iter().flat_map(of_piece).collect();
    [path.start].into_iter().chain(pieces)
}

fn check(settings: &Settings) -> Result<(), DrawingError> {
    let positive = |x: f64| x > 0.0 && x.is_finite();
    let wrong = |what: &str, x: f64| {
        let message = format!("`{what}` is {x:?}");
        Err(DrawingError::file(
            message,
            format!("give a positive number as {what}"),
        ))
    };
    if !positive(settings.scale) {
        return wrong("scale", settings.scale);
    }
    for (what, length) in [("join", settings.join), ("fit", settings.fit)] {
        if let Some(x) = length.filter(|&x| !positive(x)) {
            return wrong(what, x);
        }
    }
    Ok(())
}

/// A drawing on its way to parts.
struct Making<'d> {
    drawing: &'d Drawing,
    settings: &'d Settings,
    fit: f64,
    joined: Joined<'d>,
    /// What cannot be used, and is an error.
    problems: Vec<Problem>,
    /// What cannot be used, and is left out.
    told: Vec<Problem>,
    /// Entities that would be outlines.
    unused: Vec<u32>,
    ignored: Vec<Ignored>,
    report: FittedReport,
}

impl<'d> Making<'d> {
    fn new(drawing: &'d Drawing, settings: &'d Settings) -> Result<Self, DrawingError> {
        let size = drawing.size();
        let has_size = size > 0.0 && size.is_finite();
        if !has_size && !drawing.entities.is_empty() {
            let message = "its coordinates are beyond computing, or all are the same";
            let help = "check the file, and its unit of length";
            return Err(DrawingError::file(message, help));
        }
        let mut joined = join::join(drawing, size, settings.join.unwrap_or(DEFAULT_JOIN * size));
        let mut problems = drawing.problems.clone();
        problems.append(&mut joined.problems);
        let mut making = Self {
            drawing,
            settings,
            fit: settings.fit.unwrap_or(DEFAULT_FIT * size),
            joined,
            problems: Vec::new(),
            told: Vec::new(),
            unused: Vec::new(),
            ignored: drawing.ignored.clone(),
            report: FittedReport::default(),
        };
        for problem in problems {
            making.refuse(problem);
        }
        making.leave_out_chains();
        Ok(making)
    }

    /// An error, or something left out.
    fn refuse(&mut self, problem: Problem) {
        if !self.settings.partial {
            self.problems.push(problem);
            return;
        }
        for origin in [&problem.origin].into_iter().chain(&problem.with) {
            self.ignored.push(Ignored {
                origin: origin.clone(),
                reason: problem.reason.clone().into(),
            });
        }
        self.told.push(problem);
    }

    /// Lists what is in open chains; their ends are listed already.
    fn leave_out_chains(&mut self) {
        self.unused = core::mem::take(&mut self.joined.unused);
        if !self.settings.partial {
            return;
        }
        let key = |o: &Origin| (o.line, Arc::as_ptr(&o.handle));
        let listed: HashSet<(usize, *const str)> =
            self.ignored.iter().map(|i| key(&i.origin)).collect();
        let mut entities = self.unused.clone();
        entities.sort_unstable();
        entities.dedup();
        for entity in entities {
            let origin = &self.drawing.entities[entity as usize].origin;
            if !listed.contains(&key(origin)) {
                self.ignored.push(Ignored {
                    origin: origin.clone(),
                    reason: "it is in a chain that is not closed".into(),
                });
            }
        }
    }

    fn make(mut self) -> Result<Outlines, DrawingError> {
        let nested = self.outlines();
        let crossing = self.crossing(&nested);
        let (parts, outlines) = self.parts(nested);
        if !self.problems.is_empty() {
            return Err(DrawingError::Entities(self.problems));
        }
        if parts.is_empty() {
            return Err(self.nothing());
        }
        Ok(Outlines {
            parts,
            unit: self.drawing.unit,
            used: self.used(&outlines),
            ignored: self.ignored,
            joined: self.joined.gaps,
            crossing,
            fitted: self.report,
            duplicates: self.joined.duplicates,
            merged: self.joined.merged,
            tiny: self.joined.tiny,
        })
    }

    /// The loops, and which are parts together.
    fn outlines(&mut self) -> (Vec<Outline>, Vec<Vec<usize>>) {
        let chains = core::mem::take(&mut self.joined.loops);
        let sided = self.settings.side != FitSide::Both;
        let mut loops: Vec<(Outline, Option<Chain<'d>>)> = Vec::with_capacity(chains.len());
        let mut lone: Vec<Lone> = Vec::with_capacity(chains.len());
        for chain in chains {
            if let Some((outline, alone)) = self.fitted(&chain, Sided::Both) {
                // A chain that is not fitted again is not kept.
                let again = (sided && !outline.curves.is_empty()).then_some(chain);
                loops.push((outline, again));
                lone.push(alone);
            }
        }
        let groups = nest(&lone);
        if sided {
            self.refit(&mut loops, &mut lone, &groups);
        }
        for (outline, _) in &loops {
            self.report.pieces += outline.pieces;
            self.report.deviation = self.report.deviation.max(outline.deviation);
            self.report.kink = self.report.kink.max(outline.kink);
        }
        let curves: HashSet<u32> = (loops.iter())
            .flat_map(|l| l.0.curves.iter().copied())
            .collect();
        self.report.curves = curves.len();
        (loops.into_iter().map(|l| l.0).collect(), groups)
    }

    /// The loop of a chain, checked by itself.
    fn fitted(&mut self, chain: &Chain<'_>, sided: Sided) -> Option<(Outline, Lone)> {
        let made = if self.drawing.is_measured {
            let points: Vec<Point> = chain.pieces.iter().map(|p| p.start).collect();
            let first = NotFitted {
                entity: chain.pieces[0].entity,
                at: points[0],
            };
            fit::profile(&points, self.fit, sided, first.entity).ok_or(first)
        } else {
            fit::outline(chain, self.fit, sided)
        };
        let outline = match made {
            Ok(outline) => outline,
            Err(at) => {
                let problem = Problem {
                    origin: self.drawing.entities[at.entity as usize].origin.clone(),
                    with: Vec::new(),
                    at: Some(at.at),
                    to: None,
                    reason: format!("no lines and arcs within {:.2e} of it were found", self.fit),
                    help: "give a larger fit".to_owned(),
                };
                self.unused.push(at.entity);
                self.refuse(problem);
                return None;
            }
        };
        match Part::new("", vec![outline.vertices.clone()]) {
            Ok(part) => {
                let first = outline.vertices.first()?.point();
                Some((outline, Lone { part, first }))
            }
            Err(error) => {
                let problem = self.no_part(&error, &[&outline]);
                self.unused.extend(&outline.entities);
                self.refuse(problem);
                None
            }
        }
    }

    /// Fits again where the side matters, now that it is known which side is material.
    fn refit(
        &mut self,
        loops: &mut [(Outline, Option<Chain<'d>>)],
        lone: &mut [Lone],
        groups: &[Vec<usize>],
    ) {
        for group in groups {
            for (k, &i) in group.iter().enumerate() {
                let Some(chain) = loops[i].1.take() else {
                    continue;
                };
                // Outermost loops have material inside, holes outside; a loop that turns left has its inside on the left.
                let is_outer = k == 0;
                let left_is_inside = !lone[i].part.loops()[0].is_reversed();
                let material_is_left = is_outer == left_is_inside;
                let left = material_is_left == (self.settings.side == FitSide::Inside);
                let sided = if left { Sided::Left } else { Sided::Right };
                if let Some((outline, alone)) = self.fitted(&chain, sided) {
                    loops[i].0 = outline;
                    lone[i] = alone;
                }
            }
        }
    }

    /// Where outermost loops cross or touch.
    fn crossing(&self, (outlines, groups): &(Vec<Outline>, Vec<Vec<usize>>)) -> Option<Problem> {
        if groups.len() < 2 || self.settings.one_part.is_some() {
            return None;
        }
        let outer: Vec<&Outline> = groups.iter().map(|g| &outlines[g[0]]).collect();
        let vertices = outer.iter().map(|o| o.vertices.clone()).collect();
        let error = Part::new("", vertices).err()?;
        Some(self.no_part(&error, &outer))
    }

    /// The parts; the outlines are given back without their vertices.
    fn parts(
        &mut self,
        (mut outlines, groups): (Vec<Outline>, Vec<Vec<usize>>),
    ) -> (Vec<Part>, Vec<Outline>) {
        let groups = match &self.settings.one_part {
            Some(_) if !groups.is_empty() => vec![groups.into_iter().flatten().collect()],
            _ => groups,
        };
        let names = self.names(&outlines, &groups);
        let mut parts = Vec::with_capacity(groups.len());
        for (group, name) in groups.iter().zip(names) {
            let vertices: Vec<Vec<Vertex>> = (group.iter())
                .map(|&i| core::mem::take(&mut outlines[i].vertices))
                .collect();
            match Part::new(name, vertices) {
                Ok(part) => parts.push(part),
                Err(error) => {
                    let of: Vec<&Outline> = group.iter().map(|&i| &outlines[i]).collect();
                    let problem = self.no_part(&error, &of);
                    let entities = of.iter().flat_map(|o| &o.entities).copied();
                    self.unused.extend(entities);
                    self.refuse(problem);
                }
            }
        }
        (parts, outlines)
    }

    /// A part is called as the block that all of its outer loop is in, the layer, or the drawing; with a number where
    /// several are called the same.
    fn names(&self, outlines: &[Outline], groups: &[Vec<usize>]) -> Vec<String> {
        if let Some(name) = &self.settings.one_part {
            return vec![name.clone(); groups.len()];
        }
        let plain: Vec<String> = groups.iter().map(|g| self.name(&outlines[g[0]])).collect();
        let mut counts: HashMap<&str, usize> = HashMap::new();
        for name in &plain {
            *counts.entry(name).or_default() += 1;
        }
        let mut taken: HashSet<String> = (counts.iter())
            .filter(|(_, n)| **n == 1)
            .map(|(name, _)| (*name).to_owned())
            .collect();
        let mut next: HashMap<&str, usize> = HashMap::new();
        (plain.iter())
            .map(|name| {
                if counts[name.as_str()] == 1 {
                    return name.clone();
                }
                let number = next.entry(name).or_insert(0);
                loop {
                    *number += 1;
                    let numbered = format!("{name} {number}");
                    if taken.insert(numbered.clone()) {
                        return numbered;
                    }
                }
            })
            .collect()
    }

    fn name(&self, outline: &Outline) -> String {
        let origins: Vec<&Origin> = (outline.entities.iter())
            .map(|&e| &self.drawing.entities[e as usize].origin)
            .collect();
        let Some((first, rest)) = origins.split_first() else {
            return self.drawing.name.clone();
        };
        let shared = |o: &Origin| {
            (first.blocks.iter().zip(o.blocks.iter()))
                .take_while(|(a, b)| a == b)
                .count()
        };
        let depth = rest
            .iter()
            .map(|o| shared(o))
            .min()
            .unwrap_or(first.blocks.len());
        // Names that begin with a star are made up by programs.
        let block = first.blocks[..depth]
            .iter()
            .rev()
            .find(|b| !b.starts_with('*'));
        let layer = (rest.iter().all(|o| o.layer == first.layer))
            .then_some(&first.layer)
            .filter(|l| !l.is_empty() && &***l != "0");
        let name = block.or(layer).map_or(self.drawing.name.as_str(), |n| n);
        // Model files have no control characters in names.
        let name: String = name.chars().filter(|c| !c.is_control()).collect();
        if name.trim().is_empty() {
            "part".to_owned()
        } else {
            name
        }
    }

    fn used(&self, outlines: &[Outline]) -> BTreeMap<String, usize> {
        let mut is_used = vec![false; self.drawing.entities.len()];
        for &entity in outlines.iter().flat_map(|o| &o.entities) {
            is_used[entity as usize] = true;
        }
        let mut used = BTreeMap::new();
        for (entity, _) in self
            .drawing
            .entities
            .iter()
            .zip(&is_used)
            .filter(|(_, u)| **u)
        {
            *used.entry(entity.origin.kind.to_string()).or_default() += 1;
        }
        used
    }

    /// What is wrong with loops, at the entities that drew them.
    fn no_part(&self, error: &PartError, outlines: &[&Outline]) -> Problem {
        let entity = |l: usize, v: usize| {
            let entity = outlines.get(l).and_then(|o| o.entities.get(v));
            entity.map(|&e| self.drawing.entities[e as usize].origin.clone())
        };
        let place = |l: usize, v: usize| {
            let vertex = outlines.get(l).and_then(|o| o.vertices.get(v));
            vertex.map(|v| v.point())
        };
        let (ends, at, reason, help) = match *error {
            PartError::Crossing {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at,
            } => (
                [(loop_index, edge_index), (other_loop, other_edge)],
                Some(at),
                "outlines cross here".to_owned(),
                "move them apart, or read their layers one by one with --layer".to_owned(),
            ),
            PartError::Touching {
                loop_index,
                edge_index,
                other_loop,
                other_edge,
                at,
            } => (
                [(loop_index, edge_index), (other_loop, other_edge)],
                Some(at),
                "outlines touch here".to_owned(),
                "move them apart, merge them, or read their layers one by one with --layer"
                    .to_owned(),
            ),
            ref other => {
                let (l, v) = place_of(other);
                let text = other.to_string();
                let (reason, help) = match text.rsplit_once(": ") {
                    Some((reason, help)) => (reason.to_owned(), help.to_owned()),
                    None => (text.clone(), String::new()),
                };
                ([(l, v); 2], place(l, v), reason, help)
            }
        };
        let [first, second] = ends.map(|(l, v)| entity(l, v));
        Problem {
            with: second
                .into_iter()
                .filter(|s| Some(s) != first.as_ref())
                .collect(),
            origin: first.unwrap_or_default(),
            at,
            to: None,
            reason,
            help,
        }
    }

    fn nothing(&self) -> DrawingError {
        let left_out = match self.ignored.len() {
            0 => String::new(),
            n => format!(
                "; {n} entities were left out, the first, a {}, because: {}",
                self.ignored[0].origin.kind, self.ignored[0].reason
            ),
        };
        DrawingError::file(
            format!("the drawing has no closed outline{left_out}"),
            "draw outlines with lines, arcs, polylines or splines, and check the layers",
        )
    }
}

/// The loop and vertex that an error about one place is of.
fn place_of(error: &PartError) -> (usize, usize) {
    match *error {
        PartError::TooFewVertices { loop_index, .. } => (loop_index, 0),
        PartError::BadCoordinate {
            loop_index,
            vertex_index,
        }
        | PartError::CoordinateTooLarge {
            loop_index,
            vertex_index,
        }
        | PartError::BadBulge {
            loop_index,
            vertex_index,
            ..
        }
        | PartError::CoincidentVertices {
            loop_index,
            vertex_index,
            ..
        }
        | PartError::Spike {
            loop_index,
            vertex_index,
        } => (loop_index, vertex_index),
        _ => (0, 0),
    }
}
