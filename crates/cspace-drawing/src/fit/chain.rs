//! Loops of lines and arcs from chains that may have curves.

use core::f64::consts::PI;

use cspace::{Point, Vector, Vertex};

use super::deviation::of_others;
use super::pieces::fit;
use super::run::{Band, Run, RunEnd};
use crate::curve::Curve;
use crate::join::{Chain, ChainPiece, Shape};

/// Directions that differ by more than this, in radians, are a corner: files have directions to fewer digits than places.
const CORNER: f64 = 0.01;

/// On which side of a curve the pieces may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sided {
    Both,
    Left,
    Right,
}

/// A loop of lines and arcs.
#[derive(Debug, Clone, Default)]
pub(crate) struct Outline {
    pub(crate) vertices: Vec<Vertex>,
    /// The entity that each edge comes from.
    pub(crate) entities: Vec<u32>,
    /// The entities that lines and arcs were fitted to.
    pub(crate) curves: Vec<u32>,
    pub(crate) pieces: usize,
    pub(crate) deviation: f64,
    pub(crate) kink: f64,
}

/// Why a curve could not be fitted: the entity, and where it starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NotFitted {
    pub(crate) entity: u32,
    pub(crate) at: Point,
}

/// A smooth stretch of a chain: an edge, or spans of curves that continue one another.
enum Stretch<'c> {
    Edge(&'c ChainPiece<'c>, f64),
    Curves(Vec<Part<'c>>),
}

/// A span of a curve in the direction of travel.
#[derive(Clone, Copy)]
struct Part<'c> {
    curve: &'c Curve,
    span: usize,
    is_backward: bool,
    piece: &'c ChainPiece<'c>,
}

impl Part<'_> {
    /// The point at a fraction of the span, and the direction of travel; the chord's where the derivative vanishes.
    fn at(&self, s: f64) -> (Point, Vector) {
        let u = if self.is_backward { 1.0 - s } else { s };
        let (point, mut velocity) = self.curve.at(self.span, u);
        let near = |u: f64| self.curve.at(self.span, u).0;
        if velocity.length() <= 1e-9 * near(0.0).distance(near(1.0)) {
            /// A step along a span over which a cusp's direction shows.
            const STEP: f64 = 1e-3;
            let (a, b) = ((u - STEP).max(0.0), (u + STEP).min(1.0));
            velocity = near(b) - near(a);
        }
        let direction = velocity.unit();
        (
            point,
            if self.is_backward {
                -direction
            } else {
                direction
            },
        )
    }
}

/// The loop of a chain; its curves fitted within a tolerance.
pub(crate) fn outline(
    chain: &Chain<'_>,
    tolerance: f64,
    sided: Sided,
) -> Result<Outline, NotFitted> {
    let mut outline = Outline::default();
    let stretches = stretches(chain);
    let n = stretches.len();
    for (i, stretch) in stretches.iter().enumerate() {
        match stretch {
            Stretch::Edge(piece, bulge) => {
                outline
                    .vertices
                    .push(Vertex::new(piece.start.x, piece.start.y, *bulge));
                outline.entities.push(piece.entity);
            }
            Stretch::Curves(parts) => {
                let (first, last) = (parts[0], parts[parts.len() - 1]);
                let is_closed = n == 1 && !turns(last.at(1.0).1, first.at(0.0).1);
                let before = stretches[(i + n - 1) % n].edge_direction(1);
                let after = stretches[(i + 1) % n].edge_direction(0);
                let smooth = |edge: Option<Vector>, own: Vector| match edge {
                    Some(edge) if !turns(edge, own) => RunEnd::Along(edge),
                    _ => RunEnd::Free,
                };
                let ends = [
                    smooth(before, first.at(0.0).1),
                    smooth(after, last.at(1.0).1),
                ];
                let band = match sided {
                    Sided::Both => Band::both(tolerance),
                    Sided::Left => Band::one_sided(tolerance, true),
                    Sided::Right => Band::one_sided(tolerance, false),
                };
                add_run(&mut outline, parts, is_closed, ends, band)?;
            }
        }
    }
    Ok(outline)
}

/// Whether two directions of travel make a corner.
fn turns(a: Vector, b: Vector) -> bool {
    a.cross(b).atan2(a.dot(b)).abs() > CORNER
}

