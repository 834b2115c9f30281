//! Lenses, crescents, rings with a gap.

use core::f64::consts::TAU;

use cspace::{Part, Point};

use super::pen::{Pen, bulge_of, part, polar};

/// Two equal convex arcs over a chord of length `2 half_width` on the first axis.
pub fn lens(half_width: f64, bulge: f64) -> Part {
    part(
        "lens",
        vec![
            Pen::at(-half_width, 0.0)
                .arc(half_width, 0.0, bulge)
                .close_arc(bulge),
        ],
    )
}

/// A convex and a concave arc between the horns (0, ±`half_height`), both to the right of them.
pub fn crescent(half_height: f64, outer_bulge: f64, inner_bulge: f64) -> Part {
    part(
        "crescent",
        vec![
            Pen::at(0.0, -half_height)
                .arc(0.0, half_height, outer_bulge)
                .close_arc(-inner_bulge),
        ],
    )
}

/// The sector of a ring about the origin between two angles, its ends radial.
pub fn ring_sector(outer: f64, inner: f64, from: f64, to: f64) -> Part {
    let at = |r: f64, angle: f64| polar(Point::ORIGIN, r, angle);
    let b = bulge_of(to - from);
    let [p, q, r, s] = [
        at(outer, from),
        at(outer, to),
        at(inner, to),
        at(inner, from),
    ];
    part(
        "ring sector",
        vec![
            Pen::at(p.x, p.y)
                .arc(q.x, q.y, b)
                .line(r.x, r.y)
                .arc(s.x, s.y, -b)
                .close(),
        ],
    )
}

/// A ring about the origin with a gap of `2 half_gap` radians about the first axis. It cages a disc wider than the gap.
pub fn c_shape(outer: f64, inner: f64, half_gap: f64) -> Part {
    let p = ring_sector(outer, inner, half_gap, TAU - half_gap);
    part("C", vec![p.loops()[0].vertices().to_vec()])
}
