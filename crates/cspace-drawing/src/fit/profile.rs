//! Lines and arcs from measured points, and from polygons that trace something smooth.
//!
//! The points are divided at sharp turns; between such corners they are a run of samples like those of a curve. Points
//! that scatter are smoothed where pieces meet, so that a joint is not as far off as a point may be. Where a corner
//! lies between two measured points, the pieces before and after it are continued until they meet.
//!
//! Edges of a polygon count, not its corners alone: an edge that turns sharply at both its ends is one, as a chamfer
//! is, and an edge from which the pieces are too far off is drawn as it is.

use std::collections::HashMap;

use cspace::part::Edge;
use cspace::{Point, Vector, Vertex};

use super::chain::{Outline, Sided};
use super::deviation::of_edges;
use super::fitted::Fitted;
use super::pieces::fit;
use super::run::{Band, Run, RunEnd};

/// Length over which directions are measured from a point, in tolerances: over that length points within the tolerance
/// determine a direction to a twelfth of a radian.
const REACH: f64 = 25.0;

/// Turning by more than this, in radians, within that reach, is a corner: three times what scatter may seem to turn.
const CORNER: f64 = 0.35;

/// A corner of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Corner {
    /// Corner at a point.
    At(usize),
    /// Between a point and the next.
    After(usize),
}

/// The loop of a closed profile; `entity` is what its edges come from. None if no lines and arcs are found.
pub(crate) fn profile(
    points: &[Point],
    tolerance: f64,
    sided: Sided,
    entity: u32,
) -> Option<Outline> {
    let reach = REACH * tolerance;
    let turns: Vec<f64> = (0..points.len()).map(|i| turn(points, i, reach)).collect();
    let samples = Samples {
        points,
        scatters: scatter(points) > 0.1 * tolerance,
        tolerance,
        sided,
    };
    let corners = corners(points, &turns, reach);
    let room = |_, _| samples.tolerance;
    let outline = samples.outline(&corners, entity, &room, &mut HashMap::new());
    outline.ok()
}

/// The loop of a polygon that traces something smooth: within the tolerance of its edges, and these within it of the loop.
/// `entity` is what its edges come from. None if no lines and arcs are found.
pub(crate) fn trace(edges: &[Edge], tolerance: f64, sided: Sided, entity: u32) -> Option<Outline> {
    let edges = &joined(edges)[..];
    let (points, firsts) = points(edges);
    let reach = REACH * tolerance;
    let turns: Vec<f64> = (0..points.len()).map(|i| turn(&points, i, reach)).collect();
    let sagittas: Vec<f64> = (0..edges.len()).map(|e| chord_sagitta(edges, e)).collect();
    let samples = Samples {
        points: &points,
        scatters: scatter(&points) > 0.1 * tolerance,
        tolerance,
        sided,
    };
    let mut is_corner: Vec<bool> = (0..points.len())
        .map(|i| turns[i].abs() > CORNER && is_sharpest(&points, &turns, i, reach))
        .collect();
    let mut is_kept = vec![false; edges.len()];
    // An edge that is kept has corners at both ends, so that what lies between them is a line.
    let mut keep = |edge: usize, is_corner: &mut Vec<bool>| {
        let is_new = !core::mem::replace(&mut is_kept[edge], true);
        for end in [edge, (edge + 1) % edges.len()] {
            is_corner[firsts[end]] = true;
        }
        is_new
    };
    // What is drawn stays, and what is off the curve that it would trace by too much to leave room for anything else.
    let coarse = (1.0 - LEAST) * tolerance;
    for (edge, sagitta) in sagittas.iter().enumerate() {
        if is_drawn(edges, edge) || *sagitta > coarse {
            keep(edge, &mut is_corner);
        }
    }
    // The middles of chords are off the curve already: the rest of the tolerance is for the pieces.
    let edge_of = |point: usize| firsts.partition_point(|&first| first <= point) - 1;
    let room = |first: usize, last: usize| {
        let steps = (first..last).map(|i| edge_of(i % points.len()));
        let most = steps.map(|e| sagittas[e]).filter(|s| *s <= coarse);
        tolerance - most.fold(0.0, f64::max)
    };
    let mut fitted = HashMap::new();
    let mut kept_at_once = 1;
    loop {
        let corners: Vec<Corner> = (0..points.len())
            .filter(|&i| is_corner[i])
            .map(Corner::At)
            .collect();
        match samples.outline(&corners, entity, &room, &mut fitted) {
            Ok(mut outline) => {
                let off = of_edges(edges, &outline.vertices)?;
                let mut is_changed = false;
                for (edge, off) in off.iter().enumerate() {
                    if *off > tolerance * (1.0 + ROUNDING) {
                        is_changed |= keep(edge, &mut is_corner);
                    }
                }
                if !is_changed {
                    outline.deviation = off.into_iter().fold(0.0, f64::max);
                    return Some(outline);
                }
            }
            Err((first, steps)) => {
                // The longest edges of a stretch that no pieces fit, each time twice as many.
                let mut within: Vec<usize> = (0..edges.len())
                    .filter(|&e| {
                        let last = firsts.get(e + 1).copied().unwrap_or(points.len());
                        let from = (firsts[e] + points.len() - first) % points.len();
                        from + last - firsts[e] <= steps
                    })
                    .collect();
                within.sort_by(|&a, &b| edges[b].length().total_cmp(&edges[a].length()));
                let mut is_changed = false;
                for edge in within.into_iter().take(kept_at_once) {
                    is_changed |= keep(edge, &mut is_corner);
                }
                if !is_changed {
                    return None;
                }
                kept_at_once *= 2;
            }
        }
    }
}

