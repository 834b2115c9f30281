//! Outlines at a distance, against closed forms and against their definition: what is within the distance of the material.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use cspace::{Part, Point, Vertex};
use cspace_drawing::{OffsetError, offset};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn grown(part: &Part, by: f64) -> Part {
    let made = offset(part, by, false).unwrap_or_else(|e| panic!("{by}: {e}"));
    assert_eq!(made.changes, [""; 0]);
    made.part
}

fn perimeter(part: &Part) -> f64 {
    part.edges().map(|e| e.length()).sum()
}

fn polygon(corners: &[(f64, f64)]) -> Part {
    Part::polygon("p", corners).unwrap()
}

fn circle(x: f64, y: f64, r: f64) -> Vec<Vertex> {
    vec![Vertex::new(x - r, y, 1.0), Vertex::new(x + r, y, 1.0)]
}

fn near(found: f64, expected: f64) {
    let slack = 1e-13 * expected.abs().max(1.0);
    assert!((found - expected).abs() <= slack, "{found}, not {expected}");
}

#[test]
fn coordinates_of_a_rectangle_are_exact() {
    let plate = polygon(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0), (0.0, 5.0)]);
    let larger = grown(&plate, 0.1);
    let at: Vec<(f64, f64)> = (larger.loops()[0].vertices().iter())
        .map(|v| (v.x, v.y))
        .collect();
    assert_eq!(
        at,
        [
            (0.0, -0.1),
            (10.0, -0.1),
            (10.1, 0.0),
            (10.1, 5.0),
            (10.0, 5.1),
            (0.0, 5.1),
            (-0.1, 5.0),
            (-0.1, 0.0)
        ]
    );
    let smaller = grown(&plate, -0.1);
    let at: Vec<(f64, f64)> = (smaller.loops()[0].vertices().iter())
        .map(|v| (v.x, v.y))
        .collect();
    assert_eq!(at, [(0.1, 0.1), (9.9, 0.1), (9.9, 4.9), (0.1, 4.9)]);
    // There and back is where it was.
    assert_eq!(grown(&larger, -0.1).loops().len(), 1);
    near(grown(&larger, -0.1).area(), 50.0);
}

/// Steiner's formula of convex parts, and what strips along edges of others have twice or not at all.
#[test]
fn areas_are_those_of_closed_forms() {
    let d = 0.3;
    let triangle = polygon(&[(0.0, 0.0), (7.0, 1.0), (2.0, 5.0)]);
    let stadium = Part::slot("s", (0.0, 0.0), (6.0, 2.0), 3.0).unwrap();
    for part in [&triangle, &stadium] {
        let area = part.area() + perimeter(part) * d + PI * d * d;
        near(grown(part, d).area(), area);
    }
    near(
        grown(&stadium, -d).area(),
        stadium.area() - perimeter(&stadium) * d + PI * d * d,
    );
    let ell = polygon(&[
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 2.0),
        (2.0, 2.0),
        (2.0, 5.0),
        (0.0, 5.0),
    ]);
    let (area, strip, square) = (ell.area(), perimeter(&ell) * d, d * d);
    near(
        grown(&ell, d).area(),
        area + strip + 5.0 * FRAC_PI_4 * square - square,
    );
    near(
        grown(&ell, -d).area(),
        area - strip + 5.0 * square - FRAC_PI_4 * square,
    );
    let ring = Part::new("r", vec![circle(1.0, 2.0, 5.0), circle(1.0, 2.0, 3.0)]).unwrap();
    near(
        grown(&ring, d).area(),
        PI * (5.3_f64.powi(2) - 2.7_f64.powi(2)),
    );
    near(
        grown(&ring, -d).area(),
        PI * (4.7_f64.powi(2) - 3.3_f64.powi(2)),
    );
    assert_eq!(offset(&ring, -1.0, true), Err(OffsetError::Nothing));
}

