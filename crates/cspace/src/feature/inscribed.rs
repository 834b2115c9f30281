//! A disc inside a part's material.

use core::f64::consts::TAU;

use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Edge, Part};

/// Points tried along each side of the bounding box.
const GRID: usize = 12;
/// Of parts with more edges no disc is sought.
const MOST_SEARCHED: usize = 4000;
/// Rounds of halving the step around the best point.
const ROUNDS: usize = 8;

/// A large disc inside the material, in the pair's frame: centre and radius; none is found in parts that are thin.
///
/// Where the discs of two parts meet, the parts overlap for certain, and nothing there needs to be looked at.
pub(crate) fn inscribed_disc(part: &Part, center: Point, scale: f64) -> Option<(Point, f64)> {
    let edges = in_frame(part, center, scale);
    if edges.len() > MOST_SEARCHED {
        return None;
    }
    // How deep inside a point is, if that is more than some depth; most points are near to some edge.
    let deeper = |p: Point, than: f64| {
        let mut least = f64::INFINITY;
        for e in &edges {
            least = least.min(distance(e, p));
            if least <= than {
                return None;
            }
        }
        let outer = center + (p - Point::ORIGIN) * (1.0 / scale);
        part.contains(outer).then_some(least)
    };
    let bounds = part.bounds();
    let [lo, hi] = [bounds.min, bounds.max].map(|p| Point::ORIGIN + (p - center) * scale);
    let mut best = (Point::ORIGIN, deeper(Point::ORIGIN, 0.0).unwrap_or(0.0));
    let consider = |p: Point, best: &mut (Point, f64)| {
        if let Some(d) = deeper(p, best.1 + 1e-9) {
            *best = (p, d);
        }
    };
    // The centre of a wheel cannot be bettered by much: skip the search when it fills a good part of the box.
    let step = 0.5 * (hi - lo).length() / GRID as f64;
    if best.1 < 0.5 * (hi.x - lo.x).min(hi.y - lo.y) * 0.6 {
        for i in 0..=GRID {
            for j in 0..=GRID {
                let s = |k: usize| (k as f64 + 0.37) / (GRID as f64 + 0.74);
                let p = Point::new(lo.x + (hi.x - lo.x) * s(i), lo.y + (hi.y - lo.y) * s(j));
                consider(p, &mut best);
            }
        }
        let mut step = step;
        for _ in 0..ROUNDS {
            let at = best.0;
            for d in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                consider(at + Vector::new(d.0, d.1) * step, &mut best);
            }
            step *= 0.6;
        }
    }
    // Rounding is far below this allowance.
    let radius = best.1 - 1e-9;
    (radius > 0.0).then_some((best.0, radius))
}

/// Discs inside the material, the largest first: one that touches the boundary at the middle of each edge, without
/// those that lie mostly within another.
///
/// If turning by 2π/`fold` about `center` maps the part to itself, only edges of one sector are looked at, and their
/// discs turned.
pub(crate) fn inscribed_discs(
    part: &Part,
    center: Point,
    scale: f64,
    largest: Option<(Point, f64)>,
    fold: u32,
) -> Vec<(Point, f64)> {
    /// More discs than this cost more than they save.
    const MOST: usize = 64;
    /// Parts with more edges are left with the one disc.
    const MOST_EDGES: usize = 400;
    /// Halvings of the radius's interval.
    const STEPS: usize = 14;
    let edges = in_frame(part, center, scale);
    let mut discs: Vec<(Point, f64)> = largest.into_iter().collect();
    if edges.len() > MOST_EDGES {
        return discs;
    }
    let clearance = |p: Point| {
        edges
            .iter()
            .map(|e| distance(e, p))
            .fold(f64::INFINITY, f64::min)
    };
    let clear = |p: Point, by: f64| edges.iter().all(|e| distance(e, p) >= by);
    let step = TAU / f64::from(fold);
    let in_sector = |p: Point| {
        let angle = p.to_vector().angle() / step;
        fold == 1 || (0.0..1.0).contains(&angle)
    };
    let mut found: Vec<(Point, f64)> = Vec::new();
    for e in edges.iter().filter(|e| in_sector(e.at(0.5))) {
        let (p, inward) = (e.at(0.5), e.direction_at(0.5).left());
        let (mut lo, mut hi) = (0.0, 2.0);
        for _ in 0..STEPS {
            let r = 0.5 * (lo + hi);
            // A disc of this radius that touches at p, give or take.
            if clear(p + inward * r, 0.99 * r) {
                lo = r;
            } else {
                hi = r;
            }
        }
        let c = p + inward * lo;
        let outer = center + (c - Point::ORIGIN) * (1.0 / scale);
        let radius = clearance(c) - 1e-9;
        if radius > 0.0 && part.contains(outer) {
            let turned = |j| Rotation::by(step * f64::from(j)) * c;
            found.extend((0..fold).map(|j| (turned(j), radius)));
        }
    }
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    for d in found {
        let covered = discs.iter().any(|o| o.0.distance(d.0) + 0.7 * d.1 < o.1);
        if !covered && discs.len() < MOST {
            discs.push(d);
        }
    }
    discs
}

fn in_frame(part: &Part, center: Point, scale: f64) -> Vec<Edge> {
    let place = |p: Point| Point::ORIGIN + (p - center) * scale;
    part.edges()
        .map(|e| Edge {
            start: place(e.start),
            end: place(e.end),
            ..e
        })
        .collect()
}

/// Distance of a point from an edge.
fn distance(edge: &Edge, p: Point) -> f64 {
    let ends = p.distance(edge.start).min(p.distance(edge.end));
    let chord = edge.end - edge.start;
    if edge.is_line() {
        let s = (p - edge.start).dot(chord);
        let len2 = chord.length_squared();
        if s <= 0.0 || s >= len2 {
            return ends;
        }
        return chord.cross(p - edge.start).abs() / len2.sqrt();
    }
    let c = edge.center();
    let v = p - c;
    let (mut from, mut to) = (edge.start - c, edge.end - c);
    if edge.bulge < 0.0 {
        core::mem::swap(&mut from, &mut to);
    }
    let inside = if edge.bulge.abs() <= 1.0 {
        from.cross(v) >= 0.0 && v.cross(to) >= 0.0
    } else {
        from.cross(v) >= 0.0 || v.cross(to) >= 0.0
    };
    if inside {
        (v.length() - edge.radius()).abs()
    } else {
        ends
    }
}
