//! Ten parts with arcs, behind a bolt and a door.

use std::time::Instant;

use cspace::{Axis, Part, Vector, Vertex};
use cspace_model::PartEntry;
use cspace_plan::assembly::{Kind, Outcome};

use crate::assembly::judged::{asked, mechanism};

/// A quarter of a circle.
const QUARTER: f64 = 0.414_213_562_373_095_03;

/// A part of corners, each with the bulge of the edge after it.
fn part(name: &str, corners: &[(f64, f64, f64)]) -> Part {
    let vertices = corners
        .iter()
        .map(|&(x, y, b)| Vertex::new(x, y, b))
        .collect();
    Part::new(name, vec![vertices]).unwrap()
}

fn roller(name: &str, x: f64, y: f64) -> Part {
    part(name, &[(x - 1.0, y, 1.0), (x + 1.0, y, 1.0)])
}

#[test]
fn ten_parts_come_apart_in_order() {
    // Grooves for two rollers in the floor.
    let tray = part(
        "tray",
        &[
            (-1.0, -3.0, 0.0),
            (13.0, -3.0, 0.0),
            (13.0, 8.0, 0.0),
            (12.0, 8.0, 0.0),
            (12.0, 0.0, 0.0),
            (10.0, 0.0, -1.0),
            (8.0, 0.0, 0.0),
            (4.0, 0.0, -1.0),
            (2.0, 0.0, 0.0),
            (0.0, 0.0, 0.0),
            (0.0, 9.0, 0.0),
            (-1.0, 9.0, 0.0),
        ],
    );
    let plate = part(
        "plate",
        &[
            (0.0, 0.0, 0.0),
            (2.0, 0.0, -1.0),
            (4.0, 0.0, 0.0),
            (8.0, 0.0, -1.0),
            (10.0, 0.0, 0.0),
            (12.0, 0.0, 0.0),
            (12.0, 3.0, 0.0),
            (7.0, 3.0, -1.0),
            (5.0, 3.0, 0.0),
            (0.0, 3.0, 0.0),
        ],
    );
    // The one's tongue is in the other's groove: between the walls they go up as one.
    let left = part(
        "left",
        &[
            (0.0, 3.0, 0.0),
            (5.0, 3.0, -QUARTER),
            (6.0, 4.0, 0.0),
            (6.0, 4.5, 0.0),
            (7.0, 4.5, 0.0),
            (7.0, 5.5, 0.0),
            (6.0, 5.5, 0.0),
            (6.0, 6.0, 0.0),
            (0.0, 6.0, 0.0),
        ],
    );
    let right = part(
        "right",
        &[
            (7.0, 3.0, 0.0),
            (12.0, 3.0, 0.0),
            (12.0, 6.0, 0.0),
            (6.0, 6.0, 0.0),
            (6.0, 5.5, 0.0),
            (7.0, 5.5, 0.0),
            (7.0, 4.5, 0.0),
            (6.0, 4.5, 0.0),
            (6.0, 4.0, -QUARTER),
        ],
    );
    let lid = Part::rectangle("lid", (6.0, 7.0), 12.0, 2.0).unwrap();
    let mut model = mechanism(
        &[tray],
        &[
            roller("first roller", 3.0, 0.0),
            roller("second roller", 9.0, 0.0),
            plate,
            roller("upper roller", 6.0, 3.0),
            left,
            right,
            lid,
        ],
    );
    let bolt = Part::rectangle("bolt", (12.0, 8.5), 4.0, 1.0).unwrap();
    let slide = Axis::prismatic(Vector::new(1.0, 0.0)).within(0.0, 4.0);
    model.parts.push(PartEntry::on(bolt, slide));
    let door = Part::rectangle("door", (4.5, 9.25), 9.0, 0.5).unwrap();
    let hinge = Axis::revolute((0.0, 9.0).into()).within(0.0, 110.0_f64.to_radians());
    model.parts.push(PartEntry::on(door, hinge));
    assert_eq!(model.parts.len(), 10);
    let begin = Instant::now();
    let apart = asked(&model);
    println!("{:?}, {} spaces", begin.elapsed(), apart.spaces);
    assert_eq!(apart.outcome, Outcome::Apart);
    let moved: Vec<(Kind, &[usize])> = (apart.steps.iter())
        .map(|s| (s.kind, s.moving.as_slice()))
        .collect();
    let mut room: Vec<usize> = moved[..2].iter().map(|m| m.1[0]).collect();
    room.sort_unstable();
    assert!(moved[..2].iter().all(|m| m.0 == Kind::Moves));
    assert_eq!(room, [8, 9]);
    assert_eq!(moved[2], (Kind::Leaves, &[7][..]));
    assert_eq!(moved[3], (Kind::Leaves, &[5, 6][..]));
    // Of what left as one, the tree tells how it comes apart.
    let pair = &apart.tree.out[1];
    assert_eq!(
        (pair.step, pair.tree.out.len(), pair.tree.left.len()),
        (3, 1, 1)
    );
    assert_eq!(apart.tree.left, [0, 8, 9]);
}
