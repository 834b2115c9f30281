use core::f64::consts::PI;

use cspace::{Edge, Part, Point, Vertex};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{Faces, around, boundary, split};

const NEAR: f64 = 1e-7;

fn edge(a: (f64, f64), b: (f64, f64), bulge: f64) -> Edge {
    Edge {
        start: a.into(),
        end: b.into(),
        bulge,
        index: 0,
    }
}

fn polygon(corners: &[(f64, f64)]) -> Vec<Edge> {
    (0..corners.len())
        .map(|i| edge(corners[i], corners[(i + 1) % corners.len()], 0.0))
        .collect()
}

fn rectangle(x: [f64; 2], y: [f64; 2]) -> Vec<Edge> {
    polygon(&[(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])])
}

fn circle(x: f64, y: f64, r: f64) -> Vec<Edge> {
    vec![
        edge((x - r, y), (x + r, y), 1.0),
        edge((x + r, y), (x - r, y), 1.0),
    ]
}

fn faces(edges: &[Edge]) -> Faces {
    Faces::of(split(edges, NEAR).unwrap())
}

fn areas(faces: &Faces) -> Vec<f64> {
    faces.faces.iter().map(|f| f.area).collect()
}

#[track_caller]
fn assert_near(found: &[f64], right: &[f64]) {
    assert_eq!(found.len(), right.len(), "{found:?} {right:?}");
    for (a, b) in found.iter().zip(right) {
        assert!((a - b).abs() < 1e-6, "{found:?} {right:?}");
    }
}

/// The part of the faces at points.
fn part(faces: &Faces, at: &[(f64, f64)]) -> Part {
    let chosen: Vec<usize> = at.iter().map(|&p| faces.at(p.into()).unwrap()).collect();
    let loops = boundary(faces, &chosen);
    let vertices = |l: &Vec<super::BoundaryEdge>| {
        l.iter()
            .map(|e| Vertex::new(e.start.x, e.start.y, e.bulge))
            .collect()
    };
    Part::new("", loops.iter().map(vertices).collect()).unwrap()
}

#[test]
fn a_plate_with_a_hole_and_centre_lines_is_two_kinds_of_faces() {
    let mut edges = rectangle([-10.0, 10.0], [-10.0, 10.0]);
    edges.extend(circle(0.0, 0.0, 3.0));
    edges.push(edge((-5.0, 0.0), (5.0, 0.0), 0.0));
    edges.push(edge((0.0, -5.0), (0.0, 5.0), 0.0));
    let faces = faces(&edges);
    let quarter = 9.0 * PI / 4.0;
    assert_near(
        &areas(&faces),
        &[400.0 - 9.0 * PI, quarter, quarter, quarter, quarter],
    );
    let plate = part(&faces, &[(8.0, 8.0)]);
    assert_eq!(plate.loops().len(), 2);
    assert_eq!(plate.edges().count(), 6);
    let disc = part(
        &faces,
        &[(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)],
    );
    assert!((disc.area() - 9.0 * PI).abs() < 1e-6);
}

#[test]
fn crossings_shared_edges_and_overlaps() {
    // A circle and a rectangle that cross: a lens between.
    let mut edges = circle(0.0, 0.0, 1.0);
    edges.extend(rectangle([0.0, 3.0], [-2.0, 2.0]));
    assert_near(
        &areas(&faces(&edges)),
        &[12.0 - PI / 2.0, PI / 2.0, PI / 2.0],
    );
    // Two rectangles with one side in common, drawn once and drawn twice, whole and in part.
    let mut edges = rectangle([0.0, 2.0], [0.0, 2.0]);
    edges.extend(rectangle([2.0, 3.0], [0.0, 1.5]));
    let both = faces(&edges);
    assert_near(&areas(&both), &[4.0, 1.5]);
    let joined = part(&both, &[(1.0, 1.0), (2.5, 0.5)]);
    assert!((joined.area() - 5.5).abs() < 1e-12);
    // A line that ends within the tolerance of another one.
    let mut edges = rectangle([0.0, 2.0], [0.0, 2.0]);
    edges.push(edge((1.0, 5e-8), (1.0, 2.0 - 5e-8), 0.0));
    assert_near(&areas(&faces(&edges)), &[2.0, 2.0]);
    // A circle tangent to three sides of a rectangle around it; the fourth is farther.
    let mut edges = rectangle([-1.0, 2.0], [-1.0, 1.0]);
    edges.extend(circle(0.0, 0.0, 1.0));
    let corner = 1.0 - PI / 4.0;
    let right = 6.0 - PI - 2.0 * corner;
    assert_near(&areas(&faces(&edges)), &[PI, right, corner, corner]);
}

