//! Properties of random parts.

use core::f64::consts::TAU;

use cspace::{Part, PartError, Point, Vertex};
use cspace_oracle::effort;
use rand::Rng;
use rand_chacha::ChaCha8Rng;

use super::backwards;
use crate::cases;

/// Number of random cases of each question.
const CASES: u64 = 256;

/// A loop around the origin: at each angle one vertex, between neighbours a line or an arc that bulges so little that it stays in the
/// sector of its two vertices.
///
/// As seen from the origin, an arc of sweep s meets its chord's end at the chord's angle minus s / 2; so s / 2 is kept below the angles of
/// the triangle of origin and chord.
fn star_shaped(rng: &mut ChaCha8Rng) -> Vec<Vertex> {
    let n = rng.random_range(4..40_usize);
    let spokes: Vec<(f64, f64, f64, bool)> = (0..n)
        .map(|_| {
            let (radius, shift) = (rng.random_range(0.5..1.5), rng.random_range(0.1..0.9));
            (
                radius,
                shift,
                rng.random_range(-0.9..0.9),
                rng.random_bool(0.5),
            )
        })
        .collect();
    let at = |i: usize| {
        let (radius, shift, ..) = spokes[i % n];
        let angle = TAU * ((i % n) as f64 + 0.5 * shift) / n as f64;
        Point::new(radius * angle.cos(), radius * angle.sin())
    };
    (0..n)
        .map(|i| {
            let (here, next) = (at(i), at(i + 1));
            let chord = next - here;
            let corner = |p: Point, way: f64| {
                let (to_origin, along) = (Point::ORIGIN - p, chord * way);
                to_origin.cross(along).abs().atan2(to_origin.dot(along))
            };
            let (_, _, share, arc) = spokes[i];
            let (a, b) = (corner(here, 1.0), corner(next, -1.0));
            // An outward arc must stay out of the extended spokes, an inward arc out of the spokes.
            let room = a.min(b).min(TAU / 2.0 - a).min(TAU / 2.0 - b);
            let bulge = if arc { (0.5 * share * room).tan() } else { 0.0 };
            Vertex::new(here.x, here.y, bulge)
        })
        .collect()
}

/// The loop turned by an angle, scaled and moved.
fn placed(vertices: &[Vertex], angle: f64, scale: f64, to: Point) -> Vec<Vertex> {
    let (sin, cos) = angle.sin_cos();
    vertices
        .iter()
        .map(|v| {
            let (x, y) = (cos * v.x - sin * v.y, sin * v.x + cos * v.y);
            Vertex::new(to.x + scale * x, to.y + scale * y, v.bulge)
        })
        .collect()
}

/// The share of a regular grid over the part's box that the part contains, as an area.
fn counted_area(part: &Part, steps: usize) -> f64 {
    let bounds = part.bounds();
    let (w, h) = (bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y);
    let inside = (0..steps * steps)
        .filter(|k| {
            let u = ((k % steps) as f64 + 0.5) / steps as f64;
            let v = ((k / steps) as f64 + 0.5) / steps as f64;
            part.contains(Point::new(bounds.min.x + u * w, bounds.min.y + v * h))
        })
        .count();
    w * h * inside as f64 / (steps * steps) as f64
}

#[test]
fn star_shaped_loops_are_parts_in_both_directions() {
    cases(CASES, |rng| {
        let vertices = star_shaped(rng);
        let part = Part::new("given", vec![vertices.clone()]).unwrap();
        let turned = Part::new("turned", vec![backwards(&vertices)]).unwrap();
        assert!(!part.loops()[0].is_reversed());
        assert!(turned.loops()[0].is_reversed());
        let area = part.area();
        assert!((area - turned.area()).abs() <= 1e-14 * area);
        assert!((part.loops()[0].signed_area() - area).abs() <= 1e-14 * area);
    });
}

#[test]
fn area_is_the_measure_of_the_points_contained() {
    cases(effort(20, CASES), |rng| {
        let part = Part::new("given", vec![star_shaped(rng)]).unwrap();
        let counted = counted_area(&part, 200);
        // The boundary, under 12 sizes long, passes through about 12 · 200 of 40000 cells, each
        // miscounted by a fraction of either sign.
        assert!((counted - part.area()).abs() < 0.01 * part.area());
    });
}

