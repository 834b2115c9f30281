//! Boundaries of the faces of an arrangement.

use cspace::{Edge, Point};

use super::split::Arrangement;

/// Half-edge: twice its piece's number for the direction from its start to its end, plus one for the opposite
/// direction.
pub(super) type Half = u32;

/// Half-edges around one face or one component, with the face on the left.
#[derive(Debug)]
pub(super) struct Cycle {
    pub(super) halves: Vec<Half>,
    /// Positive where the cycle turns left about the face that it bounds; negative where it is the outside of a component.
    pub(super) area: f64,
}

/// The cycles of an arrangement, without the pieces that have one face on both sides: those bound nothing.
pub(super) fn cycles(arrangement: &mut Arrangement) -> Vec<Cycle> {
    let all = follow(arrangement);
    let mut cycle_of = vec![0u32; 2 * arrangement.pieces.len()];
    for (number, halves) in all.iter().enumerate() {
        for &half in halves {
            cycle_of[half as usize] = number as u32;
        }
    }
    let mut sides = cycle_of.chunks_exact(2);
    let before = arrangement.pieces.len();
    (arrangement.pieces).retain(|_| sides.next().is_some_and(|s| s[0] != s[1]));
    let halves = match arrangement.pieces.len() == before {
        true => all,
        false => follow(arrangement),
    };
    (halves.into_iter())
        .map(|halves| Cycle {
            area: area(arrangement, &halves),
            halves,
        })
        .collect()
}

/// The vertex at which a half-edge starts.
pub(super) fn origin(arrangement: &Arrangement, half: Half) -> u32 {
    arrangement.pieces[half as usize / 2].ends[half as usize % 2]
}

/// A half-edge as a curve in its direction.
pub(super) fn curve(arrangement: &Arrangement, half: Half) -> Edge {
    let curve = arrangement.curve(&arrangement.pieces[half as usize / 2]);
    match half % 2 {
        0 => curve,
        _ => curve.reversed(),
    }
}

fn area(arrangement: &Arrangement, halves: &[Half]) -> f64 {
    let about = (halves.first()).map_or(Point::ORIGIN, |&h| curve(arrangement, h).start);
    (halves.iter())
        .map(|&h| curve(arrangement, h).area_swept(about))
        .sum()
}

/// Cycles of half-edges: each is followed by the one next to the right of its reverse at its end.
fn follow(arrangement: &Arrangement) -> Vec<Vec<Half>> {
    let count = 2 * arrangement.pieces.len();
    let mut next: Vec<Half> = vec![0; count];
    for around in stars(arrangement) {
        for (i, &out) in around.iter().enumerate() {
            // Counter-clockwise around the vertex; what is next clockwise to the way back keeps the face on the left.
            next[(out ^ 1) as usize] = around[(i + around.len() - 1) % around.len()];
        }
    }
    let mut is_done = vec![false; count];
    let mut cycles = Vec::new();
    for first in 0..count as Half {
        let mut halves = Vec::new();
        let mut half = first;
        while !core::mem::replace(&mut is_done[half as usize], true) {
            halves.push(half);
            half = next[half as usize];
        }
        if !halves.is_empty() {
            cycles.push(halves);
        }
    }
    cycles
}

/// Half-edges that leave each vertex, in counter-clockwise order.
///
/// They are ordered where they leave a circle about the vertex, of half the shortest chord there, so that tangent ones
/// are distinguished by their curvature: at distance r an arc has turned by asin(κ r / 2) from its tangent.
pub(super) fn stars(arrangement: &Arrangement) -> Vec<Vec<Half>> {
    let mut stars: Vec<Vec<Half>> = vec![Vec::new(); arrangement.vertices.len()];
    for half in 0..2 * arrangement.pieces.len() as Half {
        stars[origin(arrangement, half) as usize].push(half);
    }
    for around in stars.iter_mut().filter(|s| s.len() > 1) {
        let curves: Vec<Edge> = around.iter().map(|&h| curve(arrangement, h)).collect();
        let radius = 0.5
            * (curves.iter())
                .map(|c| c.start.distance(c.end))
                .fold(f64::INFINITY, f64::min);
        let mut order: Vec<(f64, Half)> = (curves.iter().zip(around.iter()))
            .map(|(c, &half)| {
                let tangent = c.start_direction();
                let turn = (0.5 * radius * c.curvature()).clamp(-1.0, 1.0).asin();
                let angle = tangent.y.atan2(tangent.x) + turn;
                (angle.sin().atan2(angle.cos()), half)
            })
            .collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        around.clear();
        around.extend(order.into_iter().map(|(_, half)| half));
    }
    stars
}
