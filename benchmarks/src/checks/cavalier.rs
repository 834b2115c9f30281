//! Checks by `cavalier_contours`, whose polylines have arcs: each loop of one part against each of the other.

use std::time::Instant;

use cavalier_contours::polyline::{
    PlineContainsOptions, PlineContainsResult, PlineSource, PlineSourceMut, Polyline,
};
use cspace::{Configuration, Part, Point};

use super::Checker;
use crate::models::Pair;

/// Loops with places given to `place`; bulges mean the same there.
fn polylines(part: &Part, place: impl Fn(Point) -> Point) -> Vec<Polyline<f64>> {
    let polyline = |l: &cspace::Loop| {
        let mut polyline = Polyline::new_closed();
        for v in l.vertices() {
            let p = place(v.point());
            polyline.add(p.x, p.y, v.bulge);
        }
        polyline
    };
    part.loops().iter().map(polyline).collect()
}

pub(super) fn checker(pair: &Pair) -> Checker<'_> {
    /// Positions nearer than this share of the size are equal to it: as near as lets it see the smallest distances asked for.
    const EQUAL: f64 = 1e-11;
    let begin = Instant::now();
    let fixed = polylines(&pair.fixed, |p| p);
    let indices: Vec<_> = fixed.iter().map(|l| l.create_approx_aabb_index()).collect();
    let equal = EQUAL * pair.fixed.size().max(pair.moving.size());
    let prepared_seconds = begin.elapsed().as_secs_f64();
    let overlaps = move |c: Configuration| {
        let moving = polylines(&pair.moving, |p| c.fixed_from_moving(p));
        // Of loops that do not meet: how many of one part are around each of the other.
        let mut around_moving = vec![0; moving.len()];
        for (f, index) in fixed.iter().zip(&indices) {
            let mut around_fixed = 0;
            for (m, around) in moving.iter().zip(&mut around_moving) {
                let options = PlineContainsOptions {
                    pline1_aabb_index: Some(index),
                    pos_equal_eps: equal,
                };
                match f.contains_opt(m, &options) {
                    PlineContainsResult::Intersected => return Some(true),
                    PlineContainsResult::Pline1InsidePline2 => around_fixed += 1,
                    PlineContainsResult::Pline2InsidePline1 => *around += 1,
                    PlineContainsResult::Disjoint => {}
                    PlineContainsResult::InvalidInput => return None,
                }
            }
            // Inside an odd number of loops: in the material.
            if around_fixed % 2 == 1 {
                return Some(true);
            }
        }
        Some(around_moving.iter().any(|n| n % 2 == 1))
    };
    Checker {
        name: "cavalier_contours",
        prepared_seconds,
        overlaps: Box::new(overlaps),
    }
}
