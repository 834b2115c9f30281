//! Rectangles, polygons and discs.

use core::f64::consts::TAU;

use cspace::{Part, Point};

use super::pen::{Pen, bulge_of, circle_loop, part, polar, rectangle_loop, rounded_rectangle_loop};

/// An axis-aligned rectangle about the origin.
pub fn rectangle(width: f64, height: f64) -> Part {
    let high = Point::new(0.5 * width, 0.5 * height);
    part(
        "rectangle",
        vec![rectangle_loop(Point::new(-high.x, -high.y), high)],
    )
}

/// A square about the origin.
pub fn square(side: f64) -> Part {
    rectangle(side, side)
}

/// A regular polygon about the origin, its first corner on the first axis.
pub fn regular_polygon(corners: usize, radius: f64) -> Part {
    let corner = |i: usize| polar(Point::ORIGIN, radius, TAU * i as f64 / corners as f64);
    let first = corner(0);
    let pen = (1..corners).fold(Pen::at(first.x, first.y), |pen, i| {
        let p = corner(i);
        pen.line(p.x, p.y)
    });
    part(format!("{corners}-gon"), vec![pen.close()])
}

/// A disc about the origin, bounded by two half circles.
pub fn circle(radius: f64) -> Part {
    part("disc", vec![circle_loop(Point::ORIGIN, radius)])
}

/// A ring between two circles about the origin.
pub fn annulus(outer: f64, inner: f64) -> Part {
    part(
        "annulus",
        vec![
            circle_loop(Point::ORIGIN, outer),
            circle_loop(Point::ORIGIN, inner),
        ],
    )
}

/// Half a disc about the origin: the half above the first axis.
pub fn half_disc(radius: f64) -> Part {
    part(
        "half disc",
        vec![Pen::at(-radius, 0.0).line(radius, 0.0).close_arc(1.0)],
    )
}

/// A disc with a flat: one arc of `sweep` radians, up to nearly a full turn, and the line that closes it, on the right.
pub fn flatted_disc(radius: f64, sweep: f64) -> Part {
    let half = 0.5 * (TAU - sweep);
    let (from, to) = (
        polar(Point::ORIGIN, radius, half),
        polar(Point::ORIGIN, radius, -half),
    );
    part(
        "disc with a flat",
        vec![
            Pen::at(from.x, from.y)
                .arc(to.x, to.y, bulge_of(sweep))
                .close(),
        ],
    )
}

/// A rectangle about the origin whose corners are quarter circles.
pub fn rounded_rectangle(width: f64, height: f64, radius: f64) -> Part {
    part(
        "rounded rectangle",
        vec![rounded_rectangle_loop(width, height, radius)],
    )
}
