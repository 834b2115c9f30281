//! Discs inside a part's material.

use core::f64::consts::TAU;

use super::material::{Material, distance, in_frame};
use crate::geometry::{Point, Rotation, Vector};
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
            least = least.min(distance(&edges[i], p));
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

/// Number of discs that pay off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Plenty {
    /// A few that cover most of the material: for pairs with few contacts.
    Few,
    /// Also small ones in the corners of parts with few edges: for pairs with so many contacts that excluding each saves more.
    Many,
}

/// Number of discs above which they cost more than they save.
const MOST: usize = 64;
/// Number of edges above which a part has only one disc.
const MOST_EDGES: usize = 400;

impl Plenty {
    /// Fractions along an edge at which a disc touches it. For parts with few edges, some are near the ends of the edges, where discs reach
    /// far into corners.
    fn shares(self, edges: usize) -> &'static [f64] {
        const SHARES: [f64; 7] = [0.5, 0.2, 0.8, 0.05, 0.95, 0.0125, 0.9875];
        let each = match self {
            Self::Few => 1,
            Self::Many => (MOST / edges.max(1)).clamp(1, SHARES.len()),
        };
        &SHARES[..each]
    }
}

/// Discs inside the material, the largest first: each touches the boundary, at least at the middle of an edge. Discs that lie mostly within
/// another are left out.
///
/// If turning by 2π/`fold` about `center` maps the part to itself, only edges of one sector are examined, and their discs turned.
pub(crate) fn inscribed_discs(
    part: &Part,
    center: Point,
    scale: f64,
    largest: Option<(Point, f64)>,
    fold: u32,
    plenty: Plenty,
) -> Vec<(Point, f64)> {
    /// Number of halvings of the interval of the radius.
    const STEPS: usize = 14;
    let mut discs: Vec<(Point, f64)> = largest.into_iter().collect();
    if part.edges().count() > MOST_EDGES {
        return discs;
    }
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
    let shares = plenty.shares(material.edges.len());
    let mut found: Vec<(Point, f64)> = (material.edges.iter())
        .filter(|e| in_sector(e.at(0.5)))
        .flat_map(|e| shares.iter().filter_map(|&share| touching(e, share)))
        .flat_map(|(c, radius)| {
            (0..fold).map(move |j| (Rotation::by(step * f64::from(j)) * c, radius))
        })
        .collect();
    found.sort_by(|a, b| b.1.total_cmp(&a.1));
    for d in found {
        let covered = discs.iter().any(|o| o.0.distance(d.0) + 0.7 * d.1 < o.1);
        if !covered && discs.len() < MOST {
            discs.push(d);
        }
    }
    discs
}
