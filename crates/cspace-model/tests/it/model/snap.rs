//! Arcs are made tangent to lines, by arithmetic: what was tangent before its numbers were rounded is again.

use core::f64::consts::PI;

use cspace::{Edge, Part, Vertex};
use cspace_model::PartEntry;
use cspace_model::model::{slips, snap};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The largest angle by which a line and an arc miss each other that meet within 0.01 rad.
fn missed(part: &Part) -> f64 {
    let mut most = 0.0f64;
    for l in part.loops() {
        let edges: Vec<Edge> = l.edges().collect();
        for (a, b) in edges.iter().zip(edges.iter().cycle().skip(1)) {
            let (d, e) = (a.end_direction(), b.start_direction());
            let turn = d.cross(e).atan2(d.dot(e)).abs();
            if a.is_line() != b.is_line() && turn < 0.01 {
                most = most.max(turn);
            }
        }
    }
    most
}

fn mechanism(part: Part) -> cspace_model::Mechanism {
    let mut mechanism = cspace_model::Mechanism::new("m");
    mechanism.parts.push(PartEntry::planar(part));
    mechanism
}

/// Polygon about the origin with rounded corners of random radii, its numbers cut to some digits.
fn rounded_polygon(rng: &mut ChaCha8Rng, digits: f64, reversed: bool) -> Part {
    let n = rng.random_range(3..9);
    let corner = |k: usize, r: f64| {
        let a = 2.0 * PI * k as f64 / n as f64;
        (r * a.cos(), r * a.sin())
    };
    let corners: Vec<(f64, f64)> = (0..n)
        .map(|k| corner(k, rng.random_range(8.0..12.0)))
        .collect();
    let mut pen = cspace::OutlineBuilder::start(corners[0]);
    for &c in &corners[1..] {
        pen = pen.line_to(c).fillet(rng.random_range(0.5..1.2));
    }
    let cut = |x: f64| (x * digits).round() / digits;
    let mut outline: Vec<Vertex> = (pen.close().unwrap().into_iter())
        .map(|v| Vertex::new(cut(v.x), cut(v.y), cut(v.bulge)))
        .collect();
    if reversed {
        let bulges: Vec<f64> = outline.iter().map(|v| v.bulge).collect();
        let n = outline.len();
        outline = (0..n)
            .rev()
            .map(|k| Vertex {
                bulge: -bulges[(k + n - 1) % n],
                ..outline[k]
            })
            .collect();
    }
    Part::new("polygon", vec![outline]).unwrap()
}

#[test]
fn rounded_corners_are_tangent_again() {
    let mut rng = ChaCha8Rng::seed_from_u64(22);
    let mut joints = 0;
    for k in 0..200 {
        let part = rounded_polygon(&mut rng, 1e4, k % 2 == 1);
        let before = missed(&part);
        let model = mechanism(part);
        let (snapped, done) = snap(&model);
        let after = &snapped.parts[0].part;
        assert!(
            missed(after) < 1e-9 || before > 1e-3,
            "{k}: {before:e} to {:e}",
            missed(after)
        );
        if let [what] = &done[..] {
            joints += what.joints;
            assert!(what.moved < 1e-3 * after.size());
            for (a, b) in model.parts[0].part.loops()[0]
                .vertices()
                .iter()
                .zip(after.loops()[0].vertices())
            {
                assert!(a.point().distance(b.point()) <= what.moved);
            }
        }
        // What is tangent stays as it is.
        if missed(after) < 1e-9 {
            assert_eq!(slips(&snapped).len(), 0);
            assert_eq!(snap(&snapped), (snapped, Vec::new()));
        }
    }
    assert!(joints > 800, "{joints}");
}

#[test]
fn an_arc_that_continues_one_line_keeps_its_ends() {
    // A quarter of a circle from the line's end, with a bulge of too few digits; its other end is a corner.
    let bulge = (2.0_f64.sqrt() - 1.0) + 2e-4;
    let outline = vec![
        Vertex::line(0.0, 0.0),
        Vertex::new(5.0, 0.0, bulge),
        Vertex::line(7.0, 2.0),
        Vertex::line(0.0, 6.0),
    ];
    let model = mechanism(Part::new("hook", vec![outline.clone()]).unwrap());
    let (snapped, done) = snap(&model);
    assert_eq!(done[0].joints, 1);
    let vertices = snapped.parts[0].part.loops()[0].vertices();
    assert!((vertices[1].bulge - (2.0_f64.sqrt() - 1.0)).abs() < 1e-15);
    assert!(
        vertices
            .iter()
            .zip(&outline)
            .all(|(a, b)| a.point() == b.point())
    );
}
