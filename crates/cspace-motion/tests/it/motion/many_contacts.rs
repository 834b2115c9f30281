//! More contacts with friction than can be tried one by one, where forces balance, against statics.

use core::fmt::Write as _;

use cspace_motion::{Record, Status};

use crate::motion::helpers::{near, read, run};

/// Friction on the floor and between blocks of a stack.
const FRICTION: f64 = 0.3;
/// Weight of each block.
const WEIGHT: f64 = 7.0;

/// The floor, and a pusher with a round nose at a height, driven to the right.
fn pushed_at(height: f64) -> String {
    format!(
        r#"
[[part]]
name = "floor"
motion = {{ type = "fixed" }}
loops = [[[-90, -1], [90, -1], [90, 0], [-90, 0]]]
[[part]]
name = "pusher"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [{{ circle = 0.1, at = [-2.6, {height:?}] }}]
[[drive]]
part = "pusher"
rate = 1
"#
    )
}

/// A block of width 4 and height 1 whose lower left corner is there, with its weight.
fn block(number: usize, [x, y]: [f64; 2]) -> String {
    let [right, top] = [x + 4.0, y + 1.0];
    format!(
        r#"
[[part]]
name = "block {number}"
loops = [[[{x:?}, {y:?}], [{right:?}, {y:?}], [{right:?}, {top:?}], [{x:?}, {top:?}]]]
[[load]]
part = "block {number}"
force = [0, -{WEIGHT:?}]
"#
    )
}

fn pair(fixed: &str, moving: &str, friction: f64) -> String {
    format!("[[pair]]\nfixed = {fixed:?}\nmoving = {moving:?}\nfriction = {friction:?}\n")
}

/// The force of the drive, and whether all that stick or slide do so within the cone, at every sample.
fn forces(record: &Record) -> Vec<(f64, f64)> {
    let at = |s: &cspace_motion::Sample| {
        let forces = s.forces.as_ref().unwrap();
        for c in &forces.contacts {
            assert!(c.normal >= 0.0, "{c:?}");
            let most = FRICTION * c.normal + 1e-9 * WEIGHT;
            assert!(c.tangential.abs() <= most, "{c:?}");
        }
        (s.t, forces.drives[0].force)
    };
    record.samples.iter().map(at).collect()
}

/// Blocks that stand on a rough floor in a row are pushed together one after the other: the force grows by μ W with each. From the fourth on
/// eight corners slide on the floor, and more.
#[test]
fn a_row_of_blocks_is_pushed_by_the_sum_of_friction() {
    const GAP: f64 = 0.25;
    let mut model = pushed_at(0.5);
    for k in 0..5 {
        model += &block(k, [-2.25 + (4.0 + GAP) * k as f64, 0.0]);
        model += &pair("floor", &format!("block {k}"), FRICTION);
        let before = match k {
            0 => "pusher".to_owned(),
            k => format!("block {}", k - 1),
        };
        model += &pair(&before, &format!("block {k}"), 0.0);
    }
    let (_, record) = run(&read(&model), 1.5, 0.1);
    assert_eq!(record.status, Status::Done, "{:?}", record.reason);
    for (t, force) in forces(&record) {
        let steps = t / GAP;
        if (steps - steps.round()).abs() > 1e-9 {
            let pushed = steps.floor().min(5.0);
            near("the drive", force, pushed * FRICTION * WEIGHT, 1e-9);
        }
    }
    let last = record.samples.last().unwrap();
    for k in 0..5_usize {
        let x = last.coordinates[1 + 3 * k];
        near("the way of a block", x, 1.5 - GAP * (k + 1) as f64, 1e-9);
    }
}

/// A pusher moves one block of a stack and what lies on it, and the rest stands.
#[test]
fn a_stack_of_blocks_slides_where_it_is_pushed() {
    for level in 0..4_usize {
        let mut model = pushed_at(level as f64 + 0.3);
        for k in 0..4_usize {
            model += &block(k, [-2.25, k as f64]);
            let below = match k {
                0 => "floor".to_owned(),
                k => format!("block {}", k - 1),
            };
            model += &pair(&below, &format!("block {k}"), FRICTION);
        }
        let _ = write!(model, "{}", pair("pusher", &format!("block {level}"), 0.0));
        let (_, record) = run(&read(&model), 1.0, 0.1);
        assert_eq!(record.status, Status::Done, "{level}: {:?}", record.reason);
        let above = (4 - level) as f64;
        for (t, force) in forces(&record) {
            if t > 0.26 {
                near("the drive", force, above * FRICTION * WEIGHT, 1e-9);
            }
        }
        let last = record.samples.last().unwrap();
        for k in 0..4_usize {
            let x = last.coordinates[1 + 3 * k];
            let way = if k < level { 0.0 } else { 0.75 };
            near("the way of a block", x, way, 1e-9);
        }
    }
}

/// Square blocks of different weights, rough all around, that a flat pusher moves. What it rubs with, V, is not determined, and all that move
/// press on the floor with W − V: the force of the drive is F = μ (W − V) with |V| ≤ μ F.
#[test]
fn rough_blocks_are_pushed_by_the_sum_of_friction() {
    for friction in [0.25, 0.4] {
        let mut model = format!(
            r#"
friction = {friction:?}
[[part]]
name = "floor"
motion = {{ type = "fixed" }}
loops = [[[-100, -10], [200, -10], [200, 0], [-100, 0]]]
[[part]]
name = "pusher"
motion = {{ type = "prismatic", direction = [1, 0] }}
loops = [[[-20, 4], [-2, 4], [-2, 6], [-20, 6]]]
[[drive]]
part = "pusher"
rate = 10
"#
        );
        for (name, x, weight) in [("a", 0, 1000), ("b", 12, 2000)] {
            write!(
                model,
                r#"
[[part]]
name = "{name}"
loops = [[[{x}, 0], [{}, 0], [{}, 10], [{x}, 10]]]
[[load]]
part = "{name}"
force = [0, -{weight}]
"#,
                x + 10,
                x + 10
            )
            .unwrap();
        }
        let (_, record) = run(&read(&model), 1.5, 0.15);
        assert_eq!(record.status, Status::Done, "{:?}", record.reason);
        for sample in &record.samples {
            let pushed = match sample.t {
                t if t > 0.41 => 3000.0,
                t if t > 0.21 && t < 0.39 => 1000.0,
                t if t < 0.19 => 0.0,
                _ => continue,
            };
            let drive = sample.forces.as_ref().unwrap().drives[0].force;
            let [most, least] =
                [-1.0, 1.0].map(|s| friction * pushed / (1.0 + s * friction * friction));
            assert!(
                (least - 1e-6..=most + 1e-6).contains(&drive),
                "{drive} at {}",
                sample.t
            );
        }
    }
}
