//! Slices of small pairs whose free space is known by reasoning.

use core::f64::consts::PI;

use super::*;
use crate::geometry::Point;
use crate::part::{Part, Vertex};
use crate::slice::Slice;

fn polygon(name: &str, corners: &[(f64, f64)]) -> Part {
    let outline = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    Part::new(name, vec![outline]).unwrap()
}

/// From one angle on a circle to another, counter-clockwise, with the bulge of that arc.
fn arc(center: (f64, f64), radius: f64, from: f64, to: f64) -> Vertex {
    let (sin, cos) = from.sin_cos();
    let bulge = (0.25 * (to - from)).tan();
    Vertex::new(center.0 + radius * cos, center.1 + radius * sin, bulge)
}

/// A disc of one arc all but a little, and a little one.
fn disc(center: (f64, f64), radius: f64, gap: f64) -> Vec<Vertex> {
    vec![
        arc(center, radius, gap, 2.0 * PI - gap),
        arc(center, radius, -gap, gap),
    ]
}

/// A block with a room that is an arc of 300° and its chord, and in the room a column near the arc. From where the column
/// cuts the arc, its longer pieces see each other across the room: what is free beside them is told within the room, however
/// small it is beside the block.
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
            // The block, and the room with the column at its side.
            assert_eq!(slice.loops.len(), 2, "{size} {theta}");
        }
    }
}

/// A triangle and a block with a notch.
fn notched() -> Geometry {
    let fixed = polygon(
        "notched",
        &[
            (-2.0, -1.0),
            (2.0, -1.0),
            (2.0, 1.0),
            (0.7, 1.0),
            (0.1, -0.4),
            (-0.6, 1.0),
            (-2.0, 1.0),
        ],
    );
    let moving = polygon("moving", &[(-0.2, -0.1), (0.2, -0.1), (0.1, 0.3)]);
    Geometry::new(&fixed, &moving, None, usize::MAX)
}

/// Crossings that may be in either order mark their curve; others, and one alone, do not.
#[test]
fn crossings_nearer_than_their_errors_are_tied() {
    let geometry = notched();
    let theta = 0.3;
    let turn = Rotation::by(theta);
    // With one more crossing this far beyond the first of a curve, the two of them with some errors.
    let tied = |more: Option<(f64, [f64; 2])>| {
        let sheets = 0..geometry.contacts.sheets.len() as u32;
        let (mut live, live_of_sheet, _) = live_curves(&geometry, sheets, theta, turn);
        cut(&mut live, &geometry, turn);
        let i = live.iter().position(|l| !l.cuts.is_empty()).unwrap();
        if let Some((further, errors)) = more {
            let own = live[i].cuts[0];
            live[i].cuts[0].error = errors[0];
            // They may be found in any order.
            let position = own.position + further;
            let error = errors[1];
            live[i].cuts.insert(
                0,
                Cut {
                    position,
                    error,
                    ..own
                },
            );
        }
        let mut all = Arrangement::default();
        all.keep_free(
            &geometry,
            &Coincidences::new(&geometry),
            &mut live,
            &live_of_sheet,
            theta,
            Test::Shells,
        );
        live[i].tied
    };
    assert!(!tied(None));
    for (further, errors, expected) in [
        (0.0, [1e-11, 1e-11], true),
        (1e-6, [0.9e-6, 0.2e-6], true),
        (-1e-6, [0.2e-6, 0.9e-6], true),
        (1e-6, [1.1e-6, 0.0], true),
        (1e-6, [0.4e-6, 0.5e-6], false),
        (-1e-6, [0.3e-6, 0.3e-6], false),
        (1e-3, [1e-11, 1e-11], false),
    ] {
        assert_eq!(
            tied(Some((further, errors))),
            expected,
            "{further} {errors:?}"
        );
    }
}

