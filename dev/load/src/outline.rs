//! Outlines drawn at random that favour ties: corners on a coarse lattice, angles that are multiples of 15°, radii from a
//! short list.

use core::f64::consts::{PI, TAU};

use cspace::{Rotation, Vertex};
use rand::Rng;

/// Loops that may make a part.
pub type Loops = Vec<Vec<Vertex>>;

/// The lattice of corners.
const PITCH: f64 = 0.25;

/// Radii of discs, polygons and corners.
const RADII: [f64; 6] = [0.25, 0.5, 0.75, 1.0, 1.5, 2.0];

/// Sweeps of arcs, in multiples of 15°.
const SWEEPS: [i32; 8] = [1, 2, 3, 4, 6, 8, 12, 14];

/// Number of kinds of outlines.
const KINDS: usize = 9;

/// An outline, turned and shifted.
pub fn outline(rng: &mut impl Rng) -> Loops {
    let drawn = match rng.random_range(0..KINDS) {
        0 | 1 => vec![lattice_star(rng)],
        2 => vec![staircase(rng)],
        3 => vec![regular(rng)],
        4 => rounded(rng),
        5 => ring(rng),
        6 => vec![sector(rng)],
        7 => pieces(rng),
        _ => holed(rng),
    };
    placed(&drawn, rng)
}

/// A plate with a hole of the shape of an outline's first loop, a little larger, smaller or of the same size.
pub fn negative(of: &Loops, rng: &mut impl Rng) -> Loops {
    let play = [0.0, 1e-2, 1e-4, 1e-6, 1e-8, 0.25][rng.random_range(0..6)];
    let reach = of
        .iter()
        .flatten()
        .map(|v| v.x.abs().max(v.y.abs()) * (1.0 + v.bulge.abs()))
        .fold(1.0, f64::max);
    let side = 2.0 * (2.0 * reach).ceil();
    let hole = of[0]
        .iter()
        .map(|v| Vertex::new((1.0 + play) * v.x, (1.0 + play) * v.y, v.bulge));
    vec![rectangle(side, side), hole.collect()]
}

fn one_of<T: Copy>(all: &[T], rng: &mut impl Rng) -> T {
    all[rng.random_range(0..all.len())]
}

fn lattice(rng: &mut impl Rng, least: i32, most: i32) -> f64 {
    PITCH * f64::from(rng.random_range(least..=most))
}

fn bulge(rng: &mut impl Rng) -> f64 {
    let sweep = f64::from(one_of(&SWEEPS, rng)) * (PI / 12.0);
    let b = (0.25 * sweep).tan();
    if rng.random_bool(0.5) { b } else { -b }
}

fn rectangle(width: f64, height: f64) -> Vec<Vertex> {
    let (w, h) = (0.5 * width, 0.5 * height);
    [(-w, -h), (w, -h), (w, h), (-w, h)]
        .map(|(x, y)| Vertex::line(x, y))
        .to_vec()
}

fn circle(x: f64, y: f64, radius: f64) -> Vec<Vertex> {
    vec![
        Vertex::new(x + radius, y, 1.0),
        Vertex::new(x - radius, y, 1.0),
    ]
}

/// Lattice points in order about the origin, some edges arcs.
fn lattice_star(rng: &mut impl Rng) -> Vec<Vertex> {
    let n = rng.random_range(3..9);
    let arcs = one_of(&[0.0, 0.3, 0.7], rng);
    let mut points: Vec<(f64, f64)> = (0..n)
        .map(|_| (lattice(rng, -4, 4), lattice(rng, -4, 4)))
        .filter(|p| *p != (0.0, 0.0))
        .collect();
    points.sort_by(|a, b| a.1.atan2(a.0).total_cmp(&b.1.atan2(b.0)));
    points.dedup_by(|a, b| a.1.atan2(a.0) == b.1.atan2(b.0));
    points
        .iter()
        .map(|&(x, y)| {
            let bulge = if rng.random_bool(arcs) {
                bulge(rng)
            } else {
                0.0
            };
            Vertex::new(x, y, bulge)
        })
        .collect()
}

/// Columns of lattice height side by side: L, T, U, steps and combs.
fn staircase(rng: &mut impl Rng) -> Vec<Vertex> {
    let columns = rng.random_range(1..6);
    let (mut x, mut top) = (0.0, Vec::new());
    for _ in 0..columns {
        let (width, height) = (lattice(rng, 1, 4), lattice(rng, 1, 6));
        top.push((x, height));
        top.push((x + width, height));
        x += width;
    }
    let mut all = vec![Vertex::line(0.0, 0.0), Vertex::line(x, 0.0)];
    for &(x, y) in top.iter().rev() {
        if all.last().is_none_or(|v| (v.x, v.y) != (x, y)) {
            all.push(Vertex::line(x, y));
        }
    }
    all
}

fn regular(rng: &mut impl Rng) -> Vec<Vertex> {
    let n = one_of(&[3, 4, 5, 6, 8, 12], rng);
    let (outer, star) = (one_of(&RADII, rng), rng.random_bool(0.4));
    let inner = outer * one_of(&[0.5, 0.75], rng);
    let corners = if star { 2 * n } else { n };
    let arc = if rng.random_bool(0.2) {
        bulge(rng)
    } else {
        0.0
    };
    (0..corners)
        .map(|i| {
            let r = if star && i % 2 == 1 { inner } else { outer };
            let a = TAU * f64::from(i) / f64::from(corners);
            Vertex::new(r * a.cos(), r * a.sin(), arc)
        })
        .collect()
}

