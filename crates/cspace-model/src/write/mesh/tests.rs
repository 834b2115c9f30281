//! Tests that every mesh is closed, exact and consistently oriented.

use cspace::{ContactSpace, Options, Part, Vertex};

use super::{Mesh, MeshError, MeshOptions};
use crate::model;

const TOLERANCE: f64 = 1e-3;

fn square(name: &str, r: f64) -> Part {
    let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
    let corners = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![corners]).unwrap()
}

fn disc(name: &str, r: f64) -> Part {
    let half = |x: f64| Vertex::new(x, 0.0, 1.0);
    Part::new(name, vec![vec![half(-r), half(r)]]).unwrap()
}

/// A frame with a square hole.
fn frame(outer: f64, inner: f64) -> Part {
    let corners = |r: f64| {
        let corners = [(-r, -r), (r, -r), (r, r), (-r, r)];
        corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect()
    };
    Part::new("frame", vec![corners(outer), corners(inner)]).unwrap()
}

fn size(space: &ContactSpace) -> f64 {
    space.fixed().size().max(space.moving().size())
}

fn check(name: &str, space: &ContactSpace) {
    check_within(name, space, 1e-12);
}

/// Vertices may be off the surface by `exact`, as a share of the size.
fn check_within(name: &str, space: &ContactSpace, exact: f64) {
    let mesh = Mesh::new(
        space,
        &MeshOptions {
            tolerance: TOLERANCE,
        },
    )
    .unwrap();
    let openings = mesh.openings();
    assert_eq!(openings.elsewhere, 0, "{name}: {openings:?}");
    assert!(openings.at_ends > 0, "{name}");
    let size = size(space);
    assert!(
        mesh.deviation <= TOLERANCE * size,
        "{name}: {}",
        mesh.deviation
    );
    for t in &mesh.triangles {
        let patch = space.patch(t.patch).unwrap();
        let corners = t.vertices.map(|v| mesh.vertices[v as usize]);
        for c in corners {
            let off = patch.contact_function(c).abs();
            assert!(
                off <= exact * size,
                "{name}: patch {}, {c:?} is off by {off}",
                t.patch
            );
        }
        // Counter-clockwise seen from free space: along the gradient, where the triangle is no sliver.
        let [a, b, c] = corners.map(|c| [c.x, c.y, c.theta * size]);
        let (u, v) = (
            [0, 1, 2].map(|k| b[k] - a[k]),
            [0, 1, 2].map(|k| c[k] - a[k]),
        );
        let cross = [
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        ];
        let area = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
        if area > 1e-4 * size * size {
            let g = patch.gradient(corners[0]);
            let facing = cross[0] * g[0] + cross[1] * g[1] + cross[2] * g[2] / size;
            assert!(
                facing > 0.0,
                "{name}: patch {} faces blocked space",
                t.patch
            );
        }
    }
    if space.window().full_turn {
        let end = |theta: f64| -> Vec<(f64, f64)> {
            let there = mesh.vertices.iter().filter(|v| v.theta == theta);
            there.map(|v| (v.x, v.y)).collect()
        };
        assert_eq!(end(mesh.ends.0), end(mesh.ends.1), "{name}");
        assert!(!end(mesh.ends.0).is_empty(), "{name}");
    }
}

fn space(fixed: &Part, moving: &Part, window: Option<(f64, f64)>) -> ContactSpace {
    ContactSpace::compute(
        fixed,
        moving,
        &Options {
            window,
            ..Options::default()
        },
    )
    .unwrap()
}

#[test]
fn simple_pairs_are_closed() {
    // The first is critical at θ = −π exactly.
    check(
        "squares",
        &space(&square("table", 2.0), &square("block", 1.0), None),
    );
    check(
        "square and disc",
        &space(&square("table", 2.0), &disc("coin", 1.0), None),
    );
    check(
        "discs",
        &space(&disc("plate", 2.0), &disc("coin", 1.0), None),
    );
    // Channels close over whole lengths as the block turns.
    check(
        "frame and block",
        &space(&frame(3.0, 2.0), &square("block", 1.6), None),
    );
}

/// Squares of side 1 with two sides that are arcs much larger than the parts, bulging and hollow.
#[test]
fn flat_arcs_are_closed() {
    let curved = |name: &str, side: f64, radius: f64| {
        let (r, bulge) = (0.5 * side, 0.25 * side / radius);
        let corners = [(-r, -r, bulge), (r, -r, 0.0), (r, r, bulge), (-r, r, 0.0)];
        let vertices = corners.map(|(x, y, b)| Vertex::new(x, y, b));
        Part::new(name, vec![vertices.to_vec()]).unwrap()
    };
    // Their curves cross at small angles: points that near to each other are one.
    const MERGED: f64 = 1e-11;
    for radius in [1e3, -1e3, 1e6, -1e6] {
        let (table, block) = (curved("table", 1.0, radius), curved("block", 0.6, 2e3));
        let name = format!("sides of radius {radius}");
        check_within(&name, &space(&table, &block, None), MERGED);
    }
}

#[test]
fn a_window_is_open_at_its_ends_alone() {
    let fixed = frame(3.0, 2.0);
    check(
        "window",
        &space(&fixed, &square("block", 1.6), Some((-0.3, 2.0))),
    );
}

#[test]
fn shipped_models_are_closed() {
    let models = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models");
    for name in [
        "ball_in_c",
        "cam_follower",
        "fixture_plate",
        "geneva",
        "knee",
        "peg_hole",
        "ratchet_pawl",
        "snap_fastener",
    ] {
        let model = model::read(format!("{models}/{name}.toml")).unwrap();
        let pair = &model.pairs[0];
        let part = |i: usize| &model.parts[i].part;
        check(
            name,
            &space(part(pair.fixed), part(pair.moving), pair.window),
        );
    }
}

/// A mesh may have the largest allowed number of vertices, and no more.
#[test]
fn a_mesh_has_a_limit() {
    let space =
        ContactSpace::compute(&square("a", 2.0), &square("b", 1.0), &Options::default()).unwrap();
    let options = MeshOptions { tolerance: 1e-2 };
    let mesh = Mesh::new(&space, &options).unwrap();
    let limit = mesh.vertices.len() as u32;
    assert_eq!(Mesh::limited(&space, &options, limit), Ok(mesh));
    let limit = limit - 1;
    let error = Mesh::limited(&space, &options, limit);
    assert_eq!(error, Err(MeshError::TooManyVertices { limit }));
    // One that asks for more than any machine has ends, too.
    let options = MeshOptions { tolerance: 0.0 };
    assert!(Mesh::limited(&space, &options, 100_000).is_err());
}