fn add_run(
    outline: &mut Outline,
    parts: &[Part<'_>],
    is_closed: bool,
    ends: [RunEnd; 2],
    band: Band,
) -> Result<(), NotFitted> {
    /// Samples of a span at first, and at most.
    const FIRST: usize = 16;
    const LAST: usize = 1024;
    /// Samples of a piece, that joints at samples are nearly as good as anywhere.
    const ENOUGH: usize = 14;
    let start = parts[0].piece;
    let not_fitted = NotFitted {
        entity: start.entity,
        at: start.start,
    };
    let mut per_span = FIRST;
    let (fitted, run) = loop {
        let run = sample(parts, per_span, is_closed, ends, band);
        let fitted = fit(&run);
        let is_fine = fitted
            .as_ref()
            .is_some_and(|f| f.vertices.len() * ENOUGH <= run.points.len());
        if is_fine || per_span >= LAST || run.points.len() > 200_000 {
            break (fitted.ok_or(not_fitted)?, run);
        }
        per_span *= 2;
    };
    // Samples of the same curve between those it was fitted to say what is reported.
    let between = sample(parts, 3 * per_span, is_closed, ends, band);
    let deviation = of_others(&between, &run, &fitted).unwrap_or(fitted.deviation);
    let entity_of = |vertex: &Vertex| {
        let nearest = run.points.iter().enumerate().min_by(|a, b| {
            let apart = |p: &Point| p.distance(vertex.point());
            apart(a.1).total_cmp(&apart(b.1))
        });
        let span = nearest.map_or(0, |(i, _)| i / per_span);
        parts[span.min(parts.len() - 1)].piece.entity
    };
    outline
        .entities
        .extend(fitted.vertices.iter().map(entity_of));
    let mut entities: Vec<u32> = parts.iter().map(|p| p.piece.entity).collect();
    entities.sort_unstable();
    entities.dedup();
    outline.curves.extend(entities);
    outline.pieces += fitted.vertices.len();
    outline.deviation = outline.deviation.max(deviation);
    outline.kink = outline.kink.max(fitted.kink);
    outline.vertices.extend(fitted.vertices);
    Ok(())
}

fn sample(
    parts: &[Part<'_>],
    per_span: usize,
    is_closed: bool,
    ends: [RunEnd; 2],
    band: Band,
) -> Run {
    let mut points = Vec::with_capacity(parts.len() * per_span + 1);
    let mut normals = Vec::with_capacity(points.capacity());
    for part in parts {
        for k in 0..per_span {
            let (point, direction) = part.at(k as f64 / per_span as f64);
            points.push(point);
            normals.push(direction.left());
        }
    }
    // The ends are where they were joined.
    let (first, last) = (parts[0].piece, parts[parts.len() - 1]);
    if !is_closed {
        points[0] = first.start;
        points.push(last.piece.end);
        normals.push(last.at(1.0).1.left());
    }
    Run {
        points,
        joints: None,
        normals,
        is_closed,
        is_measured: false,
        ends,
        band,
    }
}

/// The stretches of a chain, beginning at a corner or an edge if there is one.
fn stretches<'c>(chain: &'c Chain<'c>) -> Vec<Stretch<'c>> {
    let mut all: Vec<Stretch<'c>> = Vec::new();
    for piece in &chain.pieces {
        match piece.shape {
            Shape::Edge(bulge) => all.push(Stretch::Edge(piece, bulge)),
            Shape::Curve(curve) => {
                let spans = curve.spans();
                for k in 0..spans {
                    let span = if piece.is_backward { spans - 1 - k } else { k };
                    let part = Part {
                        curve,
                        span,
                        is_backward: piece.is_backward,
                        piece,
                    };
                    all.push(Stretch::Curves(vec![part]));
                }
            }
        }
    }
    let mut merged: Vec<Stretch<'c>> = Vec::new();
    for stretch in all {
        match (merged.last_mut(), stretch) {
            (Some(Stretch::Curves(before)), Stretch::Curves(next)) if continues(before, &next) => {
                before.extend(next);
            }
            (_, stretch) => merged.push(stretch),
        }
    }
    // The last may go on with the first.
    if merged.len() > 1
        && let [Stretch::Curves(first), .., Stretch::Curves(last)] = &merged[..]
        && continues(last, first)
        && let Some(Stretch::Curves(mut last)) = merged.pop()
        && let Stretch::Curves(first) = &mut merged[0]
    {
        last.append(first);
        *first = last;
    }
    merged
}

fn continues(before: &[Part<'_>], next: &[Part<'_>]) -> bool {
    let (Some(last), Some(first)) = (before.last(), next.first()) else {
        return false;
    };
    !turns(last.at(1.0).1, first.at(0.0).1)
}

impl Stretch<'_> {
    /// The direction of an edge at its start (0) or end (1).
    fn edge_direction(&self, side: usize) -> Option<Vector> {
        let Stretch::Edge(piece, bulge) = self else {
            return None;
        };
        let chord = (piece.end - piece.start).unit();
        let half = 2.0 * bulge.atan();
        let turn = if side == 0 { -half } else { half };
        debug_assert!(turn.abs() <= PI);
        let (sin, cos) = turn.sin_cos();
        Some(chord * cos + chord.left() * sin)
    }
}
