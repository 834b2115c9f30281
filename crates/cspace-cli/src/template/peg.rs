//! A peg and a chamfered hole, in section.

use clap::Args;

use super::page::{Page, STEEL, about, length, length_or_none, number};
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
            return Err(Failure::new(format_args!(
                "the chamfer, {chamfer}, is as deep as the hole, {depth}"
            ))
            .help("give a --chamfer less than --depth"));
        }
        let hole = 0.5 * (diameter + clearance);
        let side = hole + chamfer + diameter;
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
        page.world("gravity = [0, -9810]\nfriction = 0.15\nrestitution = 0.3");
        page.parameters();
        page.parameter("diameter", diameter, "of the peg");
        page.parameter("clearance", clearance, "the hole is wider by this");
        page.parameter("depth", depth, "of the hole, its chamfer included");
        page.parameter("chamfer", chamfer, "at 45 degrees");
        page.derived("hole", "(diameter + clearance)/2");
        page.derived("side", "hole + chamfer + diameter");
        page.derived("top", "depth + max(diameter, depth/2)");
        page.part_with("The first part of a pair is fixed.", "block", "", &[STEEL]);
        page.begin_loop("section");
        page.corner("-side", "0", "face");
        if chamfer > 0.0 {
            page.corner("-hole - chamfer", "0", "chamfer");
            page.corner("-hole", "-chamfer", "hole");
        } else {
            page.corner("-hole", "0", "hole");
        }
        page.corner("-hole", "-depth", "bottom");
        page.corner("hole", "-depth", "hole");
        if chamfer > 0.0 {
            page.corner("hole", "-chamfer", "chamfer");
        }
        page.corner("hole + chamfer", "0", "face");
        page.corner("side", "0", "");
        page.corner("side", "-depth - diameter/2", "");
        page.corner("-side", "-depth - diameter/2", "");
        page.end_loop();
        page.end_part();
        page.part_with(
            "The second part moves.",
            "peg",
            "",
            &[
                STEEL,
                "start = [\"clearance/4 + chamfer/2\", \"diameter/2\", 0]",
            ],
        );
        page.begin_loop("outline");
        page.corner("-diameter/2", "0", "end");
        page.corner("diameter/2", "0", "side");
        page.corner("diameter/2", "top", "top");
        page.rounding("diameter/4", "rounds the vertex before");
        page.corner("-diameter/2", "top", "side");
        page.rounding("diameter/4", "");
        page.end_loop();
        page.end_part();
        page.requirement(
            "What `cspace check FILE` measures: how far the peg tilts half way down.",
            "name = \"tilt\"\nmeasure = \"play\"\nof = \"theta\"\nat = { y = \"-depth/2\" }",
        );
        for (x, comment) in [
            (
                "-side",
                "`cspace simulate FILE --time 1`: the peg falls, finds the chamfer, and comes to rest on the bottom of the\nhole. The block stands on springs.",
            ),
            ("side", ""),
        ] {
            let foot = [x, "-depth - diameter/2"];
            let (stiffness, damping) = (
                "20*side*(depth + diameter/2)",
                "0.04*side*(depth + diameter/2)",
            );
            page.mount(comment, "block", [foot, foot], stiffness, damping);
        }
        page.finish()
    }
}
