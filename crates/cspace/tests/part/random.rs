//! Properties of random parts.

use core::f64::consts::TAU;

use cspace::{Part, PartError, Point, Vertex};
use proptest::prelude::*;

use crate::backwards;

/// A loop around the origin: at each angle one vertex, between neighbours a line or an arc that bulges so little that it stays in the
/// sector of its two vertices.
///
/// As seen from the origin, an arc of sweep s meets its chord's end at the chord's angle minus s / 2; so s / 2 is kept below the angles of
/// the triangle of origin and chord.
fn star_shaped() -> impl Strategy<Value = Vec<Vertex>> {
    (4..40_usize).prop_flat_map(|n| {
        let spoke = (0.5..1.5_f64, 0.1..0.9_f64, -0.9..0.9_f64, any::<bool>());
        prop::collection::vec(spoke, n).prop_map(move |spokes| {
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
        })
    })
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

proptest! {
    #[test]
    fn star_shaped_loops_are_parts_in_both_directions(vertices in star_shaped()) {
        let part = Part::new("given", vec![vertices.clone()]).unwrap();
        let turned = Part::new("turned", vec![backwards(&vertices)]).unwrap();
        prop_assert!(!part.loops()[0].is_reversed());
        prop_assert!(turned.loops()[0].is_reversed());
        prop_assert!((part.area() - turned.area()).abs() <= 1e-14 * part.area());
        prop_assert!((part.loops()[0].signed_area() - part.area()).abs() <= 1e-14 * part.area());
    }

    #[test]
    fn area_is_the_measure_of_the_points_contained(vertices in star_shaped()) {
        let part = Part::new("given", vec![vertices]).unwrap();
        let counted = counted_area(&part, 200);
        // The boundary, under 12 sizes long, passes through about 12 · 200 of 40000 cells, each
        // miscounted by a fraction of either sign.
        prop_assert!((counted - part.area()).abs() < 0.01 * part.area());
    }

    #[test]
    fn place_and_size_do_not_matter(
        vertices in star_shaped(),
        angle in 0.0..TAU,
        exponent in -9..9_i32,
        far in -1e6..1e6_f64,
    ) {
        let scale = 10.0_f64.powi(exponent);
        let to = Point::new(far * scale, 0.3 * far * scale);
        let moved = placed(&vertices, angle, scale, to);
        let part = Part::new("given", vec![vertices]).unwrap();
        let moved = Part::new("moved", vec![moved]).unwrap();
        // 10⁶ lengths away coordinates are rounded to 10⁻¹⁰ lengths.
        prop_assert!((moved.area() / (scale * scale) - part.area()).abs() < 1e-8);
    }

    #[test]
    fn edges_have_material_on_the_left(
        vertices in star_shaped(),
        hole in star_shaped(),
        flips in any::<[bool; 3]>(),
    ) {
        let given = [
            placed(&hole, 1.0, 0.05, Point::new(0.02, -0.01)),
            vertices,
            placed(&hole, 2.0, 0.3, Point::new(4.0, 1.0)),
        ];
        let loops = given.iter().zip(flips).map(|(vertices, flip)| {
            if flip { backwards(vertices) } else { vertices.clone() }
        });
        let Ok(part) = Part::new("plate", loops.collect()) else {
            return Ok(()); // The hole is not inside.
        };
        for edge in part.edges() {
            let (p, left) = (edge.at(0.5), edge.direction_at(0.5).left() * 1e-9);
            prop_assert!(part.contains(p + left));
            prop_assert!(!part.contains(p + -left));
        }
    }

    #[test]
    fn two_vertices_exchanged_make_a_crossing(
        vertices in star_shaped(),
        i in 0..1000_usize,
        skip in 1..1000_usize,
    ) {
        let n = vertices.len();
        let (i, skip) = (i % n, 2 + skip % (n - 3));
        let mut lines: Vec<_> = vertices.iter().map(|v| Vertex::line(v.x, v.y)).collect();
        lines.swap(i, (i + skip) % n);
        if crosses_by_brute_force(&lines) {
            let error = Part::new("tangled", vec![lines]).unwrap_err();
            prop_assert!(matches!(error, PartError::Crossing { .. }), "{error}");
        } else {
            prop_assert!(Part::new("lucky", vec![lines]).is_ok());
        }
    }

    #[test]
    fn circles_are_accepted_when_none_cross(
        circles in prop::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64, 0.01..0.6_f64, 0.0..TAU), 2..12),
    ) {
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
                prop_assert_eq!(part.contains(p), depth % 2 == 1);
            }
            Err(error) => prop_assert!(matches!(error, PartError::Crossing { .. }), "{}", error),
        }
        prop_assert_eq!(made.is_err(), crossing);
    }
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
