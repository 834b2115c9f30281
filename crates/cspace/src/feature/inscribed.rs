//! Discs inside a part's material.

use core::f64::consts::TAU;

use super::material::{Material, in_frame};
use crate::geometry::{Point, Rotation, Vector};
use crate::parallel;
use crate::part::{Edge, Part};

/// Number of points tried along each side of the bounding box.
const GRID: usize = 12;
/// Number of edges above which no disc is searched: a search takes a tenth of a second.
const MOST_SEARCHED: usize = 1 << 17;
/// Number of rounds in which the step around the best point is halved.
const ROUNDS: usize = 8;

/// A large disc inside the material, in the pair's frame: centre and radius; `None` for thin parts.
///
/// Where the discs of two parts meet, the parts certainly overlap, and no contact needs to be examined.
pub(crate) fn inscribed_disc(part: &Part, center: Point, scale: f64) -> Option<(Point, f64)> {
    let edges = in_frame(part, center, scale);
    if edges.len() > MOST_SEARCHED {
        return None;
    }
    // Depth of a point inside the material, if it exceeds `than`; most points are near some edge, often the one nearest to the previous
    // point.
    let mut near = 0;
    let mut deeper = |p: Point, than: f64| {
        let mut least = f64::INFINITY;
        for i in core::iter::once(near).chain(0..edges.len()) {
            least = least.min(edges[i].distance(p));
            if least <= than {
                near = i;
                return None;
            }
        }
        let outer = center + (p - Point::ORIGIN) * (1.0 / scale);
        part.contains(outer).then_some(least)
    };
    let bounds = part.bounds();
    let [lo, hi] = [bounds.min, bounds.max].map(|p| Point::ORIGIN + (p - center) * scale);
    let mut best = (Point::ORIGIN, deeper(Point::ORIGIN, 0.0).unwrap_or(0.0));
    let mut consider = |p: Point, best: &mut (Point, f64)| {
        if let Some(d) = deeper(p, best.1 + 1e-9) {
            *best = (p, d);
        }
    };
    // The centre of a wheel cannot be improved much: the search is skipped if the disc fills a good part of the box.
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
    // The allowance is far above rounding.
    let radius = best.1 - 1e-9;
    (radius > 0.0).then_some((best.0, radius))
}

/// Fractions along an edge at which a disc touches it. Some are near the ends of the edges, where discs reach far into corners.
pub(crate) const SHARES: [f64; 7] = [0.5, 0.2, 0.8, 0.05, 0.95, 0.0125, 0.9875];

/// Discs inside the material that touch the edges, for each of the first [`SHARES`] along them: the largest first.
///
/// Parts with very many edges are examined at some of them only.
///
/// If turning by 2π/`fold` about `center` maps the part to itself, only edges of one sector are examined, and their discs turned.
pub(crate) fn inscribed_discs(
    part: &Part,
    center: Point,
    scale: f64,
    fold: u32,
    shares: usize,
) -> Vec<Vec<(Point, f64)>> {
    /// Number of halvings of the interval of the radius.
    const STEPS: usize = 14;
    /// Number of edges that are examined at most.
    const MOST_EDGES: usize = 1024;
    /// Edges examined at a time by one thread.
    const EDGES: usize = 16;
    let material = Material::new(part, center, scale);
    let step = TAU / f64::from(fold);
    let in_sector = |p: Point| {
        let angle = p.to_vector().angle() / step;
        fold == 1 || (0.0..1.0).contains(&angle)
    };
    let touching = |e: &Edge, share: f64| {
        let (p, inward) = (e.at(share), e.direction_at(share).left());
        let (mut lo, mut hi) = (0.0, 2.0);
        for _ in 0..STEPS {
            let r = 0.5 * (lo + hi);
            // Approximately a disc of this radius that touches at p.
            if material.is_clear(p + inward * r, 0.99 * r) {
                lo = r;
            } else {
                hi = r;
            }
        }
        let c = p + inward * lo;
        let radius = material.closest(c, f64::INFINITY, 1.0)?.1 - 1e-9;
        (radius > 0.0 && material.contains(c)).then_some((c, radius))
    };
    let sector: Vec<Edge> = (material.edges.iter().copied())
        .filter(|e| in_sector(e.at(0.5)))
        .collect();
    let every = (sector.len() * fold as usize).div_ceil(MOST_EDGES).max(1);
    let sector: Vec<Edge> = sector.into_iter().step_by(every).collect();
    let of_share = |share: &f64| {
        let touching = parallel::chunks(&sector, EDGES, |_, edges| -> Vec<_> {
            edges.iter().filter_map(|e| touching(e, *share)).collect()
        });
        let mut found: Vec<(Point, f64)> = (touching.into_iter().flatten())
            .flat_map(|(c, radius)| {
                (0..fold).map(move |j| (Rotation::by(step * f64::from(j)) * c, radius))
            })
            .collect();
        found.sort_by(|a, b| b.1.total_cmp(&a.1));
        found
    };
    SHARES.iter().take(shares).map(of_share).collect()
}
