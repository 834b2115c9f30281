//! Fits against brute force, and the promises of every fit.

use core::f64::consts::{PI, TAU};

use cspace::{Point, Vector};

use super::fitted::Fitted;
use super::pieces::fit;
use super::run::{Band, Run, RunEnd};

/// A curve by a parameter from 0 to 1.
struct Case {
    name: &'static str,
    at: fn(f64) -> Point,
    is_closed: bool,
}

/// The flank of an involute gear of 18 teeth, module 2 and 20 degrees, from the base circle to the tip.
fn involute(s: f64) -> Point {
    let base = 18.0 * 20.0_f64.to_radians().cos();
    let t = s * ((20.0_f64 / base).powi(2) - 1.0).sqrt();
    let (sin, cos) = t.sin_cos();
    Point::new(base * (cos + t * sin), base * (sin - t * cos))
}

/// A cam of radius 20 that lifts by 8, with a lobe that leans.
fn cam(s: f64) -> Point {
    let t = TAU * s;
    let r = 20.0 + 4.0 * (1.0 - t.cos()) + (2.0 * t).sin();
    Point::new(r * t.cos(), r * t.sin())
}

fn ellipse(s: f64) -> Point {
    Point::new(20.0 * (TAU * s).cos(), 10.0 * (TAU * s).sin())
}

fn half_ellipse(s: f64) -> Point {
    ellipse(s / 2.0)
}

fn spiral(s: f64) -> Point {
    let t = 3.0 * PI * s;
    Point::new((2.0 + t) * t.cos(), (2.0 + t) * t.sin())
}

fn wave(s: f64) -> Point {
    Point::new(10.0 * s, (7.0 * s).sin())
}

const CASES: [Case; 6] = [
    Case {
        name: "involute",
        at: involute,
        is_closed: false,
    },
    Case {
        name: "cam",
        at: cam,
        is_closed: true,
    },
    Case {
        name: "ellipse",
        at: ellipse,
        is_closed: true,
    },
    Case {
        name: "half ellipse",
        at: half_ellipse,
        is_closed: false,
    },
    Case {
        name: "spiral",
        at: spiral,
        is_closed: false,
    },
    Case {
        name: "wave",
        at: wave,
        is_closed: false,
    },
];

fn samples(case: &Case, n: usize) -> Vec<(Point, Vector)> {
    let last = if case.is_closed { n } else { n - 1 };
    (0..n)
        .map(|k| {
            let s = k as f64 / last as f64;
            let h = 1e-6;
            let along = (case.at)(s + h) - (case.at)(s - h);
            ((case.at)(s), along.unit().left())
        })
        .collect()
}

fn run(case: &Case, n: usize, band: Band) -> Run {
    let (points, normals) = samples(case, n).into_iter().unzip();
    Run {
        points,
        normals,
        joints: None,
        is_closed: case.is_closed,
        is_measured: false,
        ends: [RunEnd::Free; 2],
        band,
    }
}

fn size(case: &Case) -> f64 {
    let points: Vec<Point> = samples(case, 200).into_iter().map(|s| s.0).collect();
    let range = |of: fn(&Point) -> f64| {
        let all = points.iter().map(of);
        all.clone().fold(f64::NEG_INFINITY, f64::max) - all.fold(f64::INFINITY, f64::min)
    };
    range(|p| p.x).hypot(range(|p| p.y))
}

/// Largest distance of the samples between two others from the arc of a bulge.
fn farthest(points: &[Point], from: usize, to: usize, bulge: f64) -> f64 {
    let (p, q) = (points[from], points[to % points.len()]);
    let chord = q - p;
    (from + 1..to)
        .map(|k| points[k % points.len()])
        .map(|at| {
            if bulge.abs() < 1e-9 {
                return chord.unit().cross(at - p).abs();
            }
            let center = p.midpoint(q) + chord.left() * ((1.0 - bulge * bulge) / (4.0 * bulge));
            (at.distance(center) - p.distance(center)).abs()
        })
        .fold(0.0, f64::max)
}

/// The fewest arcs from sample to sample within a tolerance, whether they are tangent or not: no tangent ones are fewer. The
/// best arc between two samples is searched for by golden sections, and all chains of samples are compared.
fn fewest(points: &[Point], is_closed: bool, tolerance: f64) -> usize {
    let n = points.len();
    let is_near = |from: usize, to: usize| {
        let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
        // The deviation has one least value over the bulges: arcs between two points are nested.
        let (mut lo, mut hi) = (-1.5, 1.5);
        for _ in 0..60 {
            let (a, b) = (hi - golden * (hi - lo), lo + golden * (hi - lo));
            if farthest(points, from, to, a) < farthest(points, from, to, b) {
                hi = b;
            } else {
                lo = a;
            }
        }
        farthest(points, from, to, f64::midpoint(lo, hi)) <= tolerance
    };
    let starts = if is_closed { 0..n / 8 } else { 0..1 };
    let reach: Vec<usize> = (0..n)
        .map(|from| {
            let most = if is_closed { from + n - 1 } else { n - 1 };
            let mut to = from;
            while to < most && is_near(from, to + 1) {
                to += 1;
            }
            to
        })
        .collect();
    (starts.map(|start| {
        let end = if is_closed { start + n } else { n - 1 };
        let (mut at, mut pieces) = (start, 0);
        while at < end {
            let here = at % n;
            at += reach[here] - here;
            pieces += 1;
        }
        pieces
    }))
    .min()
    .unwrap_or(0)
}

