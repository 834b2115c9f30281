//! A peg and a chamfered hole, in section.

use clap::Args;

use super::page::{Page, about, length, length_or_none, number};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub(crate) struct Peg {
    /// Diameter of the peg
    #[arg(long, value_name = "D", default_value_t = 10.0, value_parser = length)]
    diameter: f64,
    /// How much wider the hole is than the peg: the difference of the diameters
    #[arg(long, value_name = "L", default_value_t = 0.1, value_parser = length)]
    clearance: f64,
    /// Depth of the hole, its chamfer included
    #[arg(long, value_name = "L", default_value_t = 20.0, value_parser = length)]
    depth: f64,
    /// Chamfer of the hole, at 45 degrees; 0 for none
    #[arg(long, value_name = "L", default_value_t = 1.0, value_parser = length_or_none)]
    chamfer: f64,
}

impl Peg {
    pub(super) fn text(&self) -> Result<String, Failure> {
        let Self {
            diameter,
            clearance,
            depth,
            chamfer,
        } = *self;
        if chamfer >= depth {
            return Err(Failure::input(format_args!(
                "the chamfer, {chamfer}, is as deep as the hole, {depth}"
            ))
            .help("give a --chamfer less than --depth"));
        }
        let (half, hole) = (0.5 * diameter, 0.5 * (diameter + clearance));
        let (side, foot) = (hole + chamfer + diameter, depth + half);
        let length = depth + diameter.max(0.5 * depth);
        let comment = format!(
            "\
A peg of diameter {d} and a hole of diameter {w}, in section.

The hole is {h} deep, with a chamfer of {c} x 45 deg. The block has its origin in the middle of the
mouth, the peg in the middle of its end: (x, y, theta) = (0, 0, 0) is the peg with its end in the
mouth, (0, -{h}, 0) the peg on the bottom of the hole.

  sideways in the hole   x from -{s} to {s}, half the clearance of {cl} either way
  caught by the chamfer  x within {e} of the middle: the half clearance and the chamfer

Written by: cspace new peg --diameter {d} --clearance {cl} --depth {h} --chamfer {c}
Ask it:     cspace compute FILE
            printf 'x,y,theta\\n0,-{m},0\\n{cl},-{m},0\\n' | cspace classify FILE",
            d = number(diameter),
            w = number(2.0 * hole),
            h = number(depth),
            c = number(chamfer),
            cl = number(clearance),
            s = about(0.5 * clearance, 6),
            e = about(0.5 * clearance + chamfer, 6),
            m = number(0.5 * depth),
        );
        let mut page = Page::new(&comment, "peg in hole", side);
        page.part("The first part of a pair is fixed.", "block", "");
        page.begin_loop("section");
        page.vertex((-side, 0.0), "face");
        if chamfer > 0.0 {
            page.vertex((-hole - chamfer, 0.0), "chamfer");
            page.vertex((-hole, -chamfer), "hole");
        } else {
            page.vertex((-hole, 0.0), "hole");
        }
        page.vertex((-hole, -depth), "bottom");
        page.vertex((hole, -depth), "hole");
        if chamfer > 0.0 {
            page.vertex((hole, -chamfer), "chamfer");
        }
        page.vertex((hole + chamfer, 0.0), "face");
        page.vertex((side, 0.0), "");
        page.vertex((side, -foot), "");
        page.vertex((-side, -foot), "");
        page.end_loop();
        page.end_part();
        page.part("The second part moves.", "peg", "");
        page.begin_loop("outline");
        page.vertex((-half, 0.0), "end");
        page.vertex((half, 0.0), "side");
        page.vertex((half, length), "top");
        page.fillet(0.5 * half, "rounds the vertex before");
        page.vertex((-half, length), "side");
        page.fillet(0.5 * half, "");
        page.end_loop();
        page.end_part();
        page.finish()
    }
}
