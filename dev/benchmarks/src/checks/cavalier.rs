//! Checks by `cavalier_contours`, whose polylines have arcs: each loop of one part against each of the other.

use std::time::Instant;

use cavalier_contours::polyline::{
    PlineContainsOptions, PlineContainsResult, PlineSource, PlineSourceMut, Polyline,
};
use cspace::{Configuration, Edge, Part, Point, Rotation};

use super::Checker;
use crate::models::Pair;

/// A part's loops by corners and bulges, which mean the same there; arcs of more than half a turn, which it takes wrongly, in two.
fn corners(part: &Part) -> Vec<Vec<(Point, f64)>> {
    let add = |e: Edge, corners: &mut Vec<(Point, f64)>| {
        if e.bulge.abs() > 1.0 {
            let (sweep, center) = (e.sweep(), e.center());
            let half = (0.125 * sweep).tan();
            let middle = center + Rotation::by(0.5 * sweep) * (e.start - center);
            corners.extend([(e.start, half), (middle, half)]);
        } else {
            corners.push((e.start, e.bulge));
        }
    };
    let corners = |l: &cspace::Loop| {
        let mut corners = Vec::new();
        for e in l.edges() {
            add(e, &mut corners);
        }
        corners
    };
    part.loops().iter().map(corners).collect()
}

fn polylines(loops: &[Vec<(Point, f64)>], place: impl Fn(Point) -> Point) -> Vec<Polyline<f64>> {
    let polyline = |l: &Vec<(Point, f64)>| {
        let mut polyline = Polyline::new_closed();
        for &(p, bulge) in l {
            let p = place(p);
            polyline.add(p.x, p.y, bulge);
        }
        polyline
    };
    loops.iter().map(polyline).collect()
}

pub(super) fn checker(pair: &Pair) -> Checker<'static> {
    /// Distance, as a share of the size, within which positions count as equal: small enough for the smallest distances
    /// tested.
    const EQUAL: f64 = 1e-11;
    let begin = Instant::now();
    let fixed = polylines(&corners(&pair.fixed), |p| p);
    let drawn = corners(&pair.moving);
    let indices: Vec<_> = fixed.iter().map(|l| l.create_approx_aabb_index()).collect();
    let equal = EQUAL * pair.fixed.size().max(pair.moving.size());
    let prepared_seconds = begin.elapsed().as_secs_f64();
    let overlaps = move |c: Configuration| {
        let moving = polylines(&drawn, |p| c.fixed_from_moving(p));
        // For loops that do not meet: the number of loops of one part around each loop of the other.
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