fn kinks(fitted: &Fitted, is_closed: bool) -> f64 {
    let n = fitted.vertices.len();
    let direction = |i: usize, side: f64| {
        let v = fitted.vertices[i];
        let to = match i + 1 {
            j if j < n => fitted.vertices[j].point(),
            _ if is_closed => fitted.vertices[0].point(),
            _ => fitted.end,
        };
        let chord = to - v.point();
        chord.angle() + side * 2.0 * v.bulge.atan()
    };
    (0..n)
        .filter(|&i| is_closed || i > 0)
        .map(|i| {
            let kink = direction(i, -1.0) - direction((i + n - 1) % n, 1.0);
            (kink - TAU * (kink / TAU).round()).abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn pieces_are_tangent_and_near() {
    for case in &CASES {
        for share in [1e-3, 1e-4, 1e-5] {
            let tolerance = share * size(case);
            let fitted = fit(&run(case, 1500, Band::both(tolerance))).expect(case.name);
            // Points that the fit has not seen.
            let others: Vec<Point> = samples(case, 1009).into_iter().map(|s| s.0).collect();
            let n = fitted.vertices.len();
            let worst = (others.iter())
                .map(|at| {
                    (0..n)
                        .map(|i| {
                            let to = match i + 1 {
                                j if j < n => fitted.vertices[j].point(),
                                _ if case.is_closed => fitted.vertices[0].point(),
                                _ => fitted.end,
                            };
                            let v = fitted.vertices[i];
                            cspace::part::Edge {
                                start: v.point(),
                                end: to,
                                bulge: v.bulge,
                                index: 0,
                            }
                            .distance(*at)
                        })
                        .fold(f64::INFINITY, f64::min)
                })
                .fold(0.0, f64::max);
            assert!(
                worst <= 1.01 * tolerance,
                "{} {share}: {worst} of {tolerance}",
                case.name
            );
            assert!(
                kinks(&fitted, case.is_closed) < 1e-9,
                "{} {share}",
                case.name
            );
        }
    }
}

#[test]
#[ignore = "long: brute force over all chains of samples"]
fn pieces_are_few() {
    for case in &CASES {
        for share in [1e-3, 1e-4] {
            let tolerance = share * size(case);
            let fitted = fit(&run(case, 1500, Band::both(tolerance))).expect(case.name);
            let n = fitted.vertices.len();
            let points: Vec<Point> = samples(case, 400).into_iter().map(|s| s.0).collect();
            let optimum = fewest(&points, case.is_closed, tolerance);
            let most = (1.2 * optimum as f64).max(optimum as f64 + 1.0);
            assert!(
                n as f64 <= most,
                "{} {share}: {n}, brute force {optimum}",
                case.name
            );
        }
    }
}

/// A hundredth of the tolerance asks for no fewer pieces, and deviates less.
#[test]
fn fits_converge() {
    for case in &CASES {
        let mut before = (0, f64::INFINITY);
        for exponent in 2..=6 {
            let tolerance = 10.0_f64.powi(-exponent) * size(case);
            let fitted = fit(&run(case, 3000, Band::both(tolerance))).expect(case.name);
            let now = (fitted.vertices.len(), fitted.deviation);
            assert!(
                now.0 >= before.0 && now.1 <= before.1,
                "{}: {now:?} after {before:?}",
                case.name
            );
            before = now;
        }
    }
}

#[test]
fn one_sided_fits_stay_on_their_side() {
    for case in &CASES {
        let tolerance = 1e-4 * size(case);
        for left in [false, true] {
            let run = run(case, 1500, Band::one_sided(tolerance, left));
            let fitted = fit(&run).expect(case.name);
            let n = fitted.vertices.len();
            for (at, normal) in run.points.iter().zip(&run.normals) {
                let nearest = (0..n)
                    .map(|i| {
                        let to = match i + 1 {
                            j if j < n => fitted.vertices[j].point(),
                            _ if case.is_closed => fitted.vertices[0].point(),
                            _ => fitted.end,
                        };
                        let v = fitted.vertices[i];
                        cspace::Edge::between(v.point(), to, v.bulge).nearest(*at)
                    })
                    .min_by(|a, b| a.distance(*at).total_cmp(&b.distance(*at)));
                let off = nearest.map_or(f64::NAN, |p| (p - *at).dot(*normal));
                let signed = if left { off } else { -off };
                assert!(
                    (-1e-6 * tolerance..=1.001 * tolerance).contains(&signed),
                    "{} {left}: {signed}",
                    case.name
                );
            }
        }
    }
}
