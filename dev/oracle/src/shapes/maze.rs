//! A maze.

use core::f64::consts::TAU;

use cspace::Part;

use super::pen::{Pen, bulge_of, part};

/// A square plate from (0, 0) to (10, 10) with a winding corridor of width 1 that opens at (1.5, 10) and ends in a round
/// chamber of radius 1 about (7.5, 2.5).
pub fn maze() -> Part {
    let chamber = 2.5 + 0.75_f64.sqrt();
    part(
        "maze",
        vec![
            Pen::at(0.0, 0.0)
                .line(10.0, 0.0)
                .line(10.0, 10.0)
                .line(2.0, 10.0)
                .line(2.0, 2.0)
                .line(4.0, 2.0)
                .line(4.0, 9.0)
                .line(7.5, 9.0)
                .arc(8.0, 8.5, bulge_of(-0.25 * TAU))
                .line(8.0, chamber)
                .arc(7.0, chamber, bulge_of(-TAU * 5.0 / 6.0))
                .line(7.0, 8.0)
                .line(5.0, 8.0)
                .line(5.0, 1.0)
                .line(1.0, 1.0)
                .line(1.0, 10.0)
                .line(0.0, 10.0)
                .close(),
        ],
    )
}
