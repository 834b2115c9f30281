//! Fixed-axes pairs against brute force: is every (u, v) free or blocked as the parts' overlap says?
//!
//! The judge is the oracle, which knows no contact curves. Half of the configurations are moved by 1e-4 … 1e-9 of the
//! size from contact, found by halving along random motions. A disagreement counts when the oracle is certain of its
//! verdict by more than 1e-10 of the pair's size.
#![allow(clippy::unwrap_used)]

use core::f64::consts::TAU;

use cspace::axes::{AxisMotion, FixedAxesSpace};
use cspace::{Axis, Classification, Configuration, Rotation, Vector};
use cspace_oracle::Oracle;
use cspace_oracle::shapes::mechanisms::{Mechanism, mechanisms};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// What the margin of a verdict must exceed to count, as a share of the size.
const CERTAIN: f64 = 1e-10;
/// Configurations anywhere, and searches for contact.
const FAR: usize = 1500;
const SEARCHES: usize = 500;

/// Where an axis takes its part.
struct Placing {
    turn: f64,
    shift: Vector,
}

fn place(axis: &Axis, t: f64) -> Placing {
    match axis.motion {
        AxisMotion::Fixed => Placing {
            turn: 0.0,
            shift: Vector::ZERO,
        },
        AxisMotion::Revolute { center } => Placing {
            turn: t,
            shift: center.to_vector() - Rotation::by(t) * center.to_vector(),
        },
        AxisMotion::Prismatic { direction } => Placing {
            turn: 0.0,
            shift: direction.unit() * t,
        },
    }
}

/// The relative configuration, written down anew.
fn relative(m: &Mechanism, u: f64, v: f64) -> Configuration {
    let (a, b) = (place(&m.fixed_axis, u), place(&m.moving_axis, v));
    let back = Rotation::by(-a.turn) * (b.shift - a.shift);
    Configuration::new(back.x, back.y, b.turn - a.turn)
}

/// A coordinate at random: within the range, a turn, or as far as parts of this size may meet.
fn coordinate(axis: &Axis, size: f64, rng: &mut ChaCha8Rng) -> f64 {
    match (axis.motion, axis.range) {
        (AxisMotion::Fixed, _) => 0.0,
        (_, Some((lo, hi))) => rng.random_range(lo..hi),
        (AxisMotion::Revolute { .. }, None) => rng.random_range(-TAU..TAU),
        (AxisMotion::Prismatic { .. }, None) => size * rng.random_range(-1.5..1.5),
    }
}

#[derive(Default)]
struct Tally {
    certain: usize,
    near: usize,
    free: usize,
    wrong: Vec<String>,
}

fn ask(
    m: &Mechanism,
    space: &FixedAxesSpace,
    oracle: &Oracle,
    at: (f64, f64),
    near: bool,
    t: &mut Tally,
) {
    let Some(class) = space.classify(at.0, at.1) else {
        return;
    };
    let verdict = oracle.judge(relative(m, at.0, at.1));
    if verdict.margin <= CERTAIN * oracle.size() {
        return;
    }
    t.certain += 1;
    t.near += usize::from(near);
    t.free += usize::from(!verdict.overlap);
    let expected = if verdict.overlap {
        Classification::Blocked
    } else {
        Classification::Free
    };
    if class != expected {
        t.wrong
            .push(format!("{}: {at:?} {class:?} {verdict:?}", m.name));
    }
}

fn try_mechanism(m: &Mechanism) -> (Tally, String) {
    let started = std::time::Instant::now();
    let space = FixedAxesSpace::compute(&m.fixed, m.fixed_axis, &m.moving, m.moving_axis).unwrap();
    let computed = started.elapsed();
    let oracle = Oracle::new(&m.fixed, &m.moving);
    let mut rng = ChaCha8Rng::seed_from_u64(11);
    let mut tally = Tally::default();
    let somewhere = |rng: &mut ChaCha8Rng| {
        let size = oracle.size();
        (
            coordinate(&m.fixed_axis, size, rng),
            coordinate(&m.moving_axis, size, rng),
        )
    };
    for _ in 0..FAR {
        let at = somewhere(&mut rng);
        ask(m, &space, &oracle, at, false, &mut tally);
    }
    let overlaps = |(u, v): (f64, f64)| oracle.judge(relative(m, u, v)).overlap;
    for _ in 0..SEARCHES {
        let from = somewhere(&mut rng);
        // A move along u, v, or both.
        let way = 10f64.powf(rng.random_range(-2.0..0.0));
        let other = somewhere(&mut rng);
        let (mut du, mut dv) = (way * (other.0 - from.0), way * (other.1 - from.1));
        match rng.random_range(0..3) {
            0 => du = 0.0,
            1 => dv = 0.0,
            _ => {}
        }
        let at = |s: f64| (from.0 + s * du, from.1 + s * dv);
        let begins = overlaps(at(0.0));
        if overlaps(at(1.0)) == begins {
            continue;
        }
        let (mut lo, mut hi) = (0.0, 1.0);
        while hi - lo > 1e-16 {
            let middle = 0.5 * (lo + hi);
            if middle <= lo || middle >= hi {
                break;
            }
            if overlaps(at(middle)) == begins {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        let length = du.hypot(dv);
        for _ in 0..4 {
            let step = 10f64.powi(rng.random_range(-9..=-4))
                * if rng.random_bool(0.5) { 1.0 } else { -1.0 };
            ask(m, &space, &oracle, at(lo + step / length), true, &mut tally);
        }
    }
    let s = space.statistics();
    if s.conflicts > 0 {
        tally
            .wrong
            .push(format!("{}: {} conflicts", m.name, s.conflicts));
    }
    let line = format!(
        "{:34} {:5} certain {:5} near {:5} free {:3} wrong; {} regions, {s:?}, computed in {:.2} ms",
        m.name,
        tally.certain,
        tally.near,
        tally.free,
        tally.wrong.len(),
        space.regions().len(),
        1e3 * computed.as_secs_f64()
    );
    (tally, line)
}

#[test]
fn spaces_agree_with_brute_force() {
    let only = std::env::var("ONLY").unwrap_or_default();
    let all: Vec<Mechanism> = mechanisms()
        .into_iter()
        .filter(|m| m.name.contains(&only))
        .collect();
    let tried: Vec<(Tally, String)> = all.par_iter().map(try_mechanism).collect();
    let mut wrong = Vec::new();
    let (mut certain, mut near) = (0, 0);
    for (tally, line) in tried {
        println!("{line}");
        certain += tally.certain;
        near += tally.near;
        wrong.extend(tally.wrong.into_iter().take(6));
    }
    println!(
        "{} pairs, {certain} certain, {near} near contact",
        all.len()
    );
    for w in &wrong {
        println!("{w}");
    }
    assert!(wrong.is_empty(), "{} wrong", wrong.len());
}
