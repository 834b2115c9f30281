//! Fixed-axes pairs compared with brute force: every (u, v) must be free or blocked according to the parts' overlap.
//!
//! The oracle does not use contact curves. Half of the configurations are at 1e-4 … 1e-9 of the size from contact, found by halving along
//! random motions. A disagreement counts if the oracle's margin exceeds 1e-10 of the pair's size.

use core::f64::consts::TAU;

use cspace::fixed_axes::{AxisMotion, FixedAxesSpace};
use cspace::{Axis, Classification, Configuration, Point, Rotation, Vector};
use cspace_oracle::shapes::mechanisms::{Mechanism, gears, geneva, mechanisms};
use cspace_oracle::shapes::shifted;
use cspace_oracle::{Oracle, effort};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Minimum margin of an oracle's verdict for it to count, as a share of the size.
const CERTAIN: f64 = 1e-10;
/// Pairs with arcs whose radius is so many times their length that their centres are not known well enough: a known gap.
const TOO_FLAT: [&str; 1] = ["nearly straight arcs"];
/// Numbers of arbitrary configurations, and of searches for contact.
fn numbers() -> (usize, usize) {
    effort((40, 160), (300, 1200))
}

/// Marker of pairs that may fit exactly: in these, chains may have to be decided cell by cell.
const OF_ALL: &str = " of all";

/// Placement of a part by its axis.
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

/// The relative configuration, computed independently.
fn relative(m: &Mechanism, u: f64, v: f64) -> Configuration {
    let (a, b) = (place(&m.fixed_axis, u), place(&m.moving_axis, v));
    let back = Rotation::by(-a.turn) * (b.shift - a.shift);
    Configuration::new(back.x, back.y, b.turn - a.turn)
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
    let c = relative(m, at.0, at.1);
    let verdict = oracle.judge(c);
    // For a part drawn far away, the test's own positions have this rounding.
    let known = 64.0 * f64::EPSILON * c.x.abs().max(c.y.abs());
    // Where a tie was broken, the resolution includes the displacement of the parts.
    let least = (CERTAIN * oracle.size()).max(space.resolution());
    if verdict.margin <= least + known {
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
    let (far, searches) = numbers();
    for _ in 0..far {
        let at = m.somewhere(oracle.size(), &mut rng);
        ask(m, &space, &oracle, at, false, &mut tally);
    }
    let overlaps = |(u, v): (f64, f64)| oracle.judge(relative(m, u, v)).overlap;
    for _ in 0..searches {
        let from = m.somewhere(oracle.size(), &mut rng);
        // A displacement along u, v, or both.
        let way = 10f64.powf(rng.random_range(-2.0..0.0));
        let other = m.somewhere(oracle.size(), &mut rng);
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
    if s.conflicts > 0 && !m.name.ends_with(OF_ALL) {
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

/// Tests all mechanisms; fails if any answer is wrong or too few are certain.
fn try_all(all: &[Mechanism], least: usize) {
    let tried: Vec<(Tally, String)> = all.par_iter().map(try_mechanism).collect();
    let mut wrong = Vec::new();
    let (mut certain, mut near, mut free) = (0, 0, 0);
    for (tally, line) in tried {
        println!("{line}");
        certain += tally.certain;
        near += tally.near;
        free += tally.free;
        wrong.extend(tally.wrong.into_iter().take(6));
    }
    println!(
        "{} pairs, {certain} certain, {near} near contact, {free} free",
        all.len()
    );
    for w in &wrong {
        println!("{w}");
    }
    assert!(wrong.is_empty(), "{} wrong", wrong.len());
    assert!(certain >= least, "{certain} certain");
    assert!(2 * near >= certain, "{near} near");
}

#[test]
fn mechanisms_agree_with_brute_force() {
    try_all(&mechanisms(), effort(2_500, 20_000));
}

/// Many teeth: all copies of one period.
#[test]
fn large_gears_agree_with_brute_force() {
    let all = [gears(14, 12), gears(9, 16), gears(20, 18), geneva(8, 0.02)];
    try_all(&all, effort(400, 3_000));
}

/// The parts of all pairs of the oracle, each pair on axes of every combination: in the middle of the part, at a corner of the other's box,
/// along a coordinate or oblique, with limits and without.
#[test]
fn all_pairs_of_parts_agree_with_brute_force() {
    let mut rng = ChaCha8Rng::seed_from_u64(23);
    let mut all = Vec::new();
    for pair in cspace_oracle::pairs() {
        if pair.fixed.edges().count() + pair.moving.edges().count() > 110
            || TOO_FLAT.contains(&pair.name.as_str())
        {
            continue;
        }
        let oracle = Oracle::new(&pair.fixed, &pair.moving);
        let size = oracle.size();
        // The moving part is drawn where the parts nearly touch.
        let angle = TAU * f64::from(rng.random_range(0..8)) / 8.0;
        let to = oracle.fixed_center() - oracle.moving_center()
            + Vector::from_angle(angle) * (size * rng.random_range(0.2..0.8));
        let moving = shifted(&pair.moving, to.x, to.y);
        let moving_center = oracle.moving_center() + to;
        for combination in effort(0..2, 0..4) {
            let mut axis = |turning: bool, center: Point| {
                let axis = if turning {
                    let aside = [0.0, 0.0, 0.3, 1.0][rng.random_range(0..4)];
                    let way = Vector::from_angle(rng.random_range(0.0..TAU)) * (aside * size);
                    Axis::revolute(center + way)
                } else {
                    let directions = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.6, 0.8), (1.0, 0.37)];
                    let (x, y) = directions[rng.random_range(0..5)];
                    Axis::prismatic(Vector::new(x, y))
                };
                match (rng.random_range(0..4), turning) {
                    (0, true) => axis.within(-1.0, 2.5),
                    (1, true) => axis.within(-5.0, 6.0),
                    (0, false) => axis.within(-0.4 * size, 0.9 * size),
                    _ => axis,
                }
            };
            let fixed_axis = axis(combination & 1 == 0, oracle.fixed_center());
            let moving_axis = axis(combination & 2 == 0, moving_center);
            all.push(Mechanism {
                name: format!("{} {combination}{OF_ALL}", pair.name),
                fixed: pair.fixed.clone(),
                fixed_axis,
                moving: moving.clone(),
                moving_axis,
            });
        }
    }
    try_all(&all, effort(6_000, 100_000));
}
