//! The oracle against polygon clipping, away from contact.
#![allow(clippy::unwrap_used)]

use core::f64::consts::PI;

use cspace::{Configuration, Part, Point};
use cspace_oracle::{Oracle, pairs};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::single::SingleFloatOverlay;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

type Contour = Vec<[f64; 2]>;

/// The part's loops as polygons with corners on it, that differ from it by less than `tolerance`, seen from `origin`
/// after the motion.
fn polygons(part: &Part, tolerance: f64, moved: impl Fn(Point) -> Point) -> Vec<Contour> {
    part.loops()
        .iter()
        .map(|l| {
            let v = l.vertices();
            let mut contour = Contour::new();
            for i in 0..v.len() {
                let (a, b, bulge) = (v[i].point(), v[(i + 1) % v.len()].point(), v[i].bulge);
                let sweep = 4.0 * bulge.atan();
                let radius = a.distance(b) / (2.0 * (0.5 * sweep).sin().abs()).max(1e-300);
                let n = if bulge == 0.0 {
                    1
                } else {
                    (sweep.abs() * (0.125 * radius / tolerance).sqrt())
                        .ceil()
                        .max(1.0) as usize
                };
                for k in 0..n {
                    // The chord from a to the point is seen from the circle's other side at half its sweep.
                    let part = sweep * k as f64 / n as f64;
                    let p = if k == 0 {
                        a
                    } else {
                        let ratio = (0.5 * part).sin() / (0.5 * sweep).sin();
                        let turn = 0.5 * (part - sweep);
                        let d = b - a;
                        let (sin, cos) = turn.sin_cos();
                        a + cspace::Vector::new(cos * d.x - sin * d.y, sin * d.x + cos * d.y)
                            * ratio
                    };
                    let p = moved(p);
                    contour.push([p.x, p.y]);
                }
            }
            contour
        })
        .collect()
}

fn area(shapes: &[Vec<Contour>]) -> f64 {
    let twice: f64 = shapes
        .iter()
        .flatten()
        .flat_map(|c| (0..c.len()).map(|i| (c[i], c[(i + 1) % c.len()])))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    0.5 * twice.abs()
}

#[test]
fn polygon_clipping_says_the_same() {
    let (mut tried, mut overlaps) = (0, 0);
    for pair in pairs() {
        let mut rng = ChaCha8Rng::seed_from_u64(4);
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let (f, m, size) = (oracle.fixed_center(), oracle.moving_center(), oracle.size());
        let tolerance = 1e-5 * size;
        // Scaled to the size, about the fixed part's centre.
        let seen = |p: Point| Point::new((p.x - f.x) / size, (p.y - f.y) / size);
        let fixed = polygons(&pair.fixed, tolerance, seen);
        for i in 0..40 {
            let theta = rng.random_range(-PI..PI);
            let q = Configuration::new(0.0, 0.0, theta).fixed_from_moving(m);
            let reach = if i % 2 == 0 { 1.0 } else { 0.3 };
            let c = Configuration::new(
                f.x - q.x + reach * size * rng.random_range(-1.0..1.0),
                f.y - q.y + reach * size * rng.random_range(-1.0..1.0),
                theta,
            );
            let verdict = oracle.judge(c);
            if verdict.margin < 1e-3 * size {
                continue;
            }
            let moving = polygons(&pair.moving, tolerance, |p| seen(c.fixed_from_moving(p)));
            let both = fixed.overlay(&moving, OverlayRule::Intersect, FillRule::EvenOdd);
            let common = area(&both);
            tried += 1;
            overlaps += u32::from(verdict.overlap);
            // A point of one boundary is inside the other by the margin: some part of the disc about it is common.
            assert_eq!(
                common > 1e-9,
                verdict.overlap,
                "{}: {c:?} {verdict:?} {common}",
                pair.name
            );
        }
    }
    assert!(
        tried > 2000 && overlaps > 500 && overlaps < tried - 500,
        "{tried} {overlaps}"
    );
}
