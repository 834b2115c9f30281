//! Moments of areas, compared with known values and with sums over a grid.

use core::f64::consts::PI;

use cspace::part::circle_loop;
use cspace::{AreaMoments, Part, Point, Vertex};
use cspace_oracle::effort;

use super::backwards;

/// Asserts area, centroid and second moment, to a few roundings of the size of each.
#[track_caller]
fn is(part: &Part, area: f64, centroid: (f64, f64), second: f64) {
    let m = part.moments();
    let size = part.size();
    assert!((m.area - area).abs() < 1e-13 * size * size, "{m:?}, {area}");
    assert!(
        m.centroid.distance(Point::from(centroid)) < 1e-13 * size,
        "{m:?}, {centroid:?}"
    );
    assert!(
        (m.second - second).abs() < 1e-13 * second,
        "{m:?}, {second}"
    );
}

#[test]
fn disc_and_ring() {
    let disc = Part::circle("disc", (3.0, -2.0), 1.5).unwrap();
    is(&disc, PI * 2.25, (3.0, -2.0), PI * 1.5_f64.powi(4) / 2.0);
    let [inner, outer] = [1.0, 2.0].map(|r| circle_loop((0.5, 4.0), r).unwrap());
    let second = PI * (16.0 - 1.0) / 2.0;
    for loops in [
        vec![inner.clone(), outer.clone()],
        vec![backwards(&outer), inner],
    ] {
        let ring = Part::new("ring", loops).unwrap();
        is(&ring, 3.0 * PI, (0.5, 4.0), second);
    }
}

/// The centroid of a half disc is 4 r / 3π from its diameter.
#[test]
fn half_disc() {
    let r = 2.0;
    let loops = vec![vec![Vertex::new(r, 0.0, 1.0), Vertex::line(-r, 0.0)]];
    let half = Part::new("half", loops).unwrap();
    let (area, y) = (PI * r * r / 2.0, 4.0 * r / (3.0 * PI));
    // Half of the disc's moment about its centre, transformed to the centroid.
    let second = PI * r.powi(4) / 4.0 - area * y * y;
    is(&half, area, (0.0, y), second);
}

#[test]
fn rectangle_off_centre() {
    let (w, h) = (6.0, 0.5);
    let part = Part::rectangle("rod", (40.0, -30.0), w, h).unwrap();
    is(&part, w * h, (40.0, -30.0), w * h * (w * w + h * h) / 12.0);
}

/// A square with a round hole out of the middle, and an island in the hole.
#[test]
fn hole_and_island() {
    let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
    let square: Vec<_> = corners.iter().map(|&(x, y)| Vertex::line(x, y)).collect();
    let circle = |r| circle_loop((4.0, 5.0), r).unwrap();
    let part = Part::new("plate", vec![circle(1.0), square, circle(3.0)]).unwrap();
    let (hole, island) = (9.0 * PI, PI);
    let area = 100.0 - hole + island;
    let x = (100.0 * 5.0 - (hole - island) * 4.0) / area;
    let about = |a: f64, own: f64, at: f64| own + a * (at - x).powi(2);
    let second = about(100.0, 1e4 / 6.0, 5.0) - about(hole, 81.0 * PI / 2.0, 4.0)
        + about(island, PI / 2.0, 4.0);
    is(&part, area, (x, 5.0), second);
}

/// A segment of a circle of radius r and half angle h: area r² (h − sin h cos h), and its centroid 2 r sin³ h / 3 (h − sin h cos h)
/// from the centre. Its second moment about the centre is that of the sector less that of the triangle.
fn segment(r: f64, h: f64) -> (Part, AreaMoments) {
    let (sin, cos) = h.sin_cos();
    let loops = vec![vec![
        Vertex::new(r * sin, r * cos, (h / 2.0).tan()),
        Vertex::line(-r * sin, r * cos),
    ]];
    let shape = h - sin * cos;
    let y = 2.0 * r * sin.powi(3) / (3.0 * shape);
    let area = r * r * shape;
    let about_center = r.powi(4) * (h / 2.0 - sin * cos * (2.0 + (2.0 * h).cos()) / 6.0);
    let known = AreaMoments {
        area,
        centroid: Point::new(0.0, y),
        second: about_center - area * y * y,
    };
    (Part::new("segment", loops).unwrap(), known)
}

#[test]
fn circular_segments() {
    for (r, h) in [(2.0, 0.9), (1.0, 1.4), (3.0, 1.6), (1.5, 2.6), (1.0, 3.0)] {
        let (part, known) = segment(r, h);
        let m = part.moments();
        assert!((m.area - known.area).abs() < 1e-13 * known.area, "{h}");
        assert!(m.centroid.distance(known.centroid) < 1e-13 * r, "{h}");
        // The known formula itself loses digits.
        assert!(
            (m.second - known.second).abs() < 1e-11 * known.second,
            "{h}: {m:?} {known:?}"
        );
    }
}

