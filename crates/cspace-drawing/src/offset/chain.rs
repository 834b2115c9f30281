//! Pieces end to end, as loops.

use std::collections::{BTreeMap, HashMap};

use cspace::{Edge, Point, Vertex};
use rstar::RTree;
use rstar::primitives::GeomWithData;

use super::cut::{Piece, between};

/// A piece between two places.
#[derive(Debug, Clone, Copy)]
struct Link {
    raw: usize,
    whole: Edge,
    curve: Edge,
    from: usize,
    to: usize,
}

/// A loop, and where in it curves follow each other: the numbers of both and the place.
pub(super) struct Ring {
    pub(super) vertices: Vec<Vertex>,
    pub(super) joints: Vec<(usize, usize, Point)>,
}

/// The loops that the pieces make; what ends nowhere is left out.
pub(super) fn rings(pieces: &[Piece], near: f64) -> Vec<Ring> {
    let mut places = Places::default();
    let links: Vec<Link> = (pieces.iter())
        .map(|&Piece { raw, whole, curve }| {
            let [from, to] = [curve.start, curve.end].map(|p| places.number(p, near));
            Link {
                raw,
                whole,
                curve,
                from,
                to,
            }
        })
        .filter(|l| l.from != l.to || l.curve.length() > 4.0 * near)
        .collect();
    let links = without_ends(once(links, near), places.points.len());
    chained(&links, &places.points)
}

/// Places, those nearer than a length to one another as one.
#[derive(Default)]
struct Places {
    points: Vec<Point>,
    tree: RTree<GeomWithData<[f64; 2], usize>>,
}

impl Places {
    fn number(&mut self, p: Point, near: f64) -> usize {
        let at = [p.x, p.y];
        let nearest = (self.tree.nearest_neighbor(at)).filter(|n| {
            let [x, y] = *n.geom();
            Point::new(x, y).distance(p) <= near
        });
        if let Some(found) = nearest {
            return found.data;
        }
        let number = self.points.len();
        self.points.push(p);
        self.tree.insert(GeomWithData::new(at, number));
        number
    }
}

/// Removes repeated links: links that coincide are merged, and links of opposite directions, which have no space
/// between them, cancel.
fn once(links: Vec<Link>, near: f64) -> Vec<Link> {
    let mut between: BTreeMap<(usize, usize), Vec<Link>> = BTreeMap::new();
    for link in links {
        let ends = (link.from.min(link.to), link.from.max(link.to));
        between.entry(ends).or_default().push(link);
    }
    let mut kept = Vec::new();
    for group in between.into_values() {
        let mut different: Vec<(Link, i32)> = Vec::new();
        for link in group {
            let middle = link.curve.at(0.5);
            let same = (different.iter_mut())
                .find(|(l, _)| l.curve.at(0.5).distance(middle) <= 4.0 * near);
            match same {
                None => different.push((link, 1)),
                Some((first, count)) if first.from == link.from => *count += 1,
                Some((first, count)) => {
                    *count -= 1;
                    if *count < 0 {
                        (*first, *count) = (link, 1);
                    }
                }
            }
        }
        kept.extend(different.iter().filter(|d| d.1 > 0).map(|d| d.0));
    }
    kept.sort_by_key(|l| l.raw);
    kept
}

/// The links without those that end where no other begins, or begin where no other ends.
fn without_ends(mut links: Vec<Link>, places: usize) -> Vec<Link> {
    let [mut ins, mut outs] = [(); 2].map(|()| vec![0_u32; places]);
    for link in &links {
        outs[link.from] += 1;
        ins[link.to] += 1;
    }
    loop {
        let before = links.len();
        links.retain(|l| {
            let goes_on = ins[l.from] > 0 && outs[l.to] > 0;
            if !goes_on {
                outs[l.from] -= 1;
                ins[l.to] -= 1;
            }
            goes_on
        });
        if links.len() == before {
            return links;
        }
    }
}

/// The links one after the other.
fn chained(links: &[Link], points: &[Point]) -> Vec<Ring> {
    let mut next: HashMap<usize, Vec<usize>> = HashMap::new();
    for (i, link) in links.iter().enumerate().rev() {
        next.entry(link.from).or_default().push(i);
    }
    let mut is_used = vec![false; links.len()];
    let mut rings = Vec::new();
    for first in 0..links.len() {
        if is_used[first] {
            continue;
        }
        let mut chain = vec![first];
        is_used[first] = true;
        let mut at = links[first].to;
        while at != links[first].from {
            let free = next.get_mut(&at).and_then(Vec::pop);
            let Some(link) = free else { break };
            if !is_used[link] {
                is_used[link] = true;
                chain.push(link);
                at = links[link].to;
            }
        }
        if at == links[first].from {
            rings.push(ring(&chain, links, points));
        }
    }
    rings
}

/// The loop of a chain; pieces of one curve are made one.
fn ring(chain: &[usize], links: &[Link], points: &[Point]) -> Ring {
    let joined = |first: &Link, last: &Link| Link {
        curve: between(&first.whole, first.curve.start, last.curve.end),
        to: last.to,
        ..*first
    };
    let mut curves: Vec<Link> = Vec::with_capacity(chain.len());
    for link in chain.iter().map(|&i| links[i]) {
        match curves.last_mut() {
            Some(last) if last.raw == link.raw => *last = joined(last, &link),
            _ => curves.push(link),
        }
    }
    if let [first, .., last] = &mut curves[..]
        && first.raw == last.raw
    {
        *first = joined(last, first);
        curves.pop();
    }
    let vertices = (curves.iter())
        .map(|link| {
            let at = points[link.from];
            Vertex::new(at.x, at.y, link.curve.bulge)
        })
        .collect();
    let after = curves.iter().cycle().skip(1);
    let joints = (curves.iter().zip(after))
        .map(|(a, b)| (a.raw, b.raw, points[a.to]))
        .collect();
    Ring { vertices, joints }
}
