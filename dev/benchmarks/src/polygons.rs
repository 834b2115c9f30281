//! Parts as polygons: what tools without arcs are given.

use cspace::{Edge, Part, Point, Rotation};

/// A loop of corners, material on the left.
pub(crate) type Ring = Vec<Point>;

/// The loops of a part, arcs replaced by chords no farther than `chord` from them.
pub(crate) fn rings(part: &Part, chord: f64) -> Vec<Ring> {
    let ring = |l: &cspace::Loop| {
        let mut ring = Vec::new();
        for e in l.edges() {
            chords(&e, chord, &mut ring);
        }
        ring
    };
    part.loops().iter().map(ring).collect()
}

/// The start of an edge and points along it.
fn chords(e: &Edge, chord: f64, ring: &mut Ring) {
    ring.push(e.start);
    if e.is_line() {
        return;
    }
    // A chord of angle α is r (1 − cos α/2) from its arc.
    let share = (1.0 - chord / e.radius()).max(-1.0);
    let pieces = (e.sweep().abs() / (2.0 * share.acos())).ceil().max(1.0);
    let (center, arm) = (e.center(), e.start - e.center());
    for k in 1..pieces as usize {
        ring.push(center + Rotation::by(e.sweep() * k as f64 / pieces) * arm);
    }
}

/// Twice the area that a ring goes around counter-clockwise.
fn doubled_area(ring: &Ring) -> f64 {
    let n = ring.len();
    let side = |i: usize| {
        let (p, q) = (ring[i].to_vector(), ring[(i + 1) % n].to_vector());
        p.cross(q)
    };
    (0..n).map(side).sum()
}

fn contains(ring: &Ring, p: Point) -> bool {
    let n = ring.len();
    let crosses = |i: usize| {
        let (a, b) = (ring[i], ring[(i + 1) % n]);
        (a.y > p.y) != (b.y > p.y) && a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x
    };
    (0..n).filter(|&i| crosses(i)).count() % 2 == 1
}

/// Outer rings, each with the holes in it.
pub(crate) fn pieces(rings: &[Ring]) -> Vec<Vec<&Ring>> {
    let (outer, holes): (Vec<&Ring>, Vec<&Ring>) =
        rings.iter().partition(|r| doubled_area(r) > 0.0);
    let mut pieces: Vec<Vec<&Ring>> = outer.into_iter().map(|r| vec![r]).collect();
    for hole in holes {
        let around = pieces.iter_mut().filter(|p| contains(p[0], hole[0]));
        let smallest = around.min_by(|a, b| doubled_area(a[0]).total_cmp(&doubled_area(b[0])));
        if let Some(piece) = smallest {
            piece.push(hole);
        }
    }
    pieces
}
