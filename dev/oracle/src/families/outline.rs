//! Loops from which families are drawn: nothing is checked here, since some are no parts.

use core::f64::consts::TAU;

use cspace::{Part, Point, Rotation, Vector, Vertex};

use crate::shapes::{circle_loop, polar, rectangle_loop, rounded_rectangle_loop};

/// Loops that may make a part.
pub type Loops = Vec<Vec<Vertex>>;

pub(super) fn line(x: f64, y: f64) -> Vertex {
    Vertex::line(x, y)
}

pub(super) fn arc(x: f64, y: f64, bulge: f64) -> Vertex {
    Vertex::new(x, y, bulge)
}

pub(super) fn rectangle(width: f64, height: f64) -> Loops {
    let (w, h) = (0.5 * width, 0.5 * height);
    vec![rectangle_loop(Point::new(-w, -h), Point::new(w, h))]
}

pub(super) fn disc(radius: f64) -> Loops {
    vec![circle_loop(Point::ORIGIN, radius)]
}

/// A regular polygon, one corner on the first axis.
pub(super) fn polygon(corners: usize, radius: f64) -> Loops {
    let step = TAU / corners as f64;
    vec![around(corners, |i| (radius, step * i as f64))]
}

/// A star of that many points.
pub(super) fn star(points: usize, outer: f64, inner: f64) -> Loops {
    let step = 0.5 * TAU / points as f64;
    vec![around(2 * points, |i| {
        (
            if i.is_multiple_of(2) { outer } else { inner },
            step * i as f64,
        )
    })]
}

fn around(corners: usize, at: impl Fn(usize) -> (f64, f64)) -> Vec<Vertex> {
    (0..corners)
        .map(|i| {
            let (radius, angle) = at(i);
            let p = polar(Point::ORIGIN, radius, angle);
            line(p.x, p.y)
        })
        .collect()
}

/// A rectangle with quarter circles for corners.
pub(super) fn rounded(width: f64, height: f64, radius: f64) -> Loops {
    vec![rounded_rectangle_loop(width, height, radius)]
}

/// A square plate with holes.
pub(super) fn plate(side: f64, holes: Loops) -> Loops {
    let mut all = rectangle(side, side);
    all.extend(holes);
    all
}

/// The loops of a part.
pub fn loops_of(part: &Part) -> Loops {
    part.loops().iter().map(|l| l.vertices().to_vec()).collect()
}

pub(super) fn scaled(loops: &Loops, factor: f64) -> Loops {
    mapped(loops, |v| Vertex::new(factor * v.x, factor * v.y, v.bulge))
}

pub(super) fn shifted(loops: &Loops, dx: f64, dy: f64) -> Loops {
    mapped(loops, |v| {
        let p = v.point() + Vector::new(dx, dy);
        Vertex::new(p.x, p.y, v.bulge)
    })
}

pub(super) fn turned(loops: &Loops, angle: f64) -> Loops {
    let turn = Rotation::by(angle);
    mapped(loops, |v| {
        let p = turn * v.point();
        Vertex::new(p.x, p.y, v.bulge)
    })
}

fn mapped(loops: &Loops, f: impl Fn(&Vertex) -> Vertex) -> Loops {
    loops.iter().map(|l| l.iter().map(&f).collect()).collect()
}

/// A disc elsewhere.
pub(super) fn disc_at(x: f64, y: f64, radius: f64) -> Vec<Vertex> {
    circle_loop(Point::new(x, y), radius)
}