/// The least share of the tolerance for what is fitted to the corners of chords.
const LEAST: f64 = 0.19;

/// Lines that go on in their direction, as one.
fn joined(edges: &[Edge]) -> Vec<Edge> {
    /// Turn that is none, in radians: that of coordinates with a dozen digits.
    const STRAIGHT: f64 = 1e-9;
    let goes_on = |a: &Edge, b: &Edge| {
        let (d, e) = (a.end - a.start, b.end - b.start);
        let is_straight = d.cross(e).abs() <= STRAIGHT * d.length() * e.length() && d.dot(e) > 0.0;
        a.is_line() && b.is_line() && is_straight
    };
    let mut all: Vec<Edge> = Vec::with_capacity(edges.len());
    for edge in edges {
        match all.last_mut() {
            Some(last) if goes_on(last, edge) => last.end = edge.end,
            _ => all.push(*edge),
        }
    }
    if let [first, .., last] = &all[..]
        && goes_on(last, first)
    {
        all[0].start = last.start;
        all.pop();
    }
    all
}

/// The distance of the middle of an edge from the curve that it is a chord of, if it is one: by its length and the smaller of its turns; 0 of
/// others.
fn chord_sagitta(edges: &[Edge], edge: usize) -> f64 {
    let n = edges.len();
    let [before, own, after] = [n - 1, 0, 1].map(|k| &edges[(edge + k) % n]);
    let turn = |a: &Edge, b: &Edge| {
        let (d, e) = (a.end - a.start, b.end - b.start);
        d.cross(e).atan2(d.dot(e))
    };
    let ends = [turn(before, own), turn(own, after)];
    let least = ends[0].abs().min(ends[1].abs());
    match own.is_line() && ends[0] * ends[1] > 0.0 && least < SMOOTH {
        true => 0.5 * own.length() * (0.25 * least).tan(),
        false => 0.0,
    }
}

/// Largest turn at a corner of a trace, in radians: a circle has 13 chords then.
const SMOOTH: f64 = 0.5;

/// Whether an edge is drawn as it is, and no chord of a curve, as a flat on a shaft is: it is long, and the outline turns at both its ends by
/// more than beside it. Where a line goes on into a curve it turns by less.
fn is_drawn(edges: &[Edge], edge: usize) -> bool {
    /// Length and turns, as multiples of those beside; and the least turn, in radians.
    const LONGER: f64 = 2.0;
    const MORE: f64 = 1.5;
    const LEAST: f64 = 0.02;
    let n = edges.len();
    let at = |k: usize| &edges[(edge + n + k - 2) % n];
    let [before, first, own, second, after] = [0, 1, 2, 3, 4].map(at);
    let turn = |a: &Edge, b: &Edge| {
        let (a, b) = (a.end_direction(), b.start_direction());
        a.cross(b).atan2(a.dot(b))
    };
    let ends = [turn(first, own), turn(own, second)];
    let beside = turn(before, first).abs().max(turn(second, after).abs());
    let least = ends[0].abs().min(ends[1].abs());
    own.is_line()
        && own.length() > LONGER * first.length().max(second.length())
        && ends[0] * ends[1] > 0.0
        && least > (MORE * beside).max(LEAST)
}

