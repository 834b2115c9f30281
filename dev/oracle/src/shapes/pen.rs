//! Drawing loops.

use core::f64::consts::FRAC_PI_2;

use cspace::{Part, Point, Vector, Vertex};

/// A loop being drawn.
#[derive(Debug, Clone)]
pub struct Pen {
    vertices: Vec<Vertex>,
}

impl Pen {
    /// Starts a loop.
    pub fn at(x: f64, y: f64) -> Self {
        Self {
            vertices: vec![Vertex::line(x, y)],
        }
    }

    /// Draws a line.
    pub fn line(self, x: f64, y: f64) -> Self {
        self.arc(x, y, 0.0)
    }

    /// Draws an arc whose bulge is tan(sweep/4).
    pub fn arc(mut self, x: f64, y: f64, bulge: f64) -> Self {
        if let Some(last) = self.vertices.last_mut() {
            last.bulge = bulge;
        }
        self.vertices.push(Vertex::line(x, y));
        self
    }

    /// Draws an arc through a point between its ends.
    pub fn through(self, by: Point, to: Point) -> Self {
        let from = self.vertices[self.vertices.len() - 1].point();
        self.arc(to.x, to.y, bulge_through(from, by, to))
    }

    /// Ends the loop with a line to where it began.
    pub fn close(self) -> Vec<Vertex> {
        self.vertices
    }

    /// Ends the loop with an arc to where it began.
    pub fn close_arc(mut self, bulge: f64) -> Vec<Vertex> {
        if let Some(last) = self.vertices.last_mut() {
            last.bulge = bulge;
        }
        self.vertices
    }
}

/// The bulge of the arc from one point by a second to a third.
pub fn bulge_through(from: Point, by: Point, to: Point) -> f64 {
    // The two chords' directions differ by half the sweep.
    let (u, v) = (by - from, to - by);
    (0.5 * u.cross(v).atan2(u.dot(v))).tan()
}

/// The bulge of an arc of `sweep` radians, counter-clockwise when positive.
pub fn bulge_of(sweep: f64) -> f64 {
    (0.25 * sweep).tan()
}

/// The point at `radius` in the direction of `angle` from `center`.
pub fn polar(center: Point, radius: f64, angle: f64) -> Point {
    center + Vector::from_angle(angle) * radius
}

/// The part with these loops.
///
/// # Panics
/// If the loops are not a part.
pub fn part(name: impl Into<String>, loops: Vec<Vec<Vertex>>) -> Part {
    let name = name.into();
    Part::new(name.clone(), loops).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// A circle of two half-circle arcs, as a loop.
pub fn circle_loop(center: Point, radius: f64) -> Vec<Vertex> {
    Pen::at(center.x + radius, center.y)
        .arc(center.x - radius, center.y, 1.0)
        .close_arc(1.0)
}

/// An axis-aligned rectangle, as a loop.
pub fn rectangle_loop(low: Point, high: Point) -> Vec<Vertex> {
    Pen::at(low.x, low.y)
        .line(high.x, low.y)
        .line(high.x, high.y)
        .line(low.x, high.y)
        .close()
}

/// A rectangle about the origin whose corners are quarter circles, as a loop.
pub fn rounded_rectangle_loop(width: f64, height: f64, radius: f64) -> Vec<Vertex> {
    let (w, h, r) = (0.5 * width, 0.5 * height, radius);
    let b = bulge_of(FRAC_PI_2);
    Pen::at(-w + r, -h)
        .line(w - r, -h)
        .arc(w, -h + r, b)
        .line(w, h - r)
        .arc(w - r, h, b)
        .line(-w + r, h)
        .arc(-w, h - r, b)
        .line(-w, -h + r)
        .close_arc(b)
}
