//! Loops of lines and arcs from chains that may have curves.

use cspace::{Point, Vector, Vertex};

use super::deviation::of_others;
use super::part::Part;
use super::pieces::fit_within;
use super::run::{Band, Run, RunEnd};
use crate::drawing::edge;
use crate::join::{Chain, ChainPiece, Shape};

/// Directions that differ by more than this, in radians, are a corner: files have directions to fewer digits than places.
const CORNER: f64 = 0.01;

/// Turning by more than this, in radians, is turning back: pieces in other directions than the curve's would cross there.
const BACK: f64 = 2.8;

/// Largest number of times that a run is halved if it cannot be fitted: by then it is a piece of a few tolerances.
const HALVINGS: u32 = 20;

/// The length within which a curve turns sharply if that is a corner, as a share of the tolerance: nobody sees how it turns.
const SHARP_WITHIN: f64 = 0.25;

/// Side of a curve on which the fitted pieces may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
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

/// The loop of a chain; its curves fitted within a tolerance.
pub(crate) fn outline(
    chain: &Chain<'_>,
    tolerance: f64,
    sided: Sided,
) -> Result<Outline, NotFitted> {
    let mut outline = Outline::default();
    let stretches = stretches(chain, SHARP_WITHIN * tolerance);
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
                let others = [
                    stretches[(i + n - 1) % n].direction(1),
                    stretches[(i + 1) % n].direction(0),
                ];
                let ends = [
                    run_end(others[0], first.at(0.0).1),
                    run_end(others[1], last.at(1.0).1),
                ];
                let band = match sided {
                    Sided::Both => Band::both(tolerance),
                    Sided::Left => Band::one_sided(tolerance, true),
                    Sided::Right => Band::one_sided(tolerance, false),
                };
                add_run(&mut outline, parts, is_closed, ends, band, HALVINGS)?;
            }
        }
    }
    Ok(outline)
}

/// Whether two directions of travel form a corner.
fn turns(a: Vector, b: Vector) -> bool {
    angle(a, b) > CORNER
}

fn angle(a: Vector, b: Vector) -> f64 {
    a.cross(b).atan2(a.dot(b)).abs()
}

/// Constraint at the end of a curve beside another stretch, whose direction is exact if it is an edge's.
fn run_end((other, is_edge): (Vector, bool), own: Vector) -> RunEnd {
    match angle(other, own) {
        turn if turn <= CORNER && is_edge => RunEnd::Along(other),
        turn if turn > BACK => RunEnd::Along(own),
        _ => RunEnd::Free,
    }
}

/// Fits a run and adds it. If it cannot be fitted as a whole, it is fitted in two halves that are tangent where they
/// meet: the shorter a run of a curve, the nearer it is to an arc.
fn add_run(
    outline: &mut Outline,
    parts: &[Part<'_>],
    is_closed: bool,
    ends: [RunEnd; 2],
    band: Band,
    halvings: u32,
) -> Result<(), NotFitted> {
    /// Samples of a span at first, when a run is halved that was not fitted, and at most.
    const FIRST: usize = 16;
    const HALVED: usize = 64;
    const LAST: usize = 1024;
    /// Samples of a piece, that joints at samples are nearly as good as anywhere.
    const ENOUGH: usize = 8;
    let start = parts[0].piece;
    let mut per_span = FIRST;
    let mut limits = None;
    let (fitted, run) = loop {
        let run = sample(parts, per_span, is_closed, ends, band);
        match fit_within(&run, &mut limits) {
            Some(fitted) => {
                let is_fine = fitted.vertices.len() * ENOUGH <= run.points.len();
                if is_fine || per_span >= LAST || run.points.len() > 200_000 {
                    break (fitted, run);
                }
            }
            None if per_span < HALVED => {}
            None => {
                if let Some(own) = own_ends(parts, ends) {
                    // The drawing has a small kink there, that a short run does not take up.
                    return add_run(outline, parts, is_closed, own, band, halvings);
                }
                if halvings == 0 {
                    return Err(NotFitted {
                        entity: start.entity,
                        at: start.start,
                    });
                }
                let mut halves = parts.to_vec();
                if let [only] = parts {
                    halves = only.halves().to_vec();
                }
                let (first, second) = halves.split_at(halves.len() / 2);
                let meeting = RunEnd::Along(second[0].at(0.0).1);
                let ends = match is_closed {
                    true => [RunEnd::Along(first[0].at(0.0).1); 2],
                    false => ends,
                };
                let [start, end] = ends;
                add_run(outline, first, false, [start, meeting], band, halvings - 1)?;
                return add_run(outline, second, false, [meeting, end], band, halvings - 1);
            }
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

/// The ends with the directions that the curve has there, where they are to be tangent; none if they have these already.
fn own_ends(parts: &[Part<'_>], ends: [RunEnd; 2]) -> Option<[RunEnd; 2]> {
    let own = [parts[0].at(0.0).1, parts[parts.len() - 1].at(1.0).1];
    let is_other = |i: usize| matches!(ends[i], RunEnd::Along(d) if angle(d, own[i]) > 0.0);
    (is_other(0) || is_other(1)).then(|| {
        core::array::from_fn(|i| match ends[i] {
            RunEnd::Free => RunEnd::Free,
            RunEnd::Along(_) => RunEnd::Along(own[i]),
        })
    })
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
    if !is_closed {
        let (end, direction) = parts[parts.len() - 1].at(1.0);
        points.push(end);
        normals.push(direction.left());
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

/// The stretches of a chain, beginning at a corner or an edge if there is one. What turns sharply within a length is a corner.
fn stretches<'c>(chain: &'c Chain<'c>, within: f64) -> Vec<Stretch<'c>> {
    let mut all: Vec<Stretch<'c>> = Vec::new();
    for piece in &chain.pieces {
        match piece.shape {
            Shape::Edge(bulge) => all.push(Stretch::Edge(piece, bulge)),
            Shape::Curve(curve) => {
                let parts = Part::all(curve, piece, within);
                all.extend(parts.into_iter().map(|part| Stretch::Curves(vec![part])));
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
    /// The direction at its start (0) or end (1), and whether it is that of an edge.
    fn direction(&self, side: usize) -> (Vector, bool) {
        match self {
            Self::Edge(piece, bulge) => {
                let edge = edge(piece.start, piece.end, *bulge);
                let direction = match side {
                    0 => edge.start_direction(),
                    _ => edge.end_direction(),
                };
                (direction, true)
            }
            Self::Curves(parts) => {
                let end = if side == 0 {
                    parts[0]
                } else {
                    parts[parts.len() - 1]
                };
                (end.at(side as f64).1, false)
            }
        }
    }
}