/// A rectangle with rounded corners, or a stadium.
fn rounded(rng: &mut impl Rng) -> Loops {
    let r = one_of(&RADII[..4], rng);
    let (w, h) = (
        r + lattice(rng, 1, 4),
        r + if rng.random_bool(0.3) {
            0.0
        } else {
            lattice(rng, 1, 4)
        },
    );
    let b = (PI / 8.0).tan();
    if h == r {
        let (w, b) = (w - r, 1.0);
        return vec![vec![
            Vertex::line(-w, -r),
            Vertex::new(w, -r, b),
            Vertex::line(w, r),
            Vertex::new(-w, r, b),
        ]];
    }
    let concave = rng.random_bool(0.2);
    let (a, c) = if concave { (-b, r) } else { (b, r) };
    vec![vec![
        Vertex::line(-w + c, -h),
        Vertex::new(w - c, -h, a),
        Vertex::line(w, -h + c),
        Vertex::new(w, h - c, a),
        Vertex::line(w - c, h),
        Vertex::new(-w + c, h, a),
        Vertex::line(-w, h - c),
        Vertex::new(-w, -h + c, a),
    ]]
}

/// A disc, perhaps with a hole.
fn ring(rng: &mut impl Rng) -> Loops {
    let r = one_of(&RADII, rng);
    let mut all = vec![circle(0.0, 0.0, r)];
    if rng.random_bool(0.5) {
        let shift = if rng.random_bool(0.3) { 0.25 * r } else { 0.0 };
        all.push(circle(shift, 0.0, r * one_of(&[0.25, 0.5, 0.625], rng)));
    }
    all
}

/// A sector of a ring or of a disc.
fn sector(rng: &mut impl Rng) -> Vec<Vertex> {
    let outer = one_of(&RADII[1..], rng);
    let sweep = f64::from(rng.random_range(2..23)) * (PI / 12.0);
    let b = (0.25 * sweep).tan();
    let at = |r: f64, a: f64| (r * a.cos(), r * a.sin());
    let ((x0, y0), (x1, y1)) = (at(outer, 0.0), at(outer, sweep));
    let mut all = vec![Vertex::new(x0, y0, b), Vertex::line(x1, y1)];
    if rng.random_bool(0.5) {
        let inner = outer * one_of(&[0.25, 0.5, 0.75], rng);
        let ((x2, y2), (x3, y3)) = (at(inner, sweep), at(inner, 0.0));
        all.extend([Vertex::new(x2, y2, -b), Vertex::line(x3, y3)]);
    } else {
        all.push(Vertex::line(0.0, 0.0));
    }
    all
}

/// Discs and rectangles on the lattice.
fn pieces(rng: &mut impl Rng) -> Loops {
    (0..rng.random_range(2..5))
        .map(|i| {
            let (x, y) = (1.25 * f64::from(i), lattice(rng, -2, 2));
            if rng.random_bool(0.5) {
                circle(x, y, one_of(&RADII[..2], rng))
            } else {
                let r = rectangle(lattice(rng, 1, 4), lattice(rng, 1, 4));
                r.iter().map(|v| Vertex::line(v.x + x, v.y + y)).collect()
            }
        })
        .collect()
}

/// A plate with a few holes on the lattice.
fn holed(rng: &mut impl Rng) -> Loops {
    let (columns, rows) = (rng.random_range(1..4), rng.random_range(1..3));
    let (w, h) = (1.5 * f64::from(columns), 1.5 * f64::from(rows));
    let mut all = vec![rectangle(w, h)];
    for i in 0..columns * rows {
        let x = 1.5 * (f64::from(i % columns) + 0.5) - 0.5 * w;
        let y = 1.5 * (f64::from(i / columns) + 0.5) - 0.5 * h;
        let hole = match rng.random_range(0..3) {
            0 => circle(0.0, 0.0, one_of(&[0.25, 0.5, 0.625], rng)),
            1 => rectangle(lattice(rng, 1, 5), lattice(rng, 1, 5)),
            _ => {
                let s = 0.5 / RADII[5];
                regular(rng)
                    .iter()
                    .map(|v| Vertex::new(s * v.x, s * v.y, v.bulge))
                    .collect()
            }
        };
        all.push(
            hole.iter()
                .map(|v| Vertex::new(v.x + x, v.y + y, v.bulge))
                .collect(),
        );
    }
    all
}

/// Turned by a multiple of 15°, mirrored, shifted along the lattice, or none of it.
fn placed(loops: &Loops, rng: &mut impl Rng) -> Loops {
    let mirror = rng.random_bool(0.2);
    let (dx, dy) = if rng.random_bool(0.3) {
        (lattice(rng, -8, 8), lattice(rng, -8, 8))
    } else {
        (0.0, 0.0)
    };
    let turn = if rng.random_bool(0.3) {
        Some(Rotation::by(
            f64::from(rng.random_range(1..24)) * (PI / 12.0),
        ))
    } else {
        None
    };
    let map = |v: &Vertex| {
        let p = turn.map_or(v.point(), |t| t * v.point());
        if mirror {
            Vertex::new(-p.x + dx, p.y + dy, -v.bulge)
        } else {
            Vertex::new(p.x + dx, p.y + dy, v.bulge)
        }
    };
    loops.iter().map(|l| l.iter().map(map).collect()).collect()
}