#[test]
fn place_and_size_do_not_matter() {
    cases(CASES, |rng| {
        let vertices = star_shaped(rng);
        let angle = rng.random_range(0.0..TAU);
        let scale = 10.0_f64.powi(rng.random_range(-9..9));
        let far = rng.random_range(-1e6..1e6);
        let to = Point::new(far * scale, 0.3 * far * scale);
        let moved = placed(&vertices, angle, scale, to);
        let part = Part::new("given", vec![vertices]).unwrap();
        let moved = Part::new("moved", vec![moved]).unwrap();
        // 10⁶ lengths away coordinates are rounded to 10⁻¹⁰ lengths.
        assert!((moved.area() / (scale * scale) - part.area()).abs() < 1e-8);
    });
}

#[test]
fn edges_have_material_on_the_left() {
    let mut asked = 0;
    cases(CASES, |rng| {
        let (vertices, hole) = (star_shaped(rng), star_shaped(rng));
        let given = [
            placed(&hole, 1.0, 0.05, Point::new(0.02, -0.01)),
            vertices,
            placed(&hole, 2.0, 0.3, Point::new(4.0, 1.0)),
        ];
        let loops = given.map(|vertices| match rng.random_bool(0.5) {
            true => backwards(&vertices),
            false => vertices,
        });
        let Ok(part) = Part::new("plate", loops.into()) else {
            return; // The hole is not inside.
        };
        asked += 1;
        for edge in part.edges() {
            let (p, left) = (edge.at(0.5), edge.direction_at(0.5).left() * 1e-9);
            assert!(part.contains(p + left));
            assert!(!part.contains(p + -left));
        }
    });
    assert!(2 * asked > CASES, "{asked}");
}

#[test]
fn two_vertices_exchanged_make_a_crossing() {
    cases(CASES, |rng| {
        let vertices = star_shaped(rng);
        let n = vertices.len();
        let (i, skip) = (rng.random_range(0..n), 2 + rng.random_range(0..n - 3));
        let mut lines: Vec<_> = vertices.iter().map(|v| Vertex::line(v.x, v.y)).collect();
        lines.swap(i, (i + skip) % n);
        if crosses_by_brute_force(&lines) {
            let error = Part::new("tangled", vec![lines]).unwrap_err();
            assert!(matches!(error, PartError::Crossing { .. }), "{error}");
        } else {
            assert!(Part::new("lucky", vec![lines]).is_ok());
        }
    });
}

#[test]
fn circles_are_accepted_when_none_cross() {
    cases(CASES, |rng| {
        let circles: Vec<(f64, f64, f64, f64)> = (0..rng.random_range(2..12))
            .map(|_| {
                let [x, y] = [0; 2].map(|_| rng.random_range(-1.0..1.0));
                (
                    x,
                    y,
                    rng.random_range(0.01..0.6),
                    rng.random_range(0.0..TAU),
                )
            })
            .collect();
        let crossing = circles.iter().enumerate().any(|(i, a)| {
            circles[..i].iter().any(|b| {
                let d = (a.0 - b.0).hypot(a.1 - b.1);
                d < a.2 + b.2 && d > (a.2 - b.2).abs()
            })
        });
        let loops = circles.iter().map(|&(x, y, r, angle)| {
            let (sin, cos) = angle.sin_cos();
            vec![
                Vertex::new(x + r * cos, y + r * sin, 1.0),
                Vertex::new(x - r * cos, y - r * sin, 1.0),
            ]
        });
        let made = Part::new("circles", loops.collect());
        match &made {
            Ok(part) => {
                let p = Point::new(0.1, 0.2);
                let depth = circles
                    .iter()
                    .filter(|c| (c.0 - p.x).hypot(c.1 - p.y) < c.2)
                    .count();
                assert_eq!(part.contains(p), depth % 2 == 1);
            }
            Err(error) => assert!(matches!(error, PartError::Crossing { .. }), "{error}"),
        }
        assert_eq!(made.is_err(), crossing);
    });
}

fn crosses_by_brute_force(vertices: &[Vertex]) -> bool {
    let n = vertices.len();
    let at = |i: usize| vertices[i % n].point();
    let turn = |a: Point, b: Point, c: Point| (b - a).cross(c - a) > 0.0;
    (0..n).any(|i| {
        (i + 2..n + i - 1).any(|j| {
            let (a, b, c, d) = (at(i), at(i + 1), at(j), at(j + 1));
            turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b)
        })
    })
}