/// Excess of a distance over the tolerance, as a share of it, that is rounding.
const ROUNDING: f64 = 1e-9;

fn band(tolerance: f64, sided: Sided) -> Band {
    match sided {
        Sided::Both => Band::both(tolerance),
        Sided::Left => Band::one_sided(tolerance, true),
        Sided::Right => Band::one_sided(tolerance, false),
    }
}

/// Points of all edges, so that what passes them keeps to long edges too; and which is the first of each.
fn points(edges: &[Edge]) -> (Vec<Point>, Vec<usize>) {
    /// Length of an edge, as a multiple of the median, from which it is divided into short ones, but not into more than
    /// `MOST`.
    const LONG: f64 = 4.0;
    const MOST: f64 = 64.0;
    let mut lengths: Vec<f64> = edges.iter().map(Edge::length).collect();
    lengths.sort_by(f64::total_cmp);
    let long = LONG * lengths[lengths.len() / 2];
    let (mut points, mut firsts) = (Vec::new(), Vec::new());
    for edge in edges {
        firsts.push(points.len());
        let bends = if edge.is_line() { 1.0 } else { 2.0 };
        let n = (edge.length() / long).ceil().clamp(bends, MOST) as u32;
        points.extend((0..n).map(|k| edge.at(f64::from(k) / f64::from(n))));
    }
    (points, firsts)
}

/// Error of the chords of an outline from the curve that they trace: the largest sagitta but for a few. `None` if most of
/// its corners are sharp.
pub(crate) fn sagitta(edges: &[Edge]) -> Option<f64> {
    /// At a corner that is drawn chords are longer than on the curves beside it: of a curve are those that are no larger than so many
    /// times what this share of them is within.
    const SHARE: f64 = 0.9;
    const LARGER: f64 = 2.0;
    let mut sagittas: Vec<f64> = Vec::new();
    for (a, b) in edges.iter().zip(edges.iter().cycle().skip(1)) {
        let (d, e) = (a.end - a.start, b.end - b.start);
        let turn = d.cross(e).atan2(d.dot(e)).abs();
        if turn > 0.0 && turn < SMOOTH {
            // The chord of an arc of the angle φ has the sagitta c/2 · tan(φ/4).
            sagittas.push(0.5 * a.length().min(b.length()) * (0.25 * turn).tan());
        }
    }
    if 2 * sagittas.len() < edges.len() {
        return None;
    }
    sagittas.sort_by(f64::total_cmp);
    let at = (SHARE * sagittas.len() as f64) as usize;
    let most = LARGER * sagittas[at.min(sagittas.len() - 1)];
    sagittas.into_iter().rfind(|s| *s <= most)
}

/// Points of a closed outline, and what fits them.
struct Samples<'p> {
    points: &'p [Point],
    scatters: bool,
    tolerance: f64,
    sided: Sided,
}

/// Pieces that were fitted to stretches, by their first and last points.
type FittedStretches = HashMap<(usize, usize), Option<Fitted>>;

