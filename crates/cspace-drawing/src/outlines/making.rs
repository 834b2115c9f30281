//! Making of parts from a drawing.

use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

use cspace::part::Bounds;
use cspace::{Part, PartError, Point, Vertex};

use super::apart::{apart, by_layer};
use super::blunt::{Tip, blunt};
use super::crossing::may_be_of_fit;
use super::fits::Fits;
use super::left_out::{LeftOut, corners};
use super::names::names;
use super::refusal::{no_part, too_deep};
use super::result::{Apart, FittedReport, Outlines};
use super::settings::{DEFAULT_FIT, DEFAULT_JOIN, FitSide, Settings};
use super::trace;
use crate::drawing::{Drawing, Ignored, Origin, Problem};
use crate::error::DrawingError;
use crate::fit::{self, NotFitted, Outline, Sided};
use crate::join::{self, CENTRE_LINE, Chain, Joined};
use crate::nest::{Ring, nest, sheet};
use crate::shown;
use crate::source::OFFERED;

/// State of a drawing while parts are made from it.
pub(super) struct Making<'d> {
    pub(super) drawing: &'d Drawing,
    pub(super) settings: &'d Settings,
    fits: &'d Fits,
    /// The size of the drawing.
    size: f64,
    pub(super) joined: Joined<'d>,
    /// Problems that are errors.
    problems: Vec<Problem>,
    /// Problems whose entities are left out.
    pub(super) told: Vec<Problem>,
    /// Entities that would be outlines.
    pub(super) unused: Vec<u32>,
    pub(super) ignored: Vec<Ignored>,
    apart: Vec<Apart>,
    sheet: Option<Origin>,
    pub(super) report: FittedReport,
}

/// Why a rectangle around everything is left out.
pub const SHEET: &str = "the sheet around everything";

/// Why a closed outline is left out that would be one by itself.
const WITH_LEFT_OUT: &str =
    "it and an outline that is left out may be one part: make parts of faces with --pick instead";

/// A closed chain and the lines and arcs that it becomes.
struct Closed<'d> {
    outline: Outline,
    ring: Ring,
    /// Whether it may be a loop of a part; if not, the problem is reported already.
    is_usable: bool,
    /// The chain, where it is fitted again once it is known which side is material.
    again: Option<Chain<'d>>,
}

/// Line and handle of an origin, which tell origins apart.
pub(super) type OriginKey = (usize, *const str);

pub(super) fn key(origin: &Origin) -> OriginKey {
    (origin.line, Arc::as_ptr(&origin.handle))
}