/// A whole shell is free or none of it, so that every gap for itself is what its shell is.
#[test]
fn gaps_tested_one_by_one_are_those_of_free_shells() {
    let geometry = notched();
    for theta in [-2.0, 0.3, 1.1, 2.5] {
        let by = |test| {
            let sheets = 0..geometry.contacts.sheets.len() as u32;
            let (all, certain) = Arrangement::at(
                &geometry,
                &Coincidences::new(&geometry),
                sheets,
                theta,
                test,
            );
            assert!(certain);
            all.gaps
        };
        let gaps = by(Test::Gaps);
        assert_eq!(gaps, by(Test::Shells), "{theta}");
        // Some of them are pieces that do not reach the end of their curve.
        let cut = |g: &FreeGap| matches!(g.to, GapEnd::Crossing(..));
        assert!(gaps.iter().any(cut), "{theta}");
    }
}

/// The curves with their crossings, their gaps numbered on.
fn cut_curves(geometry: &Geometry, theta: f64) -> (Vec<Live>, Vec<u32>) {
    let turn = Rotation::by(theta);
    let sheets = 0..geometry.contacts.sheets.len() as u32;
    let (mut live, live_of_sheet, _) = live_curves(geometry, sheets, theta, turn);
    cut(&mut live, geometry, turn);
    let mut count = 0;
    for l in &mut live {
        l.cuts.sort_by(|a, b| a.position.total_cmp(&b.position));
        l.first_gap = count;
        count += l.cuts.len() as u32 + 1;
    }
    (live, live_of_sheet)
}

/// Of a shell in doubt both the longest and the outermost gap are tested; where both are blocked or the longest is free,
/// nothing contradicts.
#[test]
fn shells_in_doubt_are_what_they_are_without() {
    let geometry = notched();
    for theta in [-2.0, 0.3, 1.1, 2.5] {
        let by = |tied: bool| {
            let (mut live, live_of_sheet) = cut_curves(&geometry, theta);
            for l in &mut live {
                l.tied |= tied;
            }
            let mut all = Arrangement::default();
            assert!(all.keep_free(
                &geometry,
                &Coincidences::new(&geometry),
                &mut live,
                &live_of_sheet,
                theta,
                Test::Shells
            ));
            all.gaps
        };
        assert_eq!(by(true), by(false), "{theta}");
    }
}

/// Of all gaps, and of any one alone, that whose middle is furthest out; but none that is a point.
#[test]
fn the_furthest_gap_is_told_by_its_middle() {
    let geometry = notched();
    for theta in [-2.0, 0.3, 1.1, 2.5] {
        let (mut live, _) = cut_curves(&geometry, theta);
        // Middles by walking from cut to cut, with the gap each belongs to.
        let mut middles = Vec::new();
        for (i, l) in live.iter().enumerate() {
            let ends: Vec<f64> = (core::iter::once(-l.half))
                .chain(l.cuts.iter().map(|c| c.position))
                .chain([l.half])
                .collect();
            for (g, e) in (0..).zip(ends.windows(2)) {
                let middle = e[0] + 0.5 * (e[1] - e[0]);
                let distance = l.curve.point(middle).distance(Point::ORIGIN);
                middles.push((distance, l.first_gap + g, i, middle));
            }
        }
        let same = |found: Option<(usize, f64)>, (_, _, i, middle): (f64, u32, usize, f64)| {
            found.is_some_and(|f| f.0 == i && (f.1 - middle).abs() < 1e-15)
        };
        for &m in &middles {
            assert!(same(furthest(&live, |gap| gap == m.1), m), "{theta}");
        }
        middles.sort_by(|a, b| b.0.total_cmp(&a.0));
        while let Some(&m) = middles.first() {
            let left: Vec<u32> = middles.iter().map(|m| m.1).collect();
            assert!(
                same(furthest(&live, |gap| left.contains(&gap)), m),
                "{theta}"
            );
            middles.remove(0);
        }
        assert_eq!(furthest(&live, |_| false), None);
        // Two crossings in one place.
        let i = live.iter().position(|l| !l.cuts.is_empty()).unwrap();
        let twice = live[i].cuts[0];
        live[i].cuts.insert(0, twice);
        let point = live[i].first_gap + 1;
        assert_eq!(furthest(&live, |gap| gap == point), None);
    }
}
