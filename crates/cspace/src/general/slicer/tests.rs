//! Slices of small pairs whose free space is known in advance.

use super::*;
use crate::geometry::Point;
use crate::part::Vertex;

/// Vertex at the beginning of an arc from one angle to another on a circle, counter-clockwise, with the arc's bulge.
fn arc(center: (f64, f64), radius: f64, from: f64, to: f64) -> Vertex {
    let (sin, cos) = from.sin_cos();
    let bulge = (0.25 * (to - from)).tan();
    Vertex::new(center.0 + radius * cos, center.1 + radius * sin, bulge)
}

/// A disc whose outline is one arc of almost the whole circle, and a small one.
fn disc(center: (f64, f64), radius: f64, gap: f64) -> Vec<Vertex> {
    vec![
        arc(center, radius, gap, 2.0 * PI - gap),
        arc(center, radius, -gap, gap),
    ]
}

/// A block with a room bounded by an arc of 300° and its chord, and in the room a column near the arc. The column cuts the contact arc, and
/// the longer pieces face each other across the room: the free space beside them must be found within the room, however small it is
/// compared with the block.
#[test]
fn rooms_of_one_arc_are_free() {
    for size in [0.3, 0.05, 2e-4] {
        let (open, at) = (PI / 6.0, |v: Vertex| {
            Vertex::new(v.x * size, v.y * size, v.bulge)
        });
        let block = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let room = vec![
            arc((0.0, 0.0), 1.0, open, 2.0 * PI - open),
            Vertex::line(open.cos(), -open.sin()),
        ];
        let column = disc((-0.75, 0.0), 0.2, 0.1);
        let fixed = Part::new(
            "block",
            vec![
                block.map(|(x, y)| Vertex::line(x, y)).to_vec(),
                room.into_iter().map(at).collect(),
                column.into_iter().map(at).collect(),
            ],
        )
        .unwrap();
        let ball = disc((0.0, 0.0), 0.1, 0.05).into_iter().map(at).collect();
        let moving = Part::new("ball", vec![ball]).unwrap();
        for theta in [0.1, 1.0, 2.0, 3.0] {
            let slice = Slice::compute(&fixed, &moving, theta);
            for (x, y, free) in [
                (0.0, 0.0, true),
                (0.0, 0.88, true),
                (-0.1, -0.88, true),
                (0.7, 0.0, true),
                (0.0, 0.92, false),
                (-0.75, 0.28, false),
                (-0.75, 0.32, true),
                (-0.87, 0.0, false),
                (0.8, 0.0, false),
            ] {
                let p = Point::new(x * size, y * size);
                assert_eq!(slice.is_free(p), free, "{size} {theta} {p:?}");
            }
            // One loop for the block, and one for the room with the column at its side.
            assert_eq!(slice.loops.len(), 2, "{size} {theta}");
        }
    }
}

fn square(r: f64) -> Part {
    Part::rectangle("square", (0.1, 0.0), r, r).unwrap()
}

/// The loops of a slice as rounded places, independent of which curve comes first.
fn corners(slice: &Slice) -> Vec<(i64, i64)> {
    let rounded = |x: f64| (x * 1e6).round() as i64;
    let mut all: Vec<_> = (slice.curves.iter())
        .map(|c| c.geometry.point(0.0))
        .map(|p| (rounded(p.x), rounded(p.y)))
        .collect();
    all.sort_unstable();
    all
}

/// Slices agree at any number of turns from the computed turn, and beside the ends of that turn.
#[test]
fn slices_some_turns_further_are_the_same() {
    let (fixed, moving) = (square(2.0), square(1.0));
    let slicer = Slicer::new(&fixed, &moving);
    for theta in [FIRST, 1e-7, -1e-7, 3e-5, -3e-5, 0.3, 2.0].map(|above| FIRST + above) {
        let one = slicer.slice(theta);
        assert!(!one.doubtful);
        for turns in [-1000.0, -1.0, 0.0, 1.0, 3.0] {
            // Not just below a critical orientation.
            let at = theta + TAU * turns + 1e-11;
            for slice in [slicer.slice(at), Slice::compute(&fixed, &moving, at)] {
                assert_eq!(slice.theta, at);
                assert_eq!(corners(&slice), corners(&one), "{at}");
                assert!(slice.curves.iter().all(|c| c.patch.is_none()));
            }
        }
    }
}

/// Where sides are parallel, the slice is that just above: sides of one square meet corners of the other one after the other.
#[test]
fn slices_at_a_critical_orientation_are_those_just_above() {
    let slicer = Slicer::new(&square(2.0), &square(1.0));
    for k in -4..=4 {
        let theta = f64::from(k) * 0.5 * PI;
        let (at, above) = (slicer.slice(theta), slicer.slice(theta + 1e-8));
        let names =
            |s: &Slice| -> Vec<_> { s.curves.iter().map(|c| (c.fixed, c.moving)).collect() };
        assert_eq!(names(&at), names(&above), "{k}");
        assert_eq!(
            (at.curves.len(), at.loops.len(), at.doubtful),
            (8, 1, false)
        );
    }
}

#[test]
fn what_is_no_orientation_has_an_empty_slice() {
    let (fixed, moving) = (square(2.0), square(1.0));
    let slicer = Slicer::new(&fixed, &moving);
    for theta in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for slice in [slicer.slice(theta), Slice::compute(&fixed, &moving, theta)] {
            assert!(slice.curves.is_empty() && slice.loops.is_empty() && !slice.doubtful);
        }
    }
    for theta in [1e16, -1e300] {
        assert_eq!(slicer.slice(theta).loops.len(), 1);
        assert_eq!(Slice::compute(&fixed, &moving, theta).loops.len(), 1);
    }
}
