//! Assembly: start configuration of parts that joints carry.

use crate::kinematic::close;
use crate::linear::Rows;
use crate::pairs::Pairs;
use crate::system::System;

/// Parts may be moved by this much to make joints hold at the start, relative to the size of the mechanism.
const MOST_ASSEMBLING: f64 = 10.0;
/// Newton's steps to where joints hold: they converge quadratically, after a few.
const MOST_STEPS: usize = 30;
/// Joints hold to this, relative to the size of the mechanism.
const HOLDS: f64 = 1e-12;

/// Start configuration at which all joints hold: parts whose start is not given are moved to the others if possible;
/// otherwise all parts are moved by the shortest displacement. `None` if joints cannot hold.
pub(crate) fn assemble(system: &System, pairs: &Pairs) -> Option<Vec<f64>> {
    let start = system.start();
    let room = MOST_ASSEMBLING * system.size();
    let mut q = carried(system, start.clone()).unwrap_or(start);
    close(system, pairs, &[], 0.0, &mut q, room)?;
    Some(q)
}

/// Parts whose start is not given moved to where joints hold, by Newton's method; `None` if that does not lead there.
fn carried(system: &System, mut q: Vec<f64>) -> Option<Vec<f64>> {
    let given = system.given();
    let free: Vec<usize> = (system.free().iter().copied())
        .filter(|&i| !given[i])
        .collect();
    if free.is_empty() || free.len() == system.free().len() {
        return None;
    }
    let lengths = system.lengths();
    for _ in 0..MOST_STEPS {
        let joints = system.joints(&q);
        let off = joints.iter().fold(0.0_f64, |m, j| m.max(j.value.abs()));
        if off <= HOLDS * system.size() {
            return Some(q);
        }
        let row = |entries: &[(usize, f64)]| -> Vec<f64> {
            let mut row = vec![0.0; free.len()];
            for &(i, d) in entries {
                if let Ok(k) = free.binary_search(&i) {
                    row[k] = d / lengths[i];
                }
            }
            row
        };
        let rows: Vec<Vec<f64>> = joints.iter().map(|j| row(j.entries())).collect();
        let missing: Vec<f64> = joints.iter().map(|j| -j.value).collect();
        let (step, _) = Rows::of(&rows).least(&missing);
        if step.is_empty() {
            return None;
        }
        for (&i, d) in free.iter().zip(step) {
            q[i] += d / lengths[i];
        }
        if q.iter().any(|x| !x.is_finite()) {
            return None;
        }
    }
    None
}
