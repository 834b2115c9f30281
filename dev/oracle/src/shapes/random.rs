//! Parts drawn at random.

use core::f64::consts::TAU;

use cspace::{Part, Point, Vertex};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::pen::{part, polar};
use crate::judge::least_gap;

/// Loop of `vertices` corners about the origin, at most 1 from it, with about `arcs` of its edges arcs.
///
/// It is deterministic for its arguments. Edges that are not adjacent are never closer than 0.02.
pub fn random_part(seed: u64, vertices: usize, arcs: f64) -> Part {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    part(
        format!("random {seed}"),
        vec![random_loop(&mut rng, vertices, arcs)],
    )
}

/// As [`random_part`], with a hole drawn the same way at half the number of corners.
pub fn random_ring(seed: u64, vertices: usize, arcs: f64) -> Part {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    loop {
        let outer = random_loop(&mut rng, vertices, arcs);
        let hole = random_loop(&mut rng, (vertices / 2).max(3), arcs);
        let loops = vec![outer, resized(&hole, Point::ORIGIN, 0.4)];
        if least_gap(&loops) > 0.02 {
            return part(format!("random ring {seed}"), loops);
        }
    }
}

/// A part of `pieces` pieces at most 1 from the origin, each drawn as [`random_part`].
pub fn random_pieces(seed: u64, pieces: usize, vertices: usize, arcs: f64) -> Part {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    loop {
        let loops: Vec<_> = (0..pieces)
            .map(|i| {
                let center = polar(Point::ORIGIN, 0.6, TAU * i as f64 / pieces as f64);
                resized(&random_loop(&mut rng, vertices, arcs), center, 0.4)
            })
            .collect();
        if least_gap(&loops) > 0.02 {
            return part(format!("random pieces {seed}"), loops);
        }
    }
}

fn resized(vertices: &[Vertex], center: Point, factor: f64) -> Vec<Vertex> {
    vertices
        .iter()
        .map(|v| Vertex::new(center.x + factor * v.x, center.y + factor * v.y, v.bulge))
        .collect()
}

fn random_loop(rng: &mut ChaCha8Rng, vertices: usize, arcs: f64) -> Vec<Vertex> {
    let step = TAU / vertices as f64;
    loop {
        let drawn: Vec<Vertex> = (0..vertices)
            .map(|i| {
                let angle = step * (i as f64 + rng.random_range(-0.35..0.35));
                let p = polar(Point::ORIGIN, rng.random_range(0.4..0.9), angle);
                let bulge = if rng.random_bool(arcs) {
                    let size = rng.random_range(0.1..1.2);
                    if rng.random_bool(0.6) { size } else { -size }
                } else {
                    0.0
                };
                Vertex::new(p.x, p.y, bulge)
            })
            .collect();
        if least_gap(core::slice::from_ref(&drawn)) > 0.02 && within(&drawn) {
            return drawn;
        }
    }
}

/// Whether the loop stays in the unit disc, tested at points of its edges.
fn within(vertices: &[Vertex]) -> bool {
    (0..vertices.len()).all(|i| {
        let (v, w) = (vertices[i], vertices[(i + 1) % vertices.len()]);
        // The middle of an arc is at bulge times half the chord from the chord.
        let chord = w.point() - v.point();
        let top = v.point().midpoint(w.point()) + chord.right() * (0.5 * v.bulge);
        top.to_vector().length() < 1.0
    })
}
