//! How far can a peg tilt in its hole, and what stops it?
//!
//! The configuration space of two parts holds the answer to every such question: it is computed once, and then asked.
//!
//! Run with `cargo run --release --example peg_in_hole`.

use cspace::pair::PairMotion;
use cspace::part::{OutlineBuilder, circle_loop};
use cspace::{Configuration, Coordinates, Options, PairSpace, Part, Relation};

/// Width of the hole, width of the peg, length of the peg, in any one unit of length.
const HOLE: f64 = 10.1;
const PEG: f64 = 10.0;
const LENGTH: f64 = 18.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A block in section: its hole is 30 deep and open at the top, where y = 0. A bore through the block shows how a part
    // has several loops.
    let half = 0.5 * HOLE;
    let section = OutlineBuilder::start([half, 0.0])
        .line_to([half, -30.0])
        .line_to([-half, -30.0])
        .line_to([-half, 0.0])
        .line_to([-20.0, 0.0])
        .fillet(2.0)
        .line_to([-20.0, -40.0])
        .line_to([20.0, -40.0])
        .line_to([20.0, 0.0])
        .fillet(2.0)
        .close()?;
    let block = Part::new("block", vec![section, circle_loop([14.0, -20.0], 3.0)?])?;
    // The peg's frame has its origin in the peg's middle.
    let peg = Part::rectangle("peg", [0.0, 0.0], PEG, LENGTH)?;

    // All relative positions and orientations. A configuration (x, y, θ) says where the peg's frame is in the block's.
    let space = PairSpace::compute(&block, &peg, Relation::Planar, &Options::default())?;
    println!("{} patches of contact", space.patch_count());

    let at = |x, y, theta| Coordinates::Planar(Configuration::new(x, y, theta));
    // The peg above the hole, in it, and beside it.
    for y in [15.0, -15.0, -25.0] {
        println!(
            "upright at height {y}: {:?}",
            space.classify(at(0.0, y, 0.0))?
        );
    }

    // Lowered by 1 a second from y = 15, it reaches the bottom when its middle is at −30 + 9: after 36 seconds.
    if let PairMotion::Contact(bottom) =
        space.first_contact(at(0.0, 15.0, 0.0), at(0.0, -1.0, 0.0), 100.0)?
    {
        println!("it reaches the bottom after {:.3} s", bottom.time);
    }

    // Turned about its middle within the hole, it touches both sides at once, with two opposite corners. Its width there
    // is then that of the hole: PEG cos θ + LENGTH sin θ = HOLE, or
    let formula = (HOLE / PEG.hypot(LENGTH)).asin() - PEG.atan2(LENGTH);
    if let PairMotion::Contact(jammed) =
        space.first_contact(at(0.0, -15.0, 0.0), at(0.0, 0.0, 1.0), 1.0)?
    {
        println!(
            "it jams at a tilt of {:.6} rad; by the formula {formula:.6}",
            jammed.time
        );
        // A hair before, for there both sides are still a boundary of free space: beyond there is none between them.
        let hair = 1e-9;
        let touching = space.contacts(at(0.0, -15.0, jammed.time - hair), 100.0 * hair)?;
        println!("{} pairs of features touch", touching.len());
    }
    Ok(())
}