#[test]
fn holes_that_close_are_told() {
    let plate = |hole: Vec<Vertex>| {
        let outer = vec![(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)];
        let outer = outer.into_iter().map(|(x, y)| Vertex::line(x, y)).collect();
        Part::new("plate", vec![outer, hole]).unwrap()
    };
    let slot = [(4.0, 2.0), (6.0, 2.0), (6.0, 6.0), (4.0, 6.0)];
    let slot = slot.map(|(x, y)| Vertex::line(x, y)).to_vec();
    // A slot of twice the distance closes as well.
    for (hole, by) in [
        (circle(4.0, 4.0, 0.5), 0.6),
        (slot.clone(), 1.0),
        (slot, 1.1),
    ] {
        let made = offset(&plate(hole), by, false).unwrap();
        near(made.part.area(), 81.0 + 36.0 * by + PI * by * by);
        assert_eq!(made.changes, ["1 hole becomes 0"]);
    }
}

#[test]
fn a_gap_that_closes_leaves_a_hole() {
    // A ring with a gap of 0.5.
    let c = polygon(&[
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 2.75),
        (4.0, 2.75),
        (4.0, 2.0),
        (2.0, 2.0),
        (2.0, 4.0),
        (4.0, 4.0),
        (4.0, 3.25),
        (6.0, 3.25),
        (6.0, 6.0),
        (0.0, 6.0),
    ]);
    let made = offset(&c, 0.3, false).unwrap();
    assert_eq!(made.changes, ["0 holes become 1"]);
    assert_eq!(made.part.loops().len(), 2);
}

#[test]
fn a_part_that_falls_apart_is_an_error_that_says_where() {
    let dumbbell = polygon(&[
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 1.5),
        (6.0, 1.5),
        (6.0, 0.0),
        (10.0, 0.0),
        (10.0, 4.0),
        (6.0, 4.0),
        (6.0, 2.5),
        (4.0, 2.5),
        (4.0, 4.0),
        (0.0, 4.0),
    ]);
    let Err(OffsetError::Apart { what, at, .. }) = offset(&dumbbell, -0.6, false) else {
        panic!("it does not hold together");
    };
    assert_eq!(what, "1 piece becomes 2");
    let at = at.unwrap();
    assert!(
        (3.4..=6.6).contains(&at.x) && (1.4..=2.6).contains(&at.y),
        "{at:?}"
    );
    let part = offset(&dumbbell, -0.6, true).unwrap().part;
    assert_eq!(part.loops().len(), 2);
    // Two squares, each with what is beyond the circles about the corners of the bridge.
    let (r, h) = (0.6_f64, 0.5_f64);
    let under = (h * (r * r - h * h).sqrt() + r * r * (h / r).asin()) / 2.0;
    near(part.area(), 2.0 * (2.8 * 2.8 + 2.0 * (r * h - under)));
    // A hole that opens to the outside.
    let outer = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
    let outer = outer.map(|(x, y)| Vertex::line(x, y)).to_vec();
    let plate = Part::new("plate", vec![outer, circle(8.5, 5.0, 1.0)]).unwrap();
    let error = offset(&plate, -0.3, false).unwrap_err();
    assert!(error.to_string().contains("1 hole becomes 0"), "{error}");
    let part = offset(&plate, -0.3, true).unwrap().part;
    // The disc less the segment beyond the side.
    let half = (1.2_f64 / 1.3).acos();
    let segment = 1.3 * 1.3 * (half - half.sin() * half.cos());
    near(part.area(), 9.4 * 9.4 - (PI * 1.3 * 1.3 - segment));
    assert!(matches!(
        offset(&plate, f64::NAN, false),
        Err(OffsetError::NoNumber(_))
    ));
    for by in [1e300, -1e300] {
        let error = offset(&plate, by, false);
        assert!(matches!(error, Err(OffsetError::TooFar(_))), "{error:?}");
    }
}

