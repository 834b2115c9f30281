//! Symmetry of parts drawn in many ways.
#![allow(clippy::unwrap_used)]

use core::f64::consts::TAU;

use super::{Corresponding, PartSymmetry, SYMMETRIC};
use crate::geometry::{Point, Rotation, Vector};
use crate::part::{Part, Vertex};

/// A loop of `k` equal teeth of three vertices each about a point, the first turned by `by`.
fn teeth(k: u32, about: Point, by: f64) -> Vec<Vertex> {
    let mut all = Vec::new();
    let step = TAU / f64::from(k);
    for i in 0..k {
        let turn = Rotation::by(by + TAU * f64::from(i) / f64::from(k));
        for (radius, share, bulge) in [
            (4.0, 0.0, 0.0),
            (4.0 + step.min(1.0), 0.1, 0.2),
            (4.0 + 0.5 * step.min(1.0), 0.5, -0.1),
        ] {
            let p = about + turn * (Vector::from_angle(share * step) * radius);
            all.push(Vertex::new(p.x, p.y, bulge));
        }
    }
    all
}

/// A circle of two half circles; the first starts in direction `from`.
fn hole(center: Point, radius: f64, from: f64) -> Vec<Vertex> {
    [0.0, 0.5 * TAU]
        .map(|a| {
            let p = center + Vector::from_angle(from + a) * radius;
            Vertex::new(p.x, p.y, 1.0)
        })
        .into()
}

/// The loop in the other direction.
fn reversed(l: &[Vertex]) -> Vec<Vertex> {
    let n = l.len();
    (0..n)
        .rev()
        .map(|i| Vertex::new(l[(i + 1) % n].x, l[(i + 1) % n].y, -l[i].bulge))
        .collect()
}

fn symmetry(loops: &[Vec<Vertex>]) -> PartSymmetry {
    Part::new("part", loops.to_vec()).unwrap().symmetry()
}

const FAR: Point = Point::new(300.0, -1000.0);

#[test]
fn wheels_have_as_many_folds_as_teeth() {
    for k in [1, 2, 3, 4, 6, 7, 12, 14, 20, 25, 60, 97] {
        for about in [Point::ORIGIN, FAR] {
            let found = symmetry(&[teeth(k, about, 0.3)]);
            assert_eq!(found.fold(), k);
            assert!(k == 1 || found.center().distance(about) < 1e-12);
            assert!(found.deviation() < 1e-12);
            assert!(found.allows(k) && found.allows(1) && !found.allows(2 * k) && !found.allows(0));
        }
    }
}

#[test]
fn holes_count_by_where_they_are() {
    let ring = |n: u32, from: f64| {
        (0..n).map(move |i| {
            let at = FAR + Vector::from_angle(TAU * f64::from(i) / f64::from(n)) * 2.0;
            hole(at, 0.2, from * f64::from(i * i))
        })
    };
    let with = |holes: Vec<Vec<Vertex>>| {
        let mut loops = vec![teeth(12, FAR, 0.0)];
        loops.extend(holes);
        symmetry(&loops).fold()
    };
    // A bore, wherever its halves meet, and holes drawn with their halves in any direction.
    assert_eq!(with(vec![hole(FAR, 0.7, 0.2)]), 12);
    assert_eq!(with(ring(6, 0.4).collect()), 6);
    assert_eq!(with(ring(8, 0.0).collect()), 4);
    assert_eq!(with(ring(6, 0.0).chain([hole(FAR, 0.7, 0.2)]).collect()), 6);
    assert_eq!(with(ring(6, 0.0).skip(1).collect()), 1);
    // A bore off the centre.
    assert_eq!(with(vec![hole(FAR + Vector::new(0.1, 0.0), 0.7, 0.0)]), 1);
}

#[test]
fn loops_may_come_in_any_order_and_direction() {
    let piece = |i: u32| {
        let at = FAR + Vector::from_angle(TAU * f64::from(i) / 5.0) * 20.0;
        let l = teeth(3, at, TAU * f64::from(i) / 5.0);
        if i.is_multiple_of(2) { reversed(&l) } else { l }
    };
    assert_eq!(symmetry(&[0, 3, 1, 4, 2].map(piece)).fold(), 5);
    assert_eq!(symmetry(&[0, 3, 1, 4].map(piece)).fold(), 1);
}

