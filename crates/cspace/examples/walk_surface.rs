//! Walks along the surface between free and blocked space, from patch to patch.
//!
//! On a patch one feature of the fixed part touches one of the moving part. Where it ends another pair of features takes
//! over: beside it at the same orientation, or above and below it where the orientation goes on.
//!
//! Run with `cargo run --release --example walk_surface`.

use std::collections::BTreeSet;

use cspace::{FeatureName, Options, PairSpace, Part, PatchId, Relation};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let triangle = Part::polygon("triangle", &[(0.0, 0.0), (6.0, 0.0), (1.0, 5.0)])?;
    let square = Part::rectangle("square", [0.0, 0.0], 2.0, 2.0)?;
    let space = PairSpace::compute(&triangle, &square, Relation::Planar, &Options::default())?;

    // Around: the square slides around the triangle at one orientation, without turning.
    let theta = 0.3;
    let is_there = |patch: &PatchId| -> bool {
        let ends = space.patch(*patch).and_then(|p| p.ends_at(theta));
        ends.is_ok()
    };
    let mut all = space.patches().map(|p| p.id());
    let start = all.find(is_there).ok_or("the parts can touch")?;
    let (mut here, mut steps) = (start, 0);
    println!("around the triangle at an orientation of {theta} rad:");
    loop {
        let patch = space.patch(here)?;
        let (fixed, moving) = patch.features()?;
        let (of_square, of_triangle) = (name(moving.name), name(fixed.name));
        println!("  patch {here}: {of_square} of the square on {of_triangle} of the triangle");
        steps += 1;
        // A patch may have several neighbours on a side, each at some orientations.
        let after = patch.neighbours().after;
        here = (after.into_iter().find(is_there)).ok_or("the boundary goes on")?;
        if here == start {
            break;
        }
    }
    // Two convex polygons touch along one loop: each side of either meets a corner of the other once.
    println!("  {steps} patches, one for each of the 3 + 4 sides");

    // Everywhere: also up and down in orientation.
    let (mut reached, mut next) = (BTreeSet::from([start]), vec![start]);
    while let Some(patch) = next.pop() {
        let around = space.neighbours(patch)?;
        for list in [around.before, around.after, around.below, around.above] {
            next.extend(list.into_iter().filter(|&p| reached.insert(p)));
        }
    }
    // The boundary of the free space of two convex parts is one surface. Every side meets every corner of the other part
    // once, so that 2 · 3 · 4 patches are on it.
    println!(
        "{} of {} patches are reached",
        reached.len(),
        space.patch_count()
    );
    Ok(())
}

/// A corner has its number, a side that of the corner it leaves.
fn name(feature: FeatureName) -> String {
    format!("{:?} {}", feature.kind, feature.index).to_lowercase()
}