#[test]
fn an_arc_of_almost_a_turn_is_a_face() {
    let arc = edge((1.0, 0.0), (1.0, -1e-8), 4e8);
    assert_near(&areas(&faces(&[arc])), &[PI]);
}

#[test]
fn what_is_nested_is_a_hole_of_the_next_face_only() {
    let mut edges = Vec::new();
    for r in [4.0, 3.0, 2.0, 1.0] {
        edges.extend(circle(0.5, -0.25, r));
    }
    assert_near(&areas(&faces(&edges)), &[7.0 * PI, 5.0 * PI, 3.0 * PI, PI]);
    let ring = part(&faces(&edges), &[(3.0, -0.25)]);
    assert!((ring.area() - 5.0 * PI).abs() < 1e-9);
}

#[test]
fn a_point_inside_is_inside() {
    let mut edges = polygon(&[
        (0.0, 0.0),
        (10.0, 0.0),
        (10.0, 0.1),
        (0.2, 0.1),
        (0.2, 7.0),
        (0.0, 7.0),
    ]);
    edges.extend(circle(20.0, 0.0, 1.0));
    edges.extend(circle(20.0, 0.0, 0.9));
    let faces = faces(&edges);
    for face in 0..faces.faces.len() {
        assert_eq!(faces.at(faces.inside(face).unwrap()), Some(face));
    }
}

/// Random lines and arcs: faces tile the area that they enclose, by Euler's formula, by their areas, and by points that
/// are in the face found by counting crossings of rays with its boundary.
#[test]
fn random_arrangements_are_planar() {
    let mut random = ChaCha8Rng::seed_from_u64(42);
    for round in 0..200 {
        let mut place = || {
            // Places on a grid make ends and crossings coincide.
            let mut x = || match round % 2 {
                0 => f64::from(random.random_range(0..6)),
                _ => random.random_range(0.0..6.0),
            };
            (x(), x())
        };
        let mut edges = Vec::new();
        for i in 0..12 {
            let (a, b) = (place(), place());
            if a != b {
                let bulge = [0.0, 0.0, 0.5, 1.0, -0.3, 1.7][i % 6];
                edges.push(edge(a, b, bulge));
            }
        }
        let mut faces = faces(&edges);
        let outside: f64 = (faces.cycles.iter()).map(|c| c.area.min(0.0)).sum();
        let holes: f64 = (faces.faces.iter().flat_map(|f| &f.cycles[1..]))
            .map(|&c| faces.cycles[c as usize].area)
            .sum();
        let total: f64 = areas(&faces).iter().sum();
        assert!((total - (holes - outside)).abs() < 1e-6, "round {round}");
        // V - E + F = 1 + C: one outside for each component.
        let outsides = faces.cycles.iter().filter(|c| c.area <= 0.0).count();
        let mut used: Vec<u32> = faces
            .arrangement
            .pieces
            .iter()
            .flat_map(|p| p.ends)
            .collect();
        used.sort_unstable();
        used.dedup();
        let (v, e, f) = (
            used.len(),
            faces.arrangement.pieces.len(),
            faces.cycles.len(),
        );
        assert_eq!(v + f, e + 2 * outsides, "round {round}");
        for _ in 0..40 {
            let p = Point::new(
                random.random_range(-1.0..7.0),
                random.random_range(-1.0..7.0),
            );
            let around: Vec<usize> = (0..faces.faces.len())
                .filter(|&f| faces.edges(f).filter(|e| e.toggles(p)).count() % 2 == 1)
                .collect();
            let found: Vec<usize> = faces.at(p).into_iter().collect();
            assert_eq!(found, around, "round {round}, {p:?}");
        }
        for face in 0..faces.faces.len() {
            let starts = |loops: Vec<Vec<super::BoundaryEdge>>| {
                let mut starts: Vec<(f64, f64)> = loops
                    .iter()
                    .flatten()
                    .map(|e| (e.start.x, e.start.y))
                    .collect();
                starts.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
                starts
            };
            assert_eq!(
                starts(around(&faces, face)),
                starts(boundary(&faces, &[face]))
            );
        }
        faces.faces.retain(|f| f.area > 1e-3);
        for face in 0..faces.faces.len() {
            assert!(faces.inside(face).is_some(), "round {round}");
        }
    }
}
