//! Symmetric parts in their own negatives, with themselves, and nearly symmetric.

use super::outline::*;
use super::{Case, Family, counting, family, powers};
use crate::shapes::gear;
use core::f64::consts::PI;

pub(super) fn add(all: &mut Vec<Family>) {
    let corners = [3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 20, 25, 32, 50, 64, 100];
    all.push(counting(
        "polygon in a little larger negative, corners",
        &corners,
        |n| {
            let p = polygon(n as usize, 1.0);
            Ok(Case::new(plate(4.0, scaled(&p, 1.001)), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "polygon in its negative, corners",
        &[3, 4, 5, 6, 8, 12, 20, 50],
        |n| {
            let p = polygon(n as usize, 1.0);
            Ok(Case::new(plate(4.0, p.clone()), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "polygon with itself, corners",
        &[3, 4, 5, 6, 7, 8, 9, 12, 20, 50],
        |n| {
            let p = polygon(n as usize, 1.0);
            Ok(Case::new(p.clone(), p)?.about(&[(2.0, 0.0, 0.0), (2.0, 0.0, PI)]))
        },
    ));
    all.push(counting(
        "star in a little larger negative, points",
        &[3, 4, 5, 6, 7, 8, 12],
        |n| {
            let p = star(n as usize, 1.0, 0.5);
            Ok(Case::new(plate(4.0, scaled(&p, 1.01)), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "star in its negative, points",
        &[3, 5, 6, 8],
        |n| {
            let p = star(n as usize, 1.0, 0.5);
            Ok(Case::new(plate(4.0, p.clone()), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting(
        "star with itself, points",
        &[3, 4, 5, 6, 7, 8, 12],
        |n| {
            let p = star(n as usize, 1.0, 0.4);
            Ok(Case::new(p.clone(), p)?.about(&[(1.4, 0.0, 0.0), (1.4, 0.0, PI)]))
        },
    ));
    all.push(counting(
        "gear in a little larger negative, teeth",
        &[6, 8, 10],
        |n| {
            let p = loops_of(&gear(n as usize, 1.0));
            Ok(Case::new(plate(4.0 * n, scaled(&p, 1.01)), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(counting("gear with itself, teeth", &[6, 8, 10], |n| {
        let p = loops_of(&gear(n as usize, 1.0));
        Ok(Case::new(p.clone(), p)?.about(&[(n + 0.05, 0.0, 0.0)]))
    }));
    all.push(family(
        "hexagons, one corner moved by",
        powers(-1, -15),
        |d| {
            let mut p = polygon(6, 1.0);
            p[0][0].x += d;
            Ok(Case::new(plate(4.0, polygon(6, 1.1)), p)?.about(&[(0.0, 0.0, 0.0)]))
        },
    ));
    all.push(family("L with itself, turned by", powers(0, -15), |t| {
        let l = vec![vec![
            line(0.0, 0.0),
            line(2.0, 0.0),
            line(2.0, 1.0),
            line(1.0, 1.0),
            line(1.0, 2.0),
            line(0.0, 2.0),
        ]];
        Ok(Case::new(l.clone(), turned(&l, t))?.about(&[(1.0, 1.0, -t), (2.0, 0.0, -t)]))
    }));
}