impl<'d> Making<'d> {
    pub(super) fn new(
        drawing: &'d Drawing,
        settings: &'d Settings,
        fits: &'d Fits,
    ) -> Result<Self, DrawingError> {
        let size = drawing.size();
        let has_size = size > 0.0 && size.is_finite();
        if !has_size && !drawing.entities.is_empty() {
            let message = "its coordinates are beyond computing, or all are the same";
            let help = "check the file, and its unit of length";
            return Err(DrawingError::file(message, help));
        }
        let mut joined = join::join(drawing, size, join_within(settings, size));
        let mut problems = drawing.problems.clone();
        problems.append(&mut joined.problems);
        let mut making = Self {
            drawing,
            settings,
            fits,
            size,
            joined,
            problems: Vec::new(),
            told: Vec::new(),
            unused: Vec::new(),
            ignored: drawing.ignored.clone(),
            apart: Vec::new(),
            sheet: None,
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

    /// Lists the entities of open chains; their ends are listed already.
    fn leave_out_chains(&mut self) {
        self.unused = core::mem::take(&mut self.joined.unused);
        let mut loose = self.joined.centre_lines.clone();
        loose.dedup();
        self.ignored.extend(loose.into_iter().map(|entity| Ignored {
            origin: self.drawing.entities[entity as usize].origin.clone(),
            reason: CENTRE_LINE.into(),
        }));
        if !self.settings.partial {
            return;
        }
        let listed: HashSet<OriginKey> = self.ignored.iter().map(|i| key(&i.origin)).collect();
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

    /// A distance at which joining ends most likely closes all that is open, and how many pieces are removed without; none if something else
    /// cannot be used, or a distance is given.
    pub(super) fn closes(&self) -> Option<(f64, usize)> {
        /// Gaps below this share of the drawing are meant to be closed if each end has one partner.
        const LIKELY: f64 = 1e-3;
        let is_asked = self.settings.join.is_none() && !self.settings.partial;
        let is_all = self.problems.len() == self.joined.small;
        let join = self
            .joined
            .closes
            .filter(|&join| is_asked && is_all && join <= LIKELY * self.size)?;
        Some((join, self.joined.tiny))
    }

    /// The parts, or what cannot be used.
    pub(super) fn make(mut self) -> Result<Outlines, DrawingError> {
        let nested = self.outlines();
        let crossing = self.crossing(&nested);
        let (parts, outlines) = self.parts(nested);
        if !self.problems.is_empty() {
            return Err(DrawingError::Entities(self.problems));
        }
        if parts.is_empty() {
            return Err(self.nothing());
        }
        Ok(self.result(parts, &outlines, crossing))
    }

    /// Collects the result: the parts and the loops used for them.
    pub(super) fn result(
        self,
        parts: Vec<Part>,
        outlines: &[Outline],
        crossing: Option<Problem>,
    ) -> Outlines {
        Outlines {
            parts,
            unit: self.drawing.unit,
            used: self.used(outlines),
            ignored: self.ignored,
            unfollowed: self.drawing.unfollowed.clone(),
            sheet: self.sheet,
            closed: None,
            apart: self.apart,
            joined: self.joined.gaps,
            crossing,
            fitted: self.report,
            duplicates: self.joined.duplicates,
            merged: self.joined.merged,
            tiny: self.joined.tiny,
            largest_removed: self.joined.largest_removed,
        }
    }

    /// Ends nearer than this are one.
    pub(super) fn join_within(&self) -> f64 {
        join_within(self.settings, self.size)
    }

    /// The loops, and which are parts together.
    pub(super) fn outlines(&mut self) -> (Vec<Outline>, Vec<Vec<usize>>) {
        let chains = core::mem::take(&mut self.joined.loops);
        let sided = self.settings.side != FitSide::Both;
        let mut loops: Vec<Closed<'d>> = Vec::with_capacity(chains.len());
        for chain in chains {
            let (outline, is_usable) = match self.fitted(&chain, Sided::Both) {
                Ok(outline) => (outline, true),
                Err(outline) => (outline, false),
            };
            loops.push(Closed {
                ring: Ring::of(&outline.vertices),
                // A chain that is not fitted again is not kept.
                again: (sided && !outline.curves.is_empty()).then_some(chain),
                outline,
                is_usable,
            });
        }
        // A sheet that is asked for may hold a single outline.
        let least = if self.settings.without_sheet { 1 } else { 2 };
        if let Some(sheet) = sheet(loops.iter().map(|l| &l.ring), least) {
            let entity = loops[sheet].outline.entities.first();
            let origin = entity.map(|&e| self.drawing.entities[e as usize].origin.clone());
            if self.settings.without_sheet {
                self.ignored.extend(origin.map(|origin| Ignored {
                    origin,
                    reason: SHEET.into(),
                }));
                loops.remove(sheet);
            } else {
                // A path with islands is drawn as one.
                let is_other = |l: &Closed<'_>, own: &Origin| {
                    let entity = l.outline.entities.first();
                    let origin = entity.map(|&e| &self.drawing.entities[e as usize].origin);
                    let is_own = |of: &Origin| {
                        // Elements on one line have types of their own.
                        (of.line, &of.handle) == (own.line, &own.handle)
                            && Arc::ptr_eq(&of.kind, &own.kind)
                    };
                    origin.is_some_and(|of| !is_own(of))
                };
                let has_others = |own: &Origin| loops.iter().any(|l| is_other(l, own));
                self.sheet = origin
                    .filter(|_| is_likely_sheet(&loops, sheet, self.drawing.page))
                    .filter(has_others);
            }
        }
        let groups = nest(&loops.iter().map(|l| &l.ring).collect::<Vec<_>>()).unwrap_or_else(|i| {
            let problem = too_deep(self.drawing, &loops[i].outline);
            self.refuse(problem);
            // With --partial none of them is used: which are holes is not known.
            self.unused
                .extend(loops.iter().flat_map(|l| &l.outline.entities).copied());
            Vec::new()
        });
        let groups = self.usable(groups, &loops);
        if sided {
            self.refit(&mut loops, &groups);
        }
        // Loops that are in no part are not kept.
        let mut outlines = Vec::new();
        let groups = (groups.into_iter())
            .map(|group| {
                let first = outlines.len();
                outlines.extend(
                    group
                        .iter()
                        .map(|&i| core::mem::take(&mut loops[i].outline)),
                );
                (first..outlines.len()).collect()
            })
            .collect();
        for outline in &outlines {
            self.report.add(outline);
        }
        (outlines, groups)
    }

    /// Groups that are complete: the holes of an outline that is left out are no parts, nor is an outline with a hole
    /// that is left out.
    fn usable(&mut self, groups: Vec<Vec<usize>>, loops: &[Closed<'d>]) -> Vec<Vec<usize>> {
        let left_out = LeftOut::of(&self.joined.open, self.join_within());
        let (kept, others): (Vec<Vec<usize>>, Vec<Vec<usize>>) =
            groups.into_iter().partition(|group| {
                group.iter().all(|&i| loops[i].is_usable) && !left_out.holds(&loops[group[0]].ring)
            });
        for &i in others.iter().flatten().filter(|&&i| loops[i].is_usable) {
            let mut entities = loops[i].outline.entities.clone();
            entities.sort_unstable();
            entities.dedup();
            self.ignored.extend(entities.iter().map(|&e| Ignored {
                origin: self.drawing.entities[e as usize].origin.clone(),
                reason: WITH_LEFT_OUT.into(),
            }));
            self.unused.extend(entities);
        }
        kept
    }

    /// Tolerance of the fit for a chain.
    pub(super) fn fit_of(&self, chain: &Chain<'_>) -> f64 {
        self.fit_within(|| chain.size())
    }

    /// Tolerance of the fit for a loop of a size: it may be a small part of a large drawing.
    pub(super) fn fit_within(&self, size: impl FnOnce() -> f64) -> f64 {
        self.settings.fit.unwrap_or_else(|| {
            let size = match self.settings.one_part {
                Some(_) => self.size,
                None => size(),
            };
            DEFAULT_FIT * size
        })
    }

    /// The loop of a chain, checked by itself; an error is what cannot be a loop of a part. Where pieces cross that were fitted to
    /// curves, they are fitted nearer: curves that do not cross are apart by more than some fit.
    fn fitted(&mut self, chain: &Chain<'_>, sided: Sided) -> Result<Outline, Outline> {
        /// Shares of the fit that are tried.
        const NEARER: [f64; 3] = [1.0, 0.125, 0.015_625];
        let fit = self.fit_of(chain);
        let mut refused: Option<(PartError, Outline)> = None;
        for share in NEARER {
            let mut outline = match self.lines_and_arcs(chain, share * fit, sided) {
                Ok(outline) => outline,
                Err(at) if refused.is_none() => {
                    self.refuse_fit(chain, at);
                    return Err(Outline {
                        vertices: corners(chain),
                        ..Outline::default()
                    });
                }
                Err(_) => break,
            };
            match checked(&mut outline, fit) {
                Ok(tips) => {
                    self.tell_tips(&tips, fit);
                    return Ok(outline);
                }
                Err(error) => {
                    let is_of_fit = !outline.curves.is_empty()
                        && may_be_of_fit(&outline.vertices, &error, share * fit);
                    refused.get_or_insert((error, outline));
                    if !is_of_fit {
                        break;
                    }
                }
            }
        }
        let Some((error, outline)) = refused else {
            return Err(Outline::default());
        };
        let problem = no_part(self.drawing, &error, &[&outline]);
        self.unused.extend(&outline.entities);
        self.refuse(problem);
        Err(outline)
    }

    /// The lines and arcs of a chain.
    pub(super) fn lines_and_arcs(
        &self,
        chain: &Chain<'_>,
        fit: f64,
        sided: Sided,
    ) -> Result<Outline, NotFitted> {
        let find = || self.find_lines_and_arcs(chain, fit, sided);
        self.fits.of(chain, fit, sided, find)
    }

    fn find_lines_and_arcs(
        &self,
        chain: &Chain<'_>,
        fit: f64,
        sided: Sided,
    ) -> Result<Outline, NotFitted> {
        if self.settings.trace
            && !self.drawing.is_measured
            && let Some(edges) = trace::edges(chain)
        {
            let first = &chain.pieces[0];
            return trace::outline(&edges, fit, sided, first.entity).ok_or(NotFitted {
                entity: first.entity,
                at: first.start,
            });
        }
        if !self.drawing.is_measured {
            return fit::outline(chain, fit, sided);
        }
        let points: Vec<Point> = chain.pieces.iter().map(|p| p.start).collect();
        let first = NotFitted {
            entity: chain.pieces[0].entity,
            at: points[0],
        };
        fit::profile(&points, fit, sided, first.entity).ok_or(first)
    }

    /// Lists the tips that were taken off.
    pub(super) fn tell_tips(&mut self, tips: &[Tip], fit: f64) {
        for tip in tips {
            let at = shown::point(tip.at);
            let reason = match tip.is_spike {
                true => {
                    format!("its spike to {at} is left out: it goes there and back on one line")
                }
                false => format!(
                    "the tip of its cusp at {at} is cut off, by {} at most: its two sides have one direction",
                    shown::number(fit)
                ),
            };
            self.ignored.push(Ignored {
                origin: self.drawing.entities[tip.entity as usize].origin.clone(),
                reason: reason.into(),
            });
        }
    }

    /// Reports that nothing was fitted, and for scattered points the size of the scatter.
    pub(super) fn refuse_fit(&mut self, chain: &Chain<'_>, at: NotFitted) {
        /// Multiple of the median distance beyond which few of the points lie if they scatter independently.
        const FARTHEST: f64 = 4.0;
        let fit = self.fit_of(chain);
        let points: Vec<Point> = chain.pieces.iter().map(|p| p.start).collect();
        let scatter = if self.drawing.is_measured {
            fit::scatter(&points)
        } else {
            0.0
        };
        let problem = Problem {
            origin: self.drawing.entities[at.entity as usize].origin.clone(),
            with: Vec::new(),
            at: Some(at.at),
            to: None,
            reason: format!(
                "no lines and arcs within {} of it were found",
                shown::number(fit)
            ),
            help: if FARTHEST * scatter > fit {
                format!(
                    "give a larger fit: the points scatter by about {}, which asks for {} or more",
                    shown::number(scatter),
                    shown::number(FARTHEST * scatter)
                )
            } else {
                "give a larger fit".to_owned()
            },
        };
        self.unused.push(at.entity);
        self.refuse(problem);
    }

    /// Fits again where the side matters, now that it is known which side is material.
    fn refit(&mut self, loops: &mut [Closed<'d>], groups: &[Vec<usize>]) {
        for group in groups {
            for (k, &i) in group.iter().enumerate() {
                let Some(chain) = loops[i].again.take() else {
                    continue;
                };
                // Outermost loops have material inside, holes outside; a loop that turns left has its inside on the left.
                let is_outer = k == 0;
                let material_is_left = is_outer == loops[i].ring.turns_left();
                let left = material_is_left == (self.settings.side == FitSide::Inside);
                let sided = if left { Sided::Left } else { Sided::Right };
                if let Ok(outline) = self.fitted(&chain, sided) {
                    loops[i].outline = outline;
                }
            }
        }
    }

    /// Problem of outermost loops that cross or touch.
    fn crossing(&self, (outlines, groups): &(Vec<Outline>, Vec<Vec<usize>>)) -> Option<Problem> {
        if groups.len() < 2 || self.settings.one_part.is_some() {
            return None;
        }
        let outer: Vec<&Outline> = groups.iter().map(|g| &outlines[g[0]]).collect();
        let vertices = outer.iter().map(|o| o.vertices.clone()).collect();
        let error = Part::new("", vertices).err()?;
        Some(no_part(self.drawing, &error, &outer))
    }

    /// The parts; the outlines are given back without their vertices.
    pub(super) fn parts(
        &mut self,
        (mut outlines, groups): (Vec<Outline>, Vec<Vec<usize>>),
    ) -> (Vec<Part>, Vec<Outline>) {
        let groups = match &self.settings.one_part {
            Some(_) if !groups.is_empty() => vec![groups.into_iter().flatten().collect()],
            None if self.settings.by_layer => by_layer(self.drawing, &outlines, groups),
            _ => groups,
        };
        let names = names(
            self.drawing,
            self.settings.one_part.as_deref(),
            &outlines,
            &groups,
        );
        self.apart = apart(self.drawing, &outlines, &groups, &names);
        let mut parts = Vec::with_capacity(groups.len());
        for (group, name) in groups.iter().zip(names) {
            let vertices: Vec<Vec<Vertex>> = (group.iter())
                .map(|&i| core::mem::take(&mut outlines[i].vertices))
                .collect();
            match Part::new(name, vertices) {
                Ok(part) => parts.push(part),
                Err(error) => {
                    let of: Vec<&Outline> = group.iter().map(|&i| &outlines[i]).collect();
                    let problem = no_part(self.drawing, &error, &of);
                    self.unused
                        .extend(of.iter().flat_map(|o| &o.entities).copied());
                    self.refuse(problem);
                    for &i in group {
                        outlines[i].entities.clear();
                    }
                }
            }
        }
        (parts, outlines)
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

    pub(super) fn nothing(&self) -> DrawingError {
        /// Largest number of reasons that are given.
        const MOST_REASONS: usize = 4;
        let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
        for ignored in &self.ignored {
            *reasons.entry(&ignored.reason).or_default() += 1;
        }
        let mut reasons: Vec<(&str, usize)> = reasons.into_iter().collect();
        reasons.sort_by_key(|r| core::cmp::Reverse(r.1));
        let mut left_out: Vec<String> = (reasons.iter().take(MOST_REASONS))
            .map(|(reason, n)| format!("{n} because: {reason}"))
            .collect();
        if self.joined.tiny > 0 {
            left_out.push(format!(
                "{} because: ends nearer than `join` are one",
                self.joined.tiny
            ));
        }
        let left_out = match left_out.is_empty() {
            true => String::new(),
            false => format!("; left out are {}", left_out.join("; ")),
        };
        let hatches = (self.ignored.iter())
            .filter(|i| i.reason == OFFERED)
            .count();
        let help = match hatches {
            0 => "draw outlines with lines, arcs, polylines or splines, and check the layers"
                .to_owned(),
            1 => "--hatches (in a model: hatches = true) takes the outline of 1 hatch".to_owned(),
            n => {
                format!("--hatches (in a model: hatches = true) takes the outlines of {n} hatches")
            }
        };
        DrawingError::file(format!("the drawing has no closed outline{left_out}"), help)
    }
}

/// Whether a rectangle around everything is a sheet rather than a part: something lies in what would be its holes, or it is as large as
/// the page.
fn is_likely_sheet(loops: &[Closed<'_>], sheet: usize, page: Option<Bounds>) -> bool {
    /// How far the sides of a page are from those of a sheet of its size, as a share of the size: lengths of pages have few digits.
    const SAME: f64 = 1e-3;
    let others = (loops.iter().enumerate())
        .filter(|(i, _)| *i != sheet)
        .map(|(_, l)| &l.ring);
    let others: Vec<&Ring> = others.collect();
    let is_nested = others
        .iter()
        .any(|a| others.iter().any(|b| b.has_within(a)));
    let ring = &loops[sheet].ring;
    is_nested || page.is_some_and(|page| ring.is_as_large_as(page, SAME))
}

/// Checks that a loop makes a part, the tips taken off at which it turns back, of cusps by a length; gives those.
pub(super) fn checked(outline: &mut Outline, by: f64) -> Result<Vec<Tip>, PartError> {
    /// Tips of a loop, at most: drawings have few.
    const MOST_TIPS: usize = 64;
    let mut tips: Vec<Tip> = Vec::new();
    loop {
        let error = match Part::new("", vec![outline.vertices.clone()]) {
            Ok(_) => return Ok(tips),
            Err(error) => error,
        };
        let PartError::Spike { vertex_index, .. } = error else {
            return Err(error);
        };
        match blunt(outline, vertex_index, by) {
            Some(tip) if tips.len() < MOST_TIPS => tips.push(tip),
            _ => return Err(error),
        }
    }
}

fn join_within(settings: &Settings, size: f64) -> f64 {
    settings.join.unwrap_or(DEFAULT_JOIN * size)
}