/// A wheel of teeth with rounded tips and roots, there and back.
#[test]
fn a_rounded_outline_comes_back() {
    let teeth = 24;
    let vertices: Vec<Vertex> = (0..2 * teeth)
        .map(|k| {
            let at = f64::from(k) * PI / f64::from(teeth);
            let p = Point::new(30.0 * at.cos(), 30.0 * at.sin());
            // Half circles in turn outward and inward, which meet at tangents all but square.
            Vertex::new(p.x, p.y, if k % 2 == 0 { 1.0 } else { -0.8 })
        })
        .collect();
    let wheel = Part::new("wheel", vec![vertices]).unwrap();
    for by in [0.2, -0.2, 0.7, -0.7] {
        let part = grown(&wheel, by);
        for edge in part.edges() {
            for share in [0.0, 0.3, 0.5, 1.0] {
                let p = edge.at(share);
                let distance = distance(&wheel, p);
                assert!((distance - by.abs()).abs() < 1e-11, "{by}: {distance}");
            }
        }
    }
    let smooth = Part::slot("s", (0.0, 0.0), (6.0, 2.0), 3.0).unwrap();
    let back = grown(&grown(&smooth, 0.4), -0.4);
    for (a, b) in smooth.edges().zip(back.edges()) {
        assert!(a.start.distance(b.start) < 1e-14 && (a.bulge - b.bulge).abs() < 1e-14);
    }
}

fn distance(part: &Part, p: Point) -> f64 {
    let distances = part.edges().map(|e| e.distance(p));
    distances.fold(f64::INFINITY, f64::min)
}

/// A random star of lines and arcs, perhaps with a hole.
fn random(rng: &mut ChaCha8Rng) -> Option<Part> {
    let n = rng.random_range(4..14);
    let turn = rng.random_range(0.0..TAU);
    let star: Vec<Vertex> = (0..n)
        .map(|k| {
            let at = turn + TAU * f64::from(k) / f64::from(n);
            // Round numbers make outlines that touch and coincide.
            let r = f64::from(rng.random_range(2..9));
            let bulge = [0.0, 0.0, 0.3, -0.3, 1.0, 2.5, 1e-7][rng.random_range(0..7)];
            Vertex::new(r * at.cos(), r * at.sin(), bulge)
        })
        .collect();
    let mut loops = vec![star];
    if rng.random_range(0..3) == 0 {
        loops.push(circle(0.0, 0.0, rng.random_range(0.2..1.5)));
    }
    Part::new("random", loops).ok()
}

#[test]
fn random_outlines_are_what_the_definition_says() {
    let mut rng = ChaCha8Rng::seed_from_u64(42);
    let mut made = 0;
    while made < 600 {
        let Some(part) = random(&mut rng) else {
            continue;
        };
        let by = [0.01, 0.25, 0.5, 1.0, 2.0, -0.01, -0.25, -0.5, -1.0][rng.random_range(0..9)];
        let result = match offset(&part, by, true) {
            Ok(result) => result.part,
            Err(OffsetError::Nothing) => {
                let mut points = (0..500).map(|_| random_point(&mut rng));
                let is_thin =
                    by < 0.0 && points.all(|p| !part.contains(p) || distance(&part, p) <= -by);
                assert!(is_thin, "{part:?} by {by}");
                continue;
            }
            Err(error) => panic!("{error}: {part:?} by {by}"),
        };
        made += 1;
        for _ in 0..200 {
            let p = random_point(&mut rng);
            let away = distance(&part, p);
            if (away - by.abs()).abs() < 1e-9 {
                continue;
            }
            let expected = match by > 0.0 {
                true => part.contains(p) || away < by,
                false => part.contains(p) && away > -by,
            };
            assert_eq!(result.contains(p), expected, "{part:?} by {by} at {p:?}");
        }
    }
}

fn random_point(rng: &mut ChaCha8Rng) -> Point {
    Point::new(rng.random_range(-11.0..11.0), rng.random_range(-11.0..11.0))
}
