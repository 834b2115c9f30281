//! Pegs, holes, sockets, and plates with holes.

use cspace::{Part, Point, Vertex};

use super::basic::{rectangle, square};
use super::pen::{Pen, circle_loop, part};

/// A bar from the origin down: its lower end is at (0, −`length`).
pub fn peg(width: f64, length: f64) -> Part {
    let w = 0.5 * width;
    part(
        "peg",
        vec![
            Pen::at(-w, -length)
                .line(w, -length)
                .line(w, 0.0)
                .line(-w, 0.0)
                .close(),
        ],
    )
}

/// A bar from the origin down whose lower end is a half circle.
pub fn rounded_peg(width: f64, length: f64) -> Part {
    let w = 0.5 * width;
    part(
        "rounded peg",
        vec![
            Pen::at(-w, -length + w)
                .arc(w, -length + w, 1.0)
                .line(w, 0.0)
                .line(-w, 0.0)
                .close(),
        ],
    )
}

/// A block below the first axis with a slot from its top, whose mouth is chamfered when `chamfer` is positive.
pub fn slotted_block(block: f64, slot: f64, depth: f64, chamfer: f64) -> Part {
    let (b, h, c) = (0.5 * block, 0.5 * slot, chamfer);
    let mut pen = Pen::at(-b, -2.0 * depth)
        .line(b, -2.0 * depth)
        .line(b, 0.0)
        .line(h + c, 0.0);
    if c > 0.0 {
        pen = pen.line(h, -c);
    }
    pen = pen.line(h, -depth).line(-h, -depth);
    if c > 0.0 {
        pen = pen.line(-h, -c);
    }
    part(
        "slotted block",
        vec![pen.line(-h - c, 0.0).line(-b, 0.0).close()],
    )
}

/// A block below the first axis with a half-round socket about the origin.
pub fn socket(radius: f64) -> Part {
    let r = radius;
    part(
        "socket",
        vec![
            Pen::at(-2.0 * r, -2.0 * r)
                .line(2.0 * r, -2.0 * r)
                .line(2.0 * r, 0.0)
                .line(r, 0.0)
                .arc(-r, 0.0, -1.0)
                .line(-2.0 * r, 0.0)
                .close(),
        ],
    )
}

/// A square about the origin with the given holes.
pub fn plate(side: f64, holes: &[&Part]) -> Part {
    let mut loops: Vec<Vec<Vertex>> = vec![loop_of(&square(side))];
    loops.extend(holes.iter().map(|p| loop_of(p)));
    part("plate", loops)
}

/// A rectangle about the origin with three round holes on the first axis, `pitch` apart.
pub fn three_holes(pitch: f64, radius: f64) -> Part {
    let mut loops = vec![loop_of(&rectangle(4.0 * pitch, 2.0 * pitch))];
    loops.extend(row_of_circles(pitch, radius));
    part("plate with three holes", loops)
}

/// Three discs on the first axis, `pitch` apart, in one part.
pub fn three_pegs(pitch: f64, radius: f64) -> Part {
    part("three pegs", row_of_circles(pitch, radius).collect())
}

fn row_of_circles(pitch: f64, radius: f64) -> impl Iterator<Item = Vec<Vertex>> {
    [-1.0, 0.0, 1.0]
        .into_iter()
        .map(move |i| circle_loop(Point::new(i * pitch, 0.0), radius))
}

fn loop_of(p: &Part) -> Vec<Vertex> {
    p.loops()[0].vertices().to_vec()
}
