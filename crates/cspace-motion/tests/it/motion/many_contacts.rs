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