#[test]
fn what_is_almost_symmetric_is_told_by_the_tolerance() {
    let nudged = |share: f64| {
        let mut l = teeth(8, FAR, 0.0);
        let size = Part::new("wheel", vec![l.clone()]).unwrap().size();
        l[4].x += share * SYMMETRIC * size;
        (symmetry(&[l]), share * SYMMETRIC * size)
    };
    let (found, by) = nudged(0.5);
    assert_eq!(found.fold(), 8);
    assert!((0.5 * by..=by).contains(&found.deviation()));
    assert_eq!(nudged(4.0).0.fold(), 1);
    // An arc bent a little more than the others.
    let mut l = teeth(8, FAR, 0.0);
    l[4].bulge += 1e-6;
    assert_eq!(symmetry(&[l]).fold(), 1);
}

#[test]
fn round_parts_have_every_fold() {
    let annulus = [hole(FAR, 3.0, 0.1), hole(FAR, 2.0, 0.1)];
    let found = symmetry(&annulus);
    assert!(found.is_round() && found.allows(17));
    assert_eq!(found.fold(), 2);
    // Halves that meet in other directions: no rotation maps the arcs as drawn.
    assert_eq!(
        symmetry(&[hole(FAR, 3.0, 0.1), hole(FAR, 2.0, 0.4)]).fold(),
        2
    );
    assert!(
        !symmetry(&[
            hole(FAR, 3.0, 0.0),
            hole(FAR + Vector::new(0.5, 0.0), 2.0, 0.0)
        ])
        .is_round()
    );
}

/// Turned by one step, the redrawn part is itself, edge by edge according to the images.
#[test]
fn redrawn_parts_are_symmetric_to_rounding() {
    let mut loops = vec![reversed(&teeth(12, FAR, 0.0)), hole(FAR, 0.7, 0.2)];
    for i in 0..4_u32 {
        let at = FAR + Vector::from_angle(TAU * f64::from(i) / 4.0) * 2.0;
        loops.push(hole(at, 0.2, f64::from(i * i)));
    }
    let part = Part::new("wheel", loops).unwrap();
    let s = part.symmetrized(Corresponding::Outlines).unwrap();
    assert_eq!(s.fold, 4);
    let turn = Rotation::by(TAU / f64::from(s.fold));
    for (l, image) in s.part.loops().iter().zip(&s.images) {
        let to = s.part.loops()[image.target as usize].vertices();
        let n = to.len();
        assert_eq!(l.vertices().len(), n);
        for (t, v) in l.vertices().iter().enumerate() {
            let w = to[(t + image.shift as usize) % n];
            assert!(
                (turn * v.point()).distance(w.point()) < 1e-14 && (v.bulge - w.bulge).abs() < 1e-14
            );
        }
    }
    // Every edge is a piece of the one from which it is reported to come.
    for ((l, was), drawn) in s.part.loops().iter().zip(part.loops()).zip(&s.drawn) {
        for (e, d) in l.edges().zip(drawn) {
            let original = was.edges().find(|o| o.index == d.edge as usize).unwrap();
            let middle = e.start.midpoint(e.end) + (e.end - e.start).right() * (0.5 * e.bulge);
            let at = s.center + middle.to_vector();
            if original.is_line() {
                let chord = original.end - original.start;
                assert!(chord.cross(at - original.start).abs() < 1e-9);
            } else {
                assert!((at.distance(original.center()) - original.radius()).abs() < 1e-9);
                let side = |p: Point| (original.end - original.start).cross(p - original.start);
                assert!(side(at) * original.bulge <= 1e-9);
            }
        }
    }
    assert_eq!(s.added, s.part.edges().count() - part.edges().count());
    assert!(s.divided[1] && !s.divided[0]);
}

#[test]
fn a_part_of_many_edges() {
    let part = Part::new("wheel", vec![teeth(4000, Point::ORIGIN, 0.0)]).unwrap();
    assert_eq!(part.symmetry().fold(), 4000);
}
