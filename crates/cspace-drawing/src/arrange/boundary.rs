//! Loops around chosen faces.

use std::collections::HashMap;

use super::cycles::{Half, curve, origin, stars};
use super::faces::Faces;
use cspace::Point;

/// An edge of a loop around faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BoundaryEdge {
    pub(crate) start: Point,
    pub(crate) bulge: f64,
    /// The edge that was given, by number.
    pub(crate) edge: u32,
    /// Whether it is travelled from its end to its start.
    pub(crate) is_backward: bool,
}

/// The loops around the union of faces, with the faces on the left; pieces of one edge that follow each other are one again.
pub(crate) fn boundary(of: &Faces, chosen: &[usize]) -> Vec<Vec<BoundaryEdge>> {
    let mut is_in = vec![false; of.faces.len()];
    for &face in chosen {
        is_in[face] = true;
    }
    let is_chosen = |half: Half| of.face_of[half as usize].is_some_and(|face| is_in[face as usize]);
    let arrangement = &of.arrangement;
    let count = 2 * arrangement.pieces.len() as Half;
    let bounds: Vec<Half> = (0..count)
        .filter(|&half| is_chosen(half) && !is_chosen(half ^ 1))
        .collect();
    let mut next: HashMap<Half, Half> = HashMap::new();
    for around in stars(arrangement) {
        for (i, &out) in around.iter().enumerate() {
            let back = out ^ 1;
            if !is_chosen(back) || is_chosen(out) {
                continue;
            }
            // Clockwise from the way back, the first half-edge with chosen faces on one side alone.
            let n = around.len();
            let goes_on = (1..=n)
                .map(|k| around[(i + n - k) % n])
                .find(|&half| is_chosen(half) && !is_chosen(half ^ 1));
            next.extend(goes_on.map(|half| (back, half)));
        }
    }
    let mut loops = Vec::new();
    let mut is_done = vec![false; count as usize];
    for first in bounds {
        let mut halves = Vec::new();
        let mut half = Some(first);
        while let Some(h) = half.filter(|&h| !is_done[h as usize]) {
            is_done[h as usize] = true;
            halves.push(h);
            half = next.get(&h).copied();
        }
        if !halves.is_empty() {
            loops.push(merged(of, halves));
        }
    }
    loops
}

/// The loops around one face, as [`boundary`] gives them: its cycles.
pub(crate) fn around(of: &Faces, face: usize) -> Vec<Vec<BoundaryEdge>> {
    (of.faces[face].cycles.iter())
        .map(|&cycle| merged(of, of.cycles[cycle as usize].halves.clone()))
        .collect()
}

/// The edges of a loop of half-edges, those that go on along one given edge made one; a whole circle in two.
fn merged(of: &Faces, mut halves: Vec<Half>) -> Vec<BoundaryEdge> {
    let arrangement = &of.arrangement;
    let piece = |half: Half| &arrangement.pieces[half as usize / 2];
    let continues = |a: Half, b: Half| {
        let ([_, end], [start, _]) = match a % 2 {
            0 => (piece(a).span, piece(b).span),
            _ => (piece(b).span, piece(a).span),
        };
        piece(a).edge == piece(b).edge && a % 2 == b % 2 && end == start
    };
    let n = halves.len();
    if let Some(corner) = (0..n).find(|&i| !continues(halves[(i + n - 1) % n], halves[i])) {
        halves.rotate_left(corner);
    }
    (halves.chunk_by(|&a, &b| continues(a, b)))
        .flat_map(|run| {
            let quarters: f64 = run
                .iter()
                .map(|&h| curve(arrangement, h).bulge.atan())
                .sum();
            let start = |half: Half| arrangement.vertices[origin(arrangement, half) as usize];
            let (edge, is_backward) = (piece(run[0]).edge, run[0] % 2 == 1);
            let ends = [start(run[0]), start(run[run.len() - 1] ^ 1)];
            let whole = BoundaryEdge {
                start: ends[0],
                bulge: match run {
                    [one] => curve(arrangement, *one).bulge,
                    _ => quarters.tan(),
                },
                edge,
                is_backward,
            };
            // An arc that ends where it starts is no edge: its pieces are.
            match ends[0] == ends[1] {
                false => vec![whole],
                true => (run.iter())
                    .map(|&half| BoundaryEdge {
                        start: start(half),
                        bulge: curve(arrangement, half).bulge,
                        edge,
                        is_backward,
                    })
                    .collect(),
            }
        })
        .collect()
}