/// A nearly flat segment is nearly the piece of a parabola: with the chord L and the height h the area is 2 L h / 3, the centroid is 2 h /
/// 5 from the chord, and the second moment is L³ h / 30, each to a factor of 1 + O(h² / L²).
#[test]
fn flat_segments_keep_their_digits() {
    let (length, bulge) = (4.0, 1e-5);
    let loops = vec![vec![
        Vertex::new(0.0, 0.0, bulge),
        Vertex::line(length, 0.0),
    ]];
    let m = Part::new("flat", loops).unwrap().moments();
    let h = length * bulge / 2.0;
    let known = (2.0 * length * h / 3.0, -0.4 * h, length.powi(3) * h / 30.0);
    assert!((m.area / known.0 - 1.0).abs() < 1e-9);
    assert!((m.centroid.y / known.1 - 1.0).abs() < 1e-9);
    assert!((m.second / known.2 - 1.0).abs() < 1e-9);
}

/// Moments do not depend on where the part is drawn: a needle with a knob at its end, far from the origin.
#[test]
fn far_from_the_origin() {
    let at = |x: f64, y: f64| {
        let loops = vec![vec![
            Vertex::line(x, y),
            Vertex::line(x + 100.0, y),
            Vertex::new(x + 100.0, y - 1.0, 3.0),
            Vertex::line(x + 100.0, y + 1.0),
            Vertex::line(x, y + 1.0),
        ]];
        Part::new("needle", loops).unwrap().moments()
    };
    let (near, far) = (at(0.0, 0.0), at(4096.0, -8192.0));
    assert!((near.second - far.second).abs() < 1e-12 * near.second);
    assert!((far.centroid - near.centroid - cspace::Vector::new(4096.0, -8192.0)).length() < 1e-11);
}

/// Rows through the material of parts with arcs of all kinds, each row integrated between its entries and exits.
#[test]
fn against_a_sum_over_rows() {
    for seed in 0..effort(2, 6_u32) {
        let part = bumpy(seed);
        let m = part.moments();
        let box_ = part.bounds();
        let rows = 4000;
        let height = (box_.max.y - box_.min.y) / f64::from(rows);
        let (mut area, mut first, mut second) = (0.0, (0.0, 0.0), 0.0);
        for row in 0..rows {
            let y = box_.min.y + (f64::from(row) + 0.5) * height;
            for (x0, x1) in inside(&part, y) {
                let (dx, dx2, dx3) = (
                    x1 - x0,
                    (x1 * x1 - x0 * x0) / 2.0,
                    (x1 * x1 * x1 - x0 * x0 * x0) / 3.0,
                );
                area += height * dx;
                first = (first.0 + height * dx2, first.1 + height * y * dx);
                second += height * (dx3 + y * y * dx);
            }
        }
        let center = Point::new(first.0 / area, first.1 / area);
        second -= area * center.to_vector().length_squared();
        assert!((m.area / area - 1.0).abs() < 1e-5, "{seed}: {m:?} {area}");
        assert!(m.centroid.distance(center) < 1e-5 * part.size(), "{seed}");
        assert!(
            (m.second / second - 1.0).abs() < 1e-5,
            "{seed}: {m:?} {second}"
        );
    }
}

/// A polygon with edges bulged in and out, of up to three quarters of a circle, and a hole.
fn bumpy(seed: u32) -> Part {
    let count = 5 + seed;
    let outline = (0..count)
        .map(|i| {
            let angle = 2.0 * PI * f64::from(i) / f64::from(count);
            let radius = 9.0 + f64::from((i * 7 + seed * 3) % 5) * 0.6;
            let bulge = [0.0, 0.3, -0.2, 0.75, -0.02, 1.05][((i + seed) % 6) as usize];
            Vertex::new(3.0 + radius * angle.cos(), radius * angle.sin(), bulge)
        })
        .collect();
    let hole = circle_loop((4.0, 1.0), 2.0).unwrap();
    Part::new("bumpy", vec![outline, hole]).unwrap()
}

/// Intervals of the line at height y that are in the material, found by testing points: brute force, without the edges.
fn inside(part: &Part, y: f64) -> Vec<(f64, f64)> {
    let (lo, hi) = (part.bounds().min.x - 0.1, part.bounds().max.x + 0.1);
    let steps = 400;
    let at = |i: u32| lo + (hi - lo) * f64::from(i) / f64::from(steps);
    let is_in = |x: f64| part.contains(Point::new(x, y));
    let mut ends = Vec::new();
    for i in 0..steps {
        let (mut a, mut b) = (at(i), at(i + 1));
        let before = is_in(a);
        if before != is_in(b) {
            for _ in 0..24 {
                let middle = 0.5 * (a + b);
                if is_in(middle) == before {
                    a = middle;
                } else {
                    b = middle;
                }
            }
            ends.push(0.5 * (a + b));
        }
    }
    ends.chunks_exact(2).map(|c| (c[0], c[1])).collect()
}
