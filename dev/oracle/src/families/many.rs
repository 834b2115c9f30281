//! Many holes, spirals and combs.

use core::f64::consts::{FRAC_PI_2, PI};

use cspace::{Point, Vertex};

use super::outline::*;
use super::{Case, Family, counting};
use crate::shapes::{bulge_of, polar};

pub(super) fn add(all: &mut Vec<Family>) {
    all.push(counting(
        "peg over a plate with holes, holes a side",
        &[1, 2, 3, 4, 5],
        |n| {
            let holes = grid(n as usize, |x, y| disc_at(x, y, 0.3));
            Ok(Case::new(plate(n + 1.0, holes), rounded(0.5, 0.3, 0.1))?.about(&[(0.0, 0.0, 0.3)]))
        },
    ));
    all.push(counting(
        "square over a plate with square holes, holes a side",
        &[1, 2, 3, 4, 5],
        |n| {
            let holes = grid(n as usize, |x, y| {
                shifted(&rectangle(0.6, 0.6), x, y).swap_remove(0)
            });
            Ok(Case::new(plate(n + 1.0, holes), rectangle(0.5, 0.5))?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "bar in a spiral of half circles, half turns",
        &[2, 3, 4, 6, 8],
        |n| Ok(Case::new(round_spiral(n as usize), rectangle(0.3, 0.2))?.about(&[(0.0, 0.0, 0.0)])),
    ));
    all.push(counting("bar in a square spiral, quarter turns", &[3, 4, 6, 8, 12], |n| {
        Ok(Case::new(square_spiral(n as usize), rectangle(0.6, 0.4))?.about(&[(0.0, 0.0, 0.0)]))
    }));
    all.push(counting("combs, teeth", &[2, 3, 5, 8, 12], |n| {
        let c = comb(n as usize);
        Ok(Case::new(c.clone(), turned(&c, PI))?.about(&[
            (n, 2.5, 0.0),
            (n - 1.0, 2.2, 0.0),
            (n, 2.0, 0.0),
        ]))
    }));
}

fn grid(n: usize, hole: impl Fn(f64, f64) -> Vec<Vertex>) -> Loops {
    let at = |i: usize| i as f64 - 0.5 * (n as f64 - 1.0);
    (0..n * n).map(|k| hole(at(k % n), at(k / n))).collect()
}

/// Teeth of width 0.45 and height 1, one apart, on a bar.
fn comb(teeth: usize) -> Loops {
    let mut all = vec![line(0.0, 0.0), line(teeth as f64, 0.0)];
    for i in (0..teeth).rev() {
        let x = i as f64;
        all.extend([
            line(x + 0.95, 0.5),
            line(x + 0.95, 1.5),
            line(x + 0.5, 1.5),
            line(x + 0.5, 0.5),
        ]);
    }
    all.push(line(0.0, 0.5));
    vec![all]
}

/// A wall of thickness 0.2 along half circles of radius 0.5, 1, 1.5, …
fn round_spiral(half_turns: usize) -> Loops {
    // The middle line's radii grow by half the pitch, and centres change sides.
    let place = |k: usize, offset: f64| {
        let side = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let r = 0.5 + 0.5 * k as f64;
        let center = if k.is_multiple_of(2) { 0.0 } else { 0.5 };
        (Point::new(center, 0.0), r + offset, side)
    };
    let mut outer = Vec::new();
    let mut inner = Vec::new();
    for k in 0..half_turns {
        let (c, r, side) = place(k, 0.1);
        outer.push(arc(c.x + side * r, 0.0, bulge_of(PI)));
        let (c, r, side) = place(k, -0.1);
        inner.push((c.x + side * r, c.x - side * r));
    }
    let (c, r, side) = place(half_turns - 1, 0.1);
    outer.push(line(c.x - side * r, 0.0));
    for &(_, end) in inner.iter().rev() {
        outer.push(arc(end, 0.0, -bulge_of(PI)));
    }
    outer.push(line(inner[0].0, 0.0));
    vec![outer]
}

/// A wall of thickness 0.2 along a square spiral of pitch 1.
fn square_spiral(quarter_turns: usize) -> Loops {
    let corner = |k: usize, offset: f64| {
        let r = (0.5 + 0.25 * k as f64 + offset) * core::f64::consts::SQRT_2;
        let p = polar(Point::ORIGIN, r, 0.5 * FRAC_PI_2 + FRAC_PI_2 * k as f64);
        line(p.x, p.y)
    };
    let n = quarter_turns + 1;
    let mut all: Vec<Vertex> = (0..n).map(|k| corner(k, 0.1)).collect();
    all.extend((0..n).rev().map(|k| corner(k, -0.1)));
    vec![all]
}