impl Samples<'_> {
    /// The lines and arcs between corners; if there are none for a stretch, the number of its first point, and how many steps it has.
    /// `room` is the tolerance of a stretch.
    fn outline(
        &self,
        corners: &[Corner],
        entity: u32,
        room: &dyn Fn(usize, usize) -> f64,
        known: &mut FittedStretches,
    ) -> Result<Outline, (usize, usize)> {
        let n = self.points.len();
        let is_closed = corners.is_empty();
        let stretches: Vec<(usize, usize)> = if is_closed {
            vec![(0, n - 1)]
        } else {
            (0..corners.len())
                .map(|k| {
                    let first = match corners[k] {
                        Corner::At(i) => i,
                        Corner::After(i) => i + 1,
                    };
                    let last = match corners[(k + 1) % corners.len()] {
                        Corner::At(i) | Corner::After(i) => i,
                    };
                    let last = if last > first || (last == first && corners.len() > 1) {
                        last
                    } else {
                        last + n
                    };
                    (first, last)
                })
                .collect()
        };
        let mut outline = Outline::default();
        let mut ends = Vec::with_capacity(stretches.len());
        for (first, last) in stretches {
            let stretch: Vec<Point> = (first..=last).map(|i| self.points[i % n]).collect();
            ends.push(outline.vertices.len());
            if let [only] = stretch[..] {
                outline.vertices.push(Vertex::line(only.x, only.y));
                continue;
            }
            let find = || {
                let tolerance = room(first, last);
                let band = band(tolerance, self.sided);
                fit(&run(&stretch, is_closed, tolerance, self.scatters, band))
            };
            let fitted = known.entry((first, last)).or_insert_with(find).as_ref();
            let fitted = fitted.ok_or((first % n, last - first))?;
            outline.deviation = outline.deviation.max(fitted.deviation);
            outline.kink = outline.kink.max(fitted.kink);
            outline.vertices.extend(&fitted.vertices);
            if !is_closed {
                outline
                    .vertices
                    .push(Vertex::line(fitted.end.x, fitted.end.y));
            }
        }
        if !is_closed {
            meet(&mut outline.vertices, &ends, corners);
        }
        outline.pieces = outline.vertices.len();
        outline.entities = vec![entity; outline.vertices.len()];
        outline.curves = vec![entity];
        Ok(outline)
    }
}

/// Sharp turns of the profile.
fn corners(points: &[Point], turns: &[f64], reach: f64) -> Vec<Corner> {
    let n = points.len();
    let mut corners = Vec::new();
    let mut is_taken = vec![false; n];
    for i in 0..n {
        let after = (i + 1) % n;
        if points[i].distance(points[after]) > reach && is_between(turns, i) {
            corners.push(Corner::After(i));
            is_taken[i] = true;
            is_taken[after] = true;
        }
    }
    for i in 0..n {
        if turns[i].abs() > CORNER && !is_taken[i] && is_sharpest(points, turns, i, reach) {
            corners.push(Corner::At(i));
        }
    }
    corners.sort_by_key(|c| match c {
        Corner::At(i) | Corner::After(i) => *i,
    });
    corners
}

/// Whether a corner lies between a point and the next: the two share its angle, each turns more than the points beyond
/// them, and those hardly turn.
fn is_between(turns: &[f64], i: usize) -> bool {
    /// Largest angle by which a curve beside a corner may turn, as a share of the corner.
    const BESIDE: f64 = 0.15;
    /// Factor by which a point of a corner turns more than a curve beside it, and its smallest turn in radians.
    const MORE: f64 = 3.0;
    const LEAST: f64 = 0.01;
    let n = turns.len();
    let [before, first, second, after] = [n - 1, 0, 1, 2].map(|k| turns[(i + k) % n]);
    let whole = (first + second).abs();
    let beside = before.abs().max(after.abs());
    whole > CORNER
        && first * second > 0.0
        && first.abs().min(second.abs()) > (MORE * beside).max(LEAST)
        && beside < BESIDE * whole
}

/// Whether no point within reach turns more; of equal turns the first counts.
fn is_sharpest(points: &[Point], turns: &[f64], i: usize, reach: f64) -> bool {
    let n = points.len();
    let within = |step: usize| {
        (1..n)
            .map(move |k| (i + step * k) % n)
            .take_while(|&j| points[i].distance(points[j]) <= reach)
    };
    let sharper = |j: usize| turns[j].abs() > turns[i].abs();
    let equal = |j: usize| turns[j].abs() == turns[i].abs();
    within(1).all(|j| !sharper(j)) && within(n - 1).all(|j| !sharper(j) && !equal(j))
}

/// The angle between the directions to a point and from it, each over at least the reach.
fn turn(points: &[Point], i: usize, reach: f64) -> f64 {
    let n = points.len();
    let beyond = |step: isize| {
        (1..n as isize)
            .map(|k| points[(i as isize + step * k).rem_euclid(n as isize) as usize])
            .find(|p| p.distance(points[i]) >= reach)
    };
    let (Some(before), Some(after)) = (beyond(-1), beyond(1)) else {
        return 0.0;
    };
    let (a, b) = (points[i] - before, after - points[i]);
    a.cross(b).atan2(a.dot(b))
}

