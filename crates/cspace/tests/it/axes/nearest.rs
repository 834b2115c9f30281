//! Nearest contacts of pairs on fixed axes, compared with first contacts to both sides and with brute force in between.

use core::f64::consts::{PI, TAU};

use cspace::fixed_axes::AxesMotionOutcome;
use cspace::fixed_axes::{AxisMotion, FixedAxesSpace};
use cspace::{Axis, Classification};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::{Mechanism, mechanisms};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Configurations of each mechanism, and steps of brute force towards a contact.
const ASKED: usize = 200;
const STEPS: u32 = 40;
/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-9;

#[derive(Default)]
struct Tally {
    free: usize,
    blocked: usize,
    none: usize,
    wrong: Vec<String>,
}

/// Distance for which a motion along one coordinate is free.
fn free_way(space: &FixedAxesSpace, from: (f64, f64), rates: (f64, f64), far: f64) -> Option<f64> {
    match space.first_contact(from, rates, far).unwrap() {
        AxesMotionOutcome::Contact(c) => Some(c.time),
        _ => None,
    }
}

fn try_mechanism(m: &Mechanism) -> Tally {
    let space = FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap();
    let oracle = Oracle::new(&m.fixed, &m.moving);
    let size = oracle.size();
    let mut rng = ChaCha8Rng::seed_from_u64(47);
    let mut tally = Tally::default();
    let stays = |axis: &Axis| axis.motion == AxisMotion::Fixed;
    let (du, dv) = if stays(&m.moving_axis) {
        (1.0, 0.0)
    } else {
        (0.0, 1.0)
    };
    let turns = {
        let axis = if dv > 0.0 {
            &m.moving_axis
        } else {
            &m.fixed_axis
        };
        matches!(axis.motion, AxisMotion::Revolute { .. })
    };
    for _ in 0..ASKED {
        let (u, v) = m.somewhere(size, &mut rng);
        let Some(class) = space.classify(u, v) else {
            continue;
        };
        let mut wrong = |what: String| tally.wrong.push(format!("{} ({u}, {v}): {what}", m.name));
        let Some(n) = space.nearest_contact(u, v) else {
            tally.none += 1;
            // No contact on either side.
            if class == Classification::Free {
                for sign in [-1.0, 1.0] {
                    if let Some(t) = free_way(&space, (u, v), (sign * du, sign * dv), TAU) {
                        wrong(format!("none, but one at {t}"));
                    }
                }
            }
            continue;
        };
        if !space
            .contacts(n.at.0, n.at.1, 1e-9 * size)
            .iter()
            .any(|c| c.0 == n.patch)
        {
            wrong(format!("{n:?} is not on its patch"));
        }
        let moved = (n.at.0 - u) * du + (n.at.1 - v) * dv;
        let held = (n.at.0 - u) * dv + (n.at.1 - v) * du;
        if held != 0.0 || (moved.abs() - n.distance).abs() > 1e-12 * (1.0 + n.distance) {
            wrong(format!("{n:?} is not that far"));
        }
        if turns && n.distance > PI + 1e-9 && space.regions().iter().any(|r| r.around_v) {
            wrong(format!("{n:?} is the longer way"));
        }
        match class {
            Classification::Free => {
                tally.free += 1;
                let sides = [-1.0, 1.0].map(|s| {
                    free_way(
                        &space,
                        (u, v),
                        (s * du, s * dv),
                        n.distance * (1.0 + 1e-9) + 1e-9,
                    )
                });
                let first = sides.into_iter().flatten().fold(f64::INFINITY, f64::min);
                if (first - n.distance).abs() > 1e-8 * (1.0 + n.distance) {
                    wrong(format!("{n:?}, but first contacts at {sides:?}"));
                }
            }
            _ => {
                tally.blocked += 1;
                for k in 1..STEPS {
                    let t = n.distance * f64::from(k) / f64::from(STEPS);
                    for t in [-t, t] {
                        let at = (u + t * du, v + t * dv);
                        if space.classify(at.0, at.1).is_none() {
                            continue;
                        }
                        let verdict = oracle.judge(space.configuration(at.0, at.1));
                        if !verdict.overlap && verdict.margin > CERTAIN * size {
                            wrong(format!("{n:?}, but free already {t} away"));
                        }
                    }
                }
            }
        }
    }
    tally
}

#[test]
fn nearest_contacts_agree_with_brute_force() {
    let all = mechanisms();
    let tried: Vec<Tally> = all.par_iter().map(try_mechanism).collect();
    let mut sum = Tally::default();
    for (m, t) in all.iter().zip(tried) {
        println!(
            "{:34} {} free, {} blocked, {} none, {} wrong",
            m.name,
            t.free,
            t.blocked,
            t.none,
            t.wrong.len()
        );
        sum.free += t.free;
        sum.blocked += t.blocked;
        sum.none += t.none;
        sum.wrong.extend(t.wrong.into_iter().take(3));
    }
    for w in &sum.wrong {
        println!("{w}");
    }
    assert!(sum.wrong.is_empty(), "{} wrong", sum.wrong.len());
    assert!(sum.free > 1000 && sum.blocked > 1000 && sum.none > 0);
}