/// Scatter of points: the median of their distances from the cubic through their neighbours, which is almost 0 for
/// clean points.
pub(crate) fn scatter(points: &[Point]) -> f64 {
    let n = points.len();
    if n < 5 {
        return 0.0;
    }
    let mut off: Vec<f64> = (0..n)
        .map(|i| {
            let [a, b, c, d, e] = core::array::from_fn(|k| points[(i + k) % n].to_vector());
            // The fourth difference of independent scatter is √70 times as large.
            (a - b * 4.0 + c * 6.0 - d * 4.0 + e).length() / 70.0_f64.sqrt()
        })
        .collect();
    off.sort_by(f64::total_cmp);
    off[n / 2]
}

fn run(points: &[Point], is_closed: bool, tolerance: f64, scatters: bool, band: Band) -> Run {
    let n = points.len();
    let at = |i: isize| -> Option<Point> {
        if is_closed {
            Some(points[i.rem_euclid(n as isize) as usize])
        } else {
            usize::try_from(i).ok().and_then(|i| points.get(i).copied())
        }
    };
    let mut normals = Vec::with_capacity(n);
    let mut joints = Vec::with_capacity(n);
    for (i, point) in points.iter().enumerate() {
        let smooth = scatters.then(|| smoothed(&at, i, tolerance)).flatten();
        let (joint, direction) = smooth.unwrap_or_else(|| (*point, direction(&at, i as isize)));
        joints.push(joint);
        normals.push(direction.left());
    }
    Run {
        points: points.to_vec(),
        normals,
        joints: scatters.then_some(joints),
        is_closed,
        is_measured: true,
        ends: [RunEnd::Free; 2],
        band,
    }
}

/// The direction at a point of the circle, or parabola, through it and its neighbours.
fn direction(at: &impl Fn(isize) -> Option<Point>, i: isize) -> Vector {
    let three = |a, b, c| Some((at(a)?, at(b)?, at(c)?));
    if let Some((p, q, r)) = three(i - 1, i, i + 1) {
        let (a, b) = (q - p, r - q);
        return (a.unit() * b.length() + b.unit() * a.length()).unit();
    }
    // At an end the chord and as much again as directions change along it.
    if let Some((p, q, r)) = three(i, i + 1, i + 2) {
        let (a, b) = (q - p, r - q);
        return (a.unit() * (2.0 * a.length() + b.length()) - b.unit() * a.length()).unit();
    }
    if let Some((p, q, r)) = three(i - 2, i - 1, i) {
        let (a, b) = (q - p, r - q);
        return (b.unit() * (2.0 * b.length() + a.length()) - a.unit() * b.length()).unit();
    }
    let (p, q) = (at(i - 1).or_else(|| at(i)), at(i + 1).or_else(|| at(i)));
    p.zip(q)
        .map_or(Vector::new(1.0, 0.0), |(p, q)| (q - p).unit())
}

/// The point of a parabola through the points around, and its direction: of as many points as stay near one.
fn smoothed(
    at: &impl Fn(isize) -> Option<Point>,
    i: usize,
    tolerance: f64,
) -> Option<(Point, Vector)> {
    /// Points on either side.
    const TRIED: [isize; 4] = [15, 10, 6, 4];
    /// Distance in tolerances: less than that of pieces, so that nothing is smoothed away.
    const NEAR: f64 = 0.8;
    let i = i as isize;
    let here = at(i)?;
    TRIED.iter().find_map(|&m| {
        let around: Vec<Point> = (i - m..=i + m).filter_map(at).collect();
        let (first, last) = (around.first()?, around.last()?);
        let along = (*last - *first).unit();
        let local: Vec<(f64, f64)> = (around.iter())
            .map(|p| ((*p - here).dot(along), along.cross(*p - here)))
            .collect();
        let [c0, c1, c2] = parabola(&local)?;
        let worst = (local.iter())
            .map(|(x, y)| (y - c0 - c1 * x - c2 * x * x).abs())
            .fold(0.0, f64::max);
        (worst <= NEAR * tolerance).then(|| {
            let direction = (along + along.left() * c1).unit();
            (here + along.left() * c0, direction)
        })
    })
}

/// The parabola c0 + c1 x + c2 x² of least squares.
fn parabola(points: &[(f64, f64)]) -> Option<[f64; 3]> {
    if points.len() < 4 {
        return None;
    }
    let scale = points.iter().map(|p| p.0.abs()).fold(0.0, f64::max);
    let mut m = [[0.0; 4]; 3];
    for &(x, y) in points {
        let powers = [1.0, x / scale, (x / scale).powi(2)];
        for (row, p) in m.iter_mut().zip(powers) {
            for (cell, q) in row.iter_mut().zip(powers.into_iter().chain([y])) {
                *cell += p * q;
            }
        }
    }
    // Gauss, without exchange of rows: the matrix is positive.
    for i in 0..3 {
        let pivot = m[i][i];
        if pivot.is_nan() || pivot <= 1e-12 {
            return None;
        }
        for j in 0..3 {
            if j != i {
                let factor = m[j][i] / pivot;
                let row = m[i];
                for (cell, by) in m[j].iter_mut().zip(row) {
                    *cell -= factor * by;
                }
            }
        }
    }
    let c = [0, 1, 2].map(|i| m[i][3] / m[i][i]);
    Some([c[0], c[1] / scale, c[2] / (scale * scale)])
}

/// Closes the loop of stretches, each of which has its own last vertex: at a corner that is a point it is the first
/// vertex of the next stretch, and where the corner is between two points the pieces are continued to their
/// intersection, if there is one.
fn meet(vertices: &mut Vec<Vertex>, starts: &[usize], corners: &[Corner]) {
    let n = vertices.len();
    let mut is_dropped = vec![false; n];
    for (k, corner) in corners.iter().enumerate() {
        let first = starts[k];
        let last = (first + n - 1) % n;
        match corner {
            Corner::At(_) => is_dropped[last] = vertices[last].point() == vertices[first].point(),
            Corner::After(_) => {
                let before = (last + n - 1) % n;
                let after = (first + 1) % n;
                let piece = |a: usize, b: usize| {
                    let (from, to) = (vertices[a], vertices[b].point());
                    Edge::between(from.point(), to, from.bulge)
                };
                if before == first || is_dropped[before] {
                    continue;
                }
                let pieces = [piece(before, last), piece(first, after)];
                let Some(at) = meeting(&pieces) else {
                    continue;
                };
                let bulges = [extended(&pieces[0], at, 1), extended(&pieces[1], at, 0)];
                vertices[before].bulge = bulges[0];
                vertices[first] = Vertex::new(at.x, at.y, bulges[1]);
                is_dropped[last] = true;
            }
        }
    }
    let mut index = 0;
    vertices.retain(|_| {
        index += 1;
        !is_dropped[index - 1]
    });
}

/// Intersection of two pieces that are continued, one forward, the other backward. `None` if it is far away.
fn meeting([before, after]: &[Edge; 2]) -> Option<Point> {
    let (p, q) = (before.end, after.start);
    let gap = p.distance(q);
    // Straight on is near enough to begin with; then the circles themselves, by Newton's method.
    let mut at = p.midpoint(q);
    for _ in 0..20 {
        let (da, na) = offset(before, at);
        let (db, nb) = offset(after, at);
        let det = na.cross(nb);
        if det.abs() < 1e-3 {
            return None;
        }
        let step = (na.right() * db - nb.right() * da) * (1.0 / det);
        at += step;
        if !at.is_finite() || step.length() < 1e-15 * gap {
            break;
        }
    }
    let forward = before.end_direction().dot(at - p) >= 0.0;
    let backward = after.start_direction().dot(q - at) >= 0.0;
    let is_near = at.distance(p) < 2.0 * gap && at.distance(q) < 2.0 * gap;
    (forward && backward && is_near).then_some(at)
}

/// The distance of a point from the line or circle of a piece, and its gradient.
fn offset(piece: &Edge, at: Point) -> (f64, Vector) {
    if piece.is_line() {
        let normal = piece.start_direction().left();
        return (normal.dot(at - piece.end), normal);
    }
    let center = piece.center();
    let out = at - center;
    (out.length() - center.distance(piece.end), out.unit())
}

/// The bulge of a piece whose end (1) or start (0) is moved along it.
fn extended(piece: &Edge, at: Point, side: usize) -> f64 {
    if piece.is_line() {
        return 0.0;
    }
    let center = piece.center();
    let moved = if side == 1 { piece.end } else { piece.start };
    let (a, b) = (moved - center, at - center);
    let more = a.cross(b).atan2(a.dot(b));
    let sweep = piece.sweep() + if side == 1 { more } else { -more };
    (sweep / 4.0).tan()
}
